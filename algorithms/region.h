/* What the second part shares: control_family, region_problem, region, region_method, and the questions that
 * may be asked of a region.
 *
 * d = (x, y) is the free handle of a curve F(d; t); where F is regular with curvature of the sign asked for
 * on all of an interval I is an open convex set, the region of d (after E. I. Karousos). */
#ifndef FATLINE_REGION_H
#define FATLINE_REGION_H

#include "bezier.h"
#include "core/curve.h"

enum {
    REGION_RATIONAL_MAX = 17,   /* highest degree with weights: arcs have degree 2n - 2 */
    REGION_EDGES_MAX = 2048,    /* of a region */
    REGION_BREAKS_MAX = 2048,   /* of all spans together */
    REGION_STEPS_MAX = 1000000, /* the step limit unless the caller asks for another */
};

/* A B-spline curve of count control points (x[j], y[j]) with weights weight[j] > 0 (NULL: all 1), knots[0 ..
 * count + degree] as in core/spline.h, and what moves with the handle d: control point j is at
 * P_j + share[j] (d - at), so that d = at is the present curve.  2 <= degree <= 32. */
struct control_family {
    int degree, count;
    const real *knots, *x, *y, *weight;
    const real *share;
    struct point at;
};

/* The three handles: they fill share[0 .. count - 1] and set f->share and f->at; the rest of f is given.
 * family_of_point: d is control point i.
 * family_of_group: the named control points move as one body; d is the first of them.
 * family_of_drag: d is the curve point at t, knots[degree] <= t <= knots[count]; control point j takes the
 * share R_j(t) / sum of R_k(t)^2 of the drag, R the (rational) basis: the least motion of all that takes the
 * curve point there (R. Bartels, J. Beatty, A technique for the direct manipulation of spline curves, 1989).
 */
void family_of_point(struct control_family *f, int i, real *share);
void family_of_group(struct control_family *f, int members, const int *member, real *share);
void family_of_drag(struct control_family *f, real t, real *share);

/* Where may d go?  interval lies in [knots[degree], knots[count]]; sign is +1 or -1.  loop_free: besides, the
 * tangent turns by less than pi over the interval.  tolerance: of region_cutting, as a part of the size of
 * the curve, and of areas and discs; 0: as fine as the arithmetic allows (region_cutting: 2^-20). */
struct region_problem {
    struct control_family family;
    struct interval interval;
    int sign;
    bool loop_free;
    real tolerance;
    int max_steps;
};

/* Of the open region: EMPTY, BOUNDED, UNBOUNDED, PLANE.  Of what the closed conditions h_t(d) >= 0 allow, all
 * but that no edge of a region is infinitely far: what is farther than 2^10 sizes of the curve counts as so.
 */
enum region_kind {
    REGION_EMPTY,
    REGION_POINT,
    REGION_SEGMENT,
    REGION_RAY,
    REGION_LINE,
    REGION_BOUNDED,
    REGION_UNBOUNDED,
    REGION_PLANE
};

/* EDGE_LINE: on the member line of parameter t.  EDGE_ARC: on the envelope, from parameter t to t1.
 * EDGE_CHORD: on the line that keeps the direction at t less than pi from that at the start of the interval.
 */
enum edge_type { EDGE_LINE, EDGE_ARC, EDGE_CHORD };

/* Edges run with the region on their left.  line: (A, B, C) with A^2 + B^2 = 1, inside positive, of a line
 * and of the arc's tangent at t.  from, to: meaningless where an end is at infinity. */
struct region_edge {
    enum edge_type type;
    int span; /* number of the knot span, of those that meet the interval */
    real t, t1;
    real line[3];
    struct point from, to;
    bool from_infinity, to_infinity;
};

struct region {
    enum region_kind kind, closed_kind;
    bool strict; /* false: at an end of the interval, or (then kind is REGION_EMPTY) inside it, det(F', F'')
                    is 0 for every d, or the curve stands still */
    bool certified; /* region_solve says what that means */
    int count;
    real area;                /* of a bounded region */
    struct point disc_centre; /* of a largest disc in it */
    real disc_radius;
    struct point
        closed[2]; /* point; ends of the segment; end of the ray and a point on it; two of the line */
    struct region_edge edge[REGION_EDGES_MAX]; /* counter-clockwise */
};

/* Reasons are added: a parameter may be a root of several. */
enum break_reason { BREAK_END = 1, BREAK_KNOT = 2, BREAK_M = 4, BREAK_N = 8, BREAK_A = 16, BREAK_B = 32 };

struct region_break {
    int span;
    real t;
    int reasons;
    int type;       /* of the segment of the envelope that follows: +1 (S+), -1 (S-), 0 (a point, or none) */
    double turning; /* of its tangent, in degrees, positive counter-clockwise */
};

