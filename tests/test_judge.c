/* The judge against answers whose verdicts are known because they were made by hand. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/judge/judge.h"
#include "../harness/judge/judge_groups.h"
#include "../harness/cases/problem.h"

enum { TRIALS = REAL_BITS == 53 ? 200 : REAL_BITS == 113 ? 60 : 12, GRID = 64 };

static const double TOL = 0x1p-30;

/* f runs along the axis, g(s) = (s, 2^-flat (s - r0) (s - r1) (s - r2)): they meet at t = s = r. */
struct scene {
    struct random_state r;
    struct test_case c;
    struct owned_problem owned;
    struct crossings *x;
    struct answer a;
    int solutions;
    real root[3];
    int multiplicity[3];
};

/* Six times the polar form at k ones and 3 - k zeros, times GRID^3. */
static long coefficient(const int root[3], int k)
{
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    long sum = 0;
    for (int i = 0; i < 6; i++) {
        long product = 1;
        for (int j = 0; j < 3; j++)
            product *= (j < k ? GRID : 0) - root[orders[i][j]];
        sum += product;
    }
    return sum;
}

static void parse_scene(struct scene *e, const char *line)
{
    char error[512];
    if (case_parse(line, "scene", 1, &e->c, error) != CASE_READ)
        fail_msg("%s", error);
    assert_null(owned_problem_make(&e->c, (real)TOL, 1000, &e->owned));
    e->x = (struct crossings *)calloc(1, sizeof *e->x);
    e->a.id = "scene";
    e->a.algorithm = "hand";
    e->a.tolerance = (real)TOL;
    e->a.outcome = SOLVED;
    e->a.steps = 1;
    e->a.points_only = false;
    e->a.crossings = e->x;
}

/* Simple roots at least 4 / GRID apart, or with twice set the last two equal. */
static void scene_make(struct scene *e, int trial, bool twice, int flat)
{
    int root[3], n = 0;
    char line[2048];
    memset((void *)e, 0, sizeof *e);
    e->r = random_for(7, "judge", (uint64_t)trial);
    root[0] = (int)random_between(&e->r, 2, 18);
    root[1] = root[0] + (int)random_between(&e->r, 4, 18);
    root[2] = twice ? root[1] : root[1] + (int)random_between(&e->r, 4, 18);
    n = sprintf(line, "{\"id\":\"scene\",\"f\":{\"points\":[[0,0],[1,0]]},\"g\":{\"points\":[");
    for (int k = 0; k < 4; k++)
        n += sprintf(line + n, "%s[\"%d/3\",\"%ld/%ld\"]", k ? "," : "", k, coefficient(root, k),
                     6L * GRID * GRID * GRID << flat);
    e->solutions = twice ? 2 : 3;
    n += sprintf(line + n, "]},\"expected\":{\"count\":%d,\"exact\":[", e->solutions);
    for (int i = 0; i < e->solutions; i++) {
        n += sprintf(line + n, "%s[\"%d/%d\",\"%d/%d\"]", i ? "," : "", root[i], GRID, root[i], GRID);
        e->root[i] = (real)root[i] / GRID;
        e->multiplicity[i] = twice && i == 1 ? 2 : 1;
    }
    sprintf(line + n, "],\"mult\":%s}}", twice ? "[1,2]" : "[1,1,1]");
    parse_scene(e, line);
}

static void scene_clear(struct scene *e)
{
    case_clear(&e->c);
    owned_problem_clear(&e->owned);
    free(e->x);
}

static struct judgement verdict(struct scene *e)
{
    return judge(&e->c, &e->owned.problem, &e->a, TOL);
}

/* A record around (t, s): sides of half to all of `width`, the point somewhere in it. */
static struct crossing *add(struct scene *e, real t, real s, double width, enum standing standing)
{
    struct crossing *c = &e->x->at[e->x->count++];
    real w = (real)width * (1 + prop_unit(&e->r, 20)) / 2, h = (real)width * (1 + prop_unit(&e->r, 20)) / 2;
    c->t.lo = t - w * prop_unit(&e->r, 20);
    c->t.hi = c->t.lo + w;
    c->s.lo = s - h * prop_unit(&e->r, 20);
    c->s.hi = c->s.lo + h;
    c->standing = standing;
    return c;
}

static void add_all(struct scene *e, enum standing standing)
{
    for (int i = 0; i < e->solutions; i++)
        add(e, e->root[i], e->root[i], TOL, standing);
}

