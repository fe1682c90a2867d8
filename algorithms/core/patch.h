/* Where a curve may meet a short arc of another: in the strip along the arc and in the strip across it. */
#ifndef FATLINE_PATCH_H
#define FATLINE_PATCH_H

#include "interval.h"
#include "lowered.h"

/* An arc over [lo, hi]: a point of it or near, and how far its control points are from there; each coordinate
 * errs by at most `error`.  radius: no coordinate of the arc is farther from the point.  (x, y): direction at
 * the middle, the larger component 1. */
struct patch {
    int degree;
    real px, py, radius, error, x, y;
    real dx[POINTS_MAX], dy[POINTS_MAX];
};

void patch_cut(const struct lowered *s, real lo, real hi, struct patch *h);

enum { MEETINGS_MAX = 2 * POINTS_MAX };

/* All parameters in [0, 1] for which a may meet the patch lie in the intervals of out, which are in order and
 * disjoint; returns their number.  At a crossing the strip along the patch is sharp, at a contact the one
 * across. tolerance: no narrower is asked for.  scratch: roots_scratch(degree of a). */
int patch_meet(const struct patch *h, const struct lowered *a, real tolerance, real *scratch,
               struct interval out[MEETINGS_MAX]);

#endif
