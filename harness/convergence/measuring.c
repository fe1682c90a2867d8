#include "measuring.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../run/interrupt.h"
#include "../run/progress.h"
#include "../run/row.h"
#include "../run/solving.h"

enum { OK = 0, FAILED = 2, BAD_DATA = 65 };
enum { ROWS = 512 };

static const struct argp_option options[] = {
    {"algorithm", 'a', "LIST", 0, "names or globs, separated by commas; may be repeated (all)", 0},
    {"rows", ROWS, 0, 0, "rows of JSON, after one line on the circumstances, instead of a table", 0},
    {"quiet", 'q', 0, 0, "no progress", 0},
    {0, 0, 0, 0, 0, 0}};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct measuring *m = (struct measuring *)state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &m->cases;
        state->child_inputs[1] = m;
        return 0;
    case 'a':
        solving_add(state, &m->algorithms, text);
        return 0;
    case ROWS:
        m->rows = true;
        return 0;
    case 'q':
        m->quiet = true;
        return 0;
    case ARGP_KEY_END:
        if (m->algorithms.count == 0)
            solving_add(state, &m->algorithms, "all");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void measuring_read(int argc, char **argv, const struct argp *own, const char *documentation,
                    struct measuring *m)
{
    const struct argp_child children[] = {{&selection_argp, 0, 0, 0}, {own, 0, 0, 0}, {0, 0, 0, 0}};
    const struct argp argp = {options, parse, "[FILE...]", documentation, children, 0, 0};
    if (argp_parse(&argp, argc, argv, 0, NULL, m))
        exit(64);
}

bool measuring_problem(const struct test_case *c, real tolerance, int max_steps, struct owned_problem *p)
{
    const char *why_not = owned_problem_make(c, tolerance, max_steps, p);
    if (why_not)
        progress_note("%s:%d: %s", c->file, c->line_number, why_not);
    return !why_not;
}

bool measuring_solutions(struct test_case *c, int digits, double seconds, struct known_solutions *known)
{
    const char *why_not = known_solutions_make(c, digits, seconds, known);
    if (why_not)
        progress_note("%s:%d: %s: no solutions: %s", c->file, c->line_number, c->id, why_not);
    return !why_not;
}

/* taken: counts the cases that are asked for. */
static int measure_stream(const struct measuring *m, FILE *stream, const char *name,
                          bool (*measure)(void *data, struct test_case *c), void *data, long *taken)
{
    struct case_reader reader;
    struct test_case c;
    enum case_status status;
    int worst = OK;
    case_reader_init(&reader, stream, name);
    while (!interrupted && (status = case_read(&reader, &c)) != CASE_END) {
        if (status == CASE_BAD) {
            progress_note("%s", reader.error);
            worst = BAD_DATA;
            continue;
        }
        if (selection_takes(&m->cases, &c)) {
            ++*taken;
            if (!measure(data, &c))
                worst = worst == OK ? BAD_DATA : worst;
            progress_step();
        }
        case_clear(&c);
    }
    case_reader_clear(&reader);
    return worst;
}

static int measure_file(const struct measuring *m, const char *path,
                        bool (*measure)(void *data, struct test_case *c), void *data, long *taken)
{
    FILE *stream = strcmp(path, "-") ? fopen(path, "r") : stdin;
    if (!stream) {
        progress_note("%s: %s", path, strerror(errno));
        return FAILED;
    }
    int status = measure_stream(m, stream, stream == stdin ? "stdin" : path, measure, data, taken);
    if (stream != stdin)
        fclose(stream);
    return status;
}

int measuring_run(const struct measuring *m, int argc, char **argv,
                  bool (*measure)(void *data, struct test_case *c), void *data)
{
    long taken = 0;
    int worst = OK;
    interrupt_watch(NULL);
    if (m->rows)
        row_write(stdout, row_environment(argc, argv, REAL_NAME));
    progress_set_quiet(m->quiet);
    progress_begin(argv[0], 0);
    for (int i = 0; i < selection_files(&m->cases) && !interrupted && worst != FAILED; i++) {
        int status = measure_file(m, selection_file(&m->cases, i), measure, data, &taken);
        worst = status != OK ? status : worst;
    }
    progress_end();
    if (worst == OK && !interrupted && !taken)
        worst = selection_complain(&m->cases, argv[0]);
    return interrupted ? INTERRUPTED : worst;
}

void measuring_clear(struct measuring *m)
{
    algorithms_named_clear(&m->algorithms);
    selection_clear(&m->cases);
}
