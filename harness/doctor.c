/* `fatline doctor`: the same code against itself.  How small a difference means something here? */
#include <limits.h>
#include <math.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cases/case_set.h"
#include "timing/clock.h"
#include "timing/noise.h"
#include "run/options.h"
#include "run/row.h"
#include "run/standard_output.h"
#include "timing/statistics.h"

const char *argp_program_version = "fatline 0.1";

static const char documentation[] = "Times one algorithm against itself, interleaved as in `fatline time`, "
                                    "again and again. The ratio ought to be 1: "
                                    "the largest departure from it is the noise floor, a relative difference "
                                    "below which `fatline compare` calls none. "
                                    "It is kept beside the programs.\v"
                                    "Without FILE 200 random pairs of cubics are used. Writes a line a trial "
                                    "and one with the verdict. Exit status: 0 if "
                                    "the ratio's 99 percent interval holds 1 in at least 19 trials of 20, "
                                    "else 1; 2 on an input or output error, 64 on "
                                    "wrong usage, 65 on bad data or no case.";

enum { TRIALS = 256, ROUNDS, JSON, FORGET };
static const double level = 0.99, tolerance = 1e-9;

static const struct argp_option options[] = {{"algorithm", 'a', "NAME", 0, "which one", 0},
                                             {"trials", TRIALS, "N", 0, "how often (20)", 0},
                                             {"rounds", ROUNDS, "N", 0, "pairs of samples a trial (51)", 0},
                                             {"rows", JSON, 0, 0, "only the row that is kept", 0},
                                             {"forget", FORGET, 0, 0, "do not keep it", 0},
                                             {0, 0, 0, 0, 0, 0}};

struct settings {
    const struct intersector *algorithm;
    const char *file;
    int trials, rounds;
    bool json, forget;
};

