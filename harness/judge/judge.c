#include <math.h>
#include <stdlib.h>

#include "judge_court.h"
#include "../cases/number.h"
#include "../run/memory.h"

const char *verdict_name(enum verdict verdict)
{
    static const char *const names[] = {"RIGHT", "WRONG", "STOPPED", "NOT_TAKEN", "UNJUDGED", "BROKEN"};
    return names[verdict];
}

/* ---- evidence ----------------------------------------------------------------------------------------- */

static void read_truth(struct court *q)
{
    const struct case_expected *e = &q->c->expected;
    q->solutions = e->count;
    q->solution = (struct solution *)memory_new((size_t)e->count, sizeof *q->solution);
    for (int i = 0; i < e->count; i++) {
        q->solution[i].t = real_from_rational(e->at[i].t);
        q->solution[i].s = real_from_rational(e->at[i].s);
        q->solution[i].multiplicity = e->at[i].multiplicity;
    }
    q->traces = e->overlaps;
    q->trace = (struct trace *)memory_new((size_t)e->overlaps, sizeof *q->trace);
    for (int i = 0; i < e->overlaps; i++)
        trace_make(q->p, &e->overlap[i], &q->trace[i]);
}

static void weigh_group(struct court *q, struct group *g)
{
    for (int i = 0; i < q->solutions; i++)
        if (box_contains(&g->at, q->solution[i].t, q->solution[i].s, q->tol)) {
            int multiplicity = q->solution[i].multiplicity;
            g->holds++;
            g->weight =
                multiplicity && g->weight < WEIGHT_UNKNOWN ? g->weight + multiplicity : WEIGHT_UNKNOWN;
        }
    for (int i = 0; i < q->traces; i++)
        g->overlaps = g->overlaps || trace_meets(q->p, &q->trace[i], &g->at, q->tol);
}

/* Multiplicities held: at least those well inside, at most those near it. */
static void weigh_cluster(const struct court *q, const struct record *r, int *least, int *most)
{
    real width = real_min(r->at.t.hi - r->at.t.lo, r->at.s.hi - r->at.s.lo),
         inside = real_min(q->tol, width) / 8;
    *least = *most = 0;
    for (int i = 0; i < q->solutions; i++) {
        int multiplicity = q->solution[i].multiplicity;
        if (box_contains(&r->at, q->solution[i].t, q->solution[i].s, -inside))
            *least += multiplicity ? multiplicity : 1;
        if (box_contains(&r->at, q->solution[i].t, q->solution[i].s, q->tol))
            *most = multiplicity && *most < WEIGHT_UNKNOWN ? *most + multiplicity : WEIGHT_UNKNOWN;
    }
}

static void weigh(struct court *q)
{
    for (int i = 0; i < q->g.groups; i++)
        weigh_group(q, &q->g.group[i]);
    for (int i = 0; i < q->g.records; i++) {
        const struct record *r = &q->g.record[i];
        struct group *g = &q->g.group[r->group];
        int least, most;
        if (r->standing != CLUSTER || g->overlaps)
            continue;
        weigh_cluster(q, r, &least, &most);
        g->refuted = g->refuted || r->at_most < least;
        g->loose = g->loose || (most > 0 && r->at_most > most + 1);
    }
}

/* ---- solutions ---------------------------------------------------------------------------------------- */

static real error_in(const struct box *b, const struct solution *x)
{
    return real_max(real_abs((b->t.lo + b->t.hi) / 2 - x->t), real_abs((b->s.lo + b->s.hi) / 2 - x->s));
}

static void credit(struct court *q, struct solution *x, const struct box *b)
{
    x->found = true;
    q->verdict.max_error = fmax(q->verdict.max_error, real_to_double(error_in(b, x)));
}

static void look_in_groups(struct court *q, struct solution *x)
{
    for (int i = 0; i < q->g.groups; i++) {
        const struct group *g = &q->g.group[i];
        if (g->overlaps || !box_contains(&g->at, x->t, x->s, q->tol))
            continue;
        if (g->refuted)
            x->refuted = true;
        else if (box_fits(&g->at, 4 * q->tol))
            credit(q, x, &g->at);
        else
            x->merged = true;
    }
}

