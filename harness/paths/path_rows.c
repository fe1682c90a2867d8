#include <jansson.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "path_rows.h"
#include "../cases/number.h"
#include "../cases/place.h"
#include "../run/progress.h"

static void write_ends(FILE *stream, const char *name, real lo, real hi)
{
    fprintf(stream, ",\"%s\":[", name);
    real_write(stream, lo);
    fputc(',', stream);
    real_write(stream, hi);
    fputc(']', stream);
}

/* {"id":"a" or {"ids":["a","b"] */
static char *head_of(const struct path_job *job)
{
    json_t *o =
        job->b ? json_pack("{s:[s,s]}", "ids", job->a->id, job->b->id) : json_pack("{s:s}", "id", job->a->id);
    char *text = o ? json_dumps(o, JSON_COMPACT) : NULL;

    if (text)
        text[strlen(text) - 1] = 0;
    json_decref(o);
    return text;
}

static const struct path_record *record_at(const struct path_job *job, int i)
{
    return &job->records.at[job->records.order[i]];
}

/* In the middle of the span, or at the first joint in it. */
static void write_point(FILE *stream, const struct path_span *s, const struct path *path)
{
    const struct curve *f = &path->segment[s->first];
    place_write(stream, f, s->first == s->last ? place_middle(s->lo, s->hi) : (real)1);
}

static void write_record(FILE *stream, const char *head, const struct path_record *r,
                         const struct path_overlap *overlap, const struct path *path)
{
    fprintf(stream, "%s,\"segments\":[[%d,%d],[%d,%d]]", head, r->a.first, r->a.last, r->b.first, r->b.last);
    write_ends(stream, "t", r->a.lo, r->a.hi);
    write_ends(stream, "s", r->b.lo, r->b.hi);
    if (r->overlap >= 0) {
        const struct path_overlap *o = &overlap[r->overlap];

        fputs(",\"standing\":\"OVERLAP\"", stream);
        write_ends(stream, "t_inner", o->a_inner.lo, o->a_inner.hi);
        write_ends(stream, "s_inner", o->b_inner.lo, o->b_inner.hi);
        fprintf(stream, ",\"reversed\":%s,\"distance\":", o->reversed ? "true" : "false");
        real_write(stream, o->distance);
    } else {
        fprintf(stream, ",\"standing\":\"%s\",\"at_most\":%d", standing_name(r->standing), r->at_most);
        write_point(stream, &r->a, path);
    }
    if (r->joint)
        fputs(",\"joint\":true", stream);
    if (r->chain > 0)
        fprintf(stream, ",\"chain\":%d", r->chain);
    fputs("}\n", stream);
}

void path_rows_write(FILE *stream, const struct path_job *job)
{
    char *head = head_of(job);

    for (int i = 0; i < job->records.count; i++)
        write_record(stream, head ? head : "{\"id\":null", record_at(job, i), job->records.overlap,
                     &job->a->path);
    free(head);
}

void path_summary_write(const struct path_job *job)
{
    long count[4] = {0, 0, 0, 0}, overlaps = 0;
    const struct path_times *t = &job->times;
    const struct path_solver *z = &job->solver;

    for (int i = 0; i < job->records.count; i++) {
        if (record_at(job, i)->overlap >= 0)
            overlaps++;
        else
            count[record_at(job, i)->standing]++;
    }
    progress_note(
        "%s%s%s: %d segments, %ld pairs of %ld solved, %d records: %ld UNIQUE, %ld END, %ld CLUSTER, "
        "%ld CANDIDATE, %ld overlaps; %.3g ms",
        job->a->id, job->b ? " x " : " with itself", job->b ? job->b->id : "",
        job->a->path.count + (job->b ? job->b->path.count : 0), z->solved, job->candidates,
        job->records.count, count[UNIQUE], count[END], count[CLUSTER], count[CANDIDATE], overlaps,
        (t->build + t->walk + t->solve + t->join) / 1e6);
    if (z->unsolved > 0)
        progress_note(
            "%ld pairs or segments were not solved (the first: %s); what is open is among the records",
            z->unsolved, outcome_name(z->worst));
}
