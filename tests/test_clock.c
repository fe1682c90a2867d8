/* The clock on work of known amount. */
#include "prop.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "../harness/timing/clock.h"
#include "../harness/timing/statistics.h"

enum { ITEMS = 40, ROUNDS = 41 };

/* Item i does amount[i] turns of a loop that the compiler cannot shorten: each turn needs the last. */
struct labour {
    int amount[ITEMS];
    double result;
};

static void labour_run(void *context, int first, int last)
{
    struct labour *l = context;

    for (int i = first; i < last; i++) {
        double x = 0.3;

        for (int k = 0; k < l->amount[i]; k++)
            x = 3.7 * x * (1 - x);
        l->result = x;
        clock_keep(l);
    }
}

static struct clock_task labour_task(struct labour *l, int amount)
{
    struct clock_task task = {ITEMS, labour_run, l, false};

    for (int i = 0; i < ITEMS; i++)
        l->amount[i] = amount;
    return task;
}

/* Median of the paired ratios b / a. */
static double ratio(int a, int b, struct range *range)
{
    struct labour first, second;
    struct clock_task task[2] = {labour_task(&first, a), labour_task(&second, b)};
    struct clock_plan plan = {ROUNDS, 0, 2e5, 7};
    struct clock_samples samples[2];
    double q[ROUNDS], median;

    clock_interleave(2, task, &plan, samples);
    for (int k = 0; k < 2; k++)
        assert_int_equal(samples[k].count, ROUNDS);
    for (int r = 0; r < ROUNDS; r++)
        q[r] = samples[1].ns[r] / samples[0].ns[r];
    median = statistics_median(ROUNDS, q);
    *range = statistics_bootstrap_median(ROUNDS, q, 0.95, 7);
    for (int k = 0; k < 2; k++)
        clock_samples_clear(&samples[k]);
    return median;
}

static void test_clocks_advance(void **state)
{
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        double last = clock_now(wall), tick = clock_tick(wall);

        assert_true(tick > 0 && tick < 1e6);
        for (int i = 0; i < 1000; i++) {
            double now = clock_now(wall);

            assert_true(now >= last);
            last = now;
        }
    }
}

/* Loose: other work may run beside the test. */
static void test_same_work_same_time(void **state)
{
    struct range range;
    double q = ratio(1000, 1000, &range);

    (void)state;
    assert_true(0.9 < q && q < 1.1);
    assert_true(0.8 < range.lo && range.hi < 1.25);
}

static void test_twice_the_work_shows(void **state)
{
    struct range range;
    double q = ratio(1000, 2000, &range);

    (void)state;
    assert_true(1.7 < q && q < 2.3);
    assert_true(range.lo > 1.5);
    assert_true(ratio(2000, 1000, &range) < 1 / 1.5);
}

/* What was run, in order. */
struct record {
    int passes, last_item;
    int *log, *logged, label; /* shared between tasks: whose pass came */
    bool in_order;
};

static void record_run(void *context, int first, int last)
{
    struct record *r = context;
    volatile double busy = 1;

    r->in_order = r->in_order && first == 0 && last == ITEMS;
    r->passes++;
    if (*r->logged < 4096)
        r->log[(*r->logged)++] = r->label;
    for (int k = 0; k < 200000; k++)
        busy = busy * 0.5 + 1;
}

static void record_order(uint64_t seed, int log[4096], int *logged, struct clock_samples samples[2])
{
    struct record record[2] = {{0, 0, log, logged, 0, true}, {0, 0, log, logged, 1, true}};
    struct clock_task task[2] = {{ITEMS, record_run, &record[0], false},
                                 {ITEMS, record_run, &record[1], false}};
    struct clock_plan plan = {ROUNDS, 0, 1, seed};

    *logged = 0;
    clock_interleave(2, task, &plan, samples);
    for (int k = 0; k < 2; k++)
        assert_true(record[k].in_order && record[k].passes > ROUNDS);
    for (int k = 0; k < 2; k++)
        clock_samples_clear(&samples[k]);
}

