#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../algorithms/peers/foreign.h"
#include "../cases/problem.h"
#include "../run/progress.h"
#include "../run/row.h"
#include "../timing/clock.h"
#include "../timing/statistics.h"
#include "path_boxes.h"
#include "path_timing.h"
#include "../run/memory.h"

enum { STAGES = 5, ROUNDS_MAX = 1000 };

static const char *const stages[STAGES] = {"build", "walk", "solve", "join", "total"};

/* Another algorithm on its pairs. */
struct beside {
    const struct intersector *algorithm;
    struct boxed_pairs pairs;
    struct workspace workspace;
    struct crossings *crossings;
};

struct samples {
    int rounds, passes;
    double ns[STAGES][ROUNDS_MAX], beside[ROUNDS_MAX];
};

static void solve_beside(const struct path_job *job, struct beside *b)
{
    const struct path *f = &job->a->path, *g = job->b ? &job->b->path : f;
    struct problem p;

    memset((void *)&p, 0, sizeof p);
    p.tolerance = job->solver.tolerance;
    p.max_steps = job->solver.max_steps;
    for (long k = 0; k < b->pairs.count; k++) {
        p.f = f->segment[b->pairs.at[k].i];
        p.g = g->segment[b->pairs.at[k].j];
        problem_solve(&p, b->algorithm, &b->workspace, b->crossings);
        clock_keep(b->crossings);
    }
}

static bool beside_make(const struct path_job *job, const char *name, struct beside *b)
{
    const struct intersector *used[2] = {NULL, NULL};
    int degree = job->b && job->b->degree > job->a->degree ? job->b->degree : job->a->degree;
    const struct foreign *x;

    memset((void *)b, 0, sizeof *b);
    used[0] = b->algorithm = intersector_find(name);
    x = b->algorithm->foreign;
    if (x && x->kind->absent(x)) {
        progress_note("--beside: %s: %s", name, x->kind->absent(x));
        return false;
    }
    if (x && !x->kind->in_process) {
        progress_note("--beside: %s works in another process, expected an algorithm of this one", name);
        return false;
    }
    workspace_make(&b->workspace, used, degree, degree, WORKSPACE_ROOM);
    b->crossings = (struct crossings *)memory_resized(NULL, sizeof *b->crossings);
    path_pairs_find(&job->a->path, job->b ? &job->b->path : NULL, &b->pairs);
    return true;
}

static void beside_clear(struct beside *b)
{
    workspace_clear(&b->workspace);
    free((void *)b->crossings);
    free(b->pairs.at);
}

/* As many passes as take a sample's time, one at least. */
static int passes_for(double ns)
{
    const double sample_ns = 1e7;

    return ns < sample_ns ? (int)(sample_ns / (ns + 1)) + 1 : 1;
}

/* Means of so many runs. */
static bool sample_paths(struct path_job *job, int passes, const volatile int *stop, double ns[STAGES])
{
    for (int k = 0; k < STAGES; k++)
        ns[k] = 0;
    for (int p = 0; p < passes; p++) {
        const struct path_times *t = &job->times;

        if (!path_job_run(job, stop))
            return false;
        ns[0] += t->build / passes;
        ns[1] += t->walk / passes;
        ns[2] += t->solve / passes;
        ns[3] += t->join / passes;
    }
    ns[4] = ns[0] + ns[1] + ns[2] + ns[3];
    return true;
}

static double sample_beside(const struct path_job *job, struct beside *b, int passes)
{
    double from = clock_now(false);

    for (int p = 0; p < passes; p++)
        solve_beside(job, b);
    return (clock_now(false) - from) / passes;
}

/* The first round, of one pass each, only says how many passes a sample has. */
static bool take_samples(struct path_job *job, struct beside *b, int rounds, const volatile int *stop,
                         struct samples *s)
{
    double ns[STAGES];
    int beside_passes = 0;

    s->rounds = rounds;
    if (!sample_paths(job, 1, stop, ns))
        return false;
    s->passes = passes_for(ns[STAGES - 1]);
    if (b)
        beside_passes = passes_for(sample_beside(job, b, 1));
    for (int r = 0; r < rounds; r++) {
        if (!sample_paths(job, s->passes, stop, ns))
            return false;
        for (int k = 0; k < STAGES; k++)
            s->ns[k][r] = ns[k];
        if (b)
            s->beside[r] = sample_beside(job, b, beside_passes);
    }
    return true;
}

static void set_real(json_t *row, const char *name, double a)
{
    json_object_set_new(row, name, json_real(a));
}

static void add_ratio(json_t *row, const struct beside *b, const struct samples *s)
{
    double q[ROUNDS_MAX];
    struct range range;

    for (int r = 0; r < s->rounds; r++)
        q[r] = s->ns[4][r] / s->beside[r];
    range = statistics_bootstrap_median(s->rounds, q, 0.95, 1);
    json_object_set_new(row, "beside", json_string(b->algorithm->name));
    json_object_set_new(row, "beside_pairs", json_integer(b->pairs.count));
    set_real(row, "beside_ns", statistics_median(s->rounds, s->beside));
    set_real(row, "ratio", statistics_median(s->rounds, q));
    set_real(row, "ratio_lo", range.lo);
    set_real(row, "ratio_hi", range.hi);
}

static json_t *row_of(const struct path_job *job, const struct samples *s)
{
    int segments = job->a->path.count + (job->b ? job->b->path.count : 0);
    const struct path_solver *z = &job->solver;
    json_t *row =
        json_pack("{s:[s,s], s:s, s:i, s:I, s:I, s:I, s:I, s:I, s:i, s:i, s:I, s:i, s:i}", "ids", job->a->id,
                  job->b ? job->b->id : job->a->id, "precision", REAL_NAME, "segments", segments, "tests",
                  (json_int_t)job->walk->tests, "candidates", (json_int_t)job->candidates, "solved",
                  (json_int_t)z->solved, "looped", (json_int_t)z->looped, "unsolved", (json_int_t)z->unsolved,
                  "found", (int)job->found, "records", job->records.count, "bytes", (json_int_t)job->bytes,
                  "samples", s->rounds, "passes", s->passes);
    for (int k = 0; k < STAGES; k++) {
        char name[32];

        snprintf(name, sizeof name, "ns_%s", stages[k]);
        set_real(row, name, statistics_median(s->rounds, s->ns[k]));
    }
    set_real(row, "ns_segment", statistics_median(s->rounds, s->ns[4]) / segments);
    set_real(row, "bytes_segment", (double)job->bytes / segments);
    return row;
}

bool path_timing_write(FILE *stream, struct path_job *job, const struct path_options *o,
                       const volatile int *stop)
{
    struct samples *s = (struct samples *)memory_resized(NULL, sizeof *s);
    struct beside b;
    bool good = !o->beside || beside_make(job, o->beside, &b);

    if (good) {
        good = take_samples(job, o->beside ? &b : NULL, o->rounds, stop, s);
        if (good) {
            json_t *row = row_of(job, s);

            if (o->beside)
                add_ratio(row, &b, s);
            row_write(stream, row);
            fflush(stream);
        }
        if (o->beside)
            beside_clear(&b);
    }
    free(s);
    return good;
}
