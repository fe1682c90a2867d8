/* fatline_batch on pairs from bytes: each pair gets what fuzz_library.c asks of fatline_intersect, and both
 * agree: where one proves a solution the other has a record, and where both prove all they have as many. */
#ifndef FATLINE_FUZZ_BATCH_H
#define FATLINE_FUZZ_BATCH_H

#include "fuzz_input.h"

enum { CURVES_MAX = 8, PAIRS_MAX = 20, REFEREED = 4 };
enum {
    BATCH_ROOM = (int)PAIRS_MAX * (int)FATLINE_CROSSINGS_MAX,
    ARCS_ROOM = (int)PAIRS_MAX * (int)FATLINE_OVERLAPS_MAX
};

struct fuzzed_batch {
    struct drawn f[CURVES_MAX], g[CURVES_MAX];
    double f_points[8 * CURVES_MAX], g_points[8 * CURVES_MAX];
    unsigned char f_degree[CURVES_MAX], g_degree[CURVES_MAX];
    int f_index[PAIRS_MAX], g_index[PAIRS_MAX];
    struct fatline_pairs pairs;
    unsigned char outcome[PAIRS_MAX];
    struct fatline_batch_crossing crossing[BATCH_ROOM];
    struct fatline_batch_overlap overlap[ARCS_ROOM];
    int count, overlaps;
};

/* Degrees 0 and 4 are none that fatline_batch takes. */
static void draw_row(struct input *in, struct drawn *c, const struct drawn *like, double *row,
                     unsigned char *degree)
{
    uint8_t kind = take(in);
    if (like && kind >= 200)
        draw_like(in, like, kind & 1, kind & 2, c);
    else
        draw(in, c, kind < 8 ? (kind < 4 ? 0 : 4) : 1 + kind % 3, false, kind >= 196);
    *degree = (unsigned char)c->curve.degree;
    for (int i = 0; i < 8; i++)
        row[i] = i % 4 <= *degree ? c->points[2 * (i % 4) + i / 4] : NAN;
}

static void draw_batch(struct input *in, struct fuzzed_batch *b)
{
    int count = 1 + take(in) % CURVES_MAX, pairs = 1 + take(in) % PAIRS_MAX;
    for (int i = 0; i < count; i++) {
        draw_row(in, &b->f[i], i > 0 ? &b->f[i - 1] : NULL, b->f_points + 8 * i, &b->f_degree[i]);
        draw_row(in, &b->g[i], &b->f[i], b->g_points + 8 * i, &b->g_degree[i]);
    }
    for (int k = 0; k < pairs; k++) {
        b->f_index[k] = k < count ? k : take(in) % count;
        b->g_index[k] = k < count ? k : take(in) % count;
    }
    struct fatline_pairs p = {
        {count, b->f_points, b->f_degree}, {count, b->g_points, b->g_degree}, b->f_index, b->g_index, pairs};
    b->pairs = p;
    b->count = b->overlaps = 0;
}

/* In memory of just the size asked for, with so much room for each call; all of it where that is none for the
 * next pair. */
static void solve_batch(struct fuzzed_batch *b, const struct fatline_options *o, int room)
{
    static struct arena arena;
    size_t size = fatline_batch_workspace_size();
    struct fatline_batch_workspace *w = fatline_batch_workspace_init(exactly(&arena, size), size);
    struct fatline_batch_answer a = {0};
    enum fatline_outcome outcome = FATLINE_OUT_OF_ROOM;
    require(w != NULL);
    a.outcome = b->outcome;
    for (int first = 0; outcome == FATLINE_OUT_OF_ROOM; first = a.done) {
        a.crossing = b->crossing + b->count;
        a.overlap = b->overlap + b->overlaps;
        a.room = least(room, (int)BATCH_ROOM - b->count);
        a.overlap_room = least(room, (int)ARCS_ROOM - b->overlaps);
        outcome = fatline_batch(w, &b->pairs, o, first, &a);
        require(outcome == FATLINE_SOLVED ? a.done == b->pairs.count : outcome == FATLINE_OUT_OF_ROOM);
        require(a.count <= a.room && a.overlaps <= a.overlap_room && !a.error);
        b->count += a.count;
        b->overlaps += a.overlaps;
        require(a.done > first || room < (int)BATCH_ROOM || b->pairs.count == 0);
        room = a.done > first ? room : (int)BATCH_ROOM;
    }
}

/* ---- what is said of one pair ---- */

