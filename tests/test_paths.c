/* Paths: no pair of segments is lost between the trees, a path's answer is that of its pairs with what is one
 * solution at a joint told once, and it does not depend on how a curve is cut, moved, turned or exchanged. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/paths/path_job.h"
#include "../harness/cases/problem.h"

enum { RUNS = REAL_BITS > 113 ? 1 : REAL_BITS > 53 ? 3 : 40 };

static const volatile int never = 0;

/* ---- building ---- */

/* Points of a segment: x then y, `degree + 1` each. */
static void add(struct path_draft *d, int degree, const real *c)
{
    assert_true(path_draft_add(d, degree, c, c + degree + 1, NULL));
}

static void add_line(struct path_draft *d, real x0, real y0, real x1, real y1)
{
    real c[4] = {x0, x1, y0, y1};
    add(d, 1, c);
}

static void polyline(struct path_set *set, int points, const real *x, const real *y)
{
    struct path_draft d;
    path_draft_begin(&d, "polyline");
    for (int i = 0; i + 1 < points; i++)
        add_line(&d, x[i], y[i], x[i + 1], y[i + 1]);
    path_draft_end(&d, set);
}

/* A cubic with control points k 2^-12 in [-1, 1], so that halving it twice is exact in doubles. */
static void random_cubic(struct random_state *r, real c[8])
{
    for (int i = 0; i < 8; i++)
        c[i] = prop_dyadic(r, 12);
}

static void halve(const real c[4], real left[4], real right[4])
{
    real a = (c[0] + c[1]) / 2, b = (c[1] + c[2]) / 2, e = (c[2] + c[3]) / 2;
    left[0] = c[0];
    left[1] = a;
    left[2] = (a + b) / 2;
    left[3] = right[0] = (left[2] + (b + e) / 2) / 2;
    right[1] = (b + e) / 2;
    right[2] = e;
    right[3] = c[3];
}

/* c in 2^cuts pieces, exactly. */
static void add_pieces(struct path_draft *d, const real c[8], int cuts)
{
    real left[8], right[8];
    if (cuts == 0) {
        add(d, 3, c);
        return;
    }
    halve(c, left, right);
    halve(c + 4, left + 4, right + 4);
    add_pieces(d, left, cuts - 1);
    add_pieces(d, right, cuts - 1);
}

static void pieces(struct path_set *set, const real c[8], int cuts)
{
    struct path_draft d;
    path_draft_begin(&d, "pieces");
    add_pieces(&d, c, cuts);
    path_draft_end(&d, set);
}

static void job_of(struct path_job *job, const struct loaded_path *a, const struct loaded_path *b)
{
    path_job_make(job, a, b, (real)1 / 1000000000000, STEPS_MAX);
    assert_true(path_job_run(job, &never));
}

static bool is_in(const struct path_span *s, int segment, real t)
{
    if (s->first == s->last)
        return s->first == segment && s->lo <= t && t <= s->hi;
    return (s->first == segment && s->lo <= t) || (s->last == segment && t <= s->hi);
}

/* ---- no pair is lost ---- */

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

static bool spans_touch(const struct path_span *p, const struct path_span *q)
{
    return p->first == q->first && p->last == q->last && p->lo <= q->hi && q->lo <= p->hi;
}

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

/* ---- cut, turned, exchanged ---- */

/* Parameter of the whole curve of a place on one of its `count` equal pieces. */
static real whole(int count, int segment, real t)
{
    return (segment + t) / count;
}

static bool is_crossing(int n, int m, const struct path_record *q, const struct crossing *x)
{
    return whole(n, q->a.first, q->a.lo) <= x->t.hi + REAL_EPSILON &&
           x->t.lo <= whole(n, q->a.last, q->a.hi) + REAL_EPSILON &&
           whole(m, q->b.first, q->b.lo) <= x->s.hi + REAL_EPSILON &&
           x->s.lo <= whole(m, q->b.last, q->b.hi) + REAL_EPSILON;
}

