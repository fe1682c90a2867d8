/* fatline lemma: the statements of the first paper's section 3, with their exponents and constants. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../algorithms/core/reduce.h"
#include "convergence/lemma_measure.h"
#include "convergence/measuring.h"
#include "cases/json_text.h"
#include "cases/problem.h"
#include "run/interrupt.h"
#include "run/options.h"
#include "run/row.h"
#include "run/standard_output.h"

const char *argp_program_version = "fatline 0.1";

enum { SECONDS = 256 };

static const struct argp_option options[] = {
    {"seconds", SECONDS, "S", 0, "give up after S seconds of computing a case's solutions exactly (60)", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] = "Measure the exponents and constants of the lemmas behind hybrid "
                                    "clipping on the case lines of FILEs (- or none: "
                                    "standard input), at each simple solution, for f and for g.\v"
                                    "3.2: the distance of a curve from its best approximation of degree k, k "
                                    "= 1, 2, 3, on an interval of length h, in "
                                    "the control-point norm; 3.3: that of the j-th derivatives; polynomial "
                                    "curves only. own, other: one cut of a curve "
                                    "by each algorithm, C_f x^(k+1) from boxes with y = x^6 and C_g y^2 from "
                                    "boxes with x = y^1.6; k is what the exponent "
                                    "says, and the constants expected are those for delta as a length "
                                    "(scalar: for the range of its component across the fat line). "
                                    "bound: least and largest part of C_f x^(k+1) + C_g y^2 that is used, "
                                    "over boxes of eight shapes. printed: order "
                                    "of the sweep that cuts both curves from the same boxes, as inequality "
                                    "(4) is printed; corrected: of the one that "
                                    "cuts g against the box that f was just left.\n\n"
                                    "Exit status: 0, 2 on an input or output error, 64 on wrong usage, 65 on "
                                    "bad data, no case or a case without known "
                                    "solutions, 130 when interrupted.";

struct command {
    struct measuring measuring;
    double seconds;
    struct order_bench bench;
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct command *o = (struct command *)state->input;
    switch (key) {
    case SECONDS:
        o->seconds = option_integer(state, "--seconds", text, 1, 1000000);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* What a row is about. */
struct subject {
    const char *id, *algorithm, *statement, *curve; /* algorithm: NULL for the lemmas */
    int solution, k, j;                             /* j < 0: none */
};

struct figure {
    double exponent, lo, hi, constant, expected_exponent, expected_constant, scalar_constant;
    int points;
};

/* "-" where there is no number. */
static void print_cell(const char *format, int width, double a)
{
    if (isfinite(a))
        printf(format, width, a);
    else
        printf("%*s", width, "-");
}

static void print_figure(const struct subject *s, const struct figure *v)
{
    static bool begun;
    if (!begun)
        printf("%-18s %-22s %-9s %5s %2s %2s %9s %9s %13s %13s %13s\n", "case", "algorithm", "statement",
               "curve", "k", "j", "exponent", "expected", "constant", "expected", "scalar");
    begun = true;
    printf("%-18s %-22s %-9s %5s %2d ", s->id, s->algorithm ? s->algorithm : "-", s->statement, s->curve,
           s->k);
    printf(s->j < 0 ? " - " : "%2d ", s->j);
    print_cell("%*.4f", 9, v->exponent);
    print_cell("%*.4g", 10, v->expected_exponent);
    print_cell("%*.6g", 14, v->constant);
    print_cell("%*.6g", 14, v->expected_constant);
    print_cell("%*.6g", 14, v->scalar_constant);
    putchar('\n');
}

static void print_bound(const struct subject *s, const struct sharpness *used)
{
    printf("%-18s %-22s %-9s %5s %2d  -  ", s->id, s->algorithm, s->statement, s->curve, s->k);
    if (isfinite(used->least) && isfinite(used->most))
        printf("between %.4f and %.4f of C_f x^(k+1) + C_g y^2, %d boxes\n", used->least, used->most,
               used->points);
    else
        printf("-\n");
}

static void write_figure(const struct command *o, const struct subject *s, const struct figure *v)
{
    if (o->measuring.rows) {
        json_t *row = json_pack(
            "{s:s, s:i, s:s?, s:s, s:s, s:s, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:i}", "id", s->id,
            "solution", s->solution, "algorithm", s->algorithm, "precision", REAL_NAME, "statement",
            s->statement, "curve", s->curve, "k", s->k, "j", s->j < 0 ? json_null() : json_integer(s->j),
            "exponent", json_number_or_null(v->exponent), "lo", json_number_or_null(v->lo), "hi",
            json_number_or_null(v->hi), "constant", json_number_or_null(v->constant), "expected_exponent",
            json_number_or_null(v->expected_exponent), "expected_constant",
            json_number_or_null(v->expected_constant), "scalar_constant",
            json_number_or_null(v->scalar_constant), "points", v->points);
        row_write(stdout, row);
    } else {
        print_figure(s, v);
    }
}

