#include "resume.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
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

/* The arguments of an environment line without --resume. */
static json_t *arguments_of(const json_t *line)
{
    const json_t *list = json_object_get(json_object_get(line, "environment"), "arguments");
    json_t *kept = json_array(), *text;
    size_t i;
    json_array_foreach(list, i, text)
    {
        if (i > 0 && strcmp(json_string_value(text), "--resume"))
            json_array_append(kept, text);
    }
    return kept;
}

static bool same_command(const json_t *a, const json_t *b)
{
    json_t *x = arguments_of(a), *y = arguments_of(b);
    bool same = json_equal(x, y);
    json_decref(x);
    json_decref(y);
    return same;
}

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
static int read_past(struct resume *r, FILE *file, const char *path, const struct resume_rule *rule,
                     const json_t *environment, struct past *p)
{
    char *text = NULL;
    size_t size = 0;
    ssize_t n;
    int status = 0;
    for (long start = 0; !status && (n = getline(&text, &size, file)) > 0; start += n) {
        json_t *row = text[n - 1] == '\n' ? json_loads(text, 0, NULL) : NULL;
        if (!row)
            break; /* torn */
        char *group = rule->group(row);
        if (start == 0 && !json_object_get(row, "environment"))
            status = fail(r, 65, "%s:1: environment: missing, expected the file of an interrupted run", path);
        else if (start == 0 && !same_command(row, environment))
            status = fail(r, 64, "%s: begun with other arguments; nothing was done", path);
        else if (start == 0)
            row_continue_run(json_string_value(json_object_get(row, "run")));
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
    if (p->last && json_integer_value(json_object_get(p->groups, p->last)) < rule->rows) {
        json_object_del(p->groups, p->last);
        p->end = p->last_start;
    }
    return truncate(path, p->end) ? fail(r, 2, "%s: %s", path, strerror(errno)) : 0;
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
    bool good = r->out && !fflush(r->out) && !ferror(r->out);
    if (r->out && r->out != stdout)
        good = !fclose(r->out) && good;
    json_decref(r->groups);
    memset(r, 0, sizeof *r);
    return good;
}
