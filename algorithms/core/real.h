/* The number type of this build: IEEE double, IEEE binary128, or 2,048 bits over MPFR.
 *
 * One text serves all three, so it keeps to the common part of C11 and C++20 (CONTRIBUTING.md, "The number
 * type").  Rounding is to nearest everywhere; |fl(a op b) - (a op b)| <= (REAL_EPSILON / 2) |a op b| for + -
 * * / and real_sqrt, barring underflow: a result below REAL_LEAST errs by up to (REAL_EPSILON / 2)
 * REAL_LEAST. */
#ifndef FATLINE_REAL_H
#define FATLINE_REAL_H

#if defined(FATLINE_MULTI)

#include "real_multi.hpp"
#define REAL_NAME "multi"
#define REAL_BITS 2048

#elif defined(FATLINE_QUAD)

/* Only + - * / and comparison are compiled in.  The square root is glibc's, which is rounded to nearest;
 * libquadmath's is off by one in the last place for one number in four. */
#include <quadmath.h>
#include <float.h>
typedef __float128 real;
#define REAL_NAME "quad"
#define REAL_BITS 113
#define REAL_EPSILON FLT128_EPSILON
#define REAL_HUGE FLT128_MAX
#define REAL_LEAST FLT128_MIN

static inline real real_abs(real a)
{
    return __builtin_fabsf128(a);
}
static inline real real_sqrt(real a)
{
    return __builtin_sqrtf128(a);
}
static inline real real_ldexp(real a, int e)
{
    return ldexpq(a, e);
}
/* e with 2^(e-1) <= |a| < 2^e; a is finite and not 0. */
static inline int real_exponent(real a)
{
    int e;
    frexpq(a, &e);
    return e;
}
static inline int real_is_finite(real a)
{
    return finiteq(a);
}
static inline double real_to_double(real a)
{
    return (double)a;
}

#else

#include <float.h>
#include <math.h>
typedef double real;
#define REAL_NAME "double"
#define REAL_BITS 53
#define REAL_EPSILON DBL_EPSILON
#define REAL_HUGE DBL_MAX
#define REAL_LEAST DBL_MIN

static inline real real_abs(real a)
{
    return fabs(a);
}
static inline real real_sqrt(real a)
{
    return sqrt(a);
}
static inline real real_ldexp(real a, int e)
{
    return ldexp(a, e);
}
/* e with 2^(e-1) <= |a| < 2^e; a is finite and not 0. */
static inline int real_exponent(real a)
{
    int e;
    frexp(a, &e);
    return e;
}
static inline int real_is_finite(real a)
{
    return isfinite(a);
}
static inline double real_to_double(real a)
{
    return a;
}

#endif

static inline real real_min(real a, real b)
{
    return a < b ? a : b;
}
static inline real real_max(real a, real b)
{
    return a > b ? a : b;
}

#endif
