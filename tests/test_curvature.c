/* What a region does not depend on, what it does when parts of the problem degenerate, and regions known in
 * closed form. */
#include "region_family.h"
#include "region_proof.h"

enum { POINTS = 40, KNOTS = 80 };

/* A family with its numbers beside it; not to be copied. */
struct made {
    struct region_problem p;
    real x[POINTS], y[POINTS], weight[POINTS], share[POINTS], knots[KNOTS];
};

static void made_link(struct made *m)
{
    struct control_family *f = &m->p.family;
    f->x = m->x;
    f->y = m->y;
    f->knots = m->knots;
    f->share = m->share;
    f->weight = f->weight ? m->weight : NULL;
}

static void made_from(const struct region_problem *p, struct made *m)
{
    m->p = *p;
    for (int i = 0; i < p->family.count; i++) {
        m->x[i] = p->family.x[i];
        m->y[i] = p->family.y[i];
        m->share[i] = p->family.share[i];
        m->weight[i] = p->family.weight ? p->family.weight[i] : (real)1;
    }
    for (int i = 0; i <= p->family.count + p->family.degree; i++)
        m->knots[i] = p->family.knots[i];
    made_link(m);
}

/* A Bezier curve over [0, 1] with control point i free. */
static void made_bezier(struct made *m, int degree, int i, int sign)
{
    memset((void *)&m->p, 0, sizeof m->p);
    m->p.family.degree = degree;
    m->p.family.count = degree + 1;
    for (int k = 0; k <= degree; k++) {
        m->knots[k] = 0;
        m->knots[degree + 1 + k] = 1;
        m->weight[k] = 1;
    }
    m->p.interval.lo = 0;
    m->p.interval.hi = 1;
    m->p.sign = sign;
    m->p.tolerance = 0; /* zeroed memory is no number at multi */
    m->p.max_steps = REGION_STEPS_MAX;
    made_link(m);
    family_of_point(&m->p.family, i, m->share);
}

/* Solves m into out, with a workspace that the caller clears. */
static void solve(const struct made *m, struct owned_workspace *room, struct region *out)
{
    owned_workspace_fit(room, &m->p);
    assert_int_equal(region_solve(&m->p, region_methods[0], &room->workspace, out), SOLVED);
}

/* ---- what a region does not depend on ---- */

/* d -> (a x + b y + u, c x + e y + v). */
struct affine {
    real a, b, c, e, u, v;
};

static struct point apply(const struct affine *m, struct point d)
{
    struct point p = {m->a * d.x + m->b * d.y + m->u, m->c * d.x + m->e * d.y + m->v};
    return p;
}

/* The vertices of one are on the boundary of the other after the map, and as many kinds of edges. */
static void compare(const struct family *f, const struct affine *map, const struct made *m, const char *what)
{
    struct owned_workspace room;
    memset((void *)&room, 0, sizeof room);
    solve(m, &room, f->other);
    real close = 100 * size_of(f) * real_ldexp(1, -REAL_BITS / 2);
    if (f->other->kind != f->region->kind)
        fail_msg("%s: %s: %s, and %s before", f->c.id, what, region_kind_name(f->other->kind),
                 region_kind_name(f->region->kind));
    for (int i = 0; i < f->region->count; i++) {
        struct point v = apply(map, f->region->edge[i].from);
        real distance = region_distance(&m->p, &room.workspace, f->other, v);
        if (real_abs(distance) > close)
            fail_msg("%s: %s: vertex %d is off by %g", f->c.id, what, i, real_to_double(distance));
    }
    real area = f->region->area * real_abs(map->a * map->e - map->b * map->c);
    if (real_abs(f->other->area - area) > area / 100000)
        fail_msg("%s: %s: area %g, expected %g", f->c.id, what, real_to_double(f->other->area),
                 real_to_double(area));
    owned_workspace_clear(&room);
}

static void map_points(const struct affine *map, struct made *m)
{
    m->p.family.at = apply(map, m->p.family.at);
    for (int i = 0; i < m->p.family.count; i++) {
        struct point d = {m->x[i], m->y[i]}, image = apply(map, d);
        m->x[i] = image.x;
        m->y[i] = image.y;
    }
    m->p.sign = map->a * map->e - map->b * map->c < 0 ? -m->p.sign : m->p.sign;
}

static void reverse(struct made *m)
{
    struct made old = *m;
    int count = m->p.family.count, knots = count + m->p.family.degree + 1;
    for (int i = 0; i < count; i++) {
        m->x[i] = old.x[count - 1 - i];
        m->y[i] = old.y[count - 1 - i];
        m->weight[i] = old.weight[count - 1 - i];
        m->share[i] = old.share[count - 1 - i];
    }
    for (int i = 0; i < knots; i++)
        m->knots[i] = 1 - old.knots[knots - 1 - i];
    m->p.interval.lo = 1 - old.p.interval.hi;
    m->p.interval.hi = 1 - old.p.interval.lo;
    m->p.sign = -old.p.sign;
}

