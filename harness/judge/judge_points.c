#include "judge_points.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "judge_groups.h"
#include "../cases/number.h"
#include "../run/memory.h"

struct point {
    double t, s;
    bool taken;
};

struct link {
    int point, solution;
    double distance;
};

struct match {
    const struct test_case *c;
    const struct problem *p;
    const struct answer *a;
    double reach;
    int points, solutions;
    struct point *point, *solution;
    struct point_judgement *out;
};

static double apart(const struct point *a, const struct point *b)
{
    return fmax(fabs(a->t - b->t), fabs(a->s - b->s));
}

static double middle(const struct interval *i)
{
    return real_to_double((i->lo + i->hi) / 2);
}

static void add_point(struct match *m, const struct interval *t, const struct interval *s)
{
    struct point *to = &m->point[m->points++];
    to->t = middle(t);
    to->s = middle(s);
}

/* What holds exactly one solution is a point of its own, however near another is; of records that prove less
 * and touch, one. */
static void read_points(struct match *m)
{
    const struct crossings *found = m->a->crossings;
    struct grouping g;
    m->point = (struct point *)memory_new((size_t)found->count + 1, sizeof *m->point);
    for (int i = 0; i < found->count; i++) {
        if (m->a->points_only || found->at[i].standing == UNIQUE) {
            add_point(m, &found->at[i].t, &found->at[i].s);
        }
    }
    if (m->a->points_only) {
        return;
    }
    grouping_make(m->a, m->a->tolerance, &g);
    for (int i = 0; i < g.groups; i++) {
        if (g.group[i].uniques == 0) {
            add_point(m, &g.group[i].at.t, &g.group[i].at.s);
        }
    }
    grouping_clear(&g);
}

static void read_solutions(struct match *m)
{
    const struct case_expected *e = &m->c->expected;
    m->solutions = e->count;
    m->solution = (struct point *)memory_new((size_t)e->count + 1, sizeof *m->solution);
    for (int i = 0; i < e->count; i++) {
        m->solution[i].t = mpq_get_d(e->at[i].t);
        m->solution[i].s = mpq_get_d(e->at[i].s);
    }
}

static int compare(const void *a, const void *b)
{
    double x = ((const struct link *)a)->distance, y = ((const struct link *)b)->distance;
    return (x > y) - (x < y);
}

static void pair_up(struct match *m)
{
    struct judgement *j = &m->out->found;
    struct link *links =
        (struct link *)memory_new((size_t)m->points * (size_t)m->solutions + 1, sizeof *links);
    int count = 0;
    for (int i = 0; i < m->points; i++)
        for (int k = 0; k < m->solutions; k++) {
            double distance = apart(&m->point[i], &m->solution[k]);
            if (distance <= m->reach) {
                links[count].point = i;
                links[count].solution = k;
                links[count++].distance = distance;
            }
        }
    qsort(links, (size_t)count, sizeof *links, compare);
    for (int i = 0; i < count; i++) {
        struct point *point = &m->point[links[i].point], *solution = &m->solution[links[i].solution];
        if (point->taken || solution->taken)
            continue;
        point->taken = solution->taken = true;
        j->found++;
        j->max_error = fmax(j->max_error, links[i].distance);
    }
    free(links);
}

/* ---- overlaps ---- */

static bool ends_match(const struct overlap *o, const struct case_overlap *e, double reach)
{
    double t0 = mpq_get_d(e->t0), t1 = mpq_get_d(e->t1), s0 = mpq_get_d(e->s0), s1 = mpq_get_d(e->s1);
    return fabs(real_to_double(o->t_outer.lo) - fmin(t0, t1)) <= reach &&
           fabs(real_to_double(o->t_outer.hi) - fmax(t0, t1)) <= reach &&
           fabs(real_to_double(o->s_outer.lo) - fmin(s0, s1)) <= reach &&
           fabs(real_to_double(o->s_outer.hi) - fmax(s0, s1)) <= reach;
}

static bool point_at(const struct match *m, const mpq_t t, const mpq_t s)
{
    struct point end = {mpq_get_d(t), mpq_get_d(s), false};
    for (int i = 0; i < m->points; i++)
        if (apart(&m->point[i], &end) <= m->reach)
            return true;
    return false;
}

