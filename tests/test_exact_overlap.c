/* Shared arcs, folded lines and curves that are points, planted. */
#include <math.h>

#include "prop.h"

#include "../harness/truth/exact_roots.h"
#include "exact_curves.h"

static void test_overlaps(void **state)
{
    (void)state;
    static const struct {
        const char *f, *g;        /* inner functions */
        const char *const end[4]; /* of the shared arc */
    } table[] = {
        {"2  0 1", "2  0 1", {"0", "1", "0", "1"}},
        {"2  0 1", "2  1 -1", {"0", "1", "1", "0"}},
        {"2  0 1", "2  1/3 1/3", {"1/3", "2/3", "0", "1"}},
        {"2  0 2/3", "2  1/3 2/3", {"1/2", "1", "0", "1/2"}},
        {"2  0 1", "3  0 1/2 1/2", {"0", "1", "0", "1"}},
        {"2  3/8 1", "3  0 1/2 1/2", {"0", "5/8", "1/2", "1"}},
        {"2  1 -1", "4  0 1 -1 1", {"0", "1", "1", "0"}},
        {"3  0 1/2 1/2", "3  1 -2/3 -1/3", {"0", "1", "1", "0"}},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct plane_curve f, g;
        struct test_case c;
        plane_curve_set(&f, "4  0 3 -1 2", "4  1 -2 5 -3", NULL);
        plane_curve_set(&g, "4  0 3 -1 2", "4  1 -2 5 -3", NULL);
        plane_curve_compose(&f, &f, table[i].f);
        plane_curve_compose(&g, &g, table[i].g);
        solve(&c, &f, (int)i % 3, &g, (int)i % 2);
        assert_class(&c, "overlap", 0, 1);
        assert_overlap(&c, 0, table[i].end);
        case_clear(&c);
        plane_curve_clear(&f);
        plane_curve_clear(&g);
    }
}

static void test_folded_lines(void **state)
{
    (void)state;
    static const char fold[] = "3  0 4 -4"; /* 0 to 1 and back */
    struct test_case c;
    solve_texts(&c, (const char *const[]){fold, fold, NULL}, (const char *const[]){"2  0 1", "2  0 1", NULL});
    assert_class(&c, "overlap", 0, 2);
    assert_overlap(&c, 0, (const char *const[]){"0", "1/2", "0", "1"});
    assert_overlap(&c, 1, (const char *const[]){"1/2", "1", "1", "0"});
    case_clear(&c);
    solve_texts(&c, (const char *const[]){fold, fold, NULL}, (const char *const[]){fold, fold, NULL});
    assert_class(&c, "overlap", 0, 2);
    assert_overlap(&c, 0, (const char *const[]){"0", "1", "0", "1"});
    assert_overlap(&c, 1, (const char *const[]){"0", "1", "1", "0"});
    case_clear(&c);
    /* The tip of the fold touches the end of the other: one point, no arc. */
    solve_texts(&c, (const char *const[]){fold, fold, NULL}, (const char *const[]){"2  1 1", "2  1 1", NULL});
    assert_class(&c, "degenerate", 1, 0);
    assert_solution(&c, 0, "1/2", "0", 0);
    case_clear(&c);
    /* One carrier, nothing in common. */
    solve_texts(&c, (const char *const[]){fold, fold, NULL},
                (const char *const[]){"2  1000000000000000001/1000000000000000000 1",
                                      "2  1000000000000000001/1000000000000000000 1", NULL});
    assert_class(&c, "none", 0, 0);
    case_clear(&c);
}

