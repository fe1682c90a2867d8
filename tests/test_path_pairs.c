/* Paths: no pair of segments is lost between the trees, and a path's answer is that of its pairs with what is
 * one solution at a joint told once. */
#include "paths.h"

struct reach {
    real low[4], high[4];
};

static struct reach reach_of(const struct curve *c)
{
    struct reach r;
    for (int i = 0; i <= c->degree; i++) {
        real x = c->w ? c->x[i] / c->w[i] : c->x[i], y = c->w ? c->y[i] / c->w[i] : c->y[i];
        real h[4] = {x, y, x + y, x - y};
        for (int k = 0; k < 4; k++) {
            r.low[k] = i ? real_min(r.low[k], h[k]) : h[k];
            r.high[k] = i ? real_max(r.high[k], h[k]) : h[k];
        }
    }
    return r;
}

static bool reaches_meet(const struct reach *p, const struct reach *q)
{
    for (int k = 0; k < 4; k++)
        if (p->low[k] > q->high[k] || q->low[k] > p->high[k])
            return false;
    return true;
}

/* Segments of any degree, some rational, of one of four layouts: everywhere, along a line, in one place and
 * huge. */
static void random_segments(struct path_set *set, struct random_state *r, int count, int layout)
{
    struct path_draft d;
    path_draft_begin(&d, "segments");
    for (int i = 0; i < count; i++) {
        struct prop_curve c;
        prop_curve_make(&c, r, (int)random_between(r, 1, 5), 20, random_between(r, 0, 3) == 0);
        real dx = layout == 1 ? (real)i * 3 / 2 : layout == 0 ? 16 * prop_dyadic(r, 20) : (real)0;
        real dy = layout == 0 ? 16 * prop_dyadic(r, 20) : (real)0;
        for (int k = 0; k <= c.curve.degree; k++) {
            c.x[k] += dx * c.w[k];
            c.y[k] += dy * c.w[k];
            if (layout == 3) {
                c.x[k] = real_ldexp(c.x[k], 1020);
                c.y[k] = real_ldexp(c.y[k], 1020);
            }
        }
        assert_true(path_draft_add(&d, c.curve.degree, c.x, c.y, c.curve.w));
    }
    path_draft_end(&d, set);
}

/* Every pair whose octagons meet is found, once; of polynomial curves in doubles no other. */
static void check_walk(const struct path *a, const struct path *b)
{
    enum { BLOCK = PATH_BLOCK_LEAST };
    struct path_tree tree_a, tree_b;
    struct path_pair block[BLOCK];
    struct path_walk *walk = (struct path_walk *)malloc(sizeof *walk);
    void *memory_a = malloc(path_tree_size(a->count)), *memory_b = malloc(path_tree_size(b->count));
    unsigned char *seen = (unsigned char *)calloc((size_t)a->count * (size_t)b->count + 1, 1);
    path_tree_make(&tree_a, a, memory_a);
    path_tree_make(&tree_b, b, memory_b);
    path_walk_begin(walk, &tree_a, &tree_b);
    for (int count; (count = path_walk_next(walk, block, BLOCK)) > 0;)
        for (int k = 0; k < count; k++) {
            assert_in_range(block[k].i, 0, a->count - 1);
            assert_in_range(block[k].j, 0, b->count - 1);
            seen[(size_t)block[k].i * (size_t)b->count + (size_t)block[k].j]++;
        }
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++) {
            struct reach p = reach_of(&a->segment[i]), q = reach_of(&b->segment[j]);
            bool exact = REAL_BITS == 53 && !a->segment[i].w && !b->segment[j].w;
            int times = seen[(size_t)i * (size_t)b->count + (size_t)j];
            bool wanted = reaches_meet(&p, &q) && (a != b || i < j);
            if (wanted ? times != 1 : times > (a == b && i >= j ? 0 : !exact))
                fail_msg("pair %d, %d of %d x %d: %d times, expected %d", i, j, a->count, b->count, times,
                         wanted);
        }
    free(walk);
    free(memory_a);
    free(memory_b);
    free(seen);
}

static void no_pair_is_lost(void **state)
{
    static const int counts[] = {0, 1, 2, 7, 8, 9, 63, 64, 65, 130, 520};
    (void)state;
    for (int k = 0; k < (REAL_BITS > 53 ? 8 : 11); k++)
        for (int layout = 0; layout < 4; layout++) {
            struct random_state r = random_for(1, "walk", (uint64_t)(4 * k + layout));
            struct path_set set = {0, 0, NULL};
            random_segments(&set, &r, counts[k], layout);
            random_segments(&set, &r, (int)random_between(&r, 0, 80), layout);
            check_walk(&set.at[0].path, &set.at[1].path);
            check_walk(&set.at[1].path, &set.at[0].path);
            check_walk(&set.at[0].path, &set.at[0].path);
            path_set_clear(&set);
        }
}

/* ---- the answer is that of the pairs ---- */

