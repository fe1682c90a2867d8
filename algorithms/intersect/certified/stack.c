/* The pairs that wait: pushing, cutting down, halving, and what becomes of those that nothing settles. */
#include "evaluate.h"

void record_add(struct solver *z, const struct crossing *c)
{
    bool narrow =
        c->t.hi - c->t.lo <= z->p->bounds.tolerance_t && c->s.hi - c->s.lo <= z->p->bounds.tolerance_s;
    if (c->standing == CANDIDATE && !narrow && z->outcome == SOLVED) {
        z->outcome = OUT_OF_STEPS;
    }
    crossings_add(z->out, c);
}

static bool lies_in(const struct crossing *a, const struct crossing *b)
{
    return b->t.lo <= a->t.lo && a->t.hi <= b->t.hi && b->s.lo <= a->s.lo && a->s.hi <= b->s.hi;
}

/* Is all of a said by b as well?  Two records of one solution each, one within the other, hold the same.  An
 * END says no more than a CLUSTER around it: no solution lies outside either. */
static bool is_idle(const struct crossing *a, const struct crossing *b)
{
    if (b->standing == UNIQUE) {
        bool one = a->standing == UNIQUE || (a->standing == CLUSTER && a->at_most == 1);
        return one && lies_in(b, a);
    }
    return b->standing == CLUSTER && a->standing != UNIQUE && lies_in(a, b);
}

static bool spans(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->lo && b->hi <= a->hi;
}

static bool lie_across(const struct crossing *a, const struct crossing *b)
{
    return a->t.lo < b->t.hi && b->t.lo < a->t.hi && a->s.lo < b->s.hi && b->s.lo < a->s.hi;
}

/* b becomes what of it is left and right of a, and below and above: one to four records, if any is left. */
static void take_out(struct crossings *out, int b, const struct crossing *a)
{
    const struct crossing whole = out->at[b], hole = *a;
    real lo = real_max(hole.t.lo, whole.t.lo), hi = real_min(hole.t.hi, whole.t.hi);
    struct crossing part[4] = {whole, whole, whole, whole};
    int parts = 0;
    if (out->count + 3 > CROSSINGS_MAX) {
        return;
    }
    part[0].t.hi = part[2].t.lo = part[3].t.lo = lo;
    part[1].t.lo = part[2].t.hi = part[3].t.hi = hi;
    part[2].s.hi = hole.s.lo;
    part[3].s.lo = hole.s.hi;
    for (int i = 0; i < 4; i++) {
        bool strip = i >= 2 && lo <= hi && part[i].s.lo < part[i].s.hi; /* it may have no width */
        if (part[i].t.lo < part[i].t.hi ? part[i].s.lo <= part[i].s.hi : strip) {
            out->at[parts++ == 0 ? b : out->count++] = part[i];
        }
    }
}

/* A CLUSTER that lies across another proof keeps what is outside of it; of a part at_most is true as well. */
static void clusters_part(struct crossings *out)
{
    for (int i = 0; i < out->count; i++) {
        struct crossing *b = &out->at[i];
        for (int k = 0; k < out->count && b->standing == CLUSTER && b->multiplicity == 0; k++) {
            const struct crossing *a = &out->at[k];
            bool apart = a->standing == UNIQUE || spans(&a->t, &b->t) || spans(&a->s, &b->s);
            if (k != i && a->standing != CANDIDATE && apart && lie_across(a, b)) {
                take_out(out, i, a);
            }
        }
    }
}

void records_tidy(struct solver *z)
{
    struct crossing *at = z->out->at;
    rings_part(z);
    for (int i = 0; i < z->out->count; i++) {
        for (int k = 0; k < z->out->count; k++) {
            if (k != i && is_idle(&at[k], &at[i])) {
                at[k] = at[--z->out->count];
                i = k = -1; /* what has moved may hold others: again from the beginning */
                break;
            }
        }
    }
    zeros_unite(z);
    clusters_part(z->out);
}

static void record_pair(struct solver *z, const struct pair *at)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    struct crossing c = {level_t(v, f->lo, f->hi), level_s(v, g->lo, g->hi), CANDIDATE, 0, 0};
    record_add(z, &c);
}

