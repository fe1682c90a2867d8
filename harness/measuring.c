#include "measuring.h"

#include <errno.h>
#include <fnmatch.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"
#include "row.h"

enum { OK = 0, FAILED = 2, BAD_DATA = 65, INTERRUPTED = 130 };
enum { ID = 512, ROWS };

static volatile sig_atomic_t interrupted;

static void interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

bool measuring_is_interrupted(void)
{
    return interrupted;
}

static const struct argp_option options[] = {
    {"algorithm", 'a', "LIST", 0, "names or globs, separated by commas; may be repeated (all)", 0},
    {"id", ID, "GLOB", 0, "only the cases whose id matches", 0},
    {"rows", ROWS, 0, 0, "rows of JSON, after one line on the circumstances, instead of a table", 0},
    {"quiet", 'q', 0, 0, "no progress", 0},
    {0, 0, 0, 0, 0, 0}};

int measuring_count(struct argp_state *state, const char *name, const char *text, int lo, int hi)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end || value < lo || value > hi)
        argp_error(state, "--%s: '%s' is not a whole number from %d to %d", name, text, lo, hi);
    return (int)value;
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct measuring *m = (struct measuring *)state->input;
    const char *error = NULL;
    switch (key) {
    case 'a':
        error = algorithms_named_add(&m->algorithms, text);
        break;
    case ID:
        m->id = text;
        break;
    case ROWS:
        m->rows = true;
        break;
    case 'q':
        m->quiet = true;
        break;
    case ARGP_KEY_ARGS:
        m->files = state->argv + state->next;
        m->file_count = state->argc - state->next;
        break;
    case ARGP_KEY_END:
        if (m->algorithms.count == 0)
            error = algorithms_named_add(&m->algorithms, "all");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    if (error)
        argp_error(state, "%s", error);
    return 0;
}

extern const struct argp measuring_argp;
const struct argp measuring_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};

static int measure_stream(const struct measuring *m, FILE *stream, const char *name,
                          bool (*measure)(void *data, struct test_case *c), void *data)
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
        if (!m->id || !fnmatch(m->id, c.id, 0)) {
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
                        bool (*measure)(void *data, struct test_case *c), void *data)
{
    FILE *stream = strcmp(path, "-") ? fopen(path, "r") : stdin;
    if (!stream) {
        progress_note("%s: %s", path, strerror(errno));
        return FAILED;
    }
    int status = measure_stream(m, stream, stream == stdin ? "stdin" : path, measure, data);
    if (stream != stdin)
        fclose(stream);
    return status;
}

int measuring_run(const struct measuring *m, int argc, char **argv,
                  bool (*measure)(void *data, struct test_case *c), void *data)
{
    struct sigaction action;
    int worst = OK;
    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESETHAND; /* the second signal ends the program at once */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    if (m->rows)
        row_write(stdout, row_environment(argc, argv, REAL_NAME));
    progress_set_quiet(m->quiet);
    progress_begin(argv[0], 0);
    for (int i = 0; i < (m->file_count ? m->file_count : 1) && !interrupted && worst != FAILED; i++) {
        int status = measure_file(m, m->file_count ? m->files[i] : "-", measure, data);
        worst = status != OK ? status : worst;
    }
    progress_end();
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "%s: standard output cannot be written\n", argv[0]);
        return FAILED;
    }
    return interrupted ? INTERRUPTED : worst;
}

void measuring_clear(struct measuring *m)
{
    algorithms_named_clear(&m->algorithms);
}
