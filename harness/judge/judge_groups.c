#include <stdio.h>
#include <stdlib.h>

#include "judge_groups.h"
#include "../run/memory.h"

bool box_contains(const struct box *b, real t, real s, real margin)
{
    return t >= b->t.lo - margin && t <= b->t.hi + margin && s >= b->s.lo - margin && s <= b->s.hi + margin;
}

bool box_fits(const struct box *b, real most)
{
    return b->t.hi - b->t.lo <= most && b->s.hi - b->s.lo <= most;
}

static struct interval middle(struct interval a)
{
    struct interval m;
    m.lo = m.hi = (a.lo + a.hi) / 2;
    return m;
}

static int compare(const void *a, const void *b)
{
    const struct record *p = (const struct record *)a, *q = (const struct record *)b;
    if (p->at.t.lo < q->at.t.lo)
        return -1;
    return p->at.t.lo > q->at.t.lo;
}

/* ---- disjoint sets: record[i].group is the parent of i ------------------------------------------------ */

static int find(struct record *r, int i)
{
    while (r[i].group != i)
        i = r[i].group = r[r[i].group].group;
    return i;
}

/* `active` holds, after each step, the records whose t may still touch what follows; what falls behind
 * leaves. */
static void connect(struct record *r, int count, real tol)
{
    int *active = (int *)memory_new((size_t)count, sizeof *active), waiting = 0;
    for (int i = 0; i < count; i++) {
        int kept = 0;
        for (int k = 0; k < waiting; k++) {
            struct record *a = &r[active[k]];
            if (a->at.t.hi + 2 * tol < r[i].at.t.lo)
                continue;
            active[kept++] = active[k];
            if (a->at.s.hi + 2 * tol >= r[i].at.s.lo && r[i].at.s.hi + 2 * tol >= a->at.s.lo)
                r[find(r, active[k])].group = find(r, i);
        }
        waiting = kept;
        active[waiting++] = i;
    }
    free(active);
}

static void include(struct group *g, const struct record *r)
{
    g->at.t.lo = real_min(g->at.t.lo, r->at.t.lo);
    g->at.t.hi = real_max(g->at.t.hi, r->at.t.hi);
    g->at.s.lo = real_min(g->at.s.lo, r->at.s.lo);
    g->at.s.hi = real_max(g->at.s.hi, r->at.s.hi);
    g->uniques += r->standing == UNIQUE;
}

/* From parents to numbers of groups. */
static void number(struct grouping *g)
{
    int *root = (int *)memory_new((size_t)g->records, sizeof *root),
        *name = (int *)memory_new((size_t)g->records, sizeof *name);
    for (int i = 0; i < g->records; i++) {
        root[i] = find(g->record, i);
        if (root[i] == i) {
            name[i] = g->groups;
            g->group[g->groups++].at = g->record[i].at;
        }
    }
    for (int i = 0; i < g->records; i++) {
        g->record[i].group = name[root[i]];
        include(&g->group[name[root[i]]], &g->record[i]);
    }
    free(root);
    free(name);
}

void grouping_make(const struct answer *a, real tol, struct grouping *g)
{
    const struct crossings *from = a->crossings;
    g->records = from->count;
    g->groups = 0;
    g->record = (struct record *)memory_new((size_t)g->records, sizeof *g->record);
    g->group = (struct group *)memory_new((size_t)g->records, sizeof *g->group);
    for (int i = 0; i < g->records; i++) {
        struct record *r = &g->record[i];
        r->at.t = a->points_only ? middle(from->at[i].t) : from->at[i].t;
        r->at.s = a->points_only ? middle(from->at[i].s) : from->at[i].s;
        r->standing = a->points_only ? CANDIDATE : from->at[i].standing;
        r->at_most = from->at[i].at_most;
    }
    qsort(g->record, (size_t)g->records, sizeof *g->record, compare);
    for (int i = 0; i < g->records; i++)
        g->record[i].group = i;
    connect(g->record, g->records, tol);
    number(g);
}

void grouping_clear(struct grouping *g)
{
    free(g->record);
    free(g->group);
}
