#include "solve_options.h"

#include <argp.h>
#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"

enum { TOLERANCE = 256, MAX_STEPS, ROOM, ID, KEEP_GOING, TIMEOUT, HUMAN, DECIDE };

static const struct argp_option options[] = {
    {0, 0, 0, 0, "What is solved:", 1},
    {"id", ID, "GLOB", 0, "only the cases whose id matches", 0},
    {0, 'f', "POINTS", 0,
     "instead of files: control points of the first curve, \"x,y x,y ...\"; with weights x,y,w", 0},
    {0, 'g', "POINTS", 0, "control points of the second curve", 0},
    {"keep-going", KEEP_GOING, 0, 0, "pass over bad lines; the exit status is still 65", 0},
    {0, 0, 0, 0, "How:", 2},
    {"algorithm", 'a', "LIST", 0,
     "names, globs or `all`, separated by commas; may be repeated (that with * in `fatline list`)", 0},
    {"tolerance", TOLERANCE, "X", 0,
     "width asked for in both parameters (1e-12); what the precision cannot tell apart stays wider", 0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 0},
    {"room", ROOM, "N", 0, "cells that may wait at once (512)", 0},
    {"external", 'x', "CMD", 0, "a program that reads case lines and writes a line of `solve` for each", 0},
    {"timeout", TIMEOUT, "S", 0, "seconds an external program may take for a case (10)", 0},
    {"decide", DECIDE, "S", OPTION_ARG_OPTIONAL,
     "settle by exact arithmetic what is not UNIQUE: tangencies with their multiplicities, near misses, "
     "close "
     "solutions, overlaps; at most S seconds of processor time a case (10)",
     0},
    {0, 0, 0, 0, "What is written:", 3},
    {"output", 'o', "FILE", 0, "instead of standard output", 0},
    {"human", HUMAN, 0, 0, "tables for people; so also -f and -g on a terminal", 0},
    {"quiet", 'q', 0, 0, "no progress", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Intersect the curves of case lines in FILEs (- or none: standard input), or two curves of your own. "
    "Writes a "
    "line of JSON for each case and algorithm.\v"
    "Example: fatline solve -f \"0,0 1,2 2,0\" -g \"0,1 1,-1 2,1\"\n\n"
    "A coordinate is a decimal, a fraction a/b, a C hex float, or a decimal with a trailing f (rounded to "
    "float32). In what is written, numbers are decimals in double and C hex floats in quad and multi, so "
    "that "
    "nothing is lost; --human has decimals.\n\n"
    "The external program finds the tolerance in FATLINE_TOLERANCE. Where it is late, ends, or writes "
    "something "
    "else, the outcome is INVALID with a message, and it is started anew for the next case.\n\n"
    "With --decide rows have `decided`: true if every record is a proved UNIQUE or was settled by exact "
    "arithmetic, for the curves as the line states them; false, with the reason in `message`, where the time "
    "did not suffice (two cubics take milliseconds, degrees 16 and 16 a third of a second, 24 and 24 seven "
    "seconds, 32 and 32 forty): the records are then those of the algorithm.\n\n"
    "Exit status: 0, 2 on an input or output error or if the external program is not there, 64 on wrong "
    "usage, 65 on bad data, 130 when interrupted.";

static int read_count(struct argp_state *state, const char *name, const char *text)
{
    char *end;
    long n = strtol(text, &end, 10);
    if (end == text || *end || n < 1 || n > INT_MAX)
        argp_error(state, "%s: \"%s\", expected an integer from 1 to %d", name, text, INT_MAX);
    return (int)n;
}

/* "x,y" or "x,y,w" at *point, changed in place: appends to the two lists. */
static bool append_point(char *point, json_t *points, json_t *weights, bool *weighted)
{
    char *part[4] = {NULL, NULL, NULL, NULL};
    int n = 0;
    while (point && n < 4)
        part[n++] = strsep(&point, ",");
    if (n < 2 || n > 3)
        return false;
    *weighted = *weighted || n == 3;
    json_t *pair = json_pack("[s, s]", part[0], part[1]);
    json_t *weight = json_string(n == 3 ? part[2] : "1");
    return !json_array_append_new(points, pair) && !json_array_append_new(weights, weight);
}

static json_t *own_curve(struct argp_state *state, const char *name, const char *text)
{
    json_t *points = json_array(), *weights = json_array(), *curve = json_object();
    char *copy = strdup(text), *rest = copy, *point;
    bool weighted = false;
    while ((point = strsep(&rest, " \t\n;")) != NULL) {
        char *shown = *point ? strdup(point) : NULL;
        if (*point && !append_point(point, points, weights, &weighted))
            argp_error(state, "-%s: \"%s\" is no point, expected x,y or x,y,w", name, shown ? shown : "");
        free(shown);
    }
    free(copy);
    json_object_set_new(curve, "points", points);
    if (weighted)
        json_object_set(curve, "weights", weights);
    json_decref(weights);
    return curve;
}

static void finish(struct solve_options *o, struct argp_state *state)
{
    if (!o->f != !o->g)
        argp_error(state, "-f and -g go together");
    if (o->f && o->file_count > 0)
        argp_error(state, "either files or -f and -g");
    if (o->f) {
        json_t *line = json_pack("{s:s, s:o, s:o}", "id", "own", "f", own_curve(state, "f", o->f), "g",
                                 own_curve(state, "g", o->g));
        o->own_line = json_dumps(line, JSON_COMPACT);
        json_decref(line);
        if (!o->own_line)
            argp_error(state, "-f, -g: not UTF-8");
    }
    if (!o->external && o->algorithms.count == 0)
        algorithms_named_add(&o->algorithms, intersector_default->name);
}

static bool parse_number(int key, char *argument, struct solve_options *o, struct argp_state *state)
{
    char *end;
    switch (key) {
    case TOLERANCE:
        if (!real_parse(argument, &o->tolerance) || !(o->tolerance > 0))
            argp_error(state, "--tolerance: \"%s\", expected a number > 0", argument);
        return true;
    case TIMEOUT:
        o->timeout = strtod(argument, &end);
        if (end == argument || *end || !(o->timeout > 0) || isinf(o->timeout))
            argp_error(state, "--timeout: \"%s\", expected seconds > 0", argument);
        return true;
    case DECIDE:
        o->decide = argument ? strtod(argument, &end) : 10;
        if (argument && (end == argument || *end || !(o->decide > 0) || isinf(o->decide)))
            argp_error(state, "--decide: \"%s\", expected seconds > 0", argument);
        return true;
    case MAX_STEPS:
        o->max_steps = read_count(state, "--max-steps", argument);
        return true;
    case ROOM:
        o->room = read_count(state, "--room", argument);
        return true;
    default:
        return false;
    }
}

static bool parse_text(int key, char *argument, struct solve_options *o)
{
    const char **text = key == ID    ? &o->id
                        : key == 'f' ? &o->f
                        : key == 'g' ? &o->g
                        : key == 'x' ? &o->external
                        : key == 'o' ? &o->output
                                     : NULL;
    bool *flag = key == KEEP_GOING ? &o->keep_going
                 : key == HUMAN    ? &o->human
                 : key == 'q'      ? &o->quiet
                                   : NULL;
    if (text)
        *text = argument;
    if (flag)
        *flag = true;
    return text || flag;
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    struct solve_options *o = (struct solve_options *)state->input;
    const char *error;
    switch (key) {
    case 'a':
        error = algorithms_named_add(&o->algorithms, argument);
        if (error)
            argp_error(state, "%s", error);
        return 0;
    case ARGP_KEY_ARGS:
        o->files = state->argv + state->next;
        o->file_count = state->argc - state->next;
        return 0;
    case ARGP_KEY_END:
        finish(o, state);
        return 0;
    default:
        return parse_number(key, argument, o, state) || parse_text(key, argument, o) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

void solve_options_read(int argc, char **argv, struct solve_options *o)
{
    static const struct argp argp = {options, parse, "[FILE...]", documentation, 0, 0, 0};
    memset((void *)o, 0, sizeof *o);
    real_parse("1e-12", &o->tolerance);
    o->timeout = 10;
    o->max_steps = STEPS_MAX;
    o->room = WORKSPACE_ROOM;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}

void solve_options_clear(struct solve_options *o)
{
    algorithms_named_clear(&o->algorithms);
    free(o->own_line);
    o->own_line = NULL;
}
