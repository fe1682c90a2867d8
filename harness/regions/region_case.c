#include "region_case.h"

#include <stdlib.h>
#include <string.h>

#include "../../algorithms/bezier.h"
#include "../cases/case_fields.h"
#include "../run/memory.h"

enum { POINTS_MAX = 4096 };

static bool is_given(const json_t *v)
{
    return v && !json_is_null(v);
}

static bool read_rationals(const struct fields *r, const char *name, const json_t *v, int n, mpq_t *out)
{
    char field[FIELD_MAX];
    if (!fields_array(r, name, v, n))
        return false;
    for (int i = 0; i < n; i++) {
        snprintf(field, sizeof field, "%s[%d]", name, i);
        if (!fields_rational(r, field, json_array_get(v, (size_t)i), out[i]))
            return false;
    }
    return true;
}

static bool read_points(const struct fields *r, const json_t *line, struct region_case *c)
{
    char field[FIELD_MAX];
    const json_t *points = json_object_get(line, "points");
    if (!fields_array(r, "points", points, -1))
        return false;
    size_t n = json_array_size(points);
    if (n < 2 || n > POINTS_MAX)
        return fields_complain(r, "points", "%zu points, expected 2 to %d", n, POINTS_MAX);
    c->count = (int)n;
    c->x = rationals_new(c->count);
    c->y = rationals_new(c->count);
    c->w = rationals_new(c->count);
    for (int i = 0; i < c->count; i++) {
        const json_t *point = json_array_get(points, (size_t)i);
        snprintf(field, sizeof field, "points[%d]", i);
        if (!fields_array(r, field, point, 2))
            return false;
        for (int k = 0; k < 2; k++) {
            snprintf(field, sizeof field, "points[%d][%d]", i, k);
            if (!fields_rational(r, field, json_array_get(point, (size_t)k), k ? c->y[i] : c->x[i]))
                return false;
        }
    }
    return true;
}

static bool read_degree(const struct fields *r, const json_t *line, struct region_case *c)
{
    const json_t *v = json_object_get(line, "degree");
    bool bezier = !is_given(json_object_get(line, "knots"));
    c->degree = c->count - 1;
    if (!v && bezier && c->degree >= 2 && c->degree <= DEGREE_MAX)
        return true;
    if (!v && bezier)
        return fields_complain(r, "points", "%d, expected 3 to %d (degree 2 to %d)", c->count, DEGREE_MAX + 1,
                               DEGREE_MAX);
    if (!fields_integer(r, "degree", v, 2, DEGREE_MAX, &c->degree))
        return false;
    if (c->count < c->degree + 1 || (bezier && c->count != c->degree + 1))
        return fields_complain(r, "points", "%d points, degree %d needs %d%s", c->count, c->degree,
                               c->degree + 1, bezier ? "" : " or more");
    return true;
}

/* 0 and 1, degree + 1 times each, unless the line says otherwise. */
static bool read_knots(const struct fields *r, const json_t *line, struct region_case *c)
{
    char field[FIELD_MAX];
    const json_t *v = json_object_get(line, "knots");
    int n = c->count + c->degree + 1, run = 1;
    c->knots = rationals_new(n);
    for (int i = c->count; i < n; i++)
        mpq_set_ui(c->knots[i], 1, 1);
    if (!is_given(v))
        return true;
    if (!read_rationals(r, "knots", v, n, c->knots))
        return false;
    for (int i = 1; i < n; i++) {
        snprintf(field, sizeof field, "knots[%d]", i);
        if (mpq_cmp(c->knots[i - 1], c->knots[i]) > 0)
            return fields_complain(r, field,
                                   "less than the knot before, expected knots that do not decrease");
        run = mpq_equal(c->knots[i - 1], c->knots[i]) ? run + 1 : 1;
        bool inner =
            mpq_cmp(c->knots[i], c->knots[c->degree]) > 0 && mpq_cmp(c->knots[i], c->knots[c->count]) < 0;
        if (run > c->degree && inner)
            return fields_complain(
                r, field, "repeated more than degree times inside, expected %d times at most", c->degree);
    }
    if (mpq_cmp(c->knots[c->degree], c->knots[c->count]) >= 0)
        return fields_complain(r, "knots", "knots[%d] = knots[%d], expected an interval between them",
                               c->degree, c->count);
    return true;
}

static bool read_weights(const struct fields *r, const json_t *line, struct region_case *c)
{
    char field[FIELD_MAX];
    const json_t *v = json_object_get(line, "weights");
    c->rational = is_given(v);
    for (int i = 0; i < c->count; i++)
        mpq_set_ui(c->w[i], 1, 1);
    if (c->rational && !read_rationals(r, "weights", v, c->count, c->w))
        return false;
    for (int i = 0; i < c->count; i++) {
        snprintf(field, sizeof field, "weights[%d]", i);
        if (mpq_sgn(c->w[i]) <= 0)
            return fields_complain(r, field, "a weight that is not positive, expected > 0");
    }
    return true;
}