/* One of the two; the other has memory of its own. */
struct side {
    const struct settings *settings;
    const struct case_set *set;
    struct workspace workspace;
    struct crossings *crossings;
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct settings *s = (struct settings *)state->input;
    switch (key) {
    case 'a':
        s->algorithm = intersector_find(text);
        if (!s->algorithm)
            argp_error(state, "no algorithm '%s', see `fatline list`", text);
        return 0;
    case TRIALS:
        s->trials = option_integer(state, "--trials", text, 5, 100000);
        return 0;
    case ROUNDS:
        s->rounds = option_integer(state, "--rounds", text, 5, 100000);
        return 0;
    case JSON:
        s->json = true;
        return 0;
    case FORGET:
        s->forget = true;
        return 0;
    case ARGP_KEY_ARG:
        if (s->file)
            argp_error(state, "one FILE only");
        s->file = text;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void solve(void *context, int first, int last)
{
    struct side *s = (struct side *)context;
    for (int i = first; i < last; i++) {
        problem_solve(&s->set->at[i].owned.problem, s->settings->algorithm, &s->workspace, s->crossings);
        clock_keep(s->crossings);
    }
}

static void side_make(struct side *side, const struct settings *s, const struct case_set *set)
{
    const struct intersector *const both[] = {s->algorithm, NULL};
    side->settings = s;
    side->set = set;
    side->crossings = (struct crossings *)calloc(1, sizeof *side->crossings);
    if (!side->crossings)
        exit(2);
    workspace_make(&side->workspace, both, set->degree_f, set->degree_g, WORKSPACE_ROOM);
}

/* The median ratio of the two and its interval. */
static double try_once(struct side side[2], int trial, struct range *range)
{
    const struct settings *s = side[0].settings;
    struct clock_task task[2];
    struct clock_samples samples[2];
    struct clock_plan plan = {s->rounds, 0, 2e6, (uint64_t)trial};
    double *ratio = (double *)calloc((size_t)s->rounds, sizeof *ratio), median;
    memset(task, 0, sizeof task);
    for (int k = 0; k < 2; k++) {
        task[k].items = side[k].set->count;
        task[k].run = solve;
        task[k].context = &side[k];
    }
    clock_interleave(2, task, &plan, samples);
    if (!ratio)
        exit(2);
    for (int i = 0; i < s->rounds; i++)
        ratio[i] = samples[1].ns[i] / samples[0].ns[i];
    median = statistics_median(s->rounds, ratio);
    *range = statistics_bootstrap_median(s->rounds, ratio, level, (uint64_t)trial);
    clock_samples_clear(&samples[0]);
    clock_samples_clear(&samples[1]);
    free(ratio);
    return median;
}

static int examine(const struct settings *s, const struct case_set *set)
{
    struct side side[2];
    double floor = 0;
    int held = 0, needed = (19 * s->trials + 19) / 20;
    json_t *row;
    for (int k = 0; k < 2; k++)
        side_make(&side[k], s, set);
    for (int i = 1; i <= s->trials; i++) {
        struct range range;
        double ratio = try_once(side, i, &range);
        bool holds = range.lo <= 1 && 1 <= range.hi;
        held += holds;
        floor = fmax(floor, fabs(ratio - 1));
        if (!s->json)
            printf("trial %2d: ratio %.5f [%.5f, %.5f]%s\n", i, ratio, range.lo, range.hi,
                   holds ? "" : "  does not hold 1");
        fflush(stdout);
    }
    row = json_pack("{s:f, s:i, s:i, s:i, s:s, s:i}", "noise_floor", floor, "trials", s->trials, "held", held,
                    "rounds", s->rounds, "algorithm", s->algorithm->name, "pairs", set->count);
    if (!s->forget && !noise_floor_save(row))
        fprintf(stderr, "fatline doctor: the noise floor cannot be kept beside the programs\n");
    if (s->json)
        row_write(stdout, json_incref(row));
    else
        printf("%d of %d intervals hold 1; noise floor %.3f%%: differences below it mean nothing\n", held,
               s->trials, 100 * floor);
    json_decref(row);
    for (int k = 0; k < 2; k++) {
        workspace_clear(&side[k].workspace);
        free(side[k].crossings);
    }
    return held >= needed ? 0 : 1;
}

/* Random cubics by the program beside this one, into a file of its own; its path. */
static const char *generate(void)
{
    static char file[] = "/tmp/fatline-doctor-XXXXXX";
    char program[PATH_MAX + 256];
    ssize_t n = readlink("/proc/self/exe", program, PATH_MAX);
    char folder[PATH_MAX + 1], *end;
    int descriptor = mkstemp(file);
    snprintf(folder, sizeof folder, "%.*s", (int)(n > 0 ? n : 0), program);
    end = strrchr(folder, '/');
    if (descriptor < 0 || !end)
        return NULL;
    close(descriptor);
    *end = 0;
    /* `generate` does not depend on the precision */
    snprintf(program, sizeof program,
             "'%s/../double/fatline-generate' random --degree 3 --count 200 --seed 1 >%s", folder, file);
    return system(program) ? NULL : file;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp parser = {options, parse, "[FILE]", documentation, NULL, NULL, NULL};
    struct settings s;
    struct case_set set = {0, 0, NULL, 0, NULL, 0, 0};
    struct noise noise;
    int status;
    memset(&s, 0, sizeof s);
    s.algorithm = intersector_default;
    s.trials = 20;
    s.rounds = 51;
    argp_parse(&parser, argc, argv, 0, NULL, &s);
    const char *file = s.file ? s.file : generate();
    if (!file) {
        fprintf(stderr, "fatline doctor: fatline-generate did not make cases\n");
        return 2;
    }
    noise_begin(&noise);
    status = case_set_read(&set, file, (real)tolerance, STEPS_MAX);
    if (!s.file)
        remove(file);
    if (!status && !set.count) {
        fprintf(stderr, "fatline doctor: no case in %s\n", strcmp(file, "-") ? file : "standard input");
        status = 65;
    }
    if (!status)
        status = examine(&s, &set);
    noise_warn(&noise, stderr);
    case_set_clear(&set);
    return status;
}
