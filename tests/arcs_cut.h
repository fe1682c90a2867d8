/* Arcs as an algorithm's cell has them, around a parameter. */
#ifndef FATLINE_TEST_ARCS_CUT_H
#define FATLINE_TEST_ARCS_CUT_H

#include "prop.h"

#include "../algorithms/core/arc.h"
#include "../algorithms/core/bernstein.h"

/* Control points of a curve over an interval, with the error of a cell's. */
struct cut {
    struct arc arc;
    real points[3 * (DEGREE_MAX + 1)];
};

static inline void cut_init(struct cut *c, const struct curve *of, real lo, real hi, real scale)
{
    int n = of->degree, length = n + 1;
    bernstein_restrict(n, 1, of->x, lo, hi, c->points);
    bernstein_restrict(n, 1, of->y, lo, hi, c->points + length);
    if (of->w)
        bernstein_restrict(n, 1, of->w, lo, hi, c->points + 2 * length);
    c->arc.degree = n;
    c->arc.x = c->points;
    c->arc.y = c->points + length;
    c->arc.w = of->w ? c->points + 2 * length : NULL;
    c->arc.error = (12 * n + 1) * (REAL_EPSILON / 2) * scale * (of->w ? 2 : 1);
}

/* [lo, lo + 2^-e] within [0, 1] that holds t at the local parameter *local, a multiple of 1/8. */
static inline real around(struct random_state *r, real t, int e, real *local)
{
    real lo, width = real_ldexp(1, -e);
    do {
        *local = (real)(int)random_between(r, 0, 8) / 8;
        lo = t - *local * width;
    } while (lo < 0 || lo + width > 1);
    return lo;
}

#endif
