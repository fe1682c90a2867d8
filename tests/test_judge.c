/* The judge against answers whose verdicts are known because they were made by hand. */
#include "scene.h"

/* ---- solved ----------------------------------------------------------------------------------------------
 */

static void test_right_answers(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        scene_make(&e, i, false, 0);
        add_all(&e, i % 2 ? UNIQUE : CANDIDATE);
        struct judgement v = verdict(&e);
        assert_counts(v, RIGHT, 3, 0, 0, 0, 0, 0);
        assert_int_equal(v.expected, 3);
        assert_true(v.max_error > 0 && v.max_error <= 0.5 * TOL);
        assert_true(isnan(v.missed_t) && isnan(v.extra_t));
        scene_clear(&e);
    }
}

static void test_missed(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        int gone = i % 3;
        scene_make(&e, i, false, 0);
        add_all(&e, CANDIDATE);
        if (i % 2) { /* left out */
            e.x->at[gone] = e.x->at[2];
            e.x->count = 2;
        } else { /* beside the solution in s: neither here nor there */
            e.x->at[gone].s.lo += (real)(3 * TOL);
            e.x->at[gone].s.hi += (real)(3 * TOL);
        }
        struct judgement v = verdict(&e);
        assert_int_equal(v.missed, 1);
        assert_int_equal(v.found, 2);
        assert_true(v.verdict == WRONG);
        assert_true(fabs(v.missed_t - real_to_double(e.root[gone])) < 1e-12);
        scene_clear(&e);
    }
}

/* A run of records on the diagonal from `from` to `to` times tol from a root. */
static void add_run(struct scene *e, real root, double from, double to)
{
    double step = 0.7 * TOL;
    for (double at = from * TOL; at < to * TOL; at += step) {
        struct crossing *c = &e->x->at[e->x->count++];
        c->t.lo = c->s.lo = root + (real)at;
        c->t.hi = c->s.hi = root + (real)fmin(at + step / 2, to * TOL);
        c->standing = CANDIDATE;
    }
}

static void test_fragments_are_merged(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        scene_make(&e, i, false, 10);
        add_run(&e, e.root[0], -1.9, 1.9);
        add_run(&e, e.root[1], -2, 5);
        add(&e, e.root[2], e.root[2], TOL, UNIQUE);
        struct judgement v = verdict(&e);
        assert_counts(v, WRONG, 2, 0, 0, 0, 1, 0);
        scene_clear(&e);
    }
}

static void test_extra_and_undecided(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        scene_make(&e, i, false, 10);
        int far = (int)random_between(&e.r, 8, 100);
        add_all(&e, UNIQUE);
        /* far tol from a root, where the curves are nearer than tol: nothing there, and not proved */
        real t = e.root[i % 3] + (real)(far * TOL);
        struct crossing *more = add(&e, t, t, TOL, CANDIDATE);
        assert_counts(verdict(&e), RIGHT, 3, 0, 0, 0, 0, 1);
        more->standing = END;
        assert_counts(verdict(&e), RIGHT, 3, 0, 0, 0, 0, 1);
        more->standing = CLUSTER; /* promises none, however many it allows */
        for (more->at_most = 0; more->at_most <= 9; more->at_most++)
            assert_counts(verdict(&e), RIGHT, 3, 0, 0, 0, 0, 1);
        more->standing = UNIQUE;
        struct judgement v = verdict(&e);
        assert_counts(v, WRONG, 3, 0, 1, 0, 0, 0);
        assert_true(fabs(v.extra_t - real_to_double(t)) < 1e-8);
        /* where the curves are apart */
        more->standing = i % 2 ? CANDIDATE : CLUSTER;
        more->s.lo += (real)(40 * TOL);
        more->s.hi += (real)(40 * TOL);
        assert_counts(verdict(&e), WRONG, 3, 0, 1, 0, 0, 0);
        scene_clear(&e);
    }
}

static void test_duplicates(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        bool twice = i % 2;
        scene_make(&e, i, twice, 0);
        add_all(&e, UNIQUE);
        add(&e, e.root[1], e.root[1], TOL, CANDIDATE);
        assert_counts(verdict(&e), RIGHT, e.solutions, 0, 0, 0, 0, 0);
        add(&e, e.root[1], e.root[1], TOL, UNIQUE);
        assert_counts(verdict(&e), twice ? RIGHT : WRONG, e.solutions, 0, 0, !twice, 0, 0);
        scene_clear(&e);
    }
}

static void test_cluster_bounds(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++)
        for (int at_most = 0; at_most <= 5; at_most++) {
            struct scene e;
            int which = i % 2;
            scene_make(&e, i, true, 0);
            add_all(&e, UNIQUE);
            struct crossing *c = &e.x->at[which];
            c->standing = CLUSTER;
            c->at_most = at_most;
            /* the solution in its middle */
            const real half = i % 3 ? (real)(TOL / 2) : (real)(TOL / 1024);
            c->t.lo = c->s.lo = e.root[which] - half;
            c->t.hi = c->s.hi = e.root[which] + half;
            int m = e.multiplicity[which];
            bool good = at_most >= m;
            int loose = at_most > m + 1; /* a bound nevertheless */
            assert_counts(verdict(&e), good ? RIGHT : WRONG, good ? 2 : 1, good ? 0 : 1, 0, 0, 0, loose);
            scene_clear(&e);
        }
}

