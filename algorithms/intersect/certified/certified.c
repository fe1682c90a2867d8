/* Every crossing proved, every contact resolved or owned up to.
 *
 * Pairs of nodes, halved where they may meet.  A pair is closed as soon as something proves what it holds:
 *
 * - octagons apart: nothing (nodes.c);
 * - all directions cross all others the same way: at most one solution, decided, found and proved by Newton's
 * method on the extended pair (cone.c, solve_one.c, ends.c);
 * - strips along the chords apart: nothing; arcs side by side that turn differently: none, two, or a contact
 * (graphs.c, contact.c); a derivative of the gap of one sign: at most so many (cluster.c); a cusp at a
 * cusp: at most so many (cusps.c, cusps_common.c), and none around them (rings.c);
 * - a shared arc (overlap.c); a curve that is one point (point.c).
 *
 * Where rounding hides what is there, the place is cut again with twice the digits (zoom.c).  What is still
 * open when both parameters are as narrow as asked is a CANDIDATE.  Every pair that leaves the stack is
 * empty, or its solutions lie in records: so do all. */
#include "front.h"
#include "graphs.h"

enum { FIRST_LOOK = 64 }; /* steps before overlaps are looked for */

/* ---- memory: one block of scratch, laid out by the degrees ---- */

static size_t numbers_for(size_t bytes)
{
    return bytes / sizeof(real) + 2;
}

static int node_stride(int n)
{
    return 7 * n + 1; /* 3 (n + 1) coordinates, 2 (2 n - 1) of directions */
}

static size_t level_length(int n, int m)
{
    return 5 * (size_t)(n + 1 + m + 1) + source_length(n) + source_length(m);
}

size_t certified_scratch(int n, int m)
{
    size_t in_front = front_scratch(n, m);
    size_t own =
        2 * numbers_for(NODES_MAX * sizeof(struct node)) + numbers_for(PAIRS_MAX * sizeof(struct pair)) +
        (size_t)NODES_MAX * (size_t)(node_stride(n) + node_stride(m)) + LEVELS_MAX * level_length(n, m);
    return own > in_front ? own : in_front; /* one after the other */
}

static real *take(real **at, size_t numbers)
{
    real *taken = *at;
    *at += numbers;
    return taken;
}

static void tree_init(struct tree *tree, int n, real **at)
{
    tree->used = 0;
    tree->spare = 0;
    tree->stride = node_stride(n);
    tree->node = (struct node *)(void *)take(at, numbers_for(NODES_MAX * sizeof(struct node)));
    tree->numbers = take(at, (size_t)NODES_MAX * (size_t)tree->stride);
}

static void solver_init(struct solver *z, const struct problem *p, struct workspace *w, struct crossings *out)
{
    int n = p->f.degree, m = p->g.degree;
    real *at = w->scratch;
    z->p = p;
    z->w = w;
    z->out = out;
    z->outcome = SOLVED;
    tree_init(&z->f, n, &at);
    tree_init(&z->g, m, &at);
    z->pair = (struct pair *)(void *)take(&at, numbers_for(PAIRS_MAX * sizeof(struct pair)));
    z->level_stride = level_length(n, m);
    z->level_numbers = at;
    z->levels = z->pairs = z->solved = 0;
    z->next_look = w->steps + FIRST_LOOK;
    z->wider = 1;
    z->turns = false;
    z->suspicions = z->looks = z->overlap_looks = z->rings = 0;
    z->narrow_t = p->bounds.tolerance_t;
    z->narrow_s = p->bounds.tolerance_s;
    z->alone = false;
}

/* ---- level 0 ---- */

/* A rational curve's homogeneous coordinates came rounded. */
static void source_of(const struct curve *c, real scale, real node_error, struct source *out)
{
    out->n = c->degree;
    out->rational = c->w != NULL;
    out->points = c->x;
    out->low = NULL;
    out->error = c->w ? REAL_EPSILON * scale : (real)0;
    out->node_error = node_error;
}