/* An index, a list of indices, or {"t": parameter}. */
static bool read_free(const struct fields *r, const json_t *line, struct region_case *c)
{
    char field[FIELD_MAX];
    const json_t *v = json_object_get(line, "free");
    if (json_is_object(v)) {
        if (!fields_rational(r, "free.t", json_object_get(v, "t"), c->drag))
            return false;
        if (mpq_cmp(c->drag, c->knots[c->degree]) < 0 || mpq_cmp(c->drag, c->knots[c->count]) > 0)
            return fields_complain(r, "free.t",
                                   "not a parameter of the curve, expected one of the knots' interval");
        return true;
    }
    bool list = json_is_array(v);
    c->members = list ? (int)json_array_size(v) : 1;
    if (c->members < 1 || c->members > c->count)
        return fields_complain(r, "free", "%d entries, expected 1 to %d", c->members, c->count);
    c->member = (int *)memory_new((size_t)c->members, sizeof *c->member);
    for (int i = 0; i < c->members; i++) {
        snprintf(field, sizeof field, list ? "free[%d]" : "free", i);
        if (!fields_integer(r, field, list ? json_array_get(v, (size_t)i) : v, 0, c->count - 1,
                            &c->member[i]))
            return false;
    }
    return true;
}

static bool read_interval(const struct fields *r, const json_t *line, struct region_case *c)
{
    const json_t *v = json_object_get(line, "interval");
    mpq_t ends[2];
    mpq_set(c->lo, c->knots[c->degree]);
    mpq_set(c->hi, c->knots[c->count]);
    if (!is_given(v))
        return true;
    mpq_init(ends[0]);
    mpq_init(ends[1]);
    bool good = read_rationals(r, "interval", v, 2, ends);
    if (good) {
        mpq_set(c->lo, ends[0]);
        mpq_set(c->hi, ends[1]);
    }
    mpq_clear(ends[0]);
    mpq_clear(ends[1]);
    if (!good)
        return false;
    if (mpq_cmp(c->lo, c->hi) >= 0)
        return fields_complain(r, "interval", "empty, expected [a, b] with a < b");
    if (mpq_cmp(c->lo, c->knots[c->degree]) < 0 || mpq_cmp(c->hi, c->knots[c->count]) > 0)
        return fields_complain(r, "interval", "not inside the knots' own interval");
    return true;
}

static bool read_rest(const struct fields *r, const json_t *line, struct region_case *c)
{
    const json_t *sign = json_object_get(line, "sign"), *loop_free = json_object_get(line, "loop_free");
    c->sign = 1;
    if (sign && !fields_integer(r, "sign", sign, -1, 1, &c->sign))
        return false;
    if (c->sign == 0)
        return fields_complain(r, "sign", "0, expected 1 or -1");
    if (loop_free && !json_is_boolean(loop_free))
        return fields_complain(r, "loop_free", "%s, expected true or false", fields_type(loop_free));
    c->loop_free = json_is_true(loop_free);
    bool apart = false;
    for (int i = 1; i < c->count; i++)
        apart = apart || !mpq_equal(c->x[i], c->x[0]) || !mpq_equal(c->y[i], c->y[0]);
    if (!apart)
        return fields_complain(r, "points", "all the same, expected a curve with a length");
    return true;
}

static bool read_id(const struct fields *r, const json_t *line, struct region_case *c)
{
    const json_t *v = json_object_get(line, "id");
    if (!json_is_string(v))
        return fields_complain(r, "id", "%s, expected text", fields_type(v));
    if (!*json_string_value(v))
        return fields_complain(r, "id", "empty text, expected a name");
    c->id = strdup(json_string_value(v));
    return true;
}

/* Of `expected`, the first line is what --check reads; the rest is for readers. */
static bool check_names(const struct fields *r, const json_t *line)
{
    static const char *const known[] = {"id",    "degree",   "knots", "points",    "weights",
                                        "free",  "interval", "sign",  "loop_free", "note",
                                        "check", "expected", NULL};
    static const char *const known_expected[] = {
        "kind",       "closed_kind",     "closed",         "strict_nonempty",
        "edges_ccw",  "vertices",        "vertices_exact", "area",
        "area_exact", "inside",          "outside",        "breaks",
        "pieces",     "corner_turn_deg", "reason",         "strict_empty_reason",
        NULL};
    const json_t *expected = json_object_get(line, "expected");
    if (!fields_are_known(r, "", line, known))
        return false;
    if (is_given(expected) && !json_is_object(expected))
        return fields_complain(r, "expected", "%s, expected an object", fields_type(expected));
    return fields_are_known(r, "expected.", expected, known_expected);
}

enum region_case_status region_case_parse(const char *text, const char *file, int line_number,
                                          struct region_case *c, char error[512])
{
    json_error_t json_error;
    struct fields r = {file, line_number, error};
    memset(c, 0, sizeof *c);
    mpq_init(c->drag);
    mpq_init(c->lo);
    mpq_init(c->hi);
    c->line = json_loads(text, 0, &json_error);
    bool good = json_is_object(c->line);
    if (!c->line)
        snprintf(error, 512, "%s:%d: JSON: %s, near column %d", file, line_number, json_error.text,
                 json_error.column);
    else if (!good)
        fields_complain(&r, "line", "%s, expected an object", fields_type(c->line));
    good = good && check_names(&r, c->line) && read_id(&r, c->line, c) && read_points(&r, c->line, c) &&
           read_degree(&r, c->line, c) && read_knots(&r, c->line, c) && read_weights(&r, c->line, c) &&
           read_free(&r, c->line, c) && read_interval(&r, c->line, c) && read_rest(&r, c->line, c);
    if (!good)
        region_case_clear(c);
    return good ? REGION_CASE_READ : REGION_CASE_BAD;
}

void region_case_clear(struct region_case *c)
{
    rationals_free(c->x, c->count);
    rationals_free(c->y, c->count);
    rationals_free(c->w, c->count);
    rationals_free(c->knots, c->count + c->degree + 1);
    free(c->member);
    free(c->id);
    mpq_clear(c->drag);
    mpq_clear(c->lo);
    mpq_clear(c->hi);
    json_decref(c->line);
    memset(c, 0, sizeof *c);
}
