/* The orders of the algorithms on pairs made here, and the negative controls: ways of measuring, or of
 * clipping, that give another order, and which.  Watched build. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../harness/lemma_measure.h"
#include "../harness/problem.h"
#include "prop.h"

enum { POWERS = 6, LINE = 4096 };

/* Bernstein coefficients of degree n of sum a[j] (t - root)^j, as text. */
static void write_coefficients(int n, const mpq_t *a, const mpq_t root, char text[][64])
{
    mpq_t c[POWERS], q;
    mpq_init(q);
    for (int i = 0; i <= n; i++) {
        mpq_init(c[i]);
        mpq_set(c[i], a[i]);
    }
    for (int i = 0; i < n; i++) /* to powers of t, by Horner's scheme */
        for (int j = n - 1; j >= i; j--) {
            mpq_mul(q, c[j + 1], root);
            mpq_sub(c[j], c[j], q);
        }
    for (int i = 0; i <= n; i++) {
        mpq_t b, factor;
        mpq_inits(b, factor, NULL);
        for (int j = 0; j <= i; j++) { /* C(i,j) / C(n,j) a[j] */
            mpz_bin_uiui(mpq_numref(factor), (unsigned long)i, (unsigned long)j);
            mpz_bin_uiui(mpq_denref(factor), (unsigned long)n, (unsigned long)j);
            mpq_canonicalize(factor);
            mpq_mul(factor, factor, c[j]);
            mpq_add(b, b, factor);
        }
        gmp_snprintf(text[i], 64, "%Qd", b);
        mpq_clears(b, factor, NULL);
    }
    for (int i = 0; i <= n; i++)
        mpq_clear(c[i]);
    mpq_clear(q);
}

/* x and y as polynomials of degree n in t - root, in eighths. */
struct local_curve {
    int n;
    int x[POWERS], y[POWERS];
};

static int write_curve(const struct local_curve *c, const mpq_t root, char *text, size_t size)
{
    char coefficient[2][POWERS][64];
    for (int k = 0; k < 2; k++) {
        mpq_t a[POWERS];
        for (int j = 0; j < POWERS; j++) {
            mpq_init(a[j]);
            mpq_set_si(a[j], (k ? c->y : c->x)[j], 8);
            mpq_canonicalize(a[j]);
        }
        write_coefficients(c->n, a, root, coefficient[k]);
        for (int j = 0; j < POWERS; j++)
            mpq_clear(a[j]);
    }
    int used = snprintf(text, size, "{\"points\":[");
    for (int i = 0; i <= c->n; i++)
        used += snprintf(text + used, size - (size_t)used, "%s[\"%s\",\"%s\"]", i ? "," : "",
                         coefficient[0][i], coefficient[1][i]);
    return used + snprintf(text + used, size - (size_t)used, "]}");
}

/* A pair that meets at t = 3/8, s = 5/8, f(3/8) = g(5/8) = the origin. */
static void make_pair(const struct local_curve *f, const struct local_curve *g, int multiplicity,
                      struct test_case *c, struct known_solution *z)
{
    char line[LINE], error[512];
    struct known_solutions known;
    mpq_t t, s;
    mpq_inits(t, s, NULL);
    mpq_set_si(t, 3, 8);
    mpq_set_si(s, 5, 8);
    int used = snprintf(line, LINE, "{\"id\":\"pair\",\"f\":");
    used += write_curve(f, t, line + used, LINE - (size_t)used);
    used += snprintf(line + used, LINE - (size_t)used, ",\"g\":");
    used += write_curve(g, s, line + used, LINE - (size_t)used);
    snprintf(
        line + used, LINE - (size_t)used,
        ",\"expected\":{\"count\":1,\"params\":[[0.375,0.625]],\"exact\":[[\"3/8\",\"5/8\"]],\"mult\":[%d]}}",
        multiplicity);
    if (case_parse(line, "test", 1, c, error) != CASE_READ)
        fail_msg("%s", error);
    assert_null(known_solutions_make(c, 40, 10, &known));
    assert_int_equal(known.count, 1);
    *z = known.at[0];
    mpq_inits(z->t, z->s, NULL);
    mpq_set(z->t, t);
    mpq_set(z->s, s);
    known_solutions_clear(&known);
    mpq_clears(t, s, NULL);
}

