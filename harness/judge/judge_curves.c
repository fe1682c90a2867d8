#include <stdlib.h>

#include "judge_curves.h"
#include "../cases/number.h"

/* ---- points ------------------------------------------------------------------------------------------- */

struct jet {
    real at[2], slope[2];
};

/* Point and derivative by de Casteljau: the point errs by at most 8 (n + 1) REAL_EPSILON times the largest
 * coordinate and the ratio of the weights. */
static struct jet jet_at(const struct curve *c, real t)
{
    const real *source[3] = {c->x, c->y, c->w};
    real width = c->domain.hi - c->domain.lo, u = (t - c->domain.lo) / width;
    real b[DEGREE_MAX + 1], value[3], slope[3];
    struct jet j;
    int n = c->degree;

    for (int k = 0; k < (c->w ? 3 : 2); k++) {
        for (int i = 0; i <= n; i++)
            b[i] = source[k][i];
        for (int r = 1; r < n; r++)
            for (int i = 0; i <= n - r; i++)
                b[i] = (1 - u) * b[i] + u * b[i + 1];
        value[k] = (1 - u) * b[0] + u * b[1];
        slope[k] = (real)n * (b[1] - b[0]) / width;
    }
    for (int k = 0; k < 2; k++) {
        j.at[k] = c->w ? value[k] / value[2] : value[k];
        j.slope[k] = c->w ? (slope[k] - j.at[k] * slope[2]) / value[2] : slope[k];
    }
    return j;
}

static real length(real x, real y)
{
    return real_sqrt(x * x + y * y);
}

static real coordinate(const struct curve *c, const real *a, int i)
{
    return c->w ? a[i] / c->w[i] : a[i];
}

static void extend(const struct curve *c, const real *a, real *lo, real *hi)
{
    for (int i = 0; i <= c->degree; i++) {
        *lo = real_min(*lo, coordinate(c, a, i));
        *hi = real_max(*hi, coordinate(c, a, i));
    }
}

real curves_size(const struct problem *p)
{
    real x = coordinate(&p->f, p->f.x, 0), y = coordinate(&p->f, p->f.y, 0);
    real x_lo = x, x_hi = x, y_lo = y, y_hi = y;
    extend(&p->f, p->f.x, &x_lo, &x_hi);
    extend(&p->g, p->g.x, &x_lo, &x_hi);
    extend(&p->f, p->f.y, &y_lo, &y_hi);
    extend(&p->g, p->g.y, &y_lo, &y_hi);
    return real_max(x_hi - x_lo, y_hi - y_lo);
}

/* ---- distance over a box ------------------------------------------------------------------------------ */

static real weight_ratio(const struct curve *c)
{
    real light = 1, heavy = 1;
    if (!c->w)
        return 1;
    light = heavy = c->w[0];
    for (int i = 1; i <= c->degree; i++) {
        light = real_min(light, c->w[i]);
        heavy = real_max(heavy, c->w[i]);
    }
    return heavy / light;
}

/* |f'| <= n r^2 max |P_i+1 - P_i| for weights of ratio at most r (Floater 1992; r is 1 for polynomials). */
static real speed_bound(const struct curve *c)
{
    real most = 0, ratio = weight_ratio(c);
    for (int i = 0; i < c->degree; i++)
        most = real_max(most, length(coordinate(c, c->x, i + 1) - coordinate(c, c->x, i),
                                     coordinate(c, c->y, i + 1) - coordinate(c, c->y, i)));
    return (real)c->degree * ratio * ratio * most * (1 + 16 * REAL_EPSILON) / (c->domain.hi - c->domain.lo);
}

/* Rounding of |f(t) - g(s)|, for any t and s. */
static real rounding(const struct problem *p)
{
    real lo = 0, hi = 0;
    extend(&p->f, p->f.x, &lo, &hi);
    extend(&p->g, p->g.x, &lo, &hi);
    extend(&p->f, p->f.y, &lo, &hi);
    extend(&p->g, p->g.y, &lo, &hi);
    return real_max(-lo, hi) * (weight_ratio(&p->f) + weight_ratio(&p->g)) * REAL_EPSILON *
           (real)(32 * (p->f.degree + p->g.degree + 4));
}

static struct interval clipped(struct interval a, struct interval to)
{
    struct interval r;
    r.lo = real_min(real_max(a.lo, to.lo), to.hi);
    r.hi = real_max(real_min(a.hi, to.hi), to.lo);
    return r;
}

