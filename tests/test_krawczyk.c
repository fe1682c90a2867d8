/* Krawczyk's test: a zero planted in a box is never denied, and lies where the test says. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/bernstein.h"
#include "../algorithms/core/krawczyk.h"

/* Two curves and a zero (t, s) of their difference, exact but for rounding that error bounds. */
struct meeting {
    struct prop_curve f, g;
    struct arc a, b;
    real t, s;
};

static real value(const struct prop_curve *c, const real *x, real t)
{
    real v = bernstein_value(c->curve.degree, x, t);
    return c->curve.w ? v / bernstein_value(c->curve.degree, c->w, t) : v;
}

static struct arc arc_of(const struct curve *c, real error)
{
    struct arc a = {c->degree, c->x, c->y, c->w, error};
    return a;
}

/* Moves g so that g(s) = f(t). */
static void meeting_make(struct meeting *m, struct random_state *r)
{
    int n = nasty_degree(r, 8), k = nasty_degree(r, 8);
    prop_curve_make(&m->f, r, n, 20, random_bits(r) % 3 == 0);
    prop_curve_make(&m->g, r, k, 20, random_bits(r) % 3 == 0);
    m->t = nasty_unit(r);
    m->s = nasty_unit(r);
    real x = value(&m->f, m->f.x, m->t) - value(&m->g, m->g.x, m->s);
    real y = value(&m->f, m->f.y, m->t) - value(&m->g, m->g.y, m->s);
    for (int i = 0; i <= k; i++) {
        m->g.x[i] += m->g.w[i] * x;
        m->g.y[i] += m->g.w[i] * y;
    }
    m->a = arc_of(&m->f.curve, 0);
    m->b =
        arc_of(&m->g.curve, 256 * REAL_EPSILON); /* of the move: 8 (3 degree + 3) u for coordinates below 8 */
}

/* An interval around x within [0, 1], up to `width` to either side. */
static struct interval around(struct random_state *r, real x, real width)
{
    struct interval i = {real_max(0, x - width * prop_unit(r, 10)),
                         real_min(1, x + width * prop_unit(r, 10))};
    return i;
}

static void test_planted(void **state)
{
    (void)state;
    int proved = 0, cases = trials(8000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, "planted", (uint64_t)i);
        struct meeting m;
        meeting_make(&m, &r);
        real width = real_ldexp(1, -(int)random_between(&r, 1, REAL_BITS));
        struct interval t = around(&r, m.t, width), s = around(&r, m.s, width);
        enum proof proof = krawczyk_narrow(&m.a, &m.b, &t, &s);
        if (proof == NO_ZERO)
            fail_msg("case %d: a zero is denied", i);
        if (proof == ONE_ZERO && !(t.lo <= m.t && m.t <= t.hi && s.lo <= m.s && m.s <= s.hi))
            fail_msg("case %d: the zero lies elsewhere", i);
        proved += proof == ONE_ZERO;
    }
    assert_true(proved > cases / 2);
}

/* Two zeros in a box: never called one.  Conics x = t, y = (t - p)(t - q) against a line. */
static void test_two_zeros(void **state)
{
    (void)state;
    for (int i = 0; i < trials(4000); i++) {
        struct random_state r = random_for(2, "two", (uint64_t)i);
        real p = prop_unit(&r, 10), q = p + real_ldexp(1, -(int)random_between(&r, 1, REAL_BITS / 3));
        const real x[3] = {0, (real)1 / 2, 1}, y[3] = {p * q, p * q - (p + q) / 2, (1 - p) * (1 - q)};
        const real along[2] = {0, 1}, zero[2] = {0, 0};
        const struct arc f = {2, x, y, NULL, 4 * REAL_EPSILON}, g = {1, along, zero, NULL, 0};
        struct interval t = {real_max(0, p - (q - p)), real_min(1, q)}, s = t;
        if (q <= 1 && krawczyk_narrow(&f, &g, &t, &s) != UNDECIDED)
            fail_msg("case %d: two zeros taken for one or none", i);
    }
}

/* Curves apart in the box: denied, or undecided, never proved. */
static void test_no_zero(void **state)
{
    (void)state;
    int denied = 0, cases = trials(4000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(3, "none", (uint64_t)i);
        struct meeting m;
        meeting_make(&m, &r);
        int k = m.g.curve.degree;
        for (int j = 0; j <= k; j++)
            m.g.x[j] += m.g.w[j] * 20; /* f stays within 1 of the origin, g within 4 */
        struct interval t = around(&r, m.t, real_ldexp(1, -8)), s = around(&r, m.s, real_ldexp(1, -8));
        enum proof proof = krawczyk_narrow(&m.a, &m.b, &t, &s);
        if (proof == ONE_ZERO && t.lo <= 1 && t.hi >= 0 && s.lo <= 1 && s.hi >= 0)
            fail_msg("case %d: a zero where there is none", i);
        denied += proof == NO_ZERO;
    }
    assert_true(denied > cases / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_planted), cmocka_unit_test(test_two_zeros),
                                       cmocka_unit_test(test_no_zero)};
    return cmocka_run_group_tests_name("krawczyk", tests, NULL, NULL);
}