static const struct local_curve f_plain = {4, {0, 8, 2, 2, 3}, {0, 1, 8, 5, 4}};
static const struct local_curve g_across = {4, {0, 1, 9, -4, 2}, {0, 8, 3, 2, 1}};
static const struct local_curve f_flat = {4, {0, 8, 1, 0, 1}, {0, 0, 8, 3, 2}};
static const struct local_curve g_touching = {4, {0, 9, 1, 1, 0}, {0, 0, 17, 2, 1}};

static struct order_bench bench;
static struct test_case crossing, tangency;
static struct known_solution at_crossing, at_tangency;

static int set_up(void **state)
{
    (void)state;
    order_bench_make(&bench, intersectors, 8);
    make_pair(&f_plain, &g_across, 1, &crossing, &at_crossing);
    make_pair(&f_flat, &g_touching, 2, &tangency, &at_tangency);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    order_bench_clear(&bench);
    case_clear(&crossing);
    case_clear(&tangency);
    mpq_clears(at_crossing.t, at_crossing.s, at_tangency.t, at_tangency.s, NULL);
    return 0;
}

static const struct {
    const char *name;
    int k;
    double order;
} fat_line_methods[] = {{"bezier_clipping", 1, 2},
                        {"hybrid_clipping_1", 1, 2},
                        {"hybrid_clipping_2", 2, 3},
                        {"hybrid_clipping_3", 3, 4}};
enum { METHODS = sizeof fat_line_methods / sizeof *fat_line_methods };

static const struct intersector *method(int i)
{
    const struct intersector *a = intersector_find(fat_line_methods[i].name);
    assert_non_null(a);
    return a;
}

/* Within 5 percent in double, 3 percent above it. */
static void assert_order(const char *name, double measured, double expected)
{
    double within = REAL_BITS > 53 ? 0.03 : 0.05;
    if (!(fabs(measured - expected) <= within * expected))
        fail_msg("%s: order %g, expected %g", name, measured, expected);
}

static void test_order_by_boxes(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct order_estimate e = order_by_boxes(&bench, &crossing, method(i), &at_crossing);
        assert_int_equal(e.law, SUPERLINEAR);
        assert_order(fat_line_methods[i].name, e.per_round, fat_line_methods[i].order);
    }
}

static void test_order_by_rounds(void **state)
{
    (void)state;
    struct owned_problem owned;
    assert_null(owned_problem_make(&crossing, (real)1 / 1024, 100000, &owned));
    for (int i = 0; i < METHODS; i++) {
        struct order_estimate e = order_by_rounds(&bench, &owned.problem, method(i), &at_crossing, REAL_BITS);
        if (REAL_BITS > 1000 || e.law == SUPERLINEAR) {
            assert_int_equal(e.law, SUPERLINEAR);
            assert_true(REAL_BITS < 1000 || fabs(e.per_round / fat_line_methods[i].order - 1) < 0.03);
        } else {
            assert_int_equal(e.law, TOO_FEW); /* which is an answer */
        }
    }
    owned_problem_clear(&owned);
}

/* Control: the first cut from a square shows order 2 for every k. */
static void test_first_cut_from_a_square(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        double before[8], after[8];
        for (int j = 0; j < 8; j++) {
            bool below;
            before[j] = 5 + j;
            after[j] =
                one_cut(&bench, &crossing, method(i), &at_crossing, before[j], before[j], false, &below);
            assert_false(below);
        }
        assert_order(fat_line_methods[i].name, line_fit(8, before, after).slope, 2);
    }
}

/* Control: both curves cut from the same boxes, as the paper's (4) is printed, is of order 2 for every k. */
static void test_jacobi(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++)
        assert_order(fat_line_methods[i].name,
                     jacobi_order(&bench, &crossing, method(i), &at_crossing).per_round, 2);
}

