/* Arcs of SVG as rational quadratics.  Compiled for each precision. */
#ifndef FATLINE_PATH_ARC_H
#define FATLINE_PATH_ARC_H

#include "path_set.h"

/* From (x0, y0) to (x1, y1): half axes rx, ry, rotation in degrees, as SVG 1.1, appendix F.6, defines it.
 * false: this precision does not hold it. */
bool path_arc_add(struct path_draft *d, real x0, real y0, real rx, real ry, double rotation, bool large,
                  bool sweep, real x1, real y1);

#endif
