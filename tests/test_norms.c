/* The three norms of a curve: the bounds that curve.h states, against exact arithmetic. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/curve.h"

enum { DEGREE = 32 };

static void add_square(const real a, mpq_t sum)
{
    mpq_t q;
    mpq_init(q);
    real_to_rational(a, q);
    mpq_mul(q, q, q);
    mpq_add(sum, sum, q);
    mpq_clear(q);
}

/* max |a_i|^2. */
static void largest_square(int n, const real *x, const real *y, mpq_t out)
{
    mpq_t q;
    mpq_init(q);
    mpq_set_ui(out, 0, 1);
    for (int i = 0; i <= n; i++) {
        mpq_set_ui(q, 0, 1);
        add_square(x[i], q);
        add_square(y[i], q);
        if (mpq_cmp(q, out) > 0)
            mpq_set(out, q);
    }
    mpq_clear(q);
}

/* The integral of c^2 over [0, 1]: c in powers of t, c = sum of C(n,k) D^k c_0 t^k with differences D. */
static void add_integral(int n, const real *c, mpq_t sum)
{
    struct dyadics d;
    mpz_t b;
    mpq_t term, power[DEGREE + 1];
    dyadics_init(&d);
    mpz_init(b);
    mpq_init(term);
    rationals_init(n + 1, power);
    dyadics_set(&d, n, c);
    for (int k = 0; k <= n; k++) {
        dyadics_get(&d, 0, power[k]);
        mpz_bin_uiui(b, (unsigned long)n, (unsigned long)k);
        mpq_set_z(term, b);
        mpq_mul(power[k], power[k], term);
        for (int i = 0; i < n - k; i++)
            mpz_sub(d.m[i], d.m[i + 1], d.m[i]);
    }
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            mpq_t share;
            mpq_init(share);
            mpq_set_si(share, 1, (unsigned long)(i + j + 1));
            mpq_mul(term, power[i], power[j]);
            mpq_mul(term, term, share);
            mpq_add(sum, sum, term);
            mpq_clear(share);
        }
    rationals_clear(n + 1, power);
    mpq_clear(term);
    mpz_clear(b);
    dyadics_clear(&d);
}

static void square(real a, mpq_t out)
{
    mpq_set_ui(out, 0, 1);
    add_square(a, out);
}

/* |computed^2 - exact| <= units u size; the square of a rounded root errs by 2 u of itself more. */
static bool is_root(real computed, const mpq_t exact, long units, const mpq_t size)
{
    mpq_t a, bound;
    mpq_inits(a, bound, NULL);
    square(computed, a);
    bound_add(bound, units, size);
    bound_add(bound, 2, exact);
    mpq_sub(a, a, exact);
    bool good = is_within(0, a, bound);
    mpq_clears(a, bound, NULL);
    return good;
}

static void test_norms(void **state)
{
    (void)state;
    mpq_t exact, size;
    mpq_inits(exact, size, NULL);
    for (int i = 0; i < trials(300); i++) {
        struct random_state r = random_for(1, "norms", (uint64_t)i);
        real x[DEGREE + 1], y[DEGREE + 1];
        int n = nasty_degree(&r, DEGREE), units = n * n + 12 * n + 12;
        nasty_coefficients(&r, n, x);
        nasty_coefficients(&r, n, y);
        for (int k = 0; i % 3 == 0 && k <= n; k++) { /* nothing cancels */
            x[k] = real_abs(x[k]);
            y[k] = real_abs(y[k]);
        }
        mpq_set_ui(exact, 0, 1);
        add_integral(n, x, exact);
        add_integral(n, y, exact);
        largest_square(n, x, y, size);
        if (!is_root(norm_l2(n, x, y), exact, units, i % 3 ? size : exact))
            fail_msg("L2 norm %d: degree %d", i, n);
        if (!is_root(norm_bb(n, x, y), size, 2, size))
            fail_msg("BB norm %d: degree %d", i, n);
    }
    mpq_clears(exact, size, NULL);
}

