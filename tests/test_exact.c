/* The exact truth against planted answers. */
#include "prop.h"

#include <math.h>

#include "exact_curves.h"

static void random_polynomial(fmpq_poly_t p, struct random_state *r, int degree)
{
    for (int k = 0; k <= degree; k++)
        fmpq_poly_set_coeff_si(p, k, random_between(r, -9, 9));
    if (fmpq_poly_degree(p) < degree)
        fmpq_poly_set_coeff_si(p, degree, 1);
}

/* f = (t, y(t)), g = (X, y(X) + c (s - s0)^k) with X = s - s0 + t0: they meet once, with contact k. */
static void plant_contact(struct plane_curve *f, struct plane_curve *g, struct random_state *r, int degree,
                          int k, const fmpq_t t0, const fmpq_t s0)
{
    fmpq_poly_t u;
    fmpq_t a;
    fmpq_poly_init(u);
    fmpq_init(a);
    plane_curve_init(f);
    plane_curve_init(g);
    fmpq_poly_set_coeff_si(f->x, 1, 1);
    random_polynomial(f->y, r, degree);
    fmpq_sub(a, t0, s0);
    fmpq_poly_set_coeff_fmpq(g->x, 0, a);
    fmpq_poly_set_coeff_si(g->x, 1, 1);
    fmpq_poly_compose(g->y, f->y, g->x);
    fmpq_neg(a, s0);
    fmpq_poly_set_coeff_fmpq(u, 0, a);
    fmpq_poly_set_coeff_si(u, 1, 1);
    fmpq_poly_pow(u, u, (ulong)k);
    fmpq_poly_scalar_mul_si(u, u, 1 + random_between(r, 0, 5));
    fmpq_poly_add(g->y, g->y, u);
    plane_curve_map(f);
    plane_curve_map(g);
    fmpq_poly_clear(u);
    fmpq_clear(a);
}

static void test_planted_contacts(void **state)
{
    (void)state;
    for (int i = 0; i < 60; i++) {
        struct random_state r = random_for(1, "contact", (uint64_t)i);
        struct plane_curve f, g;
        struct test_case c;
        fmpq_t t0, s0;
        int k = 1 + i % 6, degree = 2 + i % 3;
        fmpq_init(t0);
        fmpq_init(s0);
        fmpq_set_si(t0, random_between(&r, 0, 21), 21); /* an end now and then */
        fmpq_set_si(s0, random_between(&r, 1, 99), 100);
        plant_contact(&f, &g, &r, degree, k, t0, s0);
        solve(&c, &f, i % 2, &g, i % 3);
        char *t = fmpq_get_str(NULL, 10, t0), *s = fmpq_get_str(NULL, 10, s0);
        bool end = fmpq_is_zero(t0) || fmpq_is_one(t0);
        assert_class(&c, k > 1 ? "tangent" : end ? "endpoint" : "transversal", 1, 0);
        assert_solution(&c, 0, t, s, k);
        assert_true(k > 1 ? c.expected.at[0].sine == 0 : fabs(c.expected.at[0].sine) > 0);
        case_clear(&c);
        flint_free(t);
        flint_free(s);
        plane_curve_clear(&f);
        plane_curve_clear(&g);
        fmpq_clear(t0);
        fmpq_clear(s0);
    }
}

/* |q^2 - num / den| < 10^-39 and the nearest double in `params`. */
static void assert_square_root(const mpq_t q, int num, int den)
{
    mpq_t d, e;
    mpq_inits(d, e, NULL);
    mpq_mul(d, q, q);
    mpq_set_si(e, num, (unsigned long)den);
    mpq_sub(d, d, e);
    mpq_abs(d, d);
    mpq_set_d(e, 1e-39);
    assert_true(mpq_cmp(d, e) < 0);
    mpq_clears(d, e, NULL);
}

static void test_irrational_contact(void **state)
{
    (void)state;
    struct test_case c;
    /* y = (t^2 - 1/2)^2 touches the axis; f is a graph, g runs by s -> s^2 + s - 3/4 along the axis. */
    solve_texts(&c, (const char *const[]){"2  0 1", "5  1/4 0 -1 0 1", NULL},
                (const char *const[]){"3  -3/4 1 1", "0", NULL});
    assert_class(&c, "tangent", 1, 0);
    assert_int_equal(c.expected.at[0].multiplicity, 2);
    assert_false(c.expected.at[0].exact);
    assert_square_root(c.expected.at[0].t, 1, 2);
    assert_true(c.expected.at[0].sine == 0);
    case_clear(&c);
}

static void test_irrational_cusps(void **state)
{
    (void)state;
    struct test_case c;
    /* (u^2, u^3) and (v^3, v^2) with u = t^2 - 1/2, v = s^2 - 1/3: the cusps lie on each other. */
    solve_texts(&c, (const char *const[]){"5  1/4 0 -1 0 1", "7  -1/8 0 3/4 0 -3/2 0 1", NULL},
                (const char *const[]){"7  -1/27 0 1/3 0 -1 0 1", "5  1/9 0 -2/3 0 1", NULL});
    assert_class(&c, "degenerate", 1, 0);
    assert_int_equal(c.expected.at[0].multiplicity, 4);
    assert_square_root(c.expected.at[0].t, 1, 2);
    assert_square_root(c.expected.at[0].s, 1, 3);
    assert_true(isnan(c.expected.at[0].sine));
    case_clear(&c);
}

