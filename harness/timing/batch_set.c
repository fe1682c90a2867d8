#include "batch_set.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../algorithms/crossings.h"
#include "../run/memory.h"

enum { LINE = 64 }; /* bytes of a cache line */

static bool is_taken(const struct curve *c)
{
    return !c->w && c->degree <= 3 && c->domain.lo == 0 && c->domain.hi == 1;
}

static void add_curve(struct batch_set *b, int i, const struct curve *c)
{
    b->degree[i] = (unsigned char)c->degree;
    for (int k = 0; k <= c->degree; k++) {
        b->points[BATCH_NUMBERS * i + k] = c->x[k];
        b->points[BATCH_NUMBERS * i + BATCH_NUMBERS / 2 + k] = c->y[k];
    }
}

static void make_room(struct batch_set *b, int records, int overlaps)
{
    struct batch_answer *a = &b->answer;
    a->record = (struct batch_record *)memory_need(realloc(a->record, (size_t)records * sizeof *a->record));
    a->overlap =
        (struct batch_overlap *)memory_need(realloc(a->overlap, (size_t)overlaps * sizeof *a->overlap));
    a->record_room = records;
    a->overlap_room = overlaps;
}

/* The curves f come first, then the g; both begin on a cache line. */
static void make_tables(struct batch_set *b)
{
    size_t numbers = (size_t)b->count * 2 * BATCH_NUMBERS;
    b->memory = memory_need(calloc(numbers * sizeof(real) + LINE, 1));
    b->points = (real *)(void *)(((uintptr_t)b->memory + LINE - 1) / LINE * LINE);
    b->degree = (unsigned char *)memory_need(calloc((size_t)b->count * 2 + 1, 1));
    b->place = (int *)memory_need(calloc((size_t)b->count + 1, sizeof *b->place));
    b->first = (int *)memory_need(calloc((size_t)b->count + 2, sizeof *b->first));
    b->workspace = memory_need(aligned_alloc(LINE, (batch_workspace_size() + LINE - 1) / LINE * LINE));
    b->answer.outcome = (unsigned char *)memory_need(calloc((size_t)b->count + 1, 1));
}

void batch_set_make(struct batch_set *b, int count, const struct loaded_case *const *at, const int *index,
                    enum batch_variant variant)
{
    bool cubic = true;
    memset((void *)b, 0, sizeof *b);
    b->count = count;
    make_tables(b);
    b->batch.variant = variant;
    b->batch.tolerance = 1;
    b->batch.max_steps = STEPS_MAX;
    for (int i = 0; i < count; i++) {
        const struct problem *p = &at[index ? index[i] : i]->owned.problem;
        int k = b->batch.pairs;
        b->place[i] = is_taken(&p->f) && is_taken(&p->g) ? b->batch.pairs++ : -1;
        if (b->place[i] < 0)
            continue;
        add_curve(b, k, &p->f);
        add_curve(b, count + k, &p->g);
        cubic = cubic && p->f.degree == 3 && p->g.degree == 3;
        b->batch.tolerance = real_min(b->batch.tolerance, p->tolerance);
        b->batch.max_steps = p->max_steps;
    }
    b->batch.f.points = b->points;
    b->batch.g.points = b->points + (size_t)count * BATCH_NUMBERS;
    b->batch.f.degree = cubic ? NULL : b->degree;
    b->batch.g.degree = cubic ? NULL : b->degree + count;
    make_room(b, 4 * count + 64, 64);
}

void batch_set_solve(struct batch_set *b)
{
    struct batch_answer *a = &b->answer;
    while (batch_solve(&b->batch, 0, b->workspace, a) == OUT_OF_ROOM)
        make_room(b, 2 * a->record_room, 2 * a->overlap_room);
    b->order = (int *)memory_need(realloc(b->order, ((size_t)a->records + 1) * sizeof *b->order));
    memset(b->first, 0, ((size_t)b->batch.pairs + 2) * sizeof *b->first);
    for (int i = 0; i < a->records; i++)
        b->first[a->record[i].pair + 1]++;
    for (int k = 0; k < b->batch.pairs; k++)
        b->first[k + 1] += b->first[k];
    for (int i = 0; i < a->records; i++) /* moves each beginning to the pair's end */
        b->order[b->first[a->record[i].pair]++] = i;
    for (int k = b->batch.pairs; k > 0; k--)
        b->first[k] = b->first[k - 1];
    b->first[0] = 0;
}

void batch_set_run(struct batch_set *b, int first, int last)
{
    struct batch part = b->batch;
    part.pairs = last;
    batch_solve(&part, first, b->workspace, &b->answer);
}

enum outcome batch_set_answer(const struct batch_set *b, int i, struct crossings *out)
{
    const struct batch_answer *a = &b->answer;
    int k = b->place[i];
    out->count = out->overlaps = 0;
    out->merged = false;
    if (k < 0)
        return UNSUPPORTED;
    for (int j = b->first[k]; j < b->first[k + 1] && out->count < CROSSINGS_MAX; j++)
        out->at[out->count++] = a->record[b->order[j]].at;
    for (int j = 0; j < a->overlaps && out->overlaps < OVERLAPS_MAX; j++)
        if (a->overlap[j].pair == k)
            out->overlap[out->overlaps++] = a->overlap[j].at;
    crossings_sort(out);
    return (enum outcome)a->outcome[k];
}

void batch_set_clear(struct batch_set *b)
{
    free(b->answer.record);
    free(b->answer.overlap);
    free(b->answer.outcome);
    free(b->place);
    free(b->first);
    free(b->order);
    free(b->degree);
    free(b->workspace);
    free(b->memory);
    memset((void *)b, 0, sizeof *b);
}