/* A loop over itself: the arc, and the node as two pairs beside it. */
static void test_node_beside_overlap(void **state)
{
    (void)state;
    struct plane_curve f, g;
    struct test_case c;
    plane_curve_set(&f, "3  -1/4 0 1", "4  0 -1/4 0 1", NULL); /* (0, 0) at -1/2 and 1/2 */
    plane_curve_set(&g, "3  -1/4 0 1", "4  0 -1/4 0 1", NULL);
    plane_curve_compose(&f, &f, "2  -1 2");
    plane_curve_compose(&g, &g, "2  1 -2");
    solve(&c, &f, 0, &g, 0);
    assert_class(&c, "overlap", 2, 1);
    assert_solution(&c, 0, "1/4", "1/4", 1);
    assert_solution(&c, 1, "3/4", "3/4", 1);
    const json_t *places = json_object_get(json_object_get(c.line, "expected"), "distinct_points");
    assert_int_equal(json_integer_value(places), 1);
    assert_overlap(&c, 0, (const char *const[]){"0", "1", "1", "0"});
    case_clear(&c);
    plane_curve_clear(&f);
    plane_curve_clear(&g);
}

static void test_points(void **state)
{
    (void)state;
    struct test_case c;
    solve_texts(&c, (const char *const[]){"1  1/2", "1  1/4", NULL},
                (const char *const[]){"2  0 1", "3  0 0 1", NULL});
    assert_class(&c, "degenerate", 0, 1);
    assert_overlap(&c, 0, (const char *const[]){"0", "1", "1/2", "1/2"});
    case_clear(&c);
    solve_texts(&c, (const char *const[]){"2  0 1", "3  0 0 1", NULL},
                (const char *const[]){"1  1/2", "1  1/3", NULL});
    assert_class(&c, "degenerate", 0, 0);
    case_clear(&c);
}

/* The number of s in [0, 1] with x(s) = c. */
static int solutions_of(const fmpq_poly_t x, const fmpq_t c)
{
    fmpq_poly_t p;
    fmpz_poly_t q;
    struct root_list l;
    fmpq_poly_init(p);
    fmpz_poly_init(q);
    fmpq_poly_sub_fmpq(p, x, c);
    fmpq_poly_get_numerator(q, p);
    root_list_find(&l, q);
    int count = l.count;
    root_list_clear(&l);
    fmpq_poly_clear(p);
    fmpz_poly_clear(q);
    return count;
}

/* Two curves of degree up to 5 on one line, folding as they like: through every sampled t go as many arcs as
 * there are s with g(s) = f(t). */
static void test_arcs_through_samples(void **state)
{
    (void)state;
    int several = 0;
    for (int i = 0; i < 150; i++) {
        struct random_state r = random_for(4, "line", (uint64_t)i);
        struct plane_curve f, g;
        struct test_case c;
        fmpq_t t, x;
        fmpq_init(t);
        fmpq_init(x);
        plane_curve_init(&f);
        plane_curve_init(&g);
        for (int k = 0; k <= 5; k++) {
            fmpq_poly_set_coeff_si(f.x, k, random_between(&r, -9, 9) * (k < 2 + i % 4));
            fmpq_poly_set_coeff_si(g.x, k, random_between(&r, -9, 9) * (k < 2 + i % 5));
        }
        fmpq_poly_set_coeff_si(f.x, 1, 10);
        fmpq_poly_set_coeff_si(g.x, 1, -10);
        fmpq_poly_scalar_mul_si(f.y, f.x, 3);
        fmpq_poly_scalar_mul_si(g.y, g.x, 3);
        solve(&c, &f, 0, &g, 0);
        for (int k = 0; k < 50; k++) {
            fmpq_set_si(t, 2 * k + 1, 101); /* where no arc ends */
            fmpq_poly_evaluate_fmpq(x, f.x, t);
            int through = 0;
            for (int j = 0; j < c.expected.overlaps; j++) {
                const struct case_overlap *o = &c.expected.overlap[j];
                through += mpq_get_d(o->t0) < (2 * k + 1) / 101.0 && (2 * k + 1) / 101.0 < mpq_get_d(o->t1);
            }
            assert_int_equal(through, solutions_of(g.x, x));
            several += through > 1;
        }
        case_clear(&c);
        plane_curve_clear(&f);
        plane_curve_clear(&g);
        fmpq_clear(t);
        fmpq_clear(x);
    }
    assert_true(several > 100);
}

