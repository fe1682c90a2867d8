/* A batch says of every pair what a single call says: the same outcome, the same records with the same
 * standings, intervals that meet; whatever the pairs are, however many, whichever variant solves them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../algorithms/batch.h"
#include "../harness/cases/case.h"
#include "../harness/cases/number.h"
#include "../harness/cases/problem.h"
#include "../harness/truth/referee.h"

enum {
    SHARE = REAL_BITS > 113  ? 60 /* of the pairs one in so many */
            : REAL_BITS > 53 ? 10
                             : 1,
    GUARD = 256,
    GUARD_BYTE = 0xa5,
    ROOM = 20000,
    PAIRS = 3000
};

static const real tolerance = (real)1 / 1000000000;
static const enum batch_variant variants[] = {BATCH_PORTABLE, BATCH_AVX2, BATCH_AVX512, BATCH_BEST};
static char generator[4096];
static struct crossings crossings;

/* The best is one of the others, so that it need not be tried where there is but one. */
static bool is_tried(enum batch_variant variant)
{
    return batch_has(variant) && (variant != BATCH_BEST || batch_has(BATCH_AVX2));
}

/* ---- pairs ---- */

struct table {
    int pairs;
    real f[(int)PAIRS * BATCH_NUMBERS], g[(int)PAIRS * BATCH_NUMBERS];
    unsigned char degree_f[PAIRS], degree_g[PAIRS];
};

static struct table table;

/* What is beyond the degree must not matter. */
static void put(const struct curve *c, real *to, unsigned char *degree)
{
    *degree = (unsigned char)c->degree;
    for (int k = 0; k < 4; k++) {
        bool there = k <= c->degree;
        to[k] = there ? c->x[k] : (real)NAN;
        to[4 + k] = there ? c->y[k] : (real)NAN;
    }
}

static void add(const struct curve *f, const struct curve *g)
{
    int i = table.pairs++;
    assert_true(i < PAIRS);
    put(f, table.f + BATCH_NUMBERS * i, &table.degree_f[i]);
    put(g, table.g + BATCH_NUMBERS * i, &table.degree_g[i]);
}

static void rescale(int pair, int e)
{
    for (int k = 0; k < BATCH_NUMBERS; k++) {
        real *a = &table.f[BATCH_NUMBERS * pair + k], *b = &table.g[BATCH_NUMBERS * pair + k];
        *a = real_ldexp(*a, e);
        *b = real_ldexp(*b, e);
    }
}

/* Calls with each case of the family. */
static void each_case(const char *family, const char *degrees, int count, void (*call)(struct test_case *))
{
    struct case_reader reader;
    struct test_case c;
    char command[sizeof generator + 256];
    count = count / SHARE ? count / SHARE : 1;
    snprintf(command, sizeof command, "'%s' %s --degree %s --count %d --seed 5", generator, family, degrees,
             count);
    FILE *stream = popen(command, "r");
    assert_non_null(stream);
    case_reader_init(&reader, stream, family);
    while (case_read(&reader, &c) == CASE_READ) {
        call(&c);
        case_clear(&c);
    }
    case_reader_clear(&reader);
    assert_int_equal(pclose(stream), 0);
}

static void add_case(struct test_case *c)
{
    struct owned_problem p;
    assert_null(owned_problem_make(c, tolerance, 20000, &p));
    add(&p.problem.f, &p.problem.g);
    owned_problem_clear(&p);
}

static void add_family(const char *family, const char *degrees, int count)
{
    each_case(family, degrees, count, add_case);
}

static void add_random(struct random_state *r, int count)
{
    struct prop_curve f, g;
    for (int i = 0; i < count; i++) {
        prop_curve_make(&f, r, (int)random_between(r, 1, 3), 20, false);
        prop_curve_make(&g, r, (int)random_between(r, 1, 3), 20, false);
        add(&f.curve, &g.curve);
    }
}

/* ---- a batch ---- */

struct run {
    struct batch batch;
    struct batch_answer answer;
    unsigned char *workspace;
};

static void *guarded(size_t bytes)
{
    unsigned char *memory = (unsigned char *)malloc(bytes + 2 * GUARD);
    assert_non_null(memory);
    memset(memory, GUARD_BYTE, bytes + 2 * GUARD);
    return memory + GUARD;
}

static void release(void *memory, size_t bytes)
{
    unsigned char *at = (unsigned char *)memory - GUARD;
    for (int i = 0; i < GUARD; i++)
        assert_true(at[i] == GUARD_BYTE && at[GUARD + bytes + i] == GUARD_BYTE);
    free(at);
}

