/* Two nodes as graphs y(x) over one direction (contact.c, cluster.c, overlap.c). */
#ifndef FATLINE_CERTIFIED_GRAPHS_H
#define FATLINE_CERTIFIED_GRAPHS_H

#include "evaluate.h"

/* x is along (ex, ey), of length 1 to rounding, y across.  x' > 0 on f, and on g times sign. */
struct graphs {
    real ex, ey, sign;
    struct interval run_f, run_g;     /* |x'| by the local parameter */
    struct interval curve_f, curve_g; /* y'' by x */
    real bend;                        /* max |y''| */
    struct interval x_f, x_g, x;      /* x at the ends; x: in common */
    real x_error;                     /* of those */
    bool apart;                       /* there is no x in common */
};

/* false if they are no graphs over one direction, or turn too much */
bool graphs_init(const struct level *v, const struct node *f, const struct node *g, struct graphs *out);

/* Where the common abscissas are, with `pad` more at each end: all solutions are there. */
void graphs_common(const struct node *f, const struct node *g, const struct graphs *h, real pad,
                   struct zero *out);

/* True only if a strip along one arc's chord keeps it apart from the other. */
bool strips_apart(const struct level *v, const struct node *f, const struct node *g);

/* The gap y_f - y_g at x, the x of f(t), its slope by x there, and their errors; hx: x of f(t) less that of
 * g(s). t, s: within the nodes. */
struct gap_view {
    real t, s, x, hx, run_f, run_g;
    real gap, slope, gap_error, slope_error, noise;
};
void gap_look(const struct level *v, const struct graphs *h, real t, real s, struct gap_view *out);

/* Parameters where both arcs are near abscissa x; those that Newton's method gives next, from a view; and is
 * hx so small that it adds no more than an eighth of the noise? */
void gap_start(const struct node *f, const struct node *g, const struct graphs *h, real x, real *t, real *s);
void gap_step(const struct node *f, const struct node *g, real x, const struct gap_view *from, real *t,
              real *s);
bool gap_is_level(const struct graphs *h, const struct gap_view *at);
/* The view at abscissa x; false if Newton's method does not get there. */
bool gap_look_at(const struct level *v, const struct node *f, const struct node *g, const struct graphs *h,
                 real x, struct gap_view *out);

/* Bernstein coefficients, degree 2 ways - 4, of cross(N, N') / (ways - 1), N the polynomial of the
 * directions. */
void direction_turn(const struct node *a, real *out);

enum verdict contact_settle(struct solver *z, int level, const struct node *f, const struct node *g,
                            const struct graphs *h);
/* most: clusters of more are not worth it, and the pair stays open. */
enum verdict cluster_settle(struct solver *z, const struct pair *at, int most);
enum verdict cusps_settle(struct solver *z, const struct pair *at);
/* Are all solutions of the pair in the rectangle of an overlap, on its arc? */
bool overlap_holds(const struct solver *z, int level, const struct node *f, const struct node *g,
                   const struct graphs *h);
/* Is the rectangle, in the problem's parameters, in that of an overlap, at a cusp of both curves?
 * (overlap_ends.c) */
bool overlap_turns(struct solver *z, const struct interval *t, const struct interval *s);

#endif
