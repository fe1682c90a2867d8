/* Polynomial models: a function on [-1, 1] as a polynomial of degree k <= 5 in powers of u, and a bound of
 * the rest.
 *
 * Local parameters t in [0, 1] are u = 2t - 1.  u_0 stands for the unit round-off REAL_EPSILON / 2; bounds
 * are first-order in it, and doubled, or enlarged by 1/64, to cover the rounding of the bounds themselves.
 * (K. Makino, M. Berz, Taylor models and other validated functional inclusion methods, 2003.) */
#ifndef FATLINE_MODEL_H
#define FATLINE_MODEL_H

#include "real.h"

enum { MODEL_MAX = 5 };

/* All functions with |function - sum of c[j] u^j| <= rest on [-1, 1]. */
struct model {
    int k;
    real c[MODEL_MAX + 1];
    real rest;
};

/* The polynomial of degree n <= k with Bernstein coefficients b[0..n] on [0, 1], each within `off` of the
 * true one.
 */
void model_of_bernstein(int n, const real *b, real off, int k, struct model *out);

/* Sum of |c[j]| r^j: bounds the polynomial for |u| <= r. */
real model_size(const struct model *m, real r);

real model_value(const struct model *m, real u, real *slope);

/* Bernstein coefficients, of degree k, of the polynomial on [-r, r]; returns a bound of their rounding,
 * (2k + 4) u_0 model_size(m, r): powers and products j + 1, binomials 1, the sum k. */
real model_to_bernstein(const struct model *m, real r, real *b);

/* The polynomial about another point, p(at + v) in powers of v; the rest is left as it is.  For |v| <= r it
 * errs by at most 2k u_0 model_size(m, |at| + r). */
void model_shift(struct model *m, real at);

/* p(q(u)) for polynomials p, q of the same degree, q(0) = 0: coefficients up to degree k; the rest bounds
 * what was dropped and all rounding (the rests of p and q do not enter). */
void model_compose(const struct model *p, const struct model *q, struct model *out);

#endif
