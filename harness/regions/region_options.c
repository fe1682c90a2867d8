#include "region_options.h"

#include <argp.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"

enum { TOLERANCE = 256, MAX_STEPS, CHECK, ROWS, ALL_POINTS, KEEP_GOING };

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
    "bad data, 130 when interrupted.";

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

static int read_count(struct argp_state *state, const char *text)
{
    char *end;
    long n = strtol(text, &end, 10);
    if (end == text || *end || n < 1 || n > INT_MAX)
        argp_error(state, "--max-steps: \"%s\", expected an integer from 1 to %d", text, INT_MAX);
    return (int)n;
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
        return 0;
    case MAX_STEPS:
        o->max_steps = read_count(state, argument);
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
        if (o->rows && !o->check)
            argp_error(state, "--rows goes with --check");
        if (o->count == 0)
            add_method(o, region_methods[0]);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
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
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}