/* A bound that is not known is no bound: nothing is held against a CLUSTER for it. */
static void test_cluster_of_unknown_multiplicity(void **state)
{
    (void)state;
    struct scene e;
    scene_make(&e, 1, true, 0);
    add_all(&e, UNIQUE);
    e.c.expected.at[1].multiplicity = 0;
    e.x->at[1].standing = CLUSTER;
    e.x->at[1].at_most = 7;
    assert_counts(verdict(&e), RIGHT, 2, 0, 0, 0, 0, 0);
    scene_clear(&e);
}

/* ---- not solved ------------------------------------------------------------------------------------------
 */

static void test_stopped(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        scene_make(&e, i, false, 0);
        e.a.outcome = i % 2 ? OUT_OF_STEPS : OUT_OF_ROOM;
        add(&e, e.root[0], e.root[0], TOL, UNIQUE);
        struct crossing *rest = add(&e, e.root[1], e.root[1], TOL, CANDIDATE);
        rest->t.hi = rest->s.hi = e.root[2] + (real)0x1p-10;
        add(&e, (real)1, (real)0, TOL, CANDIDATE); /* far from any solution, but still to be looked at */
        assert_counts(verdict(&e), STOPPED, 1, 0, 0, 0, 0, 1);
        rest->t.hi = e.root[2] - (real)(2 * TOL);
        struct judgement v = verdict(&e);
        assert_counts(v, WRONG, 1, 1, 0, 0, 0, 1);
        assert_true(fabs(v.missed_t - real_to_double(e.root[2])) < 1e-12);
        rest->t.hi = e.root[2];
        e.x->at[2].standing = UNIQUE;
        assert_counts(verdict(&e), WRONG, 1, 0, 1, 0, 0, 0);
        scene_clear(&e);
    }
}

static void test_no_answer_and_no_truth(void **state)
{
    (void)state;
    struct scene e;
    scene_make(&e, 0, false, 0);
    e.a.outcome = UNSUPPORTED;
    assert_true(verdict(&e).verdict == NOT_TAKEN);
    e.a.outcome = INVALID;
    assert_counts(verdict(&e), NOT_TAKEN, 0, 0, 0, 0, 0, 0);
    e.a.outcome = SOLVED;
    e.c.expected.known = false;
    assert_true(verdict(&e).verdict == UNJUDGED);
    e.c.expected.known = true;
    assert_counts(verdict(&e), WRONG, 0, 3, 0, 0, 0, 0);
    scene_clear(&e);
}

static void test_points(void **state)
{
    (void)state;
    struct scene e;
    scene_make(&e, 3, false, 0);
    for (int i = 0; i < 3; i++)
        add(&e, e.root[i], e.root[i], TOL, UNIQUE);
    /* far too wide, but for the middle */
    e.x->at[1].t.lo = e.x->at[1].s.lo = e.root[1] - (real)0x1p-9;
    e.x->at[1].t.hi = e.x->at[1].s.hi = e.root[1] + (real)0x1p-9;
    assert_int_equal(verdict(&e).merged, 1);
    e.a.points_only = true;
    assert_counts(verdict(&e), RIGHT, 3, 0, 0, 0, 0, 0);
    e.x->at[1].t.hi += (real)0x1p-20; /* the middle is off, though the box holds the solution */
    assert_int_equal(verdict(&e).missed, 1);
    assert_int_equal(verdict(&e).found, 2);
    scene_clear(&e);
}

static void test_order_does_not_matter(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        scene_make(&e, i, i % 2, i % 12);
        int count = (int)random_between(&e.r, 1, 40);
        for (int k = 0; k < count; k++) {
            real at = e.root[k % e.solutions] + (real)(TOL * random_between(&e.r, -6, 6));
            add(&e, at, at, TOL * (double)random_between(&e.r, 1, 3), k % 5 ? CANDIDATE : UNIQUE);
        }
        struct judgement v = verdict(&e);
        for (int k = e.x->count - 1; k > 0; k--) {
            int j = (int)random_between(&e.r, 0, k);
            struct crossing swap = e.x->at[k];
            e.x->at[k] = e.x->at[j];
            e.x->at[j] = swap;
        }
        assert_counts(verdict(&e), v.verdict, v.found, v.missed, v.extra, v.duplicate, v.merged, v.undecided);
        assert_true(v.found + v.missed <= v.expected);
        scene_clear(&e);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_right_answers),
        cmocka_unit_test(test_missed),
        cmocka_unit_test(test_fragments_are_merged),
        cmocka_unit_test(test_extra_and_undecided),
        cmocka_unit_test(test_duplicates),
        cmocka_unit_test(test_cluster_bounds),
        cmocka_unit_test(test_cluster_of_unknown_multiplicity),
        cmocka_unit_test(test_stopped),
        cmocka_unit_test(test_no_answer_and_no_truth),
        cmocka_unit_test(test_points),
        cmocka_unit_test(test_order_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
