/* Paths as fatline.h has them: trees, walk, solver and records of path.h, in memory of the caller's, and on
 * from where it was full. */
#include <string.h>

#include "library_paths.h"

enum { BLOCK = 8192, RECORDS_MAX = 1 << 28, OVERLAP_SHARE = 8 };

_Static_assert((int)PATH_RECORDS_LEAST < (int)RECORDS_MAX, "there is room for some records");

/* This, then both paths, their trees and the solver's memory, each at an address that 64 divides. */
struct fatline_paths_workspace {
    size_t size;
    bool waits; /* for memory: a search has begun */
    bool self;
    struct taken_path a, b;
    struct path_tree tree_a, tree_b;
    struct path_solver solver;
    struct path_walk walk;
    struct path_pair block[BLOCK];
    int in_block, at; /* pairs in the block; so many are done */
    int singles;      /* segments that were looked at alone */
    long long done;
    struct path_records records;
};

/* ---- the caller's memory ---- */

/* Room and places of what lies there: records and overlaps as path.h has them, the numbers of
 * path_records_join, and both again as fatline.h has them. */
struct layout {
    int records, overlaps;
    size_t overlap, numbers, crossing, arc, end;
};

static size_t rounded(size_t bytes)
{
    return (bytes + 63) / 64 * 64;
}

static struct layout layout_of(int count_a, int count_b, int records)
{
    struct layout l;
    l.records = records;
    l.overlaps = PATH_OVERLAPS_LEAST + records / OVERLAP_SHARE;
    size_t count = (size_t)l.records, overlaps = (size_t)l.overlaps;
    l.overlap = rounded(count * sizeof(struct path_record));
    l.numbers = l.overlap + rounded(overlaps * sizeof(struct path_overlap));
    l.crossing = l.numbers + rounded(path_join_size(count_a, count_b, records));
    l.arc = l.crossing + rounded(count * sizeof(struct fatline_path_crossing));
    l.end = l.arc + rounded(overlaps * sizeof(struct fatline_path_overlap));
    return l;
}

/* The largest that fits; without records if there is none that path_solve takes. */
static struct layout layout_within(size_t size, int count_a, int count_b)
{
    int least = 0, most = RECORDS_MAX;
    while (least < most) {
        int middle = most - (most - least) / 2;
        if (layout_of(count_a, count_b, middle).end <= size) {
            least = middle;
        } else {
            most = middle - 1;
        }
    }
    return layout_of(count_a, count_b, least >= PATH_RECORDS_LEAST ? least : 0);
}

size_t fatline_paths_memory_size(const struct fatline_path *a, const struct fatline_path *b, int records)
{
    if (!path_taken_size(a) || (b && !path_taken_size(b)) || records < 0 ||
        records > (int)RECORDS_MAX - (int)PATH_RECORDS_LEAST) {
        return 0;
    }
    return layout_of(a->count, b ? b->count : 0, records + (int)PATH_RECORDS_LEAST).end;
}

/* ---- the workspace ---- */

static int degree_max(const struct fatline_path *p)
{
    int most = p && p->count > 0 && !p->degree ? 3 : 1;
    for (int i = 0; p && p->degree && i < p->count; i++) {
        most = p->degree[i] > most ? p->degree[i] : most;
    }
    return most;
}

static size_t solver_bytes(const struct fatline_path *a, const struct fatline_path *b)
{
    int n = degree_max(a), m = degree_max(b);
    return rounded(path_solver_size(n > m ? n : m));
}

size_t fatline_paths_workspace_size(const struct fatline_path *a, const struct fatline_path *b)
{
    enum { TO_ALIGN = 63 };
    size_t size_a = path_taken_size(a), size_b = b ? path_taken_size(b) : 0;
    if (!size_a || (b && !size_b)) {
        return 0;
    }
    size_t trees = rounded(path_tree_size(a->count)) + (b ? rounded(path_tree_size(b->count)) : 0);
    return rounded(sizeof(struct fatline_paths_workspace)) + TO_ALIGN + size_a + size_b + trees +
           solver_bytes(a, b);
}

struct fatline_paths_workspace *fatline_paths_workspace_init(void *memory, size_t size)
{
    const struct fatline_path none = {0, NULL, NULL, NULL, 0, NULL};
    if (!memory_fits(memory, size, fatline_paths_workspace_size(&none, NULL))) {
        return NULL;
    }
    struct fatline_paths_workspace *w = (struct fatline_paths_workspace *)memory;
    w->size = size;
    w->waits = false;
    return w;
}

/* ---- a search ---- */

static void begin(struct fatline_paths_workspace *w, const struct fatline_path *a,
                  const struct fatline_path *b, const struct fatline_options *o)
{
    char *at = (char *)w + rounded(sizeof *w);
    at += 63 - ((uintptr_t)at + 63) % 64;
    w->self = !b;
    path_take(a, at, &w->a);
    at += path_taken_size(a);
    path_tree_make(&w->tree_a, &w->a.path, at);
    at += rounded(path_tree_size(a->count));
    int degree = w->a.degree;
    if (b) {
        path_take(b, at, &w->b);
        at += path_taken_size(b);
        path_tree_make(&w->tree_b, &w->b.path, at);
        at += rounded(path_tree_size(b->count));
        degree = w->b.degree > degree ? w->b.degree : degree;
    }
    path_solver_init(&w->solver, &w->a.path, b ? &w->b.path : NULL, degree,
                     o && o->tolerance > 0 ? o->tolerance : 1e-10,
                     o && o->max_steps > 0 ? o->max_steps : (int)STEPS_MAX, at);
    path_walk_begin(&w->walk, &w->tree_a, b ? &w->tree_b : &w->tree_a);
    w->in_block = w->at = w->singles = 0;
    w->done = 0;
    memset(&w->records, 0, sizeof w->records);
}

