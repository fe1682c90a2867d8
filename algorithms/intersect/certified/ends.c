/* Where a zero lies: inside, at an end of a domain, or at a cut between nodes.
 *
 * cone.c proves one zero of the *extended* nodes.  Well inside both nodes it is a solution, the only one
 * there: UNIQUE. Within its radius of an end of a domain it may be outside: END.  Within its radius of a cut
 * inside the domain it may belong to the neighbour, and its extension may not even be a zero of the curves;
 * so larger nodes are cut with the zero in their middle, and the test is made there.  The rectangle of these
 * nodes then holds this zero and no other: a neighbour that finds it again has its zero in that rectangle,
 * and adds nothing. */
#include "evaluate.h"

/* ---- parameters of the problem ---- */

/* A product and a sum of numbers that are not negative: less than 1.5 eps of the sum, up (1) or down (-1). */
static real rounded(const struct interval *span, real at, int up)
{
    real width = span->hi - span->lo, sum = span->lo + width * at;
    return width == 1 ? sum : sum * (1 + up * 2 * REAL_EPSILON); /* the whole: exact */
}

struct interval level_t(const struct level *v, real lo, real hi)
{
    struct interval out = {lo <= 0 ? v->t.lo : rounded(&v->t, lo, -1),
                           hi >= 1 ? v->t.hi : rounded(&v->t, hi, 1)};
    return out;
}

struct interval level_s(const struct level *v, real lo, real hi)
{
    struct interval out = {lo <= 0 ? v->s.lo : rounded(&v->s, lo, -1),
                           hi >= 1 ? v->s.hi : rounded(&v->s, hi, 1)};
    return out;
}

/* A part of it that surely lies within; lo > hi: none does. */
static struct interval level_inner(const struct interval *span, real lo, real hi)
{
    struct interval out = {lo <= 0 ? span->lo : rounded(span, lo, 1),
                           hi >= 1 ? span->hi : rounded(span, hi, -1)};
    return out;
}

static bool within(const struct interval *a, const struct interval *b)
{
    return b->lo <= a->lo && a->hi <= b->hi;
}