static void look_in_records(struct court *q, struct solution *x)
{
    for (int i = 0; i < q->g.records; i++) {
        const struct record *r = &q->g.record[i];
        if (!box_contains(&r->at, x->t, x->s, q->tol))
            continue;
        x->covered = true;
        if (!q->g.group[r->group].overlaps)
            continue;
        if (box_fits(&r->at, 4 * q->tol))
            credit(q, x, &r->at);
        else
            x->merged = true;
    }
}

static void look_in_overlaps(struct court *q, struct solution *x)
{
    for (int i = 0; i < q->a->crossings->overlaps; i++) {
        struct box b = overlap_box(&q->a->crossings->overlap[i]);
        if (!box_contains(&b, x->t, x->s, q->tol))
            continue;
        x->covered = true;
        if (box_fits(&b, 4 * q->tol))
            credit(q, x, &b);
        else
            x->merged = true;
    }
}

void court_miss(struct court *q, real t)
{
    if (!q->verdict.missed++)
        q->verdict.missed_t = real_to_double(t);
}

static void judge_solutions(struct court *q)
{
    for (int i = 0; i < q->solutions; i++) {
        struct solution *x = &q->solution[i];
        look_in_groups(q, x);
        look_in_records(q, x);
        look_in_overlaps(q, x);
        q->verdict.found += x->found;
        if (!x->found && (q->solved ? !x->merged || x->refuted : !x->covered || x->refuted))
            court_miss(q, x->t);
    }
}

/* ---- what is too much --------------------------------------------------------------------------------- */

void court_reject(struct court *q, const struct box *b)
{
    if (!q->verdict.extra++)
        q->verdict.extra_t = real_to_double((b->t.lo + b->t.hi) / 2);
}

void court_empty(struct court *q, const struct box *b, bool refuted)
{
    real distance = q->tol * curves_size(q->p);
    if (refuted || (q->solved && curves_apart(q->p, b, distance)))
        court_reject(q, b);
    else
        q->verdict.undecided++;
}

static void judge_groups(struct court *q)
{
    for (int i = 0; i < q->g.groups; i++) {
        const struct group *g = &q->g.group[i];
        if (g->overlaps) {
            q->verdict.undecided++;
        } else if (!g->holds) {
            court_empty(q, &g->at, g->uniques > 0);
        } else {
            q->verdict.undecided += g->loose && !g->refuted;
            q->verdict.merged += q->solved && !box_fits(&g->at, 4 * q->tol);
            q->verdict.duplicate += g->uniques > g->weight ? g->uniques - g->weight : 0;
        }
    }
}

/* ---- the verdict -------------------------------------------------------------------------------------- */

static enum verdict conclude(const struct court *q)
{
    const struct judgement *v = &q->verdict;
    if (v->missed || v->extra || v->duplicate || v->merged)
        return WRONG;
    return q->solved ? RIGHT : STOPPED;
}

enum verdict verdict_without(enum outcome outcome)
{
    return outcome == UNSUPPORTED || outcome == INVALID                       ? NOT_TAKEN
           : outcome == GAVE_UP || outcome == CRASHED || outcome == TIMED_OUT ? BROKEN
                                                                              : UNJUDGED;
}

struct judgement judge(const struct test_case *c, const struct problem *p, const struct answer *a, double tol)
{
    struct court q = {c, p, a, tol, a->outcome == SOLVED};
    struct judgement *v = &q.verdict;

    v->missed_t = v->extra_t = v->max_error = NAN;
    v->verdict = verdict_without(a->outcome);
    if (!c->expected.known)
        return q.verdict;
    v->expected = c->expected.count + c->expected.overlaps;
    if (v->verdict != UNJUDGED)
        return q.verdict;
    read_truth(&q);
    grouping_make(a, q.tol, &q.g);
    weigh(&q);
    judge_solutions(&q);
    judge_traces(&q);
    judge_groups(&q);
    judge_uniques(&q);
    judge_overlap_records(&q);
    v->verdict = conclude(&q);
    grouping_clear(&q.g);
    free(q.solution);
    free(q.trace);
    return q.verdict;
}
