/* Where a polynomial can vanish, by its best approximation of low degree. */
#ifndef FATLINE_ZEROS_H
#define FATLINE_ZEROS_H

#include "interval.h"
#include "reduce.h"

enum { ZEROS_PIECES_MAX = 4, ZEROS_DEGREE_MAX = 32 };

/* Every zero in [0, 1] of a polynomial whose Bernstein coefficients are all within `error` of c[0..r->n] lies
 * in one of the disjoint intervals of out, in order; returns their number.  The polynomial is within max
 * |residual| of its approximation q, so it vanishes only where |q| is no more than that and the error: q's
 * degree is 1 to 5. */
int zeros_by_reduction(const struct reduction *r, const real *c, real error,
                       struct interval out[ZEROS_PIECES_MAX]);

#endif
