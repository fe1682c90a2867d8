#include <stdio.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "path_set.h"

void *path_memory(void *old, size_t bytes)
{
    void *memory = realloc(old, bytes ? bytes : 1);

    if (!memory) {
        fprintf(stderr, "fatline: out of memory (%zu bytes)\n", bytes);
        exit(2);
    }
    return memory;
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
        d->begin = (int *)path_memory(d->begin, (size_t)d->subpaths_room * sizeof *d->begin);
    }
    d->begin[d->subpaths++] = d->segments;
}

static void make_room(struct path_draft *d, size_t numbers)
{
    if (d->segments == d->segments_room) {
        d->segments_room = d->segments_room + d->segments_room / 2 + 16;
        d->segment = (struct curve *)path_memory(d->segment, (size_t)d->segments_room * sizeof *d->segment);
    }
    if (d->coefficients + numbers > d->coefficients_room) {
        d->coefficients_room = d->coefficients_room + d->coefficients_room / 2 + 128 + numbers;
        d->coefficient = (real *)path_memory(d->coefficient, d->coefficients_room * sizeof(real));
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

/* The coefficients have found their place. */
static void place_segments(struct loaded_path *p, int count)
{
    const real *at = p->coefficient;

    for (int i = 0; i < count; i++) {
        struct curve *c = &p->segment[i];
        int length = c->degree + 1;

        c->x = at;
        c->y = at + length;
        c->w = c->w ? at + 2 * length : NULL;
        at += (c->w ? 3 : 2) * length;
        p->degree = c->degree > p->degree ? c->degree : p->degree;
    }
}

static struct loaded_path *path_new(struct path_set *set)
{
    if (set->count == set->room) {
        set->room = 2 * set->room + 4;
        set->at = (struct loaded_path *)path_memory(set->at, (size_t)set->room * sizeof *set->at);
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
    p->segment = (struct curve *)path_memory(d->segment, (size_t)d->segments * sizeof *d->segment);
    p->coefficient = (real *)path_memory(d->coefficient, d->coefficients * sizeof(real));
    p->coefficients = d->coefficients;
    p->degree = 1;
    place_segments(p, d->segments);
    p->path.count = d->segments;
    p->path.segment = p->segment;
    p->path.next = (int *)path_memory(NULL, links);
    p->path.before = (int *)path_memory(NULL, links);
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
        free(p->path.next);
        free(p->path.before);
    }
    free(set->at);
    memset(set, 0, sizeof *set);
}
