/* Pairs restricted to boxes: the same points, exactly, and the solution where it is said to be. */
#include <math.h>
#include <string.h>

#include "../harness/case_fields.h"
#include "../harness/close_up.h"
#include "dyadic.h"
#include "prop.h"

/* Random dyadic control points; weights k/8. */
static void make_curve(struct case_curve *c, struct random_state *r, int n, bool rational)
{
    memset(c, 0, sizeof *c);
    c->degree = n;
    c->rational = rational;
    c->x = rationals_new(n + 1);
    c->y = rationals_new(n + 1);
    c->w = rationals_new(n + 1);
    mpq_inits(c->lo, c->hi, NULL);
    mpq_set_si(c->hi, 1, 1);
    for (int i = 0; i <= n; i++) {
        mpq_set_si(c->x[i], random_between(r, -1000, 1000), 1 + (unsigned long)random_between(r, 0, 6));
        mpq_set_si(c->y[i], random_between(r, -1000, 1000), 8);
        mpq_set_si(c->w[i], rational ? random_between(r, 1, 32) : 8, 8);
        mpq_canonicalize(c->x[i]);
        mpq_canonicalize(c->y[i]);
        mpq_canonicalize(c->w[i]);
    }
}

static void set_ratio(mpq_t q, long a, unsigned long b)
{
    mpq_set_si(q, a, b);
    mpq_canonicalize(q);
}

/* near(u) + origin = c(lo + (hi - lo) u), up to the common factor of homogeneous points. */
static void assert_same_point(const struct case_curve *c, const struct case_curve *near, mpq_t lo, mpq_t hi,
                              mpq_t *origin, const mpq_t u)
{
    mpq_t t, *a = rationals_new(3), *b = rationals_new(3);
    mpq_init(t);
    mpq_sub(t, hi, lo);
    mpq_mul(t, t, u);
    mpq_add(t, t, lo);
    curve_point_exact(c, t, a);
    curve_point_exact(near, u, b);
    for (int k = 0; k < 2; k++) {
        mpq_div(a[k], a[k], a[2]);
        mpq_div(b[k], b[k], b[2]);
        mpq_add(b[k], b[k], origin[k]);
        assert_true(mpq_equal(a[k], b[k]));
    }
    mpq_clear(t);
    rationals_free(a, 3);
    rationals_free(b, 3);
}

static void test_restriction_is_exact(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        struct random_state r = random_for(21, "restrict", (uint64_t)i);
        struct case_curve c, near;
        mpq_t *q = rationals_new(5); /* lo, hi, origin, u */
        make_curve(&c, &r, (int)random_between(&r, 1, 9), i % 2);
        set_ratio(q[0], random_between(&r, 0, 40), 97);
        set_ratio(q[1], random_between(&r, 41, 97), 97);
        set_ratio(q[2], random_between(&r, -50, 50), 3);
        set_ratio(q[3], random_between(&r, -50, 50), 7);
        curve_restrict(&c, q[0], q[1], q + 2, &near);
        for (int k = 0; k <= 4; k++) {
            set_ratio(q[4], k, 4);
            assert_same_point(&c, &near, q[0], q[1], q + 2, q[4]);
        }
        curve_clear(&c);
        curve_clear(&near);
        rationals_free(q, 5);
    }
}

/* Also at the ends, and with the curves exchanged: the point of the solution is the origin of the near pair.
 */
static void test_solution_stays(void **state)
{
    static const long numerators[] = {0, 37, 50, 99, 100};
    (void)state;
    for (int i = 0; i < 200; i++) {
        struct random_state r = random_for(22, "solution", (uint64_t)i);
        struct test_case c, near;
        struct known_solution z, at;
        mpq_t *point = rationals_new(6);
        bool exchanged = i % 3 == 0;
        memset(&c, 0, sizeof c);
        memset(&z, 0, sizeof z);
        make_curve(&c.f, &r, (int)random_between(&r, 1, 6), i % 2);
        make_curve(&c.g, &r, (int)random_between(&r, 1, 6), false);
        mpq_inits(z.t, z.s, NULL);
        set_ratio(z.t, numerators[random_bits(&r) % 5], 100);
        set_ratio(z.s, numerators[random_bits(&r) % 5], 100);
        z.bits = INFINITY;
        curve_point_exact(&c.f, z.t, point);
        curve_point_exact(&c.g, z.s, point + 3);
        for (int k = 0; k < 2; k++) { /* move g so that they meet */
            mpq_div(point[k], point[k], point[2]);
            mpq_sub(point[k], point[k], point[3 + k]);
            for (int j = 0; j <= c.g.degree; j++)
                mpq_add((k ? c.g.y : c.g.x)[j], (k ? c.g.y : c.g.x)[j], point[k]);
        }
        double x = 1 + 30 * random_unit(&r), y = 1 + 30 * random_unit(&r);
        close_up_make(&c, &z, x, y, exchanged, &near);
        close_up_solution(&z, x, y, exchanged, &at);
        assert_true(mpq_sgn(at.t) >= 0 && mpq_cmp_si(at.t, 1, 1) <= 0 && mpq_sgn(at.s) >= 0 &&
                    mpq_cmp_si(at.s, 1, 1) <= 0);
        curve_point_exact(&near.f, at.t, point);
        curve_point_exact(&near.g, at.s, point + 3);
        for (int k = 0; k < 2; k++)
            assert_true(mpq_sgn(point[k]) == 0 && mpq_sgn(point[3 + k]) == 0);
        assert_int_equal(near.f.degree, exchanged ? c.g.degree : c.f.degree);
        close_up_clear(&near);
        curve_clear(&c.f);
        curve_clear(&c.g);
        mpq_clears(z.t, z.s, at.t, at.s, NULL);
        rationals_free(point, 6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_restriction_is_exact),
        cmocka_unit_test(test_solution_stays),
    };
    return cmocka_run_group_tests_name("close up", tests, NULL, NULL);
}
