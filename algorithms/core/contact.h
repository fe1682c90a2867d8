/* The gap between two arcs as a function of one parameter, with its remainder: where it may vanish.
 *
 * Let T be a direction along which g runs, N its normal.  An affine s(t) is chosen so that T.g(s(t)) is
 * T.f(t) to first order.  If |T.(f(t) - g(s(t)))| <= eps on the box, then f(t) = g(s) only for |s - s(t)| <=
 * eta = eps / min |T.g'|, and then |N.(f(t) - g(s(t)))| <= eta max |N.g'|: the roots of this gap, which is a
 * polynomial over positive weights, within this bound.  On a box of width h eta is O(h^2) and max |N.g'| is
 * O(h) next to a contact, so the bound is O(h^3), and a contact of order k is narrowed to O(h^(3/k)). */
#ifndef FATLINE_CONTACT_H
#define FATLINE_CONTACT_H

#include "interval.h"
#include "lowered.h"

enum { CONTACT_DEGREE_MAX = 2 * (POINTS_MAX - 1) };

struct contact_piece {
    struct interval t, s;
};

/* All (t, s) in the box with f(t) = g(s) lie in the pieces, which have disjoint t; returns their number, at
 * most CONTACT_DEGREE_MAX + 1, or -1 if g does not run along T all over the box.  tolerance: no narrower t is
 * asked for. scratch: roots_scratch(degree of f + degree of g). */
int contact_meet(const struct lowered *f, const struct interval *t, const struct lowered *g,
                 const struct interval *s, real tolerance, real *scratch,
                 struct contact_piece out[CONTACT_DEGREE_MAX + 1]);

#endif
