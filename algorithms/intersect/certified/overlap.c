/* Shared arcs: found from their ends, removed from what the cells have to settle.
 *
 * Two arcs of algebraic curves that agree at infinitely many points lie on one curve, and agree until one of
 * them ends.  So both ends of a shared arc are ends of f or of g: each end of either curve is sought on the
 * other, and every two such places are tried as the ends of one (overlap_compare.c).
 *
 * Then the search begins anew.  Let a pair be two graphs over one direction (graphs.c): every x has at most
 * one t and one s, so that all solutions in it lie on the curve in the parameter plane where the abscissas
 * agree.  If they agree within the overlap's rectangle all along the common range, all solutions of the pair
 * are in that rectangle, and the record holds them. To leave other solutions in that rectangle alone, the gap
 * must be closed in the middle and at both ends of the range. */
#include "graphs.h"
#include "overlap.h"

enum { PLACES_MAX = 32 };

struct places {
    int count;
    real t[PLACES_MAX], s[PLACES_MAX];
    bool tried[PLACES_MAX][PLACES_MAX]; /* from one place to another */
};

static void place_add(struct places *p, real t, real s)
{
    const real same = real_ldexp(1, -REAL_BITS / 2);
    for (int i = 0; i < p->count; i++) {
        if (real_abs(p->t[i] - t) <= same && real_abs(p->s[i] - s) <= same) {
            return;
        }
    }
    if (p->count < PLACES_MAX) {
        p->t[p->count] = t;
        p->s[p->count++] = s;
    }
}

static real square_distance(const struct source *c, real t, real x, real y)
{
    struct spot p;
    source_at(c, t, &p);
    return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
}

/* Parameter of the point of c nearest to (x, y), from *t, and how far it is; at a cusp, which Gauss and
 * Newton's method approaches slowly, by the derivative's zero. */
static real match(const struct source *c, real x, real y, real near, real *t)
{
    const real nearby = real_ldexp(1, -8);
    struct spot p;
    real distance = source_match(c, x, y, 0, 1, t), at = *t;
    if (!source_cusp(c, &at) || real_abs(at - *t) > nearby) {
        return distance;
    }
    source_at(c, at, &p);
    real there = real_max(real_abs(p.x - x), real_abs(p.y - y));
    if (there > real_max(near, distance)) {
        return distance;
    }
    *t = at;
    return there;
}

/* From parameter i / steps; and from its neighbours too where the curve turns back between them. */
static bool match_about(const struct source *c, real x, real y, real near, int i, int steps, real *t)
{
    *t = (real)i / (real)steps;
    if (match(c, x, y, near, t) <= near) {
        return true;
    }
    if (i == 0 || i == steps) {
        return false;
    }
    struct spot p, q;
    real before = (real)(i - 1) / (real)steps, after = (real)(i + 1) / (real)steps;
    source_at(c, before, &p);
    source_at(c, after, &q);
    if (p.dx * q.dx + p.dy * q.dy > 0) {
        return false;
    }
    *t = before;
    if (match(c, x, y, near, t) <= near) {
        return true;
    }
    *t = after;
    return match(c, x, y, near, t) <= near;
}

/* Where `other` passes within `near` of an end of c. */
static void places_of_end(const struct source *c, real end, const struct source *other, real near,
                          bool c_is_f, struct places *out)
{
    struct spot p;
    int steps = 6 * other->n + 2;
    source_at(c, end, &p);
    real before = REAL_HUGE, now = square_distance(other, 0, p.x, p.y);
    for (int i = 0; i <= steps; i++) {
        real next = i < steps ? square_distance(other, (real)(i + 1) / (real)steps, p.x, p.y) : REAL_HUGE;
        real at;
        if (now <= before && now <= next && match_about(other, p.x, p.y, near, i, steps, &at)) {
            place_add(out, c_is_f ? end : at, c_is_f ? at : end);
        }
        before = now;
        now = next;
    }
}

/* ---- arcs ---- */

static bool is_known(const struct crossings *out, const struct shared *x)
{
    for (int i = 0; i < out->overlaps; i++) {
        const struct overlap *o = &out->overlap[i];
        if (o->t_outer.lo <= x->t0 && x->t1 <= o->t_outer.hi && o->s_outer.lo <= real_min(x->s0, x->s1) &&
            real_max(x->s0, x->s1) <= o->s_outer.hi && o->reversed == (x->s0 > x->s1)) {
            return true;
        }
    }
    return false;
}

