/* The gap between arcs: no planted meeting is denied, in exact arithmetic; its order at contacts and cusps;
 * the number of steps at near-contacts. */
#include <math.h>

#include "arcs_cut.h"
#include "nasty.h"
#include "solving.h"

#include "../algorithms/core/band.h"
#include "../algorithms/core/bernstein.h"
#include "../algorithms/core/gap.h"

static bool is_negative(int k, const real *c, real t)
{
    mpq_t v;
    mpq_init(v);
    exact_value(k, c, t, v);
    bool below = mpq_sgn(v) < 0;
    mpq_clear(v);
    return below;
}

/* |s - sigma(t)| <= margin? */
static bool is_partner(const struct gap *g, real t, real s, real margin)
{
    mpq_t v, a;
    mpq_init(v);
    mpq_init(a);
    exact_value(g->k, g->sigma, t, v);
    real_to_rational(s, a);
    mpq_sub(v, v, a);
    mpq_abs(v, v);
    real_to_rational(margin, a);
    bool near = mpq_cmp(v, a) <= 0;
    mpq_clear(v);
    mpq_clear(a);
    return near;
}

struct setting {
    struct planted pair;
    struct cut a, b;
    struct frame frame;
    struct reduction ra, rb;
    real memory[2][2 * (DEGREE_MAX + 1) * (REDUCED_MAX + 1)];
    real t, s; /* local */
    int k;
};

/* False: b is not fit to be parametrised by its chord. */
static bool setting_make(struct setting *z, struct random_state *r, int i)
{
    int rational = i % 4 > 1 ? i % 4 - 1 : 0;
    planted_make(&z->pair, r, nasty_degree(r, 8), nasty_degree(r, 8), rational);
    int e = (int)random_between(r, 1, REAL_BITS < 60 ? 20 : 40), apart = (int)random_between(r, 0, 2);
    real lo = around(r, z->pair.t, e, &z->t), lo_s = around(r, z->pair.s, e + apart, &z->s);
    cut_init(&z->a, &z->pair.f.curve, lo, lo + real_ldexp(1, -e), 8);
    cut_init(&z->b, &z->pair.g.curve, lo_s, lo_s + real_ldexp(1, -e - apart), 8);
    z->k = 2 + i % 4;
    reduction_init(&z->ra, z->a.arc.degree, z->k, z->memory[0]);
    reduction_init(&z->rb, z->b.arc.degree, z->k, z->memory[1]);
    return gap_frame(&z->b.arc, 8, &z->frame) > 0;
}

static struct setting setting;

/* The planted meeting is in the common extent, in the band, and near sigma.  A bound half as large loses
 * some. */
static void test_planted(void **state)
{
    (void)state;
    int made = 0, lost_without = 0, cases = trials(12000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, "gap", (uint64_t)i);
        struct setting *z = &setting;
        struct interval t = {0, 1}, s = {0, 1};
        struct gap gap;
        if (!setting_make(z, &r, i))
            continue;
        if (!gap_common_extent(&z->a.arc, &z->b.arc, &z->frame, &t, &s) || z->t < t.lo || z->t > t.hi ||
            z->s < s.lo || z->s > s.hi)
            fail_msg("case %d: the meeting is not in the common extent", i);
        if (!gap_between(&z->a.arc, &z->b.arc, &z->frame, &z->ra, &z->rb, z->k, &gap))
            continue;
        made++;
        if (is_negative(z->k, gap.above, z->t) || is_negative(z->k, gap.below, z->t))
            fail_msg("case %d, degree %d: the gap denies the meeting", i, z->k);
        if (!is_partner(&gap, z->t, z->s, gap.eta))
            fail_msg("case %d, degree %d: s is not near sigma(t)", i, z->k);
        struct interval partner = gap_partner(&gap, z->t, z->t);
        if (z->s < partner.lo || z->s > partner.hi)
            fail_msg("case %d, degree %d: s is not among the partners", i, z->k);
        lost_without += !is_partner(&gap, z->t, z->s, gap.eta / 16);
    }
    assert_true(made > cases / 4);
    assert_true(lost_without > 0);
}

/* ---- order ---- */

