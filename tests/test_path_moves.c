/* Paths: the answer does not depend on how a curve is cut, moved, turned or exchanged. */
#include "paths.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cutting_changes_nothing),
        cmocka_unit_test(moves_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
