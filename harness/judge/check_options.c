#include "check_options.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "../run/options.h"

enum { TOLERANCE = 256, SAMPLE, KEEP_GOING, ROWS, TRUTH, POINTS, RESUME, DRY_RUN, STRICT };

static const struct argp_option options[] = {
    {0, 0, 0, 0, "What is checked:", 1},
    {"sample", SAMPLE, "1/N", 0, "one case in N of every class, the first one always", 0},
    {"truth", TRUTH, "JUDGE", OPTION_ARG_OPTIONAL,
     "compute the truth afresh: by exact algebra (`exact`, the default), by Krawczyk's test (`krawczyk`), or "
     "by exact algebra where that test gives no verdict (`either`)",
     0},
    {"keep-going", KEEP_GOING, 0, 0, "pass over bad lines; the exit status is still 65", 0},
    {0, 0, 0, 0, "How:", 2},
    {"tolerance", TOLERANCE, "X", 0, "width asked for in both parameters (1e-9)", 0},
    {"points", POINTS, "REACH", 0,
     "judge answers as points, each paired with one solution within REACH in both parameters "
     "(judge_points.h)",
     0},
    {"strict", STRICT, 0, 0,
     "also hold every record to its word, without any tolerance (judge_strict.h), and time each solve", 0},
    {"jobs", 'j', "N", 0,
     "processes that share the work (1); no more than cases, nor than 4 for each processor", 0},
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
    "Writes a table by class and algorithm (all, unless named); ambiguous cases have lines of their own. "
    "What "
    "went wrong is named on standard error.\v"
    "Each case is judged at the larger of the tolerance asked for and its own (expected.tol, which `truth` "
    "sets to 1e-12 or more), and in double solved at that too; at the other precisions it is solved at the "
    "tolerance asked for. "
    "The verdicts: RIGHT; WRONG (something missed, extra, duplicate or merged); STOPPED (out of steps or "
    "room "
    "with every solution still covered); NOT_TAKEN (the answer is UNSUPPORTED or INVALID); BROKEN (GAVE_UP, "
    "CRASHED, TIMED_OUT, also of an external program that ends, is late or writes something else); UNJUDGED "
    "(no truth known).\n\n"
    "The table has a part for each class and, if there are several, one for all that is not ambiguous.\n\n"
    "Merged: a group of records that hold a solution is wider than four tolerances.\n\n"
    "With --strict rows and table also have `violated`, the words broken, and rows `ns`, the time of the "
    "solve.\n\n"
    "Exit status: 0, 1 if something was missed or is extra or violated in a case that is not ambiguous "
    "(duplicate and merged do not count) or an answer is broken, 2 on an input or output error or if the "
    "external program is not "
    "there, 64 on wrong usage, 65 on bad data or no case, 130 when interrupted.";

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

static int read_sample(struct argp_state *state, const char *text)
{
    if (strncmp(text, "1/", 2))
        argp_error(state, "--sample: \"%s\", expected 1/N", text);
    return option_integer(state, "--sample", text + 2, 1, INT_MAX);
}

static bool parse_flag(int key, struct check_options *o)
{
    bool *flag = key == KEEP_GOING ? &o->keep_going
                 : key == ROWS     ? &o->rows
                 : key == RESUME   ? &o->resume
                 : key == DRY_RUN  ? &o->dry_run
                 : key == STRICT   ? &o->strict
                 : key == 'q'      ? &o->quiet
                                   : NULL;
    if (flag)
        *flag = true;
    return flag;
}

static void finish(struct argp_state *state, struct check_options *o)
{
    if (!o->solving.external && o->solving.algorithms.count == 0)
        solving_add(state, &o->solving.algorithms, "all");
    o->rows = o->rows || o->output;
    option_needs(state, o->resume, "--resume", o->output, "--output FILE");
    option_excludes(state, o->resume, "--resume", o->dry_run, "--dry-run");
    option_needs(state, o->strict && o->solving.external, "--strict beside --external",
                 o->solving.algorithms.count > 0, "--algorithm");
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct check_options *o = (struct check_options *)state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->cases;
        state->child_inputs[1] = &o->solving;
        return 0;
    case TOLERANCE:
        o->tolerance = option_positive(state, "--tolerance", text);
        return 0;
    case POINTS:
        o->points = option_positive(state, "--points", text);
        return 0;
    case SAMPLE:
        o->sample = read_sample(state, text);
        return 0;
    case TRUTH:
        o->truth = read_truth(state, text);
        return 0;
    case 'j':
        o->jobs = option_integer(state, "--jobs", text, 1, INT_MAX);
        return 0;
    case 'o':
        o->output = text;
        return 0;
    case ARGP_KEY_END:
        finish(state, o);
        return 0;
    default:
        return parse_flag(key, o) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

void check_options_read(int argc, char **argv, struct check_options *o)
{
    static const struct argp_child children[] = {
        {&selection_argp, 0, 0, 0}, {&solving_argp, 0, 0, 0}, {0, 0, 0, 0}};
    static const struct argp argp = {options, parse, "[FILE...]", documentation, children, 0, 0};
    memset((void *)o, 0, sizeof *o);
    o->tolerance = 1e-9;
    o->jobs = o->sample = 1;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}

void check_options_clear(struct check_options *o)
{
    algorithms_named_clear(&o->solving.algorithms);
    selection_clear(&o->cases);
}
