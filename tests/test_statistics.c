/* Median, MAD and bootstrap interval as theorems about random samples. */
#include "prop.h"

#include <math.h>
#include <string.h>

#include "../harness/statistics.h"

enum { LONGEST = 60 };

/* Dyadic, with ties: multiples of 1/8 in [-16, 16]. */
static int draw_sample(struct random_state *r, double *x)
{
    int n = (int)random_between(r, 1, LONGEST);

    for (int i = 0; i < n; i++)
        x[i] = random_between(r, -128, 128) / 8.0;
    return n;
}

/* Half of the sample lies at or below the median, half at or above; so of the distances for the MAD. */
static void test_median_halves_the_sample(void **state)
{
    (void)state;
    for (int trial = 0; trial < 2000; trial++) {
        struct random_state r = random_for(1, "median", trial);
        double x[LONGEST], copy[LONGEST], median, mad;
        int n = draw_sample(&r, x), below = 0, above = 0, near = 0, far = 0;

        memcpy(copy, x, sizeof x);
        median = statistics_median(n, x);
        mad = statistics_mad(n, x);
        assert_memory_equal(copy, x, n * sizeof *x);
        for (int i = 0; i < n; i++) {
            below += x[i] <= median;
            above += x[i] >= median;
            near += fabs(x[i] - median) <= mad;
            far += fabs(x[i] - median) >= mad;
            assert_true(statistics_min(n, x) <= x[i]);
        }
        assert_true(2 * below >= n && 2 * above >= n);
        assert_true(2 * near >= n && 2 * far >= n);
    }
}

/* An even sample takes the mean of its two middle values: with one added beyond each end nothing changes. */
static void test_median_of_even_samples(void **state)
{
    (void)state;
    for (int trial = 0; trial < 500; trial++) {
        struct random_state r = random_for(2, "even", trial);
        double x[LONGEST] = {random_between(&r, -9, 9) / 4.0, random_between(&r, -9, 9) / 4.0};
        double middle = (x[0] + x[1]) / 2;

        for (int n = 2; n <= LONGEST - 2; n += 2) {
            assert_true(statistics_median(n, x) == middle);
            x[n] = -3 - (double)random_between(&r, 0, 99);
            x[n + 1] = 3 + (double)random_between(&r, 0, 99);
        }
    }
}

/* x -> a x + b with a power of two a and dyadic b is exact, so the median follows and the MAD scales. */
static void test_median_and_mad_follow_affine_maps(void **state)
{
    (void)state;
    for (int trial = 0; trial < 1000; trial++) {
        struct random_state r = random_for(3, "affine", trial);
        double x[LONGEST], y[LONGEST],
            a = ldexp(random_bits(&r) & 1 ? 1 : -1, (int)random_between(&r, -9, 9));
        double b = random_between(&r, -1000, 1000) / 16.0;
        int n = draw_sample(&r, x);

        for (int i = 0; i < n; i++)
            y[n - 1 - i] = a * x[i] + b;
        assert_true(statistics_median(n, y) == a * statistics_median(n, x) + b);
        assert_true(statistics_mad(n, y) == fabs(a) * statistics_mad(n, x));
    }
}

static void test_bootstrap_stays_in_the_sample(void **state)
{
    (void)state;
    for (int trial = 0; trial < 100; trial++) {
        struct random_state r = random_for(4, "bounds", trial);
        double x[LONGEST], y[LONGEST], most = -INFINITY;
        int n = draw_sample(&r, x);
        struct range a = statistics_bootstrap_median(n, x, 0.95, trial), b, c, d;

        for (int i = 0; i < n; i++) {
            most = fmax(most, x[i]);
            y[i] = 4 * x[i];
        }
        b = statistics_bootstrap_median(n, x, 0.95, trial);
        c = statistics_bootstrap_median(n, y, 0.95, trial);
        d = statistics_bootstrap_median(n, x, 0.5, trial);
        assert_true(statistics_min(n, x) <= a.lo && a.hi <= most);
        assert_true(a.lo <= statistics_median(n, x) && statistics_median(n, x) <= a.hi);
        assert_true(a.lo == b.lo && a.hi == b.hi);
        assert_true(4 * a.lo == c.lo && 4 * a.hi == c.hi);
        assert_true(a.lo <= d.lo && d.hi <= a.hi);
    }
}

/* Share of intervals that hold the true median of a skewed law, and their mean width. */
static double coverage(int experiments, int n, double level, double *width)
{
    double x[200], truth = log(2);
    int held = 0;

    *width = 0;
    for (int e = 0; e < experiments; e++) {
        struct random_state r = random_for(5, "exponential", (uint64_t)e * 1000 + n);
        struct range range;

        for (int i = 0; i < n; i++)
            x[i] = -log(1 - random_unit(&r));
        range = statistics_bootstrap_median(n, x, level, e);
        held += range.lo <= truth && truth <= range.hi;
        *width += (range.hi - range.lo) / experiments;
    }
    return (double)held / experiments;
}

/* 400 experiments: the standard deviation of the share is 1.1 percent at level 0.95, 2.5 percent at 0.5. */
static void test_bootstrap_covers_the_median(void **state)
{
    double wide, narrow, share;

    (void)state;
    share = coverage(400, 51, 0.95, &wide);
    assert_true(0.91 <= share && share <= 0.985);
    share = coverage(400, 51, 0.5, &narrow);
    assert_true(0.42 <= share && share <= 0.6);
    assert_true(narrow < wide / 2);
}

/* Four times as many samples: half as wide. */
static void test_bootstrap_narrows_with_the_sample(void **state)
{
    double few, many;

    (void)state;
    coverage(100, 25, 0.95, &few);
    coverage(100, 100, 0.95, &many);
    assert_true(0.38 <= many / few && many / few <= 0.62);
}

/* Of 0, 1, ..., 10 in any order: the quantiles are 10 q. */
static void test_quantiles(void **state)
{
    double x[11];

    (void)state;
    for (int i = 0; i < 11; i++)
        x[(7 * i) % 11] = i;
    for (int k = 0; k <= 20; k++)
        assert_true(fabs(statistics_quantile(11, x, k / 20.0) - k / 2.0) < 1e-12);
    assert_true(statistics_quantile(1, x, 0.3) == x[0]);
}

/* Quartiles 2.5 and 7.5, 5 apart: mild beyond 15 or -5, severe beyond 22.5 or -12.5. */
static void test_outliers(void **state)
{
    double x[11];
    struct outliers found;

    (void)state;
    for (int i = 0; i < 11; i++)
        x[i] = i;
    found = statistics_outliers(11, x);
    assert_true(found.mild == 0 && found.severe == 0);
    x[10] = 15.5;
    found = statistics_outliers(11, x);
    assert_true(found.mild == 1 && found.severe == 0);
    x[0] = -13;
    x[10] = 23;
    found = statistics_outliers(11, x);
    assert_true(found.mild == 0 && found.severe == 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_median_halves_the_sample),
        cmocka_unit_test(test_median_of_even_samples),
        cmocka_unit_test(test_median_and_mad_follow_affine_maps),
        cmocka_unit_test(test_quantiles),
        cmocka_unit_test(test_outliers),
        cmocka_unit_test(test_bootstrap_stays_in_the_sample),
        cmocka_unit_test(test_bootstrap_covers_the_median),
        cmocka_unit_test(test_bootstrap_narrows_with_the_sample),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
