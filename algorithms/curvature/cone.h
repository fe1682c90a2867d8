/* Convex polygons of the projective plane as cones of homogeneous triples. */
#ifndef FATLINE_CONE_H
#define FATLINE_CONE_H

#include "work.h"

static inline real triple_dot(const real *a, const real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void triple_cross(const real *a, const real *b, real *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Length before it is made 1; a zero triple is left alone. */
real triple_normalise(real *a);

/* The unit vector a x b and its error, for unit vectors that err by at most error_a, error_b; the error is
 * that of the cross product, 4 REAL_EPSILON and theirs, over its length, and 1 at most. */
void triple_meet(const real *a, real error_a, const real *b, real error_b, real *out, real *error);

void half_plane_infinity(struct half_plane *p);

/* The whole plane: the one half-plane Z >= 0. */
void cone_init(struct cone *c);

/* CLIP_NOTHING: c lies in p already (to rounding).  CLIP_EMPTY: their intersection has no interior; c is left
 * alone.  CLIP_FULL: no room. */
enum clip { CLIP_NOTHING, CLIP_CUT, CLIP_EMPTY, CLIP_FULL };
enum clip cone_clip(struct cone *c, const struct half_plane *p);

/* Vectors that span the cone with nonnegative factors, GENERATORS_MAX at most beyond its vertices: the
 * vertices and, of a cone of one or two half-planes, what lies between.  Number k, with its error; false:
 * there are no more. */
bool cone_generator(const struct cone *c, int k, real *v, real *error);

#endif
