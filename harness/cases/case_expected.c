/* What a line says of its solutions: the object `expected`. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "case.h"
#include "case_fields.h"
#include "number.h"
#include "../run/memory.h"

enum { COUNT_MAX = 1 << 16 };

/* Texts of the field `exact` are the solution itself ("29/50", "0.25"), or rounded to 40 digits. */
static bool is_rounded(const char *text)
{
    enum { ROUNDED_DIGITS = 30 };
    int digits = 0;
    if (strpbrk(text, "/xX"))
        return false;
    for (; *text && *text != 'e' && *text != 'E'; text++)
        digits += *text >= '0' && *text <= '9';
    return digits >= ROUNDED_DIGITS;
}

/* One parameter: from `exact` where that is a text, else from `params`. */
static bool read_parameter(const struct fields *r, const json_t *exact, const json_t *params, int i, int k,
                           mpq_t q, bool *is_exact)
{
    char field[FIELD_MAX];
    const json_t *v = json_array_get(json_array_get(exact, (size_t)i), (size_t)k);
    if (v && !json_is_null(v)) {
        snprintf(field, sizeof field, "expected.exact[%d][%d]", i, k);
        *is_exact = *is_exact && json_is_string(v) && !is_rounded(json_string_value(v));
        return fields_rational(r, field, v, q);
    }
    *is_exact = false;
    snprintf(field, sizeof field, "expected.params[%d]", i);
    v = json_array_get(params, (size_t)i);
    if (!fields_array(r, field, v, 2))
        return false;
    snprintf(field, sizeof field, "expected.params[%d][%d]", i, k);
    return fields_rational(r, field, json_array_get(v, (size_t)k), q);
}

static bool read_solution(const struct fields *r, const json_t *v, int i, struct case_solution *a)
{
    char field[FIELD_MAX];
    const json_t *exact = json_object_get(v, "exact"), *params = json_object_get(v, "params");
    const json_t *mult = json_array_get(json_object_get(v, "mult"), (size_t)i);
    const json_t *cond = json_array_get(json_object_get(v, "cond"), (size_t)i);
    const json_t *sine = json_array_get(json_object_get(v, "sin"), (size_t)i);
    const json_t *entry = json_array_get(exact, (size_t)i);

    snprintf(field, sizeof field, "expected.exact[%d]", i);
    if (entry && !json_is_null(entry) && !fields_array(r, field, entry, 2))
        return false;
    a->exact = true;
    if (!read_parameter(r, exact, params, i, 0, a->t, &a->exact) ||
        !read_parameter(r, exact, params, i, 1, a->s, &a->exact))
        return false;
    snprintf(field, sizeof field, "expected.mult[%d]", i);
    if (mult && !json_is_null(mult) && !fields_integer(r, field, mult, 0, 1 << 20, &a->multiplicity))
        return false;
    snprintf(field, sizeof field, "expected.cond[%d]", i);
    if (cond && !fields_double(r, field, cond, &a->cond))
        return false;
    snprintf(field, sizeof field, "expected.sin[%d]", i);
    return !sine || fields_double(r, field, sine, &a->sine);
}

static int compare_solutions(const void *a, const void *b)
{
    const struct case_solution *p = a, *q = b;
    int order = mpq_cmp(p->t, q->t);
    return order ? order : mpq_cmp(p->s, q->s);
}

/* count, or else as many as there are parameters; the lists of one entry a solution are as long. */
static bool read_count(const struct fields *r, const json_t *v, int *count)
{
    static const char *const lists[] = {"params", "exact", "mult", "cond", "sin"};
    char field[FIELD_MAX];
    const json_t *given = json_object_get(v, "count");
    if (given && !fields_integer(r, "expected.count", given, 0, COUNT_MAX, count))
        return false;
    if (!given) {
        const json_t *params = json_object_get(v, "params");
        const char *name = params ? "expected.params" : "expected.count";
        if (!params || !fields_array(r, name, params, -1))
            return params ? false : fields_complain(r, name, "missing, expected the number of solutions");
        *count = (int)json_array_size(params);
    }
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++) {
        const json_t *list = json_object_get(v, lists[k]);
        snprintf(field, sizeof field, "expected.%s", lists[k]);
        if (list && !json_is_null(list) && !fields_array(r, field, list, *count))
            return false;
    }
    if (*count > 0 && !json_is_array(json_object_get(v, "params")) &&
        !json_is_array(json_object_get(v, "exact")))
        return fields_complain(r, "expected.params", "missing, expected %d pairs [t, s]", *count);
    return true;
}