/* New homogeneous coordinates (w x, w y, w, w share), from those of the old points j and j - 1. */
static void blend(const struct made *old, int i, int j, real a, struct made *m)
{
    real w = 0, x = 0, y = 0, share = 0;
    for (int k = 0; k < 2; k++) {
        int at = k ? j - 1 : j;
        real part = k ? 1 - a : a;
        if (part == 0)
            continue;
        w += part * old->weight[at];
        x += part * old->weight[at] * old->x[at];
        y += part * old->weight[at] * old->y[at];
        share += part * old->weight[at] * old->share[at];
    }
    m->weight[i] = w;
    m->x[i] = x / w;
    m->y[i] = y / w;
    m->share[i] = share / w;
}

/* Boehm's insertion of the knot u. */
static void insert_knot(struct made *m, real u)
{
    struct made old = *m;
    int n = m->p.family.degree, k = n;
    while (old.knots[k + 1] <= u)
        k++;
    m->p.family.count++;
    for (int i = 0; i < m->p.family.count; i++) {
        real a = i <= k - n ? (real)1
                 : i > k    ? (real)0
                            : (u - old.knots[i]) / (old.knots[i + n] - old.knots[i]);
        blend(&old, i, i, a, m);
    }
    for (int i = k + 1; i < m->p.family.count + n + 1; i++)
        m->knots[i] = i == k + 1 ? u : old.knots[i - 1];
}

/* Of a Bezier curve. */
static void elevate(struct made *m)
{
    struct made old = *m;
    int n = m->p.family.degree++;
    m->p.family.count++;
    for (int i = 0; i <= n + 1; i++)
        blend(&old, i, i, 1 - (real)i / (n + 1), m);
    for (int i = 0; i <= n + 1; i++) {
        m->knots[i] = 0;
        m->knots[n + 2 + i] = 1;
    }
}

static bool is_telling(const struct family *f)
{
    return is_compact(f) && f->region->certified && f->region->disc_radius > size_of(f) / 1000;
}

