/* fatline solve: one line for each case and algorithm. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <argp.h>

#include "judge/answer.h"
#include "judge/answer_table.h"
#include "cases/case.h"
#include "run/external.h"
#include "cases/problem.h"
#include "run/guard.h"
#include "run/interrupt.h"
#include "run/progress.h"
#include "run/solve_options.h"
#include "run/standard_output.h"
#include "truth/decide.h"

enum { OK = 0, FAILED = 2, BAD_DATA = 65 };

struct solver {
    const struct solve_options *options;
    FILE *out;
    long taken;        /* cases that were asked for */
    bool human, flush; /* flush: somebody may be waiting for each line */
    struct fitted_workspace memory;
    struct crossings *crossings;
    struct external external;
};

/* decided: whether it is, with --decide; else not there. */
static void write_answer(struct solver *s, const struct answer *a, const struct problem *p,
                         const char *message, json_t *decided)
{
    json_t *extra = json_object();
    if (decided)
        json_object_set_new(extra, "decided", decided);
    if (message)
        json_object_set_new(extra, "message", json_string(message));
    if (s->human)
        answer_table_write(s->out, a, p, message);
    else
        answer_write(s->out, a, &p->f, extra);
    json_decref(extra);
    if (s->flush)
        fflush(s->out);
}

static void solve_by(struct solver *s, const struct test_case *c, const struct problem *p,
                     const struct intersector *algorithm)
{
    struct answer a = {c->id, algorithm->name,        s->options->tolerance, INVALID,
                       0,     algorithm->points_only, s->crossings};
    struct workspace *w = workspace_fit(&s->memory, s->options->solving.algorithms.at, p->f.degree,
                                        p->g.degree, s->options->solving.room);
    a.outcome = guard_solve(p, algorithm, w, s->crossings);
    a.steps = w->steps;
    double seconds = s->options->decide;
    const char *why_not = seconds > 0 ? decide(c, p, seconds, &a.outcome, s->crossings) : NULL;
    write_answer(s, &a, p, why_not, seconds > 0 ? json_boolean(!why_not) : NULL);
}

static void solve_outside(struct solver *s, const struct test_case *c, const struct problem *p)
{
    struct answer a = {c->id, NULL, s->options->tolerance, INVALID, 0, false, s->crossings};
    char *line = json_dumps(c->line, JSON_COMPACT);
    const char *message = external_ask(&s->external, c->id, line ? line : "", &a);
    free(line);
    if (message && !interrupted)
        progress_note("%s: %s", c->id, message);
    if (!interrupted)
        write_answer(s, &a, p, message, NULL);
}

/* All algorithms on one case. */
static int solve_case(struct solver *s, const struct test_case *c)
{
    const struct solve_options *o = s->options;
    struct owned_problem owned;
    if (!selection_takes(&o->cases, c))
        return OK;
    s->taken++;
    const char *why_not = owned_problem_make(c, o->tolerance, o->solving.max_steps, &owned);
    if (why_not) {
        progress_note("%s:%d: %s", c->file, c->line_number, why_not);
        return BAD_DATA;
    }
    for (int i = 0; i < o->solving.algorithms.count && !interrupted; i++)
        solve_by(s, c, &owned.problem, o->solving.algorithms.at[i]);
    if (o->solving.external && !interrupted)
        solve_outside(s, c, &owned.problem);
    owned_problem_clear(&owned);
    progress_step();
    return OK;
}

static int solve_stream(struct solver *s, FILE *stream, const char *name)
{
    struct case_reader reader;
    int worst = OK;
    bool more = true;
    case_reader_init(&reader, stream, name);
    while (more && !interrupted) {
        struct test_case c;
        enum case_status status = case_read(&reader, &c);
        int result = OK;
        if (status == CASE_END || interrupted)
            more = false;
        else if (status == CASE_BAD)
            progress_note("%s", reader.error);
        if (status == CASE_READ) {
            result = solve_case(s, &c);
            case_clear(&c);
        }
        if ((status == CASE_BAD && !interrupted) || result != OK) {
            worst = BAD_DATA;
            more = more && s->options->keep_going;
        }
        more = more && !ferror(s->out);
    }
    case_reader_clear(&reader);
    return worst;
}

static int solve_file(struct solver *s, const char *path)
{
    if (!strcmp(path, "-"))
        return solve_stream(s, stdin, "stdin");
    FILE *stream = fopen(path, "r");
    if (!stream) {
        progress_note("%s: %s", path, strerror(errno));
        return FAILED;
    }
    int result = solve_stream(s, stream, path);
    if (ferror(stream))
        result = FAILED;
    fclose(stream);
    return result;
}

static int solve_own(struct solver *s)
{
    struct test_case c;
    char error[512];
    if (case_parse(s->options->own_line, "command line", 1, &c, error) != CASE_READ) {
        progress_note("%s", error);
        return BAD_DATA;
    }
    int result = solve_case(s, &c);
    case_clear(&c);
    return result;
}

static int solve_all(struct solver *s)
{
    const struct solve_options *o = s->options;
    int worst = OK;
    if (o->own_line)
        return solve_own(s);
    for (int i = 0; i < selection_files(&o->cases) && !interrupted; i++) {
        int result = solve_file(s, selection_file(&o->cases, i));
        if (result != OK)
            worst = worst == FAILED ? FAILED : result;
        if (result != OK && !o->keep_going)
            break;
    }
    return worst;
}

/* Opens what is written to and read from; 0 or an exit status. */
static int open_all(struct solver *s, const struct solve_options *o)
{
    struct stat out;
    s->options = o;
    s->crossings = (struct crossings *)malloc(sizeof *s->crossings);
    s->out = o->output ? fopen(o->output, "w") : stdout;
    if (!s->crossings || !s->out) {
        fprintf(stderr, "%s: %s\n", o->output ? o->output : "fatline solve", strerror(errno));
        return FAILED;
    }
    s->flush = fstat(fileno(s->out), &out) || !S_ISREG(out.st_mode);
    guard_set_timeout(o->solving.timeout);
    s->human = o->human || (o->own_line && isatty(fileno(s->out)));
    const char *error = o->solving.external ? external_start(&s->external, o->solving.external,
                                                             o->solving.timeout, o->tolerance)
                                            : NULL;
    if (error)
        fprintf(stderr, "fatline solve: %s\n", error);
    return error ? FAILED : OK;
}

static int close_all(struct solver *s)
{
    bool bad = s->out != stdout && ferror(s->out);
    if (s->out != stdout)
        bad = fclose(s->out) || bad;
    if (bad)
        fprintf(stderr, "%s: cannot be written\n", s->options->output);
    if (s->options->solving.external)
        external_stop(&s->external);
    guard_end();
    fitted_workspace_clear(&s->memory);
    free(s->crossings);
    return bad ? FAILED : OK;
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    struct solve_options options;
    static struct solver s;
    solve_options_read(argc, argv, &options);
    int result = open_all(&s, &options);
    if (result != OK)
        return result;
    interrupt_watch(external_interrupt);
    progress_set_quiet(options.quiet || options.own_line || isatty(fileno(s.out)));
    progress_begin("solve", 0);
    result = solve_all(&s);
    progress_end();
    if (result == OK && !interrupted && !s.taken)
        result = selection_complain(&options.cases, "fatline solve");
    int closed = close_all(&s);
    solve_options_clear(&options);
    return interrupted ? INTERRUPTED : closed != OK ? closed : result;
}
