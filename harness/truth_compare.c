/* Differences between the truth a line carries and the truth found afresh. */
#include "truth_compare.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

struct comparison {
    FILE *stream;
    const struct test_case *said, *found;
    double within;
    int differences;
};

static void differ(struct comparison *d, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(d->stream, "%s:%d: %s: ", d->said->file, d->said->line_number, d->said->id ? d->said->id : "?");
    vfprintf(d->stream, format, list);
    fputc('\n', d->stream);
    va_end(list);
    d->differences++;
}

static bool is_near(const mpq_t a, const mpq_t b, double within)
{
    mpq_t distance, bound;
    mpq_inits(distance, bound, NULL);
    mpq_sub(distance, a, b);
    mpq_abs(distance, distance);
    mpq_set_d(bound, within);
    bool near = mpq_cmp(distance, bound) <= 0;
    mpq_clears(distance, bound, NULL);
    return near;
}

/* The first of `count` solutions from `from` on near (t, s), -1 if there is none. */
static int find_near(const struct comparison *d, const struct case_expected *e, const mpq_t t, const mpq_t s,
                     const bool *taken)
{
    for (int i = 0; i < e->count; i++)
        if (!(taken && taken[i]) && is_near(e->at[i].t, t, d->within) && is_near(e->at[i].s, s, d->within))
            return i;
    return -1;
}

static void compare_solutions(struct comparison *d, const struct case_expected *a,
                              const struct case_expected *b)
{
    bool *taken = calloc((size_t)b->count + 1, sizeof *taken);
    if (a->count != b->count)
        differ(d, "count: the line says %d, found %d", a->count, b->count);
    for (int i = 0; i < a->count; i++) {
        const struct case_solution *x = &a->at[i];
        int j = find_near(d, b, x->t, x->s, taken);
        if (j < 0) {
            differ(d, "solution (%.17g, %.17g) of the line not found", mpq_get_d(x->t), mpq_get_d(x->s));
            continue;
        }
        taken[j] = true;
        if (x->multiplicity && b->at[j].multiplicity && x->multiplicity != b->at[j].multiplicity)
            differ(d, "mult at (%.17g, %.17g): the line says %d, found %d", mpq_get_d(x->t), mpq_get_d(x->s),
                   x->multiplicity, b->at[j].multiplicity);
        if (!isnan(x->sine) && !isnan(b->at[j].sine) && fabs(x->sine - b->at[j].sine) > 1e-6)
            differ(d, "sin at (%.17g, %.17g): the line says %g, found %g", mpq_get_d(x->t), mpq_get_d(x->s),
                   x->sine, b->at[j].sine);
    }
    for (int j = 0; j < b->count; j++)
        if (!taken[j])
            differ(d, "solution (%.17g, %.17g) found, not in the line", mpq_get_d(b->at[j].t),
                   mpq_get_d(b->at[j].s));
    free(taken);
}

static json_int_t places_of(const struct test_case *c)
{
    const json_t *count = json_object_get(json_object_get(c->line, "expected"), "distinct_points");
    return count ? json_integer_value(count) : -1;
}

static void compare_places(struct comparison *d)
{
    json_int_t said = places_of(d->said), found = places_of(d->found);
    if (said >= 0 && said != found)
        differ(d, "distinct_points: the line says %d, found %d", (int)said, (int)found);
}

static bool same_overlap(const struct comparison *d, const struct case_overlap *a,
                         const struct case_overlap *b)
{
    return is_near(a->t0, b->t0, d->within) && is_near(a->t1, b->t1, d->within) &&
           is_near(a->s0, b->s0, d->within) && is_near(a->s1, b->s1, d->within);
}

static bool has_overlap(const struct comparison *d, const struct case_expected *e,
                        const struct case_overlap *a)
{
    for (int i = 0; i < e->overlaps; i++)
        if (same_overlap(d, &e->overlap[i], a))
            return true;
    return false;
}

static void compare_overlaps(struct comparison *d, const struct case_expected *a,
                             const struct case_expected *b)
{
    const struct case_expected *in[2] = {a, b};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < in[k]->overlaps; i++) {
            const struct case_overlap *o = &in[k]->overlap[i];
            if (!has_overlap(d, in[1 - k], o))
                differ(d, "overlap [%.17g, %.17g, %.17g, %.17g] %s", mpq_get_d(o->t0), mpq_get_d(o->t1),
                       mpq_get_d(o->s0), mpq_get_d(o->s1),
                       k ? "found, not in the line" : "of the line not found");
        }
}

/* A text or a number of the line as a rational. */
static bool read_number(const json_t *v, mpq_t q)
{
    if (json_is_string(v))
        return number_parse(json_string_value(v), q);
    if (!json_is_number(v))
        return false;
    mpq_set_d(q, json_number_value(v));
    return true;
}

static void compare_planted_point(struct comparison *d, const json_t *v)
{
    mpq_t t, s;
    mpq_inits(t, s, NULL);
    const json_t *mult = json_object_get(v, "mult");
    if (!read_number(json_object_get(v, "t"), t) || !read_number(json_object_get(v, "s"), s)) {
        differ(d, "planted: no t and s, expected numbers");
    } else {
        int i = find_near(d, &d->found->expected, t, s, NULL);
        if (i < 0)
            differ(d, "planted solution (%.17g, %.17g) not found", mpq_get_d(t), mpq_get_d(s));
        else if (mult && json_integer_value(mult) != d->found->expected.at[i].multiplicity)
            differ(d, "mult of the planted solution (%.17g, %.17g): the line says %d, found %d", mpq_get_d(t),
                   mpq_get_d(s), (int)json_integer_value(mult), d->found->expected.at[i].multiplicity);
    }
    mpq_clears(t, s, NULL);
}

static void compare_planted(struct comparison *d)
{
    const json_t *points = json_object_get(d->said->line, "planted");
    const json_t *arc = json_object_get(d->said->line, "planted_overlap");
    const json_t *count = json_object_get(d->said->line, "planted_count");
    for (size_t i = 0; i < json_array_size(points); i++)
        compare_planted_point(d, json_array_get(points, i));
    if (count && json_integer_value(count) != d->found->expected.count)
        differ(d, "planted_count is %d, found %d", (int)json_integer_value(count), d->found->expected.count);
    if (!arc)
        return;
    struct case_overlap o;
    mpq_inits(o.t0, o.t1, o.s0, o.s1, NULL);
    if (!read_number(json_array_get(arc, 0), o.t0) || !read_number(json_array_get(arc, 1), o.t1) ||
        !read_number(json_array_get(arc, 2), o.s0) || !read_number(json_array_get(arc, 3), o.s1))
        differ(d, "planted_overlap: expected [t0, t1, s0, s1]");
    else if (!has_overlap(d, &d->found->expected, &o))
        differ(d, "planted overlap [%.17g, %.17g, %.17g, %.17g] not found", mpq_get_d(o.t0), mpq_get_d(o.t1),
               mpq_get_d(o.s0), mpq_get_d(o.s1));
    mpq_clears(o.t0, o.t1, o.s0, o.s1, NULL);
}

int truth_compare(FILE *stream, const struct test_case *said, const struct test_case *found, double within)
{
    struct comparison d = {stream, said, found, within, 0};
    if (said->class_name && said->class_name[0] && strcmp(said->class_name, found->class_name))
        differ(&d, "class: the line says %s, found %s", said->class_name, found->class_name);
    if (said->expected.known) {
        compare_solutions(&d, &said->expected, &found->expected);
        compare_overlaps(&d, &said->expected, &found->expected);
        compare_places(&d);
    }
    compare_planted(&d);
    return d.differences;
}
