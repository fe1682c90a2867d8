/* Half-planes that keep the tangent from turning by pi. */
#ifndef FATLINE_CHORDS_H
#define FATLINE_CHORDS_H

#include "pieces.h"

/* det(F'(a), F'(t)) has the sign of (w(a) x w(t)) . (d, 1): where it is that of the curvature for all t in
 * (a, b], the direction of F' stays within pi of the first.  All these lines pass through e(a); of their
 * pencil those at the spans' ends and where L(t) . w(a) = 0, which is where the line is stationary, imply the
 * others.  Fills k->chord; false: no room. */
bool chords_make(struct region_work *k);

#endif
