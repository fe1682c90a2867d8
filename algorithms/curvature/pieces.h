/* Spans cut where their type changes, and the half-planes of each piece. */
#ifndef FATLINE_PIECES_H
#define FATLINE_PIECES_H

#include "signs.h"

/* AT_TORSION: cut where M changes its sign.  AT_ALL: also where w3, A or B does, and with the envelopes'
 * forms and types. */
enum cuts { AT_TORSION, AT_ALL };

/* Makes k->piece; false: no room. */
bool pieces_make(struct region_work *k, enum cuts cuts);

/* Makes them otherwise: spans are halved until the Bernstein coefficients of L lie within 60 degrees of one
 * direction, so that none is more than twice as long as the sum lets expect.  *all: everywhere; room and
 * arithmetic may forbid it. */
bool pieces_make_narrow(struct region_work *k, bool *all);

/* Parameters inside span s, in increasing order, where one of its forms changes sign, with the reasons
 * (enum break_reason; those closer than rounding are one); -1: more than `room`. */
struct cut {
    real t;
    int reasons;
};
int span_cuts(struct region_work *k, const struct span *s, enum cuts cuts, int room, struct cut *out);

/* At the knot after this span the envelope goes on through the same point with the same oriented tangent. */
bool joint_is_smooth(const struct region_work *k, int span);

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