static void measure_reduction(const struct command *o, const struct test_case *c,
                              const struct known_solution *z, int solution, bool of_g)
{
    int n = (of_g ? &c->g : &c->f)->degree;
    for (int k = 1; k <= 3 && k < n; k++)
        for (int j = -1; j <= k && !interrupted; j++) {
            struct subject s = {c->id, NULL, j < 0 ? "3.2" : "3.3", of_g ? "g" : "f", solution, k, j};
            struct power_law l = reduction_law(c, z, of_g, k, j);
            struct figure v = {l.exponent,
                               l.lo,
                               l.hi,
                               l.constant,
                               k + 1.0 - (j > 0 ? j : 0),
                               reduction_constant(c, z, of_g, k, j),
                               NAN,
                               l.points};
            write_figure(o, &s, &v);
        }
}

/* The degree of approximation that the exponent shows; the degree of the curve if there is no term of its
 * own. */
static int degree_shown(const struct power_law *own, int n)
{
    if (!isfinite(own->exponent))
        return n;
    int k = (int)nearbyint(own->exponent) - 1;
    return k < 1 ? 1 : k > REDUCED_MAX ? REDUCED_MAX : k;
}

static void measure_cut(struct command *o, const struct test_case *c, const struct intersector *a,
                        const struct known_solution *z, int solution, bool of_g)
{
    struct power_law own = cut_law(&o->bench, c, a, z, of_g, true),
                     other = cut_law(&o->bench, c, a, z, of_g, false);
    int k = degree_shown(&own, (of_g ? &c->g : &c->f)->degree);
    struct cut_constants expected = cut_constants(c, z, of_g, k < REDUCED_MAX ? k : REDUCED_MAX);
    struct subject s = {c->id, a->name, "own", of_g ? "g" : "f", solution, k, -1};
    struct figure v = {own.exponent,        own.lo,    own.hi, own.constant, k + 1.0, expected.own_vector,
                       expected.own_scalar, own.points};
    write_figure(o, &s, &v);
    s.statement = "other";
    struct figure w = {other.exponent, other.lo, other.hi,    other.constant, 2,
                       expected.other, NAN,      other.points};
    write_figure(o, &s, &w);
    struct sharpness used = cut_sharpness(&o->bench, c, a, z, of_g, k,
                                          isfinite(own.exponent) ? expected.own_vector : 0, expected.other);
    s.statement = "bound";
    struct figure u = {NAN, used.least, used.most, NAN, NAN, NAN, NAN, used.points};
    if (!o->measuring.rows)
        print_bound(&s, &used);
    else
        write_figure(o, &s, &u);
}

static void measure_sweeps(struct command *o, const struct test_case *c, const struct intersector *a,
                           const struct known_solution *z, int solution)
{
    struct order_estimate e[2] = {jacobi_order(&o->bench, c, a, z), order_by_boxes(&o->bench, c, a, z)};
    for (int i = 0; i < 2; i++) {
        struct subject s = {c->id, a->name, i ? "corrected" : "printed", "both", solution, 0, -1};
        struct figure v = {e[i].per_round, e[i].lo, e[i].hi, NAN, i ? NAN : 2, NAN, NAN, e[i].points};
        write_figure(o, &s, &v);
    }
}

static void measure_solution(struct command *o, const struct test_case *c, const struct known_solution *z,
                             int solution)
{
    for (int of_g = 0; of_g < 2; of_g++)
        if (!(of_g ? &c->g : &c->f)->rational)
            measure_reduction(o, c, z, solution, of_g);
    for (int i = 0; i < o->measuring.algorithms.count && !interrupted; i++) {
        for (int of_g = 0; of_g < 2; of_g++)
            measure_cut(o, c, o->measuring.algorithms.at[i], z, solution, of_g);
        measure_sweeps(o, c, o->measuring.algorithms.at[i], z, solution);
        fflush(stdout);
    }
}

static bool measure(void *data, struct test_case *c)
{
    struct command *o = (struct command *)data;
    struct known_solutions known;
    if (!measuring_solutions(c, (int)(2 * REAL_BITS * 0.30103) + 10, o->seconds, &known))
        return false;
    for (int i = 0; i < known.count && !interrupted; i++)
        if (known.at[i].multiplicity == 1)
            measure_solution(o, c, &known.at[i], i);
    known_solutions_clear(&known);
    return true;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp own = {options, parse, 0, 0, 0, 0, 0};
    static struct command o;
    o.seconds = 60;
    measuring_read(argc, argv, &own, documentation, &o.measuring);
    order_bench_make(&o.bench, o.measuring.algorithms.at, DEGREE_MAX);
    int status = measuring_run(&o.measuring, argc, argv, measure, &o);
    order_bench_clear(&o.bench);
    measuring_clear(&o.measuring);
    return status;
}