/* The whole of c; it shares c's points, and is never written to. */
static int root_make(struct tree *tree, const struct source *c)
{
    int k = node_new(tree);
    struct node *root = &tree->node[k];
    root->way = root->points;
    root->points = (real *)c->points;
    node_root(c, root);
    return k;
}

/* Level 0 and its roots; false: the octagons are apart. */
static bool begin(struct solver *z)
{
    const struct problem *p = z->p;
    struct level *v = &z->level[0];
    real scale = real_max(p->bounds.scale, (real)1);
    v->scale = scale;
    v->factor = 1;
    v->t.lo = v->s.lo = 0;
    v->t.hi = v->s.hi = 1;
    source_of(&p->f, scale, p->bounds.f, &v->f);
    source_of(&p->g, scale, p->bounds.g, &v->g);
    int f = root_make(&z->f, &v->f), g = root_make(&z->g, &v->g);
    if (!nodes_meet(&z->f.node[f], &z->g.node[g])) {
        return false;
    }
    source_init(&v->f, scale, z->level_numbers);
    source_init(&v->g, scale, z->level_numbers + source_length(v->f.n));
    z->levels = 1;
    z->root_f = f;
    z->root_g = g;
    return true;
}

/* The whole problem, or what a front left of it. */
static void begin_with_all(struct solver *z, const struct rest *rest)
{
    (void)rest;
    pair_push(z, 0, z->root_f, z->root_g, 0);
}

/* What is proved about two cusps often holds for the pairs around them too. */
static void cusps_first(struct solver *z)
{
    const struct level *v = &z->level[0];
    for (int i = 0, last = z->pairs; i < last && z->pairs > 1;) {
        struct pair at = z->pair[i];
        struct node *f = &z->f.node[at.f], *g = &z->g.node[at.g];
        node_prepare(&v->f, f);
        node_prepare(&v->g, g);
        if (f->wide && g->wide) {
            z->pair[i] = z->pair[--last];
            z->pair[last] = at;
        } else {
            i++;
        }
    }
}

static void begin_with_rest(struct solver *z, const struct rest *rest)
{
    for (int i = 0; i < rest->count; i++) {
        pair_push_rectangle(z, &rest->at[i].t, &rest->at[i].s);
    }
    cusps_first(z);
}

/* ---- one pair ---- */

/* Narrower parts show no more than rounding of their second and third derivatives. */
static real least_width(void)
{
    return real_ldexp(1, -REAL_BITS / 4);
}

/* Two graphs that no test has settled, cut down to what they have in common in x.  If they only meet at a
 * corner, there may be three more pairs that do: a closer look settles all. */
static enum verdict cut_to_common(struct solver *z, const struct pair *at, const struct graphs *h)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    const real worth = (real)0.5, small = (real)1 / 64;
    struct zero common;
    graphs_common(f, g, h, 0, &common);
    if (region_is_solved(z, at->level, &common)) {
        return CLOSED;
    }
    bool corner = common.rt <= small * (f->hi - f->lo) && common.rs <= small * (g->hi - g->lo);
    graphs_common(f, g, h, least_width(), &common);
    if (corner && region_look(z, at->level, &common) == CLOSED) {
        return CLOSED;
    }
    bool less = 2 * common.rt <= worth * (f->hi - f->lo) || 2 * common.rs <= worth * (g->hi - g->lo);
    return less ? pair_narrow(z, at, &common) : OPEN;
}

/* Do they have so little in common in x that cutting them down to it is worth it?  What one does beyond the
 * other's end, where a rounded corner goes on as the same curve, is then beside the point. */
static bool have_little(const struct node *f, const struct node *g, const struct graphs *h)
{
    const real worth = (real)0.5;
    struct zero common;
    graphs_common(f, g, h, 0, &common);
    return 2 * common.rt <= worth * (f->hi - f->lo) || 2 * common.rs <= worth * (g->hi - g->lo);
}

/* Both may point back along their chords.  Where an overlap ends at a cusp of both, halves say nothing new
 * before rounding hides them. */
