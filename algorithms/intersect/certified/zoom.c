/* A closer look: a small part of the pair as a level of its own.
 *
 * The level's curves are those of the problem over small intervals, cut with twice the digits, less a point
 * of theirs, and enlarged by a power of two to coordinates around 1.  So their control points err by a few
 * units in their *own* last place, where the nodes of level 0 err by units in the last place of the whole:
 * what was below rounding there can be decided here.
 *
 * Errors, in units of the problem: de Casteljau's two passes over [0, hi] and [lo/hi, 1] in twofolds, each
 * step a relative error of at most 12 u^2 for products of weights (15 u^2) with points and their sum, 2 n
 * steps: less than 64 n u^2 S; for numerator and denominator each; the subtraction 16 u^2 S; rounding to one
 * real u of the difference.  For rational curves the homogeneous coordinates of the problem are rounded
 * already (the error of level 0): less is gained. */
#include "../../core/bernstein.h"
#include "../../core/twofold.h"
#include "evaluate.h"

struct cut {
    int n;
    bool rational;
    struct twofold x[DEGREE_MAX + 1], y[DEGREE_MAX + 1], w[DEGREE_MAX + 1];
};

static inline struct twofold mean(struct twofold v, struct twofold a, struct twofold t, struct twofold b)
{
    return twofold_add(twofold_multiply(v, a), twofold_multiply(t, b));
}

static void cut_component(int n, const real *c, const struct interval *span, struct twofold *out)
{
    struct twofold hi = twofold_of(span->hi), rest = exact_sum(1, -span->hi);
    for (int i = 0; i <= n; i++) {
        out[i] = twofold_of(c[i]);
    }
    for (int k = 1; k <= n && rest.hi > 0; k++) {
        for (int i = n; i >= k; i--) {
            out[i] = mean(rest, out[i - 1], hi, out[i]);
        }
    }
    if (span->lo > 0) {
        struct twofold share = twofold_divide(twofold_of(span->lo), hi);
        struct twofold other = twofold_divide(exact_sum(span->hi, -span->lo), hi);
        for (int k = 1; k <= n; k++) {
            for (int i = 0; i <= n - k; i++) {
                out[i] = mean(other, out[i], share, out[i + 1]);
            }
        }
    }
}

static void cut_curve(const struct curve *c, const struct interval *span, struct cut *out)
{
    out->n = c->degree;
    cut_component(c->degree, c->x, span, out->x);
    cut_component(c->degree, c->y, span, out->y);
    out->rational = c->w != NULL;
    if (c->w) {
        cut_component(c->degree, c->w, span, out->w);
    }
}

/* c - x, or c - x w: exact but for relative errors of 16 u^2. */
static struct twofold moved(struct twofold c, real x, const struct twofold *w)
{
    return twofold_add(c, w ? twofold_multiply(*w, twofold_of(-x)) : twofold_of(-x));
}

/* Homogeneous coordinates from (x, y) on, into numbers, and what rounding leaves off; returns the largest
 * Euclidean one. */
static real difference(const struct cut *c, real x, real y, real *to, real *low)
{
    real most = 0;
    for (int i = 0; i <= c->n; i++) {
        const struct twofold *w = c->rational ? &c->w[i] : NULL;
        struct twofold moved_x = moved(c->x[i], x, w), moved_y = moved(c->y[i], y, w);
        real dx = moved_x.hi, dy = moved_y.hi, weight = w ? w->hi : (real)1;
        to[i] = dx;
        to[c->n + 1 + i] = dy;
        low[i] = moved_x.lo;
        low[c->n + 1 + i] = moved_y.lo;
        if (w) {
            to[2 * (c->n + 1) + i] = weight;
        }
        most = real_max(most, real_max(real_abs(dx), real_abs(dy)) / weight);
    }
    return most;
}

/* ---- the level ---- */

/* Enlarges the points by a power of two; error: of the problem's cut, before. */
static void enlarge(const struct cut *cut, real *points, real *low, real factor, real error, struct source *c,
                    real *numbers)
{
    const real u = REAL_EPSILON / 2;
    const real scale = 2; /* coordinates are below it */
    int n = cut->n, doubled = cut->rational ? 2 : 1;
    for (int i = 0; i < 2 * (n + 1); i++) {
        points[i] = points[i] * factor;
        low[i] = low[i] * factor;
    }
    c->n = n;
    c->rational = cut->rational;
    c->points = points;
    c->low = cut->rational ? NULL : low;
    c->fine_error = error * factor;
    c->error = error * factor + doubled * u * scale;
    c->node_error = doubled * (12 * n + 1) * u * scale + c->error;
    source_init(c, scale, numbers);
}

/* A dyadic interval of width 2^e >= 2 radius within [0, 1] that holds x - radius and x + radius, where [0, 1]
 * does. */
static void span_make(real x, real radius, struct interval *out)
{
    enum { PARTS = 64 };
    real width = real_ldexp(1, real_exponent(radius) + 2);
    if (width >= 1) {
        out->lo = 0;
        out->hi = 1;
        return;
    }
    /* the nearest multiple of width / PARTS, by adding and subtracting a number whose last place that is */
    real big = real_ldexp(width / PARTS, REAL_BITS - 1), lo = x - width * 21 / 64;
    lo = (lo + big) - big;
    out->lo = clamp(lo, 0, 1 - width);
    out->hi = out->lo + width;
}

