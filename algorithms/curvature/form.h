/* Bernstein forms multiplied through by their binomials: sum of c[i] t^i (1 - t)^(n - i).
 *
 * Products are then plain convolutions and factors of t and 1 - t are plain shifts. */
#ifndef FATLINE_FORM_H
#define FATLINE_FORM_H

#include <stddef.h>

#include "../core/real.h"

/* Pascal's triangle, row after row; exact up to row 56 in doubles, relative error below 32 u beyond. */
size_t pascal_size(int rows);
void pascal_fill(int rows, real *pascal);
static inline const real *pascal_row(const real *pascal, int n)
{
    return pascal + (size_t)n * (size_t)(n + 1) / 2;
}

/* out[i] = c[i] C(n, i), and back; in place is allowed. */
void form_scale(int n, const real *pascal, const real *c, real *out);
void form_unscale(int n, const real *pascal, const real *c, real *out);

/* sum += factor a b, of degree n + m; all scaled. */
void form_add_product(int n, const real *a, int m, const real *b, int factor, real *sum);

void form_clear(int n, real *c);

/* Values at t in [0, 1] of `components` unscaled forms of degree n <= 96, one after the other, and of their
 * derivatives, as sums over the Bernstein polynomials; errors at most (4n + 8) REAL_EPSILON |c|(t), of
 * the derivative n times as much for its own coefficients. */
void form_values(int n, int components, const real *pascal, const real *c, real t, real *out);
void form_values_slopes(int n, int components, const real *pascal, const real *c, real t, real *value,
                        real *slope);
real form_value_slope(int n, const real *pascal, const real *c, real t, real *slope);

#endif
