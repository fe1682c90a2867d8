/* Questions about points, the other handles, and loops. */
#include <math.h>

#include "region_family.h"

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
                fail_msg("%s: (%.17g, %.17g): a disc of the safe radius %.17g is outside", f.c.id,
                         real_to_double(d.x), real_to_double(d.y), real_to_double(distance));
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sides),
        cmocka_unit_test(test_nearest),
        cmocka_unit_test(test_handles),
        cmocka_unit_test(test_loop_free),
    };
    return cmocka_run_group_tests_name("region_points", tests, NULL, NULL);
}
