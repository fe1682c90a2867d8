/* See clock.h. */
#include "clock.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "../cases/random.h"
#include "../run/memory.h"

double clock_now(bool wall)
{
    struct timespec now;

    clock_gettime(wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
    return now.tv_sec * 1e9 + now.tv_nsec;
}

double clock_tick(bool wall)
{
    double tick = INFINITY;

    for (int seen = 0; seen < 1000;) {
        double before = clock_now(wall), after = clock_now(wall);

        if (after > before) {
            tick = fmin(tick, after - before);
            seen++;
        }
    }
    return tick;
}

static double time_passes(const struct clock_task *task, int passes)
{
    double start;

    if (task->timed)
        return task->timed(task->context, passes);
    start = clock_now(task->wall);

    for (int i = 0; i < passes; i++)
        task->run(task->context, 0, task->items);
    return clock_now(task->wall) - start;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* Passes a sample needs so that even the faster of two lasts `enough` ns; warms up on the way. */
static int calibrate(const struct clock_task *task, double enough)
{
    int passes = 1;

    /* fmin would pass over a NAN */
    while (smaller(time_passes(task, passes), time_passes(task, passes)) < enough && passes < 1 << 28)
        passes *= 2;
    return passes;
}

static void shuffle(int n, int *order, struct random_state *random)
{
    for (int i = n - 1; i > 0; i--) {
        int j = (int)random_between(random, 0, i), swap = order[i];

        order[i] = order[j];
        order[j] = swap;
    }
}

void clock_interleave(int n, const struct clock_task *task, const struct clock_plan *plan,
                      struct clock_samples *samples)
{
    struct random_state random = random_for(plan->seed, "rounds", (uint64_t)n);
    double enough[2] = {fmax(plan->sample_ns, (double)CLOCK_TICKS * clock_tick(false)),
                        fmax(plan->sample_ns, (double)CLOCK_TICKS * clock_tick(true))};
    double start = clock_now(true);
    int *order = (int *)memory_new(n, sizeof *order), least = plan->rounds;

    if (least > CLOCK_ROUNDS_LEAST)
        least = CLOCK_ROUNDS_LEAST;
    for (int i = 0; i < n; i++) {
        samples[i].count = 0;
        samples[i].passes = calibrate(&task[i], enough[task[i].wall]);
        samples[i].ns = (double *)memory_new(plan->rounds, sizeof *samples[i].ns);
        order[i] = i;
    }
    for (int r = 0; r < plan->rounds; r++) {
        if (r >= least && plan->seconds > 0 && clock_now(true) - start > plan->seconds * 1e9)
            break;
        shuffle(n, order, &random);
        for (int k = 0; k < n; k++) {
            const struct clock_task *now = &task[order[k]];
            struct clock_samples *to = &samples[order[k]];

            to->ns[to->count++] = time_passes(now, to->passes) / to->passes / now->items;
        }
    }
    free(order);
}

void clock_samples_clear(struct clock_samples *samples)
{
    free(samples->ns);
    samples->ns = NULL;
    samples->count = 0;
}

void clock_each(const struct clock_task *task, int passes, double *ns)
{
    double cost = clock_tick(true);

    if (task->timed_each) {
        task->timed_each(task->context, passes, task->items, ns);
        return;
    }
    for (int i = 0; i < task->items; i++)
        ns[i] = INFINITY;
    for (int r = 0; r < passes; r++) {
        for (int i = 0; i < task->items; i++) {
            double start = clock_now(true);

            task->run(task->context, i, i + 1);
            ns[i] = fmin(ns[i], clock_now(true) - start);
        }
    }
    for (int i = 0; i < task->items; i++)
        ns[i] = fmax(0, ns[i] - cost);
}
