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
#include <fnmatch.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <argp.h>

#include "check_case.h"
#include "check_table.h"
#include "progress.h"
#include "row.h"

enum { OK = 0, NOT_RIGHT = 1, FAILED = 2, BAD_DATA = 65, INTERRUPTED = 130 };

static volatile sig_atomic_t interrupted;

static void interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

/* Standard input is read once, by the parent. */
static char *standard_input;
static size_t standard_input_size;

static void load_standard_input(void)
{
    FILE *copy = open_memstream(&standard_input, &standard_input_size);
    char buffer[65536];
    size_t n;
    while ((n = fread(buffer, 1, sizeof buffer, stdin)) > 0)
        fwrite(buffer, 1, n, copy);
    fclose(copy);
}

static FILE *open_cases(const char *path)
{
    if (strcmp(path, "-"))
        return fopen(path, "r");
    return standard_input_size ? fmemopen(standard_input, standard_input_size, "r") : fopen("/dev/null", "r");
}

/* ---- a worker --------------------------------------------------------------------------------------------
 */

struct worker {
    struct checker checker;
    const struct check_options *options;
    int number;       /* 0 .. options->jobs - 1 */
    long lines;       /* of all files so far */
    json_t *of_class; /* cases seen of each class */
    FILE *to;
};

static bool reply_with(struct worker *w, json_t *reply)
{
    json_dumpf(reply, w->to, JSON_COMPACT);
    json_decref(reply);
    return fputc('\n', w->to) != EOF && !fflush(w->to);
}

/* Counts the case if it is of those asked for. */
static bool is_selected(struct worker *w, const struct test_case *c)
{
    const struct check_options *o = w->options;
    if ((o->id && fnmatch(o->id, c->id, 0)) || (o->class_name && strcmp(o->class_name, c->class_name)))
        return false;
    json_int_t seen = json_integer_value(json_object_get(w->of_class, c->class_name));
    json_object_set_new(w->of_class, c->class_name, json_integer(seen + 1));
    return seen % o->sample == 0;
}

/* Every worker counts the classes; only one replies. False if nobody listens any more. */
static bool take_line(struct worker *w, const char *text, const char *file, int line_number)
{
    bool mine = w->lines++ % w->options->jobs == w->number, selected = false;
    struct test_case c;
    char error[512];
    json_t *reply = NULL;

    if (!mine && w->options->sample == 1)
        return true;
    enum case_status status = case_parse(text, file, line_number, &c, error);
    if (status == CASE_READ)
        selected = is_selected(w, &c);
    if (mine && status != CASE_READ)
        reply = json_pack("{s:b,s:[s]}", "bad", 1, "notes", error);
    else if (mine)
        reply = selected ? checker_run(&w->checker, &c) : json_object();
    if (status == CASE_READ)
        case_clear(&c);
    return !mine || reply_with(w, reply);
}

static bool is_blank(const char *text)
{
    return text[strspn(text, " \t\r\n")] == 0;
}

static bool take_file(struct worker *w, const char *path)
{
    const char *name = strcmp(path, "-") ? path : "stdin";
    FILE *stream = open_cases(path);
    char *text = NULL;
    size_t size = 0;
    int line_number = 0;
    bool more = true;

    if (!stream)
        return w->lines++ % w->options->jobs != w->number ||
               reply_with(w, json_pack("{s:b,s:[o]}", "failed", 1, "notes",
                                       json_sprintf("%s: %s", path, strerror(errno))));
    while (more && getline(&text, &size, stream) >= 0) {
        line_number++;
        if (!is_blank(text))
            more = take_line(w, text, name, line_number);
    }
    free(text);
    fclose(stream);
    return more;
}

static int work(const struct check_options *o, int number, FILE *to)
{
    static char dash[] = "-";
    static char *const only[] = {dash};
    struct worker w = {.options = o, .number = number, .to = to};
    char *const *files = o->file_count ? o->files : only;
    const char *error = checker_open(&w.checker, o);
    if (error) {
        fprintf(stderr, "fatline check: %s\n", error);
        return FAILED;
    }
    w.of_class = json_object();
    for (int i = 0; i < (o->file_count ? o->file_count : 1); i++)
        if (!take_file(&w, files[i]))
            break;
    checker_close(&w.checker);
    json_decref(w.of_class);
    return fclose(to) ? FAILED : OK;
}

