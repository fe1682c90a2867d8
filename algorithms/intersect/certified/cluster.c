/* Contacts of higher order, cusps, and arcs that nearly are one: by their gap as a polynomial with a
 * remainder.
 *
 * G and its derivatives are enclosed by gap_model.c; solutions of the pair are zeros of G on the free node,
 * one of multiplicity k a zero of order k.  core/roots.c encloses all zeros of the polynomials within the
 * radii of G's Bernstein coefficients; the true G is, at every t, the value of one of them.  If there are
 * none, the pair is empty.  Otherwise, for each enclosure:
 *
 * - if the remainder makes it wide, the pair is cut down to it and to where the graph has the same abscissas,
 * and modelled again: like gap clipping, of order 6 / k at a solution of multiplicity k;
 * - if rounding does, and the p-th derivative has one sign on it, G has at most p zeros there, with
 * multiplicity (Rolle): a CLUSTER of p; or for p = 1 a single zero. */
#include "../../core/roots.h"
#include "gap_model.h"

struct stretch {
    real lo, hi; /* of the free node */
};

enum { STRETCHES_MAX = 8, ROOTS_SCRATCH = 32 + 2 * (REAL_BITS + 16) };

static int stretches(const struct gap_model *c, struct stretch *out)
{
    struct ball g[SERIES + 1];
    real value[SERIES + 1], error[SERIES + 1], scratch[ROOTS_SCRATCH];
    struct root root[STRETCHES_MAX];
    gap_model_bernstein(c, 0, 0, 1, g);
    for (int i = 0; i <= SERIES; i++) {
        value[i] = g[i].mid;
        error[i] = g[i].rad;
    }
    int count = roots_find(SERIES, value, error, REAL_EPSILON, scratch, STRETCHES_MAX, root);
    for (int i = 0; i < count; i++) {
        out[i].lo = root[i].lo;
        out[i].hi = root[i].hi;
    }
    return count;
}

/* Is rounding of the points, not the remainder, what hides G there? */
static bool is_limited(const struct gap_model *c, const struct stretch *s)
{
    const int many = 4;
    real d = real_max(c->at - s->lo, s->hi - c->at), dd = d * d;
    return c->gap.c[SERIES].rad * (dd * dd * dd) <= c->noise && c->gap.c[0].rad <= many * c->noise;
}

/* The least p for which G^(p) has one sign on the stretch; 0: none.  size: at most |G^(p)| / p!. */
static int order_on(const struct gap_model *c, const struct stretch *s, real *size)
{
    for (int p = 1; p <= SERIES; p++) {
        struct ball g[SERIES + 1];
        gap_model_bernstein(c, p, s->lo, s->hi, g);
        int up = 0, down = 0;
        *size = 0;
        for (int i = 0; i <= SERIES - p; i++) {
            up += g[i].mid > g[i].rad;
            down += -g[i].mid > g[i].rad;
            *size = real_max(*size, ball_most(g[i]));
        }
        if (up > SERIES - p || down > SERIES - p) {
            return p;
        }
    }
    return 0;
}

/* Would a narrower pair, whose points are cut, tell no more?  G changes by no more than size d^p over d. */
static bool is_all(const struct gap_model *c, const struct stretch *s, int p, real size)
{
    const int many = 4;
    real quarter = (s->hi - s->lo) / 4;
    for (int k = 0; k < p; k++) {
        size = size * quarter;
    }
    return size <= many * c->noise;
}

/* Does G have opposite signs at the ends of the node? */
static bool changes_sign(const struct gap_model *c)
{
    struct ball g[SERIES + 1];
    gap_model_bernstein(c, 0, 0, 1, g);
    const struct ball *a = &g[0], *b = &g[SERIES];
    return ball_least(*a) > 0 && ball_least(*b) > 0 && (a->mid > 0) != (b->mid > 0);
}

