/* JSON with short numbers: jansson's own writer prints 17 digits of every double. */
#include "json_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

static void write_object(FILE *stream, json_t *v)
{
    const char *key, *comma = "";
    json_t *value;
    fputc('{', stream);
    json_object_foreach(v, key, value)
    {
        json_t *name = json_string(key);
        fputs(comma, stream);
        json_text_write(stream, name);
        fputs(": ", stream);
        json_text_write(stream, value);
        json_decref(name);
        comma = ", ";
    }
    fputc('}', stream);
}

static void write_real(FILE *stream, double a)
{
    char text[64];
    number_text_double(a, text, sizeof text);
    fputs(text, stream);
    if (!strpbrk(text, ".eE"))
        fputs(".0", stream); /* stays a real */
}

void json_text_write(FILE *stream, const json_t *v)
{
    if (json_is_object(v)) {
        write_object(stream, (json_t *)v);
    } else if (json_is_array(v)) {
        fputc('[', stream);
        for (size_t i = 0; i < json_array_size(v); i++) {
            fputs(i ? ", " : "", stream);
            json_text_write(stream, json_array_get(v, i));
        }
        fputc(']', stream);
    } else if (json_is_real(v)) {
        write_real(stream, json_real_value(v));
    } else {
        char *text = json_dumps(v, JSON_ENCODE_ANY);
        fputs(text, stream);
        free(text);
    }
}

void json_text_write_string(FILE *stream, const char *text)
{
    json_t *string = json_string(text);
    char *quoted = string ? json_dumps(string, JSON_ENCODE_ANY) : NULL;

    fputs(quoted ? quoted : "null", stream);
    free(quoted);
    json_decref(string);
}

json_t *json_number_or_null(double a)
{
    return isfinite(a) ? json_real(a) : json_null();
}
