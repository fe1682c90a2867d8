/* Newton's method in every lane, with the proof of solve_one.c, and the records.
 *
 * All lanes step until each has once taken a step small enough to end with; the ones that had may go on, for
 * the bounds hold after any step that is.  One that never gets there, or whose zero is not well inside its
 * node, is left alone. */
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

/* The last step, as in solve_one.c: df and dg are 1-norms of the derivatives. */
struct last_step {
    wide dt, ds, det, df, dg, error;
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

LANES_INLINE void side_init(struct side *a, const struct arc *c, wide code, wide reach, wide bend)
{
    side_component(c->x, a->x, a->slope_x);
    side_component(c->y, a->y, a->slope_y);
    a->lo = code_start(code);
    a->hi = a->lo + code_width(code);
    a->reach = reach;
    a->bend = bend;
}

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

LANES_INLINE wide_mask beyond(const struct side *a, wide t, wide radius)
{
    return wide_less(a->hi, t - radius) | wide_less(t + radius, a->lo);
}

/* Takes a step from *t, *s.  *active loses the lanes without a zero in their nodes; returns those that may
 * end with this step. */
LANES_INLINE wide_mask newton_step(const struct side *f, const struct side *g, wide unit, wide_mask *active,
                                   wide *t, wide *s, struct last_step *d)
{
    struct spot p, q;
    wide past_f, past_g;
    spot_at(f, *t, &p, &past_f);
    spot_at(g, *s, &q, &past_g);
    wide x = p.x - q.x, y = p.y - q.y, far = wide_max(wide_abs(x), wide_abs(y));
    wide det = cross(p.dx, p.dy, q.dx, q.dy), one = 1.0 / det;
    d->error = unit * wide_fma(past_f + past_g, wide_of(slope_error), wide_of(2 * value_error));
    wide most = wide_fma(far, wide_of(1 + 4 * DBL_EPSILON), d->error);
    *active &= ~(beyond(f, *t, f->reach * most) | beyond(g, *s, g->reach * most));
    d->dt = cross(x, y, q.dx, q.dy) * one;
    d->ds = cross(x, y, p.dx, p.dy) * one;
    d->det = wide_abs(det);
    d->df = norm_1(p.dx, p.dy);
    d->dg = norm_1(q.dx, q.dy);
    *t = *t - d->dt;
    *s = *s - d->ds;
    wide rest = wide_fma(f->bend * d->dt, d->dt, (g->bend * d->ds) * d->ds);
    return wide_less(rest, 2.0 * d->error);
}

/* As radii() of solve_one.c, in the same order of operations. */
LANES_INLINE void radii(const struct side *f, const struct side *g, wide unit, const struct last_step *d,
                        wide t, wide s, wide *out_t, wide *out_s)
{
    const double eps = DBL_EPSILON;
    wide dt = wide_abs(d->dt), ds = wide_abs(d->ds), noise = unit * slope_error;
    wide tilt = d->df * d->dg / d->det, way = wide_fma(d->df, dt, d->dg * ds);
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

/* Inside its node by more than that: ends and cuts are looked at elsewhere, and so is whatever another radius
 * of the same zero might reach. */
LANES_INLINE wide_mask well_inside(const struct side *a, wide t, wide radius)
{
    wide margin = 16.0 * radius;
    return wide_less(a->lo, t - margin) & wide_less(t + margin, a->hi);
}

/* Writes LANES records, of which those in `which` count: there is room for all. */
LANES_INLINE void write_records(struct batch_chunk *z, wide_mask which, wide at, wide t, wide s, wide rt,
                                wide rs)
{
    double pair[LANES], t_lo[LANES], t_hi[LANES], s_lo[LANES], s_hi[LANES];
    struct batch_record *to = z->record + z->records;
    unsigned bits = wide_bits(which);
    wide_store(pair, at + (double)z->first);
    wide_store(t_lo, t - rt);
    wide_store(t_hi, t + rt);
    wide_store(s_lo, s - rs);
    wide_store(s_hi, s + rs);
    for (int i = 0; i < LANES; i++) {
        to->at.t.lo = t_lo[i];
        to->at.t.hi = t_hi[i];
        to->at.s.lo = s_lo[i];
        to->at.s.hi = s_hi[i];
        to->at.standing = UNIQUE;
        to->at.at_most = to->at.multiplicity = 1;
        to->pair = (int)pair[i];
        to += bits >> i & 1;
    }
    z->records = (int)(to - z->record);
}

LANES_INLINE void solve_lanes(struct batch_chunk *z, const struct batch_solves *q, int first, int count)
{
    enum { ITERATIONS_MAX = 10 };
    struct arc c[2];
    struct side f, g;
    struct last_step d;
    wide at = list_load(q->pair, first, count), unit = wide_gather(z->unit, at), rt, rs;
    wide t = list_load(q->t, first, count), s = list_load(q->s, first, count);
    load_pairs(z, at, &c[0], &c[1]);
    side_init(&f, &c[0], list_load(q->f, first, count), list_load(q->reach_t, first, count),
              list_load(q->bend_f, first, count));
    side_init(&g, &c[1], list_load(q->g, first, count), list_load(q->reach_s, first, count),
              list_load(q->bend_g, first, count));
    wide_mask active = wide_first(count - first), ended;
    int steps = 0;
    do {
        ended = newton_step(&f, &g, unit, &active, &t, &s, &d);
    } while (++steps < ITERATIONS_MAX && wide_bits(active & ~ended));
    radii(&f, &g, unit, &d, t, s, &rt, &rs);
    active &= ~(ended & (beyond(&f, t, rt) | beyond(&g, s, rs)));
    const wide widest = wide_of(z->tolerance / 2);
    wide_mask good = active & ended & well_inside(&f, t, rt) & well_inside(&g, s, rs) &
                     wide_less(rt, widest) & wide_less(rs, widest);
    if (wide_bits(active & ~good)) {
        leave_alone(z, active & ~good, at);
    }
    if (z->records + LANES > z->room) {
        z->full = true;
    } else {
        write_records(z, good, at, t, s, rt, rs);
    }
}

#endif