/* From own parameters of the nodes to a region of the level. */
static void region_of(const struct gap_model *c, const struct stretch *s, const struct node *loose,
                      const struct node *graph, bool f_is_graph, struct zero *out)
{
    real as, rs, wide = loose->hi - loose->lo, across = graph->hi - graph->lo;
    gap_model_place(c, s->lo, s->hi, &as, &rs);
    real t = loose->lo + wide * ((s->lo + s->hi) / 2), rt = wide * ((s->hi - s->lo) / 2) + REAL_EPSILON;
    real at = graph->lo + across * as, rat = across * rs + REAL_EPSILON;
    out->t = f_is_graph ? at : t;
    out->rt = f_is_graph ? rat : rt;
    out->s = f_is_graph ? t : at;
    out->rs = f_is_graph ? rt : rat;
}

static enum verdict settle_stretch(struct solver *z, const struct pair *at, const struct gap_model *c,
                                   bool f_is_graph, const struct stretch *s, int most)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    const real worth = (real)0.5;
    struct zero x, found;
    region_of(c, s, f_is_graph ? g : f, f_is_graph ? f : g, f_is_graph, &x);
    real size;
    int p = order_on(c, s, &size);
    bool limited = is_limited(c, s) || (p > 0 && p <= 2 && is_all(c, s, p, size));
    p = limited ? p : 0;
    if (p > most) {
        return OPEN;
    }
    if (p == 1) {
        const int many = 64;
        struct zero guess = {x.t, x.s, 0, 0};
        real wt = real_min(many * x.rt, f->hi - f->lo), ws = real_min(many * x.rs, g->hi - g->lo);
        if (zero_prove(z, at->level, &guess, wt, ws, &found) == ZERO) {
            return CLOSED;
        }
    }
    if (p && region_settle(z, at->level, f, g, &x, p, p == 1 && changes_sign(c)) == CLOSED) {
        return CLOSED;
    }
    if (limited) {
        z->next_look = z->suspicions++ ? z->next_look : z->w->steps; /* the arcs may be one */
        return region_look(z, at->level, &x);
    }
    return s->hi - s->lo <= worth ? pair_narrow(z, at, &x) : OPEN;
}

/* Several: the pair is divided between them. */
static enum verdict divide(struct solver *z, const struct pair *at, const struct gap_model *c,
                           bool f_is_graph, int count, const struct stretch *s)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    int pairs = z->pairs;
    for (int i = count - 1; i >= 0; i--) {
        struct stretch part = {i > 0 ? (s[i - 1].hi + s[i].lo) / 2 : (real)0,
                               i < count - 1 ? (s[i].hi + s[i + 1].lo) / 2 : (real)1};
        struct zero x;
        region_of(c, &part, f_is_graph ? g : f, f_is_graph ? f : g, f_is_graph, &x);
        if (pair_narrow(z, at, &x) == OPEN) {
            z->pairs = pairs;
            return OPEN;
        }
    }
    return CLOSED;
}

static enum verdict settle_stretches(struct solver *z, const struct pair *at, const struct gap_model *c,
                                     bool f_is_graph, int most)
{
    struct stretch s[STRETCHES_MAX];
    int count = stretches(c, s);
    if (count == 0) {
        return CLOSED;
    }
    return count == 1 ? settle_stretch(z, at, c, f_is_graph, &s[0], most)
                      : divide(z, at, c, f_is_graph, count, s);
}

enum verdict cluster_settle(struct solver *z, const struct pair *at, int most)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    for (int way = 0; way < 2; way++) {
        struct gap_model c;
        bool f_is_graph = way;
        bool made =
            f_is_graph ? gap_model_init(&v->g, g, &v->f, f, &c) : gap_model_init(&v->f, f, &v->g, g, &c);
        if (made && settle_stretches(z, at, &c, f_is_graph, most) == CLOSED) {
            return CLOSED;
        }
    }
    return OPEN;
}
