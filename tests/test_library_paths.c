/* fatline_paths gives the records of `fatline paths`, bit for bit, in one call or in several with little
 * memory; at joints they are true at all scales. */
#include <math.h>
#include <string.h>

#include "library_paths.h"

static const volatile int never = 0;

/* ---- the same as the program ---- */

static bool same_span(const struct fatline_path_span *s, const struct path_span *p)
{
    return s->first == p->first && s->last == p->last && s->lo == p->lo && s->hi == p->hi;
}

static bool same_overlap(const struct fatline_path_overlap *o, const struct path_overlap *p)
{
    return o->a_inner_lo == p->a_inner.lo && o->a_inner_hi == p->a_inner.hi &&
           o->b_inner_lo == p->b_inner.lo && o->b_inner_hi == p->b_inner.hi && o->distance == p->distance &&
           o->reversed == p->reversed;
}

static bool same_record(const struct fatline_paths_answer *a, int i, const struct path_records *all)
{
    static const enum fatline_standing standing[] = {FATLINE_CANDIDATE, FATLINE_UNIQUE, FATLINE_END,
                                                     FATLINE_CLUSTER};
    const struct fatline_path_crossing *c = &a->crossing[i];
    const struct path_record *r = &all->at[all->order[i]];
    if ((c->overlap >= 0) != (r->overlap >= 0) ||
        (c->overlap >= 0 && !same_overlap(&a->overlap[c->overlap], &all->overlap[r->overlap])))
        return false;
    return same_span(&c->a, &r->a) && same_span(&c->b, &r->b) && c->standing == standing[r->standing] &&
           (c->standing == FATLINE_CANDIDATE || c->at_most == r->at_most) && c->joint == r->joint &&
           c->chain == r->chain;
}

static bool same_answer(const struct fatline_paths_answer *a, const struct path_job *job)
{
    const struct path_records *all = &job->records;
    bool same = a->count == all->count && a->overlaps == all->overlaps && a->open == job->solver.unsolved;
    for (int i = 0; same && i < a->count; i++)
        same = same_record(a, i, all);
    return same;
}

/* The program's answer; b: NULL for a with itself. */
static void job_of(struct path_job *job, struct path_set *set, struct both *a, struct both *b)
{
    path_draft_end(&a->draft, set);
    if (b)
        path_draft_end(&b->draft, set);
    path_job_make(job, &set->at[0], b ? &set->at[1] : NULL, 1e-10, STEPS_MAX);
    assert_true(path_job_run(job, &never));
}

struct tally {
    int records, overlaps, joints, chains, ends, calls;
};

static void check_same(struct both *a, struct both *b, struct tally *sum)
{
    struct path_set set = {0, 0, NULL};
    struct path_job job;
    struct run z;
    job_of(&job, &set, a, b);
    run_init(&z, &a->path, b ? &b->path : NULL, 0);
    enum fatline_outcome o = fatline_paths(z.w, &a->path, b ? &b->path : NULL, NULL, 0, &z.a);
    if (o == FATLINE_OUT_OF_ROOM) {
        run_grow(&z, fatline_paths_memory_size(&a->path, b ? &b->path : NULL, (int)job.found));
        o = fatline_paths(z.w, NULL, NULL, NULL, z.a.done, &z.a);
        sum->calls++;
    }
    assert_true(o == (z.a.open > 0 ? FATLINE_OUT_OF_STEPS : FATLINE_SOLVED));
    if (!same_answer(&z.a, &job))
        fail_msg("%d and %d segments: the library has other records (%d, expected %d)", a->path.count,
                 b ? b->path.count : 0, z.a.count, job.records.count);
    for (int i = 0; i < z.a.count; i++) {
        sum->joints += z.a.crossing[i].joint;
        sum->chains += z.a.crossing[i].chain > 0;
        sum->ends += z.a.crossing[i].standing == FATLINE_END;
    }
    sum->records += z.a.count;
    sum->overlaps += z.a.overlaps;
    run_clear(&z);
    path_job_clear(&job);
    path_set_clear(&set);
}

static void same_as_the_program(void **state)
{
    (void)state;
    static const int counts[] = {100, 1000, 19000}; /* of the last, several blocks of pairs are made */
    for (int k = 0; k < 6; k++) {
        struct tally sum = {0, 0, 0, 0, 0, 0};
        struct both a, b;
        both_init(&a);
        both_init(&b);
        add_walk(&a, counts[k / 2], (uint64_t)k, 0);
        add_walk(&b, counts[k / 2], (uint64_t)k, 1);
        a.path.weights = b.path.weights = NULL; /* cubics without weights need neither array */
        a.path.degree = b.path.degree = NULL;
        check_same(&a, k % 2 ? &b : NULL, &sum);
        assert_true(sum.records > counts[k / 2] / 5 && (k < 4 || sum.calls == 1));
        both_clear(&a);
        both_clear(&b);
    }
}

