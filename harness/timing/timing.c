/* See timing.h. */
#include "timing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../judge/judge_points.h"
#include "timing_work.h"
#include "../run/memory.h"

enum {
    EACH_PASSES = 5,
    PASSES_LEAST = 2 + CLOCK_ROUNDS_LEAST + EACH_PASSES, /* of whatever is timed, calibration included */
    PATIENCE = 3                                         /* failures of a program before it is given up */
};

/* What a contender made of a pair. */
enum result { GOOD, MISSING, OTHERWISE_WRONG, EARLY, REFUSED, BROKE };

/* Judged pairs x contenders. */
struct results {
    int pairs, contenders;
    int *index;            /* of the judged pairs in the family */
    unsigned char *result; /* [contender * pairs + pair] */
    double *ns;            /* likewise: how long that one solve took */
    bool *in;              /* [contender]: to be timed */
};

static enum result rate(const struct loaded_case *pair, const struct answer *a,
                        const struct timing_plan *plan)
{
    struct judgement j;
    enum verdict without = verdict_without(a->outcome);

    if (without != UNJUDGED)
        return without == BROKEN ? BROKE : REFUSED;
    if (plan->unchecked)
        return a->outcome == SOLVED ? GOOD : EARLY;
    if (plan->points > 0)
        j = judge_points(&pair->c, &pair->owned.problem, a, plan->points).found;
    else
        j = judge(&pair->c, &pair->owned.problem, a,
                  case_tolerance(&pair->c, real_to_double(plan->tolerance)));
    if (j.missed > 0)
        return MISSING;
    if (a->outcome != SOLVED)
        return j.verdict == WRONG ? OTHERWISE_WRONG : EARLY;
    return j.verdict == RIGHT ? GOOD : OTHERWISE_WRONG;
}

static void count_result(struct timing *t, enum result result, const char *id)
{
    t->judged++;
    t->right += result == GOOD;
    t->missing += result == MISSING;
    t->wrong += result == OTHERWISE_WRONG;
    t->stopped += result == EARLY;
    t->not_taken += result == REFUSED;
    t->broken += result == BROKE;
    if (result == MISSING && !t->first_missing)
        t->first_missing = id;
}

static void judge_all(struct work *work, const struct timing_plan *plan, struct results *r,
                      struct timing *timing)
{
    for (int k = 0; k < r->contenders; k++) {
        if (work_is_program(work[k].contender) && r->pairs > 0)
            work_ask(&work[k], r->index[0]); /* starts it, which is not the pair's own time */
        for (int i = 0; i < r->pairs; i++) {
            const struct loaded_case *pair = work[k].at[r->index[i]];
            enum result result = work[k].contender->limit ? GOOD : REFUSED;

            if (!work[k].contender->left_out && result != GOOD && work[k].failures < PATIENCE) {
                double start = clock_now(true);
                struct answer a = work_ask(&work[k], r->index[i]);

                r->ns[k * r->pairs + i] = clock_now(true) - start;
                result = rate(pair, &a, plan);
            }
            r->result[k * r->pairs + i] = result;
            count_result(&timing[k], result, pair->c.id);
        }
    }
}

static bool is_common(const struct results *r, int pair)
{
    for (int k = 0; k < r->contenders; k++)
        if (r->in[k] && r->result[k * r->pairs + pair] != GOOD)
            return false;
    return true;
}

/* Who is still in and was right least often; -1 if nobody is in. */
static int weakest(const struct results *r, const struct contender *contender, const struct timing *timing)
{
    int least = -1;

    for (int k = 0; k < r->contenders; k++)
        if (r->in[k] && !contender[k].limit && (least < 0 || timing[k].right <= timing[least].right))
            least = k;
    return least;
}

static void leave_out(struct results *r, const struct work *work, struct timing *timing, int k)
{
    struct timing *t = &timing[k];

    r->in[k] = false;
    if (work[k].contender->left_out)
        snprintf(t->why_not, sizeof t->why_not, "%.150s", work[k].contender->left_out);
    else if (t->broken == t->judged && t->judged)
        snprintf(t->why_not, sizeof t->why_not, "broke down on each of %d pairs%s", t->judged,
                 work[k].failure);
    else if (t->not_taken == t->judged && t->judged)
        snprintf(t->why_not, sizeof t->why_not, "takes none of %d pairs", t->judged);
    else if (t->missing)
        snprintf(t->why_not, sizeof t->why_not, "missed a root of %d of %d pairs, first %s", t->missing,
                 t->judged, t->first_missing);
    else
        snprintf(t->why_not, sizeof t->why_not, "right on only %d of %d pairs%s", t->right, t->judged,
                 work[k].failure);
}

/* Settles who is timed, and on which pairs; returns how many those are. */
static int choose(struct results *r, const struct work *work, const struct timing_plan *plan,
                  struct timing *timing, int *common)
{
    for (int k = 0; k < r->contenders; k++) {
        bool seldom =
            plan->forgive ? !timing[k].right : timing[k].missing || 2 * timing[k].right < timing[k].judged;

        r->in[k] = true;
        if (seldom || work[k].contender->left_out)
            leave_out(r, work, timing, k);
    }
    for (;;) {
        int out = weakest(r, work[0].contender, timing), count = 0;

        for (int i = 0; i < r->pairs; i++)
            if (is_common(r, i))
                common[count++] = i;
        if (out < 0 || count > 0)
            return out < 0 ? 0 : count;
        leave_out(r, work, timing, out);
    }
}

