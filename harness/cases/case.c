#include "case.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "../../algorithms/bezier.h"
#include "../run/progress.h"
#include "case_fields.h"

enum { ID_MAX = 255 };

/* points or f64: the first that is there of the two names. */
static const json_t *either(const json_t *curve, const char *first, const char *second, const char **name)
{
    const json_t *v = json_object_get(curve, first);
    bool given = v && !json_is_null(v);
    *name = given ? first : second;
    return given ? v : json_object_get(curve, second);
}

static bool read_points(const struct fields *r, const char *curve, const json_t *object, struct case_curve *c)
{
    char field[FIELD_MAX];
    const char *name;
    const json_t *points = either(object, "f64", "points", &name);
    snprintf(field, sizeof field, "%s.%s", curve, name);
    if (!json_is_array(points))
        return fields_complain(r, field, "%s, expected control points [[x, y], ...]", fields_type(points));
    size_t n = json_array_size(points);
    if (n < 2 || n > DEGREE_MAX + 1)
        return fields_complain(r, field, "%zu point%s, expected 2 to %d (degree 1 to %d)", n,
                               n == 1 ? "" : "s", DEGREE_MAX + 1, DEGREE_MAX);
    c->degree = (int)n - 1;
    c->x = rationals_new(c->degree + 1);
    c->y = rationals_new(c->degree + 1);
    c->w = rationals_new(c->degree + 1);
    for (int i = 0; i <= c->degree; i++) {
        const json_t *point = json_array_get(points, (size_t)i);
        snprintf(field, sizeof field, "%s.%s[%d]", curve, name, i);
        if (!fields_array(r, field, point, 2))
            return false;
        for (int k = 0; k < 2; k++) {
            snprintf(field, sizeof field, "%s.%s[%d][%d]", curve, name, i, k);
            if (!fields_rational(r, field, json_array_get(point, (size_t)k), k ? c->y[i] : c->x[i]))
                return false;
        }
    }
    return true;
}

static bool read_degree(const struct fields *r, const char *curve, const json_t *object, int degree)
{
    char field[FIELD_MAX];
    int given;
    const json_t *v = json_object_get(object, "degree");
    if (!v)
        return true;
    snprintf(field, sizeof field, "%s.degree", curve);
    if (!fields_integer(r, field, v, 1, DEGREE_MAX, &given))
        return false;
    snprintf(field, sizeof field, "%s.points", curve);
    if (given != degree)
        return fields_complain(r, field, "%d points, degree %d needs %d", degree + 1, given, given + 1);
    return true;
}

static bool read_weights(const struct fields *r, const char *curve, const json_t *object,
                         struct case_curve *c)
{
    char field[FIELD_MAX];
    const char *name;
    const json_t *weights = either(object, "w64", "weights", &name);
    c->rational = weights && !json_is_null(weights);
    snprintf(field, sizeof field, "%s.%s", curve, name);
    if (c->rational && !fields_array(r, field, weights, c->degree + 1))
        return false;
    for (int i = 0; i <= c->degree; i++) {
        mpq_set_ui(c->w[i], 1, 1);
        if (!c->rational)
            continue;
        snprintf(field, sizeof field, "%s.%s[%d]", curve, name, i);
        if (!fields_rational(r, field, json_array_get(weights, (size_t)i), c->w[i]))
            return false;
        if (mpq_sgn(c->w[i]) <= 0)
            return fields_complain(r, field, "a weight that is not positive, expected > 0");
    }
    return true;
}

static bool read_domain(const struct fields *r, const char *curve, const json_t *object, struct case_curve *c)
{
    char field[FIELD_MAX];
    const json_t *v = json_object_get(object, "domain");
    mpq_set_ui(c->hi, 1, 1);
    if (!v || json_is_null(v))
        return true;
    snprintf(field, sizeof field, "%s.domain", curve);
    if (!fields_array(r, field, v, 2))
        return false;
    for (int k = 0; k < 2; k++) {
        snprintf(field, sizeof field, "%s.domain[%d]", curve, k);
        if (!fields_rational(r, field, json_array_get(v, (size_t)k), k ? c->hi : c->lo))
            return false;
    }
    snprintf(field, sizeof field, "%s.domain", curve);
    if (mpq_cmp(c->lo, c->hi) >= 0)
        return fields_complain(r, field, "its ends are not in order, expected [a, b] with a < b");
    return true;
}

bool case_curve_read(const struct fields *r, const char *name, const json_t *v, struct case_curve *c)
{
    static const char *const known[] = {"points", "weights", "degree", "domain", "f64", "w64", NULL};
    char where[FIELD_MAX];
    if (!json_is_object(v))
        return fields_complain(r, name, "%s, expected an object with points", fields_type(v));
    snprintf(where, sizeof where, "%s.", name);
    return fields_are_known(r, where, v, known) && read_points(r, name, v, c) &&
           read_degree(r, name, v, c->degree) && read_weights(r, name, v, c) && read_domain(r, name, v, c);
}

static bool read_text(const struct fields *r, const char *field, const json_t *v, char **text)
{
    if (!json_is_string(v))
        return fields_complain(r, field, "%s, expected text", fields_type(v));
    *text = strdup(json_string_value(v));
    return *text || fields_complain(r, field, "out of memory");
}

