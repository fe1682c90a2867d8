/* Polynomials in Bernstein form, sum of c[i] B(i,n)(t) on [0, 1], and curves of several components.
 *
 * u stands for the unit round-off REAL_EPSILON / 2; |c| for the polynomial with coefficients |c[i]|.  Bounds
 * are first-order in u; with n <= 32 the neglected factor is below 1 + 400 u. */
#ifndef FATLINE_BERNSTEIN_H
#define FATLINE_BERNSTEIN_H

#include "real.h"

/* Value at t in [0, 1] by de Casteljau; error at most 3n u |c|(t). */
real bernstein_value(int n, const real *c, real t);

/* Value and first derivative at t; c is left alone, scratch holds n + 1.  Errors at most 3n u |c|(t) and
 * 2n (3n + 1) u max|c|. */
real bernstein_value_slope(int n, const real *c, real t, real *scratch, real *slope);

/* Coefficients over [lo, hi], 0 <= lo <= hi <= 1, of `components` polynomials stored one after the other; out
 * may not overlap c.  Coefficient i is the blossom of c at (lo^(n-i), hi^i), and the error is at most 8n u
 * times the blossom of |c|: the weights hi, 1 - hi, lo/hi, (hi - lo)/hi are not negative and have relative
 * error at most 2u, and each of the 2n steps adds a product and a sum.  By induction over the steps: a mean,
 * by exact weights, of two numbers that err by at most k u of their blossoms errs by no more; the step itself
 * adds 3u where the weights are 1 - hi and hi, 4u where they are quotients (tests/proofs/restrict_weights.g,
 * restrict_steps.g: 3.5u and 4.5u with the higher orders), 7n u to first order. */
void bernstein_restrict(int n, int components, const real *c, real lo, real hi, real *out);

/* Coefficients over [0, 1/2] and [1/2, 1]; left and right may not overlap c.  Error at most n u blossom of
 * |c|: by induction over the n levels, a mean of two numbers that err by at most k u of their blossoms errs
 * by no more, its sum adds u, and halving is exact (tests/proofs/halve_quadratic.g). */
void bernstein_halve(int n, int components, const real *c, real *left, real *right);

/* Coefficients of the derivative, n of them: n (c[i+1] - c[i]); error at most 2 u of the result + n u (|c[i]|
 * + |c[i+1]|) from the inputs' own rounding. */
void bernstein_derivative(int n, const real *c, real *out);

/* The same polynomial in degree n + r, out[0..n+r]; in place is allowed.  Error at most 4 r u max|c|. */
void bernstein_elevate(int n, const real *c, int r, real *out);

/* Product of degree n + m, out[0..n+m], not overlapping a or b.  Error at most (n + m + 6) u |a||b|,
 * coefficient by coefficient: the weights C(n,i) C(m,j) / C(n+m,i+j) are positive and sum to 1. */
void bernstein_multiply(int n, const real *a, int m, const real *b, real *out);

/* C(n, i) for 0 <= i <= n <= 64, exact in every precision when n <= 54; above, in double, relative error at
 * most 20 u (the last ten products exceed 2^53). */
real binomial(int n, int i);

#endif
