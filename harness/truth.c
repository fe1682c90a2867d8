/* fatline truth: the exact intersections of case lines. */
#include <argp.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <flint/flint.h>

#include "truth/exact.h"
#include "truth/exact_poly.h"
#include "cases/json_text.h"
#include "cases/selection.h"
#include "run/options.h"
#include "run/interrupt.h"
#include "run/progress.h"
#include "run/row.h"
#include "run/standard_output.h"
#include "truth/truth_compare.h"

const char *argp_program_version = "fatline 0.1";

enum { DIGITS_LEAST = 40, DIGITS_MOST = 1000 };
enum status { OK = 0, WRONG = 1, FAILED = 2, BAD_DATA = 65 };
enum { COMPARE = 256, DIGITS, SECONDS, TIMING, KEEP_GOING, WITHIN };

/* Seconds of the cases of one pair of degrees. */
struct group {
    int n, m, count;
    double *seconds;
    char worst_id[128];
};

struct arguments {
    struct selection cases;
    struct exact_limits limits;
    bool compare, timing, keep_going, quiet;
    double within; /* 0: not given */
};

struct run {
    const struct arguments *a;
    struct group *groups;
    int group_count;
    long taken; /* cases that were asked for */
    enum status worst;
};

static const struct argp_option options[] = {
    {"compare", COMPARE, 0, 0,
     "instead of writing lines, say where a line differs from the truth; exit status 1 if any does", 0},
    {"within", WITHIN, "X", 0, "how far parameters may differ in a comparison (1e-15)", 0},
    {"digits", DIGITS, "N", 0, "significant digits of irrational parameters, 40 to 1000 (40)", 0},
    {"seconds", SECONDS, "S", 0, "give a case up after S seconds of processor time (never)", 0},
    {"timing", TIMING, 0, 0, "instead of lines, rows of seconds by pair of degrees", 0},
    {"keep-going", KEEP_GOING, 0, 0, "pass over bad lines; the exit status is still 65", 0},
    {"quiet", 'q', 0, 0, "no progress", 0},
    {0}};

static const char documentation[] =
    "Find the intersections of the curves of case lines in FILEs (- or none: standard input) in exact "
    "arithmetic, "
    "and write each line back with `expected`, `class` and `flags` afresh.\v"
    "Parameters are proved: what `exact` says is the solution itself where it is a fraction, else right in "
    "all its "
    "digits; `params` are the nearest doubles.\n\n"
    "Exit status: 0, 1 if a comparison found a difference, 2 if a case has no answer (with its reason on "
    "standard "
    "error) or a file cannot be read, 64 on wrong usage, 65 on bad data or no case, 130 when interrupted.";

