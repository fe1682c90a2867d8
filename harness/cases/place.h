/* Where a record is in the plane.  Compiled for each precision. */
#ifndef FATLINE_PLACE_H
#define FATLINE_PLACE_H

#include <stdio.h>

#include "../../algorithms/bezier.h"

/* f at t, a parameter of its domain; beyond it at the end.  In the units of f, rounded as bernstein.h says.
 */
void place_at(const struct curve *f, real t, real *x, real *y);
/* ,"point":[x,y] as doubles; null for what is beyond their range. */
void place_write(FILE *stream, const struct curve *f, real t);

/* A number within the interval. */
static inline real place_middle(real lo, real hi)
{
    return lo + (hi - lo) / 2;
}

#endif
