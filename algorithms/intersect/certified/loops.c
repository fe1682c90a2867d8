/* Where a curve crosses itself: f(t) = f(s) with t < s, the curve given as f and as g; and where two curves
 * meet beside the end of f that is, exactly, the beginning of g.
 *
 * The triangle t < s is cut into pairs of nodes.  Two nodes I and J with a corner in common, or one node with
 * itself, are closed if all their directions have a positive product with one vector d: then f.d grows
 * strictly all along I and J (I before J), and no point is met twice.  Else they are halved: of I with itself
 * the halves with themselves and with each other; of two neighbours the inner halves are neighbours, and the
 * other three pairs have a gap between them: they are the certified algorithm's.  Where the curve is regular
 * all parts that are short enough are closed; what remains when they are as narrow as asked, a cusp, is a
 * CANDIDATE.
 *
 * A polynomial cubic has a closed form instead (loop_cubic.c).
 *
 * Where another curve comes back nearly as it went, at a cusp or a line that is folded, candidates are many:
 * if they are too many, the triangle is cut again with a tolerance 64 times as wide, and so on, and
 * candidates that touch become one.
 *
 * Of two curves with a joint, the first pair is that of neighbours.
 *
 * Of one curve a record's t is below its s, and none is found twice.  The ends of a closed curve, t = 0 and s
 * = 1, are a solution like any other.  Shared arcs are not looked for: there it takes all its steps, and
 * candidates cover what is left.
 *
 * Rounding of d.A, A = A~ + e with |e| <= error in each coordinate: error |d|_1, and 2 u |A~|_1 |d|_1 in
 * 1-norms of products; speed bounds |A|_1. */
#include "evaluate.h"
#include "loops.h"

static bool goes_along(const struct node *a, real dx, real dy)
{
    real bound = (a->error + 4 * REAL_EPSILON * a->speed) * (real_abs(dx) + real_abs(dy)) * 2;
    for (int i = 0; i < a->ways; i++) {
        if (!(a->way[i] * dx + a->way[a->ways + i] * dy > bound)) {
            return false;
        }
    }
    return true;
}

/* Adds the sum of the directions, of length 1. */
static void add_heading(const struct node *a, real *dx, real *dy)
{
    real x = 0, y = 0;
    for (int i = 0; i < a->ways; i++) {
        x += a->way[i];
        y += a->way[a->ways + i];
    }
    real length = real_abs(x) + real_abs(y);
    if (length > 0) {
        *dx += x / length;
        *dy += y / length;
    }
}

static bool runs_straight(const struct node *a, const struct node *b)
{
    real dx = 0, dy = 0;
    add_heading(a, &dx, &dy);
    add_heading(b, &dx, &dy);
    return goes_along(a, dx, dy) && goes_along(b, dx, dy);
}

static void push_if_met(struct solver *z, int f, int g)
{
    if (nodes_meet(&z->f.node[f], &z->g.node[g])) {
        pair_push(z, 0, f, g, 0);
    }
}

/* Node f of the one tree and g of the other are nothing more to be done with. */
static void accept(struct solver *z, int f, int g)
{
    struct pair at = {f, g, 0, 0};
    pair_accept(z, &at);
}

/* Halves both; false: that cannot be, and the pair is a record. */
static bool halve_both(struct solver *z, int f, int g, int *left_f, int *left_g)
{
    const struct level *v = &z->level[0];
    if (narrow_t(z, v, &z->f.node[f]) && narrow_s(z, v, &z->g.node[g])) {
        accept(z, f, g);
        return false;
    }
    *left_f = node_split(&z->f, &v->f, f);
    *left_g = node_split(&z->g, &v->g, g);
    if (!*left_f || !*left_g) {
        z->outcome = OUT_OF_ROOM;
        accept(z, f, g);
        return false;
    }
    return true;
}

/* f ends where g begins. */
static void begin_with_neighbours(struct solver *z, int f, int g)
{
    for (;;) {
        struct node *a = &z->f.node[f], *b = &z->g.node[g];
        int left_f, left_g;
        node_prepare(&z->level[0].f, a);
        node_prepare(&z->level[0].g, b);
        if (runs_straight(a, b) || !halve_both(z, f, g, &left_f, &left_g)) {
            return;
        }
        push_if_met(z, left_f, left_g);
        push_if_met(z, left_f, left_g + 1);
        push_if_met(z, left_f + 1, left_g + 1);
        f = left_f + 1;
        g = left_g;
    }
}

