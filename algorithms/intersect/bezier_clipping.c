/* Clip each curve in turn to the fat line of the other.
 *
 * Sederberg and Nishita 1990: the distances of f's control points from the fat line of g are the control
 * values of an explicit Bezier curve over the parameter; where its convex hull misses the strip, f cannot
 * meet g.  When a clip removes less than a fifth, the longer curve is halved, if the boxes along both
 * chords meet.  Quadratic at transversal crossings (Schulz 2009), linear at contacts.
 *
 * Nothing is lost to rounding: the strip is widened by the bound of fat_line, the clip by that of hull_meet
 * and of its map to the curve's parameter. */
#include "../core/cells.h"
#include "../core/hull.h"

/* Narrows [*lo, *hi] = the whole of a, in local parameters, to where a may meet b; false: nowhere. */
static bool clip(const struct arc *a, const struct arc *b, real scale, real *lo, real *hi)
{
    const struct fat_line_rule rule = {.unit = false, .tight = true, .stretch = 1};
    real above[DEGREE_MAX + 1], below[DEGREE_MAX + 1];
    struct strip s;
    fat_line(b, a, scale, &rule, &s);
    strip_distances(&s, a, above, below);
    *lo = 0;
    *hi = 1;
    return hull_meet(a->degree, above, lo, hi) && hull_meet(a->degree, below, lo, hi);
}

static int shrink(const struct problem *p, const struct workspace *w, struct cell *c,
                  struct piece piece[PIECES_MAX])
{
    (void)w;
    bool clip_g = c->turn;
    if (clip_g ? interval_width(&c->s) <= p->bounds.tolerance_s
               : interval_width(&c->t) <= p->bounds.tolerance_t) {
        clip_g = !clip_g;
    }
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    real lo, hi;
    if (!clip(clip_g ? &g : &f, clip_g ? &f : &g, p->bounds.scale, &lo, &hi)) {
        return 0;
    }
    c->turn = !clip_g;
    piece[0].t = c->t;
    piece[0].s = c->s;
    struct interval *clipped = clip_g ? &piece[0].s : &piece[0].t;
    real width = interval_width(clipped);
    interval_clip(clipped, lo, hi);
    if (interval_width(clipped) <= (real)0.8 * width) {
        return 1;
    }
    return arc_oriented_boxes_meet(&f, &g, p->bounds.scale) ? HALVE : 0;
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return solve_by_shrinking(p, w, out, shrink, cell_arcs_may_meet, LONGER_ARC);
}

extern const struct intersector bezier_clipping;
const struct intersector bezier_clipping = {
    .name = "bezier_clipping",
    .summary = "clip each curve to the fat line of the other by convex hulls",
    .reference = "Sederberg and Nishita, Curve intersection using Bezier clipping, 1990",
    .claimed = {2, 1, 0, 0},
    .intersect = intersect,
    .scratch = NULL,
    .points_only = false,
};
