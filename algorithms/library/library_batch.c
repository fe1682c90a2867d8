/* Pairs as fatline.h has them to pairs as batch.h has them, block by block, and the records back. */
#include "../batch.h"
#include "library.h"

/* A block is a chunk of batch.c, with room for nine records of every pair, or any number of one. */
enum { BLOCK = 512, RECORDS = 9 * (int)BLOCK + (int)CROSSINGS_MAX, OVERLAPS = 256 + (int)OVERLAPS_MAX };

_Static_assert((int)FATLINE_SOLVED == (int)SOLVED && (int)FATLINE_OUT_OF_STEPS == (int)OUT_OF_STEPS &&
                   (int)FATLINE_OUT_OF_ROOM == (int)OUT_OF_ROOM &&
                   (int)FATLINE_UNSUPPORTED == (int)UNSUPPORTED && (int)FATLINE_INVALID == (int)INVALID,
               "outcomes of pairs are handed on as they are");

struct fatline_batch_workspace {
    struct batch_record record[RECORDS];
    struct batch_overlap overlap[OVERLAPS];
};

/* ---- memory ---- */

static size_t head_size(void)
{
    enum { ALIGN = 64 };
    return (sizeof(struct fatline_batch_workspace) + ALIGN - 1) / ALIGN * ALIGN;
}

size_t fatline_batch_workspace_size(void)
{
    return head_size() + batch_workspace_size();
}

struct fatline_batch_workspace *fatline_batch_workspace_init(void *memory, size_t size)
{
    return memory_fits(memory, size, fatline_batch_workspace_size())
               ? (struct fatline_batch_workspace *)memory
               : NULL;
}

/* ---- what is wrong? ---- */

static const char *error_of(const struct fatline_pairs *p, int first, const struct fatline_batch_answer *out)
{
    if (!p || !p->f.points || !p->g.points) {
        return "the pairs or the points of a table are missing";
    }
    if (p->count < 0 || first < 0 || first > p->count) {
        return "first is not within 0 and the number of pairs";
    }
    if (out->room < 0 || out->overlap_room < 0 || (out->room > 0 && !out->crossing) ||
        (out->overlap_room > 0 && !out->overlap) || (p->count > 0 && !out->outcome)) {
        return "an array of the answer is missing, or its room is negative";
    }
    return NULL;
}

static bool has_curve(const struct fatline_table *t, const int *index, int pair)
{
    int i = index ? index[pair] : pair;
    return i >= 0 && i < t->count;
}

/* The first pair from `first` on, before `last`, that names a curve which is not there; or `last`. */
static int pairs_named(const struct fatline_pairs *p, int first, int last)
{
    int k = first;
    while (k < last && has_curve(&p->f, p->f_index, k) && has_curve(&p->g, p->g_index, k)) {
        k++;
    }
    return k;
}

/* ---- a block ---- */

static void give(const struct fatline_batch_workspace *w, const struct batch_answer *found,
                 struct fatline_batch_answer *out)
{
    for (int i = 0; i < found->records; i++) {
        struct fatline_batch_crossing *to = &out->crossing[out->count++];
        to->pair = w->record[i].pair;
        crossing_public(&w->record[i].at, &to->at);
    }
    for (int i = 0; i < found->overlaps; i++) {
        struct fatline_batch_overlap *to = &out->overlap[out->overlaps++];
        to->pair = w->overlap[i].pair;
        overlap_public(&w->overlap[i].at, 0, &to->at);
    }
    out->done = found->done;
}

/* The pairs from out->done on, of the first b->pairs, as far as there is room.  A single pair has room in w:
 * where none is settled, it is the caller's arrays that are full. */
static bool solve_block(struct fatline_batch_workspace *w, const struct batch *b,
                        struct fatline_batch_answer *out)
{
    int room = out->room - out->count, overlap_room = out->overlap_room - out->overlaps, before = out->done;
    struct batch_answer found = {.record = w->record,
                                 .overlap = w->overlap,
                                 .outcome = out->outcome,
                                 .record_room = room < RECORDS ? room : RECORDS,
                                 .overlap_room = overlap_room < OVERLAPS ? overlap_room : OVERLAPS};
    batch_solve(b, before, (char *)w + head_size(), &found);
    give(w, &found, out);
    return out->done > before;
}

static struct batch batch_of(const struct fatline_pairs *p, const struct fatline_options *o)
{
    struct batch b = {.f = {p->f.points, p->f.degree},
                      .g = {p->g.points, p->g.degree},
                      .f_index = p->f_index,
                      .g_index = p->g_index,
                      .tolerance = o && o->tolerance > 0 ? o->tolerance : TOLERANCE_USUAL,
                      .max_steps = o && o->max_steps > 0 ? o->max_steps : (int)STEPS_MAX,
                      .variant = BATCH_BEST};
    return b;
}

enum fatline_outcome fatline_batch(struct fatline_batch_workspace *w, const struct fatline_pairs *pairs,
                                   const struct fatline_options *options, int first,
                                   struct fatline_batch_answer *out)
{
    out->count = out->overlaps = 0;
    out->done = first;
    out->error = error_of(pairs, first, out);
    out->error = out->error ? out->error : options_error(options);
    if (out->error) {
        return FATLINE_INVALID;
    }
    struct batch b = batch_of(pairs, options);
    while (out->done < pairs->count) {
        int left = pairs->count - out->done;
        b.pairs = pairs_named(pairs, out->done, out->done + (left < BLOCK ? left : BLOCK));
        if (b.pairs == out->done) {
            out->error = "an index of pair number `done` is not within its table";
            return FATLINE_INVALID;
        }
        if (!solve_block(w, &b, out)) {
            return FATLINE_OUT_OF_ROOM;
        }
    }
    return FATLINE_SOLVED;
}
