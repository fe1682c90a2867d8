#include "judge_court.h"

struct box overlap_box(const struct overlap *o)
{
    struct box b;
    b.t = o->t_outer;
    b.s = o->s_outer;
    return b;
}

static bool is_covered(const struct court *q, real t, real s)
{
    for (int i = 0; i < q->g.records; i++)
        if (box_contains(&q->g.record[i].at, t, s, q->tol))
            return true;
    for (int i = 0; i < q->a->crossings->overlaps; i++) {
        struct box b = overlap_box(&q->a->crossings->overlap[i]);
        if (box_contains(&b, t, s, q->tol))
            return true;
    }
    return false;
}

void judge_traces(struct court *q)
{
    for (int i = 0; i < q->traces; i++) {
        const struct trace *trace = &q->trace[i];
        int k = 0;
        while (k < TRACE_MAX && (!trace->sure[k] || is_covered(q, trace_t(trace, k), trace->s[k])))
            k++;
        if (k == TRACE_MAX)
            q->verdict.found++;
        else
            court_miss(q, trace_t(trace, k));
    }
}

static bool is_expected_overlap(const struct court *q, real t, real s)
{
    for (int i = 0; i < q->traces; i++) {
        struct box b;
        b.t.lo = b.t.hi = t;
        b.s.lo = b.s.hi = s;
        if (trace_meets(q->p, &q->trace[i], &b, q->tol))
            return true;
    }
    return false;
}

/* What the record says of t_inner, at TRACE_MAX places. */
static bool is_true(const struct court *q, const struct overlap *o)
{
    real slack = curves_size(q->p) * (real)(1 << 16) * REAL_EPSILON;
    for (int k = 0; k < TRACE_MAX; k++) {
        real share = (real)k / (real)(TRACE_MAX - 1), along = o->reversed ? 1 - share : share;
        real t = o->t_inner.lo + (o->t_inner.hi - o->t_inner.lo) * share;
        real s = o->s_inner.lo + (o->s_inner.hi - o->s_inner.lo) * along;
        real distance = curves_match(q->p, t, o->s_outer, &s);
        if (o->exact ? !is_expected_overlap(q, t, s)
                     : distance > o->distance * (1 + 16 * REAL_EPSILON) + slack)
            return false;
    }
    return true;
}

/* UNIQUE in the midst of an overlap. */
void judge_uniques(struct court *q)
{
    for (int i = 0; i < q->g.records; i++) {
        const struct record *r = &q->g.record[i];
        real t = (r->at.t.lo + r->at.t.hi) / 2;
        for (int k = 0; k < q->traces && r->standing == UNIQUE; k++) {
            const struct trace *trace = &q->trace[k];
            if (t <= trace->t.lo + 2 * q->tol || t >= trace->t.hi - 2 * q->tol)
                continue;
            real s = trace_s(q->p, trace, t);
            if (s >= r->at.s.lo - q->tol && s <= r->at.s.hi + q->tol)
                court_reject(q, &r->at);
        }
    }
}

void judge_overlap_records(struct court *q)
{
    for (int i = 0; i < q->a->crossings->overlaps; i++) {
        const struct overlap *o = &q->a->crossings->overlap[i];
        struct box b = overlap_box(o);
        bool meets = false, holds = false;
        for (int k = 0; k < q->traces; k++)
            meets = meets || trace_meets(q->p, &q->trace[k], &b, q->tol);
        for (int k = 0; k < q->solutions; k++)
            holds = holds || box_contains(&b, q->solution[k].t, q->solution[k].s, q->tol);
        if (!is_true(q, o))
            court_reject(q, &b);
        else if (holds && !meets)
            q->verdict.merged += q->solved && !box_fits(&b, 4 * q->tol);
        else if (!meets)
            court_empty(q, &b, false);
    }
}