static bool comes_before(const struct fatline_crossing *c, const struct fatline_crossing *d)
{
    return c->t_lo != d->t_lo ? c->t_lo < d->t_lo : c->s_lo < d->s_lo;
}

/* Its records, sorted. */
static void gather(const struct fuzzed_batch *b, int pair, struct kept *out)
{
    struct fatline_answer *a = &out->answer;
    memset(a, 0, sizeof *a);
    a->outcome = (enum fatline_outcome)b->outcome[pair];
    a->crossing = out->crossing;
    a->overlap = out->overlap;
    for (int i = 0; i < b->count; i++) {
        if (b->crossing[i].pair != pair)
            continue;
        require(a->count < FATLINE_CROSSINGS_MAX);
        int k = a->count++;
        for (; k > 0 && comes_before(&b->crossing[i].at, &out->crossing[k - 1]); k--)
            out->crossing[k] = out->crossing[k - 1];
        out->crossing[k] = b->crossing[i].at;
        if (PLANTED && out->crossing[k].standing == FATLINE_UNIQUE)
            out->crossing[k].t_lo = out->crossing[k].t_hi = out->crossing[k].t_hi / 2;
    }
    for (int i = 0; i < b->overlaps; i++) {
        require(b->overlap[i].pair != pair || a->overlaps < FATLINE_OVERLAPS_MAX);
        if (b->overlap[i].pair == pair)
            out->overlap[a->overlaps++] = b->overlap[i].at;
    }
}

static bool meets(const struct fatline_crossing *c, double t_lo, double t_hi, double s_lo, double s_hi)
{
    return c->t_lo <= t_hi && t_lo <= c->t_hi && c->s_lo <= s_hi && s_lo <= c->s_hi;
}

/* The solution of each UNIQUE of one lies in some record of the other. */
static void check_covered(const struct fatline_answer *one, const struct fatline_answer *other)
{
    for (int i = 0; i < one->count; i++) {
        const struct fatline_crossing *c = &one->crossing[i];
        bool found = c->standing != FATLINE_UNIQUE;
        for (int k = 0; k < other->count && !found; k++) {
            const struct fatline_crossing *d = &other->crossing[k];
            found = meets(c, d->t_lo, d->t_hi, d->s_lo, d->s_hi);
        }
        for (int k = 0; k < other->overlaps && !found; k++) {
            const struct fatline_overlap *d = &other->overlap[k];
            found = meets(c, d->t_outer_lo, d->t_outer_hi, d->s_outer_lo, d->s_outer_hi);
        }
        require(found);
    }
}

static bool is_all_unique(const struct fatline_answer *a)
{
    for (int i = 0; i < a->count; i++)
        if (a->crossing[i].standing != FATLINE_UNIQUE)
            return false;
    return a->overlaps == 0;
}

static void check_member(const struct fuzzed_batch *b, int pair, const struct fatline_options *o,
                         const uint8_t *data, size_t length)
{
    static struct kept mine, single;
    const struct drawn *f = &b->f[b->f_index[pair]], *g = &b->g[b->g_index[pair]];
    bool valid = is_valid(&f->curve, 3) && is_valid(&g->curve, 3);
    gather(b, pair, &mine);
    require(valid == (mine.answer.outcome != FATLINE_INVALID));
    check_form(&mine.answer);
    if (!valid) {
        require(mine.answer.count == 0 && mine.answer.overlaps == 0);
        return;
    }
    solve(3, &f->curve, &g->curve, o, &single);
    check_covered(&mine.answer, &single.answer);
    check_covered(&single.answer, &mine.answer);
    require(!is_all_unique(&mine.answer) || !is_all_unique(&single.answer) ||
            mine.answer.count == single.answer.count);
    if (pair < REFEREED)
        require(referee_agrees(&f->curve, &g->curve, &mine.answer, data, length));
}

static void try_batch(struct input *in, const uint8_t *data, size_t length)
{
    static struct fuzzed_batch b;
    uint8_t room = take(in);
    struct fatline_options o = draw_options(in);
    o.max_steps = least(o.max_steps, STEPS_OF_MANY);
    draw_batch(in, &b);
    solve_batch(&b, &o, room < 128 ? room : (int)BATCH_ROOM);
    for (int i = 0; i < b.count; i++)
        require(b.crossing[i].pair >= 0 && b.crossing[i].pair < b.pairs.count);
    for (int k = 0; k < b.pairs.count; k++)
        check_member(&b, k, &o, data, length);
}

#endif
