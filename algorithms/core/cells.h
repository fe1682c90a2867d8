/* The loop that every cell algorithm shares: take a cell, shrink it, discard, accept or halve it.
 *
 * A cell is an exact pair of intervals with control points of f and g over them.  The points are cut from the
 * original curves (bernstein_restrict), or halved from the parent's at most HALVINGS_MAX times in a row and
 * only on dyadic intervals, whose midpoints are exact.  So their error never grows with the depth: it stays
 * below bounds.f and bounds.g (problem.c, cell_error).
 *
 * The one file of core/ that knows struct problem. */
#ifndef FATLINE_CELLS_H
#define FATLINE_CELLS_H

#include "../bezier.h"
#include "../crossings.h"
#include "arc.h"
#include "bernstein.h"

enum { HALVINGS_MAX = 4, NOT_DYADIC = HALVINGS_MAX, PIECES_MAX = 4 };

/* What becomes of a cell: 0 pieces, none of it can hold a solution; k pieces, all its solutions lie in them;
 * HALVE, the cell (its intervals may have been narrowed) is to be halved by the rule of the algorithm;
 * ACCEPT, it is a record as it is, proved to hold exactly one solution. */
enum { HALVE = -1, ACCEPT = -2 };

struct piece {
    struct interval t, s;
};

/* FOUR_WAY: both curves, four children, as the papers print it.  WIDER: the longer parameter interval.
 * LONGER_ARC: the larger extent of the control points. */
enum halving { FOUR_WAY, WIDER, LONGER_ARC };

#ifdef FATLINE_WATCHED
static inline void observe(const struct workspace *w, enum event e, const struct cell *c)
{
    if (w->watch) {
        w->watch(w->log, e, c);
    }
}
static inline bool is_ignored(const struct workspace *w, const struct cell *c)
{
    return w->ignore && w->ignore(w->log, c);
}
#else
#define observe(w, e, c) ((void)0)
#define is_ignored(w, c) false
#endif

static inline real interval_width(const struct interval *a)
{
    return a->hi - a->lo;
}

/* The part [lo, hi] of a in local parameters, rounded outwards: the width, the product and the sum err by u
 * each, relative to at most a->hi. */
static inline void interval_clip(struct interval *a, real lo, real hi)
{
    real width = a->hi - a->lo, pad = 2 * REAL_EPSILON * a->hi;
    real left = a->lo + width * lo - pad, right = a->lo + width * hi + pad;
    if (lo > 0 && left > a->lo) {
        a->lo = left;
    }
    if (hi < 1 && right < a->hi) {
        a->hi = right;
    }
}

static inline int curve_components(const struct curve *c)
{
    return c->w ? 3 : 2;
}

static inline struct arc arc_of(const struct curve *c, const real *points, real error)
{
    int length = c->degree + 1;
    struct arc a = {c->degree, points, points + length, c->w ? points + 2 * length : NULL, error};
    return a;
}

static inline struct arc cell_f(const struct problem *p, const struct cell *c)
{
    return arc_of(&p->f, c->f, p->bounds.f);
}

static inline struct arc cell_g(const struct problem *p, const struct cell *c)
{
    return arc_of(&p->g, c->g, p->bounds.g);
}

/* ---- control points of a cell ---- */

static inline void cell_cut_f(const struct problem *p, struct cell *c)
{
    bernstein_restrict(p->f.degree, curve_components(&p->f), p->f.x, c->t.lo, c->t.hi, c->f);
}

static inline void cell_cut_g(const struct problem *p, struct cell *c)
{
    bernstein_restrict(p->g.degree, curve_components(&p->g), p->g.x, c->s.lo, c->s.hi, c->g);
}

/* The new cell on top of the stack, a copy of c but for its own memory; control points are not copied. */
static inline struct cell *cell_push(const struct problem *p, struct workspace *w, const struct cell *c)
{
    int length_f = curve_components(&p->f) * (p->f.degree + 1);
    int length_g = curve_components(&p->g) * (p->g.degree + 1);
    struct cell *top = &w->cell[w->used];
    if (c) {
        *top = *c;
    }
    top->f = w->pool + (size_t)w->used * (size_t)(length_f + length_g);
    top->g = top->f + length_f;
    w->used++;
    return top;
}

static inline void copy_points(int length, const real *from, real *to)
{
    for (int i = 0; i < length; i++) {
        to[i] = from[i];
    }
}

static inline void cell_copy_f(const struct problem *p, const struct cell *from, struct cell *to)
{
    copy_points(curve_components(&p->f) * (p->f.degree + 1), from->f, to->f);
}