static void assert_counts(struct judgement v, enum verdict verdict, int found, int missed, int extra,
                          int duplicate, int merged, int undecided)
{
    assert_string_equal(verdict_name(v.verdict), verdict_name(verdict));
    assert_int_equal(v.found, found);
    assert_int_equal(v.missed, missed);
    assert_int_equal(v.extra, extra);
    assert_int_equal(v.duplicate, duplicate);
    assert_int_equal(v.merged, merged);
    assert_int_equal(v.undecided, undecided);
}

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

/* ---- overlaps --------------------------------------------------------------------------------------------
 */

/* f is the parabola (t, t^2), g its arc over [a / 8, b / 8], reversed or not. */
static void overlap_make(struct scene *e, int trial)
{
    char line[1024];
    memset((void *)e, 0, sizeof *e);
    e->r = random_for(8, "judge overlap", (uint64_t)trial);
    int a = (int)random_between(&e->r, 0, 4), b = a + (int)random_between(&e->r, 1, 4);
    int from = trial % 2 ? b : a, to = trial % 2 ? a : b;
    sprintf(line,
            "{\"id\":\"overlap\",\"f\":{\"points\":[[0,0],[\"1/2\",0],[1,1]]},"
            "\"g\":{\"points\":[[\"%d/8\",\"%d/64\"],[\"%d/16\",\"%d/64\"],[\"%d/8\",\"%d/64\"]]},"
            "\"expected\":{\"count\":0,\"overlap\":[[\"%d/8\",\"%d/8\",%d,%d]]}}",
            from, from * from, from + to, from * to, to, to * to, a, b, trial % 2, 1 - trial % 2);
    parse_scene(e, line);
    e->root[0] = (real)a / 8;
    e->root[1] = (real)b / 8;
    struct overlap *o = &e->x->overlap[e->x->overlaps++];
    o->t_outer.lo = o->t_inner.lo = e->root[0];
    o->t_outer.hi = o->t_inner.hi = e->root[1];
    o->s_outer.lo = o->s_inner.lo = 0;
    o->s_outer.hi = o->s_inner.hi = 1;
    o->distance = 0;
    o->reversed = trial % 2;
    o->exact = true;
}

static void test_overlap_records(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        overlap_make(&e, i);
        struct overlap *o = &e.x->overlap[0];
        assert_counts(verdict(&e), RIGHT, 1, 0, 0, 0, 0, 0);
        o->exact = false;
        assert_counts(verdict(&e), RIGHT, 1, 0, 0, 0, 0, 0);
        add(&e, e.root[1], (real) !(i % 2), TOL, UNIQUE);
        o->t_outer.hi -= (real)0x1p-10; /* covered but for the end, which the other record holds */
        assert_counts(verdict(&e), RIGHT, 1, 0, 0, 0, 0, 1);
        o->t_outer.hi = (e.root[0] + e.root[1]) / 2; /* and now a half of it is not */
        assert_counts(verdict(&e), WRONG, 0, 1, 0, 0, 0, 1);
        scene_clear(&e);
    }
}

static void test_candidates_along_an_overlap(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        enum { PIECES = 16 };
        overlap_make(&e, i);
        e.x->overlaps = 0;
        e.a.outcome = i % 3 ? OUT_OF_STEPS : SOLVED;
        for (int k = 0; k < PIECES; k++) {
            struct crossing *c = &e.x->at[e.x->count++];
            c->t.lo = e.root[0] + (e.root[1] - e.root[0]) * (real)k / PIECES;
            c->t.hi = e.root[0] + (e.root[1] - e.root[0]) * (real)(k + 1) / PIECES;
            c->s.lo = (real)(i % 2 ? PIECES - 1 - k : k) / PIECES;
            c->s.hi = c->s.lo + (real)1 / PIECES;
        }
        assert_counts(verdict(&e), i % 3 ? STOPPED : RIGHT, 1, 0, 0, 0, 0, 1);
        e.x->at[PIECES / 2].standing = UNIQUE; /* one solution only, in the midst of an overlap? */
        assert_int_equal(verdict(&e).extra, 1);
        e.x->at[PIECES / 2] = e.x->at[0];
        struct judgement v = verdict(&e);
        assert_int_equal(v.missed, 1);
        assert_int_equal(v.found, 0);
        scene_clear(&e);
    }
}

static void test_overlaps_that_are_none(void **state)
{
    (void)state;
    struct scene e;
    scene_make(&e, 5, false, 10);
    add_all(&e, UNIQUE);
    struct overlap *o = &e.x->overlap[e.x->overlaps++];
    o->t_outer.lo = o->t_inner.lo = o->s_outer.lo = o->s_inner.lo = 0;
    o->t_outer.hi = o->t_inner.hi = o->s_outer.hi = o->s_inner.hi = 1;
    o->distance = (real)0x1p-10; /* true: the curves are this near all along */
    assert_int_equal(verdict(&e).extra, 0);
    assert_int_equal(verdict(&e).merged, 1); /* but that tells nothing apart */
    o->distance = (real)0x1p-20;
    assert_int_equal(verdict(&e).extra, 1);
    o->distance = (real)0x1p-10;
    o->exact = true;
    assert_int_equal(verdict(&e).extra, 1);
    scene_clear(&e);
}

