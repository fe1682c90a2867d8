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
    real extent, size;      /* max |coordinate|; larger side of the box of the control points */
    bool reduced; /* points agree with the given curve's within polygon.error, control points need not */
};

/* c as it is, of degree POINTS_MAX - 1 at most. */
void lowered_take(const struct arc *c, struct lowered *s);

/* scale >= max |coordinate| of c, of degree POINTS_MAX - 1 at most.  Degrees 1 to REDUCED_MAX are tried, and
 * taken if they agree within 32 n eps scale. */
void lowered_init(const struct arc *c, real scale, struct lowered *s);

/* The part over [lo, hi], as a curve of its own. */
void lowered_cut(const struct lowered *s, real lo, real hi, struct lowered *part);

#endif
