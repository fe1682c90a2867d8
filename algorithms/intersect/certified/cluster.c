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
#include "gap_model.h"

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

static enum verdict settle_stretch(struct solver *z, const struct pair *at, const struct gap_model *c,
                                   const struct stretch *s, int most)
{
    const struct stretch whole = {0, 1};
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    const real worth = (real)0.5;
    struct zero x, found;
    gap_region(c, s, f, g, &x);
    real size;
    int p = gap_order(c, s, &size);
    bool limited = gap_is_limited(c, s) || (p > 0 && p <= 2 && is_all(c, s, p, size));
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
    if (p && region_settle(z, at->level, f, g, &x, p, p == 1 && gap_crosses(c, s, &whole)) == CLOSED) {
        return CLOSED;
    }
    if (limited) {
        z->next_look = z->suspicions++ ? z->next_look : z->w->steps; /* the arcs may be one */
        return region_look(z, at->level, &x);
    }
    return s->hi - s->lo <= worth ? pair_narrow(z, at, &x) : OPEN;
}

/* Several: the pair is divided between them. */
static enum verdict divide(struct solver *z, const struct pair *at, const struct gap_model *c, int count,
                           const struct stretch *s)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    int pairs = z->pairs;
    for (int i = count - 1; i >= 0; i--) {
        struct stretch part = {i > 0 ? (s[i - 1].hi + s[i].lo) / 2 : (real)0,
                               i < count - 1 ? (s[i].hi + s[i + 1].lo) / 2 : (real)1};
        struct zero x;
        gap_region(c, &part, f, g, &x);
        if (pair_narrow(z, at, &x) == OPEN) {
            z->pairs = pairs;
            return OPEN;
        }
    }
    return CLOSED;
}

/* Is the region of the stretch as narrow as asked, all of it within the nodes? */
static bool is_enough(const struct solver *z, const struct pair *at, const struct gap_model *c,
                      const struct stretch *s)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    struct zero x;
    gap_region(c, s, f, g, &x);
    return 2 * x.rt * (v->t.hi - v->t.lo) <= z->p->bounds.tolerance_t &&
           2 * x.rs * (v->s.hi - v->s.lo) <= z->p->bounds.tolerance_s &&
           region_is_whole(z, at->level, f, g, &x);
}

/* A pair that is a whole level, where something else than a simple zero is hidden: with twice the digits. But
 * if the arcs may be one, that is looked at first, once, and the pair taken up again. */
static enum verdict look_sharply(struct solver *z, const struct pair *at, const struct gap_model *c, int most,
                                 int count, const struct stretch *s)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    bool simple = true, suspect = false;
    if (at->level == 0 || f->hi - f->lo < 1 || g->hi - g->lo < 1) {
        return OPEN;
    }
    for (int i = 0; i < count; i++) {
        real size;
        int p = gap_order(c, &s[i], &size);
        bool known =
            count == 1 && p > 0 && p <= most && gap_is_limited(c, &s[i]) && is_enough(z, at, c, &s[i]);
        simple = simple && (p == 1 || known);
        suspect = suspect || p == 0;
    }
    if (!simple && suspect && !z->alone && z->suspicions == 0) {
        z->suspicions++;
        z->next_look = z->w->steps;
        pair_push(z, at->level, at->f, at->g, 0);
        return CLOSED;
    }
    return simple ? OPEN : cluster_sharpen(z, at, c, most, count, s);
}

static enum verdict settle_stretches(struct solver *z, const struct pair *at, const struct gap_model *c,
                                     int most)
{
    const struct stretch whole = {0, 1};
    struct stretch s[STRETCHES_MAX];
    int count = gap_stretches(c, &whole, s);
    if (count == 0 || look_sharply(z, at, c, most, count, s) == CLOSED) {
        return CLOSED;
    }
    return count == 1 ? settle_stretch(z, at, c, &s[0], most) : divide(z, at, c, count, s);
}

enum verdict cluster_settle(struct solver *z, const struct pair *at, int most)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    for (int way = 0; way < 2; way++) {
        struct gap_model c;
        c.f_is_graph = way;
        bool made = way ? gap_model_init(&v->g, g, &v->f, f, &c) : gap_model_init(&v->f, f, &v->g, g, &c);
        if (made && settle_stretches(z, at, &c, most) == CLOSED) {
            return CLOSED;
        }
    }
    return OPEN;
}
