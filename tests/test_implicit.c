/* The resultant against exact arithmetic, coefficient by coefficient; inversion; curves in too high a degree.
 */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/bernstein.h"
#include "../algorithms/core/implicit.h"
#include "../algorithms/core/lowered.h"
#include "../algorithms/core/patch.h"
#include "../algorithms/core/roots.h"

enum { LOWER = 4, HIGHER = 6, PRODUCT = LOWER * HIGHER, SCRATCH = 1 << 17 };

static real scratch[SCRATCH];

/* ---- exact arithmetic ---- */

/* Homogeneous coordinates of b at z = v / (1 - v), times (1 + z)^degree. */
static void exact_point(const struct polygon *b, long z, mpq_t *point)
{
    mpq_t w, term, coordinate;
    mpq_inits(w, term, coordinate, NULL);
    for (int k = 0; k < 3; k++)
        mpq_set_si(point[k], 0, 1);
    for (int i = b->degree; i >= 0; i--) {
        real_to_rational(b->w ? b->w[i] : (real)1, w);
        real_to_rational(binomial(b->degree, i), term);
        mpq_mul(w, w, term);
        for (int k = 0; k < 3; k++) {
            mpq_set_si(term, z, 1);
            mpq_mul(point[k], point[k], term);
            real_to_rational(k == 0 ? b->x[i] : k == 1 ? b->y[i] : (real)1, coordinate);
            mpq_mul(coordinate, coordinate, w);
            mpq_add(point[k], point[k], coordinate);
        }
    }
    mpq_clears(w, term, coordinate, NULL);
}

/* C(d, i) w_i (W x_i - X) and the same with y, for a point (X, Y, W): the two forms whose resultant is
 * wanted. */
static void exact_forms(const struct polygon *a, mpq_t *point, mpq_t *p, mpq_t *q)
{
    mpq_t w, b;
    mpq_inits(w, b, NULL);
    for (int i = 0; i <= a->degree; i++) {
        real_to_rational(a->w ? a->w[i] : (real)1, w);
        real_to_rational(binomial(a->degree, i), b);
        mpq_mul(w, w, b);
        for (int k = 0; k < 2; k++) {
            mpq_t *form = k == 0 ? p : q;
            real_to_rational(k == 0 ? a->x[i] : a->y[i], b);
            mpq_mul(b, b, point[2]);
            mpq_sub(b, b, point[k]);
            mpq_mul(form[i], b, w);
        }
    }
    mpq_clears(w, b, NULL);
}

/* Determinant of an n x n matrix by elimination. */
static void exact_determinant(int n, mpq_t *m, mpq_t out)
{
    mpq_t factor, term;
    mpq_inits(factor, term, NULL);
    mpq_set_si(out, 1, 1);
    for (int k = 0; k < n; k++) {
        int pivot = k;
        while (pivot < n && mpq_sgn(m[pivot * n + k]) == 0)
            pivot++;
        if (pivot == n) {
            mpq_set_si(out, 0, 1);
            break;
        }
        for (int j = 0; j < n && pivot != k; j++)
            mpq_swap(m[pivot * n + j], m[k * n + j]);
        if (pivot != k)
            mpq_neg(out, out);
        mpq_mul(out, out, m[k * n + k]);
        for (int i = k + 1; i < n; i++) {
            mpq_div(factor, m[i * n + k], m[k * n + k]);
            for (int j = k; j < n; j++) {
                mpq_mul(term, factor, m[k * n + j]);
                mpq_sub(m[i * n + j], m[i * n + j], term);
            }
        }
    }
    mpq_clears(factor, term, NULL);
}

/* Sylvester's determinant of two forms of degree d, of another shape than Bezout's. */
static void exact_sylvester(int d, mpq_t *p, mpq_t *q, mpq_t out)
{
    mpq_t m[4 * LOWER * LOWER];
    rationals_init(4 * d * d, m);
    for (int i = 0; i < d; i++) {
        for (int j = 0; j <= d; j++) {
            mpq_set(m[i * 2 * d + i + j], p[j]);
            mpq_set(m[(d + i) * 2 * d + i + j], q[j]);
        }
    }
    exact_determinant(2 * d, m, out);
    rationals_clear(4 * d * d, m);
}

