/* Crossings of many pairs of cubics, a pair in each lane: octagons, a 4 x 4 grid, halving, the cross-product
 * test of cone.c, and Newton's method with the radii of solve_one.c.  What is not quickly decided is left
 * alone.
 *
 * A node is always cut from its curve as given, so that its error does not depend on how deep it is.  Let u =
 * 2^-53, S the largest |coordinate| of the pair as cubics (the unit of a pair is u S), P a node's point.
 *
 * Elevation to degree 3: thirds of a + 2 b, three roundings: 3 u S; none for cubics.
 * Cutting: a mean of a and b is a - t a and then + t b, both fused, so it errs by u ((1 - t) |a| + |mean|) <=
 * 2 u S; t = m 2^-d is exact.  A point is three means deep: 6 u S.
 * Halving: (a + b) / 2 errs by u S; three deep: 3 u S.  A node is cut and halved at most once, or halved at
 * most twice, and those halved after a cut meet no other test than that of octagons.  So
 *
 *     |P - exact| <= E = 12 u S, and 9 u S where directions are made.
 *
 * Octagons: x and y are apart if the computed bounds are by more than 2 E and 2 u S of rounding: 30 u S will
 * do.  x + y and x - y err by 2 E + 2 u S each, their difference by 4 u S more: 60 u S.
 * Directions A are differences: e = 18 u S + 2 u S, 26 u S will do.  V, the largest 1-norm of the computed
 * ones and 2 e, covers the exact ones.  A cross product errs by e V_f + e V_g + e^2 and 2 u V_f V_g of
 * rounding; e <= V / 2 and u V <= e / 6, so that 1.5 e (V_f + V_g) covers all.  Second differences err by 2 e
 * + 4 u S <= 60 u S.
 *
 * Evaluation, at t in [0, 1], of the curve as given: with v = 1 - t the powers err by at most 5 u relatively,
 * 3 c[1] and 3 c[2] by u and then no power by more than 4 u, products and sums by 3 u, and all terms together
 * are at most S: 8 u S.  Elevation adds 3 u S, the sum with the tangent past the node u S: 14 u S will do.
 * Slopes: differences times 3 or 6 err by 2 u, weights by 3 u, sums by 3 u, of at most 6 S: 48 u S; elevation
 * adds 18 u S, the distance past the node and its product 12 u S: 80 u S will do.
 *
 * Where S lies between 2^-200 and 2^200 nothing overflows but what then is left alone, and what underflows is
 * below a multiple of u S that was added already. */
#ifndef FATLINE_BATCH_KERNEL_H
#define FATLINE_BATCH_KERNEL_H

#include "batch_chunk.h"
#include "lanes.h"

/* Multiples of u S, see above. */
static const double octagon_gap = 60, way_error = 26, bend_error = 60, value_error = 14, slope_error = 80;

struct arc {
    wide x[4], y[4];
};

struct octagon {
    wide low[4], high[4]; /* of x, y, x + y, x - y */
};

LANES_INLINE wide cross(wide ax, wide ay, wide bx, wide by)
{
    return wide_fms(ax, by, ay * bx);
}

LANES_INLINE wide norm_1(wide x, wide y)
{
    return wide_abs(x) + wide_abs(y);
}

/* ---- curves into lanes ---- */

LANES_INLINE void elevate(wide_mask line, wide_mask low, wide c[4])
{
    const double third = 1.0 / 3;
    const wide two = wide_of(2);
    wide last = wide_select(line, c[1], wide_select(low, c[2], c[3]));
    wide left = wide_fma(wide_select(line, c[0], c[1]), two, wide_select(line, c[1], c[0])) * third;
    wide right = wide_fma(c[1], two, wide_select(line, c[0], c[2])) * third;
    c[1] = wide_select(low, left, c[1]);
    c[2] = wide_select(low, right, c[2]);
    c[3] = last;
}

/* The curves of the pairs first + pair[0..LANES-1]. */
LANES_INLINE void find_rows(const struct batch_curves *from, const int *index, int first, const int *pair,
                            const double *row[LANES])
{
    const double *points = from->points + (index ? 0 : BATCH_NUMBERS * (ptrdiff_t)first);
    if (index) {
        index += first;
#pragma GCC unroll 8
        for (int i = 0; i < LANES; i++) {
            row[i] = points + BATCH_NUMBERS * (ptrdiff_t)index[pair[i]];
        }
    } else {
#pragma GCC unroll 8
        for (int i = 0; i < LANES; i++) {
            row[i] = points + BATCH_NUMBERS * (ptrdiff_t)pair[i];
        }
    }
}

