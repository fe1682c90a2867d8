/* Exact arithmetic to judge rounded one: polynomials with dyadic Bernstein coefficients, which all reals are,
 * and errors as rationals in units of u = REAL_EPSILON / 2. */
#ifndef FATLINE_DYADIC_H
#define FATLINE_DYADIC_H

#include <gmp.h>

#include "prop.h"
#include "../harness/cases/number.h"

enum { DYADICS_MAX = 66 };

/* m[0..n] 2^e. */
struct dyadics {
    int n;
    long e;
    mpz_t m[DYADICS_MAX];
};

/* m 2^-bits. */
struct dyadic {
    mpz_t m;
    mp_bitcnt_t bits;
};

static inline void dyadics_init(struct dyadics *d)
{
    d->n = 0;
    d->e = 0;
    for (int i = 0; i < DYADICS_MAX; i++)
        mpz_init(d->m[i]);
}

static inline void dyadics_clear(struct dyadics *d)
{
    for (int i = 0; i < DYADICS_MAX; i++)
        mpz_clear(d->m[i]);
}

static inline void dyadics_copy(struct dyadics *to, const struct dyadics *from)
{
    to->n = from->n;
    to->e = from->e;
    for (int i = 0; i <= from->n; i++)
        mpz_set(to->m[i], from->m[i]);
}

static inline void dyadic_init(struct dyadic *t)
{
    mpz_init(t->m);
    t->bits = 0;
}

static inline void dyadic_clear(struct dyadic *t)
{
    mpz_clear(t->m);
}

static inline void dyadic_set(struct dyadic *t, real a)
{
    mpq_t q;
    mpq_init(q);
    real_to_rational(a, q);
    mpz_set(t->m, mpq_numref(q));
    t->bits = mpz_scan1(mpq_denref(q), 0);
    mpq_clear(q);
}

/* The reals c[0..n], exactly. */
static inline void dyadics_set(struct dyadics *d, int n, const real *c)
{
    struct dyadic a[DYADICS_MAX];
    mp_bitcnt_t most = 0;
    for (int i = 0; i <= n; i++) {
        dyadic_init(&a[i]);
        dyadic_set(&a[i], c[i]);
        most = a[i].bits > most ? a[i].bits : most;
    }
    d->n = n;
    d->e = -(long)most;
    for (int i = 0; i <= n; i++) {
        mpz_mul_2exp(d->m[i], a[i].m, most - a[i].bits);
        dyadic_clear(&a[i]);
    }
}

static inline void dyadics_abs(struct dyadics *d)
{
    for (int i = 0; i <= d->n; i++)
        mpz_abs(d->m[i], d->m[i]);
}

/* One step of de Casteljau at t: the degree falls by one. */
static inline void dyadics_step(struct dyadics *d, const struct dyadic *t)
{
    mpz_t rest;
    mpz_init(rest);
    mpz_setbit(rest, t->bits);
    mpz_sub(rest, rest, t->m);
    for (int i = 0; i < d->n; i++) {
        mpz_mul(d->m[i], d->m[i], rest);
        mpz_addmul(d->m[i], d->m[i + 1], t->m);
    }
    d->n--;
    d->e -= (long)t->bits;
    mpz_clear(rest);
}

static inline void dyadics_get(const struct dyadics *d, int i, mpq_t out)
{
    mpq_set_z(out, d->m[i]);
    number_scale(out, d->e);
}

/* Value of d at t; d is spent. */
static inline void dyadics_value(struct dyadics *d, const struct dyadic *t, mpq_t out)
{
    while (d->n > 0)
        dyadics_step(d, t);
    dyadics_get(d, 0, out);
}

/* Value at t of the polynomial with coefficients c[0..n]. */
static inline void exact_value(int n, const real *c, real t, mpq_t out)
{
    struct dyadics d;
    struct dyadic at;
    dyadics_init(&d);
    dyadic_init(&at);
    dyadics_set(&d, n, c);
    dyadic_set(&at, t);
    dyadics_value(&d, &at, out);
    dyadic_clear(&at);
    dyadics_clear(&d);
}

/* Coefficients of d over [lo, hi]: out[i] is the blossom at (lo^(n-i), hi^i).  d is spent. */
static inline void exact_restrict(struct dyadics *d, real lo, real hi, mpq_t *out)
{
    struct dyadics e;
    struct dyadic a, b;
    dyadics_init(&e);
    dyadic_init(&a);
    dyadic_init(&b);
    dyadic_set(&a, lo);
    dyadic_set(&b, hi);
    for (int i = d->n; i >= 0; i--) {
        dyadics_copy(&e, d);
        dyadics_value(&e, &b, out[i]);
        if (i > 0)
            dyadics_step(d, &a);
    }
    dyadic_clear(&a);
    dyadic_clear(&b);
    dyadics_clear(&e);
}

static inline void rationals_init(int count, mpq_t *q)
{
    for (int i = 0; i < count; i++)
        mpq_init(q[i]);
}

static inline void rationals_clear(int count, mpq_t *q)
{
    for (int i = 0; i < count; i++)
        mpq_clear(q[i]);
}

/* bound += units u |size|, with u = 2^-REAL_BITS. */
static inline void bound_add(mpq_t bound, long units, const mpq_t size)
{
    mpq_t term;
    mpq_init(term);
    mpq_set_si(term, units, 1);
    mpq_mul(term, term, size);
    mpq_abs(term, term);
    mpq_div_2exp(term, term, REAL_BITS);
    mpq_add(bound, bound, term);
    mpq_clear(term);
}

/* |computed - exact| <= bound (1 + 400 u)?  The bounds of the headers are of first order in u. */
static inline bool is_within(real computed, const mpq_t exact, const mpq_t bound)
{
    mpq_t error, most;
    mpq_init(error);
    mpq_init(most);
    real_to_rational(computed, error);
    mpq_sub(error, error, exact);
    mpq_abs(error, error);
    mpq_set(most, bound);
    bound_add(most, 400, bound);
    bool within = mpq_cmp(error, most) <= 0;
    mpq_clear(error);
    mpq_clear(most);
    return within;
}

/* |computed - exact| <= units u |size|, to first order? */
static inline bool is_near(real computed, const mpq_t exact, long units, const mpq_t size)
{
    mpq_t bound;
    mpq_init(bound);
    bound_add(bound, units, size);
    bool near = is_within(computed, exact, bound);
    mpq_clear(bound);
    return near;
}

/* max |c[i]|, i = 0..n. */
static inline void exact_largest(int n, const real *c, mpq_t out)
{
    real most = 0;
    for (int i = 0; i <= n; i++)
        most = real_max(most, real_abs(c[i]));
    real_to_rational(most, out);
}

#endif
