/* Pairs of segments, and single segments, into records. */
#include <string.h>

#include "paths.h"

extern const struct intersector certified, certified_joints, certified_loops;

enum { ROOM = 1 /* cells, of which none are used */ };

/* The memory of a solver: this, then the workspace's, then the batch's. */
struct path_memory {
    struct workspace workspace;
    struct crossings crossings;
    int f_index[PATH_BATCH], g_index[PATH_BATCH];
    int number[PATH_BATCH]; /* of the pair among those that were asked for */
    unsigned char outcome[PATH_BATCH];
    struct batch_record record[PATH_BATCH_RECORDS];
    struct batch_overlap overlap[PATH_BATCH_OVERLAPS];
    void *batch;
};

static size_t rounded(size_t bytes)
{
    return (bytes + 63) / 64 * 64;
}

static size_t workspace_bytes(int degree)
{
    return rounded(workspace_size(degree, degree, ROOM, certified.scratch(degree, degree)));
}

size_t path_solver_size(int degree)
{
    return rounded(sizeof(struct path_memory)) + workspace_bytes(degree) + batch_workspace_size();
}

void path_solver_init(struct path_solver *z, const struct path *a, const struct path *b, int degree,
                      real tolerance, int max_steps, void *memory)
{
    char *at = (char *)memory;
    z->a = a;
    z->b = b ? b : a;
    z->self = !b;
    z->tolerance = tolerance;
    z->max_steps = max_steps;
    z->memory = (struct path_memory *)memory;
    z->pairs = &certified;
    z->joints = &certified_joints;
    z->loops = &certified_loops;
    at += rounded(sizeof(struct path_memory));
    workspace_init(&z->memory->workspace, at, degree, degree, ROOM, certified.scratch(degree, degree));
    z->memory->batch = at + workspace_bytes(degree);
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
    r->joint = r->proved = false;
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
    return problem_solve(&p, by, &z->memory->workspace, &z->memory->crossings);
}

static void count_outcome(struct path_solver *z, enum outcome outcome)
{
    if (outcome != SOLVED) {
        z->worst = z->unsolved++ ? z->worst : outcome;
    }
}

static void keep(struct path_solver *z, int i, int j, enum outcome outcome, struct path_records *out)
{
    const struct crossings *found = &z->memory->crossings;
    count_outcome(z, outcome);
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
    if (!all_decided(outcome, &z->memory->crossings)) {
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

/* ---- many pairs ---- */

enum kind { NOTHING, IN_BATCH, ALONE };

static enum kind kind_of(const struct path_solver *z, int i, int j)
{
    const struct path *a = z->a, *b = z->b;
    bool plain = a->degree && b->degree && a->degree[i] && b->degree[j];
    if (plain && !z->self) {
        return IN_BATCH;
    }
    if (a->next[i] == PATH_POINT || b->next[j] == PATH_POINT) {
        return NOTHING;
    }
    if (z->self && (a->next[i] == j || a->next[j] == i)) {
        return ALONE;
    }
    return plain ? IN_BATCH : ALONE;
}

static void solve_alone(struct path_solver *z, int i, int j, struct path_records *out)
{
    bool after = z->self && z->a->next[i] == j, before = z->self && z->a->next[j] == i;
    z->solved++;
    if (after == before || !solve_joint(z, after ? i : j, after ? j : i, out)) {
        keep(z, i, j, find(z, i, j, z->pairs, false), out);
    }
}

/* Settles the first of `count` pairs that were put down; returns how many. */
static int solve_batch(struct path_solver *z, int count, struct path_records *out)
{
    struct path_memory *m = z->memory;
    struct batch b = {{z->a->points, z->a->degree},
                      {z->b->points, z->b->degree},
                      m->f_index,
                      m->g_index,
                      count,
                      z->tolerance,
                      z->max_steps,
                      BATCH_BEST};
    struct batch_answer answer = {
        m->record, m->overlap, m->outcome, PATH_BATCH_RECORDS, PATH_BATCH_OVERLAPS, 0, 0, 0, 0};
    if (count == 0) {
        return 0;
    }
    batch_solve(&b, 0, m->batch, &answer);
    for (int k = 0; k < answer.done; k++) {
        count_outcome(z, (enum outcome)m->outcome[k]);
    }
    for (int k = 0; k < answer.records; k++) {
        const struct batch_record *r = &m->record[k];
        add_crossing(z, m->f_index[r->pair], m->g_index[r->pair], &r->at, out);
    }
    for (int k = 0; k < answer.overlaps; k++) {
        const struct batch_overlap *o = &m->overlap[k];
        add_overlap(z, m->f_index[o->pair], m->g_index[o->pair], &o->at, out);
    }
    z->solved += answer.done;
    return answer.done;
}

/* Puts down what can be taken together; *looked at so many pairs.  Returns how many were put down. */
static int gather(const struct path_solver *z, const struct path_pair *pair, int count, int *looked)
{
    struct path_memory *m = z->memory;
    int gathered = 0, alone = 0, k = 0;
    for (; k < count && gathered < PATH_BATCH && alone < PATH_ALONE; k++) {
        enum kind kind = kind_of(z, pair[k].i, pair[k].j);
        if (kind == IN_BATCH) {
            m->f_index[gathered] = pair[k].i;
            m->g_index[gathered] = pair[k].j;
            m->number[gathered++] = k;
        }
        alone += kind == ALONE && !is_plain_joint(z, pair[k].i, pair[k].j);
    }
    *looked = k;
    return gathered;
}

/* Where the batch had no room for all, nothing is done beyond its last pair. */
static int solve_some(struct path_solver *z, const struct path_pair *pair, int count,
                      struct path_records *out)
{
    int looked, gathered = gather(z, pair, count, &looked), done = solve_batch(z, gathered, out);
    looked = done < gathered ? z->memory->number[done] : looked;
    for (int k = 0; looked > done && k < looked; k++) {
        int i = pair[k].i, j = pair[k].j;
        if (kind_of(z, i, j) != ALONE) {
            continue;
        }
        if (is_plain_joint(z, i, j)) {
            z->passed++;
        } else {
            solve_alone(z, i, j, out);
        }
    }
    return looked;
}

int path_solve(struct path_solver *z, const struct path_pair *pair, int count, struct path_records *out)
{
    int done = 0;
    while (done < count && has_room(out)) {
        done += solve_some(z, pair + done, count - done, out);
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
