/* What the files of the certified algorithm share.
 *
 * A *level* is a pair of curves over a part of the problem's parameters: level 0 is the problem itself; a
 * deeper one is a small part of it, cut with twice the digits, moved to the origin and enlarged (zoom.c), so
 * that rounding is small against that part.  A curve of a level is a *source*; it is halved into a binary
 * tree of *nodes*; a *pair* of nodes waits on a stack until it is *closed*: every solution in it is in some
 * record.
 *
 * "Local" parameters are those of a level, [0, 1]; "own" ones those of a node, [0, 1] too.  u = REAL_EPSILON
 * / 2. */
#ifndef FATLINE_CERTIFIED_H
#define FATLINE_CERTIFIED_H

#include "../../bezier.h"
#include "../../crossings.h"

enum {
    LEVELS_MAX = 4,
    NODES_MAX = 256, /* of each curve at a time */
    PAIRS_MAX = 1024,
    SOLVED_MAX = 64,
    RINGS_MAX = 8
};

/* A curve of a level.  A point of the exact curve is its exact point at the same parameter.  Errors hold for
 * each Euclidean coordinate. */
struct source {
    int n;
    bool rational;
    const real *points; /* homogeneous: x[0..n], y[0..n], and if rational w[0..n] */
    const real *low; /* of a polynomial curve of a level above 0: points + low err by fine_error; else NULL */
    real fine_error;
    real *value;      /* the same times C(n, i) */
    real *slope;      /* of the derivative: n (c[i+1] - c[i]) C(n-1, i), n for each component */
    real error;       /* of points */
    real node_error;  /* of the points of a node */
    real noise;       /* of source_at, point: for parameters in [0, 1] */
    real slope_noise; /* of source_at, derivative */
};

/* The part of a source over [lo, hi].  Directions: f' = pace (convex combination of the directions) by the
 * own parameter, pace in [pace_lo, pace_hi]; those of a polynomial curve are its control differences with
 * pace = n, those of a rational one the Bernstein coefficients of (X'W - XW', Y'W - YW') / n with pace = n /
 * W^2. */
struct node {
    real lo, hi;
    real low[4], high[4]; /* of x, y, x + y, x - y: the exact arc lies between */
    real *points;         /* homogeneous, as in the source */
    int ways;             /* number of directions */
    real *way;            /* x[0..ways-1], y[0..ways-1] */
    real error;           /* of a coordinate of a direction */
    real speed;           /* no exact direction is longer in the 1-norm */
    real bend;            /* no coordinate of f'' is larger, by the own parameter */
    real pace_lo, pace_hi;
    int child;  /* the first of two halves, the other is next to it; 0: none yet */
    int halved; /* midpoint halvings since the last cut from the source */
    bool ready; /* what follows `points` is made */
    bool wide;  /* some directions may point back along the chord */
};

/* The nodes of one curve: a pool with a free list of sibling pairs. */
struct tree {
    int used;   /* so many have been in use */
    int spare;  /* first of a free pair of siblings, linked by child; 0: none */
    int stride; /* numbers of a node: points, then directions */
    real *numbers;
    struct node *node;
};

struct level {
    struct source f, g;
    struct interval t, s; /* of the problem's parameters */
    real factor;          /* coordinates of the problem times this */
    real scale;           /* max |coordinate| of both, at least 1 */
    /* Of a level above 0: the record it stands for if it takes too long, how many records (-1: not begun),
     * pairs and solved rectangles there were before it, and steps left. */
    struct crossing otherwise;
    int records, pairs, solved, steps;
};

struct pair {
    int f, g;
    int level;
    int rest; /* splits to wait before another look for contacts */
};

/* Parameters of the problem; every solution inside has been reported. level: while pairs of this level wait,
 * it is not so for them; 0: none do. */
struct rectangle {
    struct interval t, s;
    int level;
};

/* Parameters of the problem; every solution within is in the core. */
struct ring {
    struct interval t, s, core_t, core_s;
};

struct solver {
    const struct problem *p;
    struct workspace *w;
    struct crossings *out;
    enum outcome outcome;
    struct tree f, g;
    int levels, pairs, solved;
    struct level level[LEVELS_MAX];
    real *level_numbers;
    size_t level_stride;
    struct pair *pair;
    struct rectangle solved_at[SOLVED_MAX];
    int root_f, root_g;
    int next_look; /* steps before overlaps are looked for (again) */
    int overlap_looks;
    bool turns;              /* an overlap has a cusp */
    real wider;              /* times the uncertainty of ends of overlaps at cusps */
    int suspicions;          /* so often a gap was no more than rounding */
    bool alone;              /* shared arcs are not looked for: loops.c */
    int looks;               /* closer looks at pairs that would be candidates */
    int rings;               /* so many there were; the last RINGS_MAX are kept */
    real narrow_t, narrow_s; /* what no proof settles is halved down to this */
    struct ring ring[RINGS_MAX];
};

