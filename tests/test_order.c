/* What the estimators make of sequences whose law is known. */
#include <math.h>

#include "../harness/cost_law.h"
#include "../harness/order_estimate.h"
#include "../harness/regression.h"
#include "prop.h"

enum { MOST = 4000 };

struct sequence {
    int n;
    double t[MOST], s[MOST];
};

static void start(struct sequence *q)
{
    q->n = 1;
    q->t[0] = q->s[0] = 0;
}

static void step(struct sequence *q, double t, double s)
{
    assert_true(q->n < MOST);
    q->t[q->n] = t;
    q->s[q->n++] = s;
}

static struct order_estimate order_of(const struct sequence *q, double floor)
{
    return order_of_widths(q->n, q->t, q->s, floor);
}

/* x' = C x^(k+1) + D y^2, the curves cut in turn, in bits. */
static void clip_in_turn(struct sequence *q, int k, double x, double y, double c, double d, double most)
{
    step(q, x, x / 2); /* however it came there */
    step(q, x, y);
    for (bool on_x = true; x < most || y < most; on_x = !on_x) {
        double own = (k + 1) * (on_x ? x : y) - c, other = 2 * (on_x ? y : x) - d;
        double left = fmin(own, other) - log2(1 + exp2(-fabs(own - other)));
        if (on_x)
            x = left;
        else
            y = left;
        step(q, x, y);
    }
}

static void test_recurrence_of_hybrid_clipping(void **state)
{
    static struct sequence q;
    struct random_state r;
    (void)state;
    r = random_for(11, "order", 0);
    for (int i = 0; i < 200; i++)
        for (int k = 1; k <= 6; k++) {
            double x = 3 + 2 * real_to_double(prop_unit(&r, 20)),
                   y = x * (1 + real_to_double(prop_unit(&r, 20)) / 2);
            double expected = k + 1 < 4 ? k + 1 : 4;
            start(&q);
            clip_in_turn(&q, k, x, y, 1, -1, 3000);
            struct order_estimate e = order_of(&q, 3000);
            if (e.law != SUPERLINEAR || !(fabs(e.per_round - expected) <= 0.03 * expected) || e.clips != 2)
                fail_msg("k %d from %g, %g: %s %g", k, x, y, law_name(e.law), e.per_round);
        }
}

static void test_any_order(void **state)
{
    static const double orders[] = {1.25, 4.0 / 3, 1.5, 5.0 / 3, 2, 2.5, 3, 4, 5, 6};
    static struct sequence q;
    (void)state;
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++)
        for (double constant = -1; constant <= 1; constant += 0.5) {
            start(&q);
            for (double x = 8; x < 4000; x = orders[i] * x + constant)
                step(&q, x, x - 0.3);
            struct order_estimate e = order_of(&q, 4000);
            assert_int_equal(e.law, SUPERLINEAR);
            assert_true(fabs(e.per_round - orders[i]) < 1e-9 && e.lo <= e.per_round && e.per_round <= e.hi);
            assert_true(isnan(e.bits_per_round) && e.clips == 1);
        }
}

/* However the gains are scattered, a linear method is not taken for more than 1.1. */
static void test_linear_with_noise(void **state)
{
    static struct sequence q;
    struct random_state r;
    (void)state;
    r = random_for(12, "order", 0);
    for (int i = 0; i < 2000; i++) {
        double t = 0, s = 0;
        start(&q);
        while (t < 400 || s < 400) {
            double gain = 2 * real_to_double(prop_unit(&r, 20));
            if (random_bits(&r) & 1)
                t += gain;
            else
                s += gain;
            step(&q, t, s);
        }
        struct order_estimate e = order_of(&q, 400);
        assert_int_equal(e.law, LINEAR);
        if (!(e.per_round < 1.1 && fabs(e.bits_per_round - 1) < 0.3))
            fail_msg("seed 12, sequence %d: %g, %g bits a round", i, e.per_round, e.bits_per_round);
    }
}

/* More and more clips a round, as at a cusp when the curve with the wider parameter is cut: linear. */
static void test_rounds_that_grow(void **state)
{
    static struct sequence q;
    double t = 0, s = 0;
    (void)state;
    start(&q);
    while (t < 900) {
        if (t >= s)
            s = 2 * t + 4;
        else
            t += 1.5;
        step(&q, t, s);
    }
    assert_int_equal(order_of(&q, 2000).law, LINEAR);
}

static void test_linear_then_quadratic(void **state)
{
    static struct sequence q;
    (void)state;
    start(&q);
    for (double x = 0.5; x < 50; x += 0.5)
        step(&q, x, x);
    for (double x = 50; x < 2000; x = 2 * x - 40)
        step(&q, x, x);
    struct order_estimate e = order_of(&q, 2000);
    assert_int_equal(e.law, SUPERLINEAR);
    assert_true(fabs(e.per_round - 2) < 1e-9);
}

