/* Regions of random families: right by sampled half-planes, in two ways alike; and mistakes are found. */
#include "region_family.h"

/* ---- right, and certified but for one in a hundred ---- */

static void test_random(void **state)
{
    (void)state;
    int n = trials(1500), certified = 0;
    for (int i = 0; i < n; i++) {
        struct family f;
        family_open(&f, 11, 3, 9, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        const char *wrong = sampled(&f, f.region);
        if (wrong)
            fail_msg("%s: %s", f.c.id, wrong);
        certified += f.region->certified;
        family_close(&f);
    }
    if (100 * certified < 99 * n)
        fail_msg("%d of %d certified", certified, n);
}

/* Cutting leaves a little more than the exact structure, everywhere within some sizes of the curve. */
static void test_methods_agree(void **state)
{
    (void)state;
    for (int i = 0; i < trials(200); i++) {
        struct family f;
        family_open(&f, 12, 3, 7, (uint64_t)i);
        f.owned.problem.tolerance = (real)1 / 65536;
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        assert_int_equal(find(&f, "region_cutting", f.other), SOLVED);
        const char *wrong = region_check_agree(&f.owned.problem, &f.room.workspace, f.region, f.other);
        if (wrong)
            fail_msg("%s: %s", f.c.id, wrong);
        family_close(&f);
    }
}

/* ---- mistakes are found ---- */

/* Negative control: a region with a vertex farther out by a tenth, and an empty one, are told from the right
 * one. */
static void test_damage_is_found(void **state)
{
    (void)state;
    int damaged = 0, found = 0;
    for (int i = 0; i < 400 && damaged < trials(40); i++) {
        struct family f;
        family_open(&f, 17, 3, 6, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        if (is_compact(&f) && f.region->strict && f.region->disc_radius > size_of(&f) / 100) {
            struct region_edge *e = &f.region->edge[0], *last = &f.region->edge[f.region->count - 1];
            e->from.x += (e->from.x - f.region->disc_centre.x) / 10;
            e->from.y += (e->from.y - f.region->disc_centre.y) / 10;
            last->to = e->from;
            f.owned.problem.tolerance = (real)1 / 65536;
            damaged++;
            found += sampled(&f, f.region) != NULL;
            assert_int_equal(find(&f, "region_cutting", f.other), SOLVED);
            damaged++;
            found += region_check_agree(&f.owned.problem, &f.room.workspace, f.region, f.other) != NULL;
            f.region->kind = REGION_EMPTY;
            damaged++;
            found += sampled(&f, f.region) != NULL;
        }
        family_close(&f);
    }
    assert_true(damaged > 0);
    assert_int_equal(found, damaged);
}

static void test_limits(void **state)
{
    (void)state;
    struct family f;
    family_open(&f, 18, 9, 9, 0);
    const char *field;
    struct region_problem p = f.owned.problem;
    p.sign = 0;
    assert_non_null(region_problem_check(&p, &field));
    assert_string_equal(field, "sign");
    assert_int_equal(region_solve(&p, region_methods[0], &f.room.workspace, f.region), INVALID);
    p = f.owned.problem;
    p.max_steps = 1;
    p.interval.lo = f.owned.problem.interval.lo;
    for (int i = 0; region_methods[i]; i++) {
        enum outcome outcome = region_solve(&p, region_methods[i], &f.room.workspace, f.region);
        assert_true(outcome == SOLVED || outcome == OUT_OF_STEPS);
        assert_false(outcome == OUT_OF_STEPS && f.region->certified);
    }
    family_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_methods_agree),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_damage_is_found),
    };
    return cmocka_run_group_tests_name("region", tests, NULL, NULL);
}
