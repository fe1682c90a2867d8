/* The exact truth under exchange, reversal, elevation and affine maps. */
#include "prop.h"

#include <math.h>

#include "exact_curves.h"

/* sum of b C(n, i) t^i (1 - t)^(n - i), b random in lo..hi. */
static void small_polynomial(fmpq_poly_t p, struct random_state *r, int n, int lo, int hi)
{
    fmpq_poly_t term, factor;
    fmpz_t c;
    fmpq_poly_init(term);
    fmpq_poly_init(factor);
    fmpz_init(c);
    fmpq_poly_zero(p);
    for (int i = 0; i <= n; i++) {
        fmpq_poly_set_str(factor, "2  1 -1");
        fmpq_poly_pow(factor, factor, (ulong)(n - i));
        fmpq_poly_shift_left(term, factor, i);
        fmpz_bin_uiui(c, (ulong)n, (ulong)i);
        fmpz_mul_si(c, c, random_between(r, lo, hi));
        fmpq_poly_scalar_mul_fmpz(term, term, c);
        fmpq_poly_add(p, p, term);
    }
    fmpq_poly_clear(term);
    fmpq_poly_clear(factor);
    fmpz_clear(c);
}

static void small_curve(struct plane_curve *c, struct random_state *r)
{
    int n = (int)random_between(r, 1, 4), size = (int)random_between(r, 1, 3);
    plane_curve_init(c);
    small_polynomial(c->x, r, n, 0, size);
    small_polynomial(c->y, r, n, 0, size);
    if (random_between(r, 0, 3) == 0)
        small_polynomial(c->w, r, 1, 1, 3); /* linear: positive weights at every degree */
}

enum transform { SWAPPED, REVERSED, ELEVATED, MAPPED, TRANSFORMS };

static void solve_transformed(struct test_case *c, struct plane_curve *f, struct plane_curve *g,
                              enum transform how)
{
    struct plane_curve u;
    plane_curve_init(&u);
    switch (how) {
    case SWAPPED:
        solve(c, g, 0, f, 0);
        break;
    case REVERSED:
        plane_curve_compose(&u, f, "2  1 -1");
        solve(c, &u, 0, g, 0);
        break;
    case ELEVATED:
        solve(c, f, 2, g, 1);
        break;
    default:
        plane_curve_map(f);
        plane_curve_map(g);
        solve(c, f, 0, g, 0);
    }
    plane_curve_clear(&u);
}

static bool holds(const struct test_case *c, double t, double s, int multiplicity)
{
    for (int i = 0; i < c->expected.count; i++)
        if (fabs(mpq_get_d(c->expected.at[i].t) - t) < 1e-14 &&
            fabs(mpq_get_d(c->expected.at[i].s) - s) < 1e-14 &&
            c->expected.at[i].multiplicity == multiplicity)
            return true;
    return false;
}

static bool holds_arc(const struct test_case *c, double t0, double t1, double s0, double s1)
{
    for (int i = 0; i < c->expected.overlaps; i++) {
        const struct case_overlap *o = &c->expected.overlap[i];
        const double end[4] = {mpq_get_d(o->t0), mpq_get_d(o->t1), mpq_get_d(o->s0), mpq_get_d(o->s1)};
        bool forth = fabs(end[0] - t0) + fabs(end[1] - t1) + fabs(end[2] - s0) + fabs(end[3] - s1) < 1e-14;
        bool back = fabs(end[0] - t1) + fabs(end[1] - t0) + fabs(end[2] - s1) + fabs(end[3] - s0) < 1e-14;
        if (forth || back)
            return true;
    }
    return false;
}

/* Two equal points: the arc has no direction. */
static bool are_points(const struct test_case *c)
{
    const struct case_overlap *o = &c->expected.overlap[0];
    return !strcmp(c->class_name, "degenerate") && mpq_cmp(o->t0, o->t1) != 0 && mpq_cmp(o->s0, o->s1) != 0;
}

static void assert_same(const struct test_case *a, const struct test_case *b, enum transform how)
{
    assert_string_equal(a->class_name, b->class_name);
    assert_int_equal(a->expected.count, b->expected.count);
    assert_int_equal(a->expected.overlaps, b->expected.overlaps);
    for (int i = 0; i < a->expected.count; i++) {
        const struct case_solution *p = &a->expected.at[i];
        double t = mpq_get_d(p->t), s = mpq_get_d(p->s);
        assert_true(how == SWAPPED    ? holds(b, s, t, p->multiplicity)
                    : how == REVERSED ? holds(b, 1 - t, s, p->multiplicity)
                                      : holds(b, t, s, p->multiplicity));
    }
    for (int i = 0; i < a->expected.overlaps && !are_points(a); i++) {
        const struct case_overlap *o = &a->expected.overlap[i];
        double t0 = mpq_get_d(o->t0), t1 = mpq_get_d(o->t1), s0 = mpq_get_d(o->s0), s1 = mpq_get_d(o->s1);
        assert_true(how == SWAPPED    ? holds_arc(b, s0, s1, t0, t1)
                    : how == REVERSED ? holds_arc(b, 1 - t0, 1 - t1, s0, s1)
                                      : holds_arc(b, t0, t1, s0, s1));
    }
}

/* Small integers, so that contacts, nodes, cusps, shared ends and shared arcs abound. */
static void test_invariance(void **state)
{
    (void)state;
    int common = 0, arcs = 0, contacts = 0;
    for (int i = 0; i < 2000; i++) {
        struct random_state r = random_for(2, "invariance", (uint64_t)i);
        struct plane_curve f, g;
        struct test_case a, b;
        small_curve(&f, &r);
        small_curve(&g, &r);
        if (i % 6 == 0)
            plane_curve_compose(&g, &f, i % 4 ? "2  1 -1" : "3  0 1/2 1/2");
        solve(&a, &f, 0, &g, 0);
        common += a.expected.count > 0;
        arcs += a.expected.overlaps > 0;
        for (int k = 0; k < a.expected.count; k++)
            contacts += a.expected.at[k].multiplicity > 1;
        for (enum transform how = SWAPPED; how < TRANSFORMS; how++) {
            solve_transformed(&b, &f, &g, how);
            assert_same(&a, &b, how);
            case_clear(&b);
        }
        case_clear(&a);
        plane_curve_clear(&f);
        plane_curve_clear(&g);
    }
    assert_true(common > 500 && arcs > 300 && contacts > 100); /* the cases are what they are meant to be */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_invariance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
