/* fatline order: the order of convergence of each algorithm at each solution. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "convergence/measuring.h"
#include "convergence/order_measure.h"
#include "cases/json_text.h"
#include "cases/problem.h"
#include "run/interrupt.h"
#include "run/options.h"
#include "run/progress.h"
#include "run/row.h"
#include "run/standard_output.h"

const char *argp_program_version = "fatline 0.1";

enum { OK = 0, BAD_DATA = 65 };
enum { PROTOCOL = 256, BITS, SOLUTION, SECONDS };

static const struct argp_option options[] = {
    {"protocol", PROTOCOL, "NAME", 0, "`rounds`, `boxes` or `both` (the default)", 0},
    {"bits", BITS, "N", 0, "rounds: solve to a width of 2^-N (as far as the precision goes)", 0},
    {"solution", SOLUTION, "I", 0, "only the solution number I of each case, from 0 (all)", 0},
    {"seconds", SECONDS, "S", 0, "give up after S seconds of computing a case's solutions exactly (60)", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Measure the order of convergence of algorithms on the case lines of FILEs (- or none: standard input), "
    "at each "
    "solution. A case may be any; where its line does not give the solutions as exact fractions, they are "
    "computed "
    "in exact arithmetic first, to as many digits as the precision has.\v"
    "A round is a cut of one curve and then one of the other, or one cut of both. The order is given per "
    "round "
    "only: the recurrence x' = C x^(k+1) + D y^2 lets the ratio of successive clips run through a cycle that "
    "depends on the start (for k = 1 anything from 1 to 2), so that per clip there is no limit, only a "
    "geometric "
    "mean, which is what the table calls by that name.\n\n"
    "Protocol `rounds` follows the cells that hold the solution through one solve and takes (L3 - L2)/(L2 - "
    "L1) of "
    "the logarithms of the widths after the last three rounds above the rounding floor. It needs hundreds of "
    "bits: "
    "use `--precision multi`. Protocol `boxes` makes one round from each of 16 boxes x by y = x^lambda "
    "around the "
    "solution, to which the curves are restricted exactly, and takes the slope; that works in double too, "
    "and where "
    "convergence is so fast that there are few rounds. lambda is the shape that a round leaves behind.\n\n"
    "law: superlinear; linear; stalled: the widths hardly shrink, or (boxes) the algorithm halves instead of "
    "clipping; exact: one round leaves only rounding; too_few: not enough rounds above rounding to tell. At "
    "a "
    "solution of multiplicity mu rounding is taken to begin at the mu-th root of that of a crossing.\n\n"
    "Exit status: 0, 2 on an input or output error, 64 on wrong usage, 65 on bad data, no case or a case "
    "without "
    "known solutions, 130 when interrupted.";

struct command {
    struct measuring measuring;
    bool rounds, boxes;
    int bits, solution; /* bits 0: not given */
    double seconds;
    bool measured;
    struct order_bench bench;
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct command *o = (struct command *)state->input;
    switch (key) {
    case PROTOCOL:
        o->rounds = strcmp(text, "boxes") != 0;
        o->boxes = strcmp(text, "rounds") != 0;
        if (o->rounds && o->boxes && strcmp(text, "both"))
            argp_error(state, "--protocol: '%s', expected rounds, boxes or both", text);
        return 0;
    case BITS:
        o->bits = option_integer(state, "--bits", text, 1, REAL_BITS);
        return 0;
    case SOLUTION:
        o->solution = option_integer(state, "--solution", text, 0, 1000000);
        return 0;
    case SECONDS:
        o->seconds = option_integer(state, "--seconds", text, 1, 1000000);
        return 0;
    case ARGP_KEY_END:
        option_needs(state, o->bits > 0, "--bits", o->rounds, "--protocol rounds or both");
        o->bits = o->bits > 0 ? o->bits : REAL_BITS;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void write_row(const struct test_case *c, int solution, int multiplicity, const struct intersector *a,
                      const char *protocol, const struct order_estimate *e)
{
    row_write(stdout, json_pack("{s:s, s:i, s:o, s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:i, s:o, s:o}", "id",
                                c->id, "solution", solution, "multiplicity",
                                multiplicity > 0 ? json_integer(multiplicity) : json_null(), "algorithm",
                                a->name, "precision", REAL_NAME, "protocol", protocol, "law",
                                law_name(e->law), "per_round", json_number_or_null(e->per_round), "lo",
                                json_number_or_null(e->lo), "hi", json_number_or_null(e->hi), "points",
                                e->points, "clips", e->clips > 0 ? json_integer(e->clips) : json_null(),
                                "bits_per_round", json_number_or_null(e->bits_per_round)));
}

static void write_line(const struct test_case *c, int solution, const struct intersector *a,
                       const char *protocol, const struct order_estimate *e)
{
    static bool begun;
    if (!begun)
        printf("%-24s %3s %-22s %-8s %-12s %10s %19s %9s %7s %10s\n", "case", "sol", "algorithm", "protocol",
               "law", "per round", "interval", "per clip", "points", "bits/round");
    begun = true;
    printf("%-24s %3d %-22s %-8s %-12s", c->id, solution, a->name, protocol, law_name(e->law));
    if (isfinite(e->per_round))
        printf(" %10.4f %9.4f-%-9.4f", e->per_round, e->lo, e->hi);
    else
        printf(" %10s %19s", "-", "-");
    if (e->law == SUPERLINEAR && e->clips > 0)
        printf(" %9.4f", pow(e->per_round, 1.0 / e->clips));
    else
        printf(" %9s", "-");
    printf(" %7d", e->points);
    if (isfinite(e->bits_per_round))
        printf(" %10.3f\n", e->bits_per_round);
    else
        printf(" %10s\n", "-");
}

static void report(const struct command *o, const struct test_case *c, int solution, int multiplicity,
                   const struct intersector *a, const char *protocol, const struct order_estimate *e)
{
    if (o->measuring.rows)
        write_row(c, solution, multiplicity, a, protocol, e);
    else
        write_line(c, solution, a, protocol, e);
    fflush(stdout);
}

static void measure_solution(struct command *o, const struct test_case *c, const struct problem *p,
                             const struct known_solutions *known, int solution)
{
    const struct known_solution *z = &known->at[solution];
    for (int i = 0; i < o->measuring.algorithms.count && !interrupted; i++) {
        const struct intersector *a = o->measuring.algorithms.at[i];
        if (o->rounds) {
            struct order_estimate e = order_by_rounds(&o->bench, p, a, z, o->bits);
            report(o, c, solution, z->multiplicity, a, "rounds", &e);
        }
        if (o->boxes) {
            struct order_estimate e = order_by_boxes(&o->bench, c, a, z);
            report(o, c, solution, z->multiplicity, a, "boxes", &e);
        }
    }
}

static bool measure(void *data, struct test_case *c)
{
    struct command *o = (struct command *)data;
    struct known_solutions known;
    struct owned_problem owned;
    /* For boxes, those of a box and of what a round leaves of it. */
    const int digits = (int)((o->boxes ? 2 * REAL_BITS : o->bits) * 0.30103) + 20;
    if (!measuring_problem(c, (real)1 / 1024, 1000000, &owned))
        return false;
    if (!measuring_solutions(c, digits, o->seconds, &known)) {
        owned_problem_clear(&owned);
        return false;
    }
    if (o->solution >= known.count)
        progress_note("%s: no solution %d, there are %d", c->id, o->solution, known.count);
    else if (known.count == 0)
        progress_note("%s: no isolated solution", c->id);
    for (int i = 0; i < known.count && !interrupted; i++)
        if (o->solution < 0 || o->solution == i) {
            measure_solution(o, c, &owned.problem, &known, i);
            o->measured = true;
        }
    known_solutions_clear(&known);
    owned_problem_clear(&owned);
    return true;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp own = {options, parse, 0, 0, 0, 0, 0};
    struct command o;
    memset((void *)&o, 0, sizeof o);
    o.rounds = o.boxes = true;
    o.solution = -1;
    o.seconds = 60;
    measuring_read(argc, argv, &own, documentation, &o.measuring);
    order_bench_make(&o.bench, o.measuring.algorithms.at, DEGREE_MAX);
    int status = measuring_run(&o.measuring, argc, argv, measure, &o);
    if (status == OK && o.solution >= 0 && !o.measured)
        status = BAD_DATA;
    order_bench_clear(&o.bench);
    measuring_clear(&o.measuring);
    return status;
}
