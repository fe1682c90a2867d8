/* Fat lines and boxes: no point that the arcs may have, within their error, is left out.  Exact arithmetic.
 */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/arc.h"

enum { DEGREE = 32, SAMPLES = 24 };

static const struct fat_line_rule rules[] = {
    {true, true, 1}, {true, false, 1}, {false, true, 1}, {false, false, 1}};

struct prop_arc {
    struct arc arc;
    real x[DEGREE + 1], y[DEGREE + 1], w[DEGREE + 1];
};

/* A piece of a curve in [-1, 1]^2 as the algorithms meet it: of size 1 to 2^-50, straight, curved, closed, or
 * a point; repeated points; with an error of 0, of rounding, or as large as itself. */
static void make(struct prop_arc *a, struct random_state *r, bool rational)
{
    int n = random_bits(r) % 2 ? (int)random_between(r, 2, 3) : nasty_degree(r, DEGREE);
    int size = -(int)random_between(r, 0, 50), kind = (int)(random_bits(r) % 6);
    real x = prop_dyadic(r, 30) / 2, y = prop_dyadic(r, 30) / 2, dx = prop_dyadic(r, 20),
         dy = prop_dyadic(r, 20);
    for (int i = 0; i <= n; i++) {
        real along = kind < 3 ? (real)i / n : prop_dyadic(r, 10);
        real off =
            kind == 0 || kind == 4 ? (real)0 : real_ldexp(prop_dyadic(r, 20), kind == 1 ? size / 2 : 0);
        a->w[i] = rational ? 1 + prop_unit(r, 10) : (real)1;
        real px = kind == 5 ? x : x + real_ldexp((along * dx - off * dy) / 4, size);
        real py = kind == 5 ? y : y + real_ldexp((along * dy + off * dx) / 4, size);
        a->x[i] = a->w[i] * px;
        a->y[i] = a->w[i] * py;
        if (i > 0 && random_bits(r) % 8 == 0) {
            a->x[i] = a->x[i - 1];
            a->y[i] = a->y[i - 1];
            a->w[i] = a->w[i - 1];
        }
    }
    if (kind == 3 && random_bits(r) % 2) {
        a->x[n] = a->x[0];
        a->y[n] = a->y[0];
        a->w[n] = a->w[0];
    }
    a->arc.degree = n;
    a->arc.x = a->x;
    a->arc.y = a->y;
    a->arc.w = rational ? a->w : NULL;
    int error = (int)(random_bits(r) % 3);
    a->arc.error = error == 0 ? (real)0 : error == 1 ? 12 * n * REAL_EPSILON : real_ldexp(1, size);
}

/* nx X + ny Y at t, times the weight there. */
static void exact_distance(const struct strip *s, const struct arc *a, real t, mpq_t d, mpq_t weight)
{
    mpq_t y, n;
    mpq_inits(y, n, NULL);
    exact_value(a->degree, a->x, t, d);
    exact_value(a->degree, a->y, t, y);
    real_to_rational(s->nx, n);
    mpq_mul(d, d, n);
    real_to_rational(s->ny, n);
    mpq_mul(y, y, n);
    mpq_add(d, d, y);
    mpq_set_ui(weight, 1, 1);
    if (a->w)
        exact_value(a->degree, a->w, t, weight);
    mpq_clears(y, n, NULL);
}

/* norm error: what the error of an arc can move a distance. */
static void exact_reach(const struct strip *s, real error, mpq_t out)
{
    mpq_t n;
    mpq_init(n);
    real_to_rational(real_abs(s->nx), out);
    real_to_rational(real_abs(s->ny), n);
    mpq_add(out, out, n);
    real_to_rational(error, n);
    mpq_mul(out, out, n);
    mpq_clear(n);
}

/* Range of nx X + ny Y over the curve within its error, by samples. */
static void exact_range(const struct strip *s, const struct arc *b, mpq_t lo, mpq_t hi)
{
    mpq_t d, w, reach;
    mpq_inits(d, w, reach, NULL);
    for (int k = 0; k <= SAMPLES; k++) {
        exact_distance(s, b, (real)k / SAMPLES, d, w);
        mpq_div(d, d, w);
        if (k == 0 || mpq_cmp(d, lo) < 0)
            mpq_set(lo, d);
        if (k == 0 || mpq_cmp(d, hi) > 0)
            mpq_set(hi, d);
    }
    exact_reach(s, b->error, reach);
    mpq_sub(lo, lo, reach);
    mpq_add(hi, hi, reach);
    mpq_clears(d, w, reach, NULL);
}