static enum verdict settle_turning(struct solver *z, struct pair *at)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    const real small = (real)1 / 256, tiny = least_width();
    real product = (f->hi - f->lo) * (g->hi - g->lo);
    if (at->level > 0 || product <= small) {
        if (cusps_settle(z, at) == CLOSED) {
            return CLOSED;
        }
    }
    struct zero x = {(f->lo + f->hi) / 2, (g->lo + g->hi) / 2, (f->hi - f->lo) / 2, (g->hi - g->lo) / 2};
    return z->out->overlaps > 0 && product <= tiny * tiny ? region_look(z, at->level, &x) : OPEN;
}

/* Arcs with parallel directions.  Looks for contacts rest for two splits when they fail. */
static enum verdict settle_beside(struct solver *z, struct pair *at)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    const real small = (real)1 / 1024;
    struct graphs h;
    if (!f->wide && !g->wide && strips_apart(v, f, g)) {
        return CLOSED;
    }
    bool last = narrow_t(z, v, f) && narrow_s(z, v, g);
    if (at->rest > 0 && !last) {
        return OPEN;
    }
    if (f->wide && g->wide) {
        return settle_turning(z, at);
    }
    bool graphs = !f->wide && !g->wide && graphs_init(v, f, g, &h);
    if (graphs && (h.apart || overlap_holds(z, at->level, f, g, &h) ||
                   contact_settle(z, at->level, f, g, &h) == CLOSED)) {
        return CLOSED;
    }
    at->rest = 2;
    int most = graphs && have_little(f, g, &h) ? 2 : (int)DEGREE_MAX;
    if (at->level > 0 && cluster_settle(z, at, most) == CLOSED) {
        return CLOSED;
    }
    if (graphs && cut_to_common(z, at, &h) == CLOSED) {
        return CLOSED;
    }
    return at->level == 0 && (f->hi - f->lo) * (g->hi - g->lo) <= small ? cluster_settle(z, at, DEGREE_MAX)
                                                                        : OPEN;
}

static enum verdict settle(struct solver *z, struct pair *at)
{
    const struct level *v = &z->level[at->level];
    struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    if (z->solved + z->rings + z->out->overlaps > 0) {
        struct interval t = level_t(v, f->lo, f->hi), s = level_s(v, g->lo, g->hi);
        if (is_solved(z, at->level, &t, &s) || overlap_turns(z, &t, &s) ||
            (z->rings > 0 && is_in_ring(z, &t, &s))) {
            return CLOSED;
        }
    }
    node_prepare(&v->f, f);
    node_prepare(&v->g, g);
    real c = cone_gap(f, g);
    if (c > 0) {
        struct zero x;
        enum search search = solve_one(v, f, g, c, &x);
        if (search == NO_ZERO || (search == ZERO && zero_settle(z, at->level, f, g, &x) == CLOSED)) {
            return CLOSED;
        }
        return OPEN;
    }
    return settle_beside(z, at);
}

/* Once in a while, where there is too much to do: if there is a shared arc, all begins anew without it.  The
 * longer it takes, the farther apart the arcs may be: nearly one, they are told as one, with how far, before
 * the places where they meet fill thousands of records. */
static void look_for_overlaps(struct solver *z)
{
    const int times = 8, first = FIRST_LOOK;
    int looser = z->overlap_looks == 0 ? 0 : z->overlap_looks == 1 ? 7 : 16;
    z->overlap_looks++;
    z->next_look = times * (z->next_look < first ? first : z->next_look);
    bool late = z->w->steps >= times * first;
    if ((late && overlap_widen(z)) || overlap_find(z, looser)) {
        z->out->count = 0;
        z->out->merged = false;
        z->outcome = SOLVED;
        z->levels = 1;
        z->solved = z->pairs = 0;
        pair_push(z, 0, z->root_f, z->root_g, 0);
    }
}

/* Levels above `level` have no pairs left: what they stood for is settled. */
static void levels_drop(struct solver *z, int level)
{
    for (int i = 0; i < z->solved && i < SOLVED_MAX; i++) {
        if (z->solved_at[i].level > level) {
            z->solved_at[i].level = 0;
        }
    }
    z->levels = level + 1;
}