/* Two nodes at one point with irrational parameters: four pairs, two of them of multiplicity 2; and one more.
 */
static void test_nodes_on_nodes(void **state)
{
    (void)state;
    struct test_case c;
    /* With u = 4 t - 2: f = (u^2 - 2, u (u^2 - 2)) passes (0, 0) at u = +-sqrt 2 with slopes +-sqrt 2;
     * g = (v^2 - 2, v (v^2 - 2) + (v^2 - 2)^2) does so with the same tangents. */
    struct plane_curve f, g;
    plane_curve_set(&f, "3  -2 0 1", "4  0 -2 0 1", NULL);
    plane_curve_set(&g, "3  -2 0 1", "5  4 -2 -4 1 1", NULL);
    plane_curve_compose(&f, &f, "2  -2 4");
    plane_curve_compose(&g, &g, "2  -2 4");
    solve(&c, &f, 0, &g, 0);
    int sum = 0;
    for (int i = 0; i < c.expected.count; i++)
        sum += c.expected.at[i].multiplicity;
    assert_string_equal(c.class_name, "tangent");
    assert_int_equal(c.expected.count, 5);
    assert_int_equal(sum, 7);
    assert_int_equal(
        json_integer_value(json_object_get(json_object_get(c.line, "expected"), "distinct_points")), 2);
    case_clear(&c);
    plane_curve_clear(&f);
    plane_curve_clear(&g);
}

static void test_ends_are_decided(void **state)
{
    (void)state;
    static const char *const place[] = {"1  -1/1000000000000000000", "0", "1  1/1000000000000000000"};
    static const char *const name[] = {"none", "endpoint", "transversal"};
    for (int i = 0; i < 3; i++) {
        struct test_case c;
        solve_texts(&c, (const char *const[]){"2  0 1", "3  0 0 1", NULL},
                    (const char *const[]){place[i], "2  -1/3 1", NULL});
        assert_class(&c, name[i], i > 0, 0);
        case_clear(&c);
    }
}

static void test_circles(void **state)
{
    (void)state;
    /* The quarter circle (1 - t^2, 2 t) / (1 + t^2). */
    static const char *const quarter[3] = {"3  1 0 -1", "2  0 2", "3  1 0 1"};
    struct test_case c;
    solve_texts(&c, quarter, (const char *const[]){"2  0 8/5", "2  0 6/5", NULL}); /* through (4/5, 3/5) */
    assert_class(&c, "transversal", 1, 0);
    assert_solution(&c, 0, "1/3", "1/2", 1);
    assert_true(fabs(fabs(c.expected.at[0].sine) - 1) < 1e-6);
    case_clear(&c);
    /* About (1, 1): (1 - 2 s / (1 + s^2), 1 - (1 - s^2) / (1 + s^2)), both ends in common. */
    solve_texts(&c, quarter, (const char *const[]){"3  1 -2 1", "3  0 0 2", "3  1 0 1"});
    assert_class(&c, "endpoint", 2, 0);
    assert_solution(&c, 0, "0", "0", 1);
    assert_solution(&c, 1, "1", "1", 1);
    case_clear(&c);
    /* About (2, 0), from (1, 0): touches at both starts. */
    solve_texts(&c, quarter, (const char *const[]){"3  1 0 3", "2  0 2", "3  1 0 1"});
    assert_class(&c, "tangent", 1, 0);
    assert_solution(&c, 0, "0", "0", 2);
    case_clear(&c);
    /* The same circle run backwards by another rational parameter: s -> 1 - 2 s / (1 + s). */
    solve_texts(&c, quarter, (const char *const[]){"2  0 4", "3  2 0 -2", "3  2 0 2"});
    assert_class(&c, "overlap", 0, 1);
    assert_overlap(&c, 0, (const char *const[]){"0", "1", "1", "0"});
    case_clear(&c);
}

static void test_domains(void **state)
{
    (void)state;
    static const char line[] =
        "{\"id\":\"a\",\"f\":{\"points\":[[\"0\",\"0\"],[\"1\",\"1\"]],\"domain\":[\"1/3\",\"3\"]},"
        "\"g\":{\"points\":[[\"0\",\"1\"],[\"2\",\"0\"]],\"domain\":[-1,0]}}";
    struct test_case c;
    char error[512];
    assert_int_equal(case_parse(line, "test", 1, &c, error), CASE_READ);
    assert_null(exact_solve(&c, &exact_test_limits));
    assert_class(&c, "transversal", 1, 0);
    assert_solution(&c, 0, "19/9", "-2/3", 1); /* at (2/3, 2/3) */
    case_clear(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_planted_contacts), cmocka_unit_test(test_irrational_contact),
        cmocka_unit_test(test_irrational_cusps), cmocka_unit_test(test_nodes_on_nodes),
        cmocka_unit_test(test_ends_are_decided), cmocka_unit_test(test_circles),
        cmocka_unit_test(test_domains),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
