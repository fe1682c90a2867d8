/* Regions over parts of a curve, what becomes of one when parts of the problem degenerate, and regions known
 * in closed form. */
#include "region_made.h"

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
        cmocka_unit_test(test_intervals_meet), cmocka_unit_test(test_collinear),
        cmocka_unit_test(test_cubics),         cmocka_unit_test(test_without_influence),
        cmocka_unit_test(test_repeated_end),   cmocka_unit_test(test_degrees),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
