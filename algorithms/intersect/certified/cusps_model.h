/* Models of cusps (cusps_common.c has what they are). */
#ifndef FATLINE_CERTIFIED_CUSPS_MODEL_H
#define FATLINE_CERTIFIED_CUSPS_MODEL_H

#include "ball.h"
#include "cusps.h"

/* A curve in the frame: powers of the model, what the exact ones may differ by, and the disc |z| <= r. */
struct model {
    int n;
    real x[TERMS], y[TERMS], w[TERMS], off_x[TERMS], off_y[TERMS], off_w[TERMS];
    real bend;          /* a */
    real r, q, in, out; /* in: R; out: 1 / sqrt(1 - q) */
    real lightest;      /* no weight, of the model or exact, is smaller there */
    real most;          /* M */
    struct series height;
};

/* x along (ex, ey), of length 1 to rounding; false: there is no disc. */
bool model_make(const struct germ *of, real ex, real ey, struct model *out);
/* How far the exact x, or y, is from the model's for |z| <= s, s <= r. */
real model_away_x(const struct model *a, real s);
real model_away_y(const struct model *a, real s);

#endif