static void finish(struct arguments *a, struct argp_state *state)
{
    option_needs(state, a->within > 0, "--within", a->compare, "--compare");
    option_excludes(state, a->compare, "--compare", a->timing, "--timing");
    a->within = a->within > 0 ? a->within : 1e-15;
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->cases;
        return 0;
    case COMPARE:
        a->compare = true;
        return 0;
    case WITHIN:
        a->within = option_positive(state, "--within", argument);
        return 0;
    case DIGITS:
        a->limits.digits = option_integer(state, "--digits", argument, DIGITS_LEAST, DIGITS_MOST);
        return 0;
    case SECONDS:
        a->limits.seconds = option_positive(state, "--seconds", argument);
        return 0;
    case TIMING:
        a->timing = true;
        return 0;
    case KEEP_GOING:
        a->keep_going = true;
        return 0;
    case 'q':
        a->quiet = true;
        return 0;
    case ARGP_KEY_END:
        finish(a, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void spoil(struct run *r, enum status status)
{
    if (status > r->worst)
        r->worst = status;
}

static struct group *group_of(struct run *r, int n, int m)
{
    for (int i = 0; i < r->group_count; i++)
        if (r->groups[i].n == n && r->groups[i].m == m)
            return &r->groups[i];
    r->groups = realloc(r->groups, (size_t)(r->group_count + 1) * sizeof *r->groups);
    r->groups[r->group_count] = (struct group){.n = n, .m = m};
    return &r->groups[r->group_count++];
}

static void note_time(struct run *r, const struct test_case *c, double seconds)
{
    struct group *g = group_of(r, c->f.degree, c->g.degree);
    g->seconds = realloc(g->seconds, (size_t)(g->count + 1) * sizeof *g->seconds);
    bool worst = true;
    for (int i = 0; i < g->count; i++)
        worst = worst && g->seconds[i] < seconds;
    if (worst)
        snprintf(g->worst_id, sizeof g->worst_id, "%s", c->id);
    g->seconds[g->count++] = seconds;
}

static void solve_case(struct run *r, const struct test_case *said)
{
    struct test_case found;
    char error[512];
    char *line = json_dumps(said->line, 0);
    if (!line || case_parse(line, said->file, said->line_number, &found, error) != CASE_READ) {
        progress_note("%s:%d: %s: cannot be copied", said->file, said->line_number, said->id);
        spoil(r, FAILED);
        free(line);
        return;
    }
    free(line);
    double start = exact_clock();
    const char *trouble = exact_solve(&found, &r->a->limits);
    if (trouble) {
        progress_note("%s:%d: %s: no answer: %s", said->file, said->line_number, said->id, trouble);
        spoil(r, FAILED);
    } else if (r->a->timing) {
        note_time(r, &found, exact_clock() - start);
    } else if (r->a->compare) {
        if (truth_compare(stdout, said, &found, r->a->within) > 0)
            spoil(r, WRONG);
    } else {
        json_text_write(stdout, found.line);
        putchar('\n');
    }
    case_clear(&found);
}

static void solve_stream(struct run *r, FILE *stream, const char *name)
{
    struct case_reader reader;
    bool more = true;
    case_reader_init(&reader, stream, name);
    while (more && !interrupted) {
        struct test_case c;
        enum case_status status = case_read(&reader, &c);
        more = status != CASE_END;
        if (status == CASE_BAD) {
            progress_note("%s", reader.error);
            spoil(r, BAD_DATA);
            more = r->a->keep_going;
        } else if (status == CASE_READ) {
            if (selection_takes(&r->a->cases, &c)) {
                r->taken++;
                solve_case(r, &c);
            }
            progress_step();
            case_clear(&c);
        }
    }
    case_reader_clear(&reader);
}

static void solve_file(struct run *r, const char *path)
{
    FILE *stream = strcmp(path, "-") ? fopen(path, "r") : stdin;
    if (!stream) {
        progress_note("%s: %s", path, strerror(errno));
        spoil(r, FAILED);
        return;
    }
    solve_stream(r, stream, stream == stdin ? "stdin" : path);
    if (ferror(stream))
        r->worst = FAILED;
    if (stream != stdin)
        fclose(stream);
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void write_timing(struct run *r, int argc, char **argv)
{
    row_write(stdout, row_environment(argc, argv, "exact"));
    for (int i = 0; i < r->group_count; i++) {
        struct group *g = &r->groups[i];
        qsort(g->seconds, (size_t)g->count, sizeof *g->seconds, by_value);
        double median = (g->seconds[(g->count - 1) / 2] + g->seconds[g->count / 2]) / 2;
        json_t *row = json_pack("{s:i, s:i, s:i, s:f, s:f, s:f, s:s}", "n", g->n, "m", g->m, "pairs",
                                g->count, "seconds_min", g->seconds[0], "seconds_median", median,
                                "seconds_max", g->seconds[g->count - 1], "worst_id", g->worst_id);
        row_write(stdout, row);
        free(g->seconds);
    }
    free(r->groups);
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp_child children[] = {{&selection_argp, 0, 0, 0}, {0}};
    static const struct argp argp = {options, parse, "[FILE...]", documentation, children, 0, 0};
    struct arguments a = {.limits = {.digits = DIGITS_LEAST}};
    struct run r = {.a = &a};
    argp_parse(&argp, argc, argv, 0, 0, &a);
    interrupt_watch(NULL);
    const bool shows_lines = !a.compare && !a.timing && isatty(STDOUT_FILENO);
    progress_set_quiet(a.quiet || shows_lines);
    progress_begin("truth", 0);
    for (int i = 0; i < selection_files(&a.cases) && !interrupted; i++)
        if (r.worst < BAD_DATA || a.keep_going)
            solve_file(&r, selection_file(&a.cases, i));
    progress_end();
    if (r.worst == OK && !interrupted && !r.taken)
        spoil(&r, selection_complain(&a.cases, "fatline truth"));
    if (a.timing)
        write_timing(&r, argc, argv);
    selection_clear(&a.cases);
    flint_cleanup();
    return interrupted ? INTERRUPTED : r.worst;
}