/* f and g are the same part of the curve. */
static void begin_with_itself(struct solver *z, int f, int g)
{
    struct node *a = &z->f.node[f];
    int left_f, left_g;
    node_prepare(&z->level[0].f, a);
    if (runs_straight(a, a) || !halve_both(z, f, g, &left_f, &left_g)) {
        return;
    }
    begin_with_itself(z, left_f, left_g);
    begin_with_neighbours(z, left_f, left_g + 1);
    begin_with_itself(z, left_f + 1, left_g + 1);
}

static void begin_with_triangle(struct solver *z, const struct rest *rest)
{
    (void)rest;
    z->alone = true;
    begin_with_itself(z, z->root_f, z->root_g);
}

static void begin_with_joint(struct solver *z, const struct rest *rest)
{
    (void)rest;
    z->alone = true;
    begin_with_neighbours(z, z->root_f, z->root_g);
}

static bool is_narrow(const struct problem *p, const struct crossing *c)
{
    return c->t.hi - c->t.lo <= p->bounds.tolerance_t && c->s.hi - c->s.lo <= p->bounds.tolerance_s;
}

static int count_candidates(const struct crossings *out)
{
    int count = 0;
    for (int i = 0; i < out->count; i++) {
        count += out->at[i].standing == CANDIDATE;
    }
    return count;
}

/* SOLVED becomes OUT_OF_STEPS if a CANDIDATE is wider than asked. */
static enum outcome outcome_by_width(const struct problem *p, enum outcome outcome,
                                     const struct crossings *out)
{
    for (int i = 0; i < out->count && outcome == SOLVED; i++) {
        if (out->at[i].standing == CANDIDATE && !is_narrow(p, &out->at[i])) {
            outcome = OUT_OF_STEPS;
        }
    }
    return outcome;
}

/* An eighth of the steps for one search. */
static enum outcome search_once(struct problem *q, int max_steps, struct workspace *w, struct crossings *out)
{
    int more = max_steps / 8 + 1;
    q->max_steps = more < max_steps - w->steps ? w->steps + more : max_steps;
    out->count = 0;
    out->merged = false;
    return certified_search(q, w, out, begin_with_triangle, NULL);
}

/* Where there are too many candidates for the list, the stack or the steps, coarser ones, which are fewer. */
static enum outcome search_triangle(const struct problem *p, struct workspace *w, struct crossings *out)
{
    const real widest = (real)1 / 64, times = 64;
    const int few = 32;
    struct problem q = *p;
    enum outcome outcome = search_once(&q, p->max_steps, w, out);
    while ((out->merged || outcome == OUT_OF_ROOM || w->steps >= q.max_steps) && w->steps < p->max_steps &&
           q.bounds.tolerance_t < widest) {
        q.bounds.tolerance_t = real_min(widest, times * q.bounds.tolerance_t);
        q.bounds.tolerance_s = real_min(widest, times * q.bounds.tolerance_s);
        outcome = search_once(&q, p->max_steps, w, out);
    }
    if (count_candidates(out) > few || q.bounds.tolerance_t > p->bounds.tolerance_t) {
        candidates_unite(out);
    }
    return outcome_by_width(p, outcome, out);
}

static enum outcome find_loops(const struct problem *p, struct workspace *w, struct crossings *out)
{
    struct crossing c;
    switch (cubic_loop_find(&p->f, &c)) {
    case LOOP_NONE:
        return SOLVED;
    case LOOP_FOUND:
        crossings_add(out, &c);
        return outcome_by_width(p, SOLVED, out);
    default:
        return search_triangle(p, w, out);
    }
}

static enum outcome find_beside_joint(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return certified_search(p, w, out, begin_with_joint, NULL);
}

extern const struct intersector certified_loops, certified_joints;
const struct intersector certified_loops = {
    .name = "certified_loops",
    .summary = "where one curve, given twice, crosses itself",
    .reference = "here",
    .claimed = {0, 0, 0, 0},
    .intersect = find_loops,
    .scratch = certified_scratch,
    .points_only = false,
};
const struct intersector certified_joints = {
    .name = "certified_joints",
    .summary = "where two curves meet beside the end of the first, at which the second begins",
    .reference = "here",
    .claimed = {0, 0, 0, 0},
    .intersect = find_beside_joint,
    .scratch = certified_scratch,
    .points_only = false,
};