/* CLOSED: every solution of the pair is in some record.  OPEN: nothing is known. */
enum verdict { OPEN, CLOSED };

/* ---- certified.c ---- */

/* Settles the pairs of nodes of level 0 that begin_with pushes, which all solutions asked for lie in; it is
 * given `rest`. */
enum outcome certified_search(const struct problem *p, struct workspace *w, struct crossings *out,
                              void (*begin_with)(struct solver *z, const struct rest *rest),
                              const struct rest *rest);
size_t certified_scratch(int n, int m);

/* ---- nodes.c ---- */

/* Makes the derived fields of c from n, rational, points, error; numbers: source_length(n) of them. */
void source_init(struct source *c, real scale, real *numbers);
size_t source_length(int n);
/* Cuts `to` from c over [lo, hi]; to->points and to->way are the caller's. */
void node_cut(const struct source *c, real lo, real hi, struct node *to);
/* The whole of c; to->points are c's own. */
void node_root(const struct source *c, struct node *to);
/* Directions and what depends on them; each node once. */
void node_prepare(const struct source *c, struct node *to);
int node_new(struct tree *tree); /* first of two siblings; 0: no memory */
/* The first half of node k, or 0 if there is no memory; it may have been made before. */
int node_split(struct tree *tree, const struct source *c, int k);
/* Frees all nodes that no waiting pair needs, but the roots. */
void nodes_collect(struct solver *z);

static inline bool nodes_meet(const struct node *a, const struct node *b)
{
    return !((a->low[0] > b->high[0]) | (b->low[0] > a->high[0]) | (a->low[1] > b->high[1]) |
             (b->low[1] > a->high[1]) | (a->low[2] > b->high[2]) | (b->low[2] > a->high[2]) |
             (a->low[3] > b->high[3]) | (b->low[3] > a->high[3]));
}

/* ---- cone.c ---- */

/* c > 0: the cross products of every exact direction of f with every one of g have the same sign, and none is
 * smaller than c; 0: that is not proved. */
real cone_gap(const struct node *f, const struct node *g);

/* ---- solve_one.c ---- */

/* Local parameters of a zero of the pair of nodes, extended linearly past their ends: it is within rt, rs. */
struct zero {
    real t, s, rt, rs;
};

/* For nodes with cone_gap c > 0.  NO_ZERO: the extended zero is outside the nodes. */
enum search { STUCK, NO_ZERO, ZERO };
enum search solve_one(const struct level *v, const struct node *f, const struct node *g, real c,
                      struct zero *out);

/* ---- ends.c ---- */

/* Settles a pair with cone_gap > 0 and the given zero. */
enum verdict zero_settle(struct solver *z, int level, const struct node *f, const struct node *g,
                         const struct zero *x);
/* Of two records that hold one zero each, and are proved to hold the same, the narrower stays. */
void zeros_unite(struct solver *z);
/* Looks for a single zero in (x->t +- wt) x (x->s +- ws), local parameters.  ZERO: there is one, at *found,
 * and it has been reported.  NO_ZERO: there is none.  STUCK: nothing is proved.  Smaller rectangles are tried
 * in turn, but all more than twice as large as x's own. */
enum search zero_prove(struct solver *z, int level, const struct zero *x, real wt, real ws,
                       struct zero *found);
/* Every solution of the pair lies in the region x, at most `at_most` with multiplicity, or just one zero of
 * the extended pair if it exists: a look closer, or a CLUSTER. */
enum verdict region_settle(struct solver *z, int level, const struct node *f, const struct node *g,
                           const struct zero *x, int at_most, bool exists);
/* The same where there are at most so many in the region of the curves, beyond the nodes and the level too.
 */
enum verdict region_settle_all(struct solver *z, int level, const struct zero *x, int at_most);
/* Only by a closer look; OPEN: there is none to be had, or no need. */
enum verdict region_look_all(struct solver *z, int level, const struct zero *x, int at_most);

/* Does the region, cut off at the ends of the domain, lie within the nodes? */
bool region_is_whole(const struct solver *z, int level, const struct node *f, const struct node *g,
                     const struct zero *x);
/* The record of a region that is whole, without a closer look. */
void region_record(struct solver *z, int level, const struct zero *x, int at_most, bool exists);

