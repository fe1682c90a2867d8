#include "region_options.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"
#include "../run/options.h"

enum {
    TOLERANCE = 256,
    MAX_STEPS,
    CHECK,
    ROWS,
    ALL_POINTS,
    KEEP_GOING,
    AT,
    TIME,
    REPEAT,
    RANDOM,
    SEED,
    DEGREE
};

static const struct argp_option options[] = {
    {"method", 'm', "LIST", 0, "names separated by commas, or `all` (that first in --help)", 0},
    {"all-points", ALL_POINTS, 0, 0, "each control point of the curve in turn, whatever `free` says", 0},
    {"tolerance", TOLERANCE, "X", 0,
     "of polygons that stand for arcs, as a part of the curve's size (2^-20), and of areas and discs (as "
     "fine as "
     "the arithmetic allows)",
     0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (1000000)", 0},
    {"check", CHECK, 0, 0, "judge by `expected` and by a dense sample of half-planes", 0},
    {"rows", ROWS, 0, 0, "with --check: a line of JSON for each region instead of a summary", 0},
    {"at", AT, "X,Y", 0, "besides: on which side that point lies, its distance, the nearest allowed point",
     0},
    {"time", TIME, 0, 0, "a row for each region and method: nanoseconds on one thread", 0},
    {"repeat", REPEAT, "K", 0,
     "solve everything K times and write nothing but {\"regions\",\"passes\"}, for "
     "profilers; with --at only the question about the point",
     0},
    {"random", RANDOM, "N", 0, "write N random lines instead", 0},
    {"seed", SEED, "S", 0, "of --random (1)", 0},
    {"degree", DEGREE, "LO-HI", 0, "of --random (3-9)", 0},
    {"keep-going", KEEP_GOING, 0, 0, "pass over bad lines; the exit status is still 65", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "For each line of FILEs (- or none: standard input) that describes a planar curve with one free control "
    "point, "
    "writes where that point may go while the curve stays regular with curvature of one sign: an open convex "
    "region "
    "bounded by lines and by arcs of an envelope.\v"
    "A line: {\"id\", \"degree\", \"knots\" (null: Bezier), \"points\", \"weights\" (null: none), \"free\": "
    "index, "
    "[indices] that move together, or {\"t\": parameter} for the curve point there, \"interval\", \"sign\", "
    "\"loop_free\"}; datasets/README.md explains it, results/README.md what is written.\n\n"
    "Exit status: 0, 1 if --check finds something wrong, 2 on an input or output error, 64 on wrong usage, "
    "65 on "
    "bad data or no line, 130 when interrupted.";

static void add_method(struct region_options *o, const struct region_method *m)
{
    for (int i = 0; i < o->count; i++)
        if (o->method[i] == m)
            return;
    if (o->count < REGION_METHODS_MAX)
        o->method[o->count++] = m;
}

static void read_methods(struct region_options *o, char *list, struct argp_state *state)
{
    char names[500] = "";
    for (const struct region_method *const *m = region_methods; *m; m++)
        snprintf(names + strlen(names), sizeof names - strlen(names), " %s", (*m)->name);
    for (char *name; (name = strsep(&list, ",")) != NULL;) {
        const struct region_method *found = region_method_find(name);
        bool all = !strcmp(name, "all");
        for (int i = 0; all && region_methods[i]; i++)
            add_method(o, region_methods[i]);
        if (!all && !found)
            argp_error(state, "no method %s; there are%s", name, names);
        if (found)
            add_method(o, found);
    }
}

static void read_at(struct argp_state *state, char *text, struct region_options *o)
{
    char *y = strchr(text, ',');
    if (y)
        *y++ = 0;
    o->at_given = true;
    if (!y || !real_parse(text, &o->at.x) || !real_parse(y, &o->at.y))
        argp_error(state, "--at: expected two numbers X,Y");
}

static void read_degrees(struct argp_state *state, const char *text, struct region_options *o)
{
    char rest;
    int n = sscanf(text, "%d-%d%c", &o->degree_lo, &o->degree_hi, &rest);
    if (n == 1)
        o->degree_hi = o->degree_lo;
    if (n < 1 || n > 2 || o->degree_lo < 2 || o->degree_hi < o->degree_lo ||
        o->degree_hi > REGION_RATIONAL_MAX)
        argp_error(state, "--degree: \"%s\", expected LO-HI within 2-%d", text, REGION_RATIONAL_MAX);
}

static void finish(struct region_options *o, struct argp_state *state)
{
    const struct region_options_given *given = &o->given;
    const bool random = o->random > 0, judges = o->check || o->time;
    if (o->check + o->time + (o->repeat > 0) + random > 1)
        argp_error(state, "one of --check, --time, --repeat and --random only");
    option_needs(state, o->rows, "--rows", o->check, "--check");
    option_needs(state, given->seed, "--seed", random, "--random");
    option_needs(state, given->degree, "--degree", random, "--random");
    option_excludes(state, o->at_given, "--at", judges, "--check or --time");
    option_excludes(state, random, "--random", o->file_count > 0, "files");
    option_excludes(state, random, "--random", o->at_given, "--at");
    option_excludes(state, random, "--random", o->all_points, "--all-points");
    option_excludes(state, random, "--random", o->keep_going, "--keep-going");
    option_excludes(state, random, "--random", o->count > 0, "--method");
    option_excludes(state, random, "--random", given->tolerance || given->max_steps,
                    "--tolerance and --max-steps");
    if (o->count == 0)
        add_method(o, region_methods[0]);
}

/* false: not one of these. */
static bool parse_measuring(int key, char *argument, struct argp_state *state, struct region_options *o)
{
    switch (key) {
    case AT:
        read_at(state, argument, o);
        return true;
    case TIME:
        o->time = true;
        return true;
    case REPEAT:
        o->repeat = option_integer(state, "--repeat", argument, 1, INT_MAX);
        return true;
    case RANDOM:
        o->random = option_integer(state, "--random", argument, 1, INT_MAX);
        return true;
    case SEED:
        o->seed = option_integer(state, "--seed", argument, 0, INT_MAX);
        o->given.seed = true;
        return true;
    case DEGREE:
        read_degrees(state, argument, o);
        o->given.degree = true;
        return true;
    default:
        return false;
    }
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    struct region_options *o = (struct region_options *)state->input;
    switch (key) {
    case 'm':
        read_methods(o, argument, state);
        return 0;
    case TOLERANCE:
        if (!real_parse(argument, &o->tolerance) || !(o->tolerance >= 0) || !(o->tolerance < 1))
            argp_error(state, "--tolerance: \"%s\", expected a number in [0, 1)", argument);
        o->given.tolerance = true;
        return 0;
    case MAX_STEPS:
        o->max_steps = option_integer(state, "--max-steps", argument, 1, INT_MAX);
        o->given.max_steps = true;
        return 0;
    case CHECK:
        o->check = true;
        return 0;
    case ROWS:
        o->rows = true;
        return 0;
    case ALL_POINTS:
        o->all_points = true;
        return 0;
    case KEEP_GOING:
        o->keep_going = true;
        return 0;
    case ARGP_KEY_ARGS:
        o->files = state->argv + state->next;
        o->file_count = state->argc - state->next;
        return 0;
    case ARGP_KEY_END:
        finish(o, state);
        return 0;
    default:
        return parse_measuring(key, argument, state, o) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

/* The methods, below the options. */
static char *help_filter(int key, const char *text, void *input)
{
    (void)input;
    if (key != ARGP_KEY_HELP_POST_DOC)
        return (char *)text;
    size_t size = 4000, n;
    char *help = (char *)malloc(size);
    if (!help)
        return NULL;
    n = (size_t)snprintf(help, size, "Methods:\n");
    for (const struct region_method *const *m = region_methods; *m; m++)
        n += (size_t)snprintf(help + n, size - n, "  %-16s %s\n", (*m)->name, (*m)->summary);
    snprintf(help + n, size - n, "\n%s", text);
    return help;
}

void region_options_read(int argc, char **argv, struct region_options *o)
{
    static const struct argp argp = {options, parse, "[FILE...]", documentation, NULL, help_filter, NULL};
    memset((void *)o, 0, sizeof *o);
    o->tolerance = 0;
    o->max_steps = REGION_STEPS_MAX;
    o->seed = 1;
    o->degree_lo = 3;
    o->degree_hi = 9;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}