/* Random coefficients of 50 bits, from 1 down to 2^-800. */
static void random_line(struct random_state *r, struct plane_curve *f, int degree)
{
    fmpq_t c;
    fmpq_init(c);
    plane_curve_init(f);
    for (int k = 0; k <= degree; k++) {
        fmpq_set_si(c, (slong)random_between(r, 1, 1L << 50) * (random_between(r, 0, 1) ? 1 : -1), 1);
        fmpq_div_2exp(c, c, 50 + (random_between(r, 0, 3) ? 0 : (ulong)random_between(r, 0, 800)));
        fmpq_poly_set_coeff_fmpq(f->x, k, c);
    }
    fmpq_poly_scalar_mul_si(f->y, f->x, -2);
    fmpq_clear(c);
}

/* |f(t) - g(s)|, and whether f or g turns there. */
static void distance(const struct plane_curve *f, const struct plane_curve *g, mpq_srcptr at, mpq_srcptr as,
                     double *error, bool *turns)
{
    fmpq_poly_t slope;
    fmpq_t t, s, x, y;
    fmpq_poly_init(slope);
    fmpq_init(t), fmpq_init(s), fmpq_init(x), fmpq_init(y);
    fmpq_set_mpq(t, at);
    fmpq_set_mpq(s, as);
    fmpq_poly_evaluate_fmpq(x, f->x, t);
    fmpq_poly_evaluate_fmpq(y, g->x, s);
    fmpq_sub(x, x, y);
    *error = fabs(fmpq_get_d(x));
    *turns = false;
    for (int side = 0; side < 2; side++) {
        fmpq_poly_derivative(slope, side ? g->x : f->x);
        fmpq_poly_evaluate_fmpq(y, slope, side ? s : t);
        *turns = *turns || fabs(fmpq_get_d(y)) < 1e-70;
    }
    fmpq_poly_clear(slope);
    fmpq_clear(t), fmpq_clear(s), fmpq_clear(x), fmpq_clear(y);
}

static bool is_a_domain_end(mpq_srcptr t)
{
    return mpq_sgn(t) == 0 || mpq_cmp_ui(t, 1, 1) == 0;
}

/* The ends of arcs on one line have as many digits as are asked for, however small they are: there both
 * curves are at one place, and one of them ends or turns. */
static void test_ends_to_many_digits(void **state)
{
    (void)state;
    int ends = 0, turning = 0;
    for (int i = 0; i < 60; i++) {
        struct random_state r = random_for(6, "ends", (uint64_t)i);
        const struct exact_limits limits = {i % 3 ? 80 : 300, 60};
        struct plane_curve f, g;
        struct test_case c;
        random_line(&r, &f, (int)random_between(&r, 1, 4));
        random_line(&r, &g, (int)random_between(&r, 1, 4));
        assert_true(make_case(&c, &f, 0, &g, 0, ""));
        const char *trouble = exact_solve(&c, &limits);
        if (trouble)
            fail_msg("line %d: %s", i, trouble);
        for (int j = 0; j < 2 * c.expected.overlaps; j++, ends++) {
            const struct case_overlap *o = &c.expected.overlap[j / 2];
            mpq_srcptr t = j % 2 ? o->t1 : o->t0, s = j % 2 ? o->s1 : o->s0;
            double error;
            bool turns;
            distance(&f, &g, t, s, &error, &turns);
            assert_true(error < pow(10, 3 - limits.digits)); /* slopes are below 16 */
            assert_true(is_a_domain_end(t) || is_a_domain_end(s) || turns);
            turning += !is_a_domain_end(t) && !is_a_domain_end(s);
        }
        case_clear(&c);
        plane_curve_clear(&f);
        plane_curve_clear(&g);
    }
    assert_true(ends > 50 && turning > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_overlaps),
        cmocka_unit_test(test_folded_lines),
        cmocka_unit_test(test_node_beside_overlap),
        cmocka_unit_test(test_points),
        cmocka_unit_test(test_arcs_through_samples),
        cmocka_unit_test(test_ends_to_many_digits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
