/* What the files of this folder share: the memory of a region_workspace, laid out.
 *
 * Coordinates inside are normalised, (x - centre) / scale; points and lines are homogeneous triples, points
 * (X, Y, Z) with Z >= 0, lines (A, B, C) with the allowed side positive. */
#ifndef FATLINE_WORK_H
#define FATLINE_WORK_H

#include "../region.h"
#include "wronskian.h"

enum { FORM_MAX = 97 };

/* One knot span within the interval, [lo, hi] in the curve's parameter; the sign of the problem is in L. */
struct span {
    real lo, hi;
    struct span_forms form;
    real error; /* of any coefficient of L, at most */
};

/* A part of a span, [lo, hi] in the span's own parameter, over which the type is constant. */
struct piece {
    int span;
    real lo, hi;
    const real *L; /* A, B, C and the error sizes, degree of the span's L */
    const real *w; /* NULL where nobody asked */
    int type;      /* +1: S+, -1: S-, 0: no arc */
    int chain;     /* arcs of one chain join smoothly ... */
    int quarter;   /* ... and while this number changes by at most 1 the tangent turns by at most pi */
};

enum source { AT_INFINITY, MEMBER, CHORD };

/* A half-plane, its normal a unit vector of three components that err by at most `error`. */
struct half_plane {
    real l[3], error;
    enum source source;
    bool corner; /* may bound the region along a segment; else only touches it, or serves to enclose it */
    int span;
    real t; /* in the span's own parameter */
};

/* A convex cone as the cyclic list of its half-planes, counter-clockwise; edge i ends at
 * v = l[i] x l[i + 1].  One half-plane: no vertex; two: two opposite ones. */
struct cone_edge {
    struct half_plane plane;
    real v[3], error;  /* unit vector, and its error */
    bool holds, fresh; /* v is known to fulfil all conditions; it was made in this round */
};

struct cone {
    int count, room;
    bool missed; /* once empty: by all of the cone before, beyond rounding */
    struct cone_edge *edge;
};

struct region_work {
    real centre_x, centre_y, scale;
    int sign;
    bool rational, loop_free;
    int degree, spans, room_spans;
    bool strict, singular; /* singular: inside the interval h vanishes for every d */
    struct span *span;
    int pieces, room_pieces;
    struct piece *piece;
    real *piece_pool;
    size_t piece_used, piece_length;
    int chords, room_chords; /* half-planes that keep the curve from turning by pi */
    struct half_plane *chord;
    struct cone cone, relaxed;
    const real *pascal;
    real *roots; /* scratch for roots_find */
    int steps, max_steps;
    struct workspace *cells; /* of the intersector */
    struct crossings *crossings;
    const struct intersector *intersector;
};

#endif
