/* See time_options.h. */
#include "time_options.h"

#include <argp.h>
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "number.h"

static const char documentation[] =
    "Times intersection algorithms on the case lines of FILEs (- or none: standard input).\v"
    "Every algorithm is first judged on every pair. One that misses a root is not timed on that "
    "family, nor is one that is right on fewer than half of its pairs, and the row says so; the "
    "others are timed on the pairs that all of them got right. Ambiguous pairs and pairs without "
    "a known answer are left out.\n\n"
    "A sample is a number of passes over all these pairs, long enough for the clock, in ns a pair "
    "(CPU time). In each round every algorithm gives one sample, in an order drawn anew, so that "
    "ratios are taken between neighbours in time. ns_min, ns_median and ns_mad (median absolute "
    "deviation, unscaled) are over samples, ns_lo and ns_hi bound a 95 percent bootstrap interval "
    "of the median; ns_max is the shortest time of the slowest single pair, worst_id, by the wall clock. "
    "External "
    "programs are timed in wall-clock time around their pipe, one line after the other (protocol "
    "\"pipe\"); no ratio is taken between the two protocols.\n\n"
    "The branch predictor learns a set of few pairs by heart: compare times of sets of similar "
    "size.\n\n"
    "Rows are JSON, one a line, after one line on the circumstances; on a terminal, or with "
    "--human, a table. Exit status: 0, 1 if nothing could be timed, 2 on an input or output "
    "error, 64 on wrong usage, 65 on bad data.";

enum { TOLERANCE = 256, MAX_STEPS, ROUNDS, SECONDS, PIN, FAMILY_BY, UNCHECKED, HUMAN, ROWS, SEED, TIMEOUT };

static const struct argp_option options[] = {
    {"algorithm", 'a', "LIST", 0, "names or globs, separated by commas, or `all` (the default)", 0},
    {"baseline", 'b', "NAME", 0, "give ratios to this algorithm, from the same rounds", 0},
    {"external", 'x', "CMD", 0, "also time a program that reads case lines and writes `solve` lines", 0},
    {"timeout", TIMEOUT, "S", 0, "seconds an external program may take for a pair (10)", 0},
    {"tolerance", TOLERANCE, "X", 0,
     "width asked for in both parameters (1e-12); in double each pair is solved at the larger of this and "
     "its own",
     0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 0},
    {"rounds", ROUNDS, "N", 0, "samples of each algorithm, at most (51)", 0},
    {"seconds", SECONDS, "S", 0,
     "time allowed for the rounds of a family (10; 0: no limit); 5 rounds at least, on fewer pairs if "
     "need be",
     0},
    {"seed", SEED, "N", 0, "of the order within the rounds and of the bootstrap (1)", 0},
    {"pin", PIN, "CPU", 0, "run on this processor only; `none` (the default): wherever the system likes", 0},
    {"family-by", FAMILY_BY, "WHAT", 0,
     "what makes a family: `file` (the default), `class`, or any text field of the case lines", 0},
    {"unchecked", UNCHECKED, 0, 0, "time whatever was SOLVED, right or wrong or not known", 0},
    {"human", HUMAN, 0, 0, "a table instead of rows", 0},
    {"rows", ROWS, 0, 0, "rows even on a terminal", 0},
    {0, 0, 0, 0, 0, 0}};

static void push(char ***list, int *count, char *text)
{
    *list = (char **)realloc(*list, (*count + 1) * sizeof **list);
    if (!*list)
        exit(2);
    (*list)[(*count)++] = text;
}

static double number_in(struct argp_state *state, const char *name, const char *text, double lo, double hi)
{
    char *end;
    double value = strtod(text, &end);

    if (end == text || *end || !(lo <= value && value <= hi))
        argp_error(state, "--%s: '%s' is not a number from %g to %g", name, text, lo, hi);
    return value;
}

static int count_in(struct argp_state *state, const char *name, const char *text, double lo, double hi)
{
    double value = number_in(state, name, text, lo, hi);

    if (value != floor(value))
        argp_error(state, "--%s: '%s' is not a whole number", name, text);
    return (int)value;
}

static void add_algorithms(struct argp_state *state, struct time_settings *s, const char *list)
{
    const char *error = algorithms_named_add(&s->algorithms, list);

    if (error)
        argp_error(state, "%s", error);
}

static void finish(struct argp_state *state, struct time_settings *s)
{
    if (!s->algorithms.count && !s->externals)
        add_algorithms(state, s, "all");
    if (s->baseline)
        add_algorithms(state, s, s->baseline);
    if (!s->files)
        push(&s->file, &s->files, (char *)"-");
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct time_settings *s = (struct time_settings *)state->input;

    switch (key) {
    case 'a':
        add_algorithms(state, s, text);
        return 0;
    case 'b':
        s->baseline = text;
        return 0;
    case 'x':
        push(&s->external, &s->externals, text);
        return 0;
    case TIMEOUT:
        s->timeout = number_in(state, "timeout", text, 1e-3, 1e9);
        return 0;
    case TOLERANCE:
        if (!real_parse(text, &s->plan.tolerance) || !(s->plan.tolerance > 0))
            argp_error(state, "--tolerance: '%s' is not a positive number", text);
        return 0;
    case MAX_STEPS:
        s->max_steps = count_in(state, "max-steps", text, 1, 1e9);
        return 0;
    case ROUNDS:
        s->plan.clock.rounds = count_in(state, "rounds", text, 1, 1e6);
        return 0;
    case SECONDS:
        s->plan.clock.seconds = number_in(state, "seconds", text, 0, 1e9);
        return 0;
    case SEED:
        s->plan.clock.seed = (uint64_t)count_in(state, "seed", text, 0, 2147483647);
        return 0;
    case PIN:
        s->cpu = strcmp(text, "none") ? count_in(state, "pin", text, 0, CPU_SETSIZE - 1) : -1;
        return 0;
    case FAMILY_BY:
        s->family_by = text;
        return 0;
    case UNCHECKED:
        s->plan.unchecked = true;
        return 0;
    case HUMAN:
    case ROWS:
        s->human = key == HUMAN;
        return 0;
    case ARGP_KEY_ARG:
        push(&s->file, &s->files, text);
        return 0;
    case ARGP_KEY_END:
        finish(state, s);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {options, parse, "FILE...", documentation, NULL, NULL, NULL};

void time_settings_read(int argc, char **argv, struct time_settings *s)
{
    memset(s, 0, sizeof *s);
    s->family_by = "file";
    s->plan.tolerance = (real)1 / 1000000000000LL;
    s->plan.clock.rounds = 51;
    s->plan.clock.seconds = 10;
    s->plan.clock.sample_ns = 2e6;
    s->plan.clock.seed = 1;
    s->max_steps = STEPS_MAX;
    s->cpu = -1;
    s->timeout = 10;
    s->human = isatty(STDOUT_FILENO);
    argp_parse(&parser, argc, argv, 0, NULL, s);
}

void time_settings_clear(struct time_settings *s)
{
    algorithms_named_clear(&s->algorithms);
    free(s->external);
    free(s->file);
}