/* Takes the free points that lie on the overlap; how many. */
static int take_along(struct match *m, const struct case_overlap *e)
{
    struct trace trace;
    int along = 0;
    trace_make(m->p, e, &trace);
    for (int i = 0; i < m->points; i++) {
        struct box at;
        at.t.lo = at.t.hi = (real)m->point[i].t;
        at.s.lo = at.s.hi = (real)m->point[i].s;
        if (!m->point[i].taken && trace_meets(m->p, &trace, &at, (real)m->reach)) {
            m->point[i].taken = true;
            along++;
        }
    }
    return along;
}

/* What an answer says of an overlap, the best first. */
enum said { ENDS, END_POINTS, SAID, ALONG, NOTHING };

static enum said look_at_overlap(struct match *m, const struct case_overlap *e, int *along)
{
    const struct crossings *x = m->a->crossings;
    bool both = point_at(m, e->t0, e->s0) && point_at(m, e->t1, e->s1);
    *along = take_along(m, e);
    for (int i = 0; i < x->overlaps; i++)
        if (ends_match(&x->overlap[i], e, m->reach))
            return ENDS;
    if (x->overlaps)
        return SAID;
    return *along == 2 && both ? END_POINTS : *along ? ALONG : NOTHING;
}

static void judge_overlaps(struct match *m)
{
    static const char *const names[] = {"ends", "end points", "said", "points", "nothing"};
    const struct case_expected *e = &m->c->expected;
    struct judgement *j = &m->out->found;
    enum said worst = ENDS;
    int along, total = 0;
    for (int i = 0; i < e->overlaps; i++) {
        enum said said = look_at_overlap(m, &e->overlap[i], &along);
        total += along;
        j->found += said <= SAID;
        worst = said > worst ? said : worst;
    }
    if (e->overlaps && worst == ALONG)
        snprintf(m->out->overlap, sizeof m->out->overlap, "points %d", total);
    else if (e->overlaps)
        snprintf(m->out->overlap, sizeof m->out->overlap, "%s", names[worst]);
    else
        j->extra += m->a->crossings->overlaps;
}

/* ---- what is left ---- */

static void count_rest(struct match *m)
{
    struct judgement *j = &m->out->found;
    for (int i = 0; i < m->points; i++) {
        bool near = false;
        if (m->point[i].taken)
            continue;
        for (int k = 0; k < m->solutions; k++)
            near = near || apart(&m->point[i], &m->solution[k]) <= m->reach;
        j->duplicate += near;
        if (!near && !j->extra++)
            j->extra_t = m->point[i].t;
    }
    for (int k = 0; k < m->solutions; k++)
        if (!m->solution[k].taken && !j->missed++)
            j->missed_t = m->solution[k].t;
    j->missed = j->expected - j->found;
}

struct point_judgement judge_points(const struct test_case *c, const struct problem *p,
                                    const struct answer *a, double reach)
{
    struct point_judgement out;
    struct match m;
    struct judgement *j = &out.found;

    memset(&out, 0, sizeof out);
    memset((void *)&m, 0, sizeof m);
    j->max_error = j->missed_t = j->extra_t = NAN;
    j->verdict = verdict_without(a->outcome);
    if (!c->expected.known)
        return out;
    j->expected = c->expected.count + c->expected.overlaps;
    if (j->verdict != UNJUDGED)
        return out;
    m.c = c;
    m.p = p;
    m.a = a;
    m.reach = reach;
    m.out = &out;
    if (a->outcome != SOLVED) {
        out.found = judge(c, p, a, case_tolerance(c, real_to_double(a->tolerance)));
        snprintf(out.overlap, sizeof out.overlap, "%s", c->expected.overlaps ? "stopped" : "");
        return out;
    }
    read_points(&m);
    read_solutions(&m);
    pair_up(&m);
    judge_overlaps(&m);
    count_rest(&m);
    out.points = m.points;
    j->verdict = j->missed || j->extra || j->duplicate ? WRONG : RIGHT;
    free(m.point);
    free(m.solution);
    return out;
}
