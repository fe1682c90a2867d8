/* Newton's method in every lane, and the records.
 *
 * First without bounds, on the powers of t, two times LANES zeros at once, since each step waits for the one
 * before it; a lane stops where its step was small.  Then, on the Bernstein coefficients, steps with the
 * proof of solve_one.c until one is small enough to end with: mostly the first.  A lane that never gets
 * there, whose tangents there are too nearly parallel, or whose zero is not well inside its node, is left
 * alone.  No lane's numbers depend on another's. */
#ifndef FATLINE_BATCH_NEWTON_H
#define FATLINE_BATCH_NEWTON_H

#include "batch_kernel.h"

/* One curve, ready for evaluation, and its node. */
struct side {
    wide x[4], y[4], slope_x[3], slope_y[3];
    wide lo, hi, reach, bend;
};

struct spot {
    wide x, y, dx, dy;
};

/* The last step, as in solve_one.c; but for the signs, and df and dg are 1-norms of the derivatives. */
struct last_step {
    wide dt, ds, det, one, df, dg, error; /* one: 1 / det */
};

LANES_INLINE void side_component(const wide c[4], wide value[4], wide slope[3])
{
    value[0] = c[0];
    value[1] = 3.0 * c[1];
    value[2] = 3.0 * c[2];
    value[3] = c[3];
    slope[0] = 3.0 * (c[1] - c[0]);
    slope[1] = 6.0 * (c[2] - c[1]);
    slope[2] = 3.0 * (c[3] - c[2]);
}

/* LANES zeros that are looked for. */
struct hunt {
    const int *pair;
    wide unit, t, s;
    wide_mask active; /* may have a zero in their nodes */
    struct arc arc[2];
    struct side f, g;
};

LANES_INLINE void hunt_init(const struct batch_chunk *z, const struct batch_solves *q, int first,
                            struct hunt *h)
{
    wide code_f = wide_load(q->f + first), code_g = wide_load(q->g + first);
    h->pair = q->pair + first;
    h->unit = wide_gather(z->unit, wide_load_whole(h->pair));
    h->t = wide_load(q->t + first);
    h->s = wide_load(q->s + first);
    h->active = wide_first(q->count - first);
    load_pairs(z, h->pair, &h->arc[0], &h->arc[1]);
    h->f.lo = code_start(code_f);
    h->f.hi = h->f.lo + code_width(code_f);
    h->f.reach = wide_load(q->reach_t + first);
    h->f.bend = wide_load(q->bend_f + first);
    h->g.lo = code_start(code_g);
    h->g.hi = h->g.lo + code_width(code_g);
    h->g.reach = wide_load(q->reach_s + first);
    h->g.bend = wide_load(q->bend_g + first);
}

/* ---- without bounds ---- */

struct powers {
    wide x[4], y[4];
};

LANES_INLINE void powers_component(const wide c[4], wide out[4])
{
    wide a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
    out[0] = c[0];
    out[1] = 3.0 * a;
    out[2] = 3.0 * (b - a);
    out[3] = (d - b) - (b - a);
}

LANES_INLINE void horner(const wide c[4], wide t, wide *value, wide *slope)
{
    wide b = wide_fma(c[3], t, c[2]), a = wide_fma(b, t, c[1]);
    *slope = wide_fma(wide_fma(c[3], t, b), t, a);
    *value = wide_fma(a, t, c[0]);
}

LANES_INLINE void powers_at(const struct powers *c, const struct side *a, wide t, struct spot *out)
{
    wide inside = wide_min(wide_max(t, a->lo), a->hi), beyond = t - inside;
    horner(c->x, inside, &out->x, &out->dx);
    horner(c->y, inside, &out->y, &out->dy);
    out->x = wide_fma(beyond, out->dx, out->x);
    out->y = wide_fma(beyond, out->dy, out->y);
}

