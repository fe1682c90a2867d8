/* Numbers of twice the digits: unevaluated sums hi + lo with |lo| <= u |hi|, u = REAL_EPSILON / 2.
 *
 * From the exact sum and product of two reals (O. Moller 1965, D. Knuth 1969; T. Dekker 1971), which hold for
 * every binary arithmetic rounded to nearest, barring underflow and overflow.  Bounds of the operations: M.
 * Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word
 * arithmetic, 2017. */
#ifndef FATLINE_TWOFOLD_H
#define FATLINE_TWOFOLD_H

#include "real.h"

struct twofold {
    real hi, lo;
};

static inline struct twofold twofold_of(real a)
{
    struct twofold t = {a, 0};
    return t;
}

/* a + b exactly, |a| >= |b| or a = 0. */
static inline struct twofold quick_sum(real a, real b)
{
    struct twofold t;
    t.hi = a + b;
    t.lo = b - (t.hi - a);
    return t;
}

/* a + b exactly. */
static inline struct twofold exact_sum(real a, real b)
{
    struct twofold t;
    t.hi = a + b;
    real part = t.hi - a;
    t.lo = (a - (t.hi - part)) + (b - part);
    return t;
}

/* a b exactly. */
static inline struct twofold exact_product(real a, real b)
{
    const real splitter = real_ldexp(1, (REAL_BITS + 1) / 2) + 1;
    real p = splitter * a, q = splitter * b;
    real a1 = p - (p - a), b1 = q - (q - b), a2 = a - a1, b2 = b - b1;
    struct twofold t;
    t.hi = a * b;
    t.lo = ((a1 * b1 - t.hi) + a1 * b2 + a2 * b1) + a2 * b2;
    return t;
}

/* Relative error 3 u^2 (+ 13 u^3). */
static inline struct twofold twofold_add(struct twofold a, struct twofold b)
{
    struct twofold s = exact_sum(a.hi, b.hi), e = exact_sum(a.lo, b.lo);
    struct twofold v = quick_sum(s.hi, s.lo + e.hi);
    return quick_sum(v.hi, e.lo + v.lo);
}

static inline struct twofold twofold_negate(struct twofold a)
{
    a.hi = -a.hi;
    a.lo = -a.lo;
    return a;
}

/* Relative error 7 u^2. */
static inline struct twofold twofold_multiply(struct twofold a, struct twofold b)
{
    struct twofold p = exact_product(a.hi, b.hi);
    return quick_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* Relative error 15 u^2. */
static inline struct twofold twofold_divide(struct twofold a, struct twofold b)
{
    real q = a.hi / b.hi;
    struct twofold rest = twofold_add(a, twofold_negate(twofold_multiply(b, twofold_of(q))));
    return quick_sum(q, rest.hi / b.hi);
}

#endif
