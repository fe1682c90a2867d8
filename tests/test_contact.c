/* The gap between two arcs: a zero in the box is in a piece, whatever the contact; and contacts are narrowed.
 */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/bernstein.h"
#include "../algorithms/core/contact.h"
#include "../algorithms/core/roots.h"

enum { DEGREE = 6, SCRATCH = 8192 };

static real scratch[SCRATCH];

/* f, and g(s) = f(s) + (s - zero)^order v: contact of that order at t = s = zero, but where v lies along f'.
 */
struct contact {
    real f[2 * (DEGREE + 1)], g[2 * (DEGREE + 1)], zero;
    int degree, order;
    struct lowered a, b;
};

/* Coefficient i of (s - zero)^k in degree n is the mean of products of k of its arguments' distances from
 * zero. */
static void power(int n, int k, real zero, real *out)
{
    out[0] = 1;
    for (int i = 0; i < k; i++) {
        const real factor[2] = {-zero, 1 - zero};
        real product[DEGREE + 1];
        bernstein_multiply(i, out, 1, factor, product);
        for (int j = 0; j <= i + 1; j++)
            out[j] = product[j];
    }
    bernstein_elevate(k, out, n - k, out);
}

static void contact_make(struct contact *c, struct random_state *r)
{
    const int n = c->degree = (int)random_between(r, 2, DEGREE);
    real p[DEGREE + 1], vx = prop_dyadic(r, 10), vy = prop_dyadic(r, 10);
    c->order = (int)random_between(r, 1, n < 4 ? n : 4);
    c->zero = nasty_unit(r);
    power(n, c->order, c->zero, p);
    for (int i = 0; i <= n; i++) {
        c->f[i] = prop_dyadic(r, 20);
        c->f[n + 1 + i] = prop_dyadic(r, 20);
        c->g[i] = c->f[i] + vx * p[i];
        c->g[n + 1 + i] = c->f[n + 1 + i] + vy * p[i];
    }
    const struct arc f = {n, c->f, c->f + n + 1, NULL, 0},
                     g = {n, c->g, c->g + n + 1, NULL, 64 * REAL_EPSILON};
    lowered_take(&f, &c->a);
    lowered_take(&g, &c->b);
}

static struct interval around(struct random_state *r, real x, real width)
{
    struct interval i = {real_max(0, x - width * prop_unit(r, 10)),
                         real_min(1, x + width * prop_unit(r, 10))};
    return i;
}

static bool holds(const struct interval *i, real x)
{
    return i->lo <= x && x <= i->hi;
}

static void test_zero_is_kept(void **state)
{
    (void)state;
    int narrowed = 0, cases = trials(8000);
    assert_true(roots_scratch(2 * DEGREE) <= SCRATCH);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, "kept", (uint64_t)i);
        struct contact c;
        struct contact_piece piece[CONTACT_DEGREE_MAX + 1];
        contact_make(&c, &r);
        real width = real_ldexp(1, -(int)random_between(&r, 2, REAL_BITS - 8)), after = 0;
        struct interval t = around(&r, c.zero, width), s = around(&r, c.zero, width);
        int count = contact_meet(&c.a, &t, &c.b, &s, 8 * REAL_EPSILON, scratch, piece), held = 0;
        for (int j = 0; j < count; j++) {
            held += holds(&piece[j].t, c.zero) && holds(&piece[j].s, c.zero);
            after += piece[j].t.hi - piece[j].t.lo;
        }
        if (count >= 0 && !held)
            fail_msg("case %d: degree %d, contact %d: the zero is lost", i, c.degree, c.order);
        narrowed += count >= 0 && after < (t.hi - t.lo) / 2;
    }
    assert_true(narrowed > cases / 8);
}

/* A parabola on its tangent, in a box of width h: left is the root of rounding, not of h. */
static void test_contact_is_narrowed(void **state)
{
    (void)state;
    const real x[3] = {0, (real)1 / 2, 1}, y[3] = {(real)1 / 4, (real)-1 / 4, (real)1 / 4};
    const real along[2] = {0, 1}, zero[2] = {0, 0};
    const struct arc f = {2, x, y, NULL, 0}, g = {1, along, zero, NULL, 0};
    struct lowered a, b;
    struct contact_piece piece[CONTACT_DEGREE_MAX + 1];
    lowered_take(&f, &a);
    lowered_take(&g, &b);
    for (int k = 4; k < REAL_BITS / 2 - 8; k += 3) {
        real h = real_ldexp(1, -k);
        struct interval t = {(real)1 / 2 - h, (real)1 / 2 + h / 3},
                        s = {(real)1 / 2 - h / 3, (real)1 / 2 + h};
        assert_int_equal(contact_meet(&a, &t, &b, &s, REAL_EPSILON, scratch, piece), 1);
        assert_true(holds(&piece[0].t, (real)1 / 2) && holds(&piece[0].s, (real)1 / 2));
        assert_true(piece[0].t.hi - piece[0].t.lo < real_ldexp(1, -REAL_BITS / 2 + 5));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_zero_is_kept),
                                       cmocka_unit_test(test_contact_is_narrowed)};
    return cmocka_run_group_tests_name("gap", tests, NULL, NULL);
}