/* Moves the lanes of *moving, which loses those that moved little. */
LANES_INLINE void approach(const struct powers *f, const struct powers *g, struct hunt *h, wide_mask *moving)
{
    struct spot p, q;
    powers_at(f, &h->f, h->t, &p);
    powers_at(g, &h->g, h->s, &q);
    wide x = p.x - q.x, y = p.y - q.y, one = wide_inverse_about(cross(p.dx, p.dy, q.dx, q.dy));
    wide dt = cross(x, y, q.dx, q.dy) * one, ds = cross(x, y, p.dx, p.dy) * one;
    h->t = wide_select(*moving, h->t - dt, h->t);
    h->s = wide_select(*moving, h->s - ds, h->s);
    *moving &= wide_less(wide_of(0x1p-13), wide_max(wide_abs(dt), wide_abs(ds)));
}

LANES_INLINE void approach_both(struct hunt *h, struct hunt *k)
{
    enum { STEPS = 7 };
    struct powers p[4];
    powers_component(h->arc[0].x, p[0].x);
    powers_component(h->arc[0].y, p[0].y);
    powers_component(h->arc[1].x, p[1].x);
    powers_component(h->arc[1].y, p[1].y);
    powers_component(k->arc[0].x, p[2].x);
    powers_component(k->arc[0].y, p[2].y);
    powers_component(k->arc[1].x, p[3].x);
    powers_component(k->arc[1].y, p[3].y);
    wide_mask moving_h = h->active, moving_k = k->active;
    int steps = 0;
    do {
        approach(&p[0], &p[1], h, &moving_h);
        approach(&p[2], &p[3], k, &moving_k);
    } while (++steps < STEPS && wide_bits(moving_h | moving_k));
}

/* ---- with bounds ---- */

LANES_INLINE wide sum_4(const wide c[4], wide w0, wide w1, wide w2, wide w3)
{
    return wide_fma(c[1], w1, c[0] * w0) + wide_fma(c[3], w3, c[2] * w2);
}

LANES_INLINE wide sum_3(const wide c[3], wide w0, wide w1, wide w2)
{
    return wide_fma(c[2], w2, wide_fma(c[1], w1, c[0] * w0));
}

/* Of the node extended by its tangents; *past: how far t is outside. */
LANES_INLINE void spot_at(const struct side *a, wide t, struct spot *out, wide *past)
{
    wide inside = wide_min(wide_max(t, a->lo), a->hi), beyond = t - inside;
    wide v = 1.0 - inside, vv = v * v, vt = v * inside, tt = inside * inside;
    wide w0 = vv * v, w1 = vv * inside, w2 = v * tt, w3 = tt * inside;
    out->dx = sum_3(a->slope_x, vv, vt, tt);
    out->dy = sum_3(a->slope_y, vv, vt, tt);
    out->x = wide_fma(beyond, out->dx, sum_4(a->x, w0, w1, w2, w3));
    out->y = wide_fma(beyond, out->dy, sum_4(a->y, w0, w1, w2, w3));
    *past = wide_abs(beyond);
}

/* The pad covers the rounding of t -+ radius where these are near the node. */
LANES_INLINE wide_mask beyond(const struct side *a, wide t, wide radius)
{
    wide reach = radius + DBL_EPSILON;
    return wide_less(a->hi, t - reach) | wide_less(t + reach, a->lo);
}

/* Takes a step in the lanes of *active that have not ended.  *active loses those without a zero in their
 * nodes, *ended gets those that may end with this step. */