/* All degrees, weights, joints, and the same segments again the other way round. */
static void mixed_paths(void **state)
{
    (void)state;
    struct tally sum = {0, 0, 0, 0, 0, 0};
    for (int run = 0; run < 60; run++) {
        struct random_state r = random_for(71, "library_paths", (uint64_t)run);
        struct both a, b;
        both_init(&a);
        both_init(&b);
        add_chain(&a, &r, (int)random_between(&r, 1, 40), run % 10 ? 5 : 32, run % 2, run % 3 == 0);
        add_chain(&b, &r, (int)random_between(&r, 1, 40), 4, run % 4 == 1, run % 3 == 1);
        for (int i = 0; run % 5 == 0 && i < a.path.count; i++)
            add_reversed(&b, &a, i);
        check_same(&a, run % 3 == 2 ? NULL : &b, &sum);
        both_clear(&a);
        both_clear(&b);
    }
    assert_true(sum.records > 1000 && sum.overlaps > 5 && sum.ends > 0);
}

/* Two squares end to end in one array: each is closed for itself. */
static void subpaths_are_apart(void **state)
{
    (void)state;
    const double corner_x[] = {0, 4, 4, 0, 0}, corner_y[] = {0, 0, 4, 4, 0};
    static const int begin[] = {0, 4};
    struct both a;
    struct run z;
    both_init(&a);
    for (int i = 0; i < 8; i++) {
        double x[2], y[2];
        for (int k = 0; k < 2; k++) {
            x[k] = corner_x[i % 4 + k] + i / 4;
            y[k] = corner_y[i % 4 + k] + i / 4;
        }
        add(&a, 1, x, y, NULL);
    }
    a.path.subpaths = 2;
    a.path.subpath = begin;
    run_init(&z, &a.path, NULL, 10);
    assert_int_equal(solve(&z, &a.path, NULL), FATLINE_SOLVED);
    assert_int_equal(z.a.count, 2);
    for (int i = 0; i < 2; i++)
        assert_int_equal(z.a.crossing[i].standing, FATLINE_UNIQUE);
    a.path.subpath = NULL; /* now the corners where they began and ended are told */
    assert_int_equal(solve(&z, &a.path, NULL), FATLINE_SOLVED);
    assert_int_equal(z.a.count, 4);
    run_clear(&z);
    both_clear(&a);
}

/* ---- scales ---- */

/* Where line i of a meets line j of b, with 113 bits. */
static bool lines_meet(const struct both *a, int i, const struct both *b, int j, __float128 *t, __float128 *s)
{
    const double *p = a->points + 4 * i, *q = b->points + 4 * j;
    __float128 ux = (__float128)p[2] - p[0], uy = (__float128)p[3] - p[1], vx = (__float128)q[2] - q[0],
               vy = (__float128)q[3] - q[1], rx = (__float128)q[0] - p[0], ry = (__float128)q[1] - p[1];
    __float128 det = ux * vy - uy * vx;
    *t = (rx * vy - ry * vx) / det;
    *s = (rx * uy - ry * ux) / det;
    return *t >= 0 && *t <= 1 && *s >= 0 && *s <= 1;
}

static bool span_has(const struct fatline_path_span *c, int segment, __float128 t)
{
    const __float128 pad = 1e-25;
    return (segment != c->first || t >= c->lo - pad) && (segment != c->last || t <= c->hi + pad);
}

/* Does a UNIQUE hold a point that the lines have in common? */
static bool is_true(const struct both *a, const struct both *b, const struct fatline_path_crossing *c)
{
    __float128 t, s;
    for (int k = 0; k < 4; k++) {
        int i = k & 1 ? c->a.last : c->a.first, j = k & 2 ? c->b.last : c->b.first;
        if (lines_meet(a, i, b, j, &t, &s) && span_has(&c->a, i, t) && span_has(&c->b, j, s))
            return true;
    }
    return false;
}

/* A corner of a, and a line, or a corner of b, through it but for some of the last bits. */
static void add_corners(struct both *a, struct both *b, struct random_state *r, double scale)
{
    double x[3], y[3], u[3], v[3], dx = prop_dyadic(r, 20), dy = prop_dyadic(r, 20);
    for (int i = 0; i < 3; i++) {
        x[i] = prop_dyadic(r, 52) * scale;
        y[i] = prop_dyadic(r, 52) * scale;
    }
    double off = ldexp((double)random_between(r, -40, 40), -54) * scale;
    u[0] = x[1] + off + dx * scale;
    v[0] = y[1] + dy * scale;
    u[1] = random_bits(r) & 1 ? x[1] + off : x[1] + off - dx / 2 * scale;
    v[1] = u[1] == x[1] + off ? y[1] : y[1] - dy / 2 * scale;
    u[2] = u[1] - dx * scale;
    v[2] = v[1] - dy * (1 + prop_dyadic(r, 3)) * scale;
    for (int i = 0; i < 2; i++) {
        add(a, 1, x + i, y + i, NULL);
        add(b, 1, u + i, v + i, NULL);
    }
}

