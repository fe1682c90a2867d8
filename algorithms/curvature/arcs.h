/* One arc of the envelope: its forms over its own interval, area beneath it, nearest points. */
#ifndef FATLINE_ARCS_H
#define FATLINE_ARCS_H

#include "work.h"

/* The envelope over [t0, t1] of a span, t0 < t1, as three forms X, Y, Z of degree e on [0, 1]. */
struct envelope {
    int e;
    real w[3 * (DEGREE_MAX + 1)];
};

void envelope_make(const struct region_work *k, const struct region_edge *edge, struct envelope *out);

/* Integral of (x y' - y x') / 2 along the arc, from `edge->t` to `edge->t1`, about the point `about`;
 * relative error about `tolerance`.  Z must not vanish. */
real envelope_area(const struct region_edge *edge, const struct envelope *a, struct point about,
                   real tolerance);

/* Parameters of the span, at most FORM_MAX, at which the distance from d to the arc is stationary and changes
 * from growing to falling or back; returns their number. */
int envelope_feet(struct region_work *k, const struct region_edge *edge, const struct envelope *a,
                  struct point d, real *t);

/* From the tangent `line` at *t to a nearer one, until none is nearer within `reach` or nearly: by Newton's
 * method, and by halving where that leads away. */
void envelope_touch(const struct region_work *k, const struct region_edge *edge, struct point d, real reach,
                    real *t, real *line);

/* Between t = a and b, where the normal of the arc is parallel to that of `line`, by Newton's method; the
 * middle if that leads away. */
real envelope_opposite(const struct region_work *k, const struct region_edge *edge, const real *line, real a,
                       real b);

/* Tangent at t of the span, (A, B, C) with A^2 + B^2 = 1, the region on the positive side. */
void envelope_tangent(const struct region_work *k, const struct region_edge *edge, real t, real *line);

#endif