static void run_init(struct run *r, int pairs, enum batch_variant variant, int record_room, int overlap_room)
{
    memset((void *)r, 0, sizeof *r);
    r->batch.f.points = table.f;
    r->batch.f.degree = table.degree_f;
    r->batch.g.points = table.g;
    r->batch.g.degree = table.degree_g;
    r->batch.pairs = pairs;
    r->batch.tolerance = tolerance;
    r->batch.max_steps = 20000;
    r->batch.variant = variant;
    r->workspace = (unsigned char *)guarded(batch_workspace_size());
    r->answer.record = (struct batch_record *)guarded(record_room * sizeof *r->answer.record);
    r->answer.overlap = (struct batch_overlap *)guarded(overlap_room * sizeof *r->answer.overlap);
    r->answer.outcome = (unsigned char *)guarded(pairs);
    r->answer.record_room = record_room;
    r->answer.overlap_room = overlap_room;
}

static void run_clear(struct run *r)
{
    release(r->workspace, batch_workspace_size());
    release(r->answer.record, r->answer.record_room * sizeof *r->answer.record);
    release(r->answer.overlap, r->answer.overlap_room * sizeof *r->answer.overlap);
    release(r->answer.outcome, r->batch.pairs);
}

/* ---- against single calls ---- */

struct single {
    struct workspace workspace;
    struct problem problem;
};

static void single_init(struct single *z)
{
    static const struct intersector *a[2] = {NULL, NULL};
    a[0] = intersector_find("certified");
    workspace_make(&z->workspace, a, 3, 3, WORKSPACE_ROOM);
}

static struct curve curve_at(const real *points, const unsigned char *degree, int i)
{
    struct curve c;
    c.degree = degree ? degree[i] : 3;
    c.x = points + BATCH_NUMBERS * i;
    c.y = c.x + BATCH_NUMBERS / 2;
    c.w = NULL;
    c.domain.lo = 0;
    c.domain.hi = 1;
    return c;
}

static enum outcome solve_single(struct single *z, const struct batch *b, int pair)
{
    memset((void *)&z->problem, 0, sizeof z->problem);
    z->problem.f = curve_at(b->f.points, b->f.degree, b->f_index ? b->f_index[pair] : pair);
    z->problem.g = curve_at(b->g.points, b->g.degree, b->g_index ? b->g_index[pair] : pair);
    z->problem.tolerance = b->tolerance;
    z->problem.max_steps = b->max_steps;
    return problem_solve(&z->problem, intersector_find("certified"), &z->workspace, &crossings);
}

