/* fatline_batch says what batch_solve says, bit for bit, and of each pair what fatline_intersect says; with
 * little room it does so in more calls; what is no problem is called so, and harms no other pair. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"

#include "../algorithms/batch.h"
#include "../algorithms/fatline.h"

enum { CURVES = 400, PAIRS = 2700, ROOM = 12000, OVERLAP_ROOM = 2 * (int)PAIRS };

/* Two tables and pairs of both: some of a curve with itself or with the same curve reversed. */
static struct {
    double f[8 * CURVES], g[8 * CURVES];
    unsigned char f_degree[CURVES], g_degree[CURVES];
    int f_index[PAIRS], g_index[PAIRS];
    struct fatline_pairs pairs;
} table;

/* What is beyond the degree must not matter. */
static void draw(struct random_state *r, double *points, unsigned char *degree)
{
    *degree = (unsigned char)random_between(r, 1, 3);
    for (int i = 0; i < 8; i++)
        points[i] = i % 4 <= *degree ? prop_dyadic(r, 20) : NAN;
}

static void draw_table(uint64_t seed)
{
    struct random_state r = random_for(seed, "library_batch", 0);
    for (int i = 0; i < CURVES; i++) {
        draw(&r, table.f + 8 * i, &table.f_degree[i]);
        draw(&r, table.g + 8 * i, &table.g_degree[i]);
        int n = table.f_degree[i];
        table.g_degree[i] = i % 50 ? table.g_degree[i] : (unsigned char)n;
        for (int k = 0; i % 50 == 0 && k < 8; k++)
            table.g[8 * i + k] = k % 4 <= n ? table.f[8 * i + k / 4 * 4 + n - k % 4] : NAN;
    }
    for (int k = 0; k < PAIRS; k++) {
        table.f_index[k] = k < CURVES ? k : (int)random_between(&r, 0, CURVES - 1);
        table.g_index[k] = k < CURVES ? k : (int)random_between(&r, 0, CURVES - 1);
    }
    struct fatline_pairs p = {{CURVES, table.f, table.f_degree},
                              {CURVES, table.g, table.g_degree},
                              table.f_index,
                              table.g_index,
                              PAIRS};
    table.pairs = p;
}

/* ---- a call ---- */

struct run {
    void *memory;
    struct fatline_batch_workspace *w;
    struct fatline_batch_answer a;
};

/* Arrays end where valgrind and the sanitizers see it, outcomes before they are given are none. */
static void run_init(struct run *z, int room, int overlap_room)
{
    size_t size = fatline_batch_workspace_size();
    z->memory = malloc(size);
    z->w = fatline_batch_workspace_init(z->memory, size);
    assert_non_null(z->w);
    memset(&z->a, 0, sizeof z->a);
    z->a.crossing = (struct fatline_batch_crossing *)malloc((size_t)room * sizeof *z->a.crossing);
    z->a.overlap = (struct fatline_batch_overlap *)malloc((size_t)overlap_room * sizeof *z->a.overlap);
    z->a.outcome = (unsigned char *)malloc(PAIRS);
    memset(z->a.outcome, 99, PAIRS);
    z->a.room = room;
    z->a.overlap_room = overlap_room;
}

static void run_clear(struct run *z)
{
    free(z->a.crossing);
    free(z->a.overlap);
    free(z->a.outcome);
    free(z->memory);
}

static void solve_all(struct run *z)
{
    run_init(z, ROOM, OVERLAP_ROOM);
    assert_int_equal(fatline_batch(z->w, &table.pairs, NULL, 0, &z->a), FATLINE_SOLVED);
    assert_null(z->a.error);
    assert_int_equal(z->a.done, table.pairs.count);
}

/* ---- the same as batch_solve ---- */

static struct batch_record record[ROOM];
static struct batch_overlap overlap[OVERLAP_ROOM];
static unsigned char outcome[PAIRS];

static void same_crossing(const struct fatline_batch_crossing *c, const struct batch_record *d)
{
    static const enum standing standing[] = {CANDIDATE, UNIQUE, END, CLUSTER};
    assert_int_equal(c->pair, d->pair);
    assert_true(c->at.t_lo == d->at.t.lo && c->at.t_hi == d->at.t.hi);
    assert_true(c->at.s_lo == d->at.s.lo && c->at.s_hi == d->at.s.hi);
    assert_int_equal(standing[c->at.standing], d->at.standing);
    assert_int_equal(c->at.at_most, d->at.standing == CANDIDATE ? 0 : d->at.at_most);
    assert_true(c->at.standing == FATLINE_CANDIDATE || c->at.at_most > 0);
}

