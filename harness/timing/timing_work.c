#include "timing_work.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../../algorithms/peers/foreign.h"
#include "../run/guard.h"

bool work_is_program(const struct contender *c)
{
    return c->algorithm && c->algorithm->foreign && !c->algorithm->foreign->kind->in_process;
}

const char *contender_protocol(const struct contender *c)
{
    return !c->algorithm ? "pipe" : c->batch ? "batch" : work_is_program(c) ? "inside" : "stream";
}

static void beat(const struct work *w)
{
    if (w->heartbeat) {
        w->heartbeat->contender = w->number;
        w->heartbeat->beats = w->heartbeat->beats + 1;
    }
}

void work_begin(struct work *w, int count)
{
    if (w->contender->batch) {
        beat(w);
        batch_set_make(&w->judged, count, w->at, NULL, w->contender->variant);
        batch_set_solve(&w->judged);
    }
}

void work_end(struct work *w)
{
    batch_set_clear(&w->judged);
    batch_set_clear(&w->timed);
}

struct answer work_ask(struct work *w, int i)
{
    struct answer a;
    const struct loaded_case *pair = w->at[i];
    const struct intersector *algorithm = w->contender->algorithm;

    beat(w);
    memset((void *)&a, 0, sizeof a);
    a.crossings = w->memory->crossings;
    if (!algorithm) {
        const char *error = external_ask(w->contender->external, pair->c.id, pair->line, &a);

        if (error && !w->failures++)
            snprintf(w->failure, sizeof w->failure, "; %s: %s", pair->c.id, error);
        return a;
    }
    a.id = pair->c.id;
    a.algorithm = algorithm->name;
    a.tolerance = pair->owned.problem.tolerance;
    a.points_only = algorithm->points_only;
    if (w->contender->batch) {
        a.outcome = batch_set_answer(&w->judged, i, a.crossings);
        return a;
    }
    a.outcome = guard_solve(&pair->owned.problem, algorithm, &w->memory->workspace, a.crossings);
    a.steps = w->memory->workspace.steps;
    return a;
}

/* What is timed. */
static void solve_pairs(void *context, int first, int last)
{
    struct work *w = (struct work *)context;
    const struct intersector *algorithm = w->contender->algorithm;

    beat(w);
    for (int i = first; i < last; i++) {
        const struct loaded_case *pair = w->at[w->index[i]];

        if (algorithm)
            problem_solve(&pair->owned.problem, algorithm, &w->memory->workspace, w->memory->crossings);
        else
            work_ask(w, w->index[i]);
        clock_keep(w->memory->crossings);
    }
}

static void solve_batch(void *context, int first, int last)
{
    struct work *w = (struct work *)context;

    beat(w);
    batch_set_run(&w->timed, first, last);
    clock_keep(w->timed.answer.record);
}

bool work_hand_over(struct work *w, int pairs)
{
    const struct foreign *x = w->contender->algorithm->foreign;

    x->kind->collect(x);
    solve_pairs(w, 0, pairs);
    return x->kind->collected(x) == pairs;
}

static double time_inside(void *context, int passes)
{
    struct work *w = (struct work *)context;
    const struct foreign *x = w->contender->algorithm->foreign;
    double ns;

    beat(w);
    if (x->kind->time(x, passes, &ns))
        return ns;
    w->failures++;
    return NAN;
}

static void each_inside(void *context, int passes, int items, double *ns)
{
    struct work *w = (struct work *)context;
    const struct foreign *x = w->contender->algorithm->foreign;

    beat(w);
    for (int i = 0; i < items; i++)
        ns[i] = 0;
    w->failures += !x->kind->each(x, passes, items, ns);
}

struct clock_task work_task(struct work *w, int pairs)
{
    struct clock_task task = {pairs, solve_pairs, w, !w->contender->algorithm, NULL, NULL};

    if (w->contender->batch) {
        batch_set_make(&w->timed, pairs, w->at, w->index, w->contender->variant);
        batch_set_solve(&w->timed);
        task.run = solve_batch;
    } else if (work_is_program(w->contender)) {
        task.timed = time_inside;
        task.timed_each = each_inside;
    }
    return task;
}
