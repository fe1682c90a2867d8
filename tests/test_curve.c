/* Points and derivatives of curves: the bounds that curve.h states, against exact arithmetic. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/curve.h"

enum { DEGREE = 32, ORDER = 8 };

/* Coordinates of one size or many, weights between 2^-10 and 2^10. */
static void make(struct random_state *r, int n, real *x, real *y, real *w)
{
    int spread = (int)random_between(r, 0, 10);
    nasty_coefficients(r, n, x);
    nasty_coefficients(r, n, y);
    for (int i = 0; i <= n; i++)
        w[i] = real_abs(prop_bits(r, (int)random_between(r, -spread, spread)));
}

/* max |x_i / w_i|; w == NULL: max |x_i|. */
static void extent(int n, const real *x, const real *w, mpq_t most)
{
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    for (int i = 0; i <= n; i++) {
        real_to_rational(x[i], a);
        if (w) {
            real_to_rational(w[i], b);
            mpq_div(a, a, b);
        }
        mpq_abs(a, a);
        if (i == 0 || mpq_cmp(a, most) > 0)
            mpq_set(most, a);
    }
    mpq_clears(a, b, NULL);
}

static void test_point(void **state)
{
    (void)state;
    mpq_t exact, weight, size, other;
    mpq_inits(exact, weight, size, other, NULL);
    for (int i = 0; i < trials(2000); i++) {
        struct random_state r = random_for(1, "point", (uint64_t)i);
        real x[DEGREE + 1], y[DEGREE + 1], weights[DEGREE + 1];
        int n = nasty_degree(&r, DEGREE);
        real t = nasty_unit(&r);
        make(&r, n, x, y, weights);
        const real *w = i % 2 ? weights : NULL;
        struct point p = curve_point(n, x, y, w, t);
        extent(n, x, w, size);
        extent(n, y, w, other);
        if (mpq_cmp(other, size) > 0)
            mpq_set(size, other);
        mpq_set_ui(weight, 1, 1);
        if (w)
            exact_value(n, w, t, weight);
        for (int k = 0; k < 2; k++) {
            exact_value(n, k ? y : x, t, exact);
            mpq_div(exact, exact, weight);
            if (!is_near(k ? p.y : p.x, exact, w ? 6 * n + 1 : 3 * n, size))
                fail_msg("point %d: degree %d, coordinate %d", i, n, k);
        }
    }
    mpq_clears(exact, weight, size, other, NULL);
}

/* ---- derivatives ---- */

/* Homogeneous derivatives at t, exactly, and what they may err by: 2^j n!/(n-j)! (3n + 2j) u max|c|. */
struct jet {
    mpq_t value[ORDER + 1], error[ORDER + 1];
};

static void jet_init(struct jet *j, int n, const real *c, real t)
{
    struct dyadics d, e;
    struct dyadic at;
    mpq_t size;
    long units = 1;
    dyadics_init(&d);
    dyadics_init(&e);
    dyadic_init(&at);
    mpq_init(size);
    rationals_init(ORDER + 1, j->value);
    rationals_init(ORDER + 1, j->error);
    dyadics_set(&d, n, c);
    dyadic_set(&at, t);
    exact_largest(n, c, size);
    for (int k = 0; k <= ORDER && k <= n; k++) {
        dyadics_copy(&e, &d);
        dyadics_value(&e, &at, j->value[k]);
        bound_add(j->error[k], units * (3 * n + 2 * k), size);
        for (int i = 0; i < d.n; i++) {
            mpz_sub(d.m[i], d.m[i + 1], d.m[i]);
            mpz_mul_si(d.m[i], d.m[i], d.n);
        }
        units = units * 2 * d.n--;
    }
    mpq_clear(size);
    dyadic_clear(&at);
    dyadics_clear(&d);
    dyadics_clear(&e);
}

static void jet_clear(struct jet *j)
{
    rationals_clear(ORDER + 1, j->value);
    rationals_clear(ORDER + 1, j->error);
}

/* x := x / w by the rule of Leibniz; errors follow: those of the terms, 2 u of every product, u of every sum
 * and of the quotient, over a weight that may be short of its own error. */
static void jet_divide(struct jet *x, const struct jet *w)
{
    mpq_t term, sum, least;
    mpz_t b;
    mpq_inits(term, sum, least, NULL);
    mpz_init(b);
    mpq_sub(least, w->value[0], w->error[0]);
    for (int k = 0; k <= ORDER; k++) {
        mpq_abs(sum, x->value[k]);
        for (int i = 1; i <= k; i++) {
            mpq_t binomial, other;
            mpq_inits(binomial, other, NULL);
            mpz_bin_uiui(b, (unsigned long)k, (unsigned long)i);
            mpq_set_z(binomial, b);
            mpq_mul(term, w->value[i], x->value[k - i]);
            mpq_mul(term, term, binomial);
            mpq_sub(x->value[k], x->value[k], term);
            mpq_abs(term, term);
            mpq_add(sum, sum, term);
            mpq_abs(other, w->value[i]);
            mpq_add(other, other, w->error[i]);
            mpq_mul(other, other, x->error[k - i]);
            mpq_abs(term, x->value[k - i]);
            mpq_mul(term, term, w->error[i]);
            mpq_add(term, term, other);
            mpq_mul(term, term, binomial);
            mpq_add(x->error[k], x->error[k], term);
            mpq_clears(binomial, other, NULL);
        }
        bound_add(x->error[k], k + 4, sum);
        mpq_div(x->value[k], x->value[k], w->value[0]);
        mpq_abs(term, x->value[k]);
        mpq_mul(term, term, w->error[0]);
        mpq_add(x->error[k], x->error[k], term);
        mpq_div(x->error[k], x->error[k], least);
    }
    mpq_clears(term, sum, least, NULL);
    mpz_clear(b);
}

static void test_derivatives(void **state)
{
    (void)state;
    for (int i = 0; i < trials(600); i++) {
        struct random_state r = random_for(1, "derivatives", (uint64_t)i);
        real x[DEGREE + 1], y[DEGREE + 1], w[DEGREE + 1];
        int n = nasty_degree(&r, DEGREE), order = (int)random_between(&r, 0, ORDER);
        real t = nasty_unit(&r);
        struct point p[ORDER + 1];
        struct jet jet, weight;
        make(&r, n, x, y, w);
        curve_derivatives(n, x, y, i % 2 ? w : NULL, t, order, p);
        jet_init(&weight, n, w, t);
        for (int k = 0; k < 2; k++) {
            jet_init(&jet, n, k ? y : x, t);
            if (i % 2)
                jet_divide(&jet, &weight);
            for (int j = 0; j <= order; j++)
                if (!is_within(k ? p[j].y : p[j].x, jet.value[j], jet.error[j]))
                    fail_msg("derivatives %d: degree %d, order %d", i, n, j);
            jet_clear(&jet);
        }
        jet_clear(&weight);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_point),
        cmocka_unit_test(test_derivatives),
    };
    return cmocka_run_group_tests_name("curve", tests, NULL, NULL);
}
