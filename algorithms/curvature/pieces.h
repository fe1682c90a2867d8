/* Spans cut where their type changes. */
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

#endif
