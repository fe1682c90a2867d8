/* Crossings of arcs, by an intersector of the registry.
 *
 * The polygon that holds the arcs is a pointed cone, so the sum of its half-planes is positive on it: taken
 * for the third coordinate it makes the polygon bounded, and the weights of every arc inside positive. */
#include "carriers.h"

#include "../core/bernstein.h"

enum { COEFFICIENTS = 3 * (DEGREE_MAX + 1), DEPTH = 40, NEWTON_STEPS = 24, PAIR_STEPS = 4000 };

/* Rows of a rotation whose last one is positive on the cone. */
struct chart {
    real row[3][3];
};

/* Part of an arc in the chart: (x, y, weight) of degree e over [lo, hi] of its span. */
struct part {
    int e;
    real lo, hi;
    real c[COEFFICIENTS];
};

static void chart_make(const struct cone *c, struct chart *out)
{
    real *x = out->row[0], *y = out->row[1], *z = out->row[2];
    int least = 0;
    z[0] = z[1] = z[2] = 0;
    for (int i = 0; i < c->count; i++) {
        for (int j = 0; j < 3; j++) {
            z[j] += c->edge[i].plane.l[j];
        }
    }
    triple_normalise(z);
    for (int j = 1; j < 3; j++) {
        least = real_abs(z[j]) < real_abs(z[least]) ? j : least;
    }
    x[0] = x[1] = x[2] = 0;
    x[least] = 1;
    triple_cross(z, x, y);
    triple_normalise(y);
    triple_cross(y, z, x);
}

/* Weights are made positive in the middle. */
static void part_make(const struct region_work *k, const struct chart *chart, int span, real lo, real hi,
                      struct part *out)
{
    const struct span_forms *f = &k->span[span].form;
    real w[COEFFICIENTS], middle[3];
    int length = f->e + 1;
    bernstein_restrict(f->e, 3, f->w, lo, hi, w);
    out->e = f->e;
    out->lo = lo;
    out->hi = hi;
    for (int i = 0; i < length; i++) {
        for (int j = 0; j < 3; j++) {
            const real *r = chart->row[j];
            out->c[j * length + i] = r[0] * w[i] + r[1] * w[length + i] + r[2] * w[2 * length + i];
        }
    }
    middle[0] = bernstein_value(f->e, out->c + 2 * length, (real)1 / 2);
    for (int i = 0; middle[0] < 0 && i < 3 * length; i++) {
        out->c[i] = -out->c[i];
    }
}

static bool weights_are_positive(const struct part *p)
{
    const real *w = p->c + 2 * (p->e + 1);
    for (int i = 0; i <= p->e; i++) {
        if (!(w[i] > 0)) {
            return false;
        }
    }
    return true;
}

static void box(const struct part *p, int coordinate, real *lo, real *hi)
{
    const real *c = p->c + coordinate * (p->e + 1), *w = p->c + 2 * (p->e + 1);
    *lo = *hi = c[0] / w[0];
    for (int i = 1; i <= p->e; i++) {
        real x = c[i] / w[i];
        *lo = real_min(*lo, x);
        *hi = real_max(*hi, x);
    }
}

static bool boxes_meet(const struct part *p, const struct part *q)
{
    for (int j = 0; j < 2; j++) {
        real a, b, c, d;
        box(p, j, &a, &b);
        box(q, j, &c, &d);
        real pad = 32 * p->e * REAL_EPSILON * (real_abs(a) + real_abs(b) + real_abs(c) + real_abs(d));
        if (b + pad < c || d + pad < a) {
            return false;
        }
    }
    return true;
}

/* Point and derivative at t of [0, 1]. */
static void evaluate(const struct part *p, real t, real *at, real *slope)
{
    real scratch[DEGREE_MAX + 1], v[3], d[3];
    for (int j = 0; j < 3; j++) {
        v[j] = bernstein_value_slope(p->e, p->c + j * (p->e + 1), t, scratch, &d[j]);
    }
    for (int j = 0; j < 2; j++) {
        at[j] = v[j] / v[2];
        slope[j] = (d[j] - at[j] * d[2]) / v[2];
    }
}

static real clamp(real t)
{
    return t < 0 ? (real)0 : t > 1 ? (real)1 : t;
}

