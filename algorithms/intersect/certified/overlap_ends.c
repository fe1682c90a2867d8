/* How far the ends of a shared arc are known, and pairs at a cusp of it.
 *
 * An end of f, say, is known exactly in t; its place on g to the distance of the arcs over g's speed.  Where
 * g has a cusp there, it is known to the root of the distance over half the second derivative only.
 *
 * Beside a cusp, be it at an end or inside, the one curve before it and the other after it have a gap that
 * grows with the third power of the parameter: so near to it pairs are settled with twice the digits at best.
 * What is in the overlap's outer rectangle and as near to the cusp as an end would be known, in both
 * parameters, belongs to the overlap, whose record holds it: nothing is lost.  Where it takes long all the
 * same, `wider` makes this larger. */
#include "graphs.h"
#include "overlap.h"

static real speed_at(const struct source *c, real at)
{
    struct spot p;
    source_at(c, at, &p);
    return real_max(real_abs(p.dx), real_abs(p.dy));
}

/* At a cusp; twice that for what is neither the one nor the other. */
static real turned(const struct source *c, real end, real most)
{
    real ddx, ddy;
    source_second(c, end, real_ldexp(1, -12), &ddx, &ddy);
    real bend = real_max(real_abs(ddx), real_abs(ddy));
    return bend > 0 ? 2 * real_sqrt(2 * most / bend) : (real)1;
}

static bool is_cusp(const struct source *c, real end, real most)
{
    return speed_at(c, end) * turned(c, end, most) < most;
}

static real uncertainty(const struct solver *z, const struct source *c, real end, real distance)
{
    real most = 2 * distance + 64 * c->node_error, speed = speed_at(c, end);
    if (is_cusp(c, end, most)) {
        return z->wider * turned(c, end, most);
    }
    return speed > 0 ? most / speed : (real)1;
}

/* From the ends of an arc; those of c's own domain are exact.  The inner range keeps away from a cusp all the
 * same, as that of the other curve does. */
static void range_make(const struct solver *z, const struct source *c, real a, real b, real distance,
                       struct interval *outer, struct interval *inner)
{
    real first = real_min(a, b), last = real_max(a, b);
    real before = uncertainty(z, c, first, distance), after = uncertainty(z, c, last, distance);
    outer->lo = clamp(first - before, 0, 1);
    outer->hi = clamp(last + after, 0, 1);
    real most = 2 * distance + 64 * c->node_error;
    inner->lo = first == 0 && !is_cusp(c, first, most) ? first : first + before;
    inner->hi = last == 1 && !is_cusp(c, last, most) ? last : last - after;
}

static bool is_some(const struct overlap *o)
{
    return o->t_inner.lo < o->t_inner.hi && o->s_inner.lo < o->s_inner.hi;
}

bool overlap_record(struct solver *z, const struct shared *x, real distance)
{
    const struct level *v = &z->level[0];
    if (z->out->overlaps == OVERLAPS_MAX) {
        return false;
    }
    struct overlap *o = &z->out->overlap[z->out->overlaps];
    range_make(z, &v->f, x->t0, x->t1, distance, &o->t_outer, &o->t_inner);
    range_make(z, &v->g, x->s0, x->s1, distance, &o->s_outer, &o->s_inner);
    o->reversed = x->s0 > x->s1;
    o->exact = false;
    o->distance = distance;
    z->out->overlaps += is_some(o);
    return is_some(o);
}

/* The ends of the arc; where the outer range ends with the domain, the domain's. */
static real end_of(const struct interval *outer, const struct interval *inner, bool last)
{
    if (last ? outer->hi == 1 : outer->lo == 0) {
        return last;
    }
    return last ? (outer->hi + inner->hi) / 2 : (outer->lo + inner->lo) / 2;
}

bool overlap_widen(struct solver *z)
{
    const int times = 16, most = 4096;
    const struct level *v = &z->level[0];
    if (!z->turns || times * z->wider > most) {
        return false;
    }
    z->wider = times * z->wider;
    for (int i = 0; i < z->out->overlaps; i++) {
        struct overlap *o = &z->out->overlap[i], now = *o;
        range_make(z, &v->f, end_of(&o->t_outer, &o->t_inner, false), end_of(&o->t_outer, &o->t_inner, true),
                   o->distance, &now.t_outer, &now.t_inner);
        range_make(z, &v->g, end_of(&o->s_outer, &o->s_inner, false), end_of(&o->s_outer, &o->s_inner, true),
                   o->distance, &now.s_outer, &now.s_inner);
        if (is_some(&now)) {
            *o = now;
        }
    }
    return true;
}

/* Is all of a no farther from a cusp of c than that is known?  *near: is there one not far? */
static bool is_at_cusp(const struct solver *z, const struct source *c, const struct interval *a,
                       real distance, bool *near)
{
    const real small = real_ldexp(1, -REAL_BITS / 6);
    real middle = (a->lo + a->hi) / 2, at = middle;
    *near = source_cusp(c, &at) && real_abs(at - middle) <= small;
    real pad = *near ? uncertainty(z, c, at, distance) : (real)0;
    return *near && at - pad <= a->lo && a->hi <= at + pad;
}

static bool lies_within(const struct interval *a, const struct interval *b)
{
    return b->lo <= a->lo && a->hi <= b->hi;
}

bool overlap_turns(struct solver *z, const struct interval *t, const struct interval *s)
{
    const real small = real_ldexp(1, -REAL_BITS / 4);
    const struct level *v = &z->level[0];
    if (t->hi - t->lo > small || s->hi - s->lo > small) {
        return false;
    }
    for (int i = 0; i < z->out->overlaps; i++) {
        const struct overlap *o = &z->out->overlap[i];
        bool near_f, near_g;
        if (!lies_within(t, &o->t_outer) || !lies_within(s, &o->s_outer)) {
            continue;
        }
        bool of_f = is_at_cusp(z, &v->f, t, o->distance, &near_f);
        bool of_g = is_at_cusp(z, &v->g, s, o->distance, &near_g);
        z->turns = z->turns || (near_f && near_g);
        if (of_f && of_g) {
            return true;
        }
    }
    return false;
}