/* A task whose single pass is long enough gives one pass a sample; each round holds both tasks, in either
 * order, and the seed decides which. */
static void test_rounds_are_shuffled(void **state)
{
    static int log[4096], again[4096], other[4096];
    struct clock_samples samples[2];
    int logged, warm, first = 0;

    (void)state;
    record_order(1, log, &logged, samples);
    assert_int_equal(samples[0].passes, 1);
    warm = logged - 2 * ROUNDS;
    for (int r = 0; r < ROUNDS; r++) {
        assert_int_equal(log[warm + 2 * r] + log[warm + 2 * r + 1], 1);
        first += log[warm + 2 * r];
    }
    assert_true(ROUNDS / 5 < first && first < ROUNDS - ROUNDS / 5);
    record_order(1, again, &logged, samples);
    assert_memory_equal(log + warm, again + logged - 2 * ROUNDS, 2 * ROUNDS * sizeof *log);
    record_order(2, other, &logged, samples);
    assert_memory_not_equal(log + warm, other + logged - 2 * ROUNDS, 2 * ROUNDS * sizeof *log);
}

static void test_samples_are_long_enough(void **state)
{
    struct labour l;
    struct clock_task task = labour_task(&l, 20);

    (void)state;
    for (double wanted = 1e4; wanted < 1e7; wanted *= 10) {
        struct clock_plan plan = {9, 0, wanted, 1};
        struct clock_samples samples;

        clock_interleave(1, &task, &plan, &samples);
        /* A later sample may be faster than calibration was, but not much. */
        assert_true(statistics_median(samples.count, samples.ns) * ITEMS * samples.passes > wanted / 2);
        assert_true(samples.passes == 1 ||
                    statistics_min(samples.count, samples.ns) * ITEMS * samples.passes >
                        CLOCK_TICKS / 2 * clock_tick(false));
        clock_samples_clear(&samples);
    }
}

static void test_time_allowed_ends_the_rounds(void **state)
{
    struct labour l;
    struct clock_task task = labour_task(&l, 1000);
    struct clock_plan plan = {1000, 1e-6, 1e5, 1};
    struct clock_samples samples;

    (void)state;
    clock_interleave(1, &task, &plan, &samples);
    assert_int_equal(samples.count, CLOCK_ROUNDS_LEAST);
    clock_samples_clear(&samples);
}

static void test_slowest_item_is_found(void **state)
{
    struct labour l;
    struct clock_task task = labour_task(&l, 200);
    double ns[ITEMS], usual;

    (void)state;
    l.amount[17] = 2000;
    clock_each(&task, 7, ns);
    usual = statistics_median(ITEMS, ns);
    assert_true(usual > 0);
    assert_true(5 * usual < ns[17] && ns[17] < 20 * usual);
    for (int i = 0; i < ITEMS; i++)
        assert_true(i == 17 || ns[i] < ns[17]);
}

static void nap(void *context, int first, int last)
{
    struct timespec pause = {0, 2000000};

    (void)context;
    for (int i = first; i < last; i++)
        nanosleep(&pause, NULL);
}

/* Sleep is wall-clock time, and no CPU time. */
static void test_wall_time_counts_waiting(void **state)
{
    struct clock_task task = {1, nap, NULL, true};
    struct clock_plan plan = {3, 0, 1, 1};
    struct clock_samples samples;
    double start = clock_now(false);

    (void)state;
    clock_interleave(1, &task, &plan, &samples);
    assert_true(statistics_min(samples.count, samples.ns) >= 2e6);
    assert_true(clock_now(false) - start < 2e6 * samples.count);
    clock_samples_clear(&samples);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_clocks_advance),          cmocka_unit_test(test_same_work_same_time),
        cmocka_unit_test(test_twice_the_work_shows),    cmocka_unit_test(test_rounds_are_shuffled),
        cmocka_unit_test(test_samples_are_long_enough), cmocka_unit_test(test_time_allowed_ends_the_rounds),
        cmocka_unit_test(test_slowest_item_is_found),   cmocka_unit_test(test_wall_time_counts_waiting),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
