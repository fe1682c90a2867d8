/* fatline trace: one row for every step of a solve. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases/case.h"
#include "convergence/measuring.h"
#include "cases/number.h"
#include "convergence/path.h"
#include "cases/problem.h"
#include "run/interrupt.h"
#include "run/options.h"
#include "run/progress.h"
#include "run/row.h"
#include "run/standard_output.h"

const char *argp_program_version = "fatline 0.1";

enum { BITS = 256, MAX_STEPS, ROOM };

static const struct argp_option options[] = {
    {"bits", BITS, "N", 0, "width asked for in both parameters: 2^-N (40)", 0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 0},
    {"room", ROOM, "N", 0, "cells that may wait at once (512)", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Watch algorithms at work on the case lines of FILEs (- or none: standard input): one row for every step "
    "of each "
    "solve.\v"
    "step: number of the row in its solve. call: cells taken from the stack so far, what `solve` counts as "
    "steps; a "
    "four-way split makes four of them. clip, round: clips that led to this cell, and rounds: a round is "
    "over when both "
    "parameters have been narrowed. event: shrunk (the widths are those after it), split (before it), "
    "discarded, "
    "accepted. log2_t, log2_s: of the widths in f's and g's parameter. depth: splits that led here.\n\n"
    "Algorithms that do not work on cells (see core/cells.h) make no steps that could be watched, and no "
    "rows.\n\n"
    "Exit status: 0, 2 on an input or output error, 64 on wrong usage, 65 on bad data or no case, 130 when "
    "interrupted.";

/* What led to a waiting cell. */
struct lineage {
    int clips, rounds;
    double bits_t, bits_s; /* when its last round ended */
};

struct command {
    struct measuring measuring;
    int bits, max_steps, room;
    struct workspace workspace;
    struct crossings *crossings;
    /* of the solve being watched */
    const char *id;
    const struct intersector *algorithm;
    struct lineage *lineage, parent; /* one a cell of the workspace; that of the cell being divided */
    int step, call;
    bool begun;
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct command *o = (struct command *)state->input;
    switch (key) {
    case BITS:
        o->bits = option_integer(state, "--bits", text, 1, REAL_BITS);
        return 0;
    case MAX_STEPS:
        o->max_steps = option_integer(state, "--max-steps", text, 1, 1000000000);
        return 0;
    case ROOM:
        o->room = option_integer(state, "--room", text, 4, 10000000);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static json_t *log2_of(double bits)
{
    return isfinite(bits) ? json_real(bits == 0 ? 0 : -bits) : json_null();
}

static void write_step(const struct command *o, enum event e, const struct lineage *l, double bits_t,
                       double bits_s, int depth)
{
    static const char *const names[] = {"shrunk", "split", "discarded", "accepted"};
    if (o->measuring.rows) {
        row_write(stdout, json_pack("{s:s, s:s, s:s, s:i, s:i, s:i, s:i, s:s, s:o, s:o, s:i}", "id", o->id,
                                    "algorithm", o->algorithm->name, "precision", REAL_NAME, "step", o->step,
                                    "call", o->call, "clip", l->clips, "round", l->rounds, "event", names[e],
                                    "log2_t", log2_of(bits_t), "log2_s", log2_of(bits_s), "depth", depth));
        return;
    }
    if (o->step == 1)
        printf("%s, %s\n%6s %6s %5s %5s %-10s %12s %12s %6s\n", o->id, o->algorithm->name, "step", "call",
               "clip", "round", "event", "log2 t", "log2 s", "depth");
    printf("%6d %6d %5d %5d %-10s %12.3f %12.3f %6d\n", o->step, o->call, l->clips, l->rounds, names[e],
           -bits_t, -bits_s, depth);
}

/* The pieces of a cell come one after the other in one call; the first stands where the cell stood. */
static void watch(void *log, enum event e, const struct cell *c)
{
    enum { CHILDREN = 4 };
    struct command *o = (struct command *)log;
    const struct workspace *w = &o->workspace;
    int slot = (int)(c - w->cell);
    bool swapped = w->swapped;
    const struct interval *t = swapped ? &c->s : &c->t, *s = swapped ? &c->t : &c->s;
    double bits_t = real_bits(t->hi - t->lo), bits_s = real_bits(s->hi - s->lo);
    if (!o->begun || w->steps != o->call)
        o->parent = o->lineage[slot];
    o->begun = true;
    o->call = w->steps;
    o->step++;
    struct lineage *l = &o->lineage[slot];
    if (e == SHRUNK) {
        *l = o->parent;
        l->clips++;
    }
    if ((e == SHRUNK || e == SPLIT) && bits_t > l->bits_t && bits_s > l->bits_s) {
        l->rounds++;
        l->bits_t = bits_t;
        l->bits_s = bits_s;
    }
    write_step(o, e, l, bits_t, bits_s, c->depth);
    for (int i = 1; e == SPLIT && i < CHILDREN && slot + i < o->room; i++)
        o->lineage[slot + i] = *l;
}

static bool measure(void *data, struct test_case *c)
{
    struct command *o = (struct command *)data;
    struct owned_problem owned;
    if (!measuring_problem(c, real_ldexp(1, -o->bits), o->max_steps, &owned))
        return false;
    for (int i = 0; i < o->measuring.algorithms.count && !interrupted; i++) {
        o->id = c->id;
        o->algorithm = o->measuring.algorithms.at[i];
        o->step = o->call = 0;
        o->begun = false;
        memset((void *)o->lineage, 0, (size_t)o->room * sizeof *o->lineage);
        enum outcome outcome = problem_solve(&owned.problem, o->algorithm, &o->workspace, o->crossings);
        if (o->step == 0)
            progress_note("%s: %s: %s, no steps to be watched", c->id, o->algorithm->name,
                          outcome_name(outcome));
    }
    owned_problem_clear(&owned);
    return true;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp own = {options, parse, 0, 0, 0, 0, 0};
    static struct command o;
    o.bits = 40;
    o.max_steps = STEPS_MAX;
    o.room = WORKSPACE_ROOM;
    measuring_read(argc, argv, &own, documentation, &o.measuring);
    workspace_make(&o.workspace, o.measuring.algorithms.at, DEGREE_MAX, DEGREE_MAX, o.room);
    o.crossings = (struct crossings *)malloc(sizeof *o.crossings);
    o.lineage = (struct lineage *)malloc((size_t)o.room * sizeof *o.lineage);
    if (!o.crossings || !o.lineage)
        return 2;
    o.workspace.watch = watch;
    o.workspace.log = &o;
    int status = measuring_run(&o.measuring, argc, argv, measure, &o);
    workspace_clear(&o.workspace);
    free(o.crossings);
    free(o.lineage);
    measuring_clear(&o.measuring);
    return status;
}