static void same_overlap(const struct fatline_batch_overlap *c, const struct batch_overlap *d)
{
    const struct fatline_overlap *a = &c->at;
    const struct overlap *b = &d->at;
    assert_int_equal(c->pair, d->pair);
    assert_true(a->t_outer_lo == b->t_outer.lo && a->t_outer_hi == b->t_outer.hi);
    assert_true(a->s_outer_lo == b->s_outer.lo && a->s_outer_hi == b->s_outer.hi);
    assert_true(a->t_inner_lo == b->t_inner.lo && a->t_inner_hi == b->t_inner.hi);
    assert_true(a->s_inner_lo == b->s_inner.lo && a->s_inner_hi == b->s_inner.hi);
    assert_true(a->distance == b->distance && a->reversed == b->reversed);
}

static void same_as_the_batch(void **state)
{
    (void)state;
    draw_table(1);
    struct run z;
    solve_all(&z);
    struct batch b = {{table.f, table.f_degree},
                      {table.g, table.g_degree},
                      table.f_index,
                      table.g_index,
                      PAIRS,
                      1e-12,
                      STEPS_MAX,
                      BATCH_BEST};
    struct batch_answer d = {record, overlap, outcome, ROOM, OVERLAP_ROOM, 0, 0, 0, 0};
    void *memory = malloc(batch_workspace_size());
    assert_int_equal(batch_solve(&b, 0, memory, &d), SOLVED);
    assert_int_equal(z.a.count, d.records);
    assert_int_equal(z.a.overlaps, d.overlaps);
    for (int i = 0; i < d.records; i++)
        same_crossing(&z.a.crossing[i], &record[i]);
    for (int i = 0; i < d.overlaps; i++)
        same_overlap(&z.a.overlap[i], &overlap[i]);
    for (int k = 0; k < PAIRS; k++)
        assert_int_equal(z.a.outcome[k] == FATLINE_SOLVED, outcome[k] == SOLVED);
    assert_true(z.a.count > PAIRS / 3 && z.a.overlaps >= CURVES / 50);
    free(memory);
    run_clear(&z);
}

/* ---- the same as single calls ---- */

static bool meet(const struct fatline_crossing *a, const struct fatline_crossing *b)
{
    return a->standing == b->standing && a->at_most == b->at_most && a->t_lo <= b->t_hi &&
           b->t_lo <= a->t_hi && a->s_lo <= b->s_hi && b->s_lo <= a->s_hi;
}

static void points_of(const struct fatline_table *t, int i, double *points, struct fatline_curve *c)
{
    c->degree = t->degree[i];
    c->points = points;
    c->weights = NULL;
    for (int k = 0; k <= c->degree; k++) {
        points[2 * k] = t->points[8 * i + k];
        points[2 * k + 1] = t->points[8 * i + 4 + k];
    }
}

static void same_as_single(const struct fatline_batch_answer *a, int pair, struct fatline_workspace *w)
{
    double p[8], q[8];
    struct fatline_curve f, g;
    struct fatline_answer alone;
    int count = 0, overlaps = 0;
    points_of(&table.pairs.f, table.f_index[pair], p, &f);
    points_of(&table.pairs.g, table.g_index[pair], q, &g);
    assert_int_equal(fatline_intersect(w, &f, &g, NULL, &alone), a->outcome[pair]);
    for (int i = 0; i < a->overlaps; i++)
        overlaps += a->overlap[i].pair == pair;
    for (int i = 0; i < a->count; i++) {
        bool met = a->crossing[i].pair != pair;
        count += !met;
        for (int k = 0; k < alone.count && !met; k++)
            met = meet(&a->crossing[i].at, &alone.crossing[k]);
        assert_true(met);
    }
    assert_int_equal(count, alone.count);
    assert_int_equal(overlaps, alone.overlaps);
}

static void same_as_single_calls(void **state)
{
    (void)state;
    draw_table(2);
    struct run z;
    solve_all(&z);
    size_t size = fatline_workspace_size(3);
    void *memory = malloc(size);
    struct fatline_workspace *w = fatline_workspace_init(memory, size, 3);
    for (int k = 0; k < PAIRS; k++)
        same_as_single(&z.a, k, w);
    free(memory);
    run_clear(&z);
}

/* ---- little room ---- */

