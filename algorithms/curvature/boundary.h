/* A region's boundary, from cones and to the curve's coordinates. */
#ifndef FATLINE_BOUNDARY_H
#define FATLINE_BOUNDARY_H

#include "cone.h"

/* Empty, and not certified. */
void region_clear(struct region *r);

/* A vertex so near the line at infinity that rounding cannot tell it from it, or farther than any use. */
bool vertex_is_infinite(const real *v, real error);

/* Kind and edges of a cone with interior, all of lines.  Points and lines are in normalised coordinates and
 * parameters those of the spans, until boundary_out.  false: no room. */
bool boundary_of_cone(const struct cone *c, struct region *out);

/* Of a region in normalised coordinates: area and largest disc if it is bounded. */
void boundary_measure(const struct region_work *k, real tolerance, struct region *r);

/* To the curve's own coordinates and parameter. */
void boundary_out(const struct region_work *k, struct region *r);

/* What closed conditions allow where the open region is empty: closed_kind, closed, and certified if that is
 * nothing. */
void boundary_closed(struct region_work *k, struct region *r);

#endif
