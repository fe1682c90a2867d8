/* B-spline and NURBS curves to Bezier pieces by knot insertion. */
#ifndef FATLINE_SPLINE_H
#define FATLINE_SPLINE_H

#include <stddef.h>

#include "real.h"

/* Degree 1 <= degree <= 32, count control points of `components` homogeneous coordinates stored one
 * coordinate after the other (points[c * count + i]), knots[0 .. count + degree] not decreasing; a knot
 * inside (knots[degree], knots[count]) occurs at most `degree` times, at an end of the knot vector at most
 * degree + 1 times. */
struct spline {
    int degree, count, components;
    const real *points, *knots;
};

/* One Bezier piece over [lo, hi] = two successive distinct knots: coefficients[c * (degree + 1) + i]. */
struct spline_piece {
    real lo, hi;
    real coefficients[3 * 33];
};

/* NULL, or what is wrong with s. */
const char *spline_check(const struct spline *s);

/* Number of distinct, non-empty knot spans inside [knots[degree], knots[count]]. */
int spline_pieces(const struct spline *s);

/* The index-th piece, 0 <= index < spline_pieces(s).  Bezier point i of the span is the blossom at (lo^(n-i),
 * hi^i), by degree - 1 rounds of knot insertion at either end of the span (de Boor's triangle): convex
 * combinations, so the error is at most 8 n u max|point| in each component. */
void spline_piece(const struct spline *s, int index, struct spline_piece *out);

#endif
