#include "planted_roots.h"

#include <gmp.h>

#include "number.h"

const char *planted_kind_name(enum planted_kind kind)
{
    static const char *const names[] = {"simple", "double", "triple", "close"};
    return names[kind];
}

int planted_kind_roots(enum planted_kind kind)
{
    static const int roots[] = {1, 2, 3, 2};
    return roots[kind];
}

/* Multiplies p, of degree n in scaled Bernstein form (sum of p[i] t^i (1-t)^(n-i)), by the linear polynomial
 * with the values a at 0 and b at 1. */
static void multiply(int n, mpq_t *p, const mpq_t a, const mpq_t b)
{
    mpq_t term;
    mpq_init(term);
    mpq_mul(p[n + 1], p[n], b);
    for (int i = n; i > 0; i--) {
        mpq_mul(p[i], p[i], a);
        mpq_mul(term, p[i - 1], b);
        mpq_add(p[i], p[i], term);
    }
    mpq_mul(p[0], p[0], a);
    mpq_clear(term);
}

/* t - (1/3 + shift). */
static void multiply_root(int n, mpq_t *p, const mpq_t shift)
{
    mpq_t a, b;
    mpq_init(a);
    mpq_init(b);
    mpq_set_si(a, -1, 3);
    mpq_sub(a, a, shift);
    mpq_set_si(b, 1, 1);
    mpq_add(b, b, a);
    multiply(n, p, a, b);
    mpq_clear(a);
    mpq_clear(b);
}

/* The i-th factor without a root in [0, 1], i = 1, 2, ...: t + i or i - t. */
static void multiply_outside(int n, mpq_t *p, int i)
{
    mpq_t a, b;
    mpq_init(a);
    mpq_init(b);
    mpq_set_si(a, i, 1);
    mpq_set_si(b, i % 2 ? i + 1 : i - 1, 1);
    multiply(n, p, a, b);
    mpq_clear(a);
    mpq_clear(b);
}

void planted_roots_make(enum planted_kind kind, int n, int gap, real *c, real *error)
{
    mpq_t p[PLANTED_DEGREE_MAX + 1], shift, divisor;
    int degree = 0;
    for (int i = 0; i <= n; i++)
        mpq_init(p[i]);
    mpq_init(shift);
    mpq_init(divisor);
    mpq_set_si(p[0], 1, 1);
    while (degree < planted_kind_roots(kind)) {
        if (kind == CLOSE_ROOTS && degree == 1) {
            mpq_set_si(shift, 1, 1);
            number_scale(shift, -gap);
        }
        multiply_root(degree, p, shift);
        degree++;
    }
    for (int i = 1; degree < n; i++)
        multiply_outside(degree++, p, i);
    for (int i = 0; i <= n; i++) {
        mpz_bin_uiui(mpq_numref(divisor), (unsigned long)n, (unsigned long)i);
        mpq_div(p[i], p[i], divisor);
        c[i] = real_from_rational(p[i]);
        error[i] = REAL_EPSILON * real_abs(c[i]);
        mpq_clear(p[i]);
    }
    mpq_clear(shift);
    mpq_clear(divisor);
}
