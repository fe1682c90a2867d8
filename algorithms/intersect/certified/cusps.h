/* Two curves as polynomials about places where their derivatives are as good as zero (cusps.c,
 * cusps_common.c). */
#ifndef FATLINE_CERTIFIED_CUSPS_H
#define FATLINE_CERTIFIED_CUSPS_H

#include "../../core/real.h"
#include "certified.h"

enum { TERMS = DEGREE_MAX + 1 };

/* Homogeneous coordinates of a source, less a common point, about a parameter, as powers; error: of x and y,
 * and of w. */
struct germ {
    int n;
    real t, reach; /* local parameter; how far the node's ends are from it */
    real x[TERMS], y[TERMS], w[TERMS], error[TERMS], error_w[TERMS];
};

/* Distances from the centres of two germs, by local parameters. */
struct box {
    real r, s;
};

/* Every solution within `clear` of the centres is within `core`; there are at most at_most of them in
 * `clear`, with multiplicity. */
struct common_ring {
    int at_most;
    struct box core, clear;
};

enum { COMMON_RINGS = 4 };
struct common {
    int rings;
    struct common_ring ring[COMMON_RINGS]; /* each in the core of the one before */
};

/* For centres of order 2 with nearly the same tangent; false: nothing is proved. */
bool cusps_common(const struct germ *f, const struct germ *g, struct common *out);

#endif
