/* Polynomials in Bernstein form: every error bound that bernstein.h states, against exact arithmetic. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/bernstein.h"

enum { DEGREE = 32, COMPONENTS = 3, LENGTH = COMPONENTS * (DEGREE + 1) };

/* Value at t of the derivative of the polynomial with coefficients c[0..n]. */
static void exact_slope(int n, const real *c, real t, mpq_t out)
{
    struct dyadics d;
    struct dyadic at;
    dyadics_init(&d);
    dyadic_init(&at);
    dyadic_set(&at, t);
    dyadics_set(&d, n, c);
    for (int k = 0; k < n; k++) {
        mpz_sub(d.m[k], d.m[k + 1], d.m[k]);
        mpz_mul_si(d.m[k], d.m[k], n);
    }
    d.n = n - 1;
    dyadics_value(&d, &at, out);
    dyadic_clear(&at);
    dyadics_clear(&d);
}

static void test_value(void **state)
{
    (void)state;
    mpq_t exact, size;
    mpq_init(exact);
    mpq_init(size);
    for (int i = 0; i < trials(4000); i++) {
        struct random_state r = random_for(1, "value", (uint64_t)i);
        real c[DEGREE + 1], a[DEGREE + 1], scratch[DEGREE + 1], slope;
        int n = nasty_degree(&r, DEGREE);
        real t = nasty_unit(&r);
        nasty_coefficients(&r, n, c);
        for (int k = 0; k <= n; k++)
            a[k] = real_abs(c[k]);
        exact_value(n, c, t, exact);
        exact_value(n, a, t, size);
        if (!is_near(bernstein_value(n, c, t), exact, 3 * n, size) ||
            !is_near(bernstein_value_slope(n, c, t, scratch, &slope), exact, 3 * n, size))
            fail_msg("value %d: degree %d", i, n);
        exact_slope(n, c, t, exact);
        exact_largest(n, c, size);
        if (!is_near(slope, exact, 2 * n * (3 * n + 1), size))
            fail_msg("slope %d: degree %d", i, n);
    }
    mpq_clear(exact);
    mpq_clear(size);
}

/* Is out[0..n] = c over [lo, hi], each within units u times the blossom of |c|? */
static bool is_restriction(int n, const real *c, const struct interval *t, const real *out, long units)
{
    bool all = true;
    mpq_t exact[DEGREE + 1], size[DEGREE + 1];
    struct dyadics d;
    dyadics_init(&d);
    rationals_init(n + 1, exact);
    rationals_init(n + 1, size);
    dyadics_set(&d, n, c);
    exact_restrict(&d, t->lo, t->hi, exact);
    dyadics_set(&d, n, c);
    dyadics_abs(&d);
    exact_restrict(&d, t->lo, t->hi, size);
    for (int i = 0; i <= n; i++)
        all = all && is_near(out[i], exact[i], units, size[i]);
    rationals_clear(n + 1, exact);
    rationals_clear(n + 1, size);
    dyadics_clear(&d);
    return all;
}

/* Degree, number of components, and their coefficients one after the other. */
struct polynomials {
    int n, components;
    real c[LENGTH];
};

static void polynomials_make(struct polynomials *p, struct random_state *r)
{
    p->n = nasty_degree(r, DEGREE);
    p->components = (int)random_between(r, 1, COMPONENTS);
    for (int k = 0; k < p->components; k++)
        nasty_coefficients(r, p->n, p->c + k * (p->n + 1));
}

static void test_restrict(void **state)
{
    (void)state;
    for (int i = 0; i < trials(1200); i++) {
        struct random_state r = random_for(1, "restrict", (uint64_t)i);
        struct polynomials p;
        real out[LENGTH];
        polynomials_make(&p, &r);
        struct interval t = nasty_interval(&r);
        bernstein_restrict(p.n, p.components, p.c, t.lo, t.hi, out);
        for (int k = 0; k < p.components; k++)
            if (!is_restriction(p.n, p.c + k * (p.n + 1), &t, out + k * (p.n + 1), 8 * p.n))
                fail_msg("restrict %d: degree %d, component %d", i, p.n, k);
        if (t.lo == 0 && t.hi == 1)
            for (int k = 0; k < p.components * (p.n + 1); k++)
                assert_true(out[k] == p.c[k]);
    }
}

static void test_halve(void **state)
{
    (void)state;
    const struct interval lower = {0, (real)0.5}, upper = {(real)0.5, 1};
    for (int i = 0; i < trials(1200); i++) {
        struct random_state r = random_for(1, "halve", (uint64_t)i);
        struct polynomials p;
        real left[LENGTH], right[LENGTH];
        polynomials_make(&p, &r);
        bernstein_halve(p.n, p.components, p.c, left, right);
        for (int k = 0; k < p.components; k++) {
            int at = k * (p.n + 1);
            if (!is_restriction(p.n, p.c + at, &lower, left + at, p.n) ||
                !is_restriction(p.n, p.c + at, &upper, right + at, p.n))
                fail_msg("halve %d: degree %d, component %d", i, p.n, k);
            assert_true(left[at + p.n] == right[at]);
        }
    }
}

static void test_derivative(void **state)
{
    (void)state;
    mpq_t a, b;
    mpq_init(a);
    mpq_init(b);
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(1, "derivative", (uint64_t)i);
        real c[DEGREE + 1], out[DEGREE];
        int n = nasty_degree(&r, DEGREE);
        nasty_coefficients(&r, n, c);
        bernstein_derivative(n, c, out);
        for (int k = 0; k < n; k++) {
            real_to_rational(c[k + 1], a);
            real_to_rational(c[k], b);
            mpq_sub(a, a, b);
            mpq_set_si(b, n, 1);
            mpq_mul(a, a, b);
            assert_true(is_near(out[k], a, 2, a));
        }
    }
    mpq_clear(a);
    mpq_clear(b);
}