static void test_invariances(void **state)
{
    (void)state;
    const struct affine same = {1, 0, 0, 1, 0, 0}, turned = {2, 1, -1, 3, 5, -7},
                        mirrored = {1, 2, 1, -1, 0, 3};
    int told = 0, elevated = 0;
    for (int i = 0; i < trials(1500); i++) {
        struct family f;
        family_open(&f, 31, 3, 7, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        if (is_telling(&f)) {
            struct made m;
            made_from(&f.owned.problem, &m);
            map_points(&turned, &m);
            compare(&f, &turned, &m, "an affine map");
            made_from(&f.owned.problem, &m);
            map_points(&mirrored, &m);
            compare(&f, &mirrored, &m, "a reflection, the other sign");
            made_from(&f.owned.problem, &m);
            reverse(&m);
            compare(&f, &same, &m, "the curve backwards, the other sign");
            made_from(&f.owned.problem, &m);
            insert_knot(&m, (real)7 / 16);
            compare(&f, &same, &m, "a knot inserted");
            if (f.owned.problem.family.count == f.owned.problem.family.degree + 1) {
                made_from(&f.owned.problem, &m);
                elevate(&m);
                compare(&f, &same, &m, "the degree elevated");
                elevated++;
            }
            told++;
        }
        family_close(&f);
    }
    if (REAL_BITS <= 53)
        assert_true(told > 20 && elevated > 5);
}

/* ---- intervals ---- */

static enum side side_over(struct region_problem *p, struct region_workspace *w, real lo, real hi,
                           struct point d)
{
    p->interval.lo = lo;
    p->interval.hi = hi;
    assert_int_equal(region_prepare(p, w), SOLVED);
    return region_contains(p, w, d, 0);
}

/* Over [a, b] the conditions are those over [a, u] and those over [u, b], whatever u is: a knot, also a
 * manifold one, or none. */
static void test_intervals_meet(void **state)
{
    (void)state;
    int inside = 0, outside = 0;
    for (int i = 0; i < trials(3000); i++) {
        struct family f;
        struct made m;
        struct random_state r = random_for(32, "intervals", (uint64_t)i);
        family_open(&f, 32, 3, 7, (uint64_t)i);
        made_from(&f.owned.problem, &m);
        real lo = m.p.interval.lo, hi = m.p.interval.hi, u = lo + (hi - lo) * (1 + prop_unit(&r, 2)) / 3;
        struct owned_workspace room;
        memset((void *)&room, 0, sizeof room);
        owned_workspace_fit(&room, &m.p);
        struct point d = {9 * prop_dyadic(&r, 20), 9 * prop_dyadic(&r, 20)};
        enum side left = side_over(&m.p, &room.workspace, lo, u, d),
                  right = side_over(&m.p, &room.workspace, u, hi, d),
                  all = side_over(&m.p, &room.workspace, lo, hi, d);
        if ((all == SIDE_INSIDE && (left == SIDE_OUTSIDE || right == SIDE_OUTSIDE)) ||
            (all == SIDE_OUTSIDE && left == SIDE_INSIDE && right == SIDE_INSIDE))
            fail_msg("%s: split at %g: the sides disagree", f.c.id, real_to_double(u));
        inside += all == SIDE_INSIDE;
        outside += all == SIDE_OUTSIDE;
        owned_workspace_clear(&room);
        family_close(&f);
    }
    assert_true(inside > 0 && outside > 0);
}

/* ---- what degenerates ---- */

/* Fixed points on one line, M = 0: a half-plane bounded by that line, or nothing. */
static void test_collinear(void **state)
{
    (void)state;
    struct region *out = region_new();
    struct owned_workspace room;
    int half_planes = 0;
    memset((void *)&room, 0, sizeof room);
    for (int i = 0; i < trials(400); i++) {
        struct made m;
        struct random_state r = random_for(33, "collinear", (uint64_t)i);
        int degree = (int)random_between(&r, 3, 9), free_point = (int)random_between(&r, 0, degree);
        real a = prop_dyadic(&r, 3), b = 1 + prop_unit(&r, 3);
        bool even = random_bits(&r) & 1; /* in order along the line: seldom nothing */
        for (int k = 0; k <= degree; k++) {
            real s = even ? (real)k : 8 * prop_dyadic(&r, 4);
            m.x[k] = b * s;
            m.y[k] = a * s + 1;
        }
        made_bezier(&m, degree, free_point, random_bits(&r) & 1 ? 1 : -1);
        m.y[free_point] += 1;
        m.p.family.at.y = m.y[free_point];
        solve(&m, &room, out);
        assert_true(out->kind == REGION_EMPTY || (out->kind == REGION_UNBOUNDED && out->count == 1));
        if (out->kind == REGION_EMPTY)
            continue;
        const real *line = out->edge[0].line;
        real size = real_sqrt(a * a + b * b), c = b * line[2];
        assert_true(real_abs(line[0] * b + line[1] * a) <= 1000 * REAL_EPSILON * size);
        assert_true(real_abs(c + b * line[1]) <= 100000 * REAL_EPSILON * b);
        half_planes++;
    }
    assert_true(half_planes > 0);
    owned_workspace_clear(&room);
    free(out);
}

/* Over spans where the control point has no say: the plane if the curve bends the right way, else nothing. */
static void test_without_influence(void **state)
{
    (void)state;
    struct region *out = region_new();
    struct owned_workspace room;
    int planes = 0, empties = 0;
    memset((void *)&room, 0, sizeof room);
    for (int i = 0; i < trials(400); i++) {
        struct made m;
        struct random_state r = random_for(34, "influence", (uint64_t)i);
        int degree = (int)random_between(&r, 3, 6), count = degree + 3;
        for (int k = 0; k < count; k++) {
            m.x[k] = (real)k + prop_dyadic(&r, 8) / 2;
            m.y[k] = m.x[k] * m.x[k] / 8 + prop_dyadic(&r, 8) / 4;
        }
        made_bezier(&m, degree, 0, random_bits(&r) & 3 ? 1 : -1);
        for (int k = 0; k <= degree; k++)
            m.knots[count + k] = 1;
        m.knots[degree + 1] = (real)1 / 4;
        m.knots[degree + 2] = (real)1 / 2;
        m.p.family.count = count;
        m.p.interval.lo = (real)1 / 4;
        family_of_point(&m.p.family, 0, m.share);
        solve(&m, &room, out);
        int sign = proof_of_curve(&m.p, m.p.family.at);
        if ((sign > 0 && out->kind != REGION_PLANE) || (sign < 0 && out->kind != REGION_EMPTY))
            fail_msg("line %d: %s, but the curve says %d", i, region_kind_name(out->kind), sign);
        planes += sign > 0;
        empties += sign < 0;
    }
    assert_true(planes > 0 && empties > 0);
    owned_workspace_clear(&room);
    free(out);
}

/* The first two control points are one: there A = B = 0 and the curve stands still, so nothing is strict, and
 * the region is that of every slightly smaller interval. */
static void test_repeated_end(void **state)
{
    (void)state;
    struct region *out = region_new(), *inner = region_new();
    struct owned_workspace room;
    int regions = 0;
    memset((void *)&room, 0, sizeof room);
    for (int i = 0; i < trials(400); i++) {
        struct made m;
        struct random_state r = random_for(35, "repeated", (uint64_t)i);
        int degree = (int)random_between(&r, 3, 6), free_point = (int)random_between(&r, 2, degree);
        for (int k = 0; k <= degree; k++) {
            m.x[k] = (real)k + prop_dyadic(&r, 8) / 2;
            m.y[k] = m.x[k] * m.x[k] / 8 + prop_dyadic(&r, 8) / 8;
        }
        m.x[1] = m.x[0];
        m.y[1] = m.y[0];
        made_bezier(&m, degree, free_point, 1);
        solve(&m, &room, out);
        assert_false(out->strict);
        if (!out->certified || out->kind == REGION_EMPTY)
            continue;
        m.p.interval.lo = real_ldexp(1, -REAL_BITS / 3);
        solve(&m, &room, inner);
        assert_int_equal(inner->kind, out->kind);
        if (out->kind == REGION_BOUNDED)
            assert_true(real_abs(inner->area - out->area) <= out->area / 1000);
        regions++;
    }
    assert_true(regions > 0);
    owned_workspace_clear(&room);
    free(out);
    free(inner);
}

/* ---- closed forms ---- */

static real det(const real *a, const real *b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/* A cubic over [0, 1] with legs q0, q1, q2: det(F', F'') > 0 where det(q0, q1) > 0, det(q1, q2) > 0 and
 * det(q0, q2) / 2 > -sqrt(det(q0, q1) det(q1, q2)): its Bernstein coefficients as a quadratic. */
static void test_cubics(void **state)
{
    (void)state;
    struct owned_workspace room;
    int inside = 0, outside = 0;
    memset((void *)&room, 0, sizeof room);
    for (int i = 0; i < trials(20000); i++) {
        struct made m;
        struct random_state r = random_for(36, "cubics", (uint64_t)i);
        real q[3][2];
        for (int k = 0; k < 4; k++) {
            m.x[k] = prop_dyadic(&r, 16);
            m.y[k] = prop_dyadic(&r, 16);
        }
        int free_point = (int)random_between(&r, 0, 3);
        made_bezier(&m, 3, free_point, 1);
        for (int k = 0; k < 3; k++) {
            q[k][0] = m.x[k + 1] - m.x[k];
            q[k][1] = m.y[k + 1] - m.y[k];
        }
        real a = det(q[0], q[1]), b = det(q[0], q[2]) / 2, c = det(q[1], q[2]);
        bool expected = a > 0 && c > 0 && (b > 0 || b * b < a * c);
        real near = real_abs(b * b - a * c);
        owned_workspace_fit(&room, &m.p);
        assert_int_equal(region_prepare(&m.p, &room.workspace), SOLVED);
        enum side side = region_contains(&m.p, &room.workspace, m.p.family.at, 0);
        if (side == SIDE_BOUNDARY) {
            assert_true(near < real_ldexp(1, -30) || a * c == 0);
            continue;
        }
        assert_int_equal(side == SIDE_INSIDE, expected);
        inside += expected;
        outside += !expected;
    }
    assert_true(inside > 0 && outside > 0);
    owned_workspace_clear(&room);
}

/* ---- what is not taken ---- */

static void test_degrees(void **state)
{
    (void)state;
    struct region *out = region_new();
    for (int degree = 2; degree <= DEGREE_MAX; degree += 3) {
        for (int rational = 0; rational < 2; rational++) {
            struct made m;
            struct owned_workspace room;
            memset((void *)&room, 0, sizeof room);
            for (int k = 0; k <= degree; k++) {
                m.x[k] = (real)k;
                m.y[k] = (real)k * k / 8;
            }
            made_bezier(&m, degree, degree / 2, 1);
            m.p.family.weight = rational ? m.weight : NULL;
            owned_workspace_fit(&room, &m.p);
            enum outcome outcome = region_solve(&m.p, region_methods[0], &room.workspace, out);
            assert_int_equal(outcome, rational && degree > REGION_RATIONAL_MAX ? UNSUPPORTED : SOLVED);
            assert_true(outcome != SOLVED || out->kind != REGION_EMPTY);
            owned_workspace_clear(&room);
        }
    }
    free(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_invariances),       cmocka_unit_test(test_intervals_meet),
        cmocka_unit_test(test_collinear),         cmocka_unit_test(test_cubics),
        cmocka_unit_test(test_without_influence), cmocka_unit_test(test_repeated_end),
        cmocka_unit_test(test_degrees),
    };
    return cmocka_run_group_tests_name("curvature", tests, NULL, NULL);
}