/* false: there is no room for the rest of the block */
static bool solve_block(struct fatline_paths_workspace *w)
{
    int done = path_solve(&w->solver, w->block + w->at, w->in_block - w->at, &w->records);
    w->at += done;
    w->done += done;
    return w->at == w->in_block;
}

/* false: there is no room for more */
static bool search(struct fatline_paths_workspace *w)
{
    while (solve_block(w)) {
        w->at = 0;
        w->in_block = path_walk_next(&w->walk, w->block, BLOCK);
        if (w->in_block == 0) {
            break;
        }
    }
    if (w->at < w->in_block) {
        return false;
    }
    if (w->self) {
        int done = path_solve_loops(&w->solver, w->singles, w->a.path.count, &w->records);
        w->singles += done;
        w->done += done;
    }
    return !w->self || w->singles == w->a.path.count;
}

/* ---- the records ---- */

static void give_span(const struct path_span *s, struct fatline_path_span *to)
{
    to->first = s->first;
    to->last = s->last;
    to->lo = s->lo;
    to->hi = s->hi;
}

static void give_crossing(const struct path_record *r, struct fatline_path_crossing *to)
{
    static const enum fatline_standing standing[] = {FATLINE_CANDIDATE, FATLINE_UNIQUE, FATLINE_END,
                                                     FATLINE_CLUSTER};
    give_span(&r->a, &to->a);
    give_span(&r->b, &to->b);
    to->standing = standing[r->standing];
    to->at_most = r->standing == CANDIDATE ? 0 : r->at_most;
    to->overlap = r->overlap;
    to->joint = r->joint;
    to->chain = r->chain;
}

static void give_overlap(const struct path_overlap *o, struct fatline_path_overlap *to)
{
    to->a_inner_lo = o->a_inner.lo;
    to->a_inner_hi = o->a_inner.hi;
    to->b_inner_lo = o->b_inner.lo;
    to->b_inner_hi = o->b_inner.hi;
    to->distance = o->distance;
    to->reversed = o->reversed;
}

static void give_all(struct fatline_paths_workspace *w, const struct layout *l,
                     struct fatline_paths_answer *out)
{
    char *memory = (char *)out->memory;
    struct fatline_path_crossing *crossing = (struct fatline_path_crossing *)(void *)(memory + l->crossing);
    struct fatline_path_overlap *overlap = (struct fatline_path_overlap *)(void *)(memory + l->arc);
    path_records_join(&w->solver, &w->records, memory + l->numbers);
    for (int i = 0; i < w->records.count; i++) {
        give_crossing(&w->records.at[w->records.order[i]], &crossing[i]);
    }
    for (int i = 0; i < w->records.overlaps; i++) {
        give_overlap(&w->records.overlap[i], &overlap[i]);
    }
    out->crossing = crossing;
    out->overlap = overlap;
    out->count = w->records.count;
    out->overlaps = w->records.overlaps;
}

/* ---- a call ---- */

static const char *error_of(const struct fatline_paths_workspace *w, const struct fatline_path *a,
                            const struct fatline_path *b, const struct fatline_options *o, long long first,
                            struct fatline_paths_answer *out)
{
    if (!memory_fits(out->memory, 1, 1)) {
        return "the memory of the answer is missing or not aligned";
    }
    if (first != 0) {
        return w->waits && first == w->done ? NULL
                                            : "first is neither 0 nor where a call ended for want of room";
    }
    const char *error = path_error(a, false, &out->segment);
    if (!error && b) {
        error = path_error(b, true, &out->segment);
    }
    error = error ? error : options_error(o);
    if (!error && fatline_paths_workspace_size(a, b) > w->size) {
        error = "the workspace is too small for these paths";
    }
    return error;
}

/* Where the records so far are, and from now on: overlaps move up with the room below them. */
static bool use_memory(struct fatline_paths_workspace *w, const struct layout *l, void *memory)
{
    struct path_records *r = &w->records;
    if (l->records < r->room) {
        return false;
    }
    size_t before = layout_of(0, 0, r->room).overlap;
    memmove((char *)memory + l->overlap, (char *)memory + before, (size_t)r->overlaps * sizeof *r->overlap);
    r->at = (struct path_record *)memory;
    r->overlap = (struct path_overlap *)(void *)((char *)memory + l->overlap);
    r->room = l->records;
    r->overlap_room = l->overlaps;
    return true;
}

enum fatline_outcome fatline_paths(struct fatline_paths_workspace *w, const struct fatline_path *a,
                                   const struct fatline_path *b, const struct fatline_options *options,
                                   long long first, struct fatline_paths_answer *out)
{
    out->count = out->overlaps = 0;
    out->crossing = NULL;
    out->overlap = NULL;
    out->segment = -1;
    out->done = first;
    out->open = 0;
    out->error = error_of(w, a, b, options, first, out);
    if (out->error) {
        return FATLINE_INVALID;
    }
    if (first == 0) {
        begin(w, a, b, options);
    }
    struct layout l = layout_within(out->size, w->a.path.count, w->self ? 0 : w->b.path.count);
    w->waits = l.records == 0 || !use_memory(w, &l, out->memory) || !search(w);
    out->done = w->done;
    out->open = w->solver.unsolved;
    if (w->waits) {
        return FATLINE_OUT_OF_ROOM;
    }
    give_all(w, &l, out);
    return out->open > 0 ? FATLINE_OUT_OF_STEPS : FATLINE_SOLVED;
}