/* Newton's interpolation at 0, 1, ..., n, then coefficients of z^k divided by C(n, k). */
static void exact_interpolate(int n, mpq_t *f)
{
    mpq_t term;
    mpq_init(term);
    for (int k = 0; k < n; k++) {
        for (int i = n; i > k; i--) {
            mpq_sub(f[i], f[i], f[i - 1]);
            mpq_set_si(term, 1, k + 1);
            mpq_mul(f[i], f[i], term);
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int i = k; i < n; i++) {
            mpq_set_si(term, k, 1);
            mpq_mul(term, term, f[i + 1]);
            mpq_sub(f[i], f[i], term);
        }
    }
    for (int i = 0; i <= n; i++) {
        mpq_set_si(term, 1, 1);
        mpz_bin_uiui(mpq_denref(term), n, i);
        mpq_mul(f[i], f[i], term);
    }
    mpq_clear(term);
}

/* Bernstein coefficients of the resultant; f: d e + 1 of them.  Bezout's determinant has Sylvester's value up
 * to a sign that depends on d only, times the weight of the point to the power d, which Sylvester has twice.
 */
static void exact_resultant(const struct polygon *a, const struct polygon *b, mpq_t *f)
{
    const int d = a->degree, n = d * b->degree;
    mpq_t p[LOWER + 1], q[LOWER + 1], point[3];
    rationals_init(d + 1, p);
    rationals_init(d + 1, q);
    rationals_init(3, point);
    for (int z = 0; z <= n; z++) {
        exact_point(b, z, point);
        exact_forms(a, point, p, q);
        exact_sylvester(d, p, q, f[z]);
        for (int k = 0; k < d; k++)
            mpq_div(f[z], f[z], point[2]);
    }
    exact_interpolate(n, f);
    rationals_clear(d + 1, p);
    rationals_clear(d + 1, q);
    rationals_clear(3, point);
}

/* ---- inputs ---- */

struct random_polygon {
    real x[HIGHER + 1], y[HIGHER + 1], w[HIGHER + 1];
    struct polygon polygon;
};

static void polygon_make(struct random_polygon *p, struct random_state *r, int degree)
{
    int bits = (int)random_between(r, 3, 50);
    bool rational = random_bits(r) % 2, full = random_bits(r) % 3 == 0;
    for (int i = 0; i <= degree; i++) {
        p->x[i] = full ? prop_bits(r, 1) : prop_dyadic(r, bits);
        p->y[i] = full ? prop_bits(r, 1) : prop_dyadic(r, bits);
        p->w[i] = real_ldexp((real)1 + prop_unit(r, 10), (int)random_between(r, -3, 3));
    }
    struct polygon q = {degree, p->x, p->y, rational ? p->w : NULL, 0};
    p->polygon = q;
}

/* ---- properties ---- */

/* Is |sign c - exact| <= error / slack, coefficient by coefficient?  exact[n + 1] is scratch. */
static bool is_bounded(int n, const real *c, const real *error, mpq_t *exact, int sign, long slack)
{
    bool all = true;
    mpq_t off, bound;
    mpq_inits(off, bound, NULL);
    for (int i = 0; i <= n; i++) {
        real_to_rational(sign * c[i], off);
        mpq_sub(off, off, exact[i]);
        mpq_abs(off, off);
        real_to_rational(error[i], bound);
        mpq_set_si(exact[n + 1], slack, 1);
        mpq_mul(off, off, exact[n + 1]);
        all = all && mpq_cmp(off, bound) <= 0;
    }
    mpq_clears(off, bound, NULL);
    return all;
}

typedef void resultant_function(const struct polygon *, const struct polygon *, real *, real *, real *);

