#include "case_fields.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "../run/memory.h"

bool fields_complain(const struct fields *r, const char *field, const char *format, ...)
{
    enum { ERROR_SIZE = 512 };
    va_list arguments;
    int n = snprintf(r->error, ERROR_SIZE, "%s:%d: %s: ", r->file, r->line, field);
    if (n < 0 || n >= ERROR_SIZE)
        return false;
    va_start(arguments, format);
    vsnprintf(r->error + n, (size_t)(ERROR_SIZE - n), format, arguments);
    va_end(arguments);
    return false;
}

const char *fields_type(const json_t *v)
{
    if (!v)
        return "missing";
    switch (json_typeof(v)) {
    case JSON_OBJECT:
        return "an object";
    case JSON_ARRAY:
        return "an array";
    case JSON_STRING:
        return "text";
    case JSON_INTEGER:
        return "an integer";
    case JSON_REAL:
        return "a number";
    case JSON_TRUE:
    case JSON_FALSE:
        return "a truth value";
    default:
        return "null";
    }
}

bool fields_rational(const struct fields *r, const char *field, const json_t *v, mpq_t q)
{
    if (json_is_number(v)) {
        mpq_set_d(q, json_number_value(v));
        return true;
    }
    if (!json_is_string(v))
        return fields_complain(r, field, "%s, expected a number", fields_type(v));
    if (!number_parse(json_string_value(v), q))
        return fields_complain(r, field,
                               "\"%.60s\" is no number, expected a decimal, a/b, a C hex float, or a "
                               "decimal with a trailing f",
                               json_string_value(v));
    return true;
}

bool fields_double(const struct fields *r, const char *field, const json_t *v, double *a)
{
    if (v && json_is_null(v)) {
        *a = NAN;
        return true;
    }
    if (!json_is_number(v))
        return fields_complain(r, field, "%s, expected a number or null", fields_type(v));
    *a = json_number_value(v);
    return true;
}

bool fields_integer(const struct fields *r, const char *field, const json_t *v, int lo, int hi, int *a)
{
    if (!json_is_integer(v))
        return fields_complain(r, field, "%s, expected an integer", fields_type(v));
    json_int_t n = json_integer_value(v);
    if (n < lo || n > hi)
        return fields_complain(r, field, "%lld, expected %d to %d", (long long)n, lo, hi);
    *a = (int)n;
    return true;
}

bool fields_array(const struct fields *r, const char *field, const json_t *v, int length)
{
    if (!json_is_array(v))
        return fields_complain(r, field, "%s, expected an array", fields_type(v));
    if (length >= 0 && json_array_size(v) != (size_t)length)
        return fields_complain(r, field, "%zu entr%s, expected %d", json_array_size(v),
                               json_array_size(v) == 1 ? "y" : "ies", length);
    return true;
}

static bool is_among(const char *name, const char *const *known)
{
    for (; *known; known++)
        if (!strcmp(*known, name))
            return true;
    return false;
}

bool fields_are_known(const struct fields *r, const char *where, const json_t *object,
                      const char *const *known)
{
    char field[FIELD_MAX], list[300] = "";
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)object, name, value)
    {
        if (is_among(name, known))
            continue;
        for (int i = 0; known[i]; i++) {
            size_t n = strlen(list);
            snprintf(list + n, sizeof list - n, "%s%s", !i ? "" : known[i + 1] ? ", " : " or ", known[i]);
        }
        snprintf(field, sizeof field, "%s%s", where, name);
        return fields_complain(r, field, "unknown, expected %s", list);
    }
    return true;
}

mpq_t *rationals_new(int n)
{
    mpq_t *q = memory_new((size_t)n, sizeof *q);
    for (int i = 0; i < n; i++)
        mpq_init(q[i]);
    return q;
}

void rationals_free(mpq_t *q, int n)
{
    for (int i = 0; q && i < n; i++)
        mpq_clear(q[i]);
    free(q);
}
