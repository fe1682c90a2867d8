/* Halve while the boxes meet: axis-parallel boxes, or boxes along the chords.
 *
 * Lane and Riesenfeld 1980.  The larger arc is halved; a cell that is narrow enough must pass the boxes along
 * the chords, in either case, before it is returned.  Linear: one bit a level; at a contact of order mu the
 * number of live cells grows like eps^(1/mu - 1) (axis-parallel) or eps^(2/mu - 1) (oriented). */
#include "../core/cells.h"

static bool boxes_meet(const struct problem *p, const struct cell *c)
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    return arc_boxes_meet(&f, &g, p->bounds.scale);
}

static bool oriented_boxes_meet(const struct problem *p, const struct cell *c)
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    return arc_boxes_meet(&f, &g, p->bounds.scale) && arc_oriented_boxes_meet(&f, &g, p->bounds.scale);
}

static int shrink(const struct problem *p, const struct workspace *w, struct cell *c,
                  struct piece piece[PIECES_MAX])
{
    (void)w;
    (void)piece;
    return boxes_meet(p, c) ? HALVE : 0;
}

static int shrink_oriented(const struct problem *p, const struct workspace *w, struct cell *c,
                           struct piece piece[PIECES_MAX])
{
    (void)w;
    (void)piece;
    return oriented_boxes_meet(p, c) ? HALVE : 0;
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return solve_by_shrinking(p, w, out, shrink, oriented_boxes_meet, LONGER_ARC);
}

static enum outcome intersect_oriented(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return solve_by_shrinking(p, w, out, shrink_oriented, oriented_boxes_meet, LONGER_ARC);
}

extern const struct intersector subdivision;
const struct intersector subdivision = {
    .name = "subdivision",
    .summary = "halve while the axis-parallel boxes meet",
    .reference = "Lane and Riesenfeld, A theoretical development for the computer generation and display of "
                 "piecewise polynomial surfaces, 1980",
    .claimed = {1, 0, 0, 0},
    .intersect = intersect,
    .scratch = NULL,
    .points_only = false,
};

extern const struct intersector subdivision_oriented;
const struct intersector subdivision_oriented = {
    .name = "subdivision_oriented",
    .summary = "halve while the boxes meet, axis-parallel and along both chords",
    .reference = "Lane and Riesenfeld 1980, with the oriented boxes of Ballard, Strip trees, 1981",
    .claimed = {1, 0, 0, 0},
    .intersect = intersect_oriented,
    .scratch = NULL,
    .points_only = false,
};