/* Of pairs of cubics in pieces: every crossing of the whole curves is there, at the same parameters; and
 * where all is decided, which may fail where they nearly touch, there are as many records, each simple. */
static void check_same(const struct crossings *c, const struct path_job *job, long seed, int *undecided)
{
    int n = job->a->path.count, m = job->b->path.count, count = job->records.count;
    bool simple = true, seen[CROSSINGS_MAX];
    memset(seen, 0, sizeof seen);
    for (int r = 0; r < job->records.count; r++) {
        const struct path_record *q = &job->records.at[job->records.order[r]];
        simple = simple && q->standing == UNIQUE;
        for (int k = 0; k < c->count; k++)
            seen[k] = seen[k] || (is_crossing(n, m, q, &c->at[k]));
    }
    for (int k = 0; k < c->count; k++) {
        simple = simple && c->at[k].standing == UNIQUE;
        if (!seen[k])
            fail_msg("run %ld, %d x %d pieces: crossing %d of the whole is not among them", seed, n, m, k);
    }
    if (simple && count != c->count)
        fail_msg("run %ld, %d x %d pieces: %d records, expected %d", seed, n, m, count, c->count);
    *undecided += !simple;
}

static bool all_simple(const struct crossings *c)
{
    for (int k = 0; k < c->count; k++)
        if (c->at[k].standing != UNIQUE && c->at[k].standing != END)
            return false;
    return c->overlaps == 0;
}

static void solve_whole(const real f[8], const real g[8], struct crossings *found)
{
    const struct intersector *certified = intersector_find("certified"), *used[] = {certified, NULL};
    struct problem p;
    struct workspace w;
    workspace_make(&w, used, 3, 3, 1);
    memset((void *)&p, 0, sizeof p);
    p.f.degree = p.g.degree = 3;
    p.f.x = f;
    p.f.y = f + 4;
    p.g.x = g;
    p.g.y = g + 4;
    p.f.domain.hi = p.g.domain.hi = 1;
    p.f.domain.lo = p.g.domain.lo = 0;
    p.tolerance = (real)1 / 1000000000000;
    p.max_steps = STEPS_MAX;
    assert_int_equal(problem_solve(&p, certified, &w, found), SOLVED);
    workspace_clear(&w);
}

/* g is moved so that, in three runs of four, it passes through a joint of f, with a joint of its own or
 * inside a segment, or closely by. */
static void cutting_changes_nothing(void **state)
{
    struct crossings *found = (struct crossings *)malloc(sizeof *found);
    int tried = 0, undecided = 0;
    (void)state;
    for (int run = 0; run < 75 * RUNS; run++) {
        struct random_state r = random_for(2, "cut", (uint64_t)run);
        real f[8], g[8], f_left[8], f_right[8], g_left[8], g_right[8];
        random_cubic(&r, f);
        random_cubic(&r, g);
        const int near = run % 8 == 3 ? 8 : 40000;
        for (int k = 0; k < 8; k += 4) {
            halve(f + k, f_left + k, f_right + k);
            halve(g + k, g_left + k, g_right + k);
            real move = run % 4 == 0 ? (real)0 : f_left[k + 3] - g_left[k + 3];
            move += run % 4 == 3 ? real_ldexp((real)(double)random_between(&r, -near, near), -44) : (real)0;
            for (int i = 0; i < 4; i++)
                g[k + i] += move;
        }
        solve_whole(f, g, found);
        if (!all_simple(found))
            continue;
        tried++;
        for (int cuts = 0; cuts <= 2; cuts++) {
            struct path_set set = {0, 0, NULL};
            struct path_job job;
            pieces(&set, f, cuts);
            pieces(&set, g, run % 4 == 2 ? 0 : 2 - cuts / 2);
            job_of(&job, &set.at[0], &set.at[1]);
            check_same(found, &job, run, &undecided);
            path_job_clear(&job);
            path_set_clear(&set);
        }
    }
    assert_true(tried >= 60 * RUNS && undecided * 50 < tried);
    free((void *)found);
}