/* Coefficient k in degree n + r is the sum of C(r, k-i) C(n, i) / C(n+r, k) c[i]. */
static void exact_elevate(int n, const real *c, int r, int k, mpq_t out)
{
    mpz_t b;
    mpq_t term;
    mpz_init(b);
    mpq_init(term);
    mpq_set_ui(out, 0, 1);
    for (int i = k > r ? k - r : 0; i <= n && i <= k; i++) {
        real_to_rational(c[i], term);
        mpz_bin_uiui(b, (unsigned long)r, (unsigned long)(k - i));
        mpz_mul(mpq_numref(term), mpq_numref(term), b);
        mpz_bin_uiui(b, (unsigned long)n, (unsigned long)i);
        mpz_mul(mpq_numref(term), mpq_numref(term), b);
        mpq_canonicalize(term);
        mpq_add(out, out, term);
    }
    mpz_bin_uiui(b, (unsigned long)(n + r), (unsigned long)k);
    mpq_set_z(term, b);
    mpq_div(out, out, term);
    mpz_clear(b);
    mpq_clear(term);
}

static void test_elevate(void **state)
{
    (void)state;
    mpq_t exact, size;
    mpq_init(exact);
    mpq_init(size);
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(1, "elevate", (uint64_t)i);
        real c[DEGREE + 1], out[DEGREE + 1];
        int n = nasty_degree(&r, DEGREE - 1), more = (int)random_between(&r, 0, DEGREE - n);
        nasty_coefficients(&r, n, c);
        bernstein_elevate(n, c, more, out);
        exact_largest(n, c, size);
        for (int k = 0; k <= n + more; k++) {
            exact_elevate(n, c, more, k, exact);
            if (!is_near(out[k], exact, 4 * more, size))
                fail_msg("elevate %d: %d to %d, coefficient %d", i, n, n + more, k);
        }
        bernstein_elevate(n, c, more, c);
        for (int k = 0; k <= n + more; k++)
            assert_true(c[k] == out[k]);
    }
    mpq_clear(exact);
    mpq_clear(size);
}

/* Coefficient k of the product, and of that of the absolute values. */
static void exact_product(int n, const real *a, int m, const real *b, int k, mpq_t out, mpq_t size)
{
    mpz_t c;
    mpq_t term, factor;
    mpz_init(c);
    mpq_init(term);
    mpq_init(factor);
    mpq_set_ui(out, 0, 1);
    mpq_set_ui(size, 0, 1);
    for (int i = k > m ? k - m : 0; i <= n && i <= k; i++) {
        real_to_rational(a[i], term);
        real_to_rational(b[k - i], factor);
        mpq_mul(term, term, factor);
        mpz_bin_uiui(c, (unsigned long)n, (unsigned long)i);
        mpq_set_z(factor, c);
        mpq_mul(term, term, factor);
        mpz_bin_uiui(c, (unsigned long)m, (unsigned long)(k - i));
        mpq_set_z(factor, c);
        mpq_mul(term, term, factor);
        mpq_add(out, out, term);
        mpq_abs(term, term);
        mpq_add(size, size, term);
    }
    mpz_bin_uiui(c, (unsigned long)(n + m), (unsigned long)k);
    mpq_set_z(factor, c);
    mpq_div(out, out, factor);
    mpq_div(size, size, factor);
    mpz_clear(c);
    mpq_clear(term);
    mpq_clear(factor);
}

static void test_multiply(void **state)
{
    (void)state;
    mpq_t exact, size;
    mpq_init(exact);
    mpq_init(size);
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(1, "multiply", (uint64_t)i);
        real a[DEGREE + 1], b[DEGREE + 1], out[2 * DEGREE + 1];
        int n = nasty_degree(&r, DEGREE), m = nasty_degree(&r, DEGREE);
        nasty_coefficients(&r, n, a);
        nasty_coefficients(&r, m, b);
        bernstein_multiply(n, a, m, b, out);
        for (int k = 0; k <= n + m; k++) {
            exact_product(n, a, m, b, k, exact, size);
            if (!is_near(out[k], exact, n + m + 6, size))
                fail_msg("multiply %d: %d times %d, coefficient %d", i, n, m, k);
        }
    }
    mpq_clear(exact);
    mpq_clear(size);
}

static void test_binomial(void **state)
{
    (void)state;
    mpz_t b;
    mpq_t exact;
    mpz_init(b);
    mpq_init(exact);
    for (int n = 0; n <= 64; n++)
        for (int i = 0; i <= n; i++) {
            mpz_bin_uiui(b, (unsigned long)n, (unsigned long)i);
            mpq_set_z(exact, b);
            if (!is_near(binomial(n, i), exact, n <= 54 ? 0 : 20, exact))
                fail_msg("C(%d, %d)", n, i);
        }
    mpz_clear(b);
    mpq_clear(exact);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_value),      cmocka_unit_test(test_restrict), cmocka_unit_test(test_halve),
        cmocka_unit_test(test_derivative), cmocka_unit_test(test_elevate),  cmocka_unit_test(test_multiply),
        cmocka_unit_test(test_binomial),
    };
    return cmocka_run_group_tests_name("bernstein", tests, NULL, NULL);
}