static bool overlap(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

static void cut_off(struct interval *a)
{
    a->lo = real_max(a->lo, (real)0);
    a->hi = real_min(a->hi, (real)1);
}

bool is_solved(const struct solver *z, int level, const struct interval *at, const struct interval *as)
{
    struct interval domain_t = *at, domain_s = *as, *t = &domain_t, *s = &domain_s;
    cut_off(t);
    cut_off(s);
    int count = z->solved < SOLVED_MAX ? z->solved : SOLVED_MAX;
    for (int i = 0; i < count; i++) {
        const struct rectangle *r = &z->solved_at[i];
        if ((r->level == 0 || level < r->level) && within(t, &r->t) && within(s, &r->s)) {
            return true;
        }
    }
    return false;
}

/* When there are too many, the oldest is forgotten: its solutions may then be found, and reported, again. */
void solved_add(struct solver *z, const struct interval *t, const struct interval *s, int level)
{
    struct rectangle *r = &z->solved_at[z->solved % SOLVED_MAX];
    r->t = *t;
    r->s = *s;
    r->level = level;
    z->solved++;
}

void solved_shrink(struct solver *z, int level, const struct crossing *to)
{
    for (int i = 0; i < z->solved && i < SOLVED_MAX; i++) {
        if (z->solved_at[i].level == level) {
            z->solved_at[i].t = to->t;
            z->solved_at[i].s = to->s;
        }
    }
}

void solved_forget(struct solver *z, int from)
{
    const struct rectangle nowhere = {{2, 2}, {2, 2}, 0};
    for (int i = z->solved > from + SOLVED_MAX ? z->solved - SOLVED_MAX : from; i < z->solved; i++) {
        z->solved_at[i % SOLVED_MAX] = nowhere;
    }
}

/* Is x near a cut inside the domain?  x, radius: local. */
static bool near_cut(const struct interval *span, const struct node *a, real x, real radius)
{
    bool first = a->lo == 0 && span->lo == 0, last = a->hi == 1 && span->hi == 1;
    return (!first && x - radius <= a->lo) || (!last && x + radius >= a->hi);
}

static bool near_end(const struct interval *a)
{
    return a->lo <= 0 || a->hi >= 1;
}

/* ---- one zero ---- */

/* Is the only zero within the nodes among the records already?  It is if some record lies within them. */
static bool is_reported(const struct solver *z, const struct interval *t, const struct interval *s)
{
    for (int i = 0; i < z->out->count; i++) {
        const struct crossing *c = &z->out->at[i];
        if ((c->standing == UNIQUE || c->standing == END) && within(&c->t, t) && within(&c->s, s)) {
            return true;
        }
    }
    return false;
}

/* x in the problem's parameters; not cut off at 0 and 1. */
static struct interval around(const struct interval *span, real x, real radius)
{
    real width = span->hi - span->lo, middle = span->lo + width * x, pad = width * radius;
    if (width != 1) {
        pad += 2 * REAL_EPSILON * real_abs(middle);
    }
    struct interval a = {middle - pad, middle + pad};
    return a;
}

/* Pairs of a deeper level wait: no closer look from this one before they are settled.  Who wants one leaves
 * the pair open; its halves are taken up after them. */
static bool is_busy(const struct solver *z, int level)
{
    return level + 1 < z->levels;
}

/* One zero, at x: a record, or if it is wider than asked for, a closer look.  Returns the level of that look,
 * or 0; LATER: nothing was done. */
enum { LATER = -1 };
static int report(struct solver *z, int level, const struct zero *x)
{
    const struct level *v = &z->level[level];
    const struct bounds *b = &z->p->bounds;
    struct interval t = around(&v->t, x->t, x->rt), s = around(&v->s, x->s, x->rs);
    struct crossing c = {t, s, near_end(&t) || near_end(&s) ? END : UNIQUE, 1, 1};
    if (c.standing == END) {
        c.multiplicity = 0;
    }
    cut_off(&c.t);
    cut_off(&c.s);
    if (c.t.lo > c.t.hi || c.s.lo > c.s.hi) {
        return 0; /* beyond the domain after all */
    }
    /* far from the origin, a closer look may tell more about an end although it is hardly narrower */
    const real shorter = c.standing == END ? (real)1 / 2 : (real)1 / 16;
    if (c.t.hi - c.t.lo > b->tolerance_t || c.s.hi - c.s.lo > b->tolerance_s) {
        if (is_busy(z, level)) {
            return LATER;
        }
        if (zoom(z, level, x, shorter, &c)) {
            return z->levels - 1;
        }
    }
    record_add(z, &c);
    return 0;
}

/* Nodes over (t +- wt) x (s +- ws), as far as the level goes; numbers: their memory. */
static inline void cut_around(const struct level *v, real t, real s, real wt, real ws,
                              real numbers[2][7 * DEGREE_MAX + 3], struct node *f, struct node *g)
{
    f->points = numbers[0];
    g->points = numbers[1];
    f->way = numbers[0] + (v->f.rational ? 3 : 2) * (v->f.n + 1);
    g->way = numbers[1] + (v->g.rational ? 3 : 2) * (v->g.n + 1);
    node_cut(&v->f, real_max(t - wt, (real)0), real_min(t + wt, (real)1), f);
    node_cut(&v->g, real_max(s - ws, (real)0), real_min(s + ws, (real)1), g);
}

/* Such nodes, and the zero in them, if there is just one. */
static enum search search_around(struct solver *z, int level, real t, real s, real wt, real ws,
                                 struct node *f, struct node *g, struct zero *x)
{
    const struct level *v = &z->level[level];
    real numbers[2][7 * DEGREE_MAX + 3];
    cut_around(v, t, s, wt, ws, numbers, f, g);
    node_prepare(&v->f, f);
    node_prepare(&v->g, g);
    real c = cone_gap(f, g);
    enum search found = c > 0 ? solve_one(v, f, g, c, x) : STUCK;
    f->points = f->way = g->points = g->way = NULL;
    return found;
}

static bool region_meets(const struct solver *z, int level, const struct zero *x)
{
    real numbers[2][7 * DEGREE_MAX + 3];
    struct node f, g;
    cut_around(&z->level[level], x->t, x->s, x->rt, x->rs, numbers, &f, &g);
    return nodes_meet(&f, &g);
}

enum search zero_prove(struct solver *z, int level, const struct zero *x, real wt, real ws,
                       struct zero *found)
{
    enum { TRIES = 4, SMALLER = 4 };
    const struct level *v = &z->level[level];
    for (int k = 0; k < TRIES && wt > 2 * x->rt && ws > 2 * x->rs;
         k++, wt = wt / SMALLER, ws = ws / SMALLER) {
        struct node f, g;
        enum search search = search_around(z, level, x->t, x->s, wt, ws, &f, &g, found);
        if (search == NO_ZERO) {
            return NO_ZERO;
        }
        if (search == STUCK || near_cut(&v->t, &f, found->t, found->rt) ||
            near_cut(&v->s, &g, found->s, found->rs)) {
            continue;
        }
        struct interval at = around(&v->t, found->t, found->rt), as = around(&v->s, found->s, found->rs);
        struct interval ut = level_inner(&v->t, f.lo, f.hi), us = level_inner(&v->s, g.lo, g.hi);
        int looked = 0;
        if (!is_solved(z, level, &at, &as) && !is_reported(z, &ut, &us)) {
            looked = report(z, level, found);
        }
        if (looked == LATER) {
            return STUCK;
        }
        solved_add(z, &ut, &us, looked);
        return ZERO;
    }
    return STUCK;
}

enum verdict zero_settle(struct solver *z, int level, const struct node *f, const struct node *g,
                         const struct zero *x)
{
    const struct level *v = &z->level[level];
    struct interval t = around(&v->t, x->t, x->rt), s = around(&v->s, x->s, x->rs);
    if (z->solved > 0 && is_solved(z, level, &t, &s)) {
        return CLOSED;
    }
    if (near_cut(&v->t, f, x->t, x->rt) || near_cut(&v->s, g, x->s, x->rs)) {
        struct zero found;
        real share = (real)0.25;
        /* a solution in the nodes is the zero x, which lies in the larger ones too */
        return zero_prove(z, level, x, share * (f->hi - f->lo), share * (g->hi - g->lo), &found) == STUCK
                   ? OPEN
                   : CLOSED;
    }
    if (z->solved > 0) {
        struct interval nt = level_inner(&v->t, f->lo, f->hi), ns = level_inner(&v->s, g->lo, g->hi);
        if (is_reported(z, &nt, &ns)) {
            return CLOSED;
        }
    }
    return report(z, level, x) == LATER ? OPEN : CLOSED;
}

/* ---- one zero, two records ---- */

/* a holds one solution, or (END) one zero; b, a part of it, holds one solution. */
static bool is_part(const struct crossing *b, const struct crossing *a)
{
    return (a->standing == UNIQUE || a->standing == END) && b->standing == UNIQUE && within(&b->t, &a->t) &&
           within(&b->s, &a->s);
}

/* Is there at most one zero of a level's extended pair in some rectangle that holds t and s?  Tried from 1/16
 * on downwards, each parameter by itself, as far as half as much again as the two are wide: next to the
 * rectangle there may be a cusp, or an end where points are doubled. */
static bool at_most_one(struct solver *z, int level, const struct interval *t, const struct interval *s)
{
    enum { TRIES = 9, SMALLER = 16 };
    const struct level *v = &z->level[level];
    const real spread_t = v->t.hi - v->t.lo, spread_s = v->s.hi - v->s.lo; /* powers of two */
    struct interval at = {(t->lo - v->t.lo) / spread_t, (t->hi - v->t.lo) / spread_t};
    struct interval as = {(s->lo - v->s.lo) / spread_s, (s->hi - v->s.lo) / spread_s};
    /* 8 eps: what rounding at, as and their middles moves */
    const real least_t = (at.hi - at.lo) * 3 / 4 + 8 * REAL_EPSILON,
               least_s = (as.hi - as.lo) * 3 / 4 + 8 * REAL_EPSILON;
    real w = (real)1 / 16;
    for (int k = 0; k < TRIES; k++, w = w / SMALLER) {
        struct node f, g;
        struct zero found;
        real wt = real_max(w, least_t), ws = real_max(w, least_s);
        enum search search =
            search_around(z, level, (at.lo + at.hi) / 2, (as.lo + as.hi) / 2, wt, ws, &f, &g, &found);
        if (search != STUCK) {
            return true;
        }
        if (wt > w && ws > w) {
            break;
        }
    }
    return false;
}

/* Is there at most one zero of the extended pair in a rectangle that holds both?  Once more on a level of its
 * own, where rounding is smaller; none is in use any more. */
static bool holds_one(struct solver *z, const struct crossing *a, const struct crossing *b)
{
    struct interval t = {real_min(a->t.lo, b->t.lo), real_max(a->t.hi, b->t.hi)};
    struct interval s = {real_min(a->s.lo, b->s.lo), real_max(a->s.hi, b->s.hi)};
    if (is_part(a, b) || is_part(b, a) || at_most_one(z, 0, &t, &s)) {
        return true;
    }
    z->levels = 1;
    bool one = level_around(z, &t, &s) && at_most_one(z, 1, &t, &s);
    z->levels = 1;
    return one;
}

/* An END's zero may lie beyond the domain: the rectangle's extension is the record's there, by the tangent at
 * the same end. */
void zeros_unite(struct solver *z)
{
    struct crossing *at = z->out->at;
    for (int i = 0; i < z->out->count; i++) {
        for (int k = i + 1; k < z->out->count; k++) {
            bool zeros = (at[i].standing == UNIQUE || at[i].standing == END) &&
                         (at[k].standing == UNIQUE || at[k].standing == END);
            if (!zeros || !overlap(&at[i].t, &at[k].t) || !overlap(&at[i].s, &at[k].s) ||
                !holds_one(z, &at[i], &at[k])) {
                continue;
            }
            bool later = at[k].standing != at[i].standing ? at[k].standing == UNIQUE
                                                          : at[k].t.hi - at[k].t.lo < at[i].t.hi - at[i].t.lo;
            if (later) {
                at[i] = at[k];
            }
            at[k] = at[--z->out->count];
            k = i;
        }
    }
}

/* ---- several ---- */

/* Is x, cut off at the ends of the level, within the node? */
static bool inside(const struct node *a, real x, real radius)
{
    return (a->lo == 0 || x - radius >= a->lo) && (a->hi == 1 || x + radius <= a->hi);
}

static bool is_cut(const struct interval *span, real x, real radius)
{
    return (span->lo > 0 && x - radius < 0) || (span->hi < 1 && x + radius > 1);
}

bool region_is_solved(const struct solver *z, int level, const struct zero *x)
{
    const struct level *v = &z->level[level];
    struct interval t = around(&v->t, x->t, x->rt), s = around(&v->s, x->s, x->rs);
    return is_solved(z, level, &t, &s);
}

bool region_inner(const struct level *v, const struct zero *x, struct interval *t, struct interval *s)
{
    *t = level_inner(&v->t, x->t - x->rt, x->t + x->rt);
    *s = level_inner(&v->s, x->s - x->rs, x->s + x->rs);
    return t->lo <= t->hi && s->lo <= s->hi;
}

void region_solved(struct solver *z, int level, const struct zero *x)
{
    struct interval t, s;
    if (region_inner(&z->level[level], x, &t, &s)) {
        solved_add(z, &t, &s, is_busy(z, level) ? z->levels - 1 : 0);
    }
}

bool region_is_whole(const struct solver *z, int level, const struct node *f, const struct node *g,
                     const struct zero *x)
{
    const struct level *v = &z->level[level];
    return inside(f, x->t, x->rt) && inside(g, x->s, x->rs) && !is_cut(&v->t, x->t, x->rt) &&
           !is_cut(&v->s, x->s, x->rs);
}

/* The record of a region that is whole. */
static struct crossing record_of(const struct interval *t, const struct interval *s, int at_most, bool exists)
{
    struct crossing c = {*t, *s, CLUSTER, at_most, 0};
    if (exists) {
        c.standing = near_end(t) || near_end(s) ? END : UNIQUE;
        c.multiplicity = c.standing == UNIQUE && at_most == 1;
    }
    return c;
}

void region_record(struct solver *z, int level, const struct zero *x, int at_most, bool exists)
{
    const struct level *v = &z->level[level];
    struct interval t = around(&v->t, x->t, x->rt), s = around(&v->s, x->s, x->rs);
    cut_off(&t);
    cut_off(&s);
    if (t.lo > t.hi || s.lo > s.hi || is_solved(z, level, &t, &s)) {
        return;
    }
    struct crossing c = record_of(&t, &s, at_most, exists);
    record_add(z, &c);
    solved_add(z, &t, &s, 0);
}

/* whole: it holds at most so many all over. */
static enum verdict settle_region(struct solver *z, int level, const struct zero *x, int at_most, bool exists,
                                  bool whole)
{
    const struct level *v = &z->level[level];
    struct interval t = around(&v->t, x->t, x->rt), s = around(&v->s, x->s, x->rs);
    cut_off(&t);
    cut_off(&s);
    if (t.lo > t.hi || s.lo > s.hi || is_solved(z, level, &t, &s)) {
        return CLOSED;
    }
    bool narrow = t.hi - t.lo <= z->p->bounds.tolerance_t && s.hi - s.lo <= z->p->bounds.tolerance_s;
    const struct crossing open = {t, s, CANDIDATE, 0, 0};
    struct crossing c = whole ? record_of(&t, &s, at_most, exists) : open;
    const real shorter = (real)1 / 16;
    /* two solutions are told apart, or from none, at any tolerance */
    bool look = !whole || !narrow || (level == 0 && at_most <= 2);
    if (look && is_busy(z, level)) {
        return OPEN;
    }
    /* level 1 knows more digits, however wide it is */
    bool digits = level == 0 && !v->f.rational && !v->g.rational;
    if (look && zoom(z, level, x, whole && !digits ? shorter : (real)1, &c)) {
        return CLOSED;
    }
    if (!narrow && !whole) {
        return OPEN;
    }
    record_add(z, &c);
    solved_add(z, &t, &s, 0);
    return CLOSED;
}

/* A CLUSTER must hold at most so many all over its rectangle, so the region has to lie within the nodes; if
 * not, a level with it in its middle is made. */
enum verdict region_settle(struct solver *z, int level, const struct node *f, const struct node *g,
                           const struct zero *x, int at_most, bool exists)
{
    return settle_region(z, level, x, at_most, exists, region_is_whole(z, level, f, g, x));
}

enum verdict region_settle_all(struct solver *z, int level, const struct zero *x, int at_most)
{
    if (!region_meets(z, level, x)) {
        return CLOSED;
    }
    return settle_region(z, level, x, at_most, false, true);
}

enum verdict region_look_all(struct solver *z, int level, const struct zero *x, int at_most)
{
    const struct level *v = &z->level[level];
    struct crossing c = {around(&v->t, x->t, x->rt), around(&v->s, x->s, x->rs), CLUSTER, at_most, 0};
    cut_off(&c.t);
    cut_off(&c.s);
    const real shorter = (real)1 / 4;
    bool narrow = c.t.hi - c.t.lo <= z->p->bounds.tolerance_t && c.s.hi - c.s.lo <= z->p->bounds.tolerance_s;
    bool solved = c.t.lo > c.t.hi || c.s.lo > c.s.hi || is_solved(z, level, &c.t, &c.s);
    bool look = !narrow && !is_busy(z, level);
    return solved || (look && zoom(z, level, x, shorter, &c)) ? CLOSED : OPEN;
}

enum verdict region_look(struct solver *z, int level, const struct zero *x)
{
    const struct level *v = &z->level[level];
    struct interval t = around(&v->t, x->t, x->rt), s = around(&v->s, x->s, x->rs);
    cut_off(&t);
    cut_off(&s);
    if (t.lo > t.hi || s.lo > s.hi) {
        return CLOSED; /* beyond the domain */
    }
    const struct crossing c = {t, s, CANDIDATE, 0, 0};
    const real shorter = (real)1 / 16;
    return level == 0 && zoom(z, level, x, shorter, &c) ? CLOSED : OPEN;
}
