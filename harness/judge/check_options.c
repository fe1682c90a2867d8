#include "check_options.h"

#include <argp.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    TOLERANCE = 256,
    MAX_STEPS,
    ROOM,
    ID,
    CLASS,
    SAMPLE,
    KEEP_GOING,
    TIMEOUT,
    ROWS,
    TRUTH,
    POINTS,
    FILTER,
    RESUME,
    DRY_RUN,
    STRICT
};

static const struct argp_option options[] = {
    {0, 0, 0, 0, "What is checked:", 1},
    {"class", CLASS, "NAME", 0, "only the cases of this class", 0},
    {"id", ID, "GLOB", 0, "only the cases whose id matches", 0},
    {"filter", FILTER, "REGEX", 0, "only the cases whose id matches this extended regular expression", 0},
    {"sample", SAMPLE, "1/N", 0, "one case in N of every class, the first one always", 0},
    {"truth", TRUTH, "JUDGE", OPTION_ARG_OPTIONAL,
     "compute the truth afresh: by exact algebra (`exact`, the default), by Krawczyk's test (`krawczyk`), or "
     "by exact algebra where that test gives no verdict (`either`)",
     0},
    {"keep-going", KEEP_GOING, 0, 0, "pass over bad lines; the exit status is still 65", 0},
    {0, 0, 0, 0, "How:", 2},
    {"algorithm", 'a', "LIST", 0,
     "names, globs, `all` or `peers`, separated by commas; may be repeated (`all`)", 0},
    {"tolerance", TOLERANCE, "X", 0, "width asked for in both parameters (1e-9)", 0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 0},
    {"room", ROOM, "N", 0, "cells that may wait at once (512)", 0},
    {"external", 'x', "CMD", 0, "a program that reads case lines and writes a line of `solve` for each", 0},
    {"timeout", TIMEOUT, "S", 0, "seconds an external program or another library may take for a case (10)",
     0},
    {"points", POINTS, "REACH", 0,
     "judge answers as points, each paired with one solution within REACH in both parameters "
     "(judge_points.h)",
     0},
    {"strict", STRICT, 0, 0,
     "also hold every record to its word, without any tolerance (judge_strict.h), and time each solve", 0},
    {"jobs", 'j', "N", 0, "processes that share the work (1)", 0},
    {0, 0, 0, 0, "What is written:", 3},
    {"rows", ROWS, 0, 0, "a line of JSON for each case and algorithm instead of the table", 0},
    {"output", 'o', "FILE", 0, "write the rows there", 0},
    {"resume", RESUME, 0, 0,
     "go on where the interrupted run that began FILE (--output) stopped; the status is then that of the "
     "rest",
     0},
    {"dry-run", DRY_RUN, 0, 0, "say how many cases there are and about how long they would take", 0},
    {"quiet", 'q', 0, 0, "no progress", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Compare what algorithms answer with the truth, for the cases in FILEs (- or none: standard input). "
    "Writes a table by class and algorithm; ambiguous cases have lines of their own. What went wrong is "
    "named "
    "on standard error.\v"
    "Each case is judged at the larger of the tolerance asked for and its own (expected.tol, which `truth` "
    "sets to 1e-12 or more), and in double solved at that too; at the other precisions it is solved at the "
    "tolerance asked for. "
    "The verdicts: RIGHT; WRONG (something missed, extra, duplicate or merged); STOPPED (out of steps or "
    "room "
    "with every solution still covered); NOT_TAKEN; UNJUDGED (no truth known).\n\n"
    "Merged: a group of records that hold a solution is wider than four tolerances.\n\n"
    "With --strict rows also have `violated`, the words broken, and `ns`, the time of the solve.\n\n"
    "Exit status: 0, 1 if something was missed or is extra or violated in a case that is not ambiguous "
    "(duplicate and merged do not count), 2 on an input or output error or if the external program is not "
    "there, 64 on "
    "wrong "
    "usage, 65 on bad data, 130 when interrupted.";

static int read_count(struct argp_state *state, const char *name, const char *text)
{
    char *end;
    long n = strtol(text, &end, 10);
    if (end == text || *end || n < 1 || n > INT_MAX)
        argp_error(state, "%s: \"%s\", expected an integer from 1 to %d", name, text, INT_MAX);
    return (int)n;
}

static double read_positive(struct argp_state *state, const char *name, const char *text)
{
    char *end;
    double a = strtod(text, &end);
    if (end == text || *end || !(a > 0) || isinf(a))
        argp_error(state, "%s: \"%s\", expected a number > 0", name, text);
    return a;
}

static enum truth read_truth(struct argp_state *state, const char *text)
{
    if (text && !strcmp(text, "krawczyk"))
        return TRUTH_KRAWCZYK;
    if (text && !strcmp(text, "either"))
        return TRUTH_EITHER;
    if (text && strcmp(text, "exact"))
        argp_error(state, "--truth: \"%s\", expected exact, krawczyk or either", text);
    return TRUTH_EXACT;
}

static bool parse_number(int key, const char *text, struct check_options *o, struct argp_state *state)
{
    switch (key) {
    case TOLERANCE:
        o->tolerance = read_positive(state, "--tolerance", text);
        return true;
    case POINTS:
        o->points = read_positive(state, "--points", text);
        return true;
    case TIMEOUT:
        o->timeout = read_positive(state, "--timeout", text);
        return true;
    case MAX_STEPS:
        o->max_steps = read_count(state, "--max-steps", text);
        return true;
    case ROOM:
        o->room = read_count(state, "--room", text);
        return true;
    case 'j':
        o->jobs = read_count(state, "--jobs", text);
        return true;
    case SAMPLE:
        if (strncmp(text, "1/", 2))
            argp_error(state, "--sample: \"%s\", expected 1/N", text);
        o->sample = read_count(state, "--sample", text + 2);
        return true;
    default:
        return false;
    }
}

static bool parse_text(int key, char *argument, struct check_options *o)
{
    const char **text = key == ID       ? &o->id
                        : key == FILTER ? &o->filter
                        : key == 'o'    ? &o->output
                        : key == CLASS  ? &o->class_name
                        : key == 'x'    ? &o->external
                                        : NULL;
    bool *flag = key == KEEP_GOING ? &o->keep_going
                 : key == ROWS     ? &o->rows
                 : key == RESUME   ? &o->resume
                 : key == DRY_RUN  ? &o->dry_run
                 : key == STRICT   ? &o->strict
                 : key == 'q'      ? &o->quiet
                                   : NULL;
    if (text)
        *text = argument;
    if (flag)
        *flag = true;
    return text || flag;
}

static void finish(struct argp_state *state, struct check_options *o)
{
    if (!o->external && o->algorithms.count == 0)
        algorithms_named_add(&o->algorithms, "all");
    o->rows = o->rows || o->output;
    if (o->resume && !o->output)
        argp_error(state, "--resume needs --output FILE");
    if (o->filter && regcomp(&o->regex, o->filter, REG_EXTENDED | REG_NOSUB))
        argp_error(state, "--filter: \"%s\" is not a regular expression", o->filter);
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    struct check_options *o = (struct check_options *)state->input;
    const char *error;
    switch (key) {
    case 'a':
        error = algorithms_named_add(&o->algorithms, argument);
        if (error)
            argp_error(state, "%s", error);
        return 0;
    case TRUTH:
        o->truth = read_truth(state, argument);
        return 0;
    case ARGP_KEY_ARGS:
        o->files = state->argv + state->next;
        o->file_count = state->argc - state->next;
        return 0;
    case ARGP_KEY_END:
        finish(state, o);
        return 0;
    default:
        return parse_number(key, argument, o, state) || parse_text(key, argument, o) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

void check_options_read(int argc, char **argv, struct check_options *o)
{
    static const struct argp argp = {options, parse, "[FILE...]", documentation, 0, 0, 0};
    memset((void *)o, 0, sizeof *o);
    o->timeout = 10;
    o->tolerance = 1e-9;
    o->max_steps = STEPS_MAX;
    o->room = WORKSPACE_ROOM;
    o->jobs = o->sample = 1;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}

void check_options_clear(struct check_options *o)
{
    algorithms_named_clear(&o->algorithms);
    if (o->filter)
        regfree(&o->regex);
}