/* ---- the parent ------------------------------------------------------------------------------------------
 */

struct hand {
    pid_t pid;
    FILE *from;
};

static bool hire(const struct check_options *o, struct hand *hands, int number)
{
    int ends[2];
    if (pipe(ends))
        return false;
    fflush(NULL);
    hands[number].pid = fork();
    if (hands[number].pid < 0)
        return false;
    if (hands[number].pid == 0) {
        signal(SIGTERM, SIG_DFL);
        for (int i = 0; i < number; i++)
            close(fileno(hands[i].from));
        close(ends[0]);
        _exit(work(o, number, fdopen(ends[1], "w")));
    }
    close(ends[1]);
    hands[number].from = fdopen(ends[0], "r");
    return true;
}

/* Ends what still runs; false if a worker ended badly of itself. */
static bool dismiss(struct hand *hands, int count, bool early)
{
    bool good = true;
    for (int i = 0; i < count; i++) {
        int status = 0;
        if (early)
            kill(hands[i].pid, SIGTERM);
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
static int take_reply(const json_t *reply, const struct check_options *o, struct check_table *table)
{
    size_t i;
    json_t *row, *text;
    json_array_foreach(json_object_get(reply, "notes"), i, text) progress_note("%s", json_string_value(text));
    json_array_foreach(json_object_get(reply, "rows"), i, row)
    {
        check_table_add(table, row);
        if (o->rows)
            row_write(stdout, json_incref(row));
    }
    progress_step();
    return json_object_get(reply, "failed") ? FAILED : json_object_get(reply, "bad") ? BAD_DATA : OK;
}

static int listen(const struct check_options *o, struct hand *hands, struct check_table *table, bool *early)
{
    char *text = NULL;
    size_t size = 0;
    int worst = OK;
    *early = false;
    for (long i = 0; !interrupted && !*early; i++) {
        if (getline(&text, &size, hands[i % o->jobs].from) < 0)
            break;
        json_t *reply = json_loads(text, 0, NULL);
        int status = reply ? take_reply(reply, o, table) : FAILED;
        json_decref(reply);
        if (status != OK && worst != FAILED)
            worst = status;
        *early = status != OK && !o->keep_going;
    }
    *early = *early || interrupted;
    free(text);
    return worst;
}

static int check_all(const struct check_options *o, struct check_table *table)
{
    struct hand *hands = (struct hand *)calloc((size_t)o->jobs, sizeof *hands);
    bool early = true, hired = hands != NULL;
    int count = 0, status = FAILED;
    for (; hired && count < o->jobs; count += hired)
        hired = hire(o, hands, count);
    if (hired)
        status = listen(o, hands, table, &early);
    else
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
    for (int i = 0; i < o->file_count; i++) {
        FILE *stream = open_cases(o->files[i]);
        while (stream && getline(&text, &size, stream) >= 0)
            count += !is_blank(text);
        if (stream)
            fclose(stream);
    }
    free(text);
    return count;
}

static bool reads_standard_input(const struct check_options *o)
{
    for (int i = 0; i < o->file_count; i++)
        if (!strcmp(o->files[i], "-"))
            return true;
    return o->file_count == 0;
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    struct check_options options;
    struct check_table table;
    struct sigaction action;

    check_options_read(argc, argv, &options);
    memset(&table, 0, sizeof table);
    memset(&action, 0, sizeof action);
    if (reads_standard_input(&options))
        load_standard_input();
    if (options.rows)
        row_write(stdout, row_environment(argc, argv, REAL_NAME));
    progress_set_quiet(options.quiet);
    progress_begin("check", count_lines(&options));
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESETHAND; /* the second signal ends the program at once */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    int status = check_all(&options, &table);
    progress_end();

    if (!options.rows)
        check_table_write(&table, stdout);
    if (check_table_unjudged(&table))
        fprintf(stderr, "fatline check: %ld answers unjudged for want of a truth (--truth computes it)\n",
                check_table_unjudged(&table));
    bool failed = check_table_failed(&table), lost = fflush(stdout) || ferror(stdout);
    if (lost)
        fprintf(stderr, "fatline check: standard output cannot be written\n");
    check_table_clear(&table);
    check_options_clear(&options);
    free(standard_input);
    return interrupted ? INTERRUPTED : lost ? FAILED : status != OK ? status : failed ? NOT_RIGHT : OK;
}
