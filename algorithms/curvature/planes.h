/* The half-planes of spans and of pieces, and whether all of them hold. */
#ifndef FATLINE_PLANES_H
#define FATLINE_PLANES_H

#include "signs.h"

/* The half-plane of span s at its parameter t, which is `corner`; false: it is all or nothing to no
 * direction, L(t) = 0. */
bool half_plane_at(const struct region_work *k, int span, real t, bool corner, struct half_plane *out);

/* Are all conditions L(t) . v >= 0 fulfilled on the piece, v a unit vector that errs by at most `error`?
 * Where FAILS, *where is a parameter of the span at which the least value, over |L|, is found near. */
enum verdict piece_holds(struct region_work *k, const struct piece *p, const real *v, real error,
                         real *where);

/* The same for all pieces but those of arcs in the same chain as `except` (NULL: none) within a quarter turn,
 * and for the chords.  FAILS fills *worst with the half-plane that v misses by most. */
enum verdict planes_hold(struct region_work *k, const struct piece *a, const struct piece *b, const real *v,
                         real error, struct half_plane *worst);

/* w at t of the span, as a unit vector with nonnegative third component. */
void envelope_at(const struct region_work *k, int span, real t, real *v);

#endif
