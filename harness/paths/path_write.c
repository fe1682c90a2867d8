#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>

#include "path_read.h"
#include "../cases/number.h"

static void write_number(FILE *stream, real a)
{
    char text[REAL_TEXT_MAX];
    const char *quote = REAL_BITS > 53 ? "\"" : "";

    real_text(a, text, sizeof text);
    fprintf(stream, "%s%s%s", quote, text, quote);
}

static void write_points(FILE *stream, const struct curve *c)
{
    fputc('[', stream);
    for (int i = 0; i <= c->degree; i++) {
        fputs(i ? ",[" : "[", stream);
        write_number(stream, c->w ? c->x[i] / c->w[i] : c->x[i]);
        fputc(',', stream);
        write_number(stream, c->w ? c->y[i] / c->w[i] : c->y[i]);
        fputc(']', stream);
    }
    fputc(']', stream);
}

static void write_segment(FILE *stream, const struct curve *c)
{
    if (!c->w) {
        write_points(stream, c);
        return;
    }
    fputs("{\"points\":", stream);
    write_points(stream, c);
    fputs(",\"weights\":[", stream);
    for (int i = 0; i <= c->degree; i++) {
        fputs(i ? "," : "", stream);
        write_number(stream, c->w[i]);
    }
    fputs("]}", stream);
}

void path_write(FILE *stream, const struct loaded_path *p)
{
    json_t *id = json_string(p->id);
    char *quoted = id ? json_dumps(id, JSON_ENCODE_ANY) : NULL;

    fprintf(stream, "{\"id\":%s,\"segments\":[", quoted ? quoted : "\"?\"");
    for (int i = 0; i < p->path.count; i++) {
        fputs(i ? "," : "", stream);
        write_segment(stream, &p->path.segment[i]);
    }
    fputs("]}\n", stream);
    free(quoted);
    json_decref(id);
}