/* Keeps every so manieth common pair if a few passes over all would not fit into the time allowed. */
static int thin(const struct results *r, const struct timing_plan *plan, int count, int *common)
{
    double pass = 0;
    int stride = 1, kept = 0;

    for (int k = 0; k < r->contenders; k++)
        for (int i = 0; i < count && r->in[k]; i++)
            pass += r->ns[k * r->pairs + common[i]];
    if (plan->clock.seconds > 0)
        stride = (int)fmin(count, ceil(fmax(1, pass * (double)PASSES_LEAST / (plan->clock.seconds * 1e9))));
    for (int i = 0; i < count; i += stride)
        common[kept++] = common[i];
    return kept;
}

static double mean_steps(struct work *w, int pairs)
{
    double sum = 0;

    for (int i = 0; i < pairs; i++)
        sum += work_ask(w, w->index[i]).steps;
    return sum / pairs;
}

static double mean_roots(const struct work *w, int pairs)
{
    double sum = 0;

    for (int i = 0; i < pairs; i++) {
        const struct case_expected *e = &w->at[w->index[i]]->c.expected;

        sum += e->known ? e->count : NAN;
    }
    return sum / pairs;
}

static void find_slowest(struct work *w, const struct clock_task *task, struct timing *t)
{
    double *ns = (double *)memory_new(task->items, sizeof *ns);
    int worst = 0;

    clock_each(task, EACH_PASSES, ns);
    for (int i = 1; i < task->items; i++)
        if (ns[i] > ns[worst])
            worst = i;
    t->ns_max = ns[worst];
    t->worst_id = w->at[w->index[worst]]->c.id;
    free(ns);
}

/* Times those who are in on the pairs index[0..pairs-1] of the family. */
static void measure(struct work *work, const struct results *r, const struct timing_plan *plan, int pairs,
                    struct timing *timing)
{
    struct clock_task *task = (struct clock_task *)memory_new(r->contenders, sizeof *task);
    struct clock_samples *samples = (struct clock_samples *)memory_new(r->contenders, sizeof *samples);
    int *who = (int *)memory_new(r->contenders, sizeof *who), n = 0;

    for (int k = 0; k < r->contenders; k++) {
        if (!r->in[k])
            continue;
        work[k].failures = 0;
        timing[k].steps = mean_steps(&work[k], pairs);
        timing[k].roots = mean_roots(&work[k], pairs);
        if (work_is_program(work[k].contender) && !work_hand_over(&work[k], pairs)) {
            snprintf(timing[k].why_not, sizeof timing[k].why_not, "did not take the pairs to be timed");
            continue;
        }
        task[n] = work_task(&work[k], pairs);
        who[n++] = k;
    }
    clock_interleave(n, task, &plan->clock, samples);
    for (int i = 0; i < n; i++) {
        struct timing *t = &timing[who[i]];

        t->samples = samples[i];
        if (!work[who[i]].failures)
            find_slowest(&work[who[i]], &task[i], t);
        t->pairs = work[who[i]].failures ? 0 : pairs;
        if (work[who[i]].failures)
            snprintf(t->why_not, sizeof t->why_not, "failed %d times while timed%s", work[who[i]].failures,
                     work[who[i]].failure);
    }
    free(who);
    free(samples);
    free(task);
}

static int judgeable(int count, const struct loaded_case *const *at, bool unchecked, int *index)
{
    int pairs = 0;

    for (int i = 0; i < count; i++)
        if (unchecked || (at[i]->c.expected.known && !at[i]->c.ambiguous))
            index[pairs++] = i;
    return pairs;
}

int timing_run(int count, const struct loaded_case *const *at, int n, const struct contender *contender,
               const struct timing_plan *plan, struct timing_memory *memory, struct timing *timing,
               int *left_out, int **shared)
{
    struct work *work = (struct work *)memory_new(n, sizeof *work);
    int *common = (int *)memory_new(count, sizeof *common), pairs, all;
    struct results r;

    memset((void *)timing, 0, n * sizeof *timing);
    r.index = (int *)memory_new(count, sizeof *r.index);
    r.pairs = judgeable(count, at, plan->unchecked, r.index);
    r.contenders = n;
    r.result = (unsigned char *)memory_new((size_t)n * r.pairs, 1);
    r.ns = (double *)memory_new((size_t)n * r.pairs, sizeof *r.ns);
    r.in = (bool *)memory_new(n, sizeof *r.in);
    *left_out = count - r.pairs;
    for (int k = 0; k < n; k++) {
        work[k].contender = &contender[k];
        work[k].at = at;
        work[k].memory = memory;
        work[k].heartbeat = plan->heartbeat;
        work[k].number = k;
        work[k].index = common;
        work_begin(&work[k], count);
    }
    judge_all(work, plan, &r, timing);
    all = choose(&r, work, plan, timing, common);
    *shared = (int *)memory_new(all, sizeof **shared);
    for (int i = 0; i < all; i++)
        (*shared)[i] = r.index[common[i]];
    pairs = thin(&r, plan, all, common);
    for (int i = 0; i < pairs; i++)
        common[i] = r.index[common[i]];
    if (pairs > 0)
        measure(work, &r, plan, pairs, timing);
    for (int k = 0; k < n; k++)
        work_end(&work[k]);
    free(r.in);
    free(r.ns);
    free(r.result);
    free(r.index);
    free(common);
    free(work);
    return all;
}

void timing_clear(struct timing *timing)
{
    clock_samples_clear(&timing->samples);
}
