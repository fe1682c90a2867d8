#include "region_answer.h"

#include <stdlib.h>

#include <jansson.h>

#include "../cases/json_text.h"
#include "../cases/number.h"

static void write_point(FILE *stream, struct point p)
{
    fputc('[', stream);
    real_write(stream, p.x);
    fputc(',', stream);
    real_write(stream, p.y);
    fputc(']', stream);
}

static void write_end(FILE *stream, const char *name, struct point p, bool infinite)
{
    fprintf(stream, ",\"%s\":", name);
    if (infinite)
        fputs("null", stream);
    else
        write_point(stream, p);
}

static void write_edge(FILE *stream, const struct region_edge *e)
{
    bool arc = e->type == EDGE_ARC;
    fprintf(stream, "{\"type\":\"%s\",\"span\":%d,\"%s\":", edge_type_name(e->type), e->span,
            arc ? "t0" : "t");
    real_write(stream, e->t);
    if (arc) {
        fputs(",\"t1\":", stream);
        real_write(stream, e->t1);
    } else {
        fputs(",\"line\":[", stream);
        for (int i = 0; i < 3; i++) {
            fputs(i ? "," : "", stream);
            real_write(stream, e->line[i]);
        }
        fputc(']', stream);
    }
    write_end(stream, "from", e->from, e->from_infinity);
    write_end(stream, "to", e->to, e->to_infinity);
    fputc('}', stream);
}

static void write_edges(FILE *stream, const struct region *r)
{
    const char *comma = "";
    fputs(",\"edges\":[", stream);
    for (int i = 0; i < r->count; i++) {
        fputs(i ? "," : "", stream);
        write_edge(stream, &r->edge[i]);
    }
    fputs("],\"vertices\":[", stream);
    for (int i = 0; i < r->count; i++)
        if (!r->edge[i].to_infinity) {
            fputs(comma, stream);
            write_point(stream, r->edge[i].to);
            comma = ",";
        }
    fputc(']', stream);
}

static void write_measures(FILE *stream, const struct region *r)
{
    fputs(",\"area\":", stream);
    if (r->kind == REGION_BOUNDED)
        real_write(stream, r->area);
    else
        fputs("null", stream);
    fputs(",\"disc\":", stream);
    if (r->kind != REGION_BOUNDED) {
        fputs("null", stream);
        return;
    }
    fputs("{\"centre\":", stream);
    write_point(stream, r->disc_centre);
    fputs(",\"radius\":", stream);
    real_write(stream, r->disc_radius);
    fputc('}', stream);
}

/* What the closed conditions allow where the open region is empty. */
static void write_closed(FILE *stream, const struct region *r)
{
    enum region_kind kind = r->closed_kind;
    int points = r->kind != REGION_EMPTY                                               ? 0
                 : kind == REGION_POINT                                                ? 1
                 : kind == REGION_SEGMENT || kind == REGION_RAY || kind == REGION_LINE ? 2
                                                                                       : 0;
    fputs(",\"closed\":[", stream);
    for (int i = 0; i < points; i++) {
        fputs(i ? "," : "", stream);
        write_point(stream, r->closed[i]);
    }
    fputc(']', stream);
}

static void write_why(FILE *stream, int reasons)
{
    static const char *const names[] = {"end", "knot", "M", "N'", "A", "B"};
    const char *plus = "";
    for (int i = 0; i < 6; i++)
        if (reasons & (1 << i)) {
            fprintf(stream, "%s%s", plus, names[i]);
            plus = "+";
        }
}

static void write_breaks(FILE *stream, const struct region_breaks *b)
{
    fputs(",\"breaks\":[", stream);
    for (int i = 0; b && i < b->count; i++) {
        const struct region_break *at = &b->at[i];
        bool last = i + 1 == b->count || b->at[i + 1].span != at->span;
        fprintf(stream, "%s{\"span\":%d,\"t\":", i ? "," : "", at->span);
        real_write(stream, at->t);
        fputs(",\"why\":\"", stream);
        write_why(stream, at->reasons);
        fputc('"', stream);
        if (!last)
            fprintf(stream, ",\"type\":\"%s\",\"turning\":%.6g",
                    at->type > 0   ? "S+"
                    : at->type < 0 ? "S-"
                                   : "S0",
                    at->turning);
        fputc('}', stream);
    }
    fputc(']', stream);
}

static void write_at(FILE *stream, const struct region_answer *a)
{
    static const char *const sides[] = {"outside", "boundary", "inside"};
    fputs(",\"at\":{\"point\":", stream);
    write_point(stream, a->at);
    fprintf(stream, ",\"side\":\"%s\",\"distance\":", sides[a->side]);
    if (a->region->count > 0)
        real_write(stream, a->distance);
    else
        fputs("null", stream);
    fputs(",\"nearest\":", stream);
    write_point(stream, a->nearest);
    fputc('}', stream);
}

void region_answer_write(FILE *stream, const struct region_answer *a)
{
    const struct region *r = a->region;
    fputs("{\"id\":", stream);
    json_text_write_string(stream, a->id);
    fprintf(stream, ",\"method\":\"%s\",\"precision\":\"%s\",\"outcome\":\"%s\"", a->method->name, REAL_NAME,
            outcome_name(a->outcome));
    fprintf(stream, ",\"kind\":\"%s\",\"closed_kind\":\"%s\",\"strict\":%s,\"sign\":%d",
            region_kind_name(r->kind), region_kind_name(r->closed_kind), r->strict ? "true" : "false",
            a->sign);
    write_edges(stream, r);
    write_measures(stream, r);
    write_closed(stream, r);
    if (a->breaks)
        write_breaks(stream, a->breaks);
    if (a->at_given)
        write_at(stream, a);
    fprintf(stream, ",\"certified\":%s,\"steps\":%ld}\n", r->certified ? "true" : "false", a->steps);
}
