/* Pairs of curves with a known solution: f(t) = g(s) exactly, checked in rational arithmetic. */
#ifndef FATLINE_PLANTED_H
#define FATLINE_PLANTED_H

#include <string.h>

#include "dyadic.h"

/* t and s are local parameters, in [0, 1]; the domains may be others.  Not to be copied. */
struct planted {
    struct prop_curve f, g;
    real t, s;
};

static inline void prop_curve_copy(struct prop_curve *to, const struct prop_curve *from)
{
    *to = *from;
    to->curve.x = to->x;
    to->curve.y = to->y;
    to->curve.w = from->curve.w ? to->w : NULL;
}

static inline void planted_copy(struct planted *to, const struct planted *from)
{
    prop_curve_copy(&to->f, &from->f);
    prop_curve_copy(&to->g, &from->g);
    to->t = from->t;
    to->s = from->s;
}

/* Homogeneous point of c at local t; the weight of a polynomial curve is 1. */
static inline void exact_point(const struct curve *c, real t, mpq_t out[3])
{
    exact_value(c->degree, c->x, t, out[0]);
    exact_value(c->degree, c->y, t, out[1]);
    mpq_set_ui(out[2], 1, 1);
    if (c->w)
        exact_value(c->degree, c->w, t, out[2]);
}

/* Is f(t) = g(s)? */
static inline bool is_planted(const struct planted *p)
{
    mpq_t a[3], b[3], first, second;
    bool same = true;
    rationals_init(3, a);
    rationals_init(3, b);
    mpq_init(first);
    mpq_init(second);
    exact_point(&p->f.curve, p->t, a);
    exact_point(&p->g.curve, p->s, b);
    for (int k = 0; k < 2; k++) {
        mpq_mul(first, a[k], b[2]);
        mpq_mul(second, b[k], a[2]);
        same = same && mpq_equal(first, second);
    }
    rationals_clear(3, a);
    rationals_clear(3, b);
    mpq_clear(first);
    mpq_clear(second);
    return same;
}

/* Moves the polynomial curve g by f(t) - g(s). */
static inline void plant_by_moving(struct planted *p)
{
    mpq_t a[3], b[3];
    rationals_init(3, a);
    rationals_init(3, b);
    exact_point(&p->f.curve, p->t, a);
    exact_point(&p->g.curve, p->s, b);
    for (int k = 0; k < 2; k++) {
        mpq_sub(a[k], a[k], b[k]);
        real move = real_from_rational(a[k]), *c = k ? p->g.y : p->g.x;
        for (int i = 0; i <= p->g.curve.degree; i++)
            c[i] = c[i] + move;
    }
    rationals_clear(3, a);
    rationals_clear(3, b);
}

/* Changes control point j of the rational curve g, and the scale of the others, so that its homogeneous point
 * at s is that of f at t, times a number.  With s = a / 2^q the other coefficients are multiplied by
 * B(j,m)(s) 2^(q m), an integer. */
static inline void plant_by_control_point(struct planted *p, int a, int q)
{
    int m = p->g.curve.degree, j = (a * m + (1 << (q - 1))) >> q;
    mpq_t h[3], value[3], factor;
    mpz_t binomial;
    rationals_init(3, h);
    rationals_init(3, value);
    mpq_init(factor);
    mpz_init(binomial);
    mpz_bin_uiui(binomial, (unsigned long)m, (unsigned long)j);
    mpq_set_z(factor, binomial);
    for (int i = 0; i < m; i++)
        mpz_mul_si(mpq_numref(factor), mpq_numref(factor), i < j ? a : (1 << q) - a);
    exact_point(&p->f.curve, p->t, h);
    real *c[3] = {p->g.x, p->g.y, p->g.w}, times = real_from_rational(factor);
    for (int k = 0; k < 3; k++) {
        c[k][j] = 0;
        exact_value(m, c[k], p->s, value[k]);
        mpq_sub(h[k], h[k], value[k]);
        for (int i = 0; i <= m; i++)
            c[k][i] = c[k][i] * times;
        c[k][j] = real_ldexp(real_from_rational(h[k]), q * m);
    }
    rationals_clear(3, h);
    rationals_clear(3, value);
    mpq_clear(factor);
    mpz_clear(binomial);
}

/* Weights positive, control points in [-8, 8]^2? */
static inline bool is_tame(const struct prop_curve *c)
{
    bool tame = true;
    for (int i = 0; i <= c->curve.degree; i++)
        tame = tame && c->w[i] > 0 && real_abs(c->x[i]) <= 8 * c->w[i] && real_abs(c->y[i]) <= 8 * c->w[i];
    return tame;
}

/* Degrees n, m; dyadic control points.  rational: 0 none, 1 g only, 2 both.  Tries until all is exact. */
static inline void planted_make(struct planted *p, struct random_state *r, int n, int m, int rational)
{
    int most = n > m ? n : m, bits = rational ? 8 : most <= 8 ? 20 : 52 - 2 * most > 20 ? 20 : 16;
    do {
        int q = most > 15 ? 1 : rational || most > 8 ? 2 : 3;
        int a = (int)random_between(r, 0, 1 << q), b = (int)random_between(r, 0, 1 << q);
        prop_curve_make(&p->f, r, n, bits, rational == 2);
        prop_curve_make(&p->g, r, m, bits, rational > 0);
        p->t = real_ldexp(b, -q);
        p->s = real_ldexp(a, -q);
        if (rational)
            plant_by_control_point(p, a, q);
        else
            plant_by_moving(p);
    } while (!is_tame(&p->g) || !is_planted(p));
}

/* Other domains for both, some of them such that the map from [0, 1] is not exact. */
static inline void planted_domains(struct planted *p, struct random_state *r)
{
    static const double domain[][2] = {{0, 1},     {-3, 5},     {1, 1.5},       {-0x1p-20, 0x1p-20},
                                       {0.1, 0.7}, {-0.9, 1.1}, {1000, 1000.3}, {-1e-9, 3}};
    struct curve *both[2] = {&p->f.curve, &p->g.curve};
    for (int k = 0; k < 2; k++) {
        const double *d = domain[random_bits(r) % (sizeof domain / sizeof *domain)];
        both[k]->domain.lo = d[0];
        both[k]->domain.hi = d[1];
    }
}

/* lo + (hi - lo) t. */
static inline void exact_parameter(const struct interval *domain, real t, mpq_t out)
{
    mpq_t a;
    mpq_init(a);
    real_to_rational(domain->lo, a);
    real_to_rational(domain->hi, out);
    mpq_sub(out, out, a);
    mpq_t b;
    mpq_init(b);
    real_to_rational(t, b);
    mpq_mul(out, out, b);
    mpq_add(out, out, a);
    mpq_clear(a);
    mpq_clear(b);
}

#endif
