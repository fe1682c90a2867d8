/* `fatline repeat`: solves every case K times and prints nothing of it, for profilers.
 *
 * The difference of two runs with different K holds the solves alone: scripts/instructions counts so. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases/case_set.h"
#include "timing/clock.h"
#include "run/options.h"
#include "run/solving.h"
#include "run/standard_output.h"

const char *argp_program_version = "fatline 0.1";

static const char documentation[] =
    "Solves every case of FILE (-: standard input) K times, one whole pass after the other, for profilers.\v"
    "Prints one line {\"pairs\",\"passes\",\"solved\"}: the cases, K, and how many were SOLVED in a pass. "
    "Exit "
    "status: 0, 2 on an input or output error, 64 on wrong usage, 65 on bad data or no case.";

enum { TIMES = 256, TOLERANCE, MAX_STEPS, OWN_TOLERANCE };

static const struct argp_option options[] = {
    {"algorithm", 'a', "NAME", 0, "which algorithm (needed)", 0},
    {"times", TIMES, "K", 0, "passes over the cases (1)", 0},
    {"tolerance", TOLERANCE, "X", 0, "width asked for in both parameters (1e-12)", 0},
    {"own-tolerance", OWN_TOLERANCE, 0, 0, "each case at the number in its field `tolerance`, if it has one",
     0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 0},
    {0, 0, 0, 0, 0, 0}};

struct settings {
    const struct intersector *algorithm;
    const char *file;
    int times, max_steps;
    real tolerance;
    bool own_tolerance;
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct settings *s = (struct settings *)state->input;

    switch (key) {
    case 'a':
        s->algorithm = intersector_find(text);
        if (!s->algorithm)
            argp_error(state, "--algorithm: no algorithm '%s', see `fatline list`", text);
        return 0;
    case TIMES:
        s->times = option_integer(state, "--times", text, 1, 1000000000);
        return 0;
    case TOLERANCE:
        s->tolerance = option_tolerance(state, text);
        return 0;
    case OWN_TOLERANCE:
        s->own_tolerance = true;
        return 0;
    case MAX_STEPS:
        s->max_steps = option_integer(state, "--max-steps", text, 1, 1000000000);
        return 0;
    case ARGP_KEY_ARG:
        if (s->file)
            argp_error(state, "one FILE only");
        s->file = text;
        return 0;
    case ARGP_KEY_END:
        if (!s->algorithm || !s->file)
            argp_error(state, "--algorithm and FILE are needed");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {options, parse, "FILE", documentation, NULL, NULL, NULL};

static int repeat(const struct settings *s, const struct case_set *set)
{
    const struct intersector *const both[] = {s->algorithm, NULL};
    struct crossings *crossings = (struct crossings *)malloc(sizeof *crossings);
    struct workspace workspace;
    long solved = 0;

    if (!crossings)
        return 2;
    workspace_make(&workspace, both, set->degree_f, set->degree_g, WORKSPACE_ROOM);
    for (int k = 0; k < s->times; k++) {
        for (int i = 0; i < set->count; i++) {
            solved += problem_solve(&set->at[i].owned.problem, s->algorithm, &workspace, crossings) == SOLVED;
            clock_keep(crossings);
        }
    }
    printf("{\"pairs\":%d,\"passes\":%d,\"solved\":%ld}\n", set->count, s->times, solved / s->times);
    workspace_clear(&workspace);
    free(crossings);
    return 0;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    struct case_set set = {0, 0, NULL, 0, NULL, 0, 0};
    struct settings s;
    int status;

    memset(&s, 0, sizeof s);
    s.times = 1;
    s.max_steps = STEPS_MAX;
    s.tolerance = (real)1 / 1000000000000LL;
    argp_parse(&parser, argc, argv, 0, NULL, &s);
    status = case_set_read(&set, s.file, s.tolerance, s.max_steps);
    for (int i = 0; s.own_tolerance && i < set.count; i++) {
        const json_t *own = json_object_get(set.at[i].c.line, "tolerance");
        if (json_is_number(own))
            set.at[i].owned.problem.tolerance = (real)json_number_value(own);
    }
    if (!status && !set.count) {
        fprintf(stderr, "fatline repeat: no case in %s\n", strcmp(s.file, "-") ? s.file : "standard input");
        status = 65;
    }
    if (!status)
        status = repeat(&s, &set);
    case_set_clear(&set);
    return status;
}