/* Control: k >= n is the curve itself, and the order is still 4. */
static void test_cap(void **state)
{
    static const struct local_curve f = {3, {0, 8, 2, 2}, {0, 1, 8, 5}}, g = {3, {0, 1, 9, -4}, {0, 8, 3, 2}};
    struct test_case c;
    struct known_solution z;
    (void)state;
    make_pair(&f, &g, 1, &c, &z);
    assert_order("cap", order_by_boxes(&bench, &c, intersector_find("hybrid_clipping_3"), &z).per_round, 4);
    assert_true(isnan(cut_law(&bench, &c, intersector_find("hybrid_clipping_3"), &z, false, true).exponent));
    case_clear(&c);
    mpq_clears(z.t, z.s, NULL);
}

/* Control: at a tangency an order above 1.1 of a fat-line method is an error of measurement. */
static void test_tangency_is_linear(void **state)
{
    struct owned_problem owned;
    (void)state;
    assert_null(owned_problem_make(&tangency, (real)1 / 1024, 100000, &owned));
    for (int i = 0; i < METHODS; i++) {
        struct order_estimate e = order_by_rounds(&bench, &owned.problem, method(i), &at_tangency, 300);
        struct order_estimate b = order_by_boxes(&bench, &tangency, method(i), &at_tangency);
        if (e.law == SUPERLINEAR || b.law == SUPERLINEAR || e.per_round > 1.1 || b.per_round > 1.1)
            fail_msg("%s: %s %g, %s %g", fat_line_methods[i].name, law_name(e.law), e.per_round,
                     law_name(b.law), b.per_round);
    }
    owned_problem_clear(&owned);
}

/* Proposition 3.5: exponents and constants of both terms, of f and of g. */
static void test_one_cut(void **state)
{
    (void)state;
    for (int i = 1; i < METHODS; i++)
        for (int of_g = 0; of_g < 2; of_g++) {
            const char *name = fat_line_methods[i].name;
            int k = fat_line_methods[i].k;
            struct power_law own = cut_law(&bench, &crossing, method(i), &at_crossing, of_g, true);
            struct power_law other = cut_law(&bench, &crossing, method(i), &at_crossing, of_g, false);
            struct cut_constants expected = cut_constants(&crossing, &at_crossing, of_g, k);
            assert_order(name, own.exponent, k + 1);
            assert_order(name, other.exponent, 2);
            assert_order(name, own.constant / expected.own_vector, 1);
            assert_order(name, other.constant / expected.other, 1);
        }
}

/* Lemmas 3.2 and 3.3. */
static void test_reduction(void **state)
{
    (void)state;
    for (int k = 1; k <= 3; k++)
        for (int j = -1; j <= k; j++) {
            struct power_law law = reduction_law(&crossing, &at_crossing, false, k, j);
            assert_order("reduction", law.exponent, k + 1 - (j > 0 ? j : 0));
            assert_order("reduction", law.constant / reduction_constant(&crossing, &at_crossing, false, k, j),
                         1);
        }
}

/* lambda_k(n), as computed by hand for the first few. */
static void test_legendre_norm(void **state)
{
    (void)state;
    static const double known[][3] = {{2, 2, 1.0 / 3},  {2, 3, 1.0 / 6},  {2, 8, 1.0 / 6},
                                      {3, 3, 3.0 / 20}, {3, 4, 1.0 / 10}, {3, 5, 7.0 / 100},
                                      {4, 4, 3.0 / 35}, {4, 8, 3.0 / 140}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        assert_true(fabs(legendre_norm((int)known[i][0], (int)known[i][1]) - known[i][2]) < 1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_order_by_boxes),
        cmocka_unit_test(test_order_by_rounds),
        cmocka_unit_test(test_first_cut_from_a_square),
        cmocka_unit_test(test_jacobi),
        cmocka_unit_test(test_cap),
        cmocka_unit_test(test_tangency_is_linear),
        cmocka_unit_test(test_one_cut),
        cmocka_unit_test(test_reduction),
        cmocka_unit_test(test_legendre_norm),
    };
    return cmocka_run_group_tests_name("convergence", tests, set_up, tear_down);
}
