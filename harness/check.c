/* fatline check: do the answers agree with the truth?
 *
 * A row a case and algorithm:
 * {"id","class","algorithm","precision","tolerance","outcome","verdict","expected",
 * "found","missed","extra","duplicate","merged","undecided","max_error","ambiguous","steps","file"}, with
 * "judged_by":"points" where only points were compared (judge.h).
 *
 * The work is done by forked workers: worker k of n takes the lines k, k + n, ... of all files, counted
 * together, and replies to each through a pipe of its own; so the replies are read in the order of the lines.
 */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <argp.h>

#include "judge/check_estimate.h"
#include "judge/check_table.h"
#include "judge/check_worker.h"
#include "run/interrupt.h"
#include "run/progress.h"
#include "run/resume.h"
#include "run/row.h"
#include "run/standard_output.h"

enum { OK = 0, NOT_RIGHT = 1, FAILED = 2, BAD_DATA = 65 };

enum { JOBS_PER_PROCESSOR = 4 };

/* ---- the parent ------------------------------------------------------------------------------------------
 */

struct hand {
    pid_t pid;
    FILE *from;
};

/* In the worker: whatever ends the parent, or is meant to end it, ends us. */
static void be_worker(pid_t parent)
{
    signal(SIGTERM, SIG_DFL);
    signal(SIGINT, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (interrupted || getppid() != parent)
        _exit(FAILED);
}

static bool hire(const struct check_options *o, struct hand *hands, int number)
{
    const pid_t parent = getpid();
    int ends[2];
    if (pipe(ends))
        return false;
    fflush(NULL);
    hands[number].pid = fork();
    if (hands[number].pid < 0)
        return false;
    if (hands[number].pid == 0) {
        be_worker(parent);
        for (int i = 0; i < number; i++)
            close(fileno(hands[i].from));
        close(ends[0]);
        _exit(check_work(o, number, fdopen(ends[1], "w")));
    }
    close(ends[1]);
    hands[number].from = fdopen(ends[0], "r");
    return true;
}

/* Ends what still runs; false if a worker ended badly of itself. */
static bool dismiss(struct hand *hands, int count, bool early)
{
    bool good = true;
    for (int i = 0; early && i < count; i++)
        kill(hands[i].pid, SIGTERM);
    for (int i = 0; i < count; i++) {
        int status = 0;
        fclose(hands[i].from);
        if (waitpid(hands[i].pid, &status, 0) == hands[i].pid && !early &&
            !(WIFEXITED(status) && WEXITSTATUS(status) == OK)) {
            good = false;
            if (WIFSIGNALED(status))
                fprintf(stderr, "fatline check: a worker was ended by signal %d\n", WTERMSIG(status));
        }
    }
    return good;
}

/* Rows to the output or the table, notes to standard error; an exit status for what is wrong with the line.
 */
static int take_reply(const json_t *reply, const struct check_options *o, FILE *out,
                      struct check_table *table)
{
    size_t i;
    json_t *row, *text;
    json_array_foreach(json_object_get(reply, "notes"), i, text) progress_note("%s", json_string_value(text));
    json_array_foreach(json_object_get(reply, "rows"), i, row)
    {
        check_table_add(table, row);
        if (o->rows)
            row_write(out, json_incref(row));
    }
    if (o->output)
        fflush(out); /* an interrupted run leaves whole cases behind */
    progress_step();
    return json_object_get(reply, "failed") ? FAILED : json_object_get(reply, "bad") ? BAD_DATA : OK;
}

static int listen(const struct check_options *o, struct hand *hands, FILE *out, struct check_table *table,
                  bool *early)
{
    char *text = NULL;
    size_t size = 0;
    int worst = OK;
    *early = false;
    for (long i = 0; !interrupted && !*early; i++) {
        if (getline(&text, &size, hands[i % o->jobs].from) < 0)
            break;
        json_t *reply = json_loads(text, 0, NULL);
        int status = reply ? take_reply(reply, o, out, table) : FAILED;
        json_decref(reply);
        if (status != OK && worst != FAILED)
            worst = status;
        *early = status != OK && !o->keep_going;
    }
    *early = *early || interrupted;
    free(text);
    return worst;
}

static int check_all(const struct check_options *o, FILE *out, struct check_table *table)
{
    struct hand *hands = (struct hand *)calloc((size_t)o->jobs, sizeof *hands);
    bool early = true, hired = hands != NULL;
    int count = 0, status = FAILED;
    for (; hired && count < o->jobs && !interrupted; count += hired)
        hired = hire(o, hands, count);
    if (hired && count == o->jobs)
        status = listen(o, hands, out, table, &early);
    else if (!interrupted)
        fprintf(stderr, "fatline check: %s\n", strerror(errno));
    if (!dismiss(hands, count, early))
        status = FAILED;
    free(hands);
    return status;
}

/* Lines with something in them; 0 if that cannot be known. */
static long count_lines(const struct check_options *o)
{
    char *text = NULL;
    size_t size = 0;
    long count = 0;
    for (int i = 0; i < selection_files(&o->cases); i++) {
        FILE *stream = check_open_cases(selection_file(&o->cases, i));
        while (stream && getline(&text, &size, stream) >= 0)
            count += !check_line_is_blank(text);
        if (stream)
            fclose(stream);
    }
    free(text);
    return count;
}

/* More workers than cases have nothing to do, and many more than processors are in each other's way. */
static void limit_jobs(struct check_options *o, long lines)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    long most = JOBS_PER_PROCESSOR * (processors > 0 ? processors : 1);
    const int asked = o->jobs;
    if (o->jobs > lines)
        o->jobs = lines > 0 ? (int)lines : 1;
    if (o->jobs > most) {
        fprintf(stderr, "fatline check: --jobs: %ld instead of %d, which is %d for each of %ld processors\n",
                most, asked, (int)JOBS_PER_PROCESSOR, most / JOBS_PER_PROCESSOR);
        o->jobs = (int)most;
    }
}