/* The same records where a and b are exchanged. */
static void check_exchanged(const struct path_job *job, const struct path_job *other)
{
    const struct path_records *p = &job->records, *q = &other->records;
    assert_int_equal(p->count, q->count);
    for (int r = 0; r < p->count; r++) {
        bool found = false;
        for (int k = 0; k < q->count && !found; k++)
            found = spans_touch(&p->at[p->order[r]].a, &q->at[q->order[k]].b) &&
                    spans_touch(&p->at[p->order[r]].b, &q->at[q->order[k]].a) &&
                    p->at[p->order[r]].standing == q->at[q->order[k]].standing;
        if (!found)
            fail_msg("record %d has no partner where the paths are exchanged", r);
    }
}

/* Control points times `factor`, then moved by (dx, dy); reversed: from end to begin. */
static void copy_path(struct path_set *set, const struct path *p, real factor, real dx, real dy,
                      bool reversed)
{
    struct path_draft d;
    path_draft_begin(&d, "copy");
    for (int i = 0; i < p->count; i++) {
        const struct curve *c = &p->segment[reversed ? p->count - 1 - i : i];
        real at[2 * (DEGREE_MAX + 1)];
        for (int k = 0; k <= c->degree; k++) {
            int from = reversed ? c->degree - k : k;
            at[k] = c->x[from] * factor + dx;
            at[c->degree + 1 + k] = c->y[from] * factor + dy;
        }
        add(&d, c->degree, at);
    }
    path_draft_end(&d, set);
}

static void check_moved(const struct path_job *job, const struct path_job *other, bool same_bits,
                        bool reversed)
{
    const struct path_records *p = &job->records, *q = &other->records;
    int n = job->a->path.count;
    assert_int_equal(p->count, q->count);
    for (int r = 0; r < p->count; r++) {
        bool found = false;
        const struct path_span *s = &p->at[p->order[r]].a;
        real lo = s->first + s->lo, hi = s->last + s->hi;
        for (int k = 0; k < q->count && !found; k++) {
            const struct path_span *o = &q->at[q->order[k]].a;
            real olo = reversed ? n - (o->last + o->hi) : o->first + o->lo;
            real ohi = reversed ? n - (o->first + o->lo) : o->last + o->hi;
            found = same_bits ? lo == olo && hi == ohi && p->at[p->order[r]].b.lo == q->at[q->order[k]].b.lo
                              : lo <= ohi + n * REAL_EPSILON && olo <= hi + n * REAL_EPSILON &&
                                    p->at[p->order[r]].standing == q->at[q->order[k]].standing;
        }
        if (!found)
            fail_msg("record %d has no partner%s", r, reversed ? " on the reversed path" : "");
    }
}

/* A walk whose coordinates have few bits, so that it can be moved exactly. */
static void rounded_walk(struct path_set *set, int count, uint64_t seed, uint64_t index)
{
    struct path_set fine = {0, 0, NULL};
    struct path_draft d;
    real last_x = 0, last_y = 0;
    path_random(&fine, "fine", count, seed, index);
    path_draft_begin(&d, "rounded");
    for (int i = 0; i < count; i++) {
        const struct curve *c = &fine.at[0].segment[i];
        real at[8];
        for (int k = 0; k < 4; k++) {
            at[k] = real_ldexp((real)(double)(long)real_to_double(real_ldexp(c->x[k], 30)), -30);
            at[4 + k] = real_ldexp((real)(double)(long)real_to_double(real_ldexp(c->y[k], 30)), -30);
        }
        if (i > 0) {
            at[0] = last_x;
            at[4] = last_y;
        }
        last_x = at[3];
        last_y = at[7];
        add(&d, 3, at);
    }
    path_draft_end(&d, set);
    path_set_clear(&fine);
}

