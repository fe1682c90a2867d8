#include "solve_options.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "options.h"

enum { TOLERANCE = 256, KEEP_GOING, HUMAN, DECIDE };

static const struct argp_option options[] = {
    {0, 0, 0, 0, "What is solved:", 1},
    {0, 'f', "POINTS", 0,
     "instead of files: control points of the first curve, \"x,y x,y ...\"; with weights x,y,w", 0},
    {0, 'g', "POINTS", 0, "control points of the second curve", 0},
    {"keep-going", KEEP_GOING, 0, 0, "pass over bad lines; the exit status is still 65", 0},
    {0, 0, 0, 0, "How:", 2},
    {"tolerance", TOLERANCE, "X", 0,
     "width asked for in both parameters (1e-12); what the precision cannot tell apart stays wider", 0},
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
    "line of JSON for each case and algorithm (that with * in `fatline list`, unless named).\v"
    "Example: fatline solve -f \"0,0 1,2 2,0\" -g \"0,1 1,-1 2,1\"\n\n"
    "A coordinate is a decimal, a fraction a/b, a C hex float, or a decimal with a trailing f (rounded to "
    "float32). In what is written, numbers are decimals in double and C hex floats in quad and multi, so "
    "that "
    "nothing is lost; --human has decimals.\n\n"
    "The external program finds the tolerance in FATLINE_TOLERANCE. Where it is late, ends, or writes "
    "something else, the outcome is TIMED_OUT, CRASHED or GAVE_UP with a message, and it is started anew for "
    "the next case. What it does not take it answers with UNSUPPORTED.\n\n"
    "With --decide rows have `decided`: true if every record is a proved UNIQUE or was settled by exact "
    "arithmetic, for the curves as the line states them; false, with the reason in `message`, where the time "
    "did not suffice (two cubics take milliseconds, degrees 16 and 16 a third of a second, 24 and 24 seven "
    "seconds, 32 and 32 forty): the records are then those of the algorithm.\n\n"
    "Exit status: 0, 2 on an input or output error or if the external program is not there, 64 on wrong "
    "usage, 65 on bad data or no case, 130 when interrupted.";

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
    const bool own = o->f && o->g;
    option_needs(state, o->f, "-f", o->g, "-g");
    option_needs(state, o->g, "-g", o->f, "-f");
    option_excludes(state, own, "-f and -g", o->cases.file_count > 0, "files");
    option_excludes(state, own, "-f and -g", selection_is_narrowed(&o->cases), "--class, --id and --filter");
    option_excludes(state, own, "-f and -g", o->keep_going, "--keep-going");
    option_needs(state, o->decide > 0 && o->solving.external, "--decide beside --external",
                 o->solving.algorithms.count > 0, "--algorithm");
    if (own) {
        json_t *line = json_pack("{s:s, s:o, s:o}", "id", "own", "f", own_curve(state, "f", o->f), "g",
                                 own_curve(state, "g", o->g));
        o->own_line = json_dumps(line, JSON_COMPACT);
        json_decref(line);
        if (!o->own_line)
            argp_error(state, "-f, -g: not UTF-8");
    }
    if (!o->solving.external && o->solving.algorithms.count == 0)
        solving_add(state, &o->solving.algorithms, intersector_default->name);
}

static bool parse_own(int key, char *text, struct solve_options *o)
{
    const char **texts = key == 'f' ? &o->f : key == 'g' ? &o->g : key == 'o' ? &o->output : NULL;
    bool *flag = key == KEEP_GOING ? &o->keep_going
                 : key == HUMAN    ? &o->human
                 : key == 'q'      ? &o->quiet
                                   : NULL;
    if (texts)
        *texts = text;
    if (flag)
        *flag = true;
    return texts || flag;
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct solve_options *o = (struct solve_options *)state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->cases;
        state->child_inputs[1] = &o->solving;
        return 0;
    case TOLERANCE:
        o->tolerance = option_tolerance(state, text);
        return 0;
    case DECIDE:
        o->decide = text ? option_positive(state, "--decide", text) : 10;
        return 0;
    case ARGP_KEY_END:
        finish(o, state);
        return 0;
    default:
        return parse_own(key, text, o) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

void solve_options_read(int argc, char **argv, struct solve_options *o)
{
    static const struct argp_child children[] = {
        {&selection_argp, 0, 0, 0}, {&solving_argp, 0, 0, 0}, {0, 0, 0, 0}};
    static const struct argp argp = {options, parse, "[FILE...]", documentation, children, 0, 0};
    memset((void *)o, 0, sizeof *o);
    o->tolerance = (real)1 / 1000000000000LL;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}

void solve_options_clear(struct solve_options *o)
{
    algorithms_named_clear(&o->solving.algorithms);
    selection_clear(&o->cases);
    free(o->own_line);
    o->own_line = NULL;
}
