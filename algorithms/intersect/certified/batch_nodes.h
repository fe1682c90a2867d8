/* What follows from a look at a pair of nodes in each lane: halves of the one that is farther from straight,
 * or where Newton's method begins. */
#ifndef FATLINE_BATCH_NODES_H
#define FATLINE_BATCH_NODES_H

#include "batch_newton.h"

/* For lanes whose directions all cross: the start of Newton's method, and what cone.c proves of them. */
struct start {
    wide t, s, reach_t, reach_s, bend_f, bend_g;
};

/* Where the chords of f and g meet; the nodes' codes are those of batch_chunk.h. */
LANES_INLINE void start_of(wide code_f, wide code_g, const struct arc *f, const struct arc *g,
                           const struct cone *c, struct start *out)
{
    const double up = 1 + 8 * DBL_EPSILON;
    wide ux = f->x[3] - f->x[0], uy = f->y[3] - f->y[0], vx = g->x[3] - g->x[0], vy = g->y[3] - g->y[0];
    wide rx = g->x[0] - f->x[0], ry = g->y[0] - f->y[0], det = cross(ux, uy, vx, vy), thrice = 3.0 * c->gap;
    wide both = 1.0 / (det * thrice), one = both * thrice, k = both * det * up; /* k: 1 / thrice */
    wide width_f = code_width(code_f), width_g = code_width(code_g);
    wide times_f = code_times(code_f), times_g = code_times(code_g);
    out->t = wide_fma(width_f, cross(rx, ry, vx, vy) * one, code_start(code_f));
    out->s = wide_fma(width_g, cross(rx, ry, ux, uy) * one, code_start(code_g));
    out->reach_t = c->g.speed * width_f * k;
    out->reach_s = c->f.speed * width_g * k;
    out->bend_f = 6 * up * c->f.bend * (times_f * times_f);
    out->bend_g = 6 * up * c->g.bend * (times_g * times_g);
}

LANES_INLINE void select_arc(wide_mask m, const struct arc *yes, const struct arc *no, struct arc *out)
{
#pragma GCC unroll 4
    for (int i = 0; i < 4; i++) {
        out->x[i] = wide_select(m, yes->x[i], no->x[i]);
        out->y[i] = wide_select(m, yes->y[i], no->y[i]);
    }
}

/* Both halves of the arc that is farther from straight, with the other. */
struct halved {
    wide_mask meet[2];
    wide f[2], g[2]; /* codes */
};

LANES_INLINE void halve_longer(wide code_f, wide code_g, wide unit, const struct arc *f, const struct arc *g,
                               const struct cone *c, struct halved *out)
{
    struct arc longer, other, half[2];
    struct octagon part, beside;
    wide_mask is_g = wide_less(c->f.bend, c->g.bend);
    select_arc(is_g, g, f, &longer);
    select_arc(is_g, f, g, &other);
    halve(&longer, &half[0], &half[1]);
    octagon_of(&other, &beside);
#pragma GCC unroll 2
    for (int k = 0; k < 2; k++) {
        octagon_of(&half[k], &part);
        out->meet[k] = ~octagons_apart(&part, &beside, unit);
        out->f[k] = wide_select(is_g, code_f, wide_fma(code_f, wide_of(2), wide_of(k)));
        out->g[k] = wide_select(is_g, wide_fma(code_g, wide_of(2), wide_of(k)), code_g);
    }
}

#endif