void pair_accept(struct solver *z, const struct pair *at)
{
    if (at->level > 0 && z->level[at->level].otherwise.standing != CANDIDATE) {
        level_give_up(z);
    } else {
        record_pair(z, at);
    }
}

/* Pairs of deeper levels stay on top. */
void pair_push(struct solver *z, int level, int f, int g, int rest)
{
    struct pair at = {f, g, level, rest};
    if (z->pairs == PAIRS_MAX) {
        z->outcome = OUT_OF_ROOM;
        record_pair(z, &at);
        return;
    }
    int place = z->pairs++;
    for (; place > 0 && z->pair[place - 1].level > level; place--) {
        z->pair[place] = z->pair[place - 1];
    }
    z->pair[place] = at;
    for (int i = level + 1; i < z->levels; i++) {
        z->level[i].pairs++;
    }
}

bool narrow_t(const struct solver *z, const struct level *v, const struct node *f)
{
    return (v->t.hi - v->t.lo) * (f->hi - f->lo) <= z->narrow_t;
}

bool narrow_s(const struct solver *z, const struct level *v, const struct node *g)
{
    return (v->s.hi - v->s.lo) * (g->hi - g->lo) <= z->narrow_s;
}

static real extent(const struct node *a)
{
    return real_max(a->high[0] - a->low[0], a->high[1] - a->low[1]);
}

/* No more than rounding is left of it. */
static bool is_speck(const struct source *c, const struct node *a)
{
    return extent(a) <= 6 * c->node_error;
}

/* A node over [lo, hi], apart from the tree; 0: no memory. */
static int part_make(struct tree *tree, const struct source *c, real lo, real hi)
{
    int k = node_new(tree);
    if (k) {
        struct node *part = &tree->node[k];
        part->way = part->points + (c->rational ? 3 : 2) * (c->n + 1);
        node_cut(c, lo, hi, part);
    }
    return k;
}

static int part_around(struct tree *tree, const struct source *c, const struct node *of, real x, real radius)
{
    return part_make(tree, c, real_min(real_max(x - radius, of->lo), of->hi),
                     real_max(real_min(x + radius, of->hi), of->lo));
}

void pair_push_rectangle(struct solver *z, const struct interval *t, const struct interval *s)
{
    const struct level *v = &z->level[0];
    bool whole_t = t->lo == 0 && t->hi == 1, whole_s = s->lo == 0 && s->hi == 1;
    int f = whole_t ? z->root_f : part_make(&z->f, &v->f, t->lo, t->hi);
    int g = whole_s ? z->root_g : part_make(&z->g, &v->g, s->lo, s->hi);
    if (!f || !g) { /* cannot be: REST_MAX parts and their siblings are fewer than NODES_MAX */
        f = z->root_f;
        g = z->root_g;
    }
    if (nodes_meet(&z->f.node[f], &z->g.node[g])) {
        pair_push(z, 0, f, g, 0);
    }
}

enum verdict pair_narrow(struct solver *z, const struct pair *at, const struct zero *x)
{
    const struct level *v = &z->level[at->level];
    int f = part_around(&z->f, &v->f, &z->f.node[at->f], x->t, x->rt);
    int g = part_around(&z->g, &v->g, &z->g.node[at->g], x->s, x->rs);
    if (!f || !g) {
        return OPEN;
    }
    if (nodes_meet(&z->f.node[f], &z->g.node[g])) {
        pair_push(z, at->level, f, g, 0);
    }
    return CLOSED;
}

struct cuts {
    int part[3]; /* before, in, after the region; 0: none, or no memory */
    bool full;
};

static void cut_in_three(struct tree *tree, const struct source *c, int of, real x, real radius,
                         struct cuts *out)
{
    real lo = tree->node[of].lo, hi = tree->node[of].hi;
    const real at[4] = {lo, real_min(real_max(x - radius, lo), hi), real_max(real_min(x + radius, hi), lo),
                        hi};
    out->full = false;
    for (int k = 0; k < 3; k++) {
        bool any = at[k] < at[k + 1];
        out->part[k] = any ? part_make(tree, c, at[k], at[k + 1]) : 0;
        out->full |= any && !out->part[k];
    }
}