/* b(v) = (v, phi(v)) and a(u) = (x(u), phi(x(u)) + 3/4 u^mu + u^(mu+1)), in powers of u and v about their
 * meeting: multiplicity mu.  x(u) = u + u^2 / 2, or u^2 + u^3 at a cusp. */
enum { POWERS = 10 };

static void power_to_curve(int n, const real *px, const real *py, real at, struct prop_curve *c)
{
    /* the blossom of (u - at)^j at i ones and n - i zeros is a mean of products; Horner's scheme in Bernstein
     * form */
    real *out[2] = {c->x, c->y};
    const real *in[2] = {px, py};
    for (int k = 0; k < 2; k++) {
        real *b = out[k];
        b[0] = in[k][n];
        for (int m = 1; m <= n; m++) { /* b, of degree m - 1, times (t - at), plus the next coefficient */
            b[m] = b[m - 1] * (1 - at) + in[k][n - m];
            for (int i = m - 1; i > 0; i--)
                b[i] = (i * (b[i - 1] * (1 - at)) - (m - i) * (b[i] * at)) / m + in[k][n - m];
            b[0] = in[k][n - m] - b[0] * at;
        }
    }
    c->curve.degree = n;
    c->curve.domain.lo = 0;
    c->curve.domain.hi = 1;
    c->curve.x = c->x;
    c->curve.y = c->y;
    c->curve.w = NULL;
}

static void multiply(const real *a, const real *b, real *out)
{
    real product[POWERS];
    for (int i = 0; i < POWERS; i++) {
        product[i] = 0;
        for (int j = 0; j <= i; j++)
            product[i] = product[i] + a[j] * b[i - j];
    }
    for (int i = 0; i < POWERS; i++)
        out[i] = product[i];
}

static void contact_make(int mu, bool cusp, real at, real bt, struct prop_curve *a, struct prop_curve *b)
{
    real phi[POWERS], x[POWERS], y[POWERS], line[POWERS];
    for (int i = 0; i < POWERS; i++)
        phi[i] = x[i] = y[i] = line[i] = 0;
    line[1] = 1;
    phi[2] = (real)3 / 8;
    phi[3] = (real)1 / 4;
    x[cusp ? 2 : 1] = 1;
    x[cusp ? 3 : 2] = (real)1 / 2;
    for (int j = 3; j >= 0; j--) { /* phi(x), Horner */
        multiply(y, x, y);
        y[0] = y[0] + phi[j];
    }
    y[mu] = y[mu] + (real)3 / 4;
    y[mu + 1] = y[mu + 1] + (real)1 / 2;
    power_to_curve(POWERS - 1, x, y, at, a);
    power_to_curve(3, line, phi, bt, b);
}

static double log2_of(real a)
{
    int e = real_exponent(a);
    return e + log2(real_to_double(real_ldexp(a, -e)));
}

/* log2 of the part of a's parameter that one step leaves, from boxes of width 2^-j about the meeting. */
static double step_width(const struct prop_curve *a, const struct prop_curve *b, real at, real bt, int k,
                         int j)
{
    static real memory[2][2 * (DEGREE_MAX + 1) * (REDUCED_MAX + 1)];
    static struct cut ca, cb;
    struct frame frame;
    struct reduction ra, rb;
    struct gap gap;
    struct band above, below, kept;
    struct interval t = {0, 1}, s = {0, 1};
    real h = real_ldexp(1, -j), lo = at - h * 5 / 16, lo_s = bt - h * 9 / 16;
    cut_init(&ca, &a->curve, lo, lo + h, 2);
    cut_init(&cb, &b->curve, lo_s, lo_s + h, 2);
    assert_true(gap_frame(&cb.arc, 2, &frame) > 0 && gap_common_extent(&ca.arc, &cb.arc, &frame, &t, &s));
    cut_init(&ca, &a->curve, lo + h * t.lo, lo + h * t.hi, 2);
    cut_init(&cb, &b->curve, lo_s + h * s.lo, lo_s + h * s.hi, 2);
    reduction_init(&ra, ca.arc.degree, k, memory[0]);
    reduction_init(&rb, cb.arc.degree, k, memory[1]);
    assert_true(gap_between(&ca.arc, &cb.arc, &frame, &ra, &rb, k, &gap));
    band_above(k, gap.above, &above);
    band_above(k, gap.below, &below);
    band_meet(&above, &below, &kept);
    assert_true(kept.count > 0);
    real width = 0;
    for (int i = 0; i < kept.count; i++)
        width = real_max(width, kept.hi[i] - kept.lo[i]);
    return log2_of(width * h * (t.hi - t.lo));
}

