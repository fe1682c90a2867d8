#include "pair.h"

#include "bernstein.h"

enum { POINTS = 33, STEPS = 4 }; /* of Newton's method from the middle: errors h, h^3, h^7, h^15 */

/* ---- preconditioning ---- */

static void middle(const struct arc *a, real point[2], real slope[2])
{
    const real half = (real)0.5;
    real scratch[POINTS], weight = 1, weight_slope = 0;
    if (a->w) {
        weight = bernstein_value_slope(a->degree, a->w, half, scratch, &weight_slope);
    }
    for (int j = 0; j < 2; j++) {
        point[j] = bernstein_value_slope(a->degree, j ? a->y : a->x, half, scratch, &slope[j]) / weight;
        slope[j] = (slope[j] - point[j] * weight_slope) / weight;
    }
}

/* Any frame will do; false: there is none. */
static bool make_frame(const struct arc *f, const struct arc *g, real scale, struct frame *out)
{
    real pf[2], pg[2], df[2], dg[2];
    middle(f, pf, df);
    middle(g, pg, dg);
    real inverse = 1 / (df[1] * dg[0] - df[0] * dg[1]);
    if (!real_is_finite(inverse)) {
        return false;
    }
    out->scale = scale;
    out->x0 = real_max(-scale, real_min(scale, pf[0]));
    out->y0 = real_max(-scale, real_min(scale, pf[1]));
    out->row[0][0] = -dg[1] * inverse;
    out->row[0][1] = dg[0] * inverse;
    out->row[1][0] = -df[1] * inverse;
    out->row[1][1] = df[0] * inverse;
    frame_set_norms(out);
    return real_is_finite(out->norm[0]) && real_is_finite(out->norm[1]);
}

/* ---- the system p(t) = q(s) ---- */

/* max |slope - ideal| over [0, 1]. */
static real stray(const struct nearby *a, int j, int ideal)
{
    real most = 0;
    for (int i = 0; i < a->degree; i++) {
        real slope = a->degree * (a->c[j][i + 1] - a->c[j][i]);
        real size = real_abs(a->c[j][i + 1]) + real_abs(a->c[j][i]);
        most = real_max(most, real_abs(slope - ideal) + REAL_EPSILON * (1 + 2 * a->degree * size));
    }
    return most + most / 64;
}

/* Value of p - q at z, |value| with its rounding, and the Jacobian. */
static void evaluate(const struct nearby *p, const struct nearby *q, const real z[2], real value[2],
                     real size[2], real jacobian[2][2])
{
    real scratch[NEARBY_DEGREE_MAX + 1], slope;
    for (int j = 0; j < 2; j++) {
        real a = bernstein_value_slope(p->degree, p->c[j], z[0], scratch, &jacobian[j][0]);
        real b = bernstein_value_slope(q->degree, q->c[j], z[1], scratch, &slope);
        real most = 0;
        for (int i = 0; i <= p->degree; i++) {
            most = real_max(most, real_abs(p->c[j][i]));
        }
        for (int i = 0; i <= q->degree; i++) {
            most = real_max(most, real_abs(q->c[j][i]));
        }
        jacobian[j][1] = -slope;
        value[j] = a - b;
        size[j] = real_abs(value[j]) + (3 * (p->degree + q->degree) + 2) * REAL_EPSILON * most;
    }
}

static void newton(const struct nearby *p, const struct nearby *q, real z[2], real size[2])
{
    real value[2], j[2][2];
    z[0] = z[1] = (real)0.5;
    for (int step = 0; step < STEPS; step++) {
        evaluate(p, q, z, value, size, j);
        real inverse = 1 / (j[0][0] * j[1][1] - j[0][1] * j[1][0]);
        if (!real_is_finite(inverse)) {
            return;
        }
        real t = (j[1][1] * value[0] - j[0][1] * value[1]) * inverse;
        real s = (j[0][0] * value[1] - j[1][0] * value[0]) * inverse;
        z[0] = real_max(0, real_min(1, z[0] - t));
        z[1] = real_max(0, real_min(1, z[1] - s));
    }
    evaluate(p, q, z, value, size, j);
}

