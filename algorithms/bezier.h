/* What algorithms and harness share: curve, problem, crossings, intersector.
 *
 * t belongs to f and s to g, here and in every file and row. */
#ifndef FATLINE_BEZIER_H
#define FATLINE_BEZIER_H

#include <stdbool.h>
#include <stddef.h>

#include "core/interval.h"
#include "core/real.h"

enum {
    DEGREE_MAX = 32,
    CROSSINGS_MAX = 2048,
    OVERLAPS_MAX = 16,
    WORKSPACE_ROOM = 512, /* cells that may wait at once, unless the caller asks for more */
    STEPS_MAX = 100000    /* the step limit unless the caller asks for another */
};

/* A planar Bezier curve over `domain`: homogeneous Bernstein coefficients x[i] = w_i X_i, y[i] = w_i Y_i,
 * w[i] = w_i > 0 for control points (X_i, Y_i), i = 0..degree, 1 <= degree <= DEGREE_MAX.
 * Polynomial curves have w == NULL.  The arrays are the caller's. */
struct curve {
    int degree;
    const real *x, *y, *w;
    struct interval domain;
};

/* Made once for each problem by problem_solve; algorithms read them.  Both curves are then scaled by one
 * power of two so that 1 <= scale < 2. */
struct bounds {
    real scale; /* max |coordinate| of the Euclidean control points of both curves; 0 if all are the origin */
    real f, g;  /* every control point that a cell carries for f (for g) differs from the exact one over the
                   cell's interval by at most this in each Euclidean coordinate: see core/cells.h */
    real tolerance_t, tolerance_s; /* widths asked for in local parameters, 4 REAL_EPSILON to 1/16 */
};

/* The first three digits of a root, in parameters that run from 0 to 1 over each curve's domain. */
struct known {
    real t, s;
};

/* What a front leaves to `intersect`: every solution lies in a record or in one of these rectangles, t and s
 * of the prepared problem. */
enum { REST_MAX = 32 };
struct rest {
    int count;
    struct {
        struct interval t, s;
    } at[REST_MAX];
};

/* Where does f(t) = g(s)? */
struct problem {
    struct curve f, g;
    real tolerance;            /* width asked for, in both parameters */
    int max_steps;             /* > 0 */
    struct bounds bounds;      /* of the prepared problem; callers leave it zero */
    const struct known *known; /* what `floor` is told; else NULL.  t of the f that the caller gave */
    int known_count;
    bool swapped;    /* of the prepared problem: f and g are exchanged */
    bool keep_order; /* the curves are not exchanged: for who measures single steps */
    /* Of the prepared problem: what the intersector's front left, in the same order of the curves, beside the
     * records that are there already; NULL: nothing has been done. */
    const struct rest *rest;
};

/* CANDIDATE: could not be excluded.  UNIQUE: holds exactly one solution, proved.
 * END: exactly one zero of the pair extended past its ends, within its radius of an end of a domain.
 * CLUSTER: holds at most at_most solutions with multiplicity, proved; not told apart. */
enum standing { CANDIDATE, UNIQUE, END, CLUSTER };

struct crossing {
    struct interval t, s;
    enum standing standing;
    int at_most, multiplicity; /* 0: not decided */
};

/* Every solution with t in t_outer lies here; over t_inner the curves stay within distance.
 * exact: decided over the rationals. */
struct overlap {
    struct interval t_outer, t_inner, s_outer, s_inner;
    bool reversed, exact;
    real distance;
};

/* Every solution (t, s) lies in some crossing or overlap; a CANDIDATE may hold none.
 * When full, candidates are merged: coverage is never given up. */
struct crossings {
    int count, overlaps;
    bool merged; /* something was merged for want of room */
    struct crossing at[CROSSINGS_MAX];
    struct overlap overlap[OVERLAPS_MAX];
};

/* SOLVED: every record is as narrow as asked and the precision allows (struct bounds), or carries its own
 * proof.
 * OUT_OF_STEPS, OUT_OF_ROOM: stopped early; what is undecided is among the records, wider than asked.
 * OUT_OF_STEPS also, with steps left: rounding hides what certified would have to see for a narrower
 * CANDIDATE.
 * UNSUPPORTED: this algorithm does not take this problem (in this precision); no records.
 * INVALID: the problem is not one (degree, weights that are not positive or differ by more than 2^256,
 * tolerance, a value that is not finite); no records.
 * GAVE_UP: other people's code says that it failed; CRASHED, TIMED_OUT: it had to be ended; no records. */
enum outcome { SOLVED, OUT_OF_STEPS, OUT_OF_ROOM, UNSUPPORTED, INVALID, GAVE_UP, CRASHED, TIMED_OUT };