/* Counts a step of a level above 0; true if there are none left. */
static bool level_is_over(struct solver *z, int level)
{
    struct level *v = &z->level[level];
    if (v->records < 0) {
        v->records = z->out->count;
    }
    return --v->steps < 0;
}

static bool is_crowded(const struct tree *tree)
{
    return !tree->spare && tree->used + 8 >= NODES_MAX;
}

static bool is_root(const struct solver *z, const struct pair *at)
{
    return at->level == 0 && at->f == z->root_f && at->g == z->root_g;
}

/* The pair on top of the stack is settled, split, or accepted. */
static void step(struct solver *z)
{
    struct pair at = z->pair[--z->pairs];
    if (at.level + 1 < z->levels) {
        levels_drop(z, at.level);
    }
    if (z->w->steps >= z->p->max_steps) {
        z->outcome = OUT_OF_STEPS;
        pair_accept(z, &at);
        return;
    }
    z->w->steps++;
    if (at.level > 0 && level_is_over(z, at.level)) {
        level_give_up(z);
    } else if (settle(z, &at) == OPEN && !(is_root(z, &at) && pair_split_root(z, &at))) {
        pair_split(z, &at);
    }
}

static void settle_all(struct solver *z)
{
    while (z->pairs > 0) {
        if (!z->alone && z->w->steps >= z->next_look) {
            look_for_overlaps(z);
        }
        if (is_crowded(&z->f) || is_crowded(&z->g)) {
            nodes_collect(z);
        }
        step(z);
    }
}

enum outcome certified_search(const struct problem *p, struct workspace *w, struct crossings *out,
                              void (*begin_with)(struct solver *z, const struct rest *rest),
                              const struct rest *rest)
{
    struct solver z;
    solver_init(&z, p, w, out);
    if (!begin(&z)) {
        return SOLVED;
    }
    begin_with(&z, rest);
    if (!z.alone && point_settle(&z)) {
        return z.outcome;
    }
    settle_all(&z);
    records_tidy(&z);
    return z.outcome;
}

static enum outcome intersect_scalar(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return certified_search(p, w, out, begin_with_all, NULL);
}

static enum outcome search_rest(const struct problem *p, const struct rest *rest, struct workspace *w,
                                struct crossings *out)
{
    return rest->count == 0 ? SOLVED : certified_search(p, w, out, begin_with_rest, rest);
}

/* A front that refused the problem as it came may still take the prepared one. */
static enum outcome intersect_with(bool many, const struct problem *p, struct workspace *w,
                                   struct crossings *out)
{
    struct rest rest;
    if (p->rest) {
        return search_rest(p, p->rest, w, out);
    }
    return front_of_prepared(many, p, w, out, &rest) ? search_rest(p, &rest, w, out)
                                                     : intersect_scalar(p, w, out);
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return intersect_with(true, p, w, out);
}

static enum outcome intersect_avx2(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return intersect_with(false, p, w, out);
}

#define REFERENCE                                                                                            \
    "here; cones of directions: Sederberg and Meyers, Loop detection in surface patch intersections, 1988"

extern const struct intersector certified;
const struct intersector certified = {
    .name = "certified",
    .summary = "every crossing proved by cross products, every contact resolved or owned up to",
    .reference = REFERENCE,
    .claimed = {0, 0, 0, 0},
    .intersect = intersect,
    .scratch = certified_scratch,
    .points_only = false,
    .front = front_of_certified,
};

extern const struct intersector certified_avx2;
const struct intersector certified_avx2 = {
    .name = "certified_avx2",
    .summary = "the same without kernels for processors that have more than AVX2",
    .reference = REFERENCE,
    .claimed = {0, 0, 0, 0},
    .intersect = intersect_avx2,
    .scratch = certified_scratch,
    .points_only = false,
    .front = front_of_certified_avx2,
};

extern const struct intersector certified_scalar;
const struct intersector certified_scalar = {
    .name = "certified_scalar",
    .summary = "the same without kernels for particular processors",
    .reference = REFERENCE,
    .claimed = {0, 0, 0, 0},
    .intersect = intersect_scalar,
    .scratch = certified_scratch,
    .points_only = false,
};