enum verdict pair_push_around(struct solver *z, const struct pair *at, const struct zero *x)
{
    const struct level *v = &z->level[at->level];
    struct cuts f, g;
    if (!(x->rt > 0 && x->rs > 0)) {
        return OPEN;
    }
    cut_in_three(&z->f, &v->f, at->f, x->t, x->rt, &f);
    cut_in_three(&z->g, &v->g, at->g, x->s, x->rs, &g);
    if (f.full || g.full) {
        return OPEN;
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            bool around = i != 1 || k != 1;
            if (around && f.part[i] && g.part[k] &&
                nodes_meet(&z->f.node[f.part[i]], &z->g.node[g.part[k]])) {
                pair_push(z, at->level, f.part[i], g.part[k], 0);
            }
        }
    }
    return CLOSED;
}

/* What is as narrow as asked and still open gets a closer look, so often. */
static bool look_before(struct solver *z, const struct pair *at)
{
    enum { LOOKS = 32 };
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    struct zero x = {(f->lo + f->hi) / 2, (g->lo + g->hi) / 2, (f->hi - f->lo) / 2, (g->hi - g->lo) / 2};
    return at->level == 0 && z->looks++ < LOOKS && region_look(z, 0, &x) == CLOSED;
}

void pair_split(struct solver *z, const struct pair *at)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    bool done_f = narrow_t(z, v, f) || is_speck(&v->f, f), done_g = narrow_s(z, v, g) || is_speck(&v->g, g);
    if (done_f && done_g) {
        if (!look_before(z, at)) {
            pair_accept(z, at);
        }
        return;
    }
    bool of_f = f->bend != g->bend ? f->bend > g->bend : extent(f) >= extent(g);
    of_f = done_f ? false : done_g ? true : of_f;
    int first = of_f ? node_split(&z->f, &v->f, at->f) : node_split(&z->g, &v->g, at->g);
    if (!first) {
        z->outcome = OUT_OF_ROOM;
        pair_accept(z, at);
        return;
    }
    int rest = at->rest > 0 ? at->rest - 1 : 0;
    for (int k = 1; k >= 0; k--) {
        const struct node *a = of_f ? &z->f.node[first + k] : f, *b = of_f ? g : &z->g.node[first + k];
        if (nodes_meet(a, b)) {
            pair_push(z, at->level, of_f ? first + k : at->f, of_f ? at->g : first + k, rest);
        }
    }
}

/* The whole curve in 1, 2 or 4 parts by how far it is from straight; 0: no memory. */
static int parts(struct tree *tree, const struct source *c, int root, bool least_two, int part[4])
{
    const struct node *a = &tree->node[root];
    part[0] = root;
    if (!least_two && 8 * a->bend <= 3 * c->n * (c->n - 1) * a->speed / 2) {
        return 1;
    }
    int half = node_split(tree, c, root);
    part[0] = half;
    part[1] = half + 1;
    if (!half || 2 * a->bend <= c->n * (c->n - 1) * a->speed) {
        return half ? 2 : 0;
    }
    for (int k = 1; k >= 0; k--) {
        int quarter = node_split(tree, c, half + k);
        if (!quarter) {
            return 0;
        }
        part[2 * k] = quarter;
        part[2 * k + 1] = quarter + 1;
    }
    return 4;
}

bool pair_split_root(struct solver *z, const struct pair *at)
{
    const struct level *v = &z->level[0];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    int of_f[4], of_g[4];
    bool larger_f = f->bend >= g->bend;
    int n = parts(&z->f, &v->f, at->f, larger_f, of_f), m = parts(&z->g, &v->g, at->g, !larger_f, of_g);
    for (int i = n - 1; i >= 0 && m > 0; i--) {
        for (int k = m - 1; k >= 0; k--) {
            if (nodes_meet(&z->f.node[of_f[i]], &z->g.node[of_g[k]])) {
                pair_push(z, 0, of_f[i], of_g[k], 0);
            }
        }
    }
    return n > 0 && m > 0;
}