/* ---- the proof ---- */

static bool is_contraction(const real e[2][2])
{
    const real few = 8 * REAL_EPSILON;
    return e[0][0] < 1 && e[1][1] < 1 && (1 - e[0][0]) * (1 - e[1][1]) > e[0][1] * e[1][0] * (1 + few) + few;
}

/* r = (I - e)^-1 eps, somewhat enlarged; true if e r + eps < r is proved. */
static bool solve_radius(const real e[2][2], const real eps[2], real r[2])
{
    const real few = 1 + 8 * REAL_EPSILON, more = (real)33 / 32;
    real d = (1 - e[0][0]) * (1 - e[1][1]) - e[0][1] * e[1][0];
    r[0] = more * ((1 - e[1][1]) * eps[0] + e[0][1] * eps[1]) / d;
    r[1] = more * (e[1][0] * eps[0] + (1 - e[0][0]) * eps[1]) / d;
    return (e[0][0] * r[0] + e[0][1] * r[1] + eps[0]) * few < r[0] &&
           (e[1][0] * r[0] + e[1][1] * r[1] + eps[1]) * few < r[1];
}

static enum pair_outcome clip(const struct arc *f, const struct arc *g, const struct frame *frame,
                              const struct reduction *rf, const struct reduction *rg, int k,
                              struct pair_box *out)
{
    struct nearby p, q;
    nearby_init(f, frame, rf, k, &p);
    nearby_init(g, frame, rg, k, &q);
    real e[2][2] = {{stray(&p, 0, 1), stray(&q, 0, 0)}, {stray(&p, 1, 0), stray(&q, 1, -1)}}, z[2], r[2],
         eps[2];
    if (!is_contraction(e)) {
        return NO_STEP;
    }
    newton(&p, &q, z, eps);
    out->at_floor = true;
    for (int j = 0; j < 2; j++) {
        real noise = frame->norm[j] * (f->error + g->error + 12 * REAL_EPSILON * frame->scale);
        eps[j] += p.off[j] + q.off[j];
        eps[j] += 4 * REAL_EPSILON * (1 + eps[j]);
        out->at_floor = out->at_floor && 4 * noise > eps[j];
    }
    if (!solve_radius(e, eps, r)) {
        return NO_STEP;
    }
    const real pad = 4 * REAL_EPSILON;
    struct interval t = {z[0] - r[0] - pad, z[0] + r[0] + pad}, s = {z[1] - r[1] - pad, z[1] + r[1] + pad};
    for (int j = 0; j < 2; j++) {
        e[j][0] += p.slope_off[j];
        e[j][1] += q.slope_off[j];
    }
    out->holds_one = t.lo >= 0 && t.hi <= 1 && s.lo >= 0 && s.hi <= 1 && is_contraction(e);
    out->t.lo = real_max(t.lo, 0);
    out->t.hi = real_min(t.hi, 1);
    out->s.lo = real_max(s.lo, 0);
    out->s.hi = real_min(s.hi, 1);
    return t.lo > 1 || t.hi < 0 || s.lo > 1 || s.hi < 0 ? NOWHERE_MET : BOXED;
}

enum pair_outcome pair_clip(const struct arc *f, const struct arc *g, real scale, const struct reduction *rf,
                            const struct reduction *rg, int k, struct pair_box *out)
{
    struct frame frame;
    enum pair_outcome best = NO_STEP;
    real area = 1;
    if (!make_frame(f, g, scale, &frame)) {
        return NO_STEP;
    }
    for (int d = k; d >= 1 && 4 * area > 1; d--) {
        struct pair_box box;
        enum pair_outcome outcome = clip(f, g, &frame, &rf[d - 1], &rg[d - 1], d, &box);
        if (outcome == NOWHERE_MET) {
            return NOWHERE_MET;
        }
        real left = (box.t.hi - box.t.lo) * (box.s.hi - box.s.lo);
        if (outcome == BOXED && (best == NO_STEP || left < area)) {
            best = BOXED;
            area = left;
            *out = box;
        }
    }
    return best;
}
