/* Points, derivatives and norms of curves given by homogeneous Bernstein coefficients on [0, 1].
 *
 * x[i] = w_i X_i, y[i] = w_i Y_i, i = 0..n; w == NULL means all weights 1.  S = max |X_i|, |Y_i|;
 * u = REAL_EPSILON / 2; bounds are first-order in u. */
#ifndef FATLINE_CURVE_H
#define FATLINE_CURVE_H

#include "real.h"

struct point {
    real x, y;
};

/* Where the curve is at t in [0, 1]; each coordinate errs by at most (6n + 1) u S (3n u S if polynomial). */
struct point curve_point(int n, const real *x, const real *y, const real *w, real t);

/* Derivatives of order 0..order at t, out[0..order].  The homogeneous derivatives err by at most
 * 2^j n!/(n-j)! (3n + 2j) u max|coefficient|; a rational curve's follow by the rule of Leibniz,
 * P^(j) = (X^(j) - sum over i >= 1 of C(j,i) w^(i) P^(j-i)) / w.  order <= 8. */
void curve_derivatives(int n, const real *x, const real *y, const real *w, real t, int order,
                       struct point *out);

/* The paper's three norms of a polynomial curve, on any interval of the parameter (they do not change under
 * affine maps of it).
 * L2, normalised by the length of the interval: sqrt of sum a_i a_j C(n,i) C(n,j) / ((2n+1) C(2n,i+j)), exact
 * but for rounding: relative error at most (n^2 + 12 n + 12) u where no cancellation occurs, in general
 * absolute error of the square at most (n^2 + 12 n + 12) u max|a_i|^2. */
real norm_l2(int n, const real *x, const real *y);
/* Enclosure of max |f(t)|: lo <= max <= hi (1 + 16 n u), narrowed by `levels` halvings where the control
 * points still rise above the best point found; hi - lo falls like 4^-levels.  levels <= 16. */
struct norm_enclosure {
    real lo, hi;
};
struct norm_enclosure norm_infinity(int n, const real *x, const real *y, int levels);
/* max |a_i|, an upper bound of both; relative error at most 2 u. */
real norm_bb(int n, const real *x, const real *y);

#endif
