/* Seeded inputs for property tests, the same at every precision where it can hold them. */
#ifndef FATLINE_PROP_H
#define FATLINE_PROP_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" { /* cmocka.h does not say so itself */
#endif
#include <cmocka.h>
#ifdef __cplusplus
}
#endif

#include "../algorithms/bezier.h"
#include "../harness/cases/random.h"

/* k 2^(-bits) with k uniform in -2^bits..2^bits; bits <= 53. */
static inline real prop_dyadic(struct random_state *r, int bits)
{
    return real_ldexp((real)(double)random_between(r, -((int64_t)1 << bits), (int64_t)1 << bits), -bits);
}

/* k 2^(-bits) in [0, 1]; bits <= 53. */
static inline real prop_unit(struct random_state *r, int bits)
{
    return real_abs(prop_dyadic(r, bits));
}

/* All REAL_BITS of the significand random, either sign, 2^(e-1) <= |a| < 2^e; normal for this e. */
static inline real prop_bits(struct random_state *r, int e)
{
    real a = 1; /* the leading bit */
    int bits = 1;

    while (bits < REAL_BITS) {
        int more = REAL_BITS - bits < 32 ? REAL_BITS - bits : 32;
        a = real_ldexp(a, more) + (double)(random_bits(r) >> (64 - more));
        bits += more;
    }
    return real_ldexp(random_bits(r) & 1 ? a : -a, e - REAL_BITS);
}

/* A curve and its coefficients. */
struct prop_curve {
    struct curve curve;
    real x[DEGREE_MAX + 1], y[DEGREE_MAX + 1], w[DEGREE_MAX + 1];
};

/* Control points dyadic in [-1, 1]^2 over [0, 1]; weights, if rational, in [1/2, 2], homogeneous coordinates
 * rounded.  Not to be copied: `curve` points into it. */
static inline void prop_curve_make(struct prop_curve *c, struct random_state *r, int degree, int bits,
                                   bool rational)
{
    c->curve.degree = degree;
    c->curve.domain.lo = 0;
    c->curve.domain.hi = 1;
    c->curve.x = c->x;
    c->curve.y = c->y;
    c->curve.w = rational ? c->w : NULL;
    for (int i = 0; i <= degree; i++) {
        c->w[i] = rational ? (real)(1 + 3 * prop_unit(r, 10)) / 2 : (real)1;
        c->x[i] = c->w[i] * prop_dyadic(r, bits);
        c->y[i] = c->w[i] * prop_dyadic(r, bits);
    }
}

#endif
