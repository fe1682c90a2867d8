/* Many pairs: chunk by chunk through the lanes, then those that these left alone, one by one. */
#include <string.h>

#include "batch_chunk.h"

#if defined(__x86_64__) && !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)
#define HAS_LANES 1
#else
#define HAS_LANES 0
#endif

extern const struct intersector certified;
extern const struct intersector *const batch_algorithm;
const struct intersector *const batch_algorithm = &certified;

enum { DEGREE = 3, CUBIC_ROOM = 1 /* cells, of which `certified` uses none */ };

/* ---- memory ---- */

static size_t rounded(size_t bytes)
{
    return (bytes + 63) / 64 * 64;
}

static size_t single_size(void)
{
    return rounded(workspace_size(DEGREE, DEGREE, CUBIC_ROOM, certified.scratch(DEGREE, DEGREE)));
}

size_t batch_workspace_size(void)
{
    return single_size() + rounded(sizeof(struct crossings)) + sizeof(struct batch_chunk);
}

struct batch_solver {
    struct workspace single;
    struct crossings *crossings;
    struct batch_chunk *chunk;
};

static void solver_init(struct batch_solver *z, void *memory)
{
    char *at = (char *)memory;
    workspace_init(&z->single, at, DEGREE, DEGREE, CUBIC_ROOM, certified.scratch(DEGREE, DEGREE));
    at += single_size();
    z->crossings = (struct crossings *)(void *)at;
    at += rounded(sizeof(struct crossings));
    z->chunk = (struct batch_chunk *)(void *)at;
    for (int i = 0; i < CHUNK + SLACK; i++) {
        z->chunk->all[i] = i;
    }
}

/* ---- which variant ---- */

bool batch_has(enum batch_variant variant)
{
#if HAS_LANES
    if (variant == BATCH_AVX2) {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    }
    if (variant == BATCH_AVX512) {
        return batch_has(BATCH_AVX2) && __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    }
#endif
    return variant == BATCH_BEST || variant == BATCH_PORTABLE;
}

static enum batch_variant choose(enum batch_variant asked)
{
    if (asked != BATCH_BEST) {
        return asked;
    }
    return batch_has(BATCH_AVX512) ? BATCH_AVX512 : batch_has(BATCH_AVX2) ? BATCH_AVX2 : BATCH_PORTABLE;
}

/* ---- one by one ---- */

static void curve_of(const struct batch_curves *from, const int *index, int pair, struct curve *out)
{
    ptrdiff_t i = index ? index[pair] : pair;
    out->degree = from->degree ? from->degree[i] : (int)DEGREE;
    out->x = from->points + BATCH_NUMBERS * i;
    out->y = out->x + BATCH_NUMBERS / 2;
    out->w = NULL;
    out->domain.lo = 0;
    out->domain.hi = 1;
}

/* false: no room */
static bool solve_alone(struct batch_solver *z, const struct batch *b, int pair, struct batch_answer *out)
{
    struct problem p;
    struct crossings *c = z->crossings;
    memset((void *)&p, 0, sizeof p);
    curve_of(&b->f, b->f_index, pair, &p.f);
    curve_of(&b->g, b->g_index, pair, &p.g);
    p.tolerance = b->tolerance;
    p.max_steps = b->max_steps;
    c->count = c->overlaps = 0;
    enum outcome outcome =
        p.f.degree <= DEGREE && p.g.degree <= DEGREE ? problem_solve(&p, &certified, &z->single, c) : INVALID;
    if (c->count > out->record_room - out->records || c->overlaps > out->overlap_room - out->overlaps) {
        return false;
    }
    for (int i = 0; i < c->count; i++) {
        struct batch_record *r = &out->record[out->records++];
        r->at = c->at[i];
        r->pair = pair;
    }
    for (int i = 0; i < c->overlaps; i++) {
        struct batch_overlap *o = &out->overlap[out->overlaps++];
        o->at = c->overlap[i];
        o->pair = pair;
    }
    out->outcome[pair] = (unsigned char)outcome;
    out->alone++;
    return true;
}

