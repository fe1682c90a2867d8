/* Two runs, by their rows.  The machine may have changed between them, so each time is divided by that of a
 * reference algorithm from the same rounds; or instructions are compared, which do not depend on the machine.
 */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare.h"
#include "statistics.h"

static const double level = 0.99;
static const double floor_unknown = 0.05;       /* of a run whose machine `doctor` did not see */
static const double floor_instructions = 0.001; /* start-up that the difference of two runs does not cancel */

enum { FAILED = 2, USAGE = 64, BAD_DATA = 65 };

struct run {
    json_t *rows; /* array */
    double floor;
};

static const char *text(const json_t *row, const char *key)
{
    const char *value = json_string_value(json_object_get(row, key));
    return value ? value : "";
}

/* 0 or an exit status. */
static int run_read(struct run *r, const char *path)
{
    FILE *file = fopen(path, "r");
    char *line = NULL;
    size_t size = 0;
    int number = 0, status = file ? 0 : FAILED;
    r->rows = json_array();
    r->floor = floor_unknown;
    while (file && status == 0 && getline(&line, &size, file) > 0) {
        json_t *row = json_loads(line, JSON_DECODE_ANY, NULL);
        const json_t *environment = json_object_get(row, "environment");
        number++;
        if (!row || (!environment && (!*text(row, "family") || !*text(row, "algorithm")))) {
            fprintf(stderr, "%s:%d: %s, expected a row of `fatline time`\n", path, number,
                    row ? "row: no family and algorithm" : "line: not JSON");
            status = BAD_DATA;
        }
        if (json_is_number(json_object_get(environment, "noise_floor")))
            r->floor = json_number_value(json_object_get(environment, "noise_floor"));
        if (!environment && status == 0)
            json_array_append(r->rows, row);
        json_decref(row);
    }
    if (!file || ferror(file)) {
        perror(path);
        status = FAILED;
    }
    if (file)
        fclose(file);
    free(line);
    return status;
}

/* The row of the same family, precision and algorithm (NULL: as `like`). */
static json_t *find(const struct run *r, const json_t *like, const char *algorithm)
{
    size_t i;
    json_t *row;
    json_array_foreach(r->rows, i, row)
    {
        if (!strcmp(text(row, "family"), text(like, "family")) &&
            !strcmp(text(row, "precision"), text(like, "precision")) &&
            !strcmp(text(row, "algorithm"), algorithm ? algorithm : text(like, "algorithm")) &&
            json_array_size(json_object_get(row, "samples")) > 0)
            return row;
    }
    return NULL;
}

/* Median of the row's samples by the reference's of the same rounds, and the logarithmic half width of its
 * interval; NAN if they have none in common. */
static double relative(const json_t *row, const json_t *reference, uint64_t seed, double *width)
{
    const json_t *a = json_object_get(row, "samples"), *b = json_object_get(reference, "samples");
    size_t n = json_array_size(a);
    double *q = (double *)calloc(n + 1, sizeof *q), median = NAN;
    if (q && reference && n > 0 && json_array_size(b) == n) {
        for (size_t i = 0; i < n; i++)
            q[i] = json_number_value(json_array_get(a, i)) / json_number_value(json_array_get(b, i));
        struct range range = statistics_bootstrap_median((int)n, q, level, seed);
        median = statistics_median((int)n, q);
        *width = fmax(log(range.hi / median), log(median / range.lo));
    }
    free(q);
    return median;
}

static bool by_reference(const struct compare_settings *s, const struct run run[2], const json_t *row,
                         const json_t *other, struct comparison *c)
{
    double width[2];
    double first = relative(row, find(&run[0], row, s->reference), s->seed, &width[0]);
    double second = relative(other, find(&run[1], other, s->reference), s->seed, &width[1]);
    double both = hypot(width[0], width[1]);
    c->what = "reference";
    c->ratio = second / first;
    c->lo = c->ratio * exp(-both);
    c->hi = c->ratio * exp(both);
    c->floor = isnan(s->floor) ? (1 + run[0].floor) * (1 + run[1].floor) - 1 : s->floor;
    return isfinite(c->ratio);
}