/* |f(t)|^2. */
static void square_at(int n, const real *x, const real *y, real t, mpq_t out)
{
    mpq_t q;
    mpq_init(q);
    exact_value(n, x, t, out);
    mpq_mul(out, out, out);
    exact_value(n, y, t, q);
    mpq_mul(q, q, q);
    mpq_add(out, out, q);
    mpq_clear(q);
}

/* Every point is within hi (1 + 16 n u), and some point of the grid of 2^-levels reaches lo.  hi - lo is at
 * most n^2 / 8 max|second difference| 4^-levels: the polygon is that near to its curve after so many
 * halvings, and the curve to its value at the nearest end of a piece where it is longest inside. */
static void check_infinity(int n, const real *x, const real *y, int levels, int trial)
{
    struct norm_enclosure e = norm_infinity(n, x, y, levels);
    mpq_t most, at, bound;
    mpq_inits(most, at, bound, NULL);
    for (int k = 0; k <= 1 << levels; k++) {
        square_at(n, x, y, real_ldexp((real)k, -levels), at);
        if (mpq_cmp(at, most) > 0)
            mpq_set(most, at);
    }
    square(e.lo, at);
    bool reached = mpq_cmp(at, most) <= 0;
    for (int k = 0; k < 16; k++) {
        struct random_state r = random_for(2, "infinity", (uint64_t)(100 * trial + k));
        square_at(n, x, y, nasty_unit(&r), at);
        if (mpq_cmp(at, most) > 0)
            mpq_set(most, at);
    }
    square(e.hi, bound);
    mpq_set(at, bound);
    bound_add(bound, 32 * n, at);
    real bend = 0, size = 0;
    for (int k = 0; k <= n; k++) {
        if (k > 1)
            bend = real_max(bend, real_abs(x[k] - 2 * x[k - 1] + x[k - 2]) +
                                      real_abs(y[k] - 2 * y[k - 1] + y[k - 2]));
        size = real_max(size, real_abs(x[k]) + real_abs(y[k]));
    }
    bool narrow =
        e.hi - e.lo <= real_ldexp(n * n * bend / 8, -2 * levels) + 64 * (n + 4) * REAL_EPSILON * size;
    if (!reached || mpq_cmp(most, bound) > 0 || !narrow)
        fail_msg("L-infinity norm %d: degree %d, %d levels: %s", trial, n, levels,
                 !reached ? "lo is not reached"
                 : narrow ? "hi is exceeded"
                          : "too wide");
    mpq_clears(most, at, bound, NULL);
}

static void test_infinity(void **state)
{
    (void)state;
    for (int i = 0; i < trials(200); i++) {
        struct random_state r = random_for(1, "infinity", (uint64_t)i);
        real x[DEGREE + 1], y[DEGREE + 1];
        int n = nasty_degree(&r, i % 4 ? 8 : DEGREE);
        nasty_coefficients(&r, n, x);
        nasty_coefficients(&r, n, y);
        check_infinity(n, x, y, (int)random_between(&r, 0, 6), i);
    }
}

/* (4 t (1 - t), 0) is longest at 1/2, with 1; t -> (t, 1) at the end, with sqrt 2. */
static void test_known_infinity(void **state)
{
    (void)state;
    const real x[] = {0, 2, 0}, y[] = {0, 0, 0}, t[] = {0, (real)0.5, 1}, one[] = {1, 1, 1};
    for (int levels = 0; levels <= 16; levels++) {
        struct norm_enclosure e = norm_infinity(2, x, y, levels), f = norm_infinity(2, t, one, levels);
        assert_true((levels == 0 || e.lo <= 1) && e.hi >= 1 && e.hi <= 1 + real_ldexp(2, -levels));
        assert_true(f.lo * f.lo <= 2 && f.hi * f.hi >= 2 && f.hi - f.lo <= 1000 * REAL_EPSILON);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_norms),
        cmocka_unit_test(test_infinity),
        cmocka_unit_test(test_known_infinity),
    };
    return cmocka_run_group_tests_name("norms", tests, NULL, NULL);
}
