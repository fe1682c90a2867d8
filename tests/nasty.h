/* Inputs that look for trouble: coefficients of one size or of many, equal, zero, alternating; parameters at
 * the ends, next to them, and anywhere. */
#ifndef FATLINE_NASTY_H
#define FATLINE_NASTY_H

#include "prop.h"

/* How often a property is tried; divided by the cost of the precision. */
static inline int trials(int at_double)
{
    return REAL_BITS > 113 ? (at_double + 39) / 40 : REAL_BITS > 53 ? (at_double + 4) / 5 : at_double;
}

/* Degrees 1 to most, the small ones more often. */
static inline int nasty_degree(struct random_state *r, int most)
{
    int n = (int)random_between(r, 1, most);
    return random_bits(r) % 2 ? n : (int)random_between(r, 1, n);
}

enum { NASTY_KINDS = 6 };

/* c[0..n]; sizes between 2^-200 and 2^200, so that no product of three of them leaves the range of double. */
static inline void nasty_coefficients(struct random_state *r, int n, real *c)
{
    int kind = (int)(random_bits(r) % NASTY_KINDS), size = (int)random_between(r, -200, 200);
    real same = prop_bits(r, size);
    for (int i = 0; i <= n; i++) {
        int spread = (int)random_between(r, -60, 0);
        c[i] = kind == 0   ? prop_dyadic(r, 20)
               : kind == 1 ? prop_bits(r, size)
               : kind == 2 ? prop_bits(r, (int)random_between(r, -200, 200))
               : kind == 3 ? same
               : kind == 4 ? (i % 2 ? -same : same)
                           : prop_bits(r, spread);
        if (kind == 5 && random_bits(r) % 3 == 0)
            c[i] = i > 0 && random_bits(r) % 2 ? c[i - 1] : (real)0;
    }
}

/* In [0, 1]. */
static inline real nasty_unit(struct random_state *r)
{
    switch (random_bits(r) % 6) {
    case 0:
        return random_bits(r) % 2 ? 0 : 1;
    case 1:
        return real_ldexp(1, -(int)random_between(r, 1, REAL_BITS));
    case 2:
        return 1 - real_ldexp(1, -(int)random_between(r, 1, REAL_BITS));
    case 3:
        return prop_unit(r, 4);
    case 4:
        return real_abs(prop_bits(r, -(int)random_between(r, 0, 40)));
    default:
        return real_abs(prop_bits(r, 0));
    }
}

/* 0 <= lo <= hi <= 1: any, wide, narrow, a single number. */
static inline struct interval nasty_interval(struct random_state *r)
{
    real a = nasty_unit(r), b = nasty_unit(r);
    if (random_bits(r) % 3 == 0) {
        real width = real_ldexp(prop_unit(r, 10), -(int)random_between(r, 0, REAL_BITS));
        b = a + width <= 1 ? a + width : (real)1;
    }
    struct interval i = {real_min(a, b), real_max(a, b)};
    return i;
}

#endif