/* Does the strip hold b within its error?  Is its normal of the length it should be? */
static void check_strip(const struct strip *s, const struct arc *b, bool unit, int trial)
{
    mpq_t lo, hi, level, length;
    mpq_inits(lo, hi, level, length, NULL);
    exact_range(s, b, lo, hi);
    real_to_rational(s->lo, level);
    bool holds = mpq_cmp(level, lo) <= 0;
    real_to_rational(s->hi, level);
    holds = holds && mpq_cmp(level, hi) >= 0;
    if (!holds)
        fail_msg("strip %d: degree %d: a point of the arc is outside", trial, b->degree);
    real_to_rational(s->nx, lo);
    real_to_rational(s->ny, hi);
    mpq_mul(lo, lo, lo);
    mpq_mul(hi, hi, hi);
    mpq_add(length, lo, hi);
    mpq_set_ui(level, 1, 1);
    if (unit && !is_near(1, length, 16, level)) /* 4 eps of the length, 8 eps of its square */
        fail_msg("strip %d: the normal has not unit length", trial);
    assert_true(s->nx != 0 || s->ny != 0);
    mpq_clears(lo, hi, level, length, NULL);
}

/* The computed distances of a are not below those of any control point within its error from any point of b:
 * d_i + reach of a - (lowest of b), times the weight; likewise from above. */
static void check_distances(const struct strip *s, const struct arc *a, const struct arc *b, int trial)
{
    real above[DEGREE + 1], below[DEGREE + 1];
    mpq_t lo, hi, d, w, reach, computed;
    mpq_inits(lo, hi, d, w, reach, computed, NULL);
    exact_range(s, b, lo, hi);
    exact_reach(s, a->error, reach);
    strip_distances(s, a, above, below);
    for (int i = 0; i <= a->degree; i++) {
        const struct arc point = {0, a->x + i, a->y + i, a->w ? a->w + i : NULL, 0};
        exact_distance(s, &point, 0, d, w);
        mpq_div(d, d, w);
        real_to_rational(above[i], computed);
        mpq_div(computed, computed, w);
        mpq_sub(computed, computed, d);
        mpq_sub(computed, computed, reach);
        mpq_add(computed, computed, lo);
        bool safe = mpq_sgn(computed) >= 0;
        real_to_rational(below[i], computed);
        mpq_div(computed, computed, w);
        mpq_add(computed, computed, d);
        mpq_sub(computed, computed, reach);
        mpq_sub(computed, computed, hi);
        if (!safe || mpq_sgn(computed) < 0)
            fail_msg("strip %d: distance %d is too small", trial, i);
    }
    mpq_clears(lo, hi, d, w, reach, computed, NULL);
}

static void test_fat_line(void **state)
{
    (void)state;
    for (int i = 0; i < trials(2000); i++) {
        struct random_state r = random_for(1, "strip", (uint64_t)i);
        struct prop_arc a, b;
        struct strip s;
        make(&a, &r, i % 4 == 1);
        make(&b, &r, i % 8 < 3);
        fat_line(&b.arc, &a.arc, 1, &rules[i / 8 % 4], &s);
        check_strip(&s, &b.arc, rules[i / 8 % 4].unit, i);
        check_distances(&s, &a.arc, &b.arc, i);
    }
}

/* The widest quadratics and cubics for their control values: the factors 1/2, 3/4 and 4/9 with nothing to
 * spare but rounding. */
