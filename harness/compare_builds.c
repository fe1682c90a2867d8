/* Two builds in one run.  In each generation three processes are started, two of the first build and one of
 * the second, each with a stack of its own; they alternate whole-set passes in an order drawn anew every
 * round.  A generation gives one ratio, the median over its rounds; the interval is over the generations, for
 * a process that happens to lie badly in memory is slow as a whole.  The two of one build ought to agree: no
 * difference is called within theirs, within the noise floor, or within 1 percent. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "compare.h"
#include "contestant.h"
#include "random.h"
#include "statistics.h"

enum { FIRST, FIRST_AGAIN, SECOND, CONTESTANTS };
static const double level = 0.99, floor_least = 0.01, sample_ns = 4e6;

struct side {
    struct contestant process;
    const char *algorithm;
};

static double timed(void *context, int passes)
{
    struct side *s = (struct side *)context;
    char request[200];
    const char *answer;
    char *end;
    snprintf(request, sizeof request, "time %s %d", s->algorithm, passes);
    answer = contestant_ask(&s->process, request);
    double ns = answer ? strtod(answer, &end) : NAN;
    return answer && end != answer ? ns : NAN;
}

/* Marks what both builds get right; the number of pairs. */
static int common_pairs(struct side side[CONTESTANTS], char **digits)
{
    int count = 0;
    char request[200];
    snprintf(request, sizeof request, "judge %s", side[FIRST].algorithm);
    const char *first = contestant_ask(&side[FIRST].process, request);
    const char *second = contestant_ask(&side[SECOND].process, request);
    free(*digits);
    *digits = NULL;
    if (!first || !second || strlen(first) != strlen(second) || strspn(first, "01") != strlen(first))
        return 0;
    *digits = strdup(first);
    for (int i = 0; (*digits)[i]; i++) {
        (*digits)[i] = first[i] == '1' && second[i] == '1' ? '1' : '0';
        count += (*digits)[i] == '1';
    }
    return count;
}

static bool start(const struct compare_settings *s, const char *file, const char *algorithm,
                  struct random_state *random, struct side side[CONTESTANTS])
{
    for (int k = 0; k < CONTESTANTS; k++) {
        const char *error = contestant_start(&side[k].process, s->build[k == SECOND], s->tolerance,
                                             s->max_steps, file, (int)random_between(random, 0, 4095));
        side[k].algorithm = algorithm;
        if (error) {
            fprintf(stderr, "fatline compare: %s\n", error);
            return false;
        }
    }
    return true;
}

/* Medians over the rounds of one generation: the second build's time by that of the first, and the first's
 * two. */
static bool measure(struct side side[CONTESTANTS], const struct clock_plan *plan, int pairs, double *ratio,
                    double *noise)
{
    struct clock_task task[CONTESTANTS];
    struct clock_samples samples[CONTESTANTS];
    double *q = (double *)calloc((size_t)plan->rounds, sizeof *q),
           *n = (double *)calloc((size_t)plan->rounds, sizeof *n);
    memset(task, 0, sizeof task);
    for (int k = 0; k < CONTESTANTS; k++) {
        task[k].items = pairs;
        task[k].context = &side[k];
        task[k].timed = timed;
    }
    if (!q || !n)
        exit(2);
    clock_interleave(CONTESTANTS, task, plan, samples);
    for (int i = 0; i < plan->rounds; i++) {
        q[i] = 2 * samples[SECOND].ns[i] / (samples[FIRST].ns[i] + samples[FIRST_AGAIN].ns[i]);
        n[i] = samples[FIRST_AGAIN].ns[i] / samples[FIRST].ns[i];
    }
    *ratio = statistics_median(plan->rounds, q);
    *noise = statistics_median(plan->rounds, n);
    for (int k = 0; k < CONTESTANTS; k++)
        clock_samples_clear(&samples[k]);
    free(q);
    free(n);
    return isfinite(*ratio) && isfinite(*noise);
}

/* One generation; the number of pairs, 0 if there are none, -1 on failure. */
static int generation(const struct compare_settings *s, const char *file, const char *algorithm, int number,
                      char **digits, double *ratio, double *noise)
{
    struct random_state random = random_for(s->seed, algorithm, (uint64_t)number);
    struct clock_plan plan = {s->rounds, 0, sample_ns, s->seed + (uint64_t)number};
    struct side side[CONTESTANTS];
    memset(side, 0, sizeof side);
    int pairs = start(s, file, algorithm, &random, side) ? common_pairs(side, digits) : -1;
    char *request = pairs > 0 ? (char *)malloc(strlen(*digits) + 5) : NULL;
    if (request) {
        sprintf(request, "use %s", *digits);
        for (int k = 0; k < CONTESTANTS; k++)
            contestant_ask(&side[k].process, request);
        if (!measure(side, &plan, pairs, ratio, noise)) {
            fprintf(stderr, "fatline compare: %s: a process ended before its time\n", algorithm);
            pairs = -1;
        }
    }
    free(request);
    for (int k = 0; k < CONTESTANTS; k++)
        contestant_stop(&side[k].process);
    return pairs;
}

static double most(double a, double b)
{
    return a > b || isnan(b) ? a : b;
}

/* 0; 1: nothing to compare; 2: failed. */
static int compare_one(const struct compare_settings *s, const char *file, const char *algorithm,
                       struct comparison *c)
{
    double *ratio = (double *)calloc((size_t)s->generations, sizeof *ratio);
    double *noise = (double *)calloc((size_t)s->generations, sizeof *noise);
    const char *name = strrchr(file, '/');
    char *digits = NULL;
    int done = 0;
    if (!ratio || !noise)
        exit(2);
    for (c->pairs = 1; done < s->generations && c->pairs > 0; done += c->pairs > 0)
        c->pairs = generation(s, file, algorithm, done, &digits, &ratio[done], &noise[done]);
    free(digits);
    if (c->pairs > 0) {
        struct range range = statistics_bootstrap_median(s->generations, ratio, level, s->seed);
        c->family = name ? name + 1 : file;
        c->algorithm = algorithm;
        c->what = "cpu";
        c->ratio = statistics_median(s->generations, ratio);
        c->lo = range.lo;
        c->hi = range.hi;
        c->floor = most(most(floor_least, s->floor), fabs(statistics_median(s->generations, noise) - 1));
    }
    free(ratio);
    free(noise);
    return c->pairs > 0 ? 0 : c->pairs == 0 ? 1 : 2;
}

int compare_builds(const struct compare_settings *s, int *compared, int *slower)
{
    for (int i = 0; i < s->files; i++) {
        for (int k = 0; k < s->algorithms.count; k++) {
            struct comparison c;
            int status;
            memset(&c, 0, sizeof c);
            status = compare_one(s, s->file[i], s->algorithms.at[k]->name, &c);
            if (status == 2)
                return 2;
            if (status == 1) {
                fprintf(stderr, "fatline compare: %s: %s: no pair that both builds get right\n", s->file[i],
                        s->algorithms.at[k]->name);
                continue;
            }
            comparison_write(s, &c);
            *compared += 1;
            *slower += comparison_change(&c) == SLOWER;
        }
    }
    return 0;
}
