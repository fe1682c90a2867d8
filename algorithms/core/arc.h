/* One arc of a curve as the algorithms see it: control points with their error, boxes, fat line. */
#ifndef FATLINE_ARC_H
#define FATLINE_ARC_H

#include <stdbool.h>

#include "real.h"

/* Homogeneous control points, w == NULL for polynomial curves.  Each Euclidean coordinate errs by at most
 * error; for rational curves also |x - exact| <= (error / 2) w and |w - exact| S <= (error / 2) w, S = max
 * |coordinate|. */
struct arc {
    int degree;
    const real *x, *y, *w;
    real error;
};

/* The points with lo <= nx X + ny Y <= hi; bounds are already widened by rounding. */
struct strip {
    real nx, ny, lo, hi;
    real norm; /* |nx| + |ny| */
};

/* How fat_line makes its strip. */
struct fat_line_rule {
    bool unit;    /* (nx, ny) has Euclidean length 1 within 4 REAL_EPSILON; else it is the chord turned by 90
                     degrees */
    bool tight;   /* the factors 1/2 (degree 2) and 3/4, 4/9 (degree 3) of Sederberg and Nishita */
    real stretch; /* 1; the length of a unit normal, another one only in a negative control */
};

/* Larger side of the box of the Euclidean control points. */
real arc_extent(const struct arc *a);

/* False only if the boxes of the two arcs are apart: axis-parallel, and along the chords and their normals.
 * scale >= max |coordinate| of both. */
bool arc_boxes_meet(const struct arc *a, const struct arc *b, real scale);
bool arc_oriented_boxes_meet(const struct arc *a, const struct arc *b, real scale);

/* A strip that holds b, along its chord; where the chord says nothing, along the farthest control point from
 * the first; where b is a point to rounding, across the chord of a. The strip is widened so that a computed
 * value nx x + ny y - level w of a control point of a or b has the sign of the exact one wherever the exact
 * curve is outside the strip before widening: by norm (a->error + b->error + 8 REAL_EPSILON scale), which
 * covers 14 roundings of at most norm scale each. */
void fat_line(const struct arc *b, const struct arc *a, real scale, const struct fat_line_rule *rule,
              struct strip *out);

/* above[i] = w_i (distance of control point i - s->lo), below[i] = w_i (s->hi - distance), i = 0..degree:
 * inside the strip exactly where both polynomials with these Bernstein coefficients are >= 0. */
void strip_distances(const struct strip *s, const struct arc *a, real *above, real *below);

#endif
