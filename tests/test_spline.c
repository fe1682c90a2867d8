/* Splines: Bezier pieces against de Boor's algorithm in exact arithmetic; joins; the NURBS circle; mistakes.
 */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/curve.h"
#include "../algorithms/core/spline.h"

enum { COUNT = 48, DEGREE = 32 };

struct prop_spline {
    struct spline spline;
    real points[3 * COUNT], knots[COUNT + DEGREE + 1];
};

/* Multiplicities 1 to the degree inside; ends clamped or not; spacing even, or from 2^-20 to 1. */
static void make(struct prop_spline *p, struct random_state *r, int most)
{
    int n = nasty_degree(r, most), inner = (int)random_between(r, 0, 6), count = n + 1,
        clamped = random_bits(r) % 2;
    real at = prop_dyadic(r, 10), *knot = p->knots;
    for (int i = 0; i <= n; i++) {
        *knot++ = at;
        at = at + (clamped ? (real)0 : prop_unit(r, 8) + (real)0.125);
    }
    for (int i = 0; i < inner; i++) {
        int repeat = random_bits(r) % 2 ? 1 : (int)random_between(r, 1, n);
        at = at + real_ldexp(1 + prop_unit(r, 6), -(int)random_between(r, 0, 20));
        for (; repeat > 0 && count < COUNT; repeat--, count++)
            *knot++ = at;
    }
    at = at + (real)0.5;
    for (int i = 0; i <= n; i++) {
        *knot++ = at;
        at = at + (clamped ? (real)0 : prop_unit(r, 8) + (real)0.125);
    }
    p->spline.degree = n;
    p->spline.count = count;
    p->spline.components = (int)random_between(r, 1, 3);
    p->spline.points = p->points;
    p->spline.knots = p->knots;
    for (int k = 0; k < p->spline.components; k++)
        nasty_coefficients(r, count - 1 < DEGREE ? count - 1 : DEGREE, p->points + k * count);
    for (int k = 0; k < p->spline.components; k++)
        for (int i = DEGREE + 1; i < count; i++)
            p->points[k * count + i] = p->points[k * count + i - DEGREE - 1];
}

/* Value of the spline's component at t in the span of knots k, k + 1: de Boor's algorithm. */
static void exact_de_boor(const struct spline *s, int component, int k, const mpq_t t, mpq_t out)
{
    int n = s->degree;
    mpq_t d[DEGREE + 1], left, right, a, b;
    rationals_init(n + 1, d);
    mpq_inits(left, right, a, b, NULL);
    for (int i = 0; i <= n; i++)
        real_to_rational(s->points[component * s->count + k - n + i], d[i]);
    for (int round = 1; round <= n; round++)
        for (int j = n; j >= round; j--) {
            real_to_rational(s->knots[k - n + j], left);
            real_to_rational(s->knots[k + 1 + j - round], right);
            mpq_sub(b, right, left);
            mpq_sub(a, t, left);
            mpq_div(a, a, b); /* (t - left) / (right - left) */
            mpq_sub(b, d[j], d[j - 1]);
            mpq_mul(b, b, a);
            mpq_add(d[j], d[j - 1], b);
        }
    mpq_set(out, d[n]);
    rationals_clear(n + 1, d);
    mpq_clears(left, right, a, b, NULL);
}

/* The piece agrees with the spline at n + 1 parameters, and so everywhere: what its rounded coefficients are
 * off by, 8 n u max|point| each, is off by no more in between. */
static void check_piece(const struct spline *s, int k, const struct spline_piece *piece, int trial)
{
    int n = s->degree;
    mpq_t t, lo, width, exact, value, size;
    mpq_inits(t, lo, width, exact, value, size, NULL);
    real_to_rational(piece->lo, lo);
    real_to_rational(piece->hi, width);
    mpq_sub(width, width, lo);
    for (int c = 0; c < s->components; c++) {
        exact_largest(n, s->points + c * s->count + k - n, size);
        for (int i = 0; i <= n; i++) {
            real local = real_ldexp((real)i, -5);
            real_to_rational(local, t);
            mpq_mul(t, t, width);
            mpq_add(t, t, lo);
            exact_de_boor(s, c, k, t, exact);
            exact_value(n, piece->coefficients + c * (n + 1), local, value);
            mpq_sub(value, value, exact);
            if (!is_near(0, value, 8 * n, size))
                fail_msg("spline %d: degree %d, span %d, component %d: value at %d/32", trial, n, k, c, i);
        }
    }
    mpq_clears(t, lo, width, exact, value, size, NULL);
}

