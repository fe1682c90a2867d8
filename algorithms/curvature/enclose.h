/* Outer polygons: half-planes cut off vertices until none is left outside. */
#ifndef FATLINE_ENCLOSE_H
#define FATLINE_ENCLOSE_H

#include "cone.h"
#include "pieces.h"

/* Clips c by p moved outwards by `relaxed` (of a unit triple). */
enum clip enclose_clip(struct cone *c, const struct half_plane *p, real relaxed);

/* Clips c by the half-planes at the ends of all pieces; those at smooth joints and others that are no corners
 * only if `all`.  false: nothing is left. */
bool enclose_ends(struct region_work *k, struct cone *c, bool all, real relaxed, enum outcome *outcome);

/* Cuts every vertex there is that misses a condition by more than `tolerance` with the worst one; *cuts
 * counts. false: nothing is left. */
bool enclose_round(struct region_work *k, struct cone *c, real relaxed, real tolerance, int *cuts,
                   enum outcome *outcome);

/* c becomes a polygon that holds all points at which the conditions, moved outwards by `relaxed`, are
 * fulfilled, and whose vertices miss none by more than relaxed + tolerance.  false: there are none, to
 * rounding. */
bool enclose(struct region_work *k, struct cone *c, real relaxed, real tolerance, enum outcome *outcome);

#endif