static void check_resultant(resultant_function *resultant, const char *name, int cases, long slack,
                            int *tight)
{
    mpq_t exact[PRODUCT + 2];
    rationals_init(PRODUCT + 2, exact);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(1, name, (uint64_t)i);
        struct random_polygon a, b;
        real c[PRODUCT + 1], error[PRODUCT + 1];
        int d = (int)random_between(&r, 1, LOWER), e = (int)random_between(&r, 1, HIGHER), sign;
        polygon_make(&a, &r, d);
        polygon_make(&b, &r, e);
        resultant(&a.polygon, &b.polygon, scratch, c, error);
        exact_resultant(&a.polygon, &b.polygon, exact);
        sign = is_bounded(d * e, c, error, exact, 1, 1) ? 1 : -1;
        if (!is_bounded(d * e, c, error, exact, sign, 1))
            fail_msg("%s %d: degrees %d and %d", name, i, d, e);
        *tight += !is_bounded(d * e, c, error, exact, sign, slack);
    }
    rationals_clear(PRODUCT + 2, exact);
}

/* The bound holds, and it is not idle: a bound 2^12 times smaller would be exceeded now and then. */
static void test_resultant(void **state)
{
    (void)state;
    int tight = 0;
    check_resultant(implicit_resultant, "resultant", trials(1000), 4096, &tight);
    assert_true(tight > 0);
}

static void test_by_nodes(void **state)
{
    (void)state;
    int tight = 0;
    assert_true(implicit_by_nodes_scratch(LOWER, HIGHER) <= SCRATCH);
    check_resultant(implicit_by_nodes, "by nodes", trials(400), 1, &tight);
}

/* A point of a, rounded: the parameter is inverted or owned up to be ambiguous, and mostly it is inverted. */
static void test_inversion(void **state)
{
    (void)state;
    int inverted = 0, cases = trials(2000);
    for (int i = 0; i < cases; i++) {
        struct random_state r = random_for(2, "inversion", (uint64_t)i);
        struct random_polygon a;
        int d = (int)random_between(&r, 2, LOWER);
        polygon_make(&a, &r, d);
        a.polygon.w = NULL;
        real u = nasty_unit(&r), lo, hi, radius = 8 * d * REAL_EPSILON;
        real x = bernstein_value(d, a.x, u), y = bernstein_value(d, a.y, u);
        enum inversion found = implicit_invert(&a.polygon, x, y, radius, scratch, &lo, &hi);
        if (found == NOWHERE || (found == INVERTED && !(lo <= u && u <= hi)))
            fail_msg("inversion %d: degree %d", i, d);
        inverted += found == INVERTED && hi - lo < real_ldexp(1, -20);
    }
    assert_true(inverted > cases * 9 / 10);
}

/* The loop (t^2, t^3 - t) shifted to [0, 1]: parameters 0 and 1 share the point; both must stay. */
static void test_double_point(void **state)
{
    (void)state;
    const real x[4] = {1, (real)-1 / 3, (real)-1 / 3, 1}, y[4] = {0, (real)4 / 3, (real)-4 / 3, 0};
    const struct polygon a = {3, x, y, NULL, 2 * REAL_EPSILON};
    const struct arc arc = {3, x, y, NULL, 2 * REAL_EPSILON};
    real lo, hi;
    struct lowered curve;
    struct patch point;
    struct interval u[MEETINGS_MAX];
    assert_int_equal(implicit_invert(&a, 1, 0, 8 * REAL_EPSILON, scratch, &lo, &hi), AMBIGUOUS);
    lowered_init(&arc, 2, &curve);
    patch_cut(&curve, 0, 0, &point);
    int count = patch_meet(&point, &curve, 64 * REAL_EPSILON, scratch, u);
    assert_int_equal(count, 2);
    assert_true(u[0].lo == 0 && u[0].hi < real_ldexp(1, -40) && u[1].hi == 1 &&
                u[1].lo > 1 - real_ldexp(1, -40));
}