/* Does what of the region is in the domain lie in a solved rectangle? */
bool region_is_solved(const struct solver *z, int level, const struct zero *x);
/* The same where nothing is proved: OPEN if there is no closer look to be had. */
enum verdict region_look(struct solver *z, int level, const struct zero *x);

/* All solutions of the region are settled, by records or levels that this step has made. */
void region_solved(struct solver *z, int level, const struct zero *x);
/* The parameters of a part of the region, in the level; false: there are none. */
bool region_inner(const struct level *v, const struct zero *x, struct interval *t, struct interval *s);

/* ---- rings.c ---- */

/* All solutions of the region `clear` are in `core`; NULL: there are none.  more: there is more than cusps in
 * the core. */
void ring_add(struct solver *z, int level, const struct zero *clear, const struct zero *core, bool more);
/* Is the rectangle in a ring, but not in its core? */
bool is_in_ring(const struct solver *z, const struct interval *t, const struct interval *s);
/* CANDIDATEs within a ring become what of its core is in them. */
void rings_part(struct solver *z);

/* ---- ends.c ---- */

/* From local parameters of a level to the problem's, rounded outwards. */
struct interval level_t(const struct level *v, real lo, real hi);
struct interval level_s(const struct level *v, real lo, real hi);
/* Does the rectangle lie in a solved one? */
bool is_solved(const struct solver *z, int level, const struct interval *t, const struct interval *s);
/* The rectangle of a level that was given up is no more than the record that stands for it. */
void solved_shrink(struct solver *z, int level, const struct crossing *to);
void solved_add(struct solver *z, const struct interval *t, const struct interval *s, int level);
/* Forgets those that were added when there had been `from` of them. */
void solved_forget(struct solver *z, int from);

/* ---- zoom.c ---- */

/* A level over the region x of level `from`, and some more around it, pushed as a pair; false if there is no
 * memory, or it would not be narrower by the factor `shorter` in one of the parameters.  otherwise: a record
 * that holds all solutions of the region, if what is found there takes too long. */
bool zoom(struct solver *z, int from, const struct zero *x, real shorter, const struct crossing *otherwise);
/* The next level, over t and s of the problem and some more; no pair.  False if it would tell nothing. */
bool level_around(struct solver *z, const struct interval *t, const struct interval *s);
/* Pairs of the last level took too many steps: they and what they found give way to the record `otherwise`.
 */
void level_give_up(struct solver *z);

/* ---- overlap.c ---- */

/* Looks for a shared arc: arcs that are apart by rounding, times 2^looser; true: one was added to the
 * records. */
bool overlap_find(struct solver *z, int looser);
/* Cusps of shared arcs become less certain, overlap_ends.c; false: none was seen, or they are uncertain
 * enough. */
bool overlap_widen(struct solver *z);

/* ---- point.c ---- */

/* If one of the curves is a point, settles all; else false. */
bool point_settle(struct solver *z);

/* ---- stack.c ---- */

/* Adds c; a CANDIDATE wider than asked means that the problem is not SOLVED. */
void record_add(struct solver *z, const struct crossing *c);
/* Clusters and candidates within another cluster say nothing new: it holds all solutions in its rectangle.
 * Nor does a solution's record around another one. */
void records_tidy(struct solver *z);
/* Where there is no room, the pair becomes a record. */
void pair_push(struct solver *z, int level, int f, int g, int rest);
/* The nodes over t and s of level 0 as a pair, cut from the originals, if their octagons meet. */
void pair_push_rectangle(struct solver *z, const struct interval *t, const struct interval *s);
/* Pushes what of the pair lies in the region instead of it; OPEN: there is no memory. */
enum verdict pair_narrow(struct solver *z, const struct pair *at, const struct zero *x);
/* Pushes what of the pair lies around the region instead of it; OPEN: there is no memory. */
enum verdict pair_push_around(struct solver *z, const struct pair *at, const struct zero *x);
/* Halves the arc that is farther from straight; accepts the pair if neither needs it. */
void pair_split(struct solver *z, const struct pair *at);
/* The first split: both arcs in up to four parts, so that parts far from each other never wait.  false: no
 * memory. */
bool pair_split_root(struct solver *z, const struct pair *at);
/* The pair as a CANDIDATE; in a level that stands for something better, that instead. */
void pair_accept(struct solver *z, const struct pair *at);
/* As narrow as need be? */
bool narrow_t(const struct solver *z, const struct level *v, const struct node *f);
bool narrow_s(const struct solver *z, const struct level *v, const struct node *g);

#endif
