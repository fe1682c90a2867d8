#include "resume.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "row.h"

__attribute__((format(printf, 3, 4))) static int fail(struct resume *r, int status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->error, sizeof r->error, format, arguments);
    va_end(arguments);
    return status;
}

/* ---- the same command?
 * ------------------------------------------------------------------------------------- */

static const struct resume_option always[] = {{0, "resume", false}, {'o', "output", true}, {0, NULL, false}};

static const struct resume_option *option_of(char letter, const char *name, const struct resume_option *idle)
{
    for (const struct resume_option *o = idle; o && o->name; o++)
        if (name ? !strncmp(o->name, name, strcspn(name, "=")) : o->letter == letter)
            return o;
    return idle == always ? NULL : option_of(letter, name, always);
}

/* Appends the argument i without options that change no result; the number of arguments taken.  As argp has
 * accepted them, a long option may be a beginning of its name, and letters may share an argument. */
static size_t append_argument(json_t *kept, const json_t *list, size_t i, const struct resume_option *idle)
{
    const char *text = json_string_value(json_array_get(list, i));
    const struct resume_option *o;
    if (!strncmp(text, "--", 2) && text[2] && (o = option_of(0, text + 2, idle)) != NULL)
        return o->valued && !strchr(text, '=') ? 2 : 1;
    if (text[0] == '-' && text[1] && text[1] != '-') {
        for (text++; *text && (o = option_of(*text, NULL, idle)) != NULL; text++)
            if (o->valued)
                return text[1] ? 1 : 2;
        if (*text)
            json_array_append_new(kept, json_sprintf("-%s", text));
        return 1;
    }
    json_array_append(kept, json_array_get(list, i));
    return 1;
}

/* The arguments of an environment line that make its rows what they are. */
static json_t *arguments_of(const json_t *line, const struct resume_option *idle)
{
    const json_t *list = json_object_get(json_object_get(line, "environment"), "arguments");
    json_t *kept = json_array();
    for (size_t i = 1; i < json_array_size(list);)
        i += json_is_string(json_array_get(list, i)) ? append_argument(kept, list, i, idle) : 1;
    return kept;
}

/* "--tolerance 1e-9": the argument i, with the option before it that it may belong to; "" beyond the end. */
static void argument_text(const json_t *list, size_t i, char text[120])
{
    const char *before = i > 0 ? json_string_value(json_array_get(list, i - 1)) : NULL;
    const char *it = json_string_value(json_array_get(list, i));
    bool belongs = it && it[0] != '-' && before && before[0] == '-' && !strchr(before, '=');
    snprintf(text, 120, "%s%s%s", belongs ? before : "", belongs ? " " : "", it ? it : "");
}

static bool is_among(const json_t *list, const json_t *text)
{
    size_t i;
    json_t *other;
    json_array_foreach(list, i, other)
    {
        if (json_equal(other, text))
            return true;
    }
    return false;
}

/* 0, or 64 and the first argument in which the two lists differ. */
static int compare_arguments(struct resume *r, const char *path, const json_t *then, const json_t *now)
{
    size_t i = 0;
    char old[120], new[120];
    while (i < json_array_size(then) && json_equal(json_array_get(then, i), json_array_get(now, i)))
        i++;
    if (i == json_array_size(then) && i == json_array_size(now))
        return 0;
    argument_text(then, i, old);
    argument_text(now, i, new);
    const bool lost = old[0] && !is_among(now, json_array_get(then, i));
    const bool added = new[0] && !is_among(then, json_array_get(now, i));
    if (added && !lost)
        return fail(r, 64, "%s: begun without %s; nothing was done", path, new);
    if (lost && !added)
        return fail(r, 64, "%s: begun with %s, which is missing now; nothing was done", path, old);
    return fail(r, 64, "%s: begun with %s where %s stands now; nothing was done", path,
                old[0] ? old : "nothing", new[0] ? new : "nothing");
}

static const char *fact(const json_t *line, const char *field)
{
    const char *text = json_string_value(json_object_get(json_object_get(line, "environment"), field));
    return text ? text : "";
}

/* "check" of "fatline check" and of "fatline-check". */
static const char *command_name(const json_t *line)
{
    const char *program = fact(line, "program"), *last = strpbrk(program, " -");
    return last ? last + 1 : program;
}

static int compare_commands(struct resume *r, const char *path, const json_t *then, const json_t *now,
                            const struct resume_option *idle)
{
    if (strcmp(command_name(then), command_name(now)))
        return fail(r, 64, "%s: begun by fatline %s; nothing was done", path, command_name(then));
    if (strcmp(fact(then, "precision"), fact(now, "precision")))
        return fail(r, 64, "%s: begun at precision %s; nothing was done", path, fact(then, "precision"));
    json_t *x = arguments_of(then, idle), *y = arguments_of(now, idle);
    int status = compare_arguments(r, path, x, y);
    json_decref(x);
    json_decref(y);
    return status;
}