LANES_INLINE void newton_step(struct hunt *h, wide_mask *ended, struct last_step *d)
{
    const struct side *f = &h->f, *g = &h->g;
    const wide t = h->t, s = h->s;
    struct spot p, q;
    wide past_f, past_g;
    spot_at(f, t, &p, &past_f);
    spot_at(g, s, &q, &past_g);
    wide x = p.x - q.x, y = p.y - q.y, far = wide_max(wide_abs(x), wide_abs(y));
    wide det = cross(p.dx, p.dy, q.dx, q.dy), one = 1.0 / det;
    wide error = h->unit * wide_fma(past_f + past_g, wide_of(slope_error), wide_of(2 * value_error));
    wide most = wide_fma(far, wide_of(1 + 4 * DBL_EPSILON), error);
    wide_mask open = h->active & ~*ended;
    h->active &= ~(open & (beyond(f, t, f->reach * most) | beyond(g, s, g->reach * most)));
    wide dt = cross(x, y, q.dx, q.dy) * one, ds = cross(x, y, p.dx, p.dy) * one;
    wide rest = wide_fma(f->bend * dt, dt, (g->bend * ds) * ds);
    h->t = wide_select(open, t - dt, t);
    h->s = wide_select(open, s - ds, s);
    d->dt = wide_select(open, wide_abs(dt), d->dt);
    d->ds = wide_select(open, wide_abs(ds), d->ds);
    d->det = wide_select(open, wide_abs(det), d->det);
    d->one = wide_select(open, wide_abs(one), d->one);
    d->df = wide_select(open, norm_1(p.dx, p.dy), d->df);
    d->dg = wide_select(open, norm_1(q.dx, q.dy), d->dg);
    d->error = wide_select(open, error, d->error);
    *ended |= open & wide_less(rest, 2.0 * error);
}

/* As radii() of solve_one.c, in the same order of operations.  A radius is computed to 17 u of itself; the
 * factor of reach, 1 + 8 DBL_EPSILON, makes up for 16 u, and value_error and slope_error, of which one part
 * in 80 is to spare, for the rest. */
LANES_INLINE void radii(const struct side *f, const struct side *g, wide unit, const struct last_step *d,
                        wide t, wide s, wide *out_t, wide *out_s)
{
    const double eps = DBL_EPSILON;
    wide dt = d->dt, ds = d->ds, noise = unit * slope_error;
    wide tilt = d->df * d->dg * d->one, way = wide_fma(d->df, dt, d->dg * ds);
    wide left = 2.0 * d->error + way * (8 * eps * (1.0 + tilt)) + noise * (dt + ds);
    wide rt = f->reach * left, rs = g->reach * left;
    wide change_f = wide_fma(f->bend, dt + rt, noise), change_g = wide_fma(g->bend, ds + rs, noise);
    wide least =
        d->det - change_f * d->dg - change_g * d->df - 2.0 * change_f * change_g - 4 * eps * d->df * d->dg;
    wide by = left * (1 + 8 * eps) / least;
    wide_mask sharp = wide_less(d->det, 2.0 * least);
    rt = wide_select(sharp, wide_min(rt, by * wide_fma(wide_of(2), change_g, d->dg)), rt);
    rs = wide_select(sharp, wide_min(rs, by * wide_fma(wide_of(2), change_f, d->df)), rs);
    *out_t = wide_fma(wide_abs(t), wide_of(eps), rt);
    *out_s = wide_fma(wide_abs(s), wide_of(eps), rs);
}

/* Is `inside` far from an end of a node, counted in radii, or at an end of the domain and so near to it that
 * no other radius of the same zero could leave it out?  `inside`: how far the zero is inside that end of the
 * node. *at: gets the lanes of the second kind.  All between is looked at elsewhere, and so is what lies near
 * a cut. */
LANES_INLINE wide_mask is_clear(wide inside, wide radius, wide_mask domain, wide_mask *at)
{
    wide_mask near = domain & wide_less(4.0 * wide_abs(inside), radius);
    *at |= near;
    return near | wide_less(16.0 * radius, inside);
}

LANES_INLINE wide_mask is_placed(const struct side *a, wide t, wide radius, wide_mask *at_end)
{
    wide_mask first = wide_less(a->lo, wide_of(DBL_MIN)), last = wide_less(wide_of(1 - DBL_EPSILON), a->hi);
    return is_clear(t - a->lo, radius, first, at_end) & is_clear(a->hi - t, radius, last, at_end);
}