/* Newton's method from (t, s) while the distance falls. */
static void refine(const struct part *p, const struct part *q, real *t, real *s)
{
    real last = REAL_HUGE, tt = *t, ss = *s;
    for (int i = 0; i < NEWTON_STEPS; i++) {
        real a[2], b[2], da[2], db[2];
        evaluate(p, tt, a, da);
        evaluate(q, ss, b, db);
        real x = b[0] - a[0], y = b[1] - a[1], distance = real_abs(x) + real_abs(y);
        if (!(distance < last)) {
            return;
        }
        *t = tt;
        *s = ss;
        last = distance;
        real d = db[0] * da[1] - da[0] * db[1];
        if (d == 0) {
            return;
        }
        tt = clamp(tt + (db[0] * y - db[1] * x) / d);
        ss = clamp(ss + (da[0] * y - da[1] * x) / d);
    }
}

static bool add(struct carrier_crossings *out, int arc, real t)
{
    if (out->count == MARKS_MAX) {
        return false;
    }
    out->at[out->count].arc = arc;
    out->at[out->count++].t = t;
    return true;
}

/* A pair that takes too long, for a contact, leaves wide records. */
static enum outcome solve(struct region_work *k, const struct part *p, const struct part *q, int i, int j,
                          struct carrier_crossings *out)
{
    struct problem problem = {{p->e, p->c, p->c + p->e + 1, p->c + 2 * (p->e + 1), {0, 1}},
                              {q->e, q->c, q->c + q->e + 1, q->c + 2 * (q->e + 1), {0, 1}},
                              real_ldexp(1, -REAL_BITS / 2),
                              PAIR_STEPS,
                              {0, 0, 0, 0, 0},
                              NULL};
    enum outcome outcome = problem_solve(&problem, k->intersector, k->cells, k->crossings);
    k->steps += k->cells->steps;
    for (int c = 0; c < k->crossings->count; c++) {
        const struct crossing *x = &k->crossings->at[c];
        real t = x->t.lo + (x->t.hi - x->t.lo) / 2, s = x->s.lo + (x->s.hi - x->s.lo) / 2;
        refine(p, q, &t, &s);
        if (!add(out, i, p->lo + t * (p->hi - p->lo)) || !add(out, j, q->lo + s * (q->hi - q->lo))) {
            return OUT_OF_ROOM;
        }
    }
    return k->steps >= k->max_steps ? OUT_OF_STEPS : outcome == OUT_OF_STEPS ? OUT_OF_ROOM : outcome;
}

/* Two parts still to be halved: their intervals. */
struct pair {
    real t0, t1, s0, s1;
};

/* Halves parts until their weights have one sign. */
static enum outcome cross(struct region_work *k, const struct chart *chart, const struct carrier_arcs *arcs,
                          int i, int j, struct carrier_crossings *out)
{
    const struct carrier_arc *a = &arcs->at[i], *b = &arcs->at[j];
    struct pair stack[2 * DEPTH] = {{a->from.t, a->to.t, b->from.t, b->to.t}};
    struct part p, q;
    int waiting = 1;
    while (waiting > 0) {
        struct pair pair = stack[--waiting], other = pair;
        part_make(k, chart, k->piece[a->piece].span, pair.t0, pair.t1, &p);
        part_make(k, chart, k->piece[b->piece].span, pair.s0, pair.s1, &q);
        bool halve_p = !weights_are_positive(&p), halve_q = !halve_p && !weights_are_positive(&q);
        if (!halve_p && !halve_q) {
            enum outcome outcome = boxes_meet(&p, &q) ? solve(k, &p, &q, i, j, out) : SOLVED;
            if (outcome != SOLVED) {
                return outcome;
            }
            continue;
        }
        if (waiting + 2 > 2 * DEPTH || k->steps++ >= k->max_steps) {
            return OUT_OF_STEPS;
        }
        if (halve_p) {
            pair.t1 = other.t0 = pair.t0 + (pair.t1 - pair.t0) / 2;
        } else {
            pair.s1 = other.s0 = pair.s0 + (pair.s1 - pair.s0) / 2;
        }
        stack[waiting++] = pair;
        stack[waiting++] = other;
    }
    return SOLVED;
}

enum outcome arcs_cross(struct region_work *k, const struct carrier_arcs *arcs, struct carrier_crossings *out)
{
    struct chart chart;
    chart_make(&k->cone, &chart);
    out->count = 0;
    for (int i = 0; i < arcs->count; i++) {
        for (int j = i + 1; j < arcs->count; j++) {
            if (pieces_are_near(&k->piece[arcs->at[i].piece], &k->piece[arcs->at[j].piece])) {
                continue;
            }
            /* where room or a pair's steps fail the records are wide, and the certificate decides */
            if (cross(k, &chart, arcs, i, j, out) == OUT_OF_STEPS) {
                return OUT_OF_STEPS;
            }
        }
    }
    return SOLVED;
}
