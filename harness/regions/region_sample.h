/* The second opinion on a region: many half-planes det(F', F'')(t) > 0, each from the curve itself by de
 * Boor's algorithm in doubles, and the polygon they leave.  Shares nothing with the methods. */
#ifndef FATLINE_REGION_SAMPLE_H
#define FATLINE_REGION_SAMPLE_H

#include "../../algorithms/region.h"

/* a x + b y + c >= 0 with a^2 + b^2 = 1 in coordinates (x - x0) / size; a = b = 0: c = 1 or -1.  The
 * coefficients err by about `error`. */
struct sampled_plane {
    double a, b, c, error;
};

struct region_sample {
    double x0, y0, size;
    int count;
    struct sampled_plane *plane;
    int corners; /* of what the planes leave of the box |x|, |y| <= SAMPLE_BOX; 0: nothing */
    double (*corner)[2];
};

enum { SAMPLE_BOX = 1000 };

/* per_span parameters a knot span, denser towards its ends. */
void region_sample_make(struct region_sample *s, const struct region_problem *p, int per_span);
void region_sample_clear(struct region_sample *s);

/* Least a x + b y + c + error over all planes at a point in the curve's own coordinates, over its distance
 * from the origin of the sample if that is above 1. */
double region_sample_height(const struct region_sample *s, double x, double y);

#endif