/* Two pieces that may still meet: f over t, g over s (local parameters, in [0, 1]).  Their homogeneous
 * control points lie in the workspace: x[0..n], y[0..n] and, if the curve is rational, w[0..n], one after the
 * other. */
struct cell {
    struct interval t, s;
    int depth;              /* splits since the root */
    int turn;               /* 0: f is to be clipped next, 1: g; for algorithms that alternate */
    int halved_f, halved_g; /* midpoint halvings since the last cut from the original (core/cells.h) */
    bool proved;            /* holds exactly one solution; for algorithms that prove it */
    real *f, *g;
};

enum event { SHRUNK, SPLIT, DISCARDED, ACCEPTED };

/* Memory of one solve: the caller's, reused, never grown.  workspace_init lays it out for curves of
 * degree <= n and <= m; used and steps are set by each solve. */
struct workspace {
    int room, used, steps;
    struct cell *cell;
    real *pool;     /* control points of the cells; each solve lays it out by its own degrees */
    real *prepared; /* scaled copies of both curves */
    real *scratch;  /* intersector.scratch(n, m) numbers, for algorithms that ask for them */
    size_t scratch_length;
    /* What scratch holds: true if the last solve was by the same algorithm for the same degrees, so that
     * tables which depend on nothing else need not be made again. */
    bool planned;
    const struct intersector *plan;
    int plan_n, plan_m;
    /* Called in the watched build only: what happened to a cell; whether one just taken from the stack is to
     * be dropped, for who watches a single solution. */
    void (*watch)(void *log, enum event, const struct cell *);
    bool (*ignore)(void *log, const struct cell *);
    void *log;
    bool swapped; /* in the last solve a cell's f was the problem's g */
};

/* Order of convergence per round claimed by the reference at contact 1, 2, 3 and at a cusp; 0: none. */
struct order {
    double contact_1, contact_2, contact_3, cusp;
};

struct foreign; /* peers/foreign.h */

/* FRONT_REFUSED: nothing has been done.  FRONT_DONE: the records are the answer, as problem_solve gives it.
 * FRONT_LEFT: `rest` holds what is open; records are those of the prepared problem, in its order of the
 * curves. */
enum front_answer { FRONT_REFUSED, FRONT_DONE, FRONT_LEFT };

struct intersector {
    const char *name;      /* as typed and as tabulated */
    const char *summary;   /* one line for `fatline list` */
    const char *reference; /* author, title, year */
    struct order claimed;
    /* p is prepared: curves over [0, 1], scaled, bounds filled in.  Call through problem_solve. */
    enum outcome (*intersect)(const struct problem *p, struct workspace *w, struct crossings *out);
    size_t (*scratch)(int n, int m); /* numbers of scratch memory needed; NULL: none */
    bool points_only; /* answers are points with a guessed width, without a proof that none is missing */
    bool allocates;   /* in a call: allowed in peers/ only */
    const struct foreign *foreign; /* other people's code; NULL: ours */
    /* Tries the problem as the caller gave it, before it is validated and copied; NULL: there is none. */
    enum front_answer (*front)(const struct problem *p, struct workspace *w, struct crossings *out,
                               struct rest *rest);
};

/* The registry: NULL-terminated, in the order of list.h.  peers[] are other people's algorithms, those that
 * are absent too (UNSUPPORTED whatever the problem); intersector_variants[] are algorithms without some of
 * their kernels, and controls[] deliberate mistakes, negative controls for the tests: both are found by their
 * exact names only.  intersector_floor is the yardstick, floor.c. */
extern const struct intersector *const intersectors[];
extern const struct intersector *const peers[];
extern const struct intersector *const intersector_floor;
extern const struct intersector *const intersector_variants[];
extern const struct intersector *const controls[];
extern const struct intersector *const intersector_default;   /* for whoever asks for none by name */
const struct intersector *intersector_find(const char *name); /* in any table; NULL if there is none */

/* Bytes for curves of degree <= n, <= m, `room` waiting cells and `scratch` numbers. */
size_t workspace_size(int n, int m, int room, size_t scratch);
/* Lays w out in `memory` (aligned as malloc aligns, at least workspace_size bytes); room >= 1. */
void workspace_init(struct workspace *w, void *memory, int n, int m, int room, size_t scratch);

/* Solves p by a: validates, scales by a power of two, puts the two curves in a canonical order (so that
 * swapping f and g gives the same bits), calls a->intersect, undoes all that, sorts by (t.lo, s.lo). Records
 * are in the curves' own parameters; where a domain is not [0, 1] the map is rounded outwards. No allocation,
 * no static state: thread-safe if p, w and out are not shared. */
enum outcome problem_solve(const struct problem *p, const struct intersector *a, struct workspace *w,
                           struct crossings *out);

const char *outcome_name(enum outcome);   /* "SOLVED", ... */
const char *standing_name(enum standing); /* "CANDIDATE", ... */

#endif
