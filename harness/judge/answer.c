#include <stdlib.h>
#include <string.h>

#include "answer.h"
#include "../cases/json_text.h"
#include "../cases/number.h"
#include "../cases/place.h"

/* ---- writing ---- */

static void write_interval(FILE *stream, const char *name, struct interval i)
{
    fprintf(stream, "\"%s\":[", name);
    real_write(stream, i.lo);
    fputc(',', stream);
    real_write(stream, i.hi);
    fputc(']', stream);
}

static void write_crossing(FILE *stream, const struct crossing *c, const struct curve *f)
{
    fputc('{', stream);
    write_interval(stream, "t", c->t);
    fputc(',', stream);
    write_interval(stream, "s", c->s);
    fprintf(stream, ",\"standing\":\"%s\",\"at_most\":%d,\"multiplicity\":%d", standing_name(c->standing),
            c->at_most, c->multiplicity);
    if (f)
        place_write(stream, f, place_middle(c->t.lo, c->t.hi));
    fputc('}', stream);
}

static void write_overlap(FILE *stream, const struct overlap *o)
{
    fputc('{', stream);
    write_interval(stream, "t_outer", o->t_outer);
    fputc(',', stream);
    write_interval(stream, "t_inner", o->t_inner);
    fputc(',', stream);
    write_interval(stream, "s_outer", o->s_outer);
    fputc(',', stream);
    write_interval(stream, "s_inner", o->s_inner);
    fprintf(stream, ",\"reversed\":%s,\"exact\":%s,\"distance\":", o->reversed ? "true" : "false",
            o->exact ? "true" : "false");
    real_write(stream, o->distance);
    fputc('}', stream);
}

/* The members of an object, each after a comma. */
static void write_more(FILE *stream, json_t *extra)
{
    const char *key;
    json_t *value;

    json_object_foreach(extra, key, value)
    {
        char *text = json_dumps(value, JSON_ENCODE_ANY | JSON_COMPACT);
        fputc(',', stream);
        json_text_write_string(stream, key);
        fprintf(stream, ":%s", text ? text : "null");
        free(text);
    }
}

void answer_write(FILE *stream, const struct answer *a, const struct curve *f, json_t *extra)
{
    fputs("{\"id\":", stream);
    json_text_write_string(stream, a->id);
    fputs(",\"algorithm\":", stream);
    json_text_write_string(stream, a->algorithm);
    fprintf(stream, ",\"precision\":\"%s\",\"tolerance\":", REAL_NAME);
    real_write(stream, a->tolerance);
    fprintf(stream, ",\"outcome\":\"%s\",\"crossings\":[", outcome_name(a->outcome));
    for (int i = 0; i < a->crossings->count; i++) {
        if (i)
            fputc(',', stream);
        write_crossing(stream, &a->crossings->at[i], f);
    }
    fputs("],\"overlaps\":[", stream);
    for (int i = 0; i < a->crossings->overlaps; i++) {
        if (i)
            fputc(',', stream);
        write_overlap(stream, &a->crossings->overlap[i]);
    }
    fprintf(stream, "],\"steps\":%ld", a->steps);
    if (a->points_only)
        fputs(",\"points_only\":true", stream);
    if (extra)
        write_more(stream, extra);
    fputs("}\n", stream);
}

/* ---- reading ---- */

static bool read_real(const json_t *value, real *a)
{
    if (json_is_string(value))
        return real_parse(json_string_value(value), a);
    if (json_is_integer(value))
        *a = (real)json_integer_value(value);
    else if (json_is_real(value))
        *a = json_real_value(value);
    else
        return false;
    return true;
}

static bool read_interval(const json_t *value, struct interval *i)
{
    return json_array_size(value) == 2 && read_real(json_array_get(value, 0), &i->lo) &&
           read_real(json_array_get(value, 1), &i->hi) && i->lo <= i->hi;
}

/* A missing one is 0. */
static bool read_count(const json_t *value, long most, long *n)
{
    *n = (long)json_integer_value(value);
    return (!value || json_is_integer(value)) && *n >= 0 && *n <= most;
}

/* A missing one is false. */
static bool read_flag(const json_t *value, bool *flag)
{
    *flag = json_is_true(value);
    return !value || json_is_boolean(value);
}

static bool read_standing(const json_t *value, enum standing *standing)
{
    static const enum standing all[] = {CANDIDATE, UNIQUE, END, CLUSTER};
    const char *name = json_string_value(value);

    *standing = CANDIDATE;
    for (int i = 0; name && i < 4; i++) {
        if (strcmp(name, standing_name(all[i])) == 0) {
            *standing = all[i];
            return true;
        }
    }
    return !value;
}

static bool read_outcome(const json_t *value, enum outcome *outcome)
{
    static const enum outcome all[] = {SOLVED,  OUT_OF_STEPS, OUT_OF_ROOM, UNSUPPORTED,
                                       INVALID, GAVE_UP,      CRASHED,     TIMED_OUT};
    const char *name = json_string_value(value);

    for (int i = 0; name && i < 8; i++) {
        if (strcmp(name, outcome_name(all[i])) == 0) {
            *outcome = all[i];
            return true;
        }
    }
    return false;
}