LANES_INLINE void arc_of(const double *const row[LANES], struct arc *out)
{
    wide number[8];
    wide_transpose(row, number);
#pragma GCC unroll 4
    for (int i = 0; i < 4; i++) {
        out->x[i] = number[i];
        out->y[i] = number[4 + i];
    }
}

LANES_INLINE void elevate_arc(const double degree[LANES], struct arc *a)
{
    wide n = wide_load(degree);
    wide_mask line = wide_less(n, wide_of(1.5)), low = wide_less(n, wide_of(2.5));
    elevate(line, low, a->x);
    elevate(line, low, a->y);
}

LANES_INLINE void load(const struct batch_curves *from, const int *index, int first, const int *pair,
                       struct arc *out)
{
    const double *row[LANES];
    double degree[LANES];
    find_rows(from, index, first, pair, row);
    arc_of(row, out);
    if (from->degree) {
        for (int i = 0; i < LANES; i++) {
            degree[i] = from->degree[index ? index[first + pair[i]] : first + pair[i]];
        }
        elevate_arc(degree, out);
    }
}

/* Curves that follow each other. */
LANES_INLINE void load_next(const struct batch_curves *from, ptrdiff_t first, struct arc *out)
{
    const double *row[LANES], *points = from->points + BATCH_NUMBERS * first;
    double degree[LANES];
#pragma GCC unroll 8
    for (int i = 0; i < LANES; i++) {
        row[i] = points + BATCH_NUMBERS * i;
    }
    arc_of(row, out);
    if (from->degree) {
        for (int i = 0; i < LANES; i++) {
            degree[i] = from->degree[first + i];
        }
        elevate_arc(degree, out);
    }
}

LANES_INLINE void load_pairs(const struct batch_chunk *z, const int *pair, struct arc *f, struct arc *g)
{
    load(&z->batch->f, z->batch->f_index, z->first, pair, f);
    load(&z->batch->g, z->batch->g_index, z->first, pair, g);
}

/* The last number of the list once more, so that LANES can be read from wherever there is one. */
LANES_INLINE void list_pad(double *list, int count)
{
    for (int i = 0; i < SLACK && count > 0; i++) {
        list[count + i] = list[count - 1];
    }
}

LANES_INLINE void list_pad_whole(int *list, int count)
{
    for (int i = 0; i < SLACK && count > 0; i++) {
        list[count + i] = list[count - 1];
    }
}

LANES_INLINE void leave_alone(struct batch_chunk *z, wide_mask which, wide at)
{
    double number[LANES];
    wide_store(number, at);
    for (unsigned bits = wide_bits(which); bits; bits &= bits - 1) {
        unsigned char *alone = &z->alone[(int)number[__builtin_ctz(bits)]];
        z->alone_count += !*alone;
        *alone = 1;
    }
}

/* ---- octagons ---- */

LANES_INLINE void span(wide a, wide b, wide c, wide d, wide *low, wide *high)
{
    *low = wide_min(wide_min(a, b), wide_min(c, d));
    *high = wide_max(wide_max(a, b), wide_max(c, d));
}

LANES_INLINE void octagon_box(const struct arc *a, struct octagon *out)
{
    span(a->x[0], a->x[1], a->x[2], a->x[3], &out->low[0], &out->high[0]);
    span(a->y[0], a->y[1], a->y[2], a->y[3], &out->low[1], &out->high[1]);
}

LANES_INLINE void octagon_corners(const struct arc *a, struct octagon *out)
{
    const wide *x = a->x, *y = a->y;
    span(x[0] + y[0], x[1] + y[1], x[2] + y[2], x[3] + y[3], &out->low[2], &out->high[2]);
    span(x[0] - y[0], x[1] - y[1], x[2] - y[2], x[3] - y[3], &out->low[3], &out->high[3]);
}

LANES_INLINE void octagon_of(const struct arc *a, struct octagon *out)
{
    octagon_box(a, out);
    octagon_corners(a, out);
}

/* The larger gap between the bounds k and k + 1. */
LANES_INLINE wide gap_between(const struct octagon *f, const struct octagon *g, int k)
{
    wide a = wide_max(f->low[k] - g->high[k], g->low[k] - f->high[k]);
    wide b = wide_max(f->low[k + 1] - g->high[k + 1], g->low[k + 1] - f->high[k + 1]);
    return wide_max(a, b);
}

