/* A part of an interval is rounded outwards, and never past the interval. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/cells.h"

/* a.lo + (a.hi - a.lo) t. */
static void exact_map(const struct interval *a, real t, mpq_t out)
{
    mpq_t lo, local;
    mpq_inits(lo, local, NULL);
    real_to_rational(a->lo, lo);
    real_to_rational(a->hi, out);
    real_to_rational(t, local);
    mpq_sub(out, out, lo);
    mpq_mul(out, out, local);
    mpq_add(out, out, lo);
    mpq_clears(lo, local, NULL);
}

static void test_clip(void **state)
{
    (void)state;
    mpq_t exact, end;
    mpq_inits(exact, end, NULL);
    for (int i = 0; i < trials(50000); i++) {
        struct random_state r = random_for(1, "clip", (uint64_t)i);
        struct interval a = nasty_interval(&r), part = nasty_interval(&r), clipped = a;
        interval_clip(&clipped, part.lo, part.hi);
        assert_true(a.lo <= clipped.lo && clipped.lo <= clipped.hi && clipped.hi <= a.hi);
        exact_map(&a, part.lo, exact);
        real_to_rational(clipped.lo, end);
        bool covers = mpq_cmp(end, exact) <= 0;
        exact_map(&a, part.hi, exact);
        real_to_rational(clipped.hi, end);
        if (!covers || mpq_cmp(end, exact) < 0)
            fail_msg("clip %d cuts off", i);
    }
    mpq_clears(exact, end, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_clip),
    };
    return cmocka_run_group_tests_name("cells", tests, NULL, NULL);
}
