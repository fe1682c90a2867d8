/* Models and nearby polynomials: their remainders hold in exact arithmetic, and are not idle. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/model.h"
#include "../algorithms/core/nearby.h"

/* |exact - value| <= bound? */
static bool within(const mpq_t exact, const mpq_t value, real bound)
{
    mpq_t off, most;
    mpq_init(off);
    mpq_init(most);
    mpq_sub(off, exact, value);
    mpq_abs(off, off);
    real_to_rational(bound, most);
    bool is = mpq_cmp(off, most) <= 0;
    mpq_clear(off);
    mpq_clear(most);
    return is;
}

/* Sum of c[j] u^j. */
static void power_value(int k, const real *c, const mpq_t u, mpq_t out)
{
    mpq_t a;
    mpq_init(a);
    mpq_set_ui(out, 0, 1);
    for (int j = k; j >= 0; j--) {
        real_to_rational(c[j], a);
        mpq_mul(out, out, u);
        mpq_add(out, out, a);
    }
    mpq_clear(a);
}

/* 2t - 1. */
static void centred(real t, mpq_t out)
{
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    real_to_rational(t, out);
    mpq_mul_2exp(out, out, 1);
    mpq_sub(out, out, one);
    mpq_clear(one);
}

static void random_model(struct random_state *r, int k, struct model *m)
{
    int fall = (int)random_between(r, 0, 20);
    m->k = k;
    m->rest = 0;
    for (int j = 0; j <= k; j++)
        m->c[j] = prop_bits(r, -j * fall);
}

/* Bernstein form to powers and back. */
static void test_conversion(void **state)
{
    (void)state;
    for (int i = 0; i < trials(4000); i++) {
        struct random_state r = random_for(1, "conversion", (uint64_t)i);
        int k = 1 + i % MODEL_MAX, n = (int)random_between(&r, 1, k);
        real b[MODEL_MAX + 1], back[MODEL_MAX + 1], t = nasty_unit(&r);
        struct model m;
        mpq_t u, exact, value;
        mpq_init(u);
        mpq_init(exact);
        mpq_init(value);
        nasty_coefficients(&r, n, b);
        model_of_bernstein(n, b, 0, k, &m);
        centred(t, u);
        exact_value(n, b, t, exact);
        power_value(k, m.c, u, value);
        if (!within(exact, value, m.rest))
            fail_msg("case %d: degree %d is farther from its powers than the rest says", i, n);
        real bound = model_to_bernstein(&m, 1, back);
        exact_value(k, back, t, exact);
        if (!within(exact, value, bound))
            fail_msg("case %d: powers of degree %d are farther from their Bernstein form than its bound", i,
                     k);
        mpq_clear(u);
        mpq_clear(exact);
        mpq_clear(value);
    }
}

/* The shifted polynomial, and the composition with another: p(at + q(u)). */
static void test_composition(void **state)
{
    (void)state;
    int exceeded = 0;
    for (int i = 0; i < trials(4000); i++) {
        struct random_state r = random_for(1, "composition", (uint64_t)i);
        int k = 1 + i % MODEL_MAX;
        struct model p, q, shifted, out;
        real at = prop_dyadic(&r, 20), t = nasty_unit(&r);
        mpq_t u, v, exact, value;
        mpq_init(u);
        mpq_init(v);
        mpq_init(exact);
        mpq_init(value);
        random_model(&r, k, &p);
        random_model(&r, k, &q);
        q.c[0] = 0;
        shifted = p;
        model_shift(&shifted, at);
        centred(t, u);
        power_value(k, q.c, u, v);
        power_value(k, shifted.c, v, value);
        real_to_rational(at, exact);
        mpq_add(exact, exact, v);
        mpq_t place;
        mpq_init(place);
        mpq_set(place, exact);
        power_value(k, p.c, place, exact);
        real reach = model_size(&q, 1) * (1 + 16 * REAL_EPSILON);
        real bound = k * REAL_EPSILON * model_size(&p, real_abs(at) + reach) * 65 / 64;
        if (!within(exact, value, bound))
            fail_msg("case %d: a shift by %g errs by more than its bound", i, real_to_double(at));
        model_compose(&shifted, &q, &out);
        mpq_set(exact, value);
        power_value(k, out.c, u, value);
        if (!within(exact, value, out.rest))
            fail_msg("case %d: a composition of degree %d strays farther than its rest", i, k);
        exceeded += !within(exact, value, out.rest / 64);
        mpq_clear(place);
        mpq_clear(u);
        mpq_clear(v);
        mpq_clear(exact);
        mpq_clear(value);
    }
    assert_true(exceeded > 0); /* the rest is within 64 times of what happens */
}