static void moves_change_nothing(void **state)
{
    (void)state;
    for (int run = 0; run < (RUNS + 3) / 4; run++) {
        struct path_set set = {0, 0, NULL};
        struct path_job job, exchanged, scaled, moved, reversed;
        int count = REAL_BITS > 53 ? 12 : 40;
        rounded_walk(&set, count, (uint64_t)(100 + run), 0);
        rounded_walk(&set, count, (uint64_t)(100 + run), 1);
        copy_path(&set, &set.at[0].path, 1024, 0, 0, false);
        copy_path(&set, &set.at[1].path, 1024, 0, 0, false);
        copy_path(&set, &set.at[0].path, 1, 4096, -8, false);
        copy_path(&set, &set.at[1].path, 1, 4096, -8, false);
        copy_path(&set, &set.at[0].path, 1, 0, 0, true);
        job_of(&job, &set.at[0], &set.at[1]);
        job_of(&exchanged, &set.at[1], &set.at[0]);
        job_of(&scaled, &set.at[2], &set.at[3]);
        job_of(&moved, &set.at[4], &set.at[5]);
        job_of(&reversed, &set.at[6], &set.at[1]);
        check_exchanged(&job, &exchanged);
        check_moved(&job, &scaled, true, false);
        check_moved(&job, &moved, false, false);
        check_moved(&job, &reversed, false, true);
        path_job_clear(&job);
        path_job_clear(&exchanged);
        path_job_clear(&scaled);
        path_job_clear(&moved);
        path_job_clear(&reversed);
        path_set_clear(&set);
    }
}

/* ---- one path ---- */

static int records_alone(const struct loaded_path *p, struct path_record *first, int overlaps)
{
    struct path_job job;
    job_of(&job, p, NULL);
    int count = job.records.count;
    assert_int_equal(job.solver.unsolved, 0);
    assert_int_equal(job.records.overlaps, overlaps);
    for (int r = 0; r < count; r++)
        assert_true(job.records.at[job.records.order[r]].standing == UNIQUE ||
                    job.records.at[job.records.order[r]].overlap >= 0);
    if (count > 0)
        *first = job.records.at[job.records.order[0]];
    path_job_clear(&job);
    return count;
}

/* f(t1) = f(t2): with f = a t^3 + b t^2 + c t that is a (t1^2 + t1 t2 + t2^2) + b (t1 + t2) + c = 0.  All
 * numbers are multiples of 3 2^-8. */
static void loop_component(struct random_state *r, real t1, real t2, real out[4])
{
    real a = 3 * (real)(double)random_between(r, -40, 40), b = 3 * (real)(double)random_between(r, -40, 40);
    real c = -(a * (t1 * t1 + t1 * t2 + t2 * t2) + b * (t1 + t2));
    out[0] = 0;
    out[1] = c / 3;
    out[2] = (2 * c + b) / 3;
    out[3] = a + b + c;
}

static void loops_of_cubics(void **state)
{
    (void)state;
    for (int run = 0; run < 25 * RUNS; run++) {
        struct random_state r = random_for(3, "loop", (uint64_t)run);
        struct path_set set = {0, 0, NULL};
        struct path_record x;
        int k1 = (int)random_between(&r, -8, 15), k2 = (int)random_between(&r, k1 + 1, 24);
        real t1 = (real)k1 / 16, t2 = (real)k2 / 16, c[8];
        loop_component(&r, t1, t2, c);
        loop_component(&r, t1, t2, c + 4);
        bool is_flat = c[1] * c[7] == c[3] * c[5] && c[1] * c[6] == c[2] * c[5];
        bool inside = k1 >= 0 && k2 <= 16, joint = k1 == 0 && k2 == 16;
        if (is_flat)
            continue;
        pieces(&set, c, 0);
        struct path_job job;
        job_of(&job, &set.at[0], NULL);
        int count = job.records.count;
        if (count > 0)
            x = job.records.at[job.records.order[0]];
        path_job_clear(&job);
        if (count != (inside && !joint))
            fail_msg("run %d, t1 = %d/16, t2 = %d/16: %d records", run, k1, k2, count);
        if (count &&
            !(is_in(&x.a, 0, t1) && is_in(&x.b, 0, t2) && (x.standing == UNIQUE || x.standing == END)))
            fail_msg("run %d, t1 = %d/16, t2 = %d/16: the record is elsewhere", run, k1, k2);
        if (inside && !joint && k1 > 0 && k2 < 16)
            for (int cuts = 1; cuts <= 2; cuts++) { /* the loop of a path */
                pieces(&set, c, cuts);
                assert_int_equal(records_alone(&set.at[cuts], &x, 0), 1);
            }
        path_set_clear(&set);
    }
}