static bool read_overlap(const struct fields *r, const json_t *v, int i, struct case_overlap *o)
{
    char field[FIELD_MAX];
    mpq_ptr end[4] = {o->t0, o->t1, o->s0, o->s1};
    snprintf(field, sizeof field, "expected.overlap[%d]", i);
    if (!fields_array(r, field, v, 4))
        return false;
    for (int k = 0; k < 4; k++) {
        snprintf(field, sizeof field, "expected.overlap[%d][%d]", i, k);
        if (!fields_rational(r, field, json_array_get(v, (size_t)k), end[k]))
            return false;
    }
    snprintf(field, sizeof field, "expected.overlap[%d]", i);
    if (mpq_cmp(o->t0, o->t1) > 0)
        return fields_complain(r, field, "t0 > t1, expected t0 <= t1 (s0 > s1 when reversed)");
    return true;
}

static bool read_overlaps(const struct fields *r, const json_t *v, struct case_expected *e)
{
    if (!v || json_is_null(v))
        return true;
    if (!fields_array(r, "expected.overlap", v, -1))
        return false;
    e->overlaps = (int)json_array_size(v);
    e->overlap = memory_new((size_t)e->overlaps, sizeof *e->overlap);
    for (int i = 0; i < e->overlaps; i++)
        mpq_inits(e->overlap[i].t0, e->overlap[i].t1, e->overlap[i].s0, e->overlap[i].s1, NULL);
    for (int i = 0; i < e->overlaps; i++)
        if (!read_overlap(r, json_array_get(v, (size_t)i), i, &e->overlap[i]))
            return false;
    return true;
}

bool expected_read(const struct fields *r, const json_t *v, struct case_expected *e)
{
    int count;
    e->tol = NAN;
    if (!v || json_is_null(v))
        return true;
    if (!json_is_object(v))
        return fields_complain(r, "expected", "%s, expected an object", fields_type(v));
    if (!read_count(r, v, &count))
        return false;
    e->at = memory_new((size_t)count, sizeof *e->at);
    for (e->count = 0; e->count < count; e->count++) {
        struct case_solution *a = &e->at[e->count];
        mpq_inits(a->t, a->s, NULL);
        a->cond = a->sine = NAN;
    }
    for (int i = 0; i < count; i++)
        if (!read_solution(r, v, i, &e->at[i]))
            return false;
    qsort(e->at, (size_t)count, sizeof *e->at, compare_solutions);

    const json_t *tol = json_object_get(v, "tol");
    if (tol && !fields_double(r, "expected.tol", tol, &e->tol))
        return false;
    if (e->tol < 0)
        return fields_complain(r, "expected.tol", "%g, expected a number >= 0 or null", e->tol);
    e->known = true;
    return read_overlaps(r, json_object_get(v, "overlap"), e);
}

void case_expected_clear(struct case_expected *e)
{
    for (int i = 0; i < e->count; i++)
        mpq_clears(e->at[i].t, e->at[i].s, NULL);
    for (int i = 0; i < e->overlaps; i++)
        mpq_clears(e->overlap[i].t0, e->overlap[i].t1, e->overlap[i].s0, e->overlap[i].s1, NULL);
    free(e->at);
    free(e->overlap);
    memset(e, 0, sizeof *e);
    e->tol = NAN;
}

/* A contact: multiplicity above 1, parallel tangents, or no tangent at all. */
static bool has_contact(const struct test_case *c)
{
    if (!strcmp(c->class_name, "tangent") || !strcmp(c->class_name, "degenerate"))
        return true;
    for (int i = 0; i < c->expected.count; i++)
        if (c->expected.at[i].multiplicity > 1 || c->expected.at[i].sine == 0)
            return true;
    return false;
}

double case_tolerance(const struct test_case *c, double asked)
{
    double tol = c->expected.tol;
    if (isnan(tol)) {
        double cond = 0;
        for (int i = 0; i < c->expected.count; i++)
            cond = fmax(cond, c->expected.at[i].cond); /* fmax passes over NAN */
        tol = has_contact(c) ? 1e-6 : 1e-12 * (1 + cond);
    }
    return fmax(asked, tol);
}