/* Is the middle of the arc on the other curve at all? */
static bool is_likely(const struct level *v, const struct shared *x, real near)
{
    struct spot p;
    real s = (x->s0 + x->s1) / 2;
    source_at(&v->f, (x->t0 + x->t1) / 2, &p);
    return source_match(&v->g, p.x, p.y, real_min(x->s0, x->s1), real_max(x->s0, x->s1), &s) <= near;
}

static bool try_arc(struct solver *z, const struct shared *x, real near)
{
    const struct level *v = &z->level[0];
    if (is_known(z->out, x) || !is_likely(v, x, near)) {
        return false;
    }
    real distance = shared_distance(v, x, near);
    return distance >= 0 && distance <= near && overlap_record(z, x, distance);
}

/* The longest arc in t between two places that has not been tried. */
static bool next_arc(struct places *p, real least, struct shared *out)
{
    real most = least;
    int from = 0, to = 0;
    for (int i = 0; i < p->count; i++) {
        for (int k = 0; k < p->count; k++) {
            real length = p->t[k] - p->t[i];
            if (length > most && real_abs(p->s[k] - p->s[i]) > least && !p->tried[i][k]) {
                most = length;
                from = i;
                to = k;
            }
        }
    }
    p->tried[from][to] = true;
    out->t0 = p->t[from];
    out->t1 = p->t[to];
    out->s0 = p->s[from];
    out->s1 = p->s[to];
    return most > least;
}

bool overlap_find(struct solver *z, int looser)
{
    const struct level *v = &z->level[0];
    const real near = real_ldexp(64 * (v->f.node_error + v->g.node_error), looser),
               least = real_ldexp(1, -REAL_BITS / 3);
    struct places p;
    struct shared arc;
    bool found = false;
    p.count = 0;
    for (int end = 0; end <= 1; end++) {
        places_of_end(&v->f, end, &v->g, near, true, &p);
        places_of_end(&v->g, end, &v->f, near, false, &p);
    }
    for (int i = 0; i < p.count; i++) {
        for (int k = 0; k < p.count; k++) {
            p.tried[i][k] = false;
        }
    }
    while (next_arc(&p, least, &arc)) {
        found = try_arc(z, &arc, near) || found;
    }
    return found;
}

/* ---- cells ---- */

static bool is_shared(const struct solver *z, const struct level *v, const struct overlap *o,
                      const struct gap_view *at)
{
    const real flat = real_ldexp(1, -REAL_BITS / 4);
    const struct level *all = &z->level[0];
    struct interval t = level_t(v, at->t, at->t), s = level_s(v, at->s, at->s);
    real most = (2 * o->distance + 64 * (all->f.node_error + all->g.node_error)) * v->factor;
    return o->t_outer.lo <= t.lo && t.hi <= o->t_outer.hi && o->s_outer.lo <= s.lo && s.hi <= o->s_outer.hi &&
           real_abs(at->gap) <= most && real_abs(at->slope) <= flat;
}

/* The view at abscissa x, both parameters as near as they can be. */
static bool look_closely(const struct level *v, const struct node *f, const struct node *g,
                         const struct graphs *h, real x, struct gap_view *out)
{
    real t, s;
    if (!gap_look_at(v, f, g, h, x, out)) {
        return false;
    }
    gap_step(f, g, x, out, &t, &s);
    gap_look(v, h, t, s, out);
    return true;
}

bool overlap_holds(const struct solver *z, int level, const struct node *f, const struct node *g,
                   const struct graphs *h)
{
    const struct level *v = &z->level[level];
    if (z->out->overlaps == 0) {
        return false;
    }
    struct gap_view first, middle, last;
    if (!look_closely(v, f, g, h, h->x.lo, &first) ||
        !look_closely(v, f, g, h, (h->x.lo + h->x.hi) / 2, &middle) ||
        !look_closely(v, f, g, h, h->x.hi, &last)) {
        return false;
    }
    for (int i = 0; i < z->out->overlaps; i++) {
        const struct overlap *o = &z->out->overlap[i];
        if (is_shared(z, v, o, &first) && is_shared(z, v, o, &middle) && is_shared(z, v, o, &last)) {
            return true;
        }
    }
    return false;
}