LANES_INLINE wide_mask boxes_apart(const struct octagon *f, const struct octagon *g, wide unit)
{
    return wide_less(unit * (octagon_gap / 2), gap_between(f, g, 0));
}

LANES_INLINE wide_mask octagons_apart(const struct octagon *f, const struct octagon *g, wide unit)
{
    wide gap = wide_max(2.0 * gap_between(f, g, 0), gap_between(f, g, 2));
    return wide_less(unit * octagon_gap, gap);
}

/* ---- nodes ---- */

LANES_INLINE wide mean(wide a, wide b, wide t)
{
    return wide_fma(t, b, wide_fnma(t, a, a));
}

/* Its polar form at (lo lo lo), (lo lo hi), (lo hi hi), (hi hi hi). */
LANES_INLINE void cut_component(const wide c[4], wide lo, wide hi, wide out[4])
{
    wide a0 = mean(c[0], c[1], lo), a1 = mean(c[1], c[2], lo), a2 = mean(c[2], c[3], lo);
    wide b0 = mean(c[0], c[1], hi), b1 = mean(c[1], c[2], hi), b2 = mean(c[2], c[3], hi);
    wide aa0 = mean(a0, a1, lo), aa1 = mean(a1, a2, lo), ab0 = mean(a0, a1, hi), ab1 = mean(a1, a2, hi);
    wide bb0 = mean(b0, b1, hi), bb1 = mean(b1, b2, hi);
    out[0] = mean(aa0, aa1, lo);
    out[1] = mean(aa0, aa1, hi);
    out[2] = mean(ab0, ab1, hi);
    out[3] = mean(bb0, bb1, hi);
}

LANES_INLINE void cut(const struct arc *c, wide lo, wide width, struct arc *out)
{
    wide hi = lo + width;
    cut_component(c->x, lo, hi, out->x);
    cut_component(c->y, lo, hi, out->y);
}

LANES_INLINE void halve_component(const wide c[4], wide left[4], wide right[4])
{
    wide a = (c[0] + c[1]) * 0.5, b = (c[1] + c[2]) * 0.5, d = (c[2] + c[3]) * 0.5;
    wide e = (a + b) * 0.5, f = (b + d) * 0.5, m = (e + f) * 0.5;
    left[0] = c[0];
    left[1] = a;
    left[2] = e;
    left[3] = right[0] = m;
    right[1] = f;
    right[2] = d;
    right[3] = c[3];
}

LANES_INLINE void halve(const struct arc *c, struct arc *left, struct arc *right)
{
    halve_component(c->x, left->x, right->x);
    halve_component(c->y, left->y, right->y);
}

/* ---- cone.c, for nodes ---- */

struct hodograph {
    wide x[3], y[3], speed, bend; /* differences; V; no larger second difference */
};

struct cone {
    struct hodograph f, g;
    wide gap; /* > 0: proved, as cone_gap */
};

LANES_INLINE void hodograph_of(const struct arc *a, wide unit, struct hodograph *out)
{
#pragma GCC unroll 3
    for (int i = 0; i < 3; i++) {
        out->x[i] = a->x[i + 1] - a->x[i];
        out->y[i] = a->y[i + 1] - a->y[i];
    }
    wide speed = wide_max(wide_max(norm_1(out->x[0], out->y[0]), norm_1(out->x[1], out->y[1])),
                          norm_1(out->x[2], out->y[2]));
    wide bend_x = wide_max(wide_abs(out->x[1] - out->x[0]), wide_abs(out->x[2] - out->x[1]));
    wide bend_y = wide_max(wide_abs(out->y[1] - out->y[0]), wide_abs(out->y[2] - out->y[1]));
    out->speed = wide_fma(unit, wide_of(2 * way_error), speed);
    out->bend = wide_fma(unit, wide_of(bend_error), wide_max(bend_x, bend_y));
}

LANES_INLINE void cone_of(const struct arc *f, const struct arc *g, wide unit, struct cone *out)
{
    hodograph_of(f, unit, &out->f);
    hodograph_of(g, unit, &out->g);
    wide low = cross(out->f.x[0], out->f.y[0], out->g.x[0], out->g.y[0]), high = low;
#pragma GCC unroll 9
    for (int k = 1; k < 9; k++) {
        wide c = cross(out->f.x[k / 3], out->f.y[k / 3], out->g.x[k % 3], out->g.y[k % 3]);
        low = wide_min(low, c);
        high = wide_max(high, c);
    }
    out->gap = wide_max(low, -high) - unit * (1.5 * way_error) * (out->f.speed + out->g.speed);
}

#endif