static bool meet(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

static bool agree(const struct crossing *a, const struct crossing *b)
{
    return a->standing == b->standing && a->at_most == b->at_most && a->multiplicity == b->multiplicity &&
           meet(&a->t, &b->t) && meet(&a->s, &b->s);
}

/* The records of `pair` and those of a single call, one to one; returns how many there are. */
static int compare_pair(const struct run *r, const char *what, struct single *z, int pair, const int *first,
                        const int *order)
{
    enum outcome o = solve_single(z, &r->batch, pair);
    int count = first[pair + 1] - first[pair], overlaps = 0;
    for (int i = 0; i < r->answer.overlaps; i++)
        overlaps += r->answer.overlap[i].pair == pair;
    if (r->answer.outcome[pair] != o || count != crossings.count || overlaps != crossings.overlaps)
        fail_msg("%s, variant %d, pair %d: %s, %d records, %d overlaps; alone %s, %d, %d", what,
                 r->batch.variant, pair, outcome_name((enum outcome)r->answer.outcome[pair]), count, overlaps,
                 outcome_name(o), crossings.count, crossings.overlaps);
    for (int i = 0; i < count; i++) {
        const struct crossing *x = &r->answer.record[order[first[pair] + i]].at;
        int matches = 0;
        for (int k = 0; k < count; k++)
            matches += agree(x, &crossings.at[k]);
        if (matches < 1)
            fail_msg("%s, variant %d, pair %d: a record that a single call does not give", what,
                     r->batch.variant, pair);
    }
    return count;
}

/* Groups the records by pairs. */
static void group(const struct batch_answer *a, int pairs, int *first, int *order)
{
    memset(first, 0, (pairs + 2) * sizeof *first);
    for (int i = 0; i < a->records; i++) {
        assert_true(a->record[i].pair >= 0 && a->record[i].pair < pairs);
        first[a->record[i].pair + 2]++;
    }
    for (int k = 0; k < pairs; k++)
        first[k + 2] += first[k + 1];
    for (int i = 0; i < a->records; i++)
        order[first[a->record[i].pair + 1]++] = i;
}

static void compare(const struct run *r, const char *what, struct single *z)
{
    static int first[PAIRS + 2], order[ROOM];
    int found = 0;
    group(&r->answer, r->batch.pairs, first, order);
    for (int k = 0; k < r->batch.pairs; k++)
        found += compare_pair(r, what, z, k, first, order);
    assert_int_equal(found, r->answer.records);
}

/* All pairs of the table; returns how many the best variant left to single calls. */
static int compare_variants(const char *what)
{
    struct single z;
    int alone = 0;
    single_init(&z);
    for (int v = 0; v < 4; v++) {
        struct run r;
        if (!is_tried(variants[v]))
            continue;
        run_init(&r, table.pairs, variants[v], ROOM, 2000);
        assert_int_equal(batch_solve(&r.batch, 0, r.workspace, &r.answer), SOLVED);
        assert_int_equal(r.answer.done, table.pairs);
        compare(&r, what, &z);
        alone = r.answer.alone;
        print_message("%s: variant %d, %d pairs, %d records, %d alone\n", what, variants[v], table.pairs,
                      r.answer.records, r.answer.alone);
        run_clear(&r);
    }
    workspace_clear(&z.workspace);
    return alone;
}

/* ---- the tests ---- */

static void test_families(void **state)
{
    static const struct {
        const char *name, *degrees;
        int count;
    } families[] = {{"random", "2,3,2x3,3x2", 250},
                    {"nice", "2,3,2x3", 300},
                    {"nine", "2,3", 60},
                    {"far", "2,3", 200},
                    {"near_disjoint", "3", 51},
                    {"shared_end", "2,3", 50},
                    {"endpoint", "2,3", 50},
                    {"smooth_join", "2,3", 30},
                    {"tangent_same", "2,3,3x2", 30},
                    {"tangent_opposite", "2,3", 30},
                    {"near_tangent", "2,3", 92},
                    {"contact_3", "3", 10},
                    {"cusp_crossed", "3", 10},
                    {"zero_end", "2,3", 20},
                    {"overlap", "2,3", 20},
                    {"size_mismatch", "3", 60}};
    (void)state;
    for (int i = 0; i < (int)(sizeof families / sizeof *families); i++) {
        table.pairs = 0;
        add_family(families[i].name, families[i].degrees, families[i].count);
        int alone = compare_variants(families[i].name);
        if (i < 4 && batch_has(BATCH_AVX2) && i != 2)
            assert_true(20 * alone <= table.pairs); /* the lanes do the work */
    }
}

/* Degrees 1 to 3 mixed; scaled by powers of two, to where the lanes do not go. */
static void test_scales(void **state)
{
    struct random_state r = random_for(41, "batch", 0);
    (void)state;
    table.pairs = 0;
    add_random(&r, 1000 / SHARE);
    compare_variants("mixed degrees");
    for (int i = 0; i < table.pairs; i++)
        rescale(i, (int)random_between(&r, -500, 500));
    compare_variants("scaled");
}

/* Roots at dyadic parameters, where nodes are cut. */
static void test_cuts(void **state)
{
    struct random_state r = random_for(42, "batch", 0);
    (void)state;
    table.pairs = 0;
    for (int i = 0; i < 600 / SHARE; i++) {
        struct prop_curve f, g;
        int k = (int)random_between(&r, 1, 3), l = (int)random_between(&r, 1, 3);
        real t = (real)k / 4, s = (real)l / 4,
             weight[4] = {(1 - s) * (1 - s) * (1 - s), 3 * s * (1 - s) * (1 - s), 3 * s * s * (1 - s),
                          s * s * s};
        real v = 1 - t, at[4] = {v * v * v, 3 * t * v * v, 3 * t * t * v, t * t * t}, x = 0, y = 0, a = 0,
             b = 0;
        prop_curve_make(&f, &r, 3, 12, false);
        prop_curve_make(&g, &r, 3, 12, false);
        for (int i2 = 0; i2 < 4; i2++) { /* exact: 12 + 6 bits */
            x += at[i2] * f.x[i2];
            y += at[i2] * f.y[i2];
            a += weight[i2] * g.x[i2];
            b += weight[i2] * g.y[i2];
        }
        for (int i2 = 0; i2 < 4; i2++) {
            g.x[i2] += x - a;
            g.y[i2] += y - b;
        }
        add(&f.curve, &g.curve);
    }
    compare_variants("dyadic");
}

static void test_counts(void **state)
{
    static const int counts[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 511, 512, 513, 1000};
    struct random_state r = random_for(43, "batch", 0);
    (void)state;
    table.pairs = 0;
    add_random(&r, 1000);
    for (int i = 0; i < (int)(sizeof counts / sizeof *counts); i++) {
        if (counts[i] * SHARE <= 1000) {
            table.pairs = counts[i];
            compare_variants("prefix");
        }
    }
}

/* One table on both sides, every curve with every curve, itself included. */
static void test_indices(void **state)
{
    enum { CURVES = REAL_BITS > 113 ? 3 : REAL_BITS > 53 ? 6 : 30 };
    static int f[CURVES * CURVES], g[CURVES * CURVES];
    struct random_state random = random_for(44, "batch", 0);
    struct single z;
    (void)state;
    table.pairs = 0;
    add_random(&random, CURVES);
    single_init(&z);
    for (int i = 0; i < CURVES * CURVES; i++) {
        f[i] = i / CURVES;
        g[i] = i % CURVES;
    }
    for (int v = 0; v < 4; v++) {
        struct run r;
        if (!is_tried(variants[v]))
            continue;
        run_init(&r, CURVES * CURVES, variants[v], ROOM, 200);
        r.batch.g = r.batch.f;
        r.batch.f_index = f;
        r.batch.g_index = g;
        assert_int_equal(batch_solve(&r.batch, 0, r.workspace, &r.answer), SOLVED);
        compare(&r, "every with every", &z);
        assert_true(r.answer.overlaps >= CURVES);
        r.batch.g_index = NULL; /* one side by index, the other in order */
        r.batch.f_index = g + CURVES / 2;
        r.batch.pairs = CURVES;
        assert_int_equal(batch_solve(&r.batch, 0, r.workspace, &r.answer), SOLVED);
        compare(&r, "one side by index", &z);
        r.batch.pairs = CURVES * CURVES; /* as they were made */
        run_clear(&r);
    }
    workspace_clear(&z.workspace);
}

/* However little room there is, every call gives whole pairs, and all together the same records. */
static void test_room(void **state)
{
    static const int rooms[] = {9, 10, 23, 64, 400};
    struct random_state random = random_for(45, "batch", 0);
    (void)state;
    table.pairs = 0;
    add_random(&random, 500 / SHARE);
    add_family("overlap", "3", 10);
    for (int v = 0; v < 4; v++) {
        for (int i = 0; i < 5 && is_tried(variants[v]); i++) {
            struct run whole, part;
            int records = 0, overlaps = 0, first = 0;
            enum outcome o = OUT_OF_ROOM;
            run_init(&whole, table.pairs, variants[v], ROOM, 200);
            run_init(&part, table.pairs, variants[v], rooms[i], 2);
            assert_int_equal(batch_solve(&whole.batch, 0, whole.workspace, &whole.answer), SOLVED);
            while (o == OUT_OF_ROOM) {
                o = batch_solve(&part.batch, first, part.workspace, &part.answer);
                assert_true(part.answer.done > first || o == SOLVED);
                assert_true(part.answer.records <= rooms[i] && part.answer.overlaps <= 2);
                for (int k = 0; k < part.answer.records; k++)
                    assert_in_range(part.answer.record[k].pair, first, part.answer.done - 1);
                first = part.answer.done;
                records += part.answer.records;
                overlaps += part.answer.overlaps;
            }
            assert_int_equal(o, SOLVED);
            assert_int_equal(first, table.pairs);
            assert_int_equal(records, whole.answer.records);
            assert_int_equal(overlaps, whole.answer.overlaps);
            assert_memory_equal(part.answer.outcome, whole.answer.outcome, table.pairs);
            run_clear(&whole);
            run_clear(&part);
        }
    }
    struct run none;
    run_init(&none, table.pairs, BATCH_BEST, 0, 0);
    assert_int_equal(batch_solve(&none.batch, 0, none.workspace, &none.answer), OUT_OF_ROOM);
    assert_true(none.answer.records == 0 && none.answer.done < table.pairs);
    run_clear(&none);
}

/* A coordinate that is no number makes its own pair INVALID, and so does a degree; all others are as ever. */
static void test_invalid(void **state)
{
    struct random_state random = random_for(46, "batch", 0);
    struct run r;
    (void)state;
    table.pairs = 0;
    add_random(&random, 600 / SHARE);
    int bad = 0;
    for (int i = 0; i < table.pairs; i++) {
        if (random_bits(&random) % 3)
            continue;
        bool of_f = random_bits(&random) & 1;
        int k = (int)random_between(&random, 0, of_f ? table.degree_f[i] : table.degree_g[i]);
        real *points = (of_f ? table.f : table.g) + BATCH_NUMBERS * i + (random_bits(&random) & 4);
        int kind = (int)(random_bits(&random) % 4);
        points[k] = kind == 0   ? (real)NAN
                    : kind == 1 ? (real)INFINITY
                    : kind == 2 ? (real)-INFINITY
                                : (real)NAN;
        if (kind == 3) {
            points[0] = (real)INFINITY;
            points[1] = (real)-INFINITY;
        }
        bad++;
    }
    assert_true(bad > 0);
    compare_variants("not finite");
    table.degree_f[0] = 4;
    table.degree_g[1] = 0;
    for (int v = 0; v < 4; v++) {
        if (!is_tried(variants[v]))
            continue;
        run_init(&r, table.pairs, variants[v], ROOM, 200);
        assert_int_equal(batch_solve(&r.batch, 0, r.workspace, &r.answer), SOLVED);
        assert_true(r.answer.outcome[0] == INVALID && r.answer.outcome[1] == INVALID);
        for (int i = 0; i < r.answer.records; i++)
            assert_true(r.answer.record[i].pair > 1);
        run_clear(&r);
    }
}

static void test_refused(void **state)
{
    struct random_state random = random_for(47, "batch", 0);
    (void)state;
    table.pairs = 0;
    add_random(&random, 9);
    struct run r;
    run_init(&r, table.pairs, BATCH_BEST, ROOM, 200);
    for (int i = 0; i < 5; i++) {
        struct batch b = r.batch;
        b.tolerance = i == 0 ? (real)0 : i == 1 ? (real)NAN : i == 2 ? (real)INFINITY : b.tolerance;
        b.max_steps = i == 3 ? 0 : b.max_steps;
        assert_int_equal(batch_solve(&b, i == 4 ? 10 : 0, r.workspace, &r.answer), INVALID);
        assert_int_equal(r.answer.records, 0);
    }
    for (int v = 0; v < 4; v++) {
        r.batch.variant = variants[v];
        assert_int_equal(batch_solve(&r.batch, 0, r.workspace, &r.answer),
                         batch_has(variants[v]) ? SOLVED : INVALID);
    }
    run_clear(&r);
}

/* ---- against the referee ---- */

static int judged;

static bool holds(const struct interval *a, const mpq_t q)
{
    mpq_t end;
    mpq_init(end);
    real_to_rational(a->lo, end);
    bool inside = mpq_cmp(end, q) <= 0;
    real_to_rational(a->hi, end);
    inside = inside && mpq_cmp(q, end) <= 0;
    mpq_clear(end);
    return inside;
}

/* Every solution in just one record, every record with just one. */
static void judge_case(struct test_case *c)
{
    if (referee_solve(c))
        return;
    table.pairs = 0;
    add_case(c);
    for (int v = 0; v < 4; v++) {
        struct run r;
        if (!is_tried(variants[v]))
            continue;
        run_init(&r, 1, variants[v], 40, 4);
        assert_int_equal(batch_solve(&r.batch, 0, r.workspace, &r.answer), SOLVED);
        assert_int_equal(r.answer.records, c->expected.count);
        for (int i = 0; i < c->expected.count; i++) {
            int held = 0;
            for (int k = 0; k < r.answer.records; k++) {
                const struct crossing *x = &r.answer.record[k].at;
                held += holds(&x->t, c->expected.at[i].t) && holds(&x->s, c->expected.at[i].s);
            }
            if (held != 1)
                fail_msg("%s, variant %d: solution %d is in %d records", c->id, variants[v], i, held);
            judged++;
        }
        run_clear(&r);
    }
}

static void test_referee(void **state)
{
    (void)state;
    if (REAL_BITS > 53)
        skip(); /* radii below the referee's digits */
    each_case("random", "2,3,2x3", 200, judge_case);
    each_case("nice", "2,3", 150, judge_case);
    each_case("nine", "3", 20, judge_case);
    each_case("many", "3", 10, judge_case);
    print_message("%d solutions held\n", judged);
    assert_true(judged > 500);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_families), cmocka_unit_test(test_scales),  cmocka_unit_test(test_cuts),
        cmocka_unit_test(test_counts),   cmocka_unit_test(test_indices), cmocka_unit_test(test_room),
        cmocka_unit_test(test_invalid),  cmocka_unit_test(test_refused), cmocka_unit_test(test_referee),
    };
    const char *slash = strrchr(argv[0], '/');
    (void)argc;
    snprintf(generator, sizeof generator, "%.*s/../../double/fatline-generate",
             slash ? (int)(slash - argv[0]) : 1, slash ? argv[0] : ".");
    return cmocka_run_group_tests_name("batch", tests, NULL, NULL);
}