/* From boxes of width h the step leaves h^((k+1)/mu): slope over the finest widths that rounding lets be
 * seen, h^(k+1) against eps.  Where (k + 1) / mu <= 1 nothing is claimed. */
static void check_order(int mu, bool cusp, int k)
{
    static struct prop_curve a, b;
    real at = (real)3 / 8, bt = (real)9 / 16;
    int last = (REAL_BITS - 8) / (k + 2), first = REAL_BITS > 53 ? last / 2 : last - 4;
    if (last > 150) {
        last = 150;
        first = 75;
    }
    contact_make(mu, cusp, at, bt, &a, &b);
    double order =
        (step_width(&a, &b, at, bt, k, last) - step_width(&a, &b, at, bt, k, first)) / (first - last);
    double theory = (k + 1.0) / mu, allowed = REAL_BITS > 113 ? 0.03 : 0.05;
    print_message("contact %d%s, degree %d: order %.3f, theory %.3f\n", mu, cusp ? " at a cusp" : "", k,
                  order, theory);
    if (!(fabs(order - theory) <= allowed * theory))
        fail_msg("contact %d, degree %d: order %.3f, theory %.3f", mu, k, order, theory);
}

static void test_order(void **state)
{
    (void)state;
    const int most = REAL_BITS > 53 ? 5 : 3; /* in double too few widths lie between long arcs and rounding */
    for (int k = 2; k <= most; k++)
        for (int mu = 1; mu <= 4 && mu <= k; mu++)
            check_order(mu, false, k);
    for (int k = 2; k <= most; k++)
        for (int mu = 2; mu <= 3 && mu <= k; mu++)
            check_order(mu, true, k);
}

/* ---- near-contacts ---- */

/* Parabolic cubics with a gap of 2^-j at their contact, two meetings or none: fewer than 12 steps to 2^-bits.
 */
static void check_steps(const struct intersector *algorithm, int bits, int j, int side, bool opposite)
{
    static struct solver solver;
    static struct prop_curve a, b;
    real x[4] = {0, 1, 0, 0}, y[4] = {0, 0, 1, (real)3 / 10}, u[4] = {0, (real)6 / 5, (real)1 / 10, 0};
    real v[4] = {side * real_ldexp(1, -j), 0, opposite ? (real)-1 / 2 : (real)2 / 5, (real)1 / 5};
    power_to_curve(3, x, y, (real)37 / 100, &a);
    power_to_curve(3, u, v, (real)58 / 100, &b);
    solver_init(&solver, algorithm, 3, 3, WORKSPACE_ROOM);
    struct problem p = problem_of(&a.curve, &b.curve, real_ldexp(1, -bits), 1000);
    enum outcome o = solver_run(&solver, &p);
    int count = solver.answer.crossings.count, steps = solver.workspace.steps;
    assert_int_equal(o, SOLVED);
    assert_int_equal(count, side > 0 ? 2 : 0);
    if (steps >= 12)
        fail_msg("%s: %d steps at a gap of 2^-%d", algorithm->name, steps, j);
    solver_clear(&solver);
}

/* To 2^-200, or, in less precision, to what rounding allows at a contact. */
static void test_steps(void **state)
{
    (void)state;
    static const char *const names[] = {"gap_clipping_3", "gap_clipping_4", "gap_clipping_5"};
    const int bits = REAL_BITS > 1000 ? 200 : (REAL_BITS - 13) / 2, last = bits - 8;
    for (int k = 0; k < 3; k++)
        for (int j = 7; j <= last; j += 1 + j / 4)
            for (int side = -1; side <= 1; side += 2)
                for (int opposite = 0; opposite < 2; opposite++)
                    check_steps(intersector_find(names[k]), bits, j, side, opposite);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_planted), cmocka_unit_test(test_order),
                                       cmocka_unit_test(test_steps)};
    return cmocka_run_group_tests_name("gap", tests, NULL, NULL);
}
