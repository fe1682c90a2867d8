/* Random curves with a free control point, as lines for `fatline region`.  Precision-independent. */
#ifndef FATLINE_REGION_RANDOM_H
#define FATLINE_REGION_RANDOM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { REGION_LINE_MAX = 8000 };

/* Line number index: a Bezier, rational Bezier, B-spline or NURBS curve of a degree in lo..hi <= 17, with
 * integer points in [-12, 12]^2, half of them near an arc of a circle; weights among 1/2, 1, 2, 3; knots in
 * eighths, repeated degree - 1 times at most; a third on part of the interval; either sign. */
void region_random_line(uint64_t seed, int lo, int hi, uint64_t index, char line[REGION_LINE_MAX]);

#ifdef __cplusplus
}
#endif
#endif
