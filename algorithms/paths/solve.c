/* Pairs of segments, and single segments, into records. */
#include <string.h>

#include "paths.h"

extern const struct intersector certified, certified_joints, certified_loops;
extern const struct intersector *const path_pairs, *const path_joints, *const path_loops;
const struct intersector *const path_pairs = &certified;
const struct intersector *const path_joints = &certified_joints;
const struct intersector *const path_loops = &certified_loops;

void path_solver_init(struct path_solver *z, const struct path *a, const struct path *b,
                      struct workspace *workspace, struct crossings *crossings)
{
    z->a = a;
    z->b = b ? b : a;
    z->self = !b;
    z->tolerance = 0;
    z->max_steps = STEPS_MAX;
    z->workspace = workspace;
    z->crossings = crossings;
    z->pairs = path_pairs;
    z->joints = path_joints;
    z->loops = path_loops;
    z->solved = z->passed = z->looped = z->unsolved = 0;
    z->worst = SOLVED;
}

static void span_of(int segment, const struct interval *t, struct path_span *out)
{
    out->first = out->last = segment;
    out->lo = t->lo;
    out->hi = t->hi;
}

/* Which of the two joints that two neighbours of one path can have lies in a record. */
static bool holds_joint(const struct path_solver *z, int i, int j, const struct interval *t,
                        const struct interval *s)
{
    return z->self && ((z->a->next[i] == j && t->hi == 1 && s->lo == 0) ||
                       (z->a->next[j] == i && t->lo == 0 && s->hi == 1));
}

static struct path_record *record_new(struct path_records *out)
{
    struct path_record *r = &out->at[out->count++];
    r->standing = CANDIDATE;
    r->at_most = r->chain = 0;
    r->joint = false;
    r->overlap = r->link = -1;
    return r;
}

/* A joint is a zero of the pair of neighbours, exactly: a record of just one zero that holds it holds nothing
 * else. */
static void add_crossing(const struct path_solver *z, int i, int j, const struct crossing *c,
                         struct path_records *out)
{
    bool joint = holds_joint(z, i, j, &c->t, &c->s), single = c->standing == UNIQUE || c->standing == END;
    if (joint && (single || (c->standing == CLUSTER && c->at_most == 1))) {
        return;
    }
    struct path_record *r = record_new(out);
    span_of(i, &c->t, &r->a);
    span_of(j, &c->s, &r->b);
    r->standing = c->standing;
    r->at_most = single ? 1 : c->at_most;
    r->joint = joint;
}

static void add_overlap(const struct path_solver *z, int i, int j, const struct overlap *o,
                        struct path_records *out)
{
    struct path_record *r = record_new(out);
    span_of(i, &o->t_outer, &r->a);
    span_of(j, &o->s_outer, &r->b);
    r->joint = holds_joint(z, i, j, &o->t_outer, &o->s_outer);
    r->overlap = out->overlaps++;
    struct path_overlap *to = &out->overlap[r->overlap];
    to->a_inner = o->t_inner;
    to->b_inner = o->s_inner;
    to->reversed = o->reversed;
    to->distance = o->distance;
}

static enum outcome find(struct path_solver *z, int i, int j, const struct intersector *by, bool keep_order)
{
    const struct interval whole = {0, 1};
    struct problem p;
    memset((void *)&p, 0, sizeof p);
    p.f = z->a->segment[i];
    p.g = z->b->segment[j];
    p.f.domain = p.g.domain = whole;
    p.tolerance = z->tolerance;
    p.max_steps = z->max_steps;
    p.keep_order = keep_order;
    return problem_solve(&p, by, z->workspace, z->crossings);
}

static void keep(struct path_solver *z, int i, int j, enum outcome outcome, struct path_records *out)
{
    const struct crossings *found = z->crossings;
    if (outcome != SOLVED) {
        z->worst = z->unsolved++ ? z->worst : outcome;
    }
    for (int k = 0; k < found->count; k++) {
        add_crossing(z, i, j, &found->at[k], out);
    }
    for (int k = 0; k < found->overlaps; k++) {
        add_overlap(z, i, j, &found->overlap[k], out);
    }
}

static bool all_decided(enum outcome outcome, const struct crossings *found)
{
    for (int k = 0; k < found->count; k++) {
        if (found->at[k].standing == CANDIDATE) {
            return false;
        }
    }
    return outcome == SOLVED;
}

/* Segment `later` begins where `earlier` ends, and not the other way round: what they have in common beside
 * that point.  false: it cannot be told so. */
static bool solve_joint(struct path_solver *z, int earlier, int later, struct path_records *out)
{
    enum outcome outcome = find(z, earlier, later, z->joints, true);
    int first = out->count;
    if (!all_decided(outcome, z->crossings)) {
        return false;
    }
    keep(z, earlier, later, outcome, out);
    for (int r = first; earlier > later && r < out->count; r++) {
        struct path_span s = out->at[r].a;
        out->at[r].a = out->at[r].b;
        out->at[r].b = s;
    }
    return true;
}

/* Neighbours that meet at their joint only. */
static bool is_plain_joint(const struct path_solver *z, int i, int j)
{
    const struct curve *c = z->a->segment;
    return z->self && ((z->a->next[i] == j && path_runs_straight(&c[i], &c[j])) ||
                       (z->a->next[j] == i && path_runs_straight(&c[j], &c[i])));
}

static bool has_room(const struct path_records *out)
{
    return out->room - out->count >= PATH_RECORDS_LEAST &&
           out->overlap_room - out->overlaps >= PATH_OVERLAPS_LEAST;
}

int path_solve(struct path_solver *z, const struct path_pair *pair, int count, struct path_records *out)
{
    int done = 0;
    for (; done < count && has_room(out); done++) {
        int i = pair[done].i, j = pair[done].j;
        if (z->a->next[i] == PATH_POINT || z->b->next[j] == PATH_POINT) {
            continue;
        }
        if (is_plain_joint(z, i, j)) {
            z->passed++;
            continue;
        }
        z->solved++;
        bool after = z->self && z->a->next[i] == j, before = z->self && z->a->next[j] == i;
        if (after == before || !solve_joint(z, after ? i : j, after ? j : i, out)) {
            keep(z, i, j, find(z, i, j, z->pairs, false), out);
        }
    }
    return done;
}

int path_solve_loops(struct path_solver *z, int first, int last, struct path_records *out)
{
    int i = first;
    for (; i < last && has_room(out); i++) {
        const struct curve *c = &z->a->segment[i];
        if (c->degree == 1 || z->a->next[i] == PATH_POINT || path_runs_straight(c, NULL)) {
            continue;
        }
        z->looped++;
        keep(z, i, i, find(z, i, i, z->loops, true), out);
    }
    return i - first;
}