/* Writes LANES records, of which those in `which` count: there is room for all. */
LANES_INLINE void write_records(struct batch_chunk *z, wide_mask which, const int *pair, wide t, wide s,
                                wide rt, wide rs)
{
    double t_ends[2 * LANES], s_ends[2 * LANES]; /* lanes 0 2 4 .., then 1 3 5 .. */
    struct batch_record *to = z->record + z->records;
    unsigned bits = wide_bits(which);
    wide_store(t_ends, wide_evens(t - rt, t + rt));
    wide_store(t_ends + LANES, wide_odds(t - rt, t + rt));
    wide_store(s_ends, wide_evens(s - rs, s + rs));
    wide_store(s_ends + LANES, wide_odds(s - rs, s + rs));
#pragma GCC unroll 8
    for (int i = 0; i < LANES; i++) {
        int from = i % 2 * LANES + i / 2 * 2;
        struct batch_record r = {
            {{t_ends[from], t_ends[from + 1]}, {s_ends[from], s_ends[from + 1]}, UNIQUE, 1, 1},
            z->first + pair[i]};
        *to = r;
        to += bits >> i & 1;
    }
    z->records = (int)(to - z->record);
}

/* Of the records just written, one for each lane of `which`, those of `ends` are at an end of a domain. */
LANES_INLINE void mark_ends(struct batch_chunk *z, wide_mask which, wide_mask ends)
{
    unsigned written = wide_bits(which);
    struct batch_record *first = z->record + z->records - __builtin_popcount(written);
    for (unsigned bits = wide_bits(ends); bits; bits &= bits - 1) {
        unsigned before = written & ((bits & -bits) - 1);
        struct crossing *c = &first[__builtin_popcount(before)].at;
        c->standing = END;
        c->multiplicity = 0;
        c->t.lo = c->t.lo > 0 ? c->t.lo : 0;
        c->s.lo = c->s.lo > 0 ? c->s.lo : 0;
        c->t.hi = c->t.hi < 1 ? c->t.hi : 1;
        c->s.hi = c->s.hi < 1 ? c->s.hi : 1;
    }
}

/* With bounds, to the end: h->active loses the lanes without a zero in their nodes; returns those whose zero
 * is proved, within the radii. */
LANES_INLINE wide_mask hunt_end(struct hunt *h, wide *rt, wide *rs)
{
    enum { ITERATIONS_MAX = 8 };
    const wide none = wide_of(0);
    struct last_step d = {none, none, none, none, none, none, none};
    struct side *f = &h->f, *g = &h->g;
    side_component(h->arc[0].x, f->x, f->slope_x);
    side_component(h->arc[0].y, f->y, f->slope_y);
    side_component(h->arc[1].x, g->x, g->slope_x);
    side_component(h->arc[1].y, g->y, g->slope_y);
    wide_mask ended = wide_first(0);
    int steps = 0;
    do {
        newton_step(h, &ended, &d);
    } while (++steps < ITERATIONS_MAX && wide_bits(h->active & ~ended));
    ended &= wide_less(64 * DBL_EPSILON * (d.df * d.dg), d.det); /* k u < 1/128 in solve_one.c */
    radii(f, g, h->unit, &d, h->t, h->s, rt, rs);
    h->active &= ~(ended & (beyond(f, h->t, *rt) | beyond(g, h->s, *rs)));
    return h->active & ended;
}

LANES_INLINE void prove(struct batch_chunk *z, struct hunt *h)
{
    wide rt, rs;
    wide_mask proved = hunt_end(h, &rt, &rs), at_end = wide_first(0);
    const wide widest = wide_of(z->tolerance / 2);
    wide_mask good = proved & is_placed(&h->f, h->t, rt, &at_end) & is_placed(&h->g, h->s, rs, &at_end) &
                     wide_less(rt, widest) & wide_less(rs, widest);
    if (wide_bits(h->active & ~good)) {
        leave_alone(z, h->active & ~good, wide_load_whole(h->pair));
    }
    if (z->records + LANES > z->room) {
        z->full = true;
    } else {
        write_records(z, good, h->pair, h->t, h->s, rt, rs);
        if (wide_bits(good & at_end)) {
            mark_ends(z, good, good & at_end);
        }
    }
}

/* Up to 2 LANES of the list. */
LANES_INLINE void solve_lanes(struct batch_chunk *z, const struct batch_solves *q, int first)
{
    struct hunt h, k;
    hunt_init(z, q, first, &h);
    hunt_init(z, q, first + LANES, &k);
    approach_both(&h, &k);
    prove(z, &h);
    prove(z, &k);
}

#endif
