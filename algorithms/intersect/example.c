/* The smallest complete algorithm, to copy: halve while the bounding circles meet.
 *
 * It is built and tested with the others, but not listed.  Yours: give the file, its entry and its name
 * another name, write your own shrink, and add INTERSECTOR(your_name) to algorithms/list.h. */
#include "../core/cells.h"

struct circle {
    real x, y, radius;
};

/* About the first control point.  Every operation here errs by at most a few u = REAL_EPSILON / 2 of the
 * scale: differences and radius 6 u together, beside the error of the control points themselves. */
static struct circle bounding_circle(const struct arc *a, real scale)
{
    struct circle c = {a->x[0], a->y[0], 0};
    if (a->w) {
        c.x = c.x / a->w[0];
        c.y = c.y / a->w[0];
    }
    for (int i = 1; i <= a->degree; i++) {
        real x = a->w ? a->x[i] / a->w[i] : a->x[i], y = a->w ? a->y[i] / a->w[i] : a->y[i];
        real dx = x - c.x, dy = y - c.y;
        c.radius = real_max(c.radius, real_sqrt(dx * dx + dy * dy));
    }
    c.radius = c.radius + 4 * a->error + 8 * REAL_EPSILON * scale;
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

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return solve_by_shrinking(p, w, out, shrink, circles_meet, LONGER_ARC);
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
