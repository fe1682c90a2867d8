/* A closer look: a small part of the pair as a level of its own.
 *
 * The level's curves are those of the problem over small intervals, cut with twice the digits, less a point of theirs, and
 * enlarged by a power of two to coordinates around 1.  So their control points err by a few units in their *own* last
 * place, where the nodes of level 0 err by units in the last place of the whole: what was below rounding there can be
 * decided here.
 *
 * Errors, in units of the problem: de Casteljau's two passes over [0, hi] and [lo/hi, 1] in twofolds, each step a relative
 * error of at most 12 u^2 for products of weights (15 u^2) with points and their sum, 2 n steps: less than 64 n u^2 S;
 * the subtraction 3 u^2 S; rounding to one real u of the difference.  For rational curves the homogeneous coordinates of the
 * problem are rounded already (u S): nothing is gained, and there is no zoom. */
#include "../../core/bernstein.h"
#include "../../core/twofold.h"
#include "evaluate.h"

struct cut {
    int n;
    struct twofold x[DEGREE_MAX + 1], y[DEGREE_MAX + 1];
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
}

/* Differences from (x, y), into numbers; returns the largest. */
static real difference(const struct cut *c, real x, real y, real *to)
{
    real most = 0;
    for (int i = 0; i <= c->n; i++) {
        struct twofold dx = twofold_add(c->x[i], twofold_of(-x)), dy = twofold_add(c->y[i], twofold_of(-y));
        to[i] = dx.hi + dx.lo;
        to[c->n + 1 + i] = dy.hi + dy.lo;
        most = real_max(most, real_max(real_abs(to[i]), real_abs(to[c->n + 1 + i])));
    }
    return most;
}

/* ---- the level ---- */

/* Enlarges the points by a power of two; error: of the problem's cut, before. */
static void enlarge(int n, real *points, real factor, real error, struct source *c, real *numbers)
{
    const real u = REAL_EPSILON / 2;
    const real scale = 2; /* coordinates are below it */
    for (int i = 0; i < 2 * (n + 1); i++) {
        points[i] = points[i] * factor;
    }
    c->n = n;
    c->rational = false;
    c->points = points;
    c->error = error * factor + u * scale;
    c->node_error = (12 * n + 1) * u * scale + c->error;
    source_init(c, scale, numbers);
}

/* A dyadic interval of width 2^e >= 2 radius within [0, 1] that holds x - radius and x + radius, where [0, 1] does. */
static void span_make(real x, real radius, struct interval *out)
{
    enum { PARTS = 64 };
    real width = real_ldexp(1, real_exponent(2 * radius) + 1);
    if (width >= 1) {
        out->lo = 0;
        out->hi = 1;
        return;
    }
    /* the nearest multiple of width / PARTS, by adding and subtracting a number whose last place that is */
    real big = real_ldexp(width / PARTS, REAL_BITS - 1), lo = x - width / 2;
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
    real *points_f = numbers, *points_g = points_f + 2 * (n + 1), *rest_f = points_g + 2 * (m + 1);
    cut_curve(&p->f, t, &f);
    cut_curve(&p->g, s, &g);
    real x = f.x[0].hi, y = f.y[0].hi;
    real most = real_max(difference(&f, x, y, points_f), difference(&g, x, y, points_g));
    int most_degree = n > m ? n : m;
    real error = (64 * most_degree + 8) * (REAL_EPSILON / 2) * (REAL_EPSILON / 2) * p->bounds.scale;
    if (!(most > 64 * error)) {
        return false;
    }
    real factor = real_ldexp(1, 1 - real_exponent(most));
    v->t = *t;
    v->s = *s;
    v->scale = 2;
    enlarge(n, points_f, factor, error, &v->f, rest_f);
    enlarge(m, points_g, factor, error, &v->g, rest_f + source_length(n));
    z->levels++;
    return true;
}

bool zoom(struct solver *z, int from, const struct zero *x)
{
    const struct level *v = &z->level[from];
    real wt = v->t.hi - v->t.lo, ws = v->s.hi - v->s.lo;
    struct interval t, s;
    if (v->f.rational || v->g.rational || z->levels == LEVELS_MAX || from != z->levels - 1) {
        return false;
    }
    span_make(v->t.lo + wt * x->t, wt * x->rt + 2 * REAL_EPSILON, &t);
    span_make(v->s.lo + ws * x->s, ws * x->rs + 2 * REAL_EPSILON, &s);
    const real shorter = (real)1 / 16;
    if (t.hi - t.lo > shorter * wt && s.hi - s.lo > shorter * ws) {
        return false;
    }
    int f = node_new(&z->f), g = node_new(&z->g);
    if (!f || !g || !level_new(z, &t, &s)) {
        return false; /* nodes that were taken are free again at the next collection */
    }
    int level = z->levels - 1;
    struct node *a = &z->f.node[f], *b = &z->g.node[g];
    a->way = a->points + 2 * (z->p->f.degree + 1);
    b->way = b->points + 2 * (z->p->g.degree + 1);
    node_cut(&z->level[level].f, 0, 1, a);
    node_cut(&z->level[level].g, 0, 1, b);
    solved_add(z, &t, &s, level);
    pair_push(z, level, f, g, 0);
    return true;
}
