/* An arc in an affine frame, replaced by polynomials of degree k, with bounds of the difference and of its
 * slope. */
#ifndef FATLINE_NEARBY_H
#define FATLINE_NEARBY_H

#include "arc.h"
#include "reduce.h"

enum { NEARBY_DEGREE_MAX = REDUCED_MAX };

/* Coordinate j of the point (x, y) is row[j][0] (x - x0) + row[j][1] (y - y0); norm[j] = |row[j][0]| +
 * |row[j][1]|. |x0|, |y0| <= scale, which bounds the coordinates of all arcs in it. */
struct frame {
    real x0, y0, row[2][2], norm[2], scale;
};

void frame_set_norms(struct frame *f);

/* c[j][0..degree]: Bernstein coefficients of coordinate j on [0, 1].  The true coordinate is within off[j] of
 * this polynomial, its derivative within slope_off[j] of the derivative. */
struct nearby {
    int degree;
    real c[2][NEARBY_DEGREE_MAX + 1], off[2], slope_off[2];
};

/* r: the reduction from a's degree to k, used if a is polynomial; the best approximation in the L2 norm.  A
 * rational arc is interpolated at k + 1 points; both differences are bounded by their own Bernstein
 * coefficients. */
void nearby_init(const struct arc *a, const struct frame *f, const struct reduction *r, int k,
                 struct nearby *out);

/* Coordinate 0 of the Euclidean control points, and the least interval that holds it: out[0..degree] may be
 * NULL. Bounds are widened by rounding and by the arc's error. */
void nearby_extent(const struct arc *a, const struct frame *f, real *out, real *lo, real *hi);

#endif
