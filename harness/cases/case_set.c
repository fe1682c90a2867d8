/* See case_set.h. */
#include "case_set.h"
#include "../run/memory.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *remember_file(struct case_set *set, const char *path)
{
    set->file = (char **)memory_need(realloc(set->file, (set->files + 1) * sizeof *set->file));
    return set->file[set->files++] = (char *)memory_need(strdup(path));
}

static struct loaded_case *new_case(struct case_set *set)
{
    if (set->count == set->room) {
        set->room = set->room ? 2 * set->room : 64;
        set->at = (struct loaded_case *)memory_need(realloc(set->at, set->room * sizeof *set->at));
    }
    return &set->at[set->count];
}

/* Takes over `read` if it is a problem. */
static int add(struct case_set *set, struct test_case *read, const char *file, real tolerance, int max_steps)
{
    struct loaded_case *to = new_case(set);
    const char *why_not = owned_problem_make(read, tolerance, max_steps, &to->owned);

    if (why_not) {
        fprintf(stderr, "%s:%d: %s\n", file, read->line_number, why_not);
        case_clear(read);
        return 65;
    }
    to->c = *read;
    to->file = file;
    to->line = (char *)memory_need(json_dumps(read->line, JSON_COMPACT));
    if (read->f.degree > set->degree_f)
        set->degree_f = read->f.degree;
    if (read->g.degree > set->degree_g)
        set->degree_g = read->g.degree;
    set->count++;
    return 0;
}

int case_set_read(struct case_set *set, const char *path, real tolerance, int max_steps)
{
    bool standard = !strcmp(path, "-");
    const char *file = remember_file(set, standard ? "stdin" : path);
    FILE *stream = standard ? stdin : fopen(path, "r");
    struct case_reader reader;
    struct test_case read;
    enum case_status status;
    int worst = 0;

    if (!stream) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        return 2;
    }
    case_reader_init(&reader, stream, file);
    while ((status = case_read(&reader, &read)) != CASE_END) {
        if (status == CASE_BAD) {
            fprintf(stderr, "%s\n", reader.error);
            worst = 65;
        } else if (add(set, &read, file, tolerance, max_steps)) {
            worst = 65;
        }
    }
    case_reader_clear(&reader);
    if (ferror(stream)) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        worst = 2;
    }
    if (!standard)
        fclose(stream);
    return worst;
}

void case_set_shorten(struct case_set *set, int count)
{
    for (int i = count; i < set->count; i++) {
        owned_problem_clear(&set->at[i].owned);
        case_clear(&set->at[i].c);
        free(set->at[i].line);
    }
    set->count = count;
}

void case_set_clear(struct case_set *set)
{
    case_set_shorten(set, 0);
    for (int i = 0; i < set->files; i++)
        free(set->file[i]);
    free(set->at);
    free(set->file);
    memset(set, 0, sizeof *set);
}
