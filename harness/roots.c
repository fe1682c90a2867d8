/* fatline roots: what the root finders of one variable need for an accuracy, and their order of convergence.
 */
#include <argp.h>
#include <jansson.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../algorithms/core/roots.h"
#include "cases/json_text.h"
#include "families/planted_roots.h"
#include "run/row.h"
#include "run/standard_output.h"
#include "timing/statistics.h"

enum { ROOM = PLANTED_DEGREE_MAX + 1, WIDTHS_MAX = 4096, ACCURACIES_MAX = 64, DEGREES_MAX = 8, DEFAULTS = 8 };

struct request {
    bool rows;
    const char *finder;
    int degrees, degree[DEGREES_MAX];
    int accuracies, accuracy[ACCURACIES_MAX]; /* -log2 of the widths asked for */
    int gap;
};

/* One polynomial. */
struct question {
    enum planted_kind kind;
    int n;
    real c[PLANTED_DEGREE_MAX + 1], error[PLANTED_DEGREE_MAX + 1];
};

/* log2 of the widths of the intervals that held the root. */
struct trail {
    real root;
    int count;
    double width[WIDTHS_MAX];
};

static real scratch[16384];

static double log2_of(real a)
{
    if (!(a > 0))
        return -INFINITY;
    int e = real_exponent(a);
    return e + log2(real_to_double(real_ldexp(a, -e)));
}

static void follow(void *log, real lo, real hi)
{
    struct trail *t = (struct trail *)log;
    if (lo <= t->root && t->root <= hi && t->count < WIDTHS_MAX)
        t->width[t->count++] = log2_of(hi - lo);
}

/* ---- order ---- */

/* Orders from successive widths, (L3 - L2) / (L2 - L1): L1 below -3 bits; L3 a quarter above where rounding
 * ends. */
static int estimate_orders(const struct trail *t, int multiplicity, double *order)
{
    int count = 0;
    double floor = -0.75 * (REAL_BITS - 8) / multiplicity;
    for (int i = 2; i < t->count; i++) {
        const double *w = &t->width[i - 2];
        if (w[0] <= -3 && w[2] >= floor && w[1] < w[0])
            order[count++] = (w[2] - w[1]) / (w[1] - w[0]);
    }
    return count;
}

/* The last ratios are nearest the limit: the later half of them, or all of up to three. */
static json_t *order_row(const struct root_finder *f, const struct question *q)
{
    static struct trail trail;
    static double order[WIDTHS_MAX];
    struct root out[ROOM];
    struct root_search search = {0, follow, &trail};
    trail.root = (real)1 / 3;
    trail.count = 0;
    f->find(q->n, q->c, q->error, real_ldexp(1, -REAL_BITS + 8), scratch, ROOM, out, &search);
    int count = q->kind == CLOSE_ROOTS ? 0 : estimate_orders(&trail, planted_kind_roots(q->kind), order);
    int used = count < 4 ? count : (count + 1) / 2;
    double lo = NAN, hi = NAN, middle = used >= 2 ? statistics_median(used, order + count - used) : NAN;
    for (int i = count - used; i < count && used >= 2; i++) {
        lo = fmin(lo, order[i]); /* fmin passes over NAN */
        hi = fmax(hi, order[i]);
    }
    return json_pack("{s:s, s:s, s:i, s:s, s:s, s:s, s:o, s:o, s:o, s:i}", "finder", f->name, "roots",
                     planted_kind_name(q->kind), "degree", q->n, "precision", REAL_NAME, "row", "order",
                     "law",
                     used < 2        ? "too_few"
                     : middle > 1.05 ? "superlinear"
                                     : "linear",
                     "per_clip", json_number_or_null(middle), "lo", json_number_or_null(lo), "hi",
                     json_number_or_null(hi), "points", used);
}

/* ---- cost ---- */

static json_t *cost_row(const struct root_finder *f, const struct question *q, int accuracy)
{
    struct root out[ROOM];
    struct root_search search = {0, NULL, NULL};
    int count = f->find(q->n, q->c, q->error, real_ldexp(1, -accuracy), scratch, ROOM, out, &search);
    real widest = 0;
    for (int i = 0; i < count; i++)
        widest = real_max(widest, out[i].hi - out[i].lo);
    return json_pack("{s:s, s:s, s:i, s:s, s:s, s:i, s:i, s:i, s:o}", "finder", f->name, "roots",
                     planted_kind_name(q->kind), "degree", q->n, "precision", REAL_NAME, "row", "cost",
                     "log2_eps", -accuracy, "clips", search.clips, "enclosures", count, "log2_widest",
                     json_number_or_null(log2_of(widest)));
}

/* ---- the table ---- */

static void print_header(const struct request *r)
{
    printf("%-7s %6s %-10s %7s %8s  clips for enclosures of width 2^-a, a =\n%40s  ", "roots", "degree",
           "finder", "order", "", "");
    for (int i = 0; i < r->accuracies; i++)
        printf(" %5d", r->accuracy[i]);
    putchar('\n');
}

