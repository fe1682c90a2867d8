#include "time_family.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "guard.h"
#include "instructions.h"
#include "progress.h"
#include "time_worker.h"

static void note_untimed(const struct family *f)
{
    const struct timing_report *r = &f->report;

    if (r->left_out == r->pairs) {
        progress_note("%s: not timed: no pair has a known answer (see `fatline truth`, or --unchecked)",
                      r->family);
        return;
    }
    for (int k = 0; k < r->contenders; k++)
        if (!r->timing[k].pairs && !f->settings->human && !r->contender[k].limit)
            progress_note("%s: %s %s: not timed: %s", r->family, r->contender[k].name, REAL_NAME,
                          r->timing[k].why_not);
}

/* NAN for whoever was not timed, or runs elsewhere. */
static double *count_instructions(const struct family *f, const struct timing *timing, int timed,
                                  const int *index)
{
    double *count = (double *)calloc(f->report.contenders, sizeof *count);

    for (int k = 0; count && k < f->report.contenders; k++) {
        const struct contender *c = &f->report.contender[k];

        count[k] = timing[k].pairs && !c->limit && !strcmp(contender_protocol(c), "stream")
                       ? instructions_count(c->algorithm, f->at, index, timed, f->settings->max_steps)
                       : NAN;
    }
    return count;
}

/* In the worker: the number of contenders timed on the family. */
static int time_family(void *context, FILE *to, struct heartbeat *heartbeat)
{
    struct family *f = (struct family *)context;
    struct timing_report *r = &f->report;
    struct timing_plan plan = f->settings->plan;
    struct timing *timing = (struct timing *)calloc(r->contenders, sizeof *timing);
    double *instructions = NULL;
    int timed = 0, pairs, *index;

    if (!timing)
        exit(2);
    plan.heartbeat = heartbeat;
    r->timing = timing;
    r->plan = &plan;
    pairs = timing_run(r->pairs, f->at, r->contenders, r->contender, &plan, f->memory, timing, &r->left_out,
                       &index);
    if (f->settings->count_instructions)
        r->instructions = instructions = count_instructions(f, timing, pairs, index);
    for (int k = 0; k < r->contenders; k++)
        timed += timing[k].pairs > 0 && !r->contender[k].limit;
    note_untimed(f);
    if (r->left_out < r->pairs && f->settings->human)
        timing_table_write(to, r);
    else if (r->left_out < r->pairs)
        timing_rows_write(to, r);
    for (int k = 0; k < r->contenders; k++)
        timing_clear(&timing[k]);
    free(instructions);
    free(index);
    free(timing);
    guard_end();
    return timed;
}

int time_family_run(struct family *f, struct contender *contender, FILE *out)
{
    struct family_work work = {time_family, f, contender, f->report.contenders,
                               f->settings->timeout * 12 + 60};
    int timed = 0;
    char *text = time_worker_run(&work, &timed);

    if (!text) {
        progress_note("%s: not timed: the process that timed it did not end well", f->report.family);
        return 0;
    }
    fputs(text, out);
    fflush(out);
    free(text);
    for (int k = 0; k < f->report.contenders; k++) {
        free((void *)contender[k].left_out);
        contender[k].left_out = NULL;
    }
    return timed;
}

double time_family_estimate(const struct family *f)
{
    enum { SAMPLE = 3 };
    const struct timing_report *r = &f->report;
    double rounds = 0, total = 0, sample = f->settings->plan.clock.sample_ns / 1e9;
    int few = r->pairs < SAMPLE ? r->pairs : SAMPLE;

    for (int k = 0; k < r->contenders; k++) {
        double start = 0, pair;

        if (!r->contender[k].algorithm)
            continue;
        for (int i = -1; i < few; i++) {
            if (i == 0) /* the first call may start a program */
                start = clock_now(true);
            guard_solve(&f->at[i < 0 ? 0 : i]->owned.problem, r->contender[k].algorithm,
                        &f->memory->workspace, f->memory->crossings);
        }
        pair = (clock_now(true) - start) / 1e9 / few;
        total += pair * r->pairs;
        rounds += f->settings->plan.clock.rounds * fmax(sample, pair * r->pairs);
    }
    if (f->settings->plan.clock.seconds > 0)
        rounds = fmin(rounds, 2 * f->settings->plan.clock.seconds);
    return total + rounds;
}
