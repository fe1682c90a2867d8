/* The judge of points against answers made by hand: two segments that cross once, and a segment on itself. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/judge/judge_points.h"
#include "../harness/cases/problem.h"

static const double REACH = 1e-4;

struct scene {
    struct test_case c;
    struct owned_problem owned;
    struct answer a;
};

/* Three solutions, at t = s = 1/4, 1/2 and 3/4, as far as the judge is told. */
static const char crossings[] = "{\"id\":\"x\",\"f\":{\"points\":[[0,0],[1,1]]},\"g\":{\"points\":[[0,1],[1,"
                                "0]]},\"expected\":{\"count\":3,"
                                "\"params\":[[0.25,0.25],[0.5,0.5],[0.75,0.75]],\"exact\":[[\"1/4\",\"1/"
                                "4\"],[\"1/2\",\"1/2\"],[\"3/4\",\"3/4\"]]}}";
/* g is the second half of f and as much again. */
static const char shared[] =
    "{\"id\":\"y\",\"class\":\"overlap\",\"f\":{\"points\":[[0,0],[1,0]]},\"g\":{\"points\":[[\"1/"
    "2\",0],[\"3/2\",0]]},"
    "\"expected\":{\"count\":0,\"params\":[],\"exact\":[],\"overlap\":[[0.5,1,0,0.5]]}}";

static void scene_make(struct scene *e, const char *line)
{
    char error[512];
    memset((void *)e, 0, sizeof *e);
    if (case_parse(line, "scene", 1, &e->c, error) != CASE_READ)
        fail_msg("%s", error);
    assert_null(owned_problem_make(&e->c, (real)1e-9, 1000, &e->owned));
    e->a.id = e->a.algorithm = "hand";
    e->a.tolerance = (real)1e-9;
    e->a.outcome = SOLVED;
    e->a.points_only = true;
    e->a.crossings = (struct crossings *)calloc(1, sizeof *e->a.crossings);
}

static void scene_clear(struct scene *e)
{
    free(e->a.crossings);
    owned_problem_clear(&e->owned);
    case_clear(&e->c);
}

static void say(struct scene *e, double t, double s)
{
    struct crossing *c = &e->a.crossings->at[e->a.crossings->count++];
    c->t.lo = c->t.hi = (real)t;
    c->s.lo = c->s.hi = (real)s;
    c->standing = CANDIDATE;
    c->at_most = c->multiplicity = 0;
}

static void say_overlap(struct scene *e, double t0, double t1, double s0, double s1)
{
    struct overlap *o = &e->a.crossings->overlap[e->a.crossings->overlaps++];
    o->t_outer.lo = o->t_inner.lo = (real)t0;
    o->t_outer.hi = o->t_inner.hi = (real)t1;
    o->s_outer.lo = o->s_inner.lo = (real)s0;
    o->s_outer.hi = o->s_inner.hi = (real)s1;
    o->distance = 4;
}

static struct point_judgement judge_scene(const struct scene *e)
{
    return judge_points(&e->c, &e->owned.problem, &e->a, REACH);
}

static void assert_judged(const struct scene *e, enum verdict verdict, int found, int missed, int extra,
                          int duplicate)
{
    struct judgement j = judge_scene(e).found;
    assert_int_equal(j.verdict, verdict);
    assert_int_equal(j.found, found);
    assert_int_equal(j.missed, missed);
    assert_int_equal(j.extra, extra);
    assert_int_equal(j.duplicate, duplicate);
}

static void test_one_to_one(void **state)
{
    struct scene e;
    (void)state;
    scene_make(&e, crossings);
    assert_judged(&e, WRONG, 0, 3, 0, 0);
    say(&e, 0.25, 0.25);
    say(&e, 0.5 + 3e-5, 0.5 - 6e-5);
    say(&e, 0.75, 0.75);
    assert_judged(&e, RIGHT, 3, 0, 0, 0);
    assert_true(fabs(judge_scene(&e).found.max_error - 6e-5) < 1e-12);
    say(&e, 0.75 - 5e-5, 0.75); /* a second one of the third */
    assert_judged(&e, WRONG, 3, 0, 0, 1);
    say(&e, 0.75, 0.25); /* t of one, s of another */
    assert_judged(&e, WRONG, 3, 0, 1, 1);
    assert_int_equal(judge_scene(&e).points, 5);
    scene_clear(&e);
}

/* The nearest pair first: a point between two solutions does not take away the other's. */
static void test_nearest_first(void **state)
{
    struct scene e;
    (void)state;
    scene_make(&e, crossings);
    say(&e, 0.5 + 9e-5, 0.5);
    say(&e, 0.5 + 1e-5, 0.5);
    say(&e, 0.25 + 2e-4, 0.25); /* beyond reach */
    assert_judged(&e, WRONG, 1, 2, 1, 1);
    assert_true(fabs(judge_scene(&e).found.max_error - 1e-5) < 1e-12);
    scene_clear(&e);
}