static void test_too_few_exact_and_stalled(void **state)
{
    static struct sequence q;
    (void)state;
    assert_int_equal(order_of_widths(0, NULL, NULL, 100).law, TOO_FEW);
    start(&q);
    assert_int_equal(order_of(&q, 100).law, TOO_FEW);
    for (double x = 4; x < 40; x *= 2)
        step(&q, x, x);
    q.n = 4; /* 0, 4, 8, 16: the first ratio is of the start */
    assert_int_equal(order_of(&q, 100).law, TOO_FEW);
    start(&q);
    step(&q, 1900, 0);
    step(&q, 1900, 1900);
    assert_int_equal(order_of(&q, 1800).law, EXACT);
    start(&q);
    for (int i = 1; i < 60; i++)
        step(&q, 3 - 3 * exp2(-i), 3 - 3 * exp2(-i));
    assert_int_equal(order_of(&q, 100).law, STALLED);
}

/* What lies below the floor must not be seen. */
static void test_rounding_floor(void **state)
{
    static struct sequence q;
    (void)state;
    start(&q);
    for (double x = 2; x < 500; x *= 2)
        step(&q, x, x);
    int above = q.n;
    struct order_estimate e = order_of(&q, 400);
    step(&q, 410, 411);
    step(&q, 412, 412);
    struct order_estimate f = order_of(&q, 400);
    assert_true(e.law == SUPERLINEAR && f.law == SUPERLINEAR && e.per_round == f.per_round &&
                f.points == above);
}

static void test_boxes(void **state)
{
    double before[16], after[16];
    (void)state;
    for (double order = 1.25; order <= 6; order += 0.25) {
        for (int i = 0; i < 16; i++) {
            before[i] = 3 + i;
            after[i] = order * before[i] + 2 + exp2(-before[i]);
        }
        struct order_estimate e = order_of_boxes(16, before, after, 0);
        assert_int_equal(e.law, SUPERLINEAR);
        assert_true(fabs(e.per_round - order) < 0.01 && e.lo <= e.per_round && e.per_round <= e.hi);
    }
    for (int i = 0; i < 16; i++)
        after[i] = before[i] + 0.5;
    assert_int_equal(order_of_boxes(16, before, after, 0).law, LINEAR);
    assert_int_equal(order_of_boxes(16, before, before, 0).law, STALLED);
    assert_int_equal(order_of_boxes(3, before, after, 0).law, TOO_FEW);
    assert_int_equal(order_of_boxes(0, before, after, 16).law, EXACT);
    assert_int_equal(order_of_boxes(0, before, after, 3).law, TOO_FEW);
}

static void test_cost_laws(void **state)
{
    double bits[24], steps[24];
    (void)state;
    for (int i = 0; i < 24; i++)
        bits[i] = 4 + i;
    for (double p = 0.25; p <= 1; p += 0.125) {
        for (int i = 0; i < 24; i++)
            steps[i] = floor(20 * exp2(p * bits[i]));
        struct cost_law law = cost_law_fit(24, bits, steps);
        assert_int_equal(law.model, POWER);
        assert_true(fabs(law.p - p) < 0.01 && law.lo <= law.p && law.p <= law.hi);
    }
    for (double b = 0; b < 10; b += 2.5) {
        for (int i = 0; i < 24; i++)
            steps[i] = floor(5 + b * bits[i]);
        struct cost_law law = cost_law_fit(24, bits, steps);
        assert_int_equal(law.model, LOGARITHMIC);
        assert_true(fabs(law.b - b) < 0.1);
    }
    assert_int_equal(cost_law_fit(COST_POINTS_LEAST - 1, bits, steps).model, FEW);
}

/* The 95 percent interval of a slope holds it in about that part of all samples. */
static void test_interval_of_slope(void **state)
{
    enum { SAMPLES = 4000, POINTS = 6 };
    struct random_state r;
    int held = 0;
    (void)state;
    r = random_for(13, "order", 0);
    for (int i = 0; i < SAMPLES; i++) {
        double x[POINTS], y[POINTS];
        for (int j = 0; j < POINTS; j++) {
            double noise = 0; /* nearly normal */
            for (int k = 0; k < 12; k++)
                noise += real_to_double(prop_unit(&r, 30)) - 0.5;
            x[j] = j;
            y[j] = 3 * j + 7 + noise;
        }
        struct line_fit fit = line_fit(POINTS, x, y);
        held += fit.lo <= 3 && 3 <= fit.hi;
    }
    assert_in_range(held, SAMPLES * 0.935, SAMPLES * 0.965);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_recurrence_of_hybrid_clipping),
        cmocka_unit_test(test_any_order),
        cmocka_unit_test(test_linear_with_noise),
        cmocka_unit_test(test_rounds_that_grow),
        cmocka_unit_test(test_linear_then_quadratic),
        cmocka_unit_test(test_too_few_exact_and_stalled),
        cmocka_unit_test(test_rounding_floor),
        cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_cost_laws),
        cmocka_unit_test(test_interval_of_slope),
    };
    return cmocka_run_group_tests_name("order", tests, NULL, NULL);
}
