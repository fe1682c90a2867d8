/* Fat curve against fat curve: planted zeros are never lost, what is called one zero is one, and the order.
 */
#include <math.h>

#include "arcs_cut.h"
#include "nasty.h"
#include "solving.h"

#include "../algorithms/core/bernstein.h"
#include "../algorithms/core/krawczyk.h"
#include "../algorithms/core/pair.h"

enum { PAIR_DEGREE_MAX = 3, MEMORY = 2 * (DEGREE_MAX + 1) * (PAIR_DEGREE_MAX + 1) };

/* An arc with its reductions. */
struct reduced {
    struct cut cut;
    struct reduction reduction[PAIR_DEGREE_MAX];
    real memory[PAIR_DEGREE_MAX][MEMORY];
};

static void reduced_init(struct reduced *c, const struct curve *of, real lo, real hi, real scale)
{
    cut_init(&c->cut, of, lo, hi, scale);
    for (int d = 1; d <= PAIR_DEGREE_MAX; d++)
        reduction_init(&c->reduction[d - 1], of->degree, d, c->memory[d - 1]);
}

static struct reduced a, b;
static struct planted pair;

static enum pair_outcome clip(int k, real scale, struct pair_box *box)
{
    return pair_clip(&a.cut.arc, &b.cut.arc, scale, a.reduction, b.reduction, k, box);
}

/* The planted zero is in the box; where the box is said to hold one, Krawczyk's test does not deny it. */
static void test_planted(void **state)
{
    (void)state;
    int boxed = 0, proved = 0, inside = 0, cases = trials(12000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, "pair", (uint64_t)i);
        int rational = i % 4 > 1 ? i % 4 - 1 : 0, k = 1 + i % 3;
        int e = (int)random_between(&r, 1, REAL_BITS < 60 ? 20 : 40), apart = (int)random_between(&r, 0, 2);
        real t, s;
        struct pair_box box;
        planted_make(&pair, &r, nasty_degree(&r, 8), nasty_degree(&r, 8), rational);
        real lo = around(&r, pair.t, e, &t), lo_s = around(&r, pair.s, e + apart, &s);
        reduced_init(&a, &pair.f.curve, lo, lo + real_ldexp(1, -e), 8);
        reduced_init(&b, &pair.g.curve, lo_s, lo_s + real_ldexp(1, -e - apart), 8);
        enum pair_outcome outcome = clip(k, 8, &box);
        if (outcome == NOWHERE_MET)
            fail_msg("case %d, degree %d: a zero is denied", i, k);
        if (outcome == NO_STEP)
            continue;
        boxed++;
        if (t < box.t.lo || t > box.t.hi || s < box.s.lo || s > box.s.hi)
            fail_msg("case %d, degree %d: the zero is not in the box", i, k);
        inside += t > 0 && t < 1 && s > 0 && s < 1;
        proved += box.holds_one;
        if (box.holds_one && krawczyk_narrow(&a.cut.arc, &b.cut.arc, &box.t, &box.s) == NO_ZERO)
            fail_msg("case %d, degree %d: Krawczyk's test finds no zero where one is proved", i, k);
    }
    assert_true(boxed > cases / 2);
    assert_true(2 * proved > inside);
}

/* The line y = 0 and the parabola (t - p)(t - q) around both: never one zero.  Around one of them: one. */
static void test_two_zeros(void **state)
{
    (void)state;
    int proved = 0, cases = trials(3000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, "two", (uint64_t)i);
        real p = (1 + prop_unit(&r, 10)) / 4, gap = real_ldexp(1, -(int)random_between(&r, 3, 20)),
             q = p + gap;
        struct prop_curve f, g;
        struct pair_box box;
        prop_curve_make(&f, &r, 2, 10, false);
        prop_curve_make(&g, &r, 1, 10, false);
        for (int j = 0; j < 3; j++)
            f.x[j] = (real)j / 2;
        f.y[0] = p * q;
        f.y[1] = p * q - (p + q) / 2;
        f.y[2] = (1 - p) * (1 - q);
        g.x[0] = g.y[0] = g.y[1] = 0;
        g.x[1] = 1;
        reduced_init(&b, &g.curve, 0, 1, 2);
        reduced_init(&a, &f.curve, p - gap / 4, q + gap / 4, 2);
        for (int k = 1; k <= 3; k++)
            if (clip(k, 2, &box) == BOXED && box.holds_one)
                fail_msg("case %d, degree %d: two zeros called one", i, k);
        reduced_init(&a, &f.curve, p - gap / 4, p + gap / 4, 2);
        reduced_init(&b, &g.curve, p - gap / 4, p + gap / 4, 2);
        proved += clip(1 + i % 3, 2, &box) == BOXED && box.holds_one;
    }
    assert_true(proved == cases);
}

