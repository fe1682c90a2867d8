/* Answers made by hand to a scene whose solutions are known, for the tests of the judge. */
#ifndef FATLINE_TEST_SCENE_H
#define FATLINE_TEST_SCENE_H

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
static inline long coefficient(const int root[3], int k)
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

static inline void parse_scene(struct scene *e, const char *line)
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
static inline void scene_make(struct scene *e, int trial, bool twice, int flat)
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

static inline void scene_clear(struct scene *e)
{
    case_clear(&e->c);
    owned_problem_clear(&e->owned);
    free(e->x);
}

static inline struct judgement verdict(struct scene *e)
{
    return judge(&e->c, &e->owned.problem, &e->a, TOL);
}

/* A record around (t, s): sides of half to all of `width`, the point somewhere in it. */
static inline struct crossing *add(struct scene *e, real t, real s, double width, enum standing standing)
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

static inline void add_all(struct scene *e, enum standing standing)
{
    for (int i = 0; i < e->solutions; i++)
        add(e, e->root[i], e->root[i], TOL, standing);
}

static inline void assert_counts(struct judgement v, enum verdict verdict, int found, int missed, int extra,
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

#endif
