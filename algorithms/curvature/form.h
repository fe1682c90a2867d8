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

/* Values at t of `components` unscaled forms of degree n, one after the other, by de Casteljau; n <= 96. */
void form_values(int n, int components, const real *c, real t, real *out);

#endif