bool curves_apart(const struct problem *p, const struct box *b, real distance)
{
    enum { STACK = 128, VISITS = 1024 };
    struct box waiting[STACK];
    real speed_f = speed_bound(&p->f), speed_g = speed_bound(&p->g), noise = rounding(p);
    int count = 1, visits = 0;

    waiting[0].t = clipped(b->t, p->f.domain);
    waiting[0].s = clipped(b->s, p->g.domain);
    while (count) {
        struct box c = waiting[--count], second = c;
        real t = (c.t.lo + c.t.hi) / 2, s = (c.s.lo + c.s.hi) / 2;
        struct jet f = jet_at(&p->f, t), g = jet_at(&p->g, s);
        real here = length(f.at[0] - g.at[0], f.at[1] - g.at[1]);
        real reach_f = speed_f * (c.t.hi - c.t.lo) / 2, reach_g = speed_g * (c.s.hi - c.s.lo) / 2;
        if (here - (reach_f + reach_g) * (1 + 8 * REAL_EPSILON) - noise > distance)
            continue;
        if (!(here > distance + noise) || ++visits == VISITS || count + 2 > STACK)
            return false;
        if (reach_f >= reach_g)
            c.t.hi = second.t.lo = t;
        else
            c.s.hi = second.s.lo = s;
        waiting[count++] = c;
        waiting[count++] = second;
    }
    return true;
}

/* ---- overlaps ----------------------------------------------------------------------------------------- */

real curves_match(const struct problem *p, real t, struct interval range, real *s)
{
    enum { STEPS = 128 };
    struct jet f = jet_at(&p->f, t), g = jet_at(&p->g, *s);
    real best = length(f.at[0] - g.at[0], f.at[1] - g.at[1]), share = 1;

    for (int k = 0; k < STEPS; k++) { /* steps that lead away are halved: the start may be far */
        real square = g.slope[0] * g.slope[0] + g.slope[1] * g.slope[1];
        if (!(square > 0))
            break;
        real step = ((f.at[0] - g.at[0]) * g.slope[0] + (f.at[1] - g.at[1]) * g.slope[1]) / square;
        real to = real_min(real_max(*s + share * step, range.lo), range.hi);
        struct jet there = jet_at(&p->g, to);
        real now = length(f.at[0] - there.at[0], f.at[1] - there.at[1]);
        if (!(now < best)) {
            share = share / 2;
            if (!(share >= (real)1 / 1024))
                break;
            continue;
        }
        best = now;
        *s = to;
        g = there;
        share = real_min(1, 2 * share);
    }
    return best;
}

real trace_t(const struct trace *trace, int k)
{
    return trace->t.lo + (trace->t.hi - trace->t.lo) * (real)k / (real)(TRACE_MAX - 1);
}

void trace_make(const struct problem *p, const struct case_overlap *o, struct trace *trace)
{
    enum { BETWEEN = 8 }; /* steps of continuation from one entry to the next */
    real from = real_from_rational(o->s0), to = real_from_rational(o->s1), s = from;
    real size = curves_size(p);

    trace->t.lo = real_from_rational(o->t0);
    trace->t.hi = real_from_rational(o->t1);
    trace->range.lo = real_min(from, to);
    trace->range.hi = real_max(from, to);
    for (int k = 0; k < TRACE_MAX; k++) {
        real distance = 0;
        for (int i = k ? 1 : BETWEEN; i <= BETWEEN; i++) {
            real t = trace_t(trace, k) -
                     (trace->t.hi - trace->t.lo) * (real)(BETWEEN - i) / (real)(BETWEEN * (TRACE_MAX - 1));
            real step = (to - from) / (real)(BETWEEN * (TRACE_MAX - 1));
            s = k ? real_min(real_max(s + step, trace->range.lo), trace->range.hi) : from;
            distance = curves_match(p, t, trace->range, &s);
        }
        trace->s[k] = s;
        trace->sure[k] = distance <= size * 1e-12;
    }
}

real trace_s(const struct problem *p, const struct trace *trace, real t)
{
    int k = 0;
    while (k < TRACE_MAX - 2 && trace_t(trace, k + 1) < t)
        k++;
    real lo = trace_t(trace, k), hi = trace_t(trace, k + 1);
    real s = hi > lo ? trace->s[k] + (trace->s[k + 1] - trace->s[k]) * (t - lo) / (hi - lo) : trace->s[k];
    curves_match(p, t, trace->range, &s);
    return s;
}

bool trace_meets(const struct problem *p, const struct trace *trace, const struct box *b, real tol)
{
    real lo = real_max(b->t.lo - tol, trace->t.lo), hi = real_min(b->t.hi + tol, trace->t.hi);
    if (lo > hi)
        return false;
    real a = trace_s(p, trace, lo), c = trace_s(p, trace, hi);
    return real_min(a, c) <= b->s.hi + tol && real_max(a, c) >= b->s.lo - tol;
}