static bool reads_standard_input(const struct check_options *o)
{
    for (int i = 0; i < selection_files(&o->cases); i++)
        if (!strcmp(selection_file(&o->cases, i), "-"))
            return true;
    return false;
}

static char *group_of(const json_t *row)
{
    const char *id = json_string_value(json_object_get(row, "id"));
    return id ? check_group(json_string_value(json_object_get(row, "file")), id) : NULL;
}

/* 0, or an exit status. */
static int open_output(int argc, char **argv, struct check_options *o, struct resume *resume)
{
    static const struct resume_option idle[] = {{'q', "quiet", false}, {'j', "jobs", true}, {0, NULL, false}};
    struct resume_rule rule = {group_of, o->solving.algorithms.count + (o->solving.external != NULL), idle};
    memset((void *)resume, 0, sizeof *resume);
    resume->out = stdout;
    if (!o->rows)
        return 0;
    int status = resume_open(resume, o->output, o->resume, &rule, row_environment(argc, argv, REAL_NAME));
    if (status)
        fprintf(stderr, "fatline check: %s\n", resume->error);
    else if (resume->done)
        fprintf(stderr, "fatline check: resumed: %d cases are done\n", resume->done);
    o->past = resume;
    return status;
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    struct check_options options;
    struct check_table table;
    struct resume output;

    check_options_read(argc, argv, &options);
    memset(&table, 0, sizeof table);
    table.strict = options.strict;
    if (reads_standard_input(&options))
        check_load_standard_input();
    const long lines = count_lines(&options);
    limit_jobs(&options, lines);
    if (options.dry_run)
        return check_estimate(&options);
    int status = open_output(argc, argv, &options, &output);
    if (status)
        return status;
    progress_set_quiet(options.quiet || (options.rows && !options.output && isatty(STDOUT_FILENO)));
    progress_begin("check", lines);
    interrupt_watch(NULL);
    status = check_all(&options, output.out, &table);
    progress_end();

    if (!options.rows)
        check_table_write(&table, stdout);
    if (status == OK && !table.count && !output.done && !interrupted)
        status = selection_complain(&options.cases, "fatline check");
    if (check_table_unjudged(&table))
        fprintf(stderr, "fatline check: %ld answers unjudged for want of a truth (--truth computes it)\n",
                check_table_unjudged(&table));
    bool failed = check_table_failed(&table), lost = !resume_close(&output);
    if (lost)
        fprintf(stderr, "fatline check: %s: %s\n", options.output, strerror(errno));
    check_table_clear(&table);
    check_options_clear(&options);
    return interrupted ? INTERRUPTED : lost ? FAILED : status != OK ? status : failed ? NOT_RIGHT : OK;
}
