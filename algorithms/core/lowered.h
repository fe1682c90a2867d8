/* A curve written in its lowest degree: elevated curves make an implicit equation vanish. */
#ifndef FATLINE_LOWERED_H
#define FATLINE_LOWERED_H

#include "../bezier.h"
#include "implicit.h"

enum { POINTS_MAX = DEGREE_MAX + 1 };

/* Homogeneous coordinates, components one after the other; Euclidean ones; the polygon points at both, so do
 * not copy it. */
struct lowered {
    int components;
    real homogeneous[3 * POINTS_MAX], euclidean[2 * POINTS_MAX];
    struct polygon
        polygon;  /* its error covers the rounding of rational control points and what reduction left */
    real extent;  /* max |coordinate| */
    bool reduced; /* the given curve is a curve of lower degree to within polygon.error <= 32 n eps scale */
};

/* scale >= max |coordinate| of c.  Degrees 1 to REDUCED_MAX are tried; where none fits, c is taken as it is.
 */
void lowered_init(const struct curve *c, real scale, struct lowered *s);

#endif