static bool is_record(const struct path_record *q, int i, int j, const struct crossing *c)
{
    struct path_span t = {i, i, c->t.lo, c->t.hi}, s = {j, j, c->s.lo, c->s.hi};
    return spans_touch(&q->a, &t) && spans_touch(&q->b, &s) && q->standing == c->standing;
}

/* All pairs of segments by problem_solve; every record must be one of the job's (its intervals meet that
 * one's, and they are of one standing), or lie in one that was joined, and there must be no others. */
static void check_pairs(const struct path_job *job)
{
    const struct path *a = &job->a->path, *b = job->b ? &job->b->path : a;
    struct crossings *found = (struct crossings *)malloc(sizeof *found);
    struct workspace w;
    const struct intersector *certified = intersector_find("certified"), *used[] = {certified, NULL};
    struct problem p;
    int plain = 0, expected = 0;
    workspace_make(&w, used, 3, 3, 1);
    memset((void *)&p, 0, sizeof p);
    p.tolerance = job->solver.tolerance;
    p.max_steps = STEPS_MAX;
    for (int i = 0; i < a->count; i++)
        for (int j = job->b ? 0 : i + 1; j < b->count; j++) {
            if (!job->b && (a->next[i] == j || a->next[j] == i))
                continue;
            p.f = a->segment[i];
            p.g = b->segment[j];
            assert_int_equal(problem_solve(&p, certified, &w, found), SOLVED);
            for (int k = 0; k < found->count; k++) {
                const struct crossing *c = &found->at[k];
                bool end = c->t.lo == 0 || c->t.hi == 1 || c->s.lo == 0 || c->s.hi == 1, held = false;
                real t = (c->t.lo + c->t.hi) / 2, s = (c->s.lo + c->s.hi) / 2;
                expected += !end;
                for (int r = 0; r < job->records.count && !held; r++) {
                    const struct path_record *q = &job->records.at[job->records.order[r]];
                    held = end ? is_in(&q->a, i, t) && is_in(&q->b, j, s) : is_record(q, i, j, c);
                }
                if (!held && !(end && c->standing == END))
                    fail_msg("segments %d and %d: record %d is not among those of the paths", i, j, k);
            }
        }
    for (int r = 0; r < job->records.count; r++) {
        const struct path_record *q = &job->records.at[job->records.order[r]];
        bool neighbours = !job->b && (a->next[q->a.first] == q->b.first || q->a.first == q->b.first);
        plain += !neighbours && q->a.lo > 0 && q->a.hi < 1 && q->b.lo > 0 && q->b.hi < 1 &&
                 q->a.first == q->a.last && q->b.first == q->b.last;
    }
    if (plain != expected)
        fail_msg("%d records inside segments, expected %d", plain, expected);
    workspace_clear(&w);
    free((void *)found);
}

static void pairs_are_all(void **state)
{
    (void)state;
    for (int run = 0; run < (RUNS + 3) / 4; run++) {
        struct path_set set = {0, 0, NULL};
        struct path_job job;
        int count = REAL_BITS > 53 ? 12 : 20 + 10 * run;
        path_random(&set, "a", count, (uint64_t)run, 0);
        path_random(&set, "b", count + 3, (uint64_t)run, 1);
        job_of(&job, &set.at[0], &set.at[1]);
        check_pairs(&job);
        path_job_clear(&job);
        job_of(&job, &set.at[0], NULL);
        check_pairs(&job);
        path_job_clear(&job);
        path_set_clear(&set);
    }
}

/* Every segment of a meets every one of b in nine places: more records than a batch of pairs has room for. */
static void room_is_found(void **state)
{
    const real across[4] = {-1, (real)-1 / 3, (real)1 / 3, 1}, swing[4] = {-9, 45, -45, 9};
    const int copies = REAL_BITS > 113 ? 3 : REAL_BITS > 53 ? 12 : 40;
    struct path_set set = {0, 0, NULL};
    struct path_job job;
    (void)state;
    for (int side = 0; side < 2; side++) {
        struct path_draft d;
        path_draft_begin(&d, "swings");
        for (int k = 0; k < copies; k++) {
            real c[8];
            for (int i = 0; i < 4; i++) {
                c[4 * side + i] = across[i];
                c[4 - 4 * side + i] = swing[i] / 8 + (real)k / 4096;
            }
            add(&d, 3, c);
        }
        path_draft_end(&d, &set);
    }
    job_of(&job, &set.at[0], &set.at[1]);
    assert_int_equal(job.records.count, 9 * copies * copies);
    for (int r = 0; r < job.records.count; r++) {
        assert_int_equal(job.records.at[job.records.order[r]].a.first, r / (9 * copies));
        assert_int_equal(job.records.at[job.records.order[r]].standing, UNIQUE);
    }
    path_job_clear(&job);
    path_set_clear(&set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pair_is_lost),
        cmocka_unit_test(pairs_are_all),
        cmocka_unit_test(room_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