static void test_tight(void **state)
{
    (void)state;
    for (int i = 0; i < trials(2000); i++) {
        struct random_state r = random_for(1, "tight", (uint64_t)i);
        struct prop_arc a, b;
        struct strip s;
        int n = 2 + i % 2;
        real skew = real_ldexp(prop_dyadic(&r, 10), -(int)random_between(&r, 0, 52));
        make(&a, &r, false);
        for (int k = 0; k <= n; k++) {
            b.x[k] = k * (real)0.25 + skew * (int)(random_bits(&r) % 3);
            b.y[k] =
                (k == 1 || k == n - 1 ? (i % 4 > 1 && k == 1 ? -1 : 1) * prop_unit(&r, 8) / 2 : (real)0) +
                skew * (int)(random_bits(&r) % 3) / 4;
        }
        const struct arc arc = {n, b.x, b.y, NULL, 0};
        fat_line(&arc, &a.arc, 1, &rules[2 * (i / 4 % 2)], &s);
        check_strip(&s, &arc, i / 4 % 2 == 0, i);
    }
}

/* ---- boxes ---- */

/* Arcs with a common point, or with points as far apart as their errors reach: the boxes meet. */
static void test_boxes_meet(void **state)
{
    (void)state;
    for (int i = 0; i < trials(20000); i++) {
        struct random_state r = random_for(1, "boxes", (uint64_t)i);
        struct prop_arc a, b;
        make(&a, &r, i % 4 == 1);
        make(&b, &r, i % 8 < 3);
        /* b moves so that its end is an end of a, but for the errors of both and the rounding of the move: 4
         * u */
        real x = a.x[0] / a.w[0] - b.x[0] / b.w[0], y = a.y[0] / a.w[0] - b.y[0] / b.w[0];
        real off = real_max(a.arc.error + b.arc.error - 8 * REAL_EPSILON, 0);
        x = x + (random_bits(&r) % 3 - 1.0) * off;
        y = y + (random_bits(&r) % 3 - 1.0) * off;
        for (int k = 0; k <= b.arc.degree; k++) {
            b.x[k] = b.x[k] + b.w[k] * x;
            b.y[k] = b.y[k] + b.w[k] * y;
        }
        const real scale = 4;
        if (!arc_boxes_meet(&a.arc, &b.arc, scale) || !arc_oriented_boxes_meet(&a.arc, &b.arc, scale))
            fail_msg("boxes %d are called apart", i);
    }
}

/* Arcs that are far apart across the chord of one of them are called so; axis-parallel boxes may still meet.
 */
static void test_boxes_apart(void **state)
{
    (void)state;
    for (int i = 0; i < trials(2000); i++) {
        struct random_state r = random_for(1, "apart", (uint64_t)i);
        struct prop_arc a, b;
        real gap = real_ldexp(1, -(int)random_between(&r, 0, 40)), tilt = prop_dyadic(&r, 10);
        make(&a, &r, false);
        a.arc.error = 0;
        for (int k = 0; k <= a.arc.degree; k++) {
            a.x[k] = (real)k / a.arc.degree;
            a.y[k] = tilt * a.x[k];
            b.x[k] = a.x[k];
            b.y[k] = a.y[k] + gap;
        }
        b.arc = a.arc;
        b.arc.x = b.x;
        b.arc.y = b.y;
        assert_false(arc_oriented_boxes_meet(&a.arc, &b.arc, 2));
        for (int k = 0; k <= b.arc.degree; k++)
            b.y[k] = a.y[k] + 3;
        assert_false(arc_boxes_meet(&a.arc, &b.arc, 4));
        for (int k = 0; k <= b.arc.degree; k++)
            b.x[k] = a.x[k] + 3;
        assert_false(arc_boxes_meet(&b.arc, &a.arc, 4));
    }
}

static void test_extent(void **state)
{
    (void)state;
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(1, "extent", (uint64_t)i);
        struct prop_arc a;
        real widest = 0;
        make(&a, &r, i % 2);
        for (int j = 0; j <= a.arc.degree; j++)
            for (int k = 0; k < j; k++) {
                widest = real_max(widest, real_abs(a.x[j] / a.w[j] - a.x[k] / a.w[k]));
                widest = real_max(widest, real_abs(a.y[j] / a.w[j] - a.y[k] / a.w[k]));
            }
        assert_true(arc_extent(&a.arc) == widest);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fat_line),    cmocka_unit_test(test_tight),  cmocka_unit_test(test_boxes_meet),
        cmocka_unit_test(test_boxes_apart), cmocka_unit_test(test_extent),
    };
    return cmocka_run_group_tests_name("arc", tests, NULL, NULL);
}