static void test_pieces(void **state)
{
    (void)state;
    for (int i = 0; i < trials(100); i++) {
        struct random_state r = random_for(1, "pieces", (uint64_t)i);
        struct prop_spline p;
        struct spline_piece piece;
        make(&p, &r, i % 10 ? 6 : DEGREE / 2);
        if (spline_check(&p.spline))
            fail_msg("spline %d: %s", i, spline_check(&p.spline));
        const struct spline *s = &p.spline;
        int count = 0;
        for (int k = s->degree; k < s->count; k++) {
            if (s->knots[k] == s->knots[k + 1])
                continue;
            spline_piece(s, count++, &piece);
            assert_true(piece.lo == s->knots[k] && piece.hi == s->knots[k + 1]);
            check_piece(s, k, &piece, i);
        }
        assert_int_equal(count, spline_pieces(s));
    }
}

/* Successive pieces meet to within the bounds of both; a spline with n + 1 points clamped is its own piece.
 */
static void test_joins(void **state)
{
    (void)state;
    mpq_t size, end;
    mpq_init(size);
    mpq_init(end);
    for (int i = 0; i < trials(500); i++) {
        struct random_state r = random_for(1, "joins", (uint64_t)i);
        struct prop_spline p;
        struct spline_piece before, after;
        make(&p, &r, DEGREE);
        int n = p.spline.degree;
        for (int k = 0; k < spline_pieces(&p.spline); k++) {
            spline_piece(&p.spline, k, &after);
            for (int c = 0; k > 0 && c < p.spline.components; c++) {
                exact_largest(p.spline.count - 1, p.points + c * p.spline.count, size);
                real_to_rational(before.coefficients[c * (n + 1) + n], end);
                assert_true(before.hi == after.lo);
                assert_true(is_near(after.coefficients[c * (n + 1)], end, 16 * n, size));
            }
            before = after;
        }
    }
    mpq_clear(size);
    mpq_clear(end);
}

/* Nine points of the square around the unit circle, weights 1 and sqrt(1/2): all pieces on the circle. */
static void test_circle(void **state)
{
    (void)state;
    static const int x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    static const int knot[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    const real half = (real)0.5, few = 32 * REAL_EPSILON;
    struct prop_spline p;
    for (int i = 0; i < 9; i++) {
        real w = i % 2 ? real_sqrt(half) : (real)1;
        p.points[i] = w * x[i];
        p.points[9 + i] = w * y[i];
        p.points[18 + i] = w;
    }
    for (int i = 0; i < 12; i++)
        p.knots[i] = knot[i];
    const struct spline s = {2, 9, 3, p.points, p.knots};
    assert_null(spline_check(&s));
    assert_int_equal(spline_pieces(&s), 4);
    for (int k = 0; k < 4; k++) {
        struct spline_piece piece;
        spline_piece(&s, k, &piece);
        const real *c = piece.coefficients;
        for (int i = 0; i <= 64; i++) {
            struct point q = curve_point(2, c, c + 3, c + 6, (real)i / 64);
            assert_true(real_abs(q.x * q.x + q.y * q.y - 1) <= few);
        }
    }
}

static void test_mistakes(void **state)
{
    (void)state;
    const real infinite = REAL_HUGE * 2, nan = infinite - infinite;
    const real points[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const real good[] = {0, 0, 0, 1, 1, 2, 2, 2}, falling[] = {0, 0, 0, 1, (real)0.5, 2, 2, 2};
    const real often[] = {0, 0, 0, 1, 1, 1, 2, 2, 2}, unknown[] = {0, 0, 0, nan, 1, 2, 2, 2};
    const real flat[] = {0, 0, 0, 0, 0, 0, 0, 0}, start[] = {0, 0, 0, 0, 1, 2, 2, 2};
    const real endless[] = {0, 0, 0, 1, 1, infinite, infinite, infinite};
    const struct spline s[] = {
        {2, 5, 1, points, good},    {0, 5, 1, points, good},    {33, 5, 1, points, good},
        {2, 2, 1, points, good},    {2, 5, 1, points, falling}, {2, 6, 1, points, often},
        {2, 5, 1, points, unknown}, {2, 5, 1, points, flat},    {2, 5, 1, points, start},
        {2, 5, 1, points, endless},
    };
    for (int i = 0; i < (int)(sizeof s / sizeof *s); i++)
        if ((spline_check(&s[i]) == NULL) != (i == 0))
            fail_msg("spline %d is %s", i, i ? "taken" : "refused");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pieces),
        cmocka_unit_test(test_joins),
        cmocka_unit_test(test_circle),
        cmocka_unit_test(test_mistakes),
    };
    return cmocka_run_group_tests_name("spline", tests, NULL, NULL);
}