static void corners_are_no_crossings(void **state)
{
    static const int star[] = {0, 2, 4, 1, 3, 0}, five_x[] = {0, 19, 12, -12, -19},
                     five_y[] = {20, 6, -16, -16, 6};
    const real square_x[] = {0, 1, 1, 0, 0}, square_y[] = {0, 0, 1, 1, 0};
    const real back_x[] = {0, 4, 1}, back_y[] = {0, 0, 0}, there_x[] = {0, 4, 1},
               there_y[] = {0, 0, (real)1 / 1024};
    real x[6], y[6];
    struct path_record first;
    struct path_set set = {0, 0, NULL};
    (void)state;
    for (int k = 0; k < 6; k++) {
        x[k] = five_x[star[k]];
        y[k] = five_y[star[k]];
    }
    polyline(&set, 6, x, y);
    polyline(&set, 5, square_x, square_y);
    polyline(&set, 3, back_x, back_y);
    polyline(&set, 3, there_x, there_y);
    assert_int_equal(records_alone(&set.at[0], &first, 0), 5);
    assert_int_equal(records_alone(&set.at[1], &first, 0), 0);
    assert_int_equal(records_alone(&set.at[2], &first, 1), 1);
    assert_true(first.joint && first.overlap >= 0);
    assert_int_equal(records_alone(&set.at[3], &first, 0), 0);
    path_set_clear(&set);
}

/* Two squares, the second moved so that corners, sides or nothing agree. */
static void check_squares(int dx, int dy, int crossings, int overlaps)
{
    const real x[] = {0, 4, 4, 0, 0}, y[] = {0, 0, 4, 4, 0};
    real u[5], v[5];
    struct path_set set = {0, 0, NULL};
    struct path_job job;
    int simple = 0;
    for (int k = 0; k < 5; k++) {
        u[k] = x[k] + dx;
        v[k] = y[k] + dy;
    }
    polyline(&set, 5, x, y);
    polyline(&set, 5, u, v);
    job_of(&job, &set.at[0], &set.at[1]);
    for (int r = 0; r < job.records.count; r++)
        simple += job.records.at[job.records.order[r]].overlap < 0 &&
                  job.records.at[job.records.order[r]].chain == 0;
    if (simple != crossings || job.records.overlaps != overlaps)
        fail_msg("squares apart by (%d, %d): %d crossings and %d overlaps, expected %d and %d", dx, dy,
                 simple, job.records.overlaps, crossings, overlaps);
    path_job_clear(&job);
    path_set_clear(&set);
}

static void squares(void **state)
{
    (void)state;
    check_squares(1, 1, 2, 0);
    check_squares(4, 4, 1, 0); /* corner on corner */
    check_squares(5, 0, 0, 0);
    check_squares(0, 0, 0, 4); /* one chain */
    check_squares(2, 0, 0, 2);
    check_squares(4, 0, 0, 1);
    check_squares(4, 2, 0, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pair_is_lost),
        cmocka_unit_test(pairs_are_all),
        cmocka_unit_test(room_is_found),
        cmocka_unit_test(cutting_changes_nothing),
        cmocka_unit_test(moves_change_nothing),
        cmocka_unit_test(loops_of_cubics),
        cmocka_unit_test(corners_are_no_crossings),
        cmocka_unit_test(squares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