static void joints_at_all_scales(void **state)
{
    (void)state;
    static const int exponents[] = {0, -1000, -600, -540, -532, -500, 480, 500, 520, 540, 700, 990};
    int at_joints[2] = {0, 0}, unique = 0;
    for (int run = 0; run < 6000; run++) {
        struct random_state r = random_for(74, "library_paths", (uint64_t)run / 12);
        struct both a, b;
        struct run z;
        both_init(&a);
        both_init(&b);
        add_corners(&a, &b, &r, ldexp(1, exponents[run % 12]));
        run_init(&z, &a.path, &b.path, 0);
        solve(&z, &a.path, &b.path);
        for (int i = 0; i < z.a.count; i++) {
            const struct fatline_path_crossing *c = &z.a.crossing[i];
            at_joints[run % 12 > 0] += c->a.first != c->a.last || c->b.first != c->b.last;
            unique += c->standing == FATLINE_UNIQUE;
            if (c->standing == FATLINE_UNIQUE && !is_true(&a, &b, c))
                fail_msg("run %d, scale 2^%d: record %d is UNIQUE and holds nothing", run,
                         exponents[run % 12], i);
        }
        run_clear(&z);
        both_clear(&a);
        both_clear(&b);
    }
    assert_true(at_joints[0] > 100 && at_joints[1] > 1000 && unique > 500);
}

/* ---- little memory ---- */

/* Each of `copies` segments meets each of the other path in nine places, or in an arc. */
static void add_copies(struct both *z, int copies, bool across, bool arcs)
{
    const double along[4] = {-1, -1.0 / 3, 1.0 / 3, 1}, swing[4] = {-9, 45, -45, 9};
    for (int k = 0; k < copies; k++) {
        double s[4], x[2] = {k / 4096.0, 1}, y[2] = {0, 0};
        for (int i = 0; i < 4; i++)
            s[i] = swing[i] / 8 + k / 4096.0;
        if (arcs)
            add(z, 1, x, y, NULL);
        else
            add(z, 3, across ? s : along, across ? along : s, NULL);
    }
}

static void memory_may_grow(void **state)
{
    (void)state;
    for (int arcs = 0; arcs < 2; arcs++) {
        struct path_set set = {0, 0, NULL};
        struct path_job job;
        struct both a, b;
        struct run z;
        both_init(&a);
        both_init(&b);
        add_copies(&a, arcs ? 70 : 40, false, arcs);
        add_copies(&b, arcs ? 70 : 40, true, arcs);
        job_of(&job, &set, &a, &b);
        run_init(&z, &a.path, &b.path, 0);
        int calls = 0, records = 0;
        enum fatline_outcome o = fatline_paths(z.w, &a.path, &b.path, NULL, 0, &z.a);
        while (o == FATLINE_OUT_OF_ROOM) {
            long long done = z.a.done;
            assert_true(!z.a.error && z.a.count == 0 && !z.a.crossing);
            o = fatline_paths(z.w, NULL, NULL, NULL, done + 1, &z.a); /* not where it stopped */
            assert_int_equal(o, FATLINE_INVALID);
            assert_non_null(strstr(z.a.error, "first"));
            run_grow(&z, fatline_paths_memory_size(&a.path, &b.path, records += 1 + records / 2));
            o = fatline_paths(z.w, NULL, NULL, NULL, done, &z.a);
            assert_true(z.a.done >= done);
            calls++;
        }
        assert_int_equal(o, FATLINE_SOLVED);
        assert_true(calls > 5 && same_answer(&z.a, &job));
        assert_int_equal(fatline_paths(z.w, &a.path, &b.path, NULL, z.a.done, &z.a), FATLINE_INVALID);
        run_clear(&z);
        path_job_clear(&job);
        path_set_clear(&set);
        both_clear(&a);
        both_clear(&b);
    }
}

/* Negative control: a point moved by its last bit is another answer. */
static void others_are_other(void **state)
{
    (void)state;
    struct path_set set = {0, 0, NULL};
    struct path_job job;
    struct both a;
    struct run z;
    both_init(&a);
    add_walk(&a, 200, 5, 0);
    job_of(&job, &set, &a, NULL);
    run_init(&z, &a.path, NULL, 1000);
    solve(&z, &a.path, NULL);
    assert_true(same_answer(&z.a, &job));
    int segment = z.a.crossing[0].a.first;
    a.points[8 * segment + 2] = nextafter(a.points[8 * segment + 2], 2);
    a.points[8 * segment + 3] = nextafter(a.points[8 * segment + 3], 2);
    solve(&z, &a.path, NULL);
    assert_false(same_answer(&z.a, &job));
    run_clear(&z);
    path_job_clear(&job);
    path_set_clear(&set);
    both_clear(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_as_the_program), cmocka_unit_test(mixed_paths),
        cmocka_unit_test(subpaths_are_apart),  cmocka_unit_test(joints_at_all_scales),
        cmocka_unit_test(memory_may_grow),     cmocka_unit_test(others_are_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