/* ---- groups and distances --------------------------------------------------------------------------------
 */

static bool touch(const struct record *a, const struct record *b, real tol)
{
    return a->at.t.lo - tol <= b->at.t.hi + tol && b->at.t.lo - tol <= a->at.t.hi + tol &&
           a->at.s.lo - tol <= b->at.s.hi + tol && b->at.s.lo - tol <= a->at.s.hi + tol;
}

/* The sweep finds the components that comparing all with all finds. */
static void test_groups_are_components(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        struct grouping g;
        int name[120];
        scene_make(&e, i, false, 0);
        int count = (int)random_between(&e.r, 0, 120);
        for (int k = 0; k < count; k++)
            add(&e, prop_unit(&e.r, 6), prop_unit(&e.r, 6), 1.0 / 32, CANDIDATE);
        grouping_make(&e.a, (real)0x1p-9, &g);
        assert_int_equal(g.records, count);
        for (int k = 0; k < count; k++)
            name[k] = k;
        for (bool changed = true; changed;) {
            changed = false;
            for (int k = 0; k < count; k++)
                for (int j = 0; j < count; j++)
                    if (name[k] > name[j] && touch(&g.record[k], &g.record[j], (real)0x1p-9)) {
                        name[k] = name[j];
                        changed = true;
                    }
        }
        for (int k = 0; k < count; k++)
            for (int j = 0; j < k; j++)
                assert_true((name[k] == name[j]) == (g.record[k].group == g.record[j].group));
        grouping_clear(&g);
        scene_clear(&e);
    }
}

static void euclidean(const struct curve *c, real t, real at[2])
{
    real sum[3] = {0, 0, 0};
    for (int i = 0; i <= c->degree; i++) {
        real b = 1;
        for (int k = 0; k < i; k++)
            b = b * (real)(c->degree - k) / (real)(k + 1) * t;
        for (int k = i; k < c->degree; k++)
            b = b * (1 - t);
        sum[0] += b * c->x[i];
        sum[1] += b * c->y[i];
        sum[2] += b * (c->w ? c->w[i] : (real)1);
    }
    at[0] = sum[0] / sum[2];
    at[1] = sum[1] / sum[2];
}

/* What is said to be apart has no near points; and boxes of half the true distance are seen to be apart. */
static void test_apart_is_sound_and_sharp(void **state)
{
    (void)state;
    int seen = 0;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(9, "apart", (uint64_t)i);
        struct prop_curve f, g;
        struct problem p;
        struct box b;
        memset((void *)&p, 0, sizeof p);
        prop_curve_make(&f, &r, 1 + i % 5, 10, i % 2);
        prop_curve_make(&g, &r, 1 + i / 5 % 5, 10, i % 2);
        p.f = f.curve;
        p.g = g.curve;
        b.t.lo = prop_unit(&r, 10) * (real)(15.0 / 16);
        b.t.hi = b.t.lo + (real)(1.0 / 16);
        b.s.lo = prop_unit(&r, 10) * (real)(15.0 / 16);
        b.s.hi = b.s.lo + (real)(1.0 / 16);
        real least = 100, at[2], to[2];
        for (int k = 0; k <= 12; k++)
            for (int j = 0; j <= 12; j++) {
                euclidean(&p.f, b.t.lo + (b.t.hi - b.t.lo) * (real)k / 12, at);
                euclidean(&p.g, b.s.lo + (b.s.hi - b.s.lo) * (real)j / 12, to);
                real d = real_sqrt((at[0] - to[0]) * (at[0] - to[0]) + (at[1] - to[1]) * (at[1] - to[1]));
                least = real_min(least, d);
            }
        assert_false(curves_apart(&p, &b, least));
        if (least > (real)0.25) {
            assert_true(curves_apart(&p, &b, least / 2));
            seen++;
        }
    }
    assert_true(seen > TRIALS / 4);
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
        cmocka_unit_test(test_overlap_records),
        cmocka_unit_test(test_candidates_along_an_overlap),
        cmocka_unit_test(test_overlaps_that_are_none),
        cmocka_unit_test(test_groups_are_components),
        cmocka_unit_test(test_apart_is_sound_and_sharp),
    };
    return cmocka_run_group_tests_name("judge", tests, NULL, NULL);
}