/* Every call gives whole pairs and gets on; all together give as many records of each pair. */
static void room_for_few(void **state)
{
    (void)state;
    static const int rooms[] = {9, 10, 23, 64, 400};
    draw_table(3);
    struct run whole;
    solve_all(&whole);
    for (int i = 0; i < 5; i++) {
        static int left[PAIRS];
        memset(left, 0, sizeof left);
        for (int k = 0; k < whole.a.count; k++)
            left[whole.a.crossing[k].pair]++;
        struct run part;
        int first = 0, overlaps = 0, calls = 0;
        run_init(&part, rooms[i], 2);
        for (enum fatline_outcome o = FATLINE_OUT_OF_ROOM; o == FATLINE_OUT_OF_ROOM; calls++) {
            o = fatline_batch(part.w, &table.pairs, NULL, first, &part.a);
            assert_true(o == FATLINE_SOLVED ? part.a.done == PAIRS : part.a.done > first);
            assert_true(part.a.count <= rooms[i] && part.a.overlaps <= 2);
            for (int k = 0; k < part.a.count; k++) {
                assert_in_range(part.a.crossing[k].pair, first, part.a.done - 1);
                left[part.a.crossing[k].pair]--;
            }
            overlaps += part.a.overlaps;
            first = part.a.done;
        }
        assert_true(calls >= whole.a.count / rooms[i]);
        assert_int_equal(overlaps, whole.a.overlaps);
        assert_memory_equal(part.a.outcome, whole.a.outcome, PAIRS);
        for (int k = 0; k < PAIRS; k++)
            assert_int_equal(left[k], 0);
        run_clear(&part);
    }
    struct run none;
    run_init(&none, 0, 0);
    assert_int_equal(fatline_batch(none.w, &table.pairs, NULL, 0, &none.a), FATLINE_OUT_OF_ROOM);
    assert_true(none.a.count == 0 && none.a.done < PAIRS && !none.a.error);
    run_clear(&none);
    run_clear(&whole);
}

/* Shared arcs in all pairs: the library's own arrays are full before the caller's. */
static void arcs_in_all(void **state)
{
    (void)state;
    draw_table(7);
    for (int k = 0; k < PAIRS; k++)
        table.f_index[k] = table.g_index[k] = k / 50 * 50 % CURVES;
    struct run z;
    solve_all(&z);
    assert_true(z.a.overlaps >= PAIRS);
    for (int k = 50; k < PAIRS; k++) /* groups of fifty are the same pair */
        assert_int_equal(z.a.outcome[k], z.a.outcome[k / 50 * 50]);
    int count[PAIRS] = {0};
    for (int i = 0; i < z.a.overlaps; i++)
        count[z.a.overlap[i].pair]++;
    for (int k = 0; k < PAIRS; k++)
        assert_true(count[k] >= 1 && count[k] == count[k / 50 * 50]);
    run_clear(&z);
}

/* ---- what is no problem ---- */

/* A pair with such a curve is INVALID and has no records; all others have as many as ever. */
static void bad_curves(void **state)
{
    (void)state;
    enum { BAD = 4 };
    static const double values[] = {INFINITY, -INFINITY, NAN};
    draw_table(4);
    struct run before, after;
    solve_all(&before);
    for (int i = 0; i < 3; i++)
        table.f[8 * i + 4 + table.f_degree[i]] = values[i];
    table.f_degree[3] = 0;
    table.g_degree[BAD] = 4;
    solve_all(&after);
    int records[2] = {0, 0}, invalid = 0;
    for (int k = 0; k < PAIRS; k++) {
        bool bad = table.f_index[k] < BAD || table.g_index[k] == BAD;
        assert_int_equal(after.a.outcome[k], bad ? FATLINE_INVALID : before.a.outcome[k]);
        invalid += bad;
    }
    assert_true(invalid > BAD);
    for (int i = 0; i < before.a.count; i++)
        records[0] +=
            before.a.outcome[before.a.crossing[i].pair] == after.a.outcome[before.a.crossing[i].pair];
    for (int i = 0; i < after.a.count; i++) {
        assert_int_not_equal(after.a.outcome[after.a.crossing[i].pair], FATLINE_INVALID);
        records[1]++;
    }
    assert_int_equal(records[0], records[1]);
    run_clear(&before);
    run_clear(&after);
}

