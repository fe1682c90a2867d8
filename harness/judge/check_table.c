#include "check_table.h"
#include "../run/memory.h"

#include <stdlib.h>
#include <string.h>

/* What a column counts: a verdict, or a field summed up. */
enum column {
    CASES,
    RIGHT_,
    WRONG_,
    STOPPED_,
    NOT_TAKEN_,
    UNJUDGED_,
    BROKEN_,
    MISSED,
    EXTRA,
    DUPLICATE,
    MERGED,
    UNDECIDED,
    STEPS
};

static const struct {
    const char *title, *verdict, *field;
} columns[TABLE_COLUMNS] = {{"cases", NULL, NULL},
                            {"right", "RIGHT", NULL},
                            {"wrong", "WRONG", NULL},
                            {"stopped", "STOPPED", NULL},
                            {"not taken", "NOT_TAKEN", NULL},
                            {"unjudged", "UNJUDGED", NULL},
                            {"broken", "BROKEN", NULL},
                            {"missed", NULL, "missed"},
                            {"extra", NULL, "extra"},
                            {"duplicate", NULL, "duplicate"},
                            {"merged", NULL, "merged"},
                            {"undecided", NULL, "undecided"},
                            {"steps", NULL, "steps"}};

static const char *text_of(const json_t *row, const char *field)
{
    const char *text = json_string_value(json_object_get(row, field));
    return text ? text : "";
}

static struct table_line *line_of(struct check_table *t, const char *class_name, const char *algorithm,
                                  bool ambiguous)
{
    for (int i = 0; i < t->count; i++)
        if (!strcmp(t->at[i].class_name, class_name) && !strcmp(t->at[i].algorithm, algorithm) &&
            t->at[i].ambiguous == ambiguous)
            return &t->at[i];
    if (t->count == t->room) {
        t->room = 2 * t->room + 16;
        t->at = (struct table_line *)memory_need(realloc(t->at, (size_t)t->room * sizeof *t->at));
    }
    struct table_line *line = &t->at[t->count++];
    memset(line, 0, sizeof *line);
    line->class_name = (char *)memory_need(strdup(class_name));
    line->algorithm = (char *)memory_need(strdup(algorithm));
    line->ambiguous = ambiguous;
    line->max_error = -1;
    return line;
}

void check_table_add(struct check_table *t, const json_t *row)
{
    struct table_line *line = line_of(t, text_of(row, "class"), text_of(row, "algorithm"),
                                      json_is_true(json_object_get(row, "ambiguous")));
    const json_t *error = json_object_get(row, "max_error");
    line->sum[CASES]++;
    for (int i = CASES + 1; i < TABLE_COLUMNS; i++)
        if (columns[i].field)
            line->sum[i] += (long)json_integer_value(json_object_get(row, columns[i].field));
        else
            line->sum[i] += !strcmp(text_of(row, "verdict"), columns[i].verdict);
    line->violated += (long)json_integer_value(json_object_get(row, "violated"));
    if (json_is_number(error) && json_number_value(error) > line->max_error)
        line->max_error = json_number_value(error);
}

/* ---- writing ---------------------------------------------------------------------------------------------
 */

static void write_line(const struct table_line *line, bool strict, int name_width, FILE *stream)
{
    fprintf(stream, "%-*s ", name_width, line->algorithm);
    for (int i = 0; i < TABLE_COLUMNS; i++)
        fprintf(stream, " %*ld", (int)(i == STEPS ? 10 : strlen(columns[i].title)), line->sum[i]);
    if (line->max_error >= 0)
        fprintf(stream, "  %9.2g", line->max_error);
    else
        fprintf(stream, "  %9s", "-");
    if (strict)
        fprintf(stream, "  %8ld", line->violated);
    fputc('\n', stream);
}

static void write_head(const char *title, bool ambiguous, bool strict, int name_width, FILE *stream)
{
    char name[128];
    snprintf(name, sizeof name, "%s%s", *title ? title : "(no class)", ambiguous ? ", ambiguous" : "");
    fprintf(stream, "%-*s ", name_width, name);
    for (int i = 0; i < TABLE_COLUMNS; i++)
        fprintf(stream, " %*s", i == STEPS ? 10 : 0, columns[i].title);
    fprintf(stream, "  max error%s\n", strict ? "  violated" : "");
}

static void accumulate(struct table_line *sum, const struct table_line *line)
{
    for (int i = 0; i < TABLE_COLUMNS; i++)
        sum->sum[i] += line->sum[i];
    sum->violated += line->violated;
    if (line->max_error > sum->max_error)
        sum->max_error = line->max_error;
}

/* The lines of one class in the order of their first rows, once for the first line of that class. */
static void write_class(const struct check_table *t, int first, int name_width, FILE *stream)
{
    const struct table_line *of = &t->at[first];
    for (int i = 0; i < first; i++)
        if (!strcmp(t->at[i].class_name, of->class_name) && t->at[i].ambiguous == of->ambiguous)
            return;
    write_head(of->class_name, of->ambiguous, t->strict, name_width, stream);
    for (int i = first; i < t->count; i++)
        if (!strcmp(t->at[i].class_name, of->class_name) && t->at[i].ambiguous == of->ambiguous)
            write_line(&t->at[i], t->strict, name_width, stream);
    fputc('\n', stream);
}

/* Is there anything to be summed up? */
static bool has_several_classes(const struct check_table *t)
{
    const char *first = NULL;
    for (int i = 0; i < t->count; i++)
        if (!t->at[i].ambiguous && !first)
            first = t->at[i].class_name;
        else if (!t->at[i].ambiguous && strcmp(t->at[i].class_name, first))
            return true;
    return false;
}

/* Sums over the classes, ambiguous cases left out. */
static void write_sums(const struct check_table *t, int name_width, FILE *stream)
{
    struct check_table sums;
    memset(&sums, 0, sizeof sums);
    sums.strict = t->strict;
    for (int i = 0; i < t->count; i++)
        if (!t->at[i].ambiguous)
            accumulate(line_of(&sums, "all classes", t->at[i].algorithm, false), &t->at[i]);
    for (int i = 0; i < sums.count; i++)
        write_class(&sums, i, name_width, stream);
    check_table_clear(&sums);
}

void check_table_write(const struct check_table *t, FILE *stream)
{
    int name_width = 24;
    for (int i = 0; i < t->count; i++)
        if ((int)strlen(t->at[i].algorithm) > name_width)
            name_width = (int)strlen(t->at[i].algorithm);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < t->count; i++)
            if (t->at[i].ambiguous == (pass == 1))
                write_class(t, i, name_width, stream);
    if (has_several_classes(t))
        write_sums(t, name_width, stream);
}

bool check_table_failed(const struct check_table *t)
{
    for (int i = 0; i < t->count; i++)
        if (t->at[i].sum[BROKEN_] ||
            (!t->at[i].ambiguous && (t->at[i].sum[MISSED] || t->at[i].sum[EXTRA] || t->at[i].violated)))
            return true;
    return false;
}

long check_table_unjudged(const struct check_table *t)
{
    long count = 0;
    for (int i = 0; i < t->count; i++)
        count += t->at[i].sum[UNJUDGED_];
    return count;
}

void check_table_clear(struct check_table *t)
{
    for (int i = 0; i < t->count; i++) {
        free(t->at[i].class_name);
        free(t->at[i].algorithm);
    }
    free(t->at);
    memset(t, 0, sizeof *t);
}