static bool by_instructions(const struct compare_settings *s, const json_t *row, const json_t *other,
                            struct comparison *c)
{
    const json_t *a = json_object_get(row, "instructions"), *b = json_object_get(other, "instructions");
    c->what = "instructions";
    c->ratio = c->lo = c->hi = json_number_value(b) / json_number_value(a);
    c->floor = isnan(s->floor) ? floor_instructions : s->floor;
    return json_is_number(a) && json_is_number(b);
}

static bool has(const struct run *r, const char *algorithm)
{
    size_t i;
    json_t *row;
    json_array_foreach(r->rows, i, row)
    {
        if (!strcmp(text(row, "algorithm"), algorithm) &&
            json_array_size(json_object_get(row, "samples")) > 0)
            return true;
    }
    return false;
}

/* "a, b, c": who was timed in both runs; "" if nobody. */
static void names_of_both(const struct run run[2], char *names, size_t size)
{
    size_t i, used = 0;
    json_t *row, *seen = json_object();
    names[0] = 0;
    json_array_foreach(run[0].rows, i, row)
    {
        const char *name = text(row, "algorithm");
        if (json_object_get(seen, name) || !has(&run[0], name) || !has(&run[1], name))
            continue;
        json_object_set_new(seen, name, json_true());
        if (used < size)
            used += (size_t)snprintf(names + used, size - used, "%s%s", used ? ", " : "", name);
    }
    json_decref(seen);
}

/* Whose times divide the others'; 0 or an exit status. */
static int choose_reference(struct compare_settings *s, const struct run run[2])
{
    const bool asked = s->reference != NULL;
    char names[2000];
    if (!asked)
        s->reference = intersector_floor->name;
    if (has(&run[0], s->reference) && has(&run[1], s->reference))
        return 0;
    names_of_both(run, names, sizeof names);
    if (asked)
        fprintf(stderr, "fatline compare: --reference: %s is not timed in both files; ", s->reference);
    else
        fprintf(stderr,
                "fatline compare: %s is not timed in both files; --reference NAME or --instructions is "
                "needed; ",
                s->reference);
    fprintf(stderr, names[0] ? "both have %s\n" : "they have nobody in common%s\n", names);
    return names[0] || asked ? USAGE : 0;
}

/* 0 or an exit status. */
static int need_instructions(const struct compare_settings *s, const struct run run[2])
{
    for (int k = 0; k < 2; k++) {
        bool counted = false;
        size_t i;
        json_t *row;
        json_array_foreach(run[k].rows, i, row) counted =
            counted || json_is_number(json_object_get(row, "instructions"));
        if (!counted) {
            fprintf(stderr,
                    "%s: instructions: in no row, expected rows of `fatline time --count instructions`\n",
                    s->file[k]);
            return BAD_DATA;
        }
    }
    return 0;
}

static void compare_row(const struct compare_settings *s, const struct run run[2], const json_t *row,
                        int *compared, int *slower)
{
    const json_t *other = find(&run[1], row, NULL);
    struct comparison c;
    memset(&c, 0, sizeof c);
    c.family = text(row, "family");
    c.algorithm = text(row, "algorithm");
    c.pairs = (int)json_integer_value(json_object_get(row, "pairs"));
    if (!other || (!s->instructions && !strcmp(c.algorithm, s->reference)) ||
        !(s->instructions ? by_instructions(s, row, other, &c) : by_reference(s, run, row, other, &c)))
        return;
    comparison_write(s, &c);
    *compared += 1;
    *slower += comparison_change(&c) == SLOWER;
}

int compare_files(struct compare_settings *s, int *compared, int *slower)
{
    struct run run[2] = {{NULL, 0}, {NULL, 0}};
    size_t i;
    json_t *row;
    int status = 0;
    for (int k = 0; k < 2 && !status; k++)
        status = run_read(&run[k], s->file[k]);
    if (!status)
        status = s->instructions ? need_instructions(s, run) : choose_reference(s, run);
    if (!status)
        json_array_foreach(run[0].rows, i, row) compare_row(s, run, row, compared, slower);
    json_decref(run[0].rows);
    json_decref(run[1].rows);
    return status;
}