static inline void cell_copy_g(const struct problem *p, const struct cell *from, struct cell *to)
{
    copy_points(curve_components(&p->g) * (p->g.degree + 1), from->g, to->g);
}

/* Narrows c to a piece, cutting only what changed. */
static inline void cell_narrow(const struct problem *p, struct cell *c, const struct piece *piece)
{
    if (piece->t.lo != c->t.lo || piece->t.hi != c->t.hi) {
        c->t = piece->t;
        c->halved_f = NOT_DYADIC;
        cell_cut_f(p, c);
    }
    if (piece->s.lo != c->s.lo || piece->s.hi != c->s.hi) {
        c->s = piece->s;
        c->halved_g = NOT_DYADIC;
        cell_cut_g(p, c);
    }
}

/* Splits c's arc of f: upper keeps c's place in memory for the second half, lower (pushed from c) the first.
 */
static inline void cell_halve_f(const struct problem *p, struct cell *c, struct cell *lower)
{
    real middle = c->t.lo + (c->t.hi - c->t.lo) * (real)0.5;
    lower->t.hi = c->t.lo = middle;
    if (c->halved_f < HALVINGS_MAX) {
        real points[3 * (DEGREE_MAX + 1)];
        int components = curve_components(&p->f);
        copy_points(components * (p->f.degree + 1), c->f, points);
        bernstein_halve(p->f.degree, components, points, lower->f, c->f);
        lower->halved_f = ++c->halved_f;
        return;
    }
    cell_cut_f(p, lower);
    cell_cut_f(p, c);
}

static inline void cell_halve_g(const struct problem *p, struct cell *c, struct cell *lower)
{
    real middle = c->s.lo + (c->s.hi - c->s.lo) * (real)0.5;
    lower->s.hi = c->s.lo = middle;
    if (c->halved_g < HALVINGS_MAX) {
        real points[3 * (DEGREE_MAX + 1)];
        int components = curve_components(&p->g);
        copy_points(components * (p->g.degree + 1), c->g, points);
        bernstein_halve(p->g.degree, components, points, lower->g, c->g);
        lower->halved_g = ++c->halved_g;
        return;
    }
    cell_cut_g(p, lower);
    cell_cut_g(p, c);
}

/* By boxes along both arcs' chords: what is asked of a cell before it becomes a record. */
static inline bool cell_arcs_may_meet(const struct problem *p, const struct cell *c)
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    return arc_oriented_boxes_meet(&f, &g, p->bounds.scale);
}

/* ---- the stack ---- */

static inline bool cell_is_narrow(const struct problem *p, const struct cell *c)
{
    return interval_width(&c->t) <= p->bounds.tolerance_t && interval_width(&c->s) <= p->bounds.tolerance_s;
}

static inline void cell_accept(const struct workspace *w, const struct cell *c, struct crossings *out)
{
    struct crossing x = {c->t, c->s, c->proved ? UNIQUE : CANDIDATE, c->proved, c->proved};
    (void)w;
    observe(w, ACCEPTED, c);
    crossings_add(out, &x);
}

/* Which curves the rule halves; a curve that is narrow enough already is never halved. */
static inline void choose_halves(const struct problem *p, const struct cell *c, enum halving rule, bool *f,
                                 bool *g)
{
    *f = interval_width(&c->t) > p->bounds.tolerance_t;
    *g = interval_width(&c->s) > p->bounds.tolerance_s;
    if (!*f || !*g || rule == FOUR_WAY) {
        return;
    }
    if (rule == WIDER) {
        *f = interval_width(&c->t) >= interval_width(&c->s);
    } else {
        struct arc af = cell_f(p, c), ag = cell_g(p, c);
        *f = arc_extent(&af) >= arc_extent(&ag);
    }
    *g = !*f;
}

/* Replaces the top cell by its halves; children with smaller parameters come to lie on top. */
static inline void cell_halve(const struct problem *p, struct workspace *w, enum halving rule)
{
    struct cell *c = &w->cell[w->used - 1];
    bool f, g;
    choose_halves(p, c, rule, &f, &g);
    if (!f && !g) { /* shrink has made it narrow enough */
        observe(w, SHRUNK, c);
        return;
    }
    observe(w, SPLIT, c);
    c->depth++;
    c->proved = false;
    struct cell *lower = cell_push(p, w, c);
    if (f) {
        cell_halve_f(p, c, lower);
        cell_copy_g(p, c, lower);
    }
    if (!g) {
        return;
    }
    if (!f) {
        cell_copy_f(p, c, lower);
        cell_halve_g(p, c, lower);
        return;
    }
    struct cell *third = cell_push(p, w, c), *fourth = cell_push(p, w, lower);
    cell_copy_f(p, c, third);
    cell_copy_f(p, lower, fourth);
    cell_halve_g(p, c, third);
    lower->s = c->s;
    lower->halved_g = c->halved_g;
    cell_copy_g(p, c, lower);
    fourth->s = third->s;
    fourth->halved_g = third->halved_g;
    cell_copy_g(p, third, fourth);
}

