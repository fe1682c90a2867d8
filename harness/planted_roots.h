/* Polynomials with a known root, for the measurement of root finders.  Compiled for each precision. */
#ifndef FATLINE_PLANTED_ROOTS_H
#define FATLINE_PLANTED_ROOTS_H

#include "../algorithms/core/real.h"

enum { PLANTED_DEGREE_MAX = 32 };

/* SIMPLE, DOUBLE, TRIPLE: 1/3 so many times; CLOSE: 1/3 and 1/3 + 2^-gap.  All other roots are real and
 * outside of [0, 1]. */
enum planted_kind { SIMPLE_ROOT, DOUBLE_ROOT, TRIPLE_ROOT, CLOSE_ROOTS, PLANTED_KINDS };

const char *planted_kind_name(enum planted_kind);
int planted_kind_roots(enum planted_kind); /* with multiplicity, in [0, 1] */

/* Bernstein coefficients c[0..n], the exact ones rounded once, with error[i] = eps |c[i]|, of the polynomial
 *     (its roots in [0, 1]) (t + 1) (2 - t) (t + 3) (4 - t) ...
 * of degree n >= planted_kind_roots(kind), n <= PLANTED_DEGREE_MAX. */
void planted_roots_make(enum planted_kind kind, int n, int gap, real *c, real *error);

#endif
