#include <stdio.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "path_set.h"
#include "../run/memory.h"

void *path_aligned(size_t bytes)
{
    return memory_need(aligned_alloc(64, bytes / 64 * 64 + 64));
}

void path_draft_begin(struct path_draft *d, const char *id)
{
    memset((void *)d, 0, sizeof *d);
    d->id = strdup(id);
    path_draft_break(d);
}

void path_draft_break(struct path_draft *d)
{
    if (d->subpaths > 0 && d->begin[d->subpaths - 1] == d->segments)
        return;
    if (d->subpaths == d->subpaths_room) {
        d->subpaths_room = 2 * d->subpaths_room + 4;
        d->begin = (int *)memory_resized(d->begin, (size_t)d->subpaths_room * sizeof *d->begin);
    }
    d->begin[d->subpaths++] = d->segments;
}

static void make_room(struct path_draft *d, size_t numbers)
{
    if (d->segments == d->segments_room) {
        d->segments_room = d->segments_room + d->segments_room / 2 + 16;
        d->segment =
            (struct curve *)memory_resized(d->segment, (size_t)d->segments_room * sizeof *d->segment);
    }
    if (d->coefficients + numbers > d->coefficients_room) {
        d->coefficients_room = d->coefficients_room + d->coefficients_room / 2 + 128 + numbers;
        d->coefficient = (real *)memory_resized(d->coefficient, d->coefficients_room * sizeof(real));
    }
}

bool path_draft_add(struct path_draft *d, int degree, const real *x, const real *y, const real *w)
{
    size_t length = (size_t)degree + 1, bytes = length * sizeof(real);
    struct curve c;

    c.degree = degree;
    c.x = x;
    c.y = y;
    c.w = w;
    c.domain.lo = 0;
    c.domain.hi = 1;
    if (!path_takes(&c))
        return false;
    make_room(d, 3 * length);
    real *to = d->coefficient + d->coefficients;
    memcpy((void *)to, x, bytes);
    memcpy((void *)(to + length), y, bytes);
    if (w)
        memcpy((void *)(to + 2 * length), w, bytes);
    d->coefficients += (w ? 3 : 2) * length;
    d->segment[d->segments++] = c; /* w says whether there are weights */
    return true;
}

static bool is_plain(const struct curve *c)
{
    return c->degree <= 3 && !c->w;
}

/* x to points[0..3], y to points[4..7]. */
static void place_plain(struct curve *c, const real *at, real *points)
{
    int length = c->degree + 1;

    for (int k = 0; k < BATCH_NUMBERS; k++)
        points[k] = 0;
    memcpy((void *)points, at, (size_t)length * sizeof(real));
    memcpy((void *)(points + BATCH_NUMBERS / 2), at + length, (size_t)length * sizeof(real));
    c->x = points;
    c->y = points + BATCH_NUMBERS / 2;
}

/* Segments find their place in the table, or among the coefficients that are left. */
static void place_segments(struct loaded_path *p, const struct path_draft *d)
{
    const real *from = d->coefficient;
    real *to = p->coefficient;

    for (int i = 0; i < d->segments; i++) {
        struct curve *c = &p->segment[i];
        size_t length = (size_t)c->degree + 1, numbers = (c->w ? 3 : 2) * length;

        p->plain[i] = (unsigned char)(is_plain(c) ? c->degree : 0);
        p->degree = c->degree > p->degree ? c->degree : p->degree;
        if (is_plain(c)) {
            place_plain(c, from, p->points + (size_t)BATCH_NUMBERS * (size_t)i);
        } else {
            memcpy((void *)to, from, numbers * sizeof(real));
            c->x = to;
            c->y = to + length;
            c->w = c->w ? to + 2 * length : NULL;
            to += numbers;
        }
        from += numbers;
    }
}

/* Numbers of segments that are not plain. */
static size_t other_numbers(const struct path_draft *d)
{
    size_t numbers = 0;

    for (int i = 0; i < d->segments; i++)
        if (!is_plain(&d->segment[i]))
            numbers += (d->segment[i].w ? 3 : 2) * ((size_t)d->segment[i].degree + 1);
    return numbers;
}

static struct loaded_path *path_new(struct path_set *set)
{
    if (set->count == set->room) {
        set->room = 2 * set->room + 4;
        set->at = (struct loaded_path *)memory_resized(set->at, (size_t)set->room * sizeof *set->at);
    }
    struct loaded_path *p = &set->at[set->count++];
    memset((void *)p, 0, sizeof *p);
    return p;
}

void path_draft_end(struct path_draft *d, struct path_set *set)
{
    struct loaded_path *p = path_new(set);
    size_t links = (size_t)d->segments * sizeof(int);

    p->id = d->id;
    p->coefficients = other_numbers(d);
    p->segment = (struct curve *)memory_resized(d->segment, (size_t)d->segments * sizeof *d->segment);
    p->coefficient = (real *)memory_resized(NULL, p->coefficients * sizeof(real));
    p->plain = (unsigned char *)memory_resized(NULL, (size_t)d->segments);
    p->points = (real *)path_aligned((size_t)d->segments * BATCH_NUMBERS * sizeof(real));
    p->degree = 1;
    place_segments(p, d);
    free((void *)d->coefficient);
    p->path.count = d->segments;
    p->path.segment = p->segment;
    p->path.points = p->points;
    p->path.degree = p->plain;
    p->path.next = (int *)memory_resized(NULL, links);
    p->path.before = (int *)memory_resized(NULL, links);
    for (int k = 0; k < d->subpaths; k++)
        path_link(&p->path, d->begin[k], k + 1 < d->subpaths ? d->begin[k + 1] : d->segments);
    free(d->begin);
    memset((void *)d, 0, sizeof *d);
}

void path_draft_clear(struct path_draft *d)
{
    free(d->id);
    free(d->segment);
    free(d->begin);
    free((void *)d->coefficient);
    memset((void *)d, 0, sizeof *d);
}

void path_set_clear(struct path_set *set)
{
    for (int i = 0; i < set->count; i++) {
        struct loaded_path *p = &set->at[i];

        free(p->id);
        free(p->segment);
        free((void *)p->coefficient);
        free((void *)p->points);
        free(p->plain);
        free(p->path.next);
        free(p->path.before);
    }
    free(set->at);
    memset(set, 0, sizeof *set);
}