/* Replaces the top cell by its pieces. */
static inline void cell_divide(const struct problem *p, struct workspace *w, int pieces,
                               const struct piece *piece)
{
    int at = w->used - 1;
    w->cell[at].proved = w->cell[at].proved && pieces == 1;
    for (int i = 1; i < pieces; i++) {
        struct cell *c = &w->cell[at], *copy = cell_push(p, w, c);
        cell_copy_f(p, c, copy);
        cell_copy_g(p, c, copy);
    }
    for (int i = 0; i < pieces; i++) {
        cell_narrow(p, &w->cell[at + i], &piece[pieces - 1 - i]);
        observe(w, SHRUNK, &w->cell[at + i]);
    }
}

typedef int shrink_function(const struct problem *p, const struct workspace *w, struct cell *c,
                            struct piece piece[PIECES_MAX]);
typedef bool may_meet_function(const struct problem *p, const struct cell *c);

/* Solves p: `shrink` narrows, `rule` halves, `may_meet` has the last word on a cell that is narrow enough.
 * Every solution lies in some record, whatever the outcome: a cell leaves the stack only if shrink or
 * may_meet proves it empty, or as a record. */
static inline enum outcome solve_by_shrinking(const struct problem *p, struct workspace *w,
                                              struct crossings *out, shrink_function *shrink,
                                              may_meet_function *may_meet, enum halving rule)
{
    enum outcome outcome = SOLVED;
    struct cell *root = cell_push(p, w, NULL);
    root->t.lo = root->s.lo = 0;
    root->t.hi = root->s.hi = 1;
    root->depth = root->turn = root->halved_f = root->halved_g = 0;
    root->proved = false;
    cell_cut_f(p, root);
    cell_cut_g(p, root);
    while (w->used > 0) {
        struct cell *c = &w->cell[w->used - 1];
        struct piece piece[PIECES_MAX];
        if (is_ignored(w, c)) {
            w->used--;
            continue;
        }
        if (w->steps >= p->max_steps) {
            for (; w->used > 0; w->used--) {
                cell_accept(w, &w->cell[w->used - 1], out);
            }
            return OUT_OF_STEPS;
        }
        w->steps++;
        if (cell_is_narrow(p, c)) {
            if (c->proved || may_meet(p, c)) {
                cell_accept(w, c, out);
            } else {
                observe(w, DISCARDED, c);
            }
            w->used--;
            continue;
        }
        int pieces = shrink(p, w, c, piece);
        if (pieces == 0) {
            observe(w, DISCARDED, c);
            w->used--;
        } else if (pieces == ACCEPT || w->used + PIECES_MAX > w->room) {
            outcome = pieces == ACCEPT ? outcome : OUT_OF_ROOM;
            cell_accept(w, c, out);
            w->used--;
        } else if (pieces == HALVE) {
            cell_halve(p, w, rule);
        } else {
            cell_divide(p, w, pieces, piece);
        }
    }
    return outcome;
}

/* The entry of the registry for degree k of a method, whose shrink(k, p, w, c, piece), solve(p, w, out, k,
 * step) and scratch(k, n, m) are functions of the file: the compiler sees which k.  What follows are the
 * orders claimed. */
#define CELL_METHOD(method, k_, summary_, reference_, ...)                                                   \
    static int shrink_##k_(const struct problem *p, const struct workspace *w, struct cell *c,               \
                           struct piece piece[PIECES_MAX])                                                   \
    {                                                                                                        \
        return shrink(k_, p, w, c, piece);                                                                   \
    }                                                                                                        \
    static enum outcome intersect_##k_(const struct problem *p, struct workspace *w, struct crossings *out)  \
    {                                                                                                        \
        return solve(p, w, out, k_, shrink_##k_);                                                            \
    }                                                                                                        \
    static size_t scratch_##k_(int n, int m)                                                                 \
    {                                                                                                        \
        return scratch(k_, n, m);                                                                            \
    }                                                                                                        \
    extern const struct intersector method##_##k_;                                                           \
    const struct intersector method##_##k_ = {                                                               \
        .name = #method "_" #k_,                                                                             \
        .summary = summary_,                                                                                 \
        .reference = reference_,                                                                             \
        .claimed = {__VA_ARGS__},                                                                            \
        .intersect = intersect_##k_,                                                                         \
        .scratch = scratch_##k_,                                                                             \
        .points_only = false,                                                                                \
    };

#endif