static bool read_labels(const struct fields *r, const json_t *line, struct test_case *c)
{
    const json_t *class_name = json_object_get(line, "class");
    if (!read_text(r, "id", json_object_get(line, "id"), &c->id))
        return false;
    if (!*c->id || strlen(c->id) > ID_MAX)
        return fields_complain(r, "id", "%zu bytes long, expected 1 to %d", strlen(c->id), ID_MAX);
    json_t *none = class_name && !json_is_null(class_name) ? NULL : json_string("");
    bool done = read_text(r, "class", none ? none : class_name, &c->class_name);
    json_decref(none);
    return done;
}

static bool read_near(const struct fields *r, const json_t *near, struct test_case *c)
{
    const json_t *reasons = json_object_get(near, "ambiguous");
    if (near && !json_is_null(near) && !json_is_object(near))
        return fields_complain(r, "near", "%s, expected an object", fields_type(near));
    if (!reasons || json_is_null(reasons) || json_is_boolean(reasons)) {
        c->ambiguous = json_is_true(reasons);
        return true;
    }
    c->ambiguous = json_array_size(reasons) > 0;
    return fields_array(r, "near.ambiguous", reasons, -1);
}

/* Lines may carry any other fields; one that is spelt almost as one of ours is told, once. */
static void note_near_misses(const struct fields *r, const json_t *line)
{
    static const char *const known[] = {
        "id",    "f",      "g",    "class",         "expected",        "near",
        "flags", "family", "note", "planted_count", "planted_overlap", "planted",
        "gap",   "source", NULL};
    static bool noted;
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)line, name, value)
    {
        const char *meant = strlen(name) > 3 ? fields_near_miss(name, known) : NULL;
        if (!meant || noted)
            continue;
        noted = true;
        progress_note("%s:%d: %.60s: a field that is not read; is %s meant?", r->file, r->line, name, meant);
    }
}

static bool read_line(const struct fields *r, const json_t *line, struct test_case *c)
{
    if (!json_is_object(line))
        return fields_complain(r, "line", "%s, expected an object with id, f, g", fields_type(line));
    note_near_misses(r, line);
    return read_labels(r, line, c) && case_curve_read(r, "f", json_object_get(line, "f"), &c->f) &&
           case_curve_read(r, "g", json_object_get(line, "g"), &c->g) &&
           expected_read(r, json_object_get(line, "expected"), &c->expected) &&
           read_near(r, json_object_get(line, "near"), c);
}

/* Integers beyond 64 bits are read as the doubles they denote. */
static json_t *parse(const char *text, json_error_t *error)
{
    size_t flags = JSON_REJECT_DUPLICATES | JSON_DECODE_ANY;
    json_t *line = json_loads(text, flags, error);
    if (!line && json_error_code(error) == json_error_numeric_overflow)
        line = json_loads(text, flags | JSON_DECODE_INT_AS_REAL, error);
    return line;
}

enum case_status case_parse(const char *text, const char *file, int line_number, struct test_case *c,
                            char error[512])
{
    struct fields r = {file, line_number, error};
    json_error_t json;
    memset(c, 0, sizeof *c);
    c->file = file;
    c->line_number = line_number;
    mpq_inits(c->f.lo, c->f.hi, c->g.lo, c->g.hi, NULL);
    c->line = parse(fields_skip_mark(text, line_number), &json);
    if (!c->line)
        fields_complain(&r, "line", "%s (column %d), expected one JSON object", json.text, json.column);
    if (c->line && read_line(&r, c->line, c))
        return CASE_READ;
    case_clear(c);
    return CASE_BAD;
}

void case_curve_clear(struct case_curve *c)
{
    rationals_free(c->x, c->degree + 1);
    rationals_free(c->y, c->degree + 1);
    rationals_free(c->w, c->degree + 1);
    mpq_clears(c->lo, c->hi, NULL);
}

void case_clear(struct test_case *c)
{
    case_curve_clear(&c->f);
    case_curve_clear(&c->g);
    case_expected_clear(&c->expected);
    free(c->id);
    free(c->class_name);
    json_decref(c->line);
    memset(c, 0, sizeof *c);
}

void case_reader_init(struct case_reader *r, FILE *stream, const char *file)
{
    memset(r, 0, sizeof *r);
    r->stream = stream;
    r->file = file;
}

static bool is_blank(const char *text)
{
    while (isspace((unsigned char)*text))
        text++;
    return !*text;
}

enum case_status case_read(struct case_reader *r, struct test_case *c)
{
    while (r->stream) {
        ssize_t length = getline(&r->text, &r->text_size, r->stream);
        struct fields here = {r->file, ++r->line_number, r->error};
        if (length < 0) {
            bool end = !ferror(r->stream);
            r->stream = NULL;
            fields_complain(&here, "line", "cannot be read, expected a text file");
            return end ? CASE_END : CASE_BAD;
        }
        if ((size_t)length != strlen(r->text)) {
            fields_complain(&here, "line", "a byte 0, expected text");
            return CASE_BAD;
        }
        if (!is_blank(r->text))
            return case_parse(r->text, r->file, r->line_number, c, r->error);
    }
    return CASE_END;
}

void case_reader_clear(struct case_reader *r)
{
    free(r->text);
    memset(r, 0, sizeof *r);
}
