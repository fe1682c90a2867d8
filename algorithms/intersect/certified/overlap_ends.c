/* How far the ends of a shared arc are known, and pairs that are nearer to one than that.
 *
 * An end of f, say, is known exactly in t; its place on g to the distance of the arcs over g's speed.  Where
 * g has a cusp there, it is known to the root of the distance over half the second derivative only; and on
 * the other side of the cusp, where the gap grows with the third power of the parameter, pairs are settled
 * with twice the digits at best.  So what is nearer to the end than that, in both parameters, belongs to the
 * overlap, whose outer rectangle holds it: nothing is lost.  Where it takes too long all the same, these
 * rectangles become larger. */
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
    source_second(c, end, &ddx, &ddy);
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

/* Nearer to an end of the domain than is known, it is that. */
static real end_of(const struct interval *outer, const struct interval *inner, bool last)
{
    if (last ? outer->hi == 1 : outer->lo == 0) {
        return last;
    }
    return last ? (outer->hi + inner->hi) / 2 : (outer->lo + inner->lo) / 2;
}

/* Does an arc end at a cusp of c? */
static bool turns(const struct source *c, const struct interval *outer, const struct interval *inner,
                  real distance)
{
    real most = 2 * distance + 64 * c->node_error;
    return is_cusp(c, end_of(outer, inner, false), most) || is_cusp(c, end_of(outer, inner, true), most);
}

bool overlap_widen(struct solver *z)
{
    const int times = 16, most = 4096;
    const struct level *v = &z->level[0];
    bool any = false;
    z->wider = times * z->wider;
    for (int i = 0; i < z->out->overlaps && z->wider <= most; i++) {
        struct overlap *o = &z->out->overlap[i], now = *o;
        if (!turns(&v->f, &o->t_outer, &o->t_inner, o->distance) &&
            !turns(&v->g, &o->s_outer, &o->s_inner, o->distance)) {
            continue;
        }
        range_make(z, &v->f, end_of(&o->t_outer, &o->t_inner, false), end_of(&o->t_outer, &o->t_inner, true),
                   o->distance, &now.t_outer, &now.t_inner);
        range_make(z, &v->g, end_of(&o->s_outer, &o->s_inner, false), end_of(&o->s_outer, &o->s_inner, true),
                   o->distance, &now.s_outer, &now.s_inner);
        if (is_some(&now)) {
            *o = now;
            any = true;
        }
    }
    return any;
}

/* What of the outer range is no farther from an end than that is known. */
static struct interval corner(const struct solver *z, const struct source *c, const struct interval *outer,
                              const struct interval *inner, bool last, real distance)
{
    real end = end_of(outer, inner, last), pad = uncertainty(z, c, end, distance);
    struct interval out = {real_max(outer->lo, end - pad), real_min(outer->hi, end + pad)};
    return out;
}

static bool lies_within(const struct interval *a, const struct interval *b)
{
    return b->lo <= a->lo && a->hi <= b->hi;
}

bool overlap_ends(const struct solver *z, const struct interval *t, const struct interval *s)
{
    const struct level *v = &z->level[0];
    for (int i = 0; i < z->out->overlaps; i++) {
        const struct overlap *o = &z->out->overlap[i];
        bool within = lies_within(t, &o->t_outer) && lies_within(s, &o->s_outer);
        for (int last = 0; last <= 1 && within; last++) {
            struct interval at = corner(z, &v->f, &o->t_outer, &o->t_inner, last, o->distance);
            struct interval as =
                corner(z, &v->g, &o->s_outer, &o->s_inner, (last != 0) != o->reversed, o->distance);
            if (lies_within(t, &at) && lies_within(s, &as)) {
                return true;
            }
        }
    }
    return false;
}