struct region_breaks {
    int count;
    struct region_break at[REGION_BREAKS_MAX]; /* each span from its start to its end, both among them */
};

struct region_work; /* algorithms/curvature/work.h */

/* The caller's memory, reused, never grown.  steps: of the last call. */
struct region_workspace {
    int degree, spans, steps;
    struct region_work *work;
};

struct region_method {
    const char *name;      /* as typed and as tabulated */
    const char *summary;   /* one line */
    const char *reference; /* author, title, year */
    /* The problem is prepared in w.  Call through region_solve. */
    enum outcome (*find)(const struct region_problem *p, struct region_workspace *w, struct region *out);
};

extern const struct region_method *const region_methods[]; /* NULL-terminated, in the order of list.h */
extern const struct region_method
    *const region_controls[]; /* deliberate mistakes, found by their names only */
const struct region_method *region_method_find(const char *name); /* in either table; NULL if there is none */

/* Bytes for curves of degree <= degree with at most `spans` knot spans in the interval. */
size_t region_workspace_size(int degree, int spans);
/* Lays w out in `memory`, aligned as malloc aligns. */
void region_workspace_init(struct region_workspace *w, void *memory, int degree, int spans);

/* NULL, or what is wrong with p, and in *field of what: "degree", "knots", "points", "weights", "free",
 * "interval", "sign", "tolerance". */
const char *region_problem_check(const struct region_problem *p, const char **field);

/* Makes what all questions below need: the half-planes h_t(d) > 0 span by span in Bernstein form, in
 * coordinates moved to the curve and scaled by a power of two.  SOLVED, INVALID, UNSUPPORTED or OUT_OF_ROOM.
 */
enum outcome region_prepare(const struct region_problem *p, struct region_workspace *w);

/* Prepares p and solves it.  Where the result is certified it has been verified after the fact, up to
 * rounding: every edge lies on a member line or on the envelope, the edges close up, and every vertex and
 * every arc fulfils all of the closed conditions; so the region is what the edges surround.  An empty region
 * is certified where finitely many member half-planes have no common point, with room to spare. */
enum outcome region_solve(const struct region_problem *p, const struct region_method *method,
                          struct region_workspace *w, struct region *out);

/* After region_prepare (or region_solve): breaks and segments of the envelope. */
enum outcome region_breaks_find(const struct region_problem *p, struct region_workspace *w,
                                struct region_breaks *out);

/* After region_prepare: is the disc of radius `margin` >= 0 about d inside the region?  Proved by the signs
 * of Bernstein coefficients; SIDE_BOUNDARY: nearer to the boundary than rounding can tell. */
enum side { SIDE_OUTSIDE, SIDE_BOUNDARY, SIDE_INSIDE };
enum side region_contains(const struct region_problem *p, struct region_workspace *w, struct point d,
                          real margin);

/* Of a region found by region_solve, w being its workspace: the distance of d to the boundary, positive
 * inside (REAL_HUGE for the plane), and the nearest point of the closed region (d itself inside it).  Both
 * are to rounding for lines, to the tolerance of the problem for arcs.  Of an empty region: -REAL_HUGE, and
 * d. */
real region_distance(const struct region_problem *p, struct region_workspace *w, const struct region *r,
                     struct point d);
struct point region_nearest(const struct region_problem *p, struct region_workspace *w,
                            const struct region *r, struct point d);

/* A family whose basis is no polynomial: all that is asked of its half-planes is a value and a bound. */
struct region_functions {
    void *data;
    /* (A, B, C) at t: d = (x, y) is allowed where A x + B y + C > 0. */
    void (*line)(void *data, real t, real *out);
    /* At least the second derivatives of A, B and C in absolute value, anywhere in [lo, hi]. */
    void (*bend)(void *data, real lo, real hi, real *out);
    struct point centre; /* where the curve is, and half its size: for coordinates near 1 */
    real size;
    struct interval interval;
    real tolerance; /* as in region_problem, > 0 */
    int max_steps;  /* values of half-planes */
};

/* region_cutting for such a family: a polygon that holds the region, none of whose points misses a half-plane
 * by more than the tolerance; certified says whether that is proved.  Rounding of what `line` returns is not
 * known here: the tolerance should be well above it.  w was laid out for any degree and one span or more.
 * SOLVED, INVALID, OUT_OF_STEPS or OUT_OF_ROOM. */
enum outcome region_cut_functions(const struct region_functions *f, struct region_workspace *w,
                                  struct region *out);

const char *region_kind_name(enum region_kind kind); /* "empty", "point", ... */
const char *edge_type_name(enum edge_type type);     /* "line", "arc", "chord" */

#endif