static bool level_new(struct solver *z, const struct interval *t, const struct interval *s)
{
    const struct problem *p = z->p;
    struct cut f, g;
    struct level *v = &z->level[z->levels];
    real *numbers = z->level_numbers + z->level_stride * (size_t)z->levels;
    int n = p->f.degree, m = p->g.degree;
    real *points_f = numbers, *points_g = points_f + 3 * (n + 1), *low_f = points_g + 3 * (m + 1);
    real *low_g = low_f + 2 * (n + 1), *rest_f = low_g + 2 * (m + 1);
    cut_curve(&p->f, t, &f);
    cut_curve(&p->g, s, &g);
    real weight = f.rational ? f.w[0].hi : (real)1, x = f.x[0].hi / weight, y = f.y[0].hi / weight;
    real most = real_max(difference(&f, x, y, points_f, low_f), difference(&g, x, y, points_g, low_g));
    int most_degree = n > m ? n : m;
    const real u = REAL_EPSILON / 2;
    real error = (128 * most_degree + 32) * u * u * p->bounds.scale;
    real error_f = error + z->level[0].f.error, error_g = error + z->level[0].g.error;
    if (!(most > 64 * real_max(error_f, error_g))) {
        return false;
    }
    real factor = real_ldexp(1, 1 - real_exponent(most));
    v->t = *t;
    v->s = *s;
    v->scale = 2;
    v->factor = factor;
    enlarge(&f, points_f, low_f, factor, error_f, &v->f, rest_f);
    enlarge(&g, points_g, low_g, factor, error_g, &v->g, rest_f + source_length(n));
    z->levels++;
    return true;
}

bool level_around(struct solver *z, const struct interval *t, const struct interval *s)
{
    struct interval at, as;
    span_make((t->lo + t->hi) / 2, (t->hi - t->lo) / 2 + 32 * REAL_EPSILON, &at);
    span_make((s->lo + s->hi) / 2, (s->hi - s->lo) / 2 + 32 * REAL_EPSILON, &as);
    bool inside = at.lo <= t->lo && t->hi <= at.hi && as.lo <= s->lo && s->hi <= as.hi;
    return inside && z->levels < LEVELS_MAX && level_new(z, &at, &as);
}

bool zoom(struct solver *z, int from, const struct zero *x, real shorter, const struct crossing *otherwise)
{
    enum { STEPS = 192 };
    const struct level *v = &z->level[from];
    real wt = v->t.hi - v->t.lo, ws = v->s.hi - v->s.lo;
    struct interval t, s;
    if (z->levels == LEVELS_MAX || from != z->levels - 1) {
        return false;
    }
    span_make(v->t.lo + wt * x->t, wt * x->rt + 32 * REAL_EPSILON, &t);
    span_make(v->s.lo + ws * x->s, ws * x->rs + 32 * REAL_EPSILON, &s);
    if (t.hi - t.lo > shorter * wt && s.hi - s.lo > shorter * ws) {
        return false;
    }
    int f = node_new(&z->f), g = node_new(&z->g), pairs = z->pairs;
    if (!f || !g || !level_new(z, &t, &s)) {
        return false; /* nodes that were taken are free again at the next collection */
    }
    int level = z->levels - 1;
    struct level *fresh = &z->level[level];
    struct node *a = &z->f.node[f], *b = &z->g.node[g];
    fresh->otherwise = *otherwise;
    fresh->records = -1;
    fresh->pairs = pairs;
    fresh->steps = STEPS;
    a->way = a->points + (fresh->f.rational ? 3 : 2) * (fresh->f.n + 1);
    b->way = b->points + (fresh->g.rational ? 3 : 2) * (fresh->g.n + 1);
    node_cut(&fresh->f, 0, 1, a);
    node_cut(&fresh->g, 0, 1, b);
    solved_add(z, &t, &s, level);
    fresh->solved = z->solved;
    pair_push(z, level, f, g, 0);
    return true;
}

/* Where all that is known is a region wider than asked, it is taken up again as a pair, and halved a few
 * times before any other look. */
static bool go_on_below(struct solver *z, const struct crossing *region)
{
    enum { HALVINGS = 8 };
    const struct bounds *b = &z->p->bounds;
    const struct level *v = &z->level[0];
    bool narrow =
        region->t.hi - region->t.lo <= b->tolerance_t && region->s.hi - region->s.lo <= b->tolerance_s;
    int f, g;
    if (region->standing != CANDIDATE || narrow || !(f = node_new(&z->f)) || !(g = node_new(&z->g))) {
        return false;
    }
    struct node *c = &z->f.node[f], *d = &z->g.node[g];
    c->way = c->points + (v->f.rational ? 3 : 2) * (v->f.n + 1);
    d->way = d->points + (v->g.rational ? 3 : 2) * (v->g.n + 1);
    node_cut(&v->f, region->t.lo, region->t.hi, c);
    node_cut(&v->g, region->s.lo, region->s.hi, d);
    pair_push(z, 0, f, g, HALVINGS);
    return true;
}

void level_give_up(struct solver *z)
{
    const struct level *v = &z->level[z->levels - 1];
    const struct crossing nowhere = {{2, 2}, {2, 2}, CANDIDATE, 0, 0};
    z->pairs = v->pairs;
    if (v->records >= 0 && !z->out->merged) { /* merged, they may have moved: then they stay */
        z->out->count = v->records;
        solved_forget(z, v->solved); /* their solutions were in those records */
    }
    if (go_on_below(z, &v->otherwise)) {
        for (int i = 1; i < z->levels; i++) { /* the levels around it are open there too */
            solved_shrink(z, i, &nowhere);
        }
        return;
    }
    record_add(z, &v->otherwise);
    solved_shrink(z, z->levels - 1, &v->otherwise);
}
