/* The smallest complete algorithm, to copy: halve while the bounding circles meet; what is narrow enough must
 * pass the boxes along both chords.
 *
 * It is built and tested with the others, but not listed.  Yours: give the file, its entry and its name
 * another name, write your own shrink, and add INTERSECTOR(your_name) to algorithms/list.h. */
#include "../core/cells.h"

struct circle {
    real x, y, radius;
};

static real coordinate(const struct arc *a, const real *c, int i)
{
    return a->w ? c[i] / a->w[i] : c[i];
}

/* About the middle of the chord.  The centre is exact by definition; differences, squares, sum and root make
 * the radius err by 4 u scale, u = REAL_EPSILON / 2, beside the error of the control points themselves. */
static struct circle bounding_circle(const struct arc *a, real scale)
{
    int n = a->degree;
    const real half = (real)0.5;
    struct circle c = {(coordinate(a, a->x, 0) + coordinate(a, a->x, n)) * half,
                       (coordinate(a, a->y, 0) + coordinate(a, a->y, n)) * half, 0};
    for (int i = 0; i <= n; i++) {
        real dx = coordinate(a, a->x, i) - c.x, dy = coordinate(a, a->y, i) - c.y;
        c.radius = real_max(c.radius, real_sqrt(dx * dx + dy * dy));
    }
    c.radius = c.radius + 2 * a->error + 8 * REAL_EPSILON * scale;
    return c;
}

static bool circles_meet(const struct problem *p, const struct cell *c)
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    struct circle a = bounding_circle(&f, p->bounds.scale), b = bounding_circle(&g, p->bounds.scale);
    real dx = a.x - b.x, dy = a.y - b.y, reach = a.radius + b.radius;
    return dx * dx + dy * dy <= reach * reach * (1 + 8 * REAL_EPSILON);
}

/* 0: the cell holds no solution; HALVE: nothing is known yet.  An algorithm that narrows the intervals writes
 * them to piece[0] and returns 1: see bezier_clipping.c. */
static int shrink(const struct problem *p, const struct workspace *w, struct cell *c,
                  struct piece piece[PIECES_MAX])
{
    (void)w;
    (void)piece;
    return circles_meet(p, c) ? HALVE : 0;
}

static bool may_meet(const struct problem *p, const struct cell *c)
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    return arc_oriented_boxes_meet(&f, &g, p->bounds.scale);
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return solve_by_shrinking(p, w, out, shrink, may_meet, LONGER_ARC);
}

extern const struct intersector example;
const struct intersector example = {
    .name = "example",
    .summary = "halve while the bounding circles meet",
    .reference = "none: an example",
    .claimed = {1, 0, 0, 0},
    .intersect = intersect,
    .scratch = NULL,
    .points_only = false,
    .allocates = false,
};
