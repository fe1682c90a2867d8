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
    int rounds;
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
    b->crossings = (struct crossings *)path_memory(NULL, sizeof *b->crossings);
    path_pairs_find(&job->a->path, job->b ? &job->b->path : NULL, &b->pairs);
    return true;
}

static void beside_clear(struct beside *b)
{
    workspace_clear(&b->workspace);
    free((void *)b->crossings);
    free(b->pairs.at);
}

/* The first round is not counted. */
static bool take_samples(struct path_job *job, struct beside *b, int rounds, const volatile int *stop,
                         struct samples *s)
{
    s->rounds = rounds;
    for (int r = -1; r < rounds; r++) {
        const struct path_times *t = &job->times;
        int k = r < 0 ? 0 : r;

        if (!path_job_run(job, stop))
            return false;
        s->ns[0][k] = t->build;
        s->ns[1][k] = t->walk;
        s->ns[2][k] = t->solve;
        s->ns[3][k] = t->join;
        s->ns[4][k] = t->build + t->walk + t->solve + t->join;
        if (b) {
            double from = clock_now(false);

            solve_beside(job, b);
            s->beside[k] = clock_now(false) - from;
        }
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
        json_pack("{s:[s,s], s:s, s:i, s:I, s:I, s:I, s:I, s:I, s:i, s:i, s:I, s:i}", "ids", job->a->id,
                  job->b ? job->b->id : job->a->id, "precision", REAL_NAME, "segments", segments, "tests",
                  (json_int_t)job->walk->tests, "candidates", (json_int_t)job->candidates, "solved",
                  (json_int_t)z->solved, "looped", (json_int_t)z->looped, "unsolved", (json_int_t)z->unsolved,
                  "found", (int)job->found, "records", job->records.count, "bytes", (json_int_t)job->bytes,
                  "samples", s->rounds);
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
    struct samples *s = (struct samples *)path_memory(NULL, sizeof *s);
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
