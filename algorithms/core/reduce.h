/* Best approximation of degree k in the L2 norm, by its constant matrix. */
#ifndef FATLINE_REDUCE_H
#define FATLINE_REDUCE_H

#include <stddef.h>

#include "real.h"

enum { REDUCED_MAX = 5 }; /* largest k */

/* reduce: (k + 1) x (n + 1), row by row, Bernstein coefficients of degree n to those of the best
 * approximation of degree k < n on any interval; elevate: (n + 1) x (k + 1), back to degree n.  Entries are
 * quotients of integers, each rounded once. */
struct reduction {
    int n, k;
    const real *reduce, *elevate;
};

size_t reduction_length(int n, int k); /* numbers of memory: 2 (n + 1)(k + 1), 0 if k >= n */

/* 1 <= n <= 32, 1 <= k <= REDUCED_MAX; for k >= n the reduction is the identity (r->k = n) and takes no
 * memory. */
void reduction_init(struct reduction *r, int n, int k, real *memory);

/* Reduces `components` polynomials stored one after the other, n + 1 coefficients each; out[c * (r->k + 1) +
 * i]. Any rounding makes it another approximation, no less valid: see reduction_residual. */
void reduction_apply(const struct reduction *r, int components, const real *c, real *out);

/* residual = c - q elevated, stored like c; returns a bound of the rounding of each entry:
 * (k + 4) u max|q| + u max|residual|.  So |c(t) - q(t)| <= max |residual| + bound for t in [0, 1]. */
real reduction_residual(const struct reduction *r, int components, const real *c, const real *q,
                        real *residual);

#endif
