/* A curve written in its lowest degree: elevated curves make an implicit equation vanish. */
#ifndef FATLINE_LOWERED_H
#define FATLINE_LOWERED_H

#include "arc.h"
#include "implicit.h"

enum { POINTS_MAX = 33 };

/* Homogeneous coordinates, components one after the other; Euclidean ones; the polygon points at both, so do
 * not copy it. */
struct lowered {
    int components;
    real homogeneous[3 * POINTS_MAX], euclidean[2 * POINTS_MAX];
    struct polygon polygon; /* its error is the arc's, and what quotients and reduction add */
    real extent;            /* max |coordinate| */
    bool reduced; /* what was given has a higher degree; it agrees within 32 n eps scale, and c.error */
};

/* scale >= max |coordinate| of c, of degree POINTS_MAX - 1 at most.  Degrees 1 to REDUCED_MAX are tried;
 * where none fits, c is taken as it is.
 */
void lowered_init(const struct arc *c, real scale, struct lowered *s);

#endif
