/* Negative controls: each deliberate mistake is seen by the same theorem that its correct sibling passes. */
#include "nasty.h"
#include "solving.h"

enum { STEPS = REAL_BITS > 113 ? 200 : 3000, PAIRS = REAL_BITS > 113 ? 40 : REAL_BITS > 53 ? 60 : 300 };

static struct solver solver;

struct tally {
    int solved, unfinished, lost;
};

/* Planted pairs of degree 5 to 8: solutions lost, and how the solves end. */
static struct tally solve_all(const char *name, real tolerance)
{
    const struct intersector *a = intersector_find(name);
    struct tally tally = {0, 0, 0};
    assert_non_null(a);
    for (int i = 0; i < PAIRS; i++) {
        struct random_state r = random_for(1, "controls", (uint64_t)i);
        struct planted p;
        planted_make(&p, &r, (int)random_between(&r, 5, 8), (int)random_between(&r, 5, 8), 0);
        solver_init(&solver, a, p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
        struct problem problem = problem_of(&p.f.curve, &p.g.curve, tolerance, STEPS);
        enum outcome o = solver_run(&solver, &problem);
        tally.solved += o == SOLVED;
        tally.unfinished += o == OUT_OF_STEPS || o == OUT_OF_ROOM;
        tally.lost += !is_covered(&problem, &solver, p.t, p.s);
        solver_clear(&solver);
    }
    print_message("%-24s %d solved, %d unfinished, %d lost\n", name, tally.solved, tally.unfinished,
                  tally.lost);
    return tally;
}

/* With AND in the discard rule nothing is discarded: it loses nothing and does not end either. */
static void test_discard_and(void **state)
{
    (void)state;
    const real tolerance = (real)1 / 1000000;
    struct tally right = solve_all("hybrid_clipping_2", tolerance);
    struct tally wrong = solve_all("control_discard_and", tolerance);
    assert_true(right.lost == 0 && wrong.lost == 0);
    assert_true(10 * right.unfinished <= right.solved && wrong.unfinished > 10 * wrong.solved);
}

static void test_no_margin(void **state)
{
    (void)state;
    assert_int_equal(solve_all("hybrid_clipping_3", 64 * REAL_EPSILON).lost, 0);
    assert_true(solve_all("control_no_margin", 64 * REAL_EPSILON).lost > 0);
}

static void test_normal_not_unit(void **state)
{
    (void)state;
    assert_int_equal(solve_all("hybrid_clipping_2", 64 * REAL_EPSILON).lost, 0);
    assert_true(solve_all("control_normal_not_unit", 64 * REAL_EPSILON).lost > 0);
}

static void test_no_delta(void **state)
{
    (void)state;
    assert_true(solve_all("control_no_delta", 64 * REAL_EPSILON).lost > 0);
}

/* Controls are found by their exact names and are not in the registry. */
static void test_not_listed(void **state)
{
    (void)state;
    for (int i = 0; controls[i]; i++) {
        assert_ptr_equal(intersector_find(controls[i]->name), controls[i]);
        for (int k = 0; intersectors[k]; k++)
            assert_true(intersectors[k] != controls[i] && strcmp(intersectors[k]->name, controls[i]->name));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_discard_and),     cmocka_unit_test(test_no_margin),
        cmocka_unit_test(test_normal_not_unit), cmocka_unit_test(test_no_delta),
        cmocka_unit_test(test_not_listed),
    };
    return cmocka_run_group_tests_name("controls", tests, NULL, NULL);
}
