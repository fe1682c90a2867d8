/* fatline cost: the steps that algorithms take on a ladder of tolerances, and the law they follow. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases/case.h"
#include "convergence/cost_law.h"
#include "convergence/measuring.h"
#include "cases/json_text.h"
#include "cases/problem.h"
#include "run/interrupt.h"
#include "run/options.h"
#include "run/row.h"
#include "run/standard_output.h"

const char *argp_program_version = "fatline 0.1";

enum { FROM = 256, TO, EVERY, MAX_STEPS, ROOM, POINTS_MAX = 2100 };

static const struct argp_option options[] = {
    {"from", FROM, "N", 0, "widest tolerance 2^-N (4)", 0},
    {"to", TO, "N", 0, "narrowest tolerance 2^-N (a third of the bits of the precision, at most 100)", 0},
    {"every", EVERY, "N", 0, "binary orders between two tolerances (2)", 0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit; the ladder ends where it is reached (1000000)", 0},
    {"room", ROOM, "N", 0, "cells that may wait at once (4096)", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Count the steps of algorithms on the case lines of FILEs (- or none: standard input) for tolerances "
    "2^-N, and fit "
    "the law that they follow: logarithmic, c + b log2(1/eps), or power, c eps^-p.\v"
    "steps: cells taken from the stack; a four-way split makes four of them. boxes: what was accepted as "
    "narrow enough, "
    "before records are merged for want of room. The ladder ends at the first tolerance that needs more than "
    "the step "
    "limit. The better law is the one with the smaller scatter of the logarithm; the exponent p is given "
    "with its 95 "
    "percent interval in either case. Where a box is narrower than the root of the "
    "rounding error of the coordinates (2^-26 in double), strips are as wide as that error and the law "
    "breaks: the default "
    "ends before.\n\n"
    "Exit status: 0, 2 on an input or output error, 64 on wrong usage, 65 on bad data or no case, 130 when "
    "interrupted.";

struct command {
    struct measuring measuring;
    int from, to, every, max_steps, room;
    struct workspace workspace;
    struct crossings *crossings;
    long accepted;
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct command *o = (struct command *)state->input;
    switch (key) {
    case FROM:
        o->from = option_integer(state, "--from", text, 0, REAL_BITS);
        return 0;
    case TO:
        o->to = option_integer(state, "--to", text, 1, REAL_BITS);
        return 0;
    case EVERY:
        o->every = option_integer(state, "--every", text, 1, REAL_BITS);
        return 0;
    case MAX_STEPS:
        o->max_steps = option_integer(state, "--max-steps", text, 1, 1000000000);
        return 0;
    case ROOM:
        o->room = option_integer(state, "--room", text, 4, 10000000);
        return 0;
    case ARGP_KEY_END:
        if (o->from > o->to)
            argp_error(state, "--from %d is beyond --to %d", o->from, o->to);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void watch(void *log, enum event e, const struct cell *c)
{
    (void)c;
    ((struct command *)log)->accepted += e == ACCEPTED;
}

static void report_point(const struct command *o, const struct test_case *c, const struct intersector *a,
                         int bits, enum outcome outcome)
{
    long boxes = o->accepted ? o->accepted : o->crossings->count;
    if (o->measuring.rows)
        row_write(stdout, json_pack("{s:s, s:s, s:s, s:i, s:i, s:I, s:s}", "id", c->id, "algorithm", a->name,
                                    "precision", REAL_NAME, "log2_eps", -bits, "steps", o->workspace.steps,
                                    "boxes", (json_int_t)boxes, "outcome", outcome_name(outcome)));
    else
        printf("%-24s %-22s %8d %10d %10ld  %s\n", c->id, a->name, -bits, o->workspace.steps, boxes,
               outcome_name(outcome));
}

static void report_law(const struct command *o, const struct test_case *c, const struct intersector *a,
                       const struct cost_law *law, int from, int to)
{
    if (o->measuring.rows) {
        row_write(stdout, json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:i, s:i, s:i}",
                                    "id", c->id, "algorithm", a->name, "precision", REAL_NAME, "law",
                                    cost_model_name(law->model), "exponent", json_number_or_null(law->p),
                                    "lo", json_number_or_null(law->lo), "hi", json_number_or_null(law->hi),
                                    "c", json_number_or_null(law->c), "b", json_number_or_null(law->b),
                                    "rms_logarithmic", json_number_or_null(law->rms_logarithmic), "rms_power",
                                    json_number_or_null(law->rms_power), "points", law->points,
                                    "log2_eps_from", -from, "log2_eps_to", -to));
        return;
    }
    if (law->model == POWER)
        printf("%-24s %-22s %.3g eps^-%.3f (%.3f to %.3f) from 2^-%d to 2^-%d\n", c->id, a->name, law->c,
               law->p, law->lo, law->hi, from, to);
    else if (law->model == LOGARITHMIC)
        printf("%-24s %-22s %.3g + %.3g log2(1/eps) from 2^-%d to 2^-%d\n", c->id, a->name, law->c, law->b,
               from, to);
    else
        printf("%-24s %-22s too few tolerances\n", c->id, a->name);
}

/* Whole, if all that was accepted is as narrow as asked: records may have been merged for want of room. */
static bool is_whole(const struct command *o, enum outcome outcome)
{
    return outcome == SOLVED || (outcome == OUT_OF_ROOM && o->crossings->merged && o->workspace.used == 0);
}

static void climb(struct command *o, const struct test_case *c, struct problem *p,
                  const struct intersector *a)
{
    double bits[POINTS_MAX], steps[POINTS_MAX];
    int n = 0, last = o->from;
    for (int b = o->from; b <= o->to && n < POINTS_MAX && !interrupted; b += o->every) {
        p->tolerance = real_ldexp(1, -b);
        o->accepted = 0;
        enum outcome outcome = problem_solve(p, a, &o->workspace, o->crossings);
        report_point(o, c, a, b, outcome);
        if (!is_whole(o, outcome) || o->workspace.steps == 0)
            break;
        bits[n] = last = b;
        steps[n++] = o->workspace.steps;
    }
    struct cost_law law = cost_law_fit(n, bits, steps);
    report_law(o, c, a, &law, o->from, last);
    fflush(stdout);
}

static bool measure(void *data, struct test_case *c)
{
    struct command *o = (struct command *)data;
    struct owned_problem owned;
    if (!measuring_problem(c, (real)1, o->max_steps, &owned))
        return false;
    for (int i = 0; i < o->measuring.algorithms.count && !interrupted; i++)
        climb(o, c, &owned.problem, o->measuring.algorithms.at[i]);
    owned_problem_clear(&owned);
    return true;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp own = {options, parse, 0, 0, 0, 0, 0};
    static struct command o;
    o.from = 4;
    o.to = REAL_BITS < 300 ? REAL_BITS / 3 : 100;
    o.every = 2;
    o.max_steps = 1000000;
    o.room = 8 * WORKSPACE_ROOM;
    measuring_read(argc, argv, &own, documentation, &o.measuring);
    workspace_make(&o.workspace, o.measuring.algorithms.at, DEGREE_MAX, DEGREE_MAX, o.room);
    o.crossings = (struct crossings *)malloc(sizeof *o.crossings);
    if (!o.crossings)
        return 2;
    o.workspace.watch = watch;
    o.workspace.log = &o;
    int status = measuring_run(&o.measuring, argc, argv, measure, &o);
    workspace_clear(&o.workspace);
    free(o.crossings);
    measuring_clear(&o.measuring);
    return status;
}
