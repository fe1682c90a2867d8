/* Are two arcs one?  (overlap_compare.c) */
#ifndef FATLINE_CERTIFIED_OVERLAP_H
#define FATLINE_CERTIFIED_OVERLAP_H

#include "evaluate.h"

/* f over [t0, t1] and g from s0 to s1, s0 > s1 if it runs the other way. */
struct shared {
    real t0, t1, s0, s1;
};

/* A bound on the distance between the two arcs, as one is run through along the other; negative: none was
 * found.  limit: larger ones are of no use. */
real shared_distance(const struct level *v, const struct shared *a, real limit);

/* Parameter of the point of c nearest to (x, y), by Gauss and Newton's method from *t, within [lo, hi];
 * returns how far it is, in the maximum norm. */
real source_match(const struct source *c, real x, real y, real lo, real hi, real *t);

/* f'' by the local parameter, about: from f' at a distance h. */
void source_second(const struct source *c, real t, real h, real *ddx, real *ddy);

/* Moves t to where the derivative is nearest to 0, by Newton's method; is it no more than rounding there? */
bool source_cusp(const struct source *c, real *t);

/* ---- overlap_ends.c ---- */

/* Adds the arc to the records; false: it is no longer than its ends are uncertain, or there is no room. */
bool overlap_record(struct solver *z, const struct shared *x, real distance);

#endif