/* ---- what is there
 * ----------------------------------------------------------------------------------------- */

/* What was read of the file so far. */
struct past {
    json_t *groups;
    char *last;      /* the group that the last row is of */
    long last_start; /* where it begins in the file */
    long end;        /* of the last whole line */
};

static void note_row(struct past *p, char *group, long start)
{
    if (!p->last || strcmp(p->last, group)) {
        free(p->last);
        p->last = strdup(group);
        p->last_start = start;
    }
    json_int_t rows = json_integer_value(json_object_get(p->groups, group));
    json_object_set_new(p->groups, group, json_integer(rows + 1));
    free(group);
}

/* The first line must be the environment of the same command. */
static int begin_past(struct resume *r, const char *path, const json_t *row, const struct resume_rule *rule,
                      const json_t *environment)
{
    if (!json_object_get(row, "environment"))
        return fail(r, 65,
                    "%s:1: environment: missing, expected the file of an interrupted run; nothing was done",
                    path);
    int status = compare_commands(r, path, row, environment, rule->idle);
    if (!status)
        row_continue_run(json_string_value(json_object_get(row, "run")));
    return status;
}

/* Only the last line may be torn, and the first only where it is seen to be ours: whatever else is no row was
 * not written by us. */
static int read_past(struct resume *r, FILE *file, const char *path, const struct resume_rule *rule,
                     const json_t *environment, struct past *p)
{
    char *text = NULL;
    size_t size = 0;
    ssize_t n;
    int status = 0, number = 1;
    for (long start = 0; !status && (n = getline(&text, &size, file)) > 0; start += n, number++) {
        bool whole = text[n - 1] == '\n';
        if (!whole && (start > 0 || !strncmp(text, "{\"environment\":", 15)))
            break;
        json_t *row = whole ? json_loads(text, 0, NULL) : NULL;
        char *group = row ? rule->group(row) : NULL;
        if (start == 0)
            status = begin_past(r, path, row, rule, environment);
        else if (!row)
            status = fail(r, 65, "%s:%d: not JSON, expected a row of the interrupted run; nothing was done",
                          path, number);
        if (group)
            note_row(p, group, start);
        p->end = start + n;
        json_decref(row);
    }
    free(text);
    return status;
}

/* Cuts the incomplete last group off. */
static int cut(struct resume *r, const char *path, const struct resume_rule *rule, struct past *p)
{
    struct stat file;
    if (p->last && json_integer_value(json_object_get(p->groups, p->last)) < rule->rows) {
        json_object_del(p->groups, p->last);
        p->end = p->last_start;
    }
    if (stat(path, &file) || (file.st_size > p->end && truncate(path, p->end)))
        return fail(r, 2, "%s: %s", path, strerror(errno));
    return 0;
}

static int continue_file(struct resume *r, const char *path, const struct resume_rule *rule,
                         const json_t *environment)
{
    struct past past = {json_object(), NULL, 0, 0};
    FILE *file = fopen(path, "r");
    if (!file && errno == ENOENT) {
        r->groups = past.groups;
        return 0;
    }
    int status = file ? read_past(r, file, path, rule, environment, &past)
                      : fail(r, 2, "%s: %s", path, strerror(errno));
    if (file)
        fclose(file);
    if (!status)
        status = cut(r, path, rule, &past);
    r->groups = past.groups;
    r->done = past.end > 0 ? (int)json_object_size(past.groups) : 0;
    free(past.last);
    return status;
}

int resume_open(struct resume *r, const char *path, bool resume, const struct resume_rule *rule,
                json_t *environment)
{
    int status = 0;
    memset(r, 0, sizeof *r);
    r->out = stdout;
    if (path && resume)
        status = continue_file(r, path, rule, environment);
    if (!r->groups)
        r->groups = json_object();
    if (!status && path) {
        r->out = fopen(path, resume ? "a" : "w");
        if (r->out)
            fseek(r->out, 0, SEEK_END);
        if (!r->out)
            status = fail(r, 2, "%s: %s", path, strerror(errno));
    }
    if (!status && r->out != stdout && ftell(r->out) > 0)
        json_decref(environment);
    else if (!status)
        row_write(r->out, environment);
    else
        json_decref(environment);
    if (!status)
        fflush(r->out);
    return status;
}

bool resume_has(const struct resume *r, const char *group)
{
    return json_object_get(r->groups, group) != NULL;
}

bool resume_close(struct resume *r)
{
    FILE *file = r->out != stdout ? r->out : NULL;
    bool bad = file && ferror(file);
    json_decref(r->groups);
    memset(r, 0, sizeof *r);
    errno = EIO;
    return !(file && fclose(file)) && !bad;
}
