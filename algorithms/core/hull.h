/* Where the convex hull of a Bernstein polygon meets a half-plane. */
#ifndef FATLINE_HULL_H
#define FATLINE_HULL_H

#include "real.h"

/* The hull of the points (i/n, c[i]), i = 0..n, meets {y >= 0} over an interval; narrows [*lo, *hi],
 * within [0, 1], to it.  Returns 0, and leaves them alone, if it is empty.  The interval is widened by 4
 * REAL_EPSILON at each end that is not 0 or 1, which covers the rounding of the crossings (7 u of at most 1
 * each).
 *
 * The least t of the hull above 0 lies on a segment from a point below to a later point above; so the least
 * crossing over all such pairs is it, and no hull has to be built: at most (n + 1)^2 / 4 quotients. */
int hull_meet(int n, const real *c, real *lo, real *hi);

#endif