static bool solve_each(struct batch_solver *z, const struct batch *b, int count, struct batch_answer *out)
{
    for (int i = 0; i < count; i++) {
        if (!solve_alone(z, b, out->done, out)) {
            return false;
        }
        out->done++;
    }
    return true;
}

/* ---- a chunk ---- */

#if HAS_LANES

/* Drops the records of pairs that are to be solved by themselves. */
static int records_keep(const struct batch_chunk *c)
{
    int kept = 0;
    for (int i = 0; i < c->records; i++) {
        if (!c->alone[c->record[i].pair - c->first]) {
            c->record[kept++] = c->record[i];
        }
    }
    return kept;
}

static bool is_degree(const struct batch_curves *from, const int *index, int pair)
{
    int degree = from->degree ? from->degree[index ? index[pair] : pair] : (int)DEGREE;
    return degree >= 1 && degree <= DEGREE;
}

/* Pairs of degrees that there are not. */
static void mark_invalid(struct batch_chunk *c)
{
    const struct batch *b = c->batch;
    for (int i = 0; i < c->count && (b->f.degree || b->g.degree); i++) {
        c->alone[i] =
            !is_degree(&b->f, b->f_index, c->first + i) || !is_degree(&b->g, b->g_index, c->first + i);
        c->alone_count += c->alone[i];
    }
}

/* The next `count` pairs.  false: no room; the answer is as it was. */
static bool solve_chunk(struct batch_solver *z, const struct batch *b, enum batch_variant variant, int count,
                        struct batch_answer *out)
{
    struct batch_chunk *c = z->chunk;
    const struct batch_answer before = *out;
    c->batch = b;
    c->tolerance = (double)real_min(1.0 / 16, real_max(4 * REAL_EPSILON, b->tolerance));
    c->first = out->done;
    c->count = count;
    c->record = out->record + out->records;
    c->room = out->record_room - out->records;
    c->records = c->alone_count = 0;
    for (int i = 0; i < SLACK; i++) {
        c->all[count + i] = count - 1;
    }
    c->full = false;
    memset(c->alone, 0, (size_t)count);
    memset(out->outcome + out->done, SOLVED, (size_t)count);
    mark_invalid(c);
    if (variant == BATCH_AVX512) {
        batch_chunk_avx512(c);
    } else {
        batch_chunk_avx2(c);
    }
    for (int i = 0; i < SLACK; i++) {
        c->all[count + i] = count + i;
    }
    out->records += c->alone_count ? records_keep(c) : c->records;
    bool good = !c->full;
    for (int i = 0, left = c->alone_count; good && left > 0; i++) {
        if (c->alone[i]) {
            good = solve_alone(z, b, c->first + i, out);
            left--;
        }
    }
    if (!good) {
        *out = before;
        return false;
    }
    out->done += count;
    return true;
}

/* Where the room ends, smaller chunks show which pair is the first without. */
static bool solve_in_chunks(struct batch_solver *z, const struct batch *b, enum batch_variant variant,
                            struct batch_answer *out)
{
    int most = CHUNK;
    while (out->done < b->pairs) {
        int left = b->pairs - out->done, count = left < most ? left : most;
        if (solve_chunk(z, b, variant, count, out)) {
            continue;
        }
        if (count < 2 * SLACK && !solve_each(z, b, count, out)) {
            return false;
        }
        most = count < 2 * SLACK ? count : count / 2;
    }
    return true;
}

#endif

enum outcome batch_solve(const struct batch *b, int first, void *workspace, struct batch_answer *out)
{
    struct batch_solver z;
    enum batch_variant variant = choose(b->variant);
    out->records = out->overlaps = out->alone = 0;
    out->done = first;
    if (!(b->tolerance > 0) || !real_is_finite(b->tolerance) || b->max_steps <= 0 || first < 0 ||
        first > b->pairs || !batch_has(variant)) {
        return INVALID;
    }
    solver_init(&z, workspace);
#if HAS_LANES
    if (variant != BATCH_PORTABLE) {
        return solve_in_chunks(&z, b, variant, out) ? SOLVED : OUT_OF_ROOM;
    }
#endif
    return solve_each(&z, b, b->pairs - first, out) ? SOLVED : OUT_OF_ROOM;
}
