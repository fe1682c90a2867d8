#include "check_worker.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "check_case.h"

/* Standard input is read once, by the parent. */
static char *standard_input;
static size_t standard_input_size;

void check_load_standard_input(void)
{
    FILE *copy = open_memstream(&standard_input, &standard_input_size);
    char buffer[65536];
    size_t n;
    while ((n = fread(buffer, 1, sizeof buffer, stdin)) > 0)
        fwrite(buffer, 1, n, copy);
    fclose(copy);
}

FILE *check_open_cases(const char *path)
{
    if (strcmp(path, "-"))
        return fopen(path, "r");
    return standard_input_size ? fmemopen(standard_input, standard_input_size, "r") : fopen("/dev/null", "r");
}

bool check_line_is_blank(const char *text)
{
    return text[strspn(text, " \t\r\n")] == 0;
}

void sampler_begin(struct sampler *s, const struct check_options *o)
{
    s->options = o;
    s->seen = json_object();
}

bool sampler_takes(struct sampler *s, const struct test_case *c)
{
    if (!selection_takes(&s->options->cases, c))
        return false;
    json_int_t seen = json_integer_value(json_object_get(s->seen, c->class_name));
    json_object_set_new(s->seen, c->class_name, json_integer(seen + 1));
    return seen % s->options->sample == 0;
}

void sampler_end(struct sampler *s)
{
    json_decref(s->seen);
}

struct worker {
    struct checker checker;
    const struct check_options *options;
    int number; /* 0 .. options->jobs - 1 */
    long lines; /* of all files so far */
    struct sampler sampler;
    FILE *to;
};

static bool reply_with(struct worker *w, json_t *reply)
{
    json_dumpf(reply, w->to, JSON_COMPACT);
    json_decref(reply);
    return fputc('\n', w->to) != EOF && !fflush(w->to);
}

char *check_group(const char *file, const char *id)
{
    char *group = (char *)malloc(strlen(file) + strlen(id) + 2);
    if (group)
        sprintf(group, "%s\n%s", file, id);
    return group;
}

static bool is_done(const struct check_options *o, const struct test_case *c)
{
    char *group = o->past ? check_group(c->file ? c->file : "", c->id) : NULL;
    bool done = group && resume_has(o->past, group);
    free(group);
    return done;
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
        selected = sampler_takes(&w->sampler, &c) && !is_done(w->options, &c);
    if (mine && status != CASE_READ)
        reply = json_pack("{s:b,s:[s]}", "bad", 1, "notes", error);
    else if (mine)
        reply = selected ? checker_run(&w->checker, &c) : json_object();
    if (status == CASE_READ)
        case_clear(&c);
    return !mine || reply_with(w, reply);
}

/* A file that cannot be read takes the place of a line. */
static bool report_failure(struct worker *w, const char *path, int why)
{
    return w->lines++ % w->options->jobs != w->number ||
           reply_with(w, json_pack("{s:b,s:[o]}", "failed", 1, "notes",
                                   json_sprintf("%s: %s", path, strerror(why))));
}

static bool take_file(struct worker *w, const char *path)
{
    const char *name = strcmp(path, "-") ? path : "stdin";
    FILE *stream = check_open_cases(path);
    char *text = NULL;
    size_t size = 0;
    int line_number = 0;
    bool more = true;

    if (!stream)
        return report_failure(w, path, errno);
    while (more && getline(&text, &size, stream) >= 0) {
        line_number++;
        if (!check_line_is_blank(text))
            more = take_line(w, text, name, line_number);
    }
    if (more && ferror(stream))
        more = report_failure(w, path, errno);
    free(text);
    fclose(stream);
    return more;
}

int check_work(const struct check_options *o, int number, FILE *to)
{
    struct worker w = {.options = o, .number = number, .to = to};
    const char *error = checker_open(&w.checker, o);
    if (error) {
        fprintf(stderr, "fatline check: %s\n", error);
        return 2;
    }
    sampler_begin(&w.sampler, o);
    for (int i = 0; i < selection_files(&o->cases); i++)
        if (!take_file(&w, selection_file(&o->cases, i)))
            break;
    checker_close(&w.checker);
    sampler_end(&w.sampler);
    return fclose(to) ? 2 : 0;
}
