/* How shared arcs are found; for exact_overlap.c and its parts.
 *
 * Both curves run over one irreducible curve F, f = F(phi(t)), g = F(psi(s)) with rational phi and psi
 * (Lueroth), so the common component is the numerator of phi(t) - psi(s).  Between its critical parameters
 * each of phi, psi is monotone: two monotone pieces share the meeting of their value ranges. */
#ifndef FATLINE_EXACT_ARCS_H
#define FATLINE_EXACT_ARCS_H

#include "exact_overlap.h"

enum { PREC_BREAK = 384 }; /* of the critical parameters */

/* One side: value = num / den over [0, 1], its critical parameters and between them the monotone pieces. */
struct side {
    fmpz_poly_t num, den, slope; /* slope: num' den - num den' */
    struct root_list breaks;
    int *rising; /* of piece k, between breaks k and k + 1 */
};

struct arcs {
    const struct exact_pair *pair;
    struct biv component;
    struct side side[2]; /* t, s */
    slong bits;          /* of ends inside pieces */
};

/* An end of the meeting of two pieces: a critical parameter, or -1 for a place inside the piece. */
struct corner {
    int at[2];
};

struct meeting {
    int piece[2];
    struct corner end[2]; /* by growing t */
    bool merged;
};

struct meeting_list {
    int count;
    struct meeting *at;
};

/* gcd(p, q), p / gcd and q / gcd, all initialised here (exact_component.c). */
bool arcs_split_component(struct biv *common, struct biv *p1, struct biv *q1, const struct biv *p,
                          const struct biv *q);
/* phi and psi, finite at 0, 1 and every turning point; false if none were found. */
bool arcs_choose_values(struct arcs *k);
void arcs_find_pieces(struct side *d);
/* Adds the meeting of piece i of phi and j of psi to m, or to `touching` if it is one corner only; false if
 * that stayed undecided (exact_meeting.c). */
bool arcs_meet(struct arcs *k, int i, int j, struct meeting_list *m, struct meeting_list *touching);
/* The parameters of a corner of the meeting of two pieces (exact_ends.c). */
bool arcs_corner(struct arcs *k, struct corner c, const int piece[2], struct real_root *t,
                 struct real_root *s);

#endif