/* Wherever an index leads out of its table, the pairs before are settled and the curve is not looked for. */
static void bad_indices(void **state)
{
    (void)state;
    static const int at[] = {0, 1, 511, 1024, 1500, PAIRS - 1},
                     index[] = {-1, CURVES, 2147483647, -2147483647};
    draw_table(5);
    struct run z;
    run_init(&z, ROOM, OVERLAP_ROOM);
    for (int i = 0; i < 24; i++) {
        int *bad = (i & 1 ? table.f_index : table.g_index) + at[i / 4], kept = *bad;
        *bad = index[i % 4];
        memset(z.a.outcome, 99, PAIRS);
        assert_int_equal(fatline_batch(z.w, &table.pairs, NULL, 0, &z.a), FATLINE_INVALID);
        assert_int_equal(z.a.done, at[i / 4]);
        assert_non_null(strstr(z.a.error, "index"));
        for (int k = 0; k < PAIRS; k++)
            assert_true(k < z.a.done ? z.a.outcome[k] <= FATLINE_INVALID : z.a.outcome[k] == 99);
        for (int k = 0; k < z.a.count; k++)
            assert_true(z.a.crossing[k].pair < z.a.done);
        assert_true(z.a.done < 500 || z.a.count > z.a.done / 3);
        *bad = kept;
    }
    table.pairs.f_index = NULL; /* more pairs than curves */
    assert_int_equal(fatline_batch(z.w, &table.pairs, NULL, 0, &z.a), FATLINE_INVALID);
    assert_int_equal(z.a.done, CURVES);
    run_clear(&z);
}

static void expect_error(struct run *z, const struct fatline_pairs *p, const struct fatline_options *o,
                         int first, const char *error)
{
    assert_int_equal(fatline_batch(z->w, p, o, first, &z->a), FATLINE_INVALID);
    assert_true(z->a.count == 0 && z->a.overlaps == 0 && z->a.done == first);
    if (!z->a.error || !strstr(z->a.error, error))
        fail_msg("\"%s\" does not say \"%s\"", z->a.error, error);
}

static void mistakes_are_told(void **state)
{
    (void)state;
    draw_table(6);
    struct run z;
    run_init(&z, ROOM, OVERLAP_ROOM);
    struct fatline_pairs p = table.pairs;
    const struct fatline_options tolerance = {-1, 0}, none = {NAN, 0}, steps = {0, -1}, few = {0, 1};
    expect_error(&z, NULL, NULL, 0, "missing");
    expect_error(&z, &p, NULL, -1, "first");
    expect_error(&z, &p, NULL, PAIRS + 1, "first");
    expect_error(&z, &p, &tolerance, 0, "tolerance");
    expect_error(&z, &p, &none, 0, "tolerance");
    expect_error(&z, &p, &steps, 0, "max_steps");
    p.g.points = NULL;
    expect_error(&z, &p, NULL, 0, "missing");
    struct fatline_batch_answer kept = z.a;
    z.a.outcome = NULL;
    expect_error(&z, &table.pairs, NULL, 0, "array");
    z.a = kept;
    z.a.room = -1;
    expect_error(&z, &table.pairs, NULL, 0, "array");
    z.a = kept;
    z.a.overlap = NULL;
    expect_error(&z, &table.pairs, NULL, 0, "array");
    z.a = kept;
    assert_int_equal(fatline_batch(z.w, &table.pairs, NULL, PAIRS, &z.a), FATLINE_SOLVED);
    assert_true(z.a.count == 0 && z.a.done == PAIRS && !z.a.error);
    assert_int_equal(fatline_batch(z.w, &table.pairs, &few, 0, &z.a), FATLINE_SOLVED);
    int stopped = 0;
    for (int k = 0; k < PAIRS; k++)
        stopped += z.a.outcome[k] == FATLINE_OUT_OF_STEPS;
    assert_true(stopped > 0);
    run_clear(&z);
}

static void memory_is_checked(void **state)
{
    (void)state;
    size_t size = fatline_batch_workspace_size();
    char *memory = malloc(size + 1);
    assert_true(size < 1000000);
    assert_null(fatline_batch_workspace_init(NULL, size));
    assert_null(fatline_batch_workspace_init(memory, size - 1));
    assert_null(fatline_batch_workspace_init(memory + 1, size));
    assert_non_null(fatline_batch_workspace_init(memory, size));
    free(memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_as_the_batch), cmocka_unit_test(same_as_single_calls),
        cmocka_unit_test(room_for_few),      cmocka_unit_test(bad_curves),
        cmocka_unit_test(bad_indices),       cmocka_unit_test(mistakes_are_told),
        cmocka_unit_test(memory_is_checked), cmocka_unit_test(arcs_in_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