/* ---- nearby ---- */

static struct frame random_frame(struct random_state *r)
{
    struct frame f;
    f.scale = 1;
    f.x0 = prop_dyadic(r, 10);
    f.y0 = prop_dyadic(r, 10);
    for (int j = 0; j < 4; j++)
        f.row[j / 2][j % 2] = prop_bits(r, (int)random_between(r, -3, 3));
    frame_set_norms(&f);
    return f;
}

/* Coordinate j at t, exactly: homogeneous, then divided. */
static void exact_coordinate(const struct curve *c, const struct frame *f, int j, const mpq_t h[3], mpq_t out)
{
    mpq_t a, b;
    (void)c;
    mpq_init(a);
    mpq_init(b);
    mpq_set_ui(out, 0, 1);
    for (int k = 0; k < 2; k++) {
        mpq_div(a, h[k], h[2]);
        real_to_rational(k ? f->y0 : f->x0, b);
        mpq_sub(a, a, b);
        real_to_rational(f->row[j][k], b);
        mpq_mul(a, a, b);
        mpq_add(out, out, a);
    }
    mpq_clear(a);
    mpq_clear(b);
}

static void exact_homogeneous(const struct curve *c, real t, mpq_t h[3])
{
    exact_value(c->degree, c->x, t, h[0]);
    exact_value(c->degree, c->y, t, h[1]);
    mpq_set_ui(h[2], 1, 1);
    if (c->w)
        exact_value(c->degree, c->w, t, h[2]);
}

/* At any two parameters the polynomial is within off, and the chord's slope within slope_off (mean value
 * theorem). */
static void test_nearby(void **state)
{
    (void)state;
    int tight = 0, cases = trials(3000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, "nearby", (uint64_t)i);
        struct prop_curve c;
        int n = nasty_degree(&r, 12), k = (int)random_between(&r, 1, REDUCED_MAX);
        static real memory[2 * 33 * (REDUCED_MAX + 1)];
        struct reduction reduction;
        struct nearby near;
        struct frame f = random_frame(&r);
        prop_curve_make(&c, &r, n, 10, i % 2);
        reduction_init(&reduction, n, k, memory);
        struct arc a = {n, c.x, c.y, c.curve.w, 0};
        nearby_init(&a, &f, &reduction, k, &near);
        real t[2] = {prop_unit(&r, 6), prop_unit(&r, 6)};
        t[1] = t[1] == t[0] ? (t[0] > 0 ? t[0] / 2 : (real)1) : t[1];
        mpq_t h[3], off[2], value, exact, step;
        rationals_init(3, h);
        rationals_init(2, off);
        mpq_init(value);
        mpq_init(exact);
        mpq_init(step);
        for (int j = 0; j < 2; j++) {
            for (int q = 0; q < 2; q++) {
                exact_homogeneous(&c.curve, t[q], h);
                exact_coordinate(&c.curve, &f, j, h, exact);
                exact_value(near.degree, near.c[j], t[q], value);
                if (!within(exact, value, near.off[j]))
                    fail_msg("case %d: coordinate %d is farther than %g", i, j, real_to_double(near.off[j]));
                tight += !within(exact, value, near.off[j] / 16);
                mpq_sub(off[q], exact, value);
            }
            real_to_rational(real_abs(t[1] - t[0]) * near.slope_off[j], step);
            mpq_sub(off[0], off[0], off[1]);
            mpq_abs(off[0], off[0]);
            if (mpq_cmp(off[0], step) > 0)
                fail_msg("case %d: the slope of coordinate %d strays farther than %g", i, j,
                         real_to_double(near.slope_off[j]));
        }
        rationals_clear(3, h);
        rationals_clear(2, off);
        mpq_clear(value);
        mpq_clear(exact);
        mpq_clear(step);
    }
    assert_true(tight > cases / 4); /* of 4 values a case */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_conversion), cmocka_unit_test(test_composition),
                                       cmocka_unit_test(test_nearby)};
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}