static void print_line(const struct root_finder *f, const struct question *q, const struct request *r)
{
    json_t *order = order_row(f, q), *per_clip = json_object_get(order, "per_clip");
    char text[32] = "-";
    if (json_is_real(per_clip))
        snprintf(text, sizeof text, "%.3f", json_real_value(per_clip));
    printf("%-7s %6d %-10s %7s %8s  ", planted_kind_name(q->kind), q->n, f->name, text,
           q->kind == CLOSE_ROOTS ? "" : json_string_value(json_object_get(order, "law")));
    json_decref(order);
    for (int i = 0; i < r->accuracies; i++) {
        json_t *row = cost_row(f, q, r->accuracy[i]), *width = json_object_get(row, "log2_widest");
        bool reached = !json_is_real(width) || json_real_value(width) <= -r->accuracy[i];
        if (reached)
            printf(" %5d", (int)json_integer_value(json_object_get(row, "clips")));
        else
            printf(" %5s", "-");
        json_decref(row);
    }
    putchar('\n');
}

static void measure(const struct request *r, const struct question *q)
{
    for (int k = 0; root_finders[k]; k++) {
        const struct root_finder *f = root_finders[k];
        if (r->finder && strcmp(r->finder, f->name))
            continue;
        if (!r->rows) {
            print_line(f, q, r);
            continue;
        }
        row_write(stdout, order_row(f, q));
        for (int i = 0; i < r->accuracies; i++)
            row_write(stdout, cost_row(f, q, r->accuracy[i]));
    }
}

/* ---- options ---- */

/* Positive numbers up to `most`, separated by commas; 0 if the text is not that. */
static int read_list(const char *text, int room, int most, int *out)
{
    int count = 0;
    for (char *end; count < room; text = end + 1) {
        long a = strtol(text, &end, 10);
        if (end == text || a < 1 || a > most)
            return 0;
        out[count++] = (int)a;
        if (!*end)
            return count;
        if (*end != ',')
            return 0;
    }
    return 0;
}

static bool is_finder(const char *name)
{
    for (int k = 0; root_finders[k]; k++)
        if (!strcmp(root_finders[k]->name, name))
            return true;
    return false;
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct request *r = (struct request *)state->input;
    switch (key) {
    case 'r':
        r->rows = true;
        return 0;
    case 'f':
        if (!is_finder(text))
            argp_error(state, "--finder: no '%s'; expected hull, quadratic or cubic", text);
        r->finder = text;
        return 0;
    case 'd':
        r->degrees = read_list(text, DEGREES_MAX, PLANTED_DEGREE_MAX, r->degree);
        if (!r->degrees)
            argp_error(state, "--degree: '%s' is no list of up to %d numbers from 1 to %d", text, DEGREES_MAX,
                       PLANTED_DEGREE_MAX);
        return 0;
    case 'a':
        r->accuracies = read_list(text, ACCURACIES_MAX, REAL_BITS, r->accuracy);
        if (!r->accuracies)
            argp_error(state, "--accuracy: '%s' is no list of up to %d numbers from 1 to %d", text,
                       ACCURACIES_MAX, REAL_BITS);
        return 0;
    case 'g':
        if (read_list(text, 1, REAL_BITS / 2, &r->gap) != 1)
            argp_error(state, "--gap: '%s' is no number from 1 to %d", text, REAL_BITS / 2);
        return 0;
    case ARGP_KEY_ARG:
        argp_error(state, "no arguments are expected, but there is '%s'", text);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_option options[] = {
    {"finder", 'f', "NAME", 0, "hull, quadratic or cubic (all)", 0},
    {"degree", 'd', "N,...", 0, "degrees, up to 32 (2,4,8,16)", 0},
    {"accuracy", 'a', "A,...", 0,
     "widths 2^-A to ask for (7,14,28,50,100,250,500,1000, as far as the precision goes)", 0},
    {"gap", 'g', "J", 0, "close roots are 2^-J apart (20)", 0},
    {"rows", 'r', 0, 0, "a line of JSON for each measurement instead of a table", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Find the roots in [0, 1] of polynomials with a simple, double or triple root 1/3, or 1/3 and a close "
    "one, by each "
    "finder, and count clips: the cost of an accuracy, and the order of convergence per clip where three or "
    "more "
    "widths lie between 1/8 and rounding."
    "\vA dash: that width is beyond what the errors of the coefficients allow. The order is the median of "
    "(L3 - L2) / (L2 - L1), L = log2 of successive widths around the root, over the later half of them (all "
    "of up to three).";

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp argp = {options, parse, "", documentation, 0, 0, 0};
    struct request r = {false, NULL, 4, {2, 4, 8, 16}, 0, {7, 14, 28, 50, 100, 250, 500, 1000}, 20};
    argp_parse(&argp, argc, argv, 0, NULL, &r);
    if (!r.accuracies)
        while (r.accuracies < DEFAULTS && r.accuracy[r.accuracies] < REAL_BITS)
            r.accuracies++;
    if (r.rows)
        row_write(stdout, row_environment(argc, argv, REAL_NAME));
    else
        print_header(&r);
    for (int kind = 0; kind < PLANTED_KINDS; kind++)
        for (int i = 0; i < r.degrees; i++) {
            struct question q;
            q.kind = (enum planted_kind)kind;
            q.n = r.degree[i];
            if (q.n < planted_kind_roots(q.kind))
                continue;
            planted_roots_make(q.kind, q.n, r.gap, q.c, q.error);
            measure(&r, &q);
        }
    return 0;
}
