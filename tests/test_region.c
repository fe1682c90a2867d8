/* Regions of random families: right by sampled half-planes, in two ways alike; and the questions about
 * points. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "nasty.h"

#include "../harness/regions/region_check.h"
#include "../harness/regions/region_problem.h"
#include "../harness/regions/region_random.h"

/* One random family with room to solve it. */
struct family {
    struct region_case c;
    struct owned_region owned;
    struct owned_workspace room;
    struct region *region, *other;
};

static struct region *region_new(void)
{
    struct region *r = (struct region *)malloc(sizeof *r);
    assert_non_null(r);
    return r;
}

static void family_open(struct family *f, uint64_t seed, int lo, int hi, uint64_t index)
{
    char line[REGION_LINE_MAX], error[512];
    region_random_line(seed, lo, hi, index, line);
    if (region_case_parse(line, "random", (int)index, &f->c, error) != REGION_CASE_READ)
        fail_msg("%s", error);
    const char *wrong = owned_region_make(&f->c, -1, 0, REGION_STEPS_MAX, &f->owned);
    if (wrong)
        fail_msg("%s: %s", f->c.id, wrong);
    memset((void *)&f->room, 0, sizeof f->room);
    owned_workspace_fit(&f->room, &f->owned.problem);
    f->region = region_new();
    f->other = region_new();
}

static void family_close(struct family *f)
{
    free(f->region);
    free(f->other);
    owned_workspace_clear(&f->room);
    owned_region_clear(&f->owned);
    region_case_clear(&f->c);
}

static enum outcome find(struct family *f, const char *method, struct region *out)
{
    return region_solve(&f->owned.problem, region_method_find(method), &f->room.workspace, out);
}

static struct region_answer answer_of(struct family *f, const char *method, const struct region *r)
{
    struct region_answer a;
    memset((void *)&a, 0, sizeof a);
    a.id = f->c.id;
    a.method = region_method_find(method);
    a.outcome = SOLVED;
    a.sign = f->owned.problem.sign;
    a.region = r;
    return a;
}

static const char *sampled(struct family *f, const struct region *r)
{
    struct region_answer a = answer_of(f, "region_carriers", r);
    return region_check_sample(&f->owned.problem, &f->room.workspace, &a);
}

/* Of the control points, with some slack for what lies far out. */
static real size_of(const struct family *f)
{
    const struct control_family *p = &f->owned.problem.family;
    real size = 0;
    for (int i = 0; i < p->count; i++)
        size = real_max(size, real_max(real_abs(p->x[i]), real_abs(p->y[i])));
    return size;
}

static bool is_compact(const struct family *f)
{
    for (int i = 0; i < f->region->count; i++) {
        const struct region_edge *e = &f->region->edge[i];
        if (e->from_infinity || e->to_infinity ||
            real_abs(e->from.x) + real_abs(e->from.y) > 100 * size_of(f))
            return false;
    }
    return f->region->kind == REGION_BOUNDED;
}

/* ---- right, and certified but for one in a hundred ---- */