static const char *read_crossing(const json_t *value, struct crossing *c)
{
    long at_most, multiplicity;

    if (!json_is_object(value))
        return "crossings: an element is not an object, expected {\"t\":[lo,hi],\"s\":[lo,hi],...}";
    if (!read_interval(json_object_get(value, "t"), &c->t))
        return "crossings.t: missing or not an interval, expected [lo,hi] with lo <= hi";
    if (!read_interval(json_object_get(value, "s"), &c->s))
        return "crossings.s: missing or not an interval, expected [lo,hi] with lo <= hi";
    if (!read_standing(json_object_get(value, "standing"), &c->standing))
        return "crossings.standing: unknown, expected CANDIDATE, UNIQUE, END or CLUSTER";
    if (!read_count(json_object_get(value, "at_most"), 1000000, &at_most))
        return "crossings.at_most: not a count, expected an integer from 0 to 1000000";
    if (!read_count(json_object_get(value, "multiplicity"), 1000000, &multiplicity))
        return "crossings.multiplicity: not a count, expected an integer from 0 to 1000000";
    c->at_most = (int)at_most;
    c->multiplicity = (int)multiplicity;
    return NULL;
}

static const char *read_overlap(const json_t *value, struct overlap *o)
{
    if (!json_is_object(value))
        return "overlaps: an element is not an object, expected {\"t_outer\":[lo,hi],...}";
    if (!read_interval(json_object_get(value, "t_outer"), &o->t_outer))
        return "overlaps.t_outer: missing or not an interval, expected [lo,hi] with lo <= hi";
    if (!read_interval(json_object_get(value, "t_inner"), &o->t_inner))
        return "overlaps.t_inner: missing or not an interval, expected [lo,hi] with lo <= hi";
    if (!read_interval(json_object_get(value, "s_outer"), &o->s_outer))
        return "overlaps.s_outer: missing or not an interval, expected [lo,hi] with lo <= hi";
    if (!read_interval(json_object_get(value, "s_inner"), &o->s_inner))
        return "overlaps.s_inner: missing or not an interval, expected [lo,hi] with lo <= hi";
    if (!read_flag(json_object_get(value, "reversed"), &o->reversed))
        return "overlaps.reversed: not a truth value, expected true or false";
    if (!read_flag(json_object_get(value, "exact"), &o->exact))
        return "overlaps.exact: not a truth value, expected true or false";
    if (!read_real(json_object_get(value, "distance"), &o->distance) || o->distance < 0)
        return "overlaps.distance: missing or not a distance, expected a number that is not negative";
    return NULL;
}

static const char *read_records(const json_t *line, struct crossings *out)
{
    const json_t *crossings = json_object_get(line, "crossings");
    const json_t *overlaps = json_object_get(line, "overlaps");
    const char *wrong = NULL;

    if ((crossings && !json_is_array(crossings)) || json_array_size(crossings) > CROSSINGS_MAX)
        return "crossings: not a list, or too long, expected at most 2048 crossings";
    if ((overlaps && !json_is_array(overlaps)) || json_array_size(overlaps) > OVERLAPS_MAX)
        return "overlaps: not a list, or too long, expected at most 16 overlaps";
    for (size_t i = 0; !wrong && i < json_array_size(crossings); i++)
        wrong = read_crossing(json_array_get(crossings, i), &out->at[out->count++]);
    for (size_t i = 0; !wrong && i < json_array_size(overlaps); i++)
        wrong = read_overlap(json_array_get(overlaps, i), &out->overlap[out->overlaps++]);
    return wrong;
}

/* A missing one is "". */
static bool read_name(const json_t *value, char *name, size_t size)
{
    const char *text = json_string_value(value);

    name[0] = '\0';
    if (!value)
        return true;
    if (!text || strlen(text) >= size)
        return false;
    strcpy(name, text);
    return true;
}

static const char *read_line(const json_t *line, struct answer *a, char id[256], char algorithm[128])
{
    const json_t *tolerance = json_object_get(line, "tolerance");

    if (!json_is_object(line))
        return "line: not a JSON object, expected {\"id\":...,\"outcome\":...,\"crossings\":[...]}";
    if (!read_name(json_object_get(line, "id"), id, 256) || !id[0])
        return "id: missing, empty or too long, expected the case's id";
    if (!read_name(json_object_get(line, "algorithm"), algorithm, 128))
        return "algorithm: not a name, expected a text of at most 127 bytes";
    if (tolerance && !read_real(tolerance, &a->tolerance))
        return "tolerance: not a number, expected the width asked for";
    if (!read_outcome(json_object_get(line, "outcome"), &a->outcome))
        return "outcome: missing or unknown, expected SOLVED, OUT_OF_STEPS, OUT_OF_ROOM, UNSUPPORTED, "
               "INVALID, GAVE_UP, CRASHED or TIMED_OUT";
    if (!read_count(json_object_get(line, "steps"), 1L << 53, &a->steps))
        return "steps: not a count, expected an integer that is not negative";
    if (!read_flag(json_object_get(line, "points_only"), &a->points_only))
        return "points_only: not a truth value, expected true or false";
    if (a->outcome == SOLVED && !json_object_get(line, "crossings"))
        return "crossings: missing, expected a list (empty if there are none)";
    return read_records(line, a->crossings);
}

const char *answer_read(const char *text, struct answer *a, char id[256], char algorithm[128])
{
    json_t *line = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    const char *wrong;

    a->id = id;
    a->algorithm = algorithm;
    a->tolerance = 0;
    a->crossings->count = a->crossings->overlaps = 0;
    a->crossings->merged = false;
    wrong = read_line(line, a, id, algorithm);
    json_decref(line);
    return wrong;
}
