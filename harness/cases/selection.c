#include "selection.h"

#include <fnmatch.h>
#include <string.h>

enum { CLASS = 0x10000, ID, FILTER };
enum { BAD_DATA = 65 };

static const struct argp_option options[] = {
    {"class", CLASS, "NAME", 0, "only the cases of this class", 1},
    {"id", ID, "GLOB", 0, "only the cases whose id matches", 1},
    {"filter", FILTER, "REGEX", 0, "only the cases whose id matches this extended regular expression", 1},
    {0, 0, 0, 0, 0, 0}};

static void set_filter(struct selection *s, const char *text, struct argp_state *state)
{
    char why[200];
    if (s->filter)
        regfree(&s->regex);
    int wrong = regcomp(&s->regex, text, REG_EXTENDED | REG_NOSUB);
    s->filter = text;
    if (wrong) {
        regerror(wrong, &s->regex, why, sizeof why);
        argp_error(state, "--filter: \"%s\", expected an extended regular expression: %s", text, why);
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct selection *s = (struct selection *)state->input;
    switch (key) {
    case CLASS:
        s->class_name = text;
        return 0;
    case ID:
        s->id = text;
        return 0;
    case FILTER:
        set_filter(s, text, state);
        return 0;
    case ARGP_KEY_ARGS:
        s->files = state->argv + state->next;
        s->file_count = state->argc - state->next;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp selection_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};

bool selection_is_narrowed(const struct selection *s)
{
    return s->class_name || s->id || s->filter;
}

bool selection_takes(const struct selection *s, const struct test_case *c)
{
    return (!s->class_name || !strcmp(s->class_name, c->class_name)) &&
           (!s->id || !fnmatch(s->id, c->id, 0)) && (!s->filter || !regexec(&s->regex, c->id, 0, NULL, 0));
}

int selection_files(const struct selection *s)
{
    return s->file_count ? s->file_count : 1;
}

const char *selection_file(const struct selection *s, int i)
{
    return s->file_count ? s->files[i] : "-";
}

int selection_complain(const struct selection *s, const char *program)
{
    enum { SHOWN = 4 };
    const struct {
        const char *option, *value;
    } given[] = {{"--class", s->class_name}, {"--id", s->id}, {"--filter", s->filter}};
    int files = selection_files(s);
    const char *before = " with";
    fprintf(stderr, "%s: no case in", program);
    for (int i = 0; i < files && i < SHOWN; i++)
        fprintf(stderr, "%s %s", i ? "," : "",
                strcmp(selection_file(s, i), "-") ? selection_file(s, i) : "standard input");
    if (files > SHOWN)
        fprintf(stderr, " and %d more", files - SHOWN);
    for (size_t i = 0; i < sizeof given / sizeof *given; i++)
        if (given[i].value) {
            fprintf(stderr, "%s %s '%s'", before, given[i].option, given[i].value);
            before = ",";
        }
    fputc('\n', stderr);
    return BAD_DATA;
}

void selection_clear(struct selection *s)
{
    if (s->filter)
        regfree(&s->regex);
    s->filter = NULL;
}