static void test_random(void **state)
{
    (void)state;
    int n = trials(600), certified = 0;
    for (int i = 0; i < n; i++) {
        struct family f;
        family_open(&f, 11, 3, 9, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        const char *wrong = sampled(&f, f.region);
        if (wrong)
            fail_msg("%s: %s", f.c.id, wrong);
        certified += f.region->certified;
        family_close(&f);
    }
    if (100 * certified < 98 * n)
        fail_msg("%d of %d certified", certified, n);
}

/* Cutting leaves a little more than the exact structure, everywhere within some sizes of the curve. */
static void test_methods_agree(void **state)
{
    (void)state;
    for (int i = 0; i < trials(200); i++) {
        struct family f;
        family_open(&f, 12, 3, 7, (uint64_t)i);
        f.owned.problem.tolerance = (real)1 / 65536;
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        assert_int_equal(find(&f, "region_cutting", f.other), SOLVED);
        if (is_compact(&f)) {
            real thin = f.region->disc_radius < size_of(&f) / 50;
            if (f.other->kind != REGION_BOUNDED ||
                (!thin && real_abs(f.other->area - f.region->area) > f.region->area / 100))
                fail_msg("%s: areas %g and %g", f.c.id, real_to_double(f.region->area),
                         real_to_double(f.other->area));
        }
        if (f.region->kind == REGION_PLANE && f.other->kind != REGION_PLANE)
            fail_msg("%s: kinds differ", f.c.id);
        family_close(&f);
    }
}

/* ---- points ---- */

/* Beyond the middle of a segment, and beyond the ends of the tangents of an arc, nothing is allowed; what the
 * conditions allow around the middle of the largest disc is proved. */
static void test_sides(void **state)
{
    (void)state;
    int asked = 0;
    for (int i = 0; i < trials(400); i++) {
        struct family f;
        family_open(&f, 13, 3, 8, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        const struct region *r = f.region;
        for (int j = 0; is_compact(&f) && r->strict && j < r->count; j++) {
            const struct region_edge *e = &r->edge[j];
            struct point p = {(e->from.x + e->to.x) / 2, (e->from.y + e->to.y) / 2}, c = r->disc_centre;
            real step = size_of(&f) / 10000;
            if (e->type == EDGE_ARC)
                p = e->from;
            struct point beyond = {p.x - step * e->line[0], p.y - step * e->line[1]};
            if (region_contains(&f.owned.problem, &f.room.workspace, beyond, 0) != SIDE_OUTSIDE)
                fail_msg("%s: edge %d: a point beyond it is not outside", f.c.id, j);
            if (region_contains(&f.owned.problem, &f.room.workspace, c, r->disc_radius * 999 / 1000) !=
                SIDE_INSIDE)
                fail_msg("%s: the largest disc is not inside", f.c.id);
            if (region_contains(&f.owned.problem, &f.room.workspace, c, r->disc_radius * 1001 / 1000) !=
                SIDE_OUTSIDE)
                fail_msg("%s: a larger disc about its centre is not outside", f.c.id);
            asked++;
        }
        family_close(&f);
    }
    assert_true(asked > 5);
}

/* The distance is that of the nearest point, which is on the boundary; inside, a disc of that radius fits. */
static void test_nearest(void **state)
{
    (void)state;
    for (int i = 0; i < trials(300); i++) {
        struct family f;
        struct random_state r = random_for(14, "nearest", (uint64_t)i);
        family_open(&f, 14, 3, 7, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        struct point d = {20 * prop_dyadic(&r, 20), 20 * prop_dyadic(&r, 20)};
        struct region_workspace *w = &f.room.workspace;
        if (f.region->kind != REGION_EMPTY && f.region->count > 0 && f.region->certified) {
            real distance = region_distance(&f.owned.problem, w, f.region, d);
            struct point n = region_nearest(&f.owned.problem, w, f.region, d);
            real x = n.x - d.x, y = n.y - d.y, way = real_sqrt(x * x + y * y), slack = (real)1 / 1000000;
            if (distance < 0 &&
                (real_abs(way + distance) > slack * (1 + way) ||
                 real_abs(region_distance(&f.owned.problem, w, f.region, n)) > slack * (1 + way)))
                fail_msg("%s: nearest point at %g, distance %g", f.c.id, real_to_double(way),
                         real_to_double(distance));
            if (distance > slack && f.region->strict && distance < 1000 &&
                region_contains(&f.owned.problem, w, d, distance * 999 / 1000) == SIDE_OUTSIDE)
                fail_msg("%s: (%.17g, %.17g): a disc of the safe radius %.17g is outside", f.c.id, real_to_double(d.x),
                         real_to_double(d.y), real_to_double(distance));
            if (distance > slack && distance < 1000 &&
                region_contains(&f.owned.problem, w, d, distance * 1001 / 1000) == SIDE_INSIDE)
                fail_msg("%s: a larger disc is inside", f.c.id);
        }
        family_close(&f);
    }
}

/* ---- handles ---- */

/* A group of one is a point; groups and dragged curve points agree with samples of their own half-planes. */
static void test_handles(void **state)
{
    (void)state;
    for (int i = 0; i < trials(200); i++) {
        struct family f;
        struct random_state r = random_for(15, "handles", (uint64_t)i);
        real share[DEGREE_MAX + 20];
        family_open(&f, 15, 3, 6, (uint64_t)i);
        struct control_family *c = &f.owned.problem.family;
        if (random_bits(&r) & 1) {
            const int members[2] = {1, 2};
            family_of_group(c, 2, members, share);
        } else {
            real lo = f.owned.problem.interval.lo, hi = f.owned.problem.interval.hi;
            family_of_drag(c, lo + (hi - lo) * prop_unit(&r, 10), share);
        }
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        const char *wrong = sampled(&f, f.region);
        if (wrong)
            fail_msg("%s: %s", f.c.id, wrong);
        family_close(&f);
    }
}

/* ---- loops ---- */

/* Total turning of the curve with its handle at d, in degrees, by small steps of its control polygon's image.
 */
static double turning(const struct family *f, struct point d)
{
    const struct control_family *c = &f->owned.problem.family;
    double lo = real_to_double(f->owned.problem.interval.lo),
           hi = real_to_double(f->owned.problem.interval.hi);
    double x0 = 0, y0 = 0, dx0 = 0, dy0 = 0, sum = 0;
    for (int i = 0; i <= 4000; i++) {
        double t = lo + (hi - lo) * i / 4000, x[33], y[33], w[33];
        int k = c->degree;
        while (k + 1 < c->count && real_to_double(c->knots[k + 1]) <= t)
            k++;
        for (int j = 0; j <= c->degree; j++) {
            int p = k - c->degree + j;
            double share = real_to_double(c->share[p]);
            w[j] = c->weight ? real_to_double(c->weight[p]) : 1;
            x[j] = w[j] * (real_to_double(c->x[p]) + share * real_to_double(d.x - c->at.x));
            y[j] = w[j] * (real_to_double(c->y[p]) + share * real_to_double(d.y - c->at.y));
        }
        for (int r = 1; r <= c->degree; r++)
            for (int j = c->degree; j >= r; j--) {
                double a = real_to_double(c->knots[k - c->degree + j]),
                       b = real_to_double(c->knots[k + 1 + j - r]);
                double v = (t - a) / (b - a);
                x[j] = (1 - v) * x[j - 1] + v * x[j];
                y[j] = (1 - v) * y[j - 1] + v * y[j];
                w[j] = (1 - v) * w[j - 1] + v * w[j];
            }
        double px = x[c->degree] / w[c->degree], py = y[c->degree] / w[c->degree];
        double dx = px - x0, dy = py - y0;
        if (i > 1)
            sum += atan2(dx0 * dy - dy0 * dx, dx0 * dx + dy0 * dy);
        dx0 = dx;
        dy0 = dy;
        x0 = px;
        y0 = py;
    }
    return fabs(sum) * 57.29577951308232;
}

/* Inside the smaller region the tangent turns by less than pi; inside the larger one only, by as much or
 * more. */
static void test_loop_free(void **state)
{
    (void)state;
    int both = 0, looped = 0;
    for (int i = 0; i < trials(2000); i++) {
        struct family f;
        family_open(&f, 16, 3, 5, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        if (is_compact(&f) && f.region->strict && f.region->disc_radius > size_of(&f) / 1000) {
            struct point d = f.region->disc_centre;
            f.owned.problem.loop_free = true;
            assert_int_equal(find(&f, "region_carriers", f.other), SOLVED);
            enum side side =
                region_contains(&f.owned.problem, &f.room.workspace, d, f.region->disc_radius / 100);
            double degrees = turning(&f, d);
            if (side == SIDE_INSIDE && degrees >= 180.5)
                fail_msg("%s: turns by %g degrees, promised less than 180", f.c.id, degrees);
            if (region_contains(&f.owned.problem, &f.room.workspace, d, 0) == SIDE_OUTSIDE && degrees < 179.5)
                fail_msg("%s: turns by %g degrees only", f.c.id, degrees);
            if (side == SIDE_INSIDE && f.other->kind == REGION_EMPTY)
                fail_msg("%s: a point inside an empty region", f.c.id);
            both += side == SIDE_INSIDE;
            looped += degrees > 180.5;
        }
        family_close(&f);
    }
    if (REAL_BITS <= 53)
        assert_true(both > 3 && looped > 3);
}

/* ---- mistakes are found ---- */

/* Negative control: a region that is a little too large or too small is told from the right one. */
static void test_damage_is_found(void **state)
{
    (void)state;
    int damaged = 0, found = 0;
    for (int i = 0; i < trials(400); i++) {
        struct family f;
        family_open(&f, 17, 3, 6, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        if (is_compact(&f) && f.region->strict && f.region->disc_radius > size_of(&f) / 100) {
            struct region_edge *e = &f.region->edge[0];
            real out = size_of(&f) / 1000;
            e->from.x += 100 * out * (e->from.x - f.region->disc_centre.x) / size_of(&f);
            e->from.y += 100 * out * (e->from.y - f.region->disc_centre.y) / size_of(&f);
            damaged++;
            found += sampled(&f, f.region) != NULL;
            f.region->kind = REGION_EMPTY;
            damaged++;
            found += sampled(&f, f.region) != NULL;
        }
        family_close(&f);
    }
    assert_true(damaged > 0);
    assert_int_equal(found, damaged);
}

static void test_limits(void **state)
{
    (void)state;
    struct family f;
    family_open(&f, 18, 9, 9, 0);
    const char *field;
    struct region_problem p = f.owned.problem;
    p.sign = 0;
    assert_non_null(region_problem_check(&p, &field));
    assert_string_equal(field, "sign");
    assert_int_equal(region_solve(&p, region_methods[0], &f.room.workspace, f.region), INVALID);
    p = f.owned.problem;
    p.max_steps = 1;
    p.interval.lo = f.owned.problem.interval.lo;
    for (int i = 0; region_methods[i]; i++) {
        enum outcome outcome = region_solve(&p, region_methods[i], &f.room.workspace, f.region);
        assert_true(outcome == SOLVED || outcome == OUT_OF_STEPS);
        assert_false(outcome == OUT_OF_STEPS && f.region->certified);
    }
    family_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),  cmocka_unit_test(test_methods_agree),
        cmocka_unit_test(test_sides),   cmocka_unit_test(test_nearest),
        cmocka_unit_test(test_handles), cmocka_unit_test(test_loop_free),
        cmocka_unit_test(test_limits),  cmocka_unit_test(test_damage_is_found),
    };
    return cmocka_run_group_tests_name("region", tests, NULL, NULL);
}