/* patch_meet keeps every parameter of a that lies on the patch: both curves are cut from one. */
static void test_patch(void **state)
{
    (void)state;
    for (int i = 0; i < trials(2000); i++) {
        struct random_state r = random_for(3, "patch", (uint64_t)i);
        struct random_polygon a;
        struct interval v = nasty_interval(&r), u[MEETINGS_MAX];
        struct lowered curve;
        struct patch h;
        int d = (int)random_between(&r, 1, HIGHER);
        polygon_make(&a, &r, d);
        const struct arc arc = {d, a.x, a.y, a.polygon.w, 0};
        lowered_init(&arc, 16, &curve);
        patch_cut(&curve, v.lo, v.hi, &h);
        int count = patch_meet(&h, &curve, real_ldexp(1, -40), scratch, u), held[2] = {0, 0};
        for (int j = 0; j < count; j++) {
            held[0] += u[j].lo <= v.lo && v.lo <= u[j].hi;
            held[1] += u[j].lo <= v.hi && v.hi <= u[j].hi;
        }
        if (!held[0] || !held[1])
            fail_msg("patch %d: degree %d", i, d);
    }
}

/* Elevated by one to three degrees the implicit equation vanishes; lowered, the curve is what it was. */
static void test_elevated(void **state)
{
    (void)state;
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(4, "elevated", (uint64_t)i);
        struct random_polygon a, b;
        int d = (int)random_between(&r, 1, 3), more = (int)random_between(&r, 1, 3), n = d + more;
        real x[HIGHER + 1], y[HIGHER + 1], c[HIGHER * HIGHER + 1], error[HIGHER * HIGHER + 1];
        struct lowered lowered;
        polygon_make(&a, &r, d);
        polygon_make(&b, &r, 3);
        bernstein_elevate(d, a.x, more, x);
        bernstein_elevate(d, a.y, more, y);
        const struct arc high = {n, x, y, NULL, 0};
        const struct polygon p = {n, x, y, NULL, 16 * REAL_EPSILON};
        assert_true(implicit_scratch(n, 3) <= SCRATCH);
        implicit_resultant(&p, &b.polygon, scratch, c, error);
        assert_true(implicit_vanishes(3 * n, c, error));
        lowered_init(&high, 2, &lowered);
        assert_true(lowered.reduced && lowered.polygon.degree <= d);
        for (int k = 0; k <= d && lowered.polygon.degree == d; k++) {
            assert_true(real_abs(lowered.polygon.x[k] - a.x[k]) <= 4096 * REAL_EPSILON);
            assert_true(real_abs(lowered.polygon.y[k] - a.y[k]) <= 4096 * REAL_EPSILON);
        }
    }
}

/* Two parts of one curve: the resultant is 0 to within its errors. */
static void test_same_carrier(void **state)
{
    (void)state;
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(5, "carrier", (uint64_t)i);
        struct random_polygon a, b;
        real c[LOWER * LOWER + 1], error[LOWER * LOWER + 1];
        struct interval v = nasty_interval(&r);
        int d = (int)random_between(&r, 1, LOWER);
        polygon_make(&a, &r, d);
        a.polygon.w = NULL;
        bernstein_restrict(d, 1, a.x, v.lo, v.hi, b.x);
        bernstein_restrict(d, 1, a.y, v.lo, v.hi, b.y);
        const struct polygon part = {d, b.x, b.y, NULL, 8 * d * REAL_EPSILON};
        implicit_resultant(&a.polygon, &part, scratch, c, error);
        assert_true(implicit_vanishes(d * d, c, error));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_resultant),    cmocka_unit_test(test_by_nodes),
        cmocka_unit_test(test_inversion),    cmocka_unit_test(test_double_point),
        cmocka_unit_test(test_patch),        cmocka_unit_test(test_elevated),
        cmocka_unit_test(test_same_carrier),
    };
    return cmocka_run_group_tests_name("implicit", tests, NULL, NULL);
}