/* Curves farther apart than their length: nothing is ever called a zero. */
static void test_no_zero(void **state)
{
    (void)state;
    for (int i = 0; i < trials(3000); i++) {
        struct random_state r = random_for(1, "none", (uint64_t)i);
        struct prop_curve f, g;
        struct pair_box box;
        bool rational = i % 2;
        prop_curve_make(&f, &r, nasty_degree(&r, 8), 20, rational);
        prop_curve_make(&g, &r, nasty_degree(&r, 8), 20, false);
        real t = prop_unit(&r, 6) / 2, s = prop_unit(&r, 6) / 2,
             h = real_ldexp(1, -(int)random_between(&r, 1, 20));
        reduced_init(&a, &f.curve, t, t + h, 2);
        reduced_init(&b, &g.curve, s, s + h, 2);
        real away = 64 * h; /* both curves have slopes below 64 */
        real move = a.cut.arc.x[0] / (a.cut.arc.w ? a.cut.arc.w[0] : (real)1) - b.cut.arc.x[0] + 4 * away;
        for (int j = 0; j <= g.curve.degree; j++)
            g.x[j] = g.x[j] + move;
        reduced_init(&b, &g.curve, s, s + h, 512);
        if (clip(1 + i % 3, 512, &box) == BOXED && box.holds_one)
            fail_msg("case %d: a zero where there is none", i);
    }
}

/* ---- order ---- */

static double log2_of(real x)
{
    int e = real_exponent(x);
    return e + log2(real_to_double(real_ldexp(x, -e)));
}

static double step_width(int k, int j)
{
    struct pair_box box;
    real h = real_ldexp(1, -j);
    reduced_init(&a, &pair.f.curve, pair.t - h * 5 / 16, pair.t + h * 11 / 16, 8);
    reduced_init(&b, &pair.g.curve, pair.s - h * 9 / 16, pair.s + h * 7 / 16, 8);
    if (clip(k, 8, &box) != BOXED)
        return 0;
    return log2_of(real_max(box.t.hi - box.t.lo, box.s.hi - box.s.lo) * h);
}

/* Curves of degree 5 and 6 that cross, polynomial and rational: h^(k+1) is left of h, seen between short arcs
 * and rounding. */
static void test_order(void **state)
{
    (void)state;
    int measured = 0;
    const double allowed = REAL_BITS > 1000 ? 0.03 : REAL_BITS > 53 ? 0.08 : 0.25;
    for (int i = 0; i < 8; i++)
        for (int k = 1; k <= 3; k++) {
            struct random_state r = random_for(1, "order", (uint64_t)i);
            int last = (REAL_BITS - 10) / (k + 1), first;
            last = last < 150 ? last : 150;
            first = last - (last + 1) / 3;
            do
                planted_make(&pair, &r, 5, 6, i % 2);
            while (!(pair.t > 0 && pair.t < 1 && pair.s > 0 && pair.s < 1));
            double wide = step_width(k, first), narrow = step_width(k, last);
            if (wide == 0 || narrow == 0)
                continue;
            double order = (wide - narrow) / (last - first);
            measured++;
            if (!(fabs(order - (k + 1)) <= allowed * (k + 1)))
                fail_msg("pair %d, degree %d: order %.3f", i, k, order);
        }
    assert_true(measured > 12);
}

/* As an algorithm: the crossings of random curves come back as records proved unique. */
static void test_unique_records(void **state)
{
    (void)state;
    static struct solver solver;
    int unique = 0, records = 0;
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(1, "unique", (uint64_t)i);
        struct prop_curve f, g;
        prop_curve_make(&f, &r, 3, 40, i % 3 == 1);
        prop_curve_make(&g, &r, 3, 40, i % 3 == 2);
        solver_init(&solver, intersector_find("pair_clipping_2"), 3, 3, WORKSPACE_ROOM);
        struct problem p = problem_of(&f.curve, &g.curve, real_ldexp(1, -30), 2000);
        assert_int_equal(solver_run(&solver, &p), SOLVED);
        records += solver.answer.crossings.count;
        for (int j = 0; j < solver.answer.crossings.count; j++)
            unique += solver.answer.crossings.at[j].standing == UNIQUE;
        solver_clear(&solver);
    }
    print_message("%d of %d records proved\n", unique, records);
    assert_true(records > 0 && 100 * unique >= 99 * records);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_planted), cmocka_unit_test(test_two_zeros),
                                       cmocka_unit_test(test_no_zero), cmocka_unit_test(test_order),
                                       cmocka_unit_test(test_unique_records)};
    return cmocka_run_group_tests_name("pair", tests, NULL, NULL);
}