/* What reports intervals is one point where they touch. */
static void test_records_that_touch(void **state)
{
    struct scene e;
    (void)state;
    scene_make(&e, crossings);
    e.a.points_only = false;
    for (int i = 0; i < 3; i++) {
        double middle = 0.25 * (i + 1);
        for (int k = -1; k <= 1; k += 2) {
            struct crossing *c = &e.a.crossings->at[e.a.crossings->count++];
            c->t.lo = (real)(middle + (k < 0 ? -1e-9 : 0));
            c->t.hi = (real)(middle + (k < 0 ? 0 : 1e-9));
            c->s = c->t;
            c->standing = CANDIDATE;
        }
    }
    assert_judged(&e, RIGHT, 3, 0, 0, 0);
    assert_int_equal(judge_scene(&e).points, 3);
    scene_clear(&e);
}

/* What is proved to be one solution is a point, however near another is: two solutions within the tolerance.
 */
static void test_proved_records_stay_apart(void **state)
{
    static const char near_ones[] =
        "{\"id\":\"z\",\"f\":{\"points\":[[0,0],[1,1]]},\"g\":{\"points\":[[0,1],[1,0]]},"
        "\"expected\":{\"count\":2,\"params\":[[0.5,0.5],[0.50000001,0.5]],\"exact\":[[\"1/2\",\"1/2\"],"
        "[\"50000001/100000000\",\"1/2\"]]}}";
    struct scene e;
    (void)state;
    scene_make(&e, near_ones);
    e.a.points_only = false;
    e.a.tolerance = (real)1e-6;
    say(&e, 0.5, 0.5);
    say(&e, 0.50000001, 0.5);
    assert_judged(&e, WRONG, 1, 1, 0, 0);
    e.a.crossings->at[0].standing = e.a.crossings->at[1].standing = UNIQUE;
    assert_judged(&e, RIGHT, 2, 0, 0, 0);
    say(&e, 0.500000005, 0.5); /* what touches them says no more */
    assert_judged(&e, RIGHT, 2, 0, 0, 0);
    e.a.crossings->at[2].standing = UNIQUE; /* but proved, it is one too many */
    assert_judged(&e, WRONG, 2, 0, 0, 1);
    scene_clear(&e);
}

static void test_outcomes_that_are_no_answers(void **state)
{
    static const struct {
        enum outcome outcome;
        enum verdict verdict;
    } all[] = {{GAVE_UP, BROKEN},
               {CRASHED, BROKEN},
               {TIMED_OUT, BROKEN},
               {UNSUPPORTED, NOT_TAKEN},
               {INVALID, NOT_TAKEN}};
    struct scene e;
    (void)state;
    scene_make(&e, crossings);
    for (int i = 0; i < 5; i++) {
        e.a.outcome = all[i].outcome;
        assert_judged(&e, all[i].verdict, 0, 0, 0, 0);
        assert_int_equal(judge(&e.c, &e.owned.problem, &e.a, 1e-9).verdict, all[i].verdict);
    }
    scene_clear(&e);
}

static void assert_overlap(const struct scene *e, const char *told, enum verdict verdict)
{
    struct point_judgement j = judge_scene(e);
    assert_string_equal(j.overlap, told);
    assert_int_equal(j.found.verdict, verdict);
    assert_int_equal(j.found.extra, 0);
}

static void test_how_an_overlap_is_told(void **state)
{
    struct scene e;
    (void)state;
    scene_make(&e, shared);
    assert_overlap(&e, "nothing", WRONG);
    say(&e, 0.5, 0);
    say(&e, 1, 0.5);
    assert_overlap(&e, "end points", RIGHT);
    say(&e, 0.75, 0.25);
    assert_overlap(&e, "points 3", WRONG);
    say_overlap(&e, 0, 1, 0, 1);
    assert_overlap(&e, "said", RIGHT);
    e.a.crossings->overlaps = 0;
    say_overlap(&e, 0.5 + 1e-5, 1, 0, 0.5);
    assert_overlap(&e, "ends", RIGHT);
    say(&e, 0.25, 0.75); /* off the shared arc */
    assert_int_equal(judge_scene(&e).found.extra, 1);
    scene_clear(&e);
}

static void test_an_overlap_that_is_none(void **state)
{
    struct scene e;
    (void)state;
    scene_make(&e, crossings);
    say_overlap(&e, 0, 1, 0, 1);
    assert_judged(&e, WRONG, 0, 3, 1, 0);
    scene_clear(&e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_to_one),
        cmocka_unit_test(test_nearest_first),
        cmocka_unit_test(test_records_that_touch),
        cmocka_unit_test(test_proved_records_stay_apart),
        cmocka_unit_test(test_outcomes_that_are_no_answers),
        cmocka_unit_test(test_how_an_overlap_is_told),
        cmocka_unit_test(test_an_overlap_that_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
