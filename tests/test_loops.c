/* Where one curve crosses itself: cubics with a loop, without one, with a cusp and nearly with one, against
 * the closed form in rationals; and what is left as CANDIDATE of other curves. */
#include "solving.h"
#include "../harness/cases/number.h"

extern const struct intersector certified_loops;

enum { STEPS = REAL_BITS > 113 ? 1500 : REAL_BITS > 53 ? 4000 : STEPS_MAX };
enum { RUNS = REAL_BITS > 113 ? 20 : REAL_BITS > 53 ? 300 : 2000 };

static struct solver loops;

static enum outcome solve(int degree, const real *x, const real *y, const real *w, int max_steps)
{
    struct curve c = {degree, x, y, w, {0, 1}};
    struct problem p = problem_of(&c, &c, (real)1 / 1000000000000, max_steps);
    p.keep_order = true;
    return problem_solve(&p, &certified_loops, &loops.workspace, &loops.answer.crossings);
}

/* ---- the truth ---- */

/* 2 half = t + s; quarter = half^2 - t s, times 4 the discriminant; flat: D = 0. */
struct exact_loop {
    bool flat;
    mpq_t half, quarter;
};

/* cross of column i of x, y with column k. */
static void cross(mpq_t *x, mpq_t *y, int i, int k, mpq_t out)
{
    mpq_t other;
    mpq_init(other);
    mpq_mul(out, x[i], y[k]);
    mpq_mul(other, x[k], y[i]);
    mpq_sub(out, out, other);
    mpq_clear(other);
}

/* a, b, c of the power basis. */
static void power_basis(const real *p, mpq_t out[3])
{
    static const int by[3][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}};
    mpq_t a, k;
    mpq_inits(a, k, NULL);
    for (int i = 0; i < 3; i++) {
        mpq_set_ui(out[i], 0, 1);
        for (int j = 0; j < 4; j++) {
            real_to_rational(p[j], a);
            mpq_set_si(k, by[i][j], 1);
            mpq_mul(a, a, k);
            mpq_add(out[i], out[i], a);
        }
    }
    mpq_clears(a, k, NULL);
}

static void loop_init(struct exact_loop *z, const real *px, const real *py)
{
    mpq_t x[3], y[3], d, v;
    mpq_inits(z->half, z->quarter, d, v, NULL);
    for (int i = 0; i < 3; i++)
        mpq_inits(x[i], y[i], NULL);
    power_basis(px, x);
    power_basis(py, y);
    cross(x, y, 0, 1, d);
    z->flat = mpq_sgn(d) == 0;
    if (!z->flat) {
        cross(x, y, 2, 0, z->half);
        mpq_div(z->half, z->half, d);
        mpq_div_2exp(z->half, z->half, 1);
        cross(x, y, 1, 2, v);
        mpq_div(v, v, d); /* v = 3 half^2 + quarter */
        mpq_mul(z->quarter, z->half, z->half);
        mpq_set_ui(d, 3, 1);
        mpq_mul(z->quarter, z->quarter, d);
        mpq_sub(z->quarter, v, z->quarter);
    }
    for (int i = 0; i < 3; i++)
        mpq_clears(x[i], y[i], NULL);
    mpq_clears(d, v, NULL);
}

static void loop_clear(struct exact_loop *z)
{
    mpq_clears(z->half, z->quarter, NULL);
}

/* The sign of half + side h - at, h = sqrt(quarter) >= 0. */
static int compare_root(const struct exact_loop *z, int side, const mpq_t at)
{
    mpq_t off;
    mpq_init(off);
    mpq_sub(off, z->half, at);
    int sign = mpq_sgn(off);
    mpq_mul(off, off, off);
    int further = mpq_cmp(off, z->quarter); /* is |half - at| > h? */
    mpq_clear(off);
    return further > 0 ? sign : further == 0 ? (sign == side ? side : 0) : side;
}

static int compare_root_real(const struct exact_loop *z, int side, real at)
{
    mpq_t q;
    mpq_init(q);
    real_to_rational(at, q);
    int sign = compare_root(z, side, q);
    mpq_clear(q);
    return sign;
}

static bool loop_holds(const struct interval *t, const struct exact_loop *z, int side)
{
    return compare_root_real(z, side, t->lo) >= 0 && compare_root_real(z, side, t->hi) <= 0;
}

/* |quarter| < 2^-bits? */
static bool is_below(const struct exact_loop *z, int bits)
{
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    mpq_abs(a, z->quarter);
    mpq_set_ui(b, 1, 1);
    mpq_div_2exp(b, b, (mp_bitcnt_t)bits);
    bool below = mpq_cmp(a, b) < 0;
    mpq_clears(a, b, NULL);
    return below;
}

/* ---- cubics ---- */

static const char *check_border(const struct crossing *c)
{
    bool border = c->t.lo == 0 || c->t.hi == 1 || c->s.lo == 0 || c->s.hi == 1;
    return c->standing == UNIQUE ? "UNIQUE of a loop that is not there"
           : border              ? NULL
                                 : "a record of nothing";
}

/* NULL, or what is wrong with the answer. */
static const char *check(const struct exact_loop *z)
{
    const struct crossings *a = &loops.answer.crossings;
    const struct crossing *c = a->at;
    const int undecided = 2 * REAL_BITS - 50;
    bool cusp = is_below(z, undecided);
    if (a->count > 1 || a->overlaps > 0)
        return "more than one record";
    if (a->count == 1 && c->standing == CANDIDATE && !cusp)
        return "the sign of the discriminant was to be seen";
    if (mpq_sgn(z->quarter) <= 0)
        return a->count == 1 && c->standing != CANDIDATE ? "a loop where there is none" : NULL;
    bool inside = compare_root_real(z, -1, 0) >= 0 && compare_root_real(z, 1, 1) <= 0;
    if (!inside)
        return a->count == 1 ? check_border(c) : NULL;
    if (a->count == 0)
        return "the loop is missing";
    if (!loop_holds(&c->t, z, -1) || !loop_holds(&c->s, z, 1))
        return "the record is elsewhere";
    real wide = is_below(z, REAL_BITS / 2) ? real_ldexp(1, -REAL_BITS / 2) : 256 * REAL_EPSILON;
    return c->t.hi - c->t.lo > wide || c->s.hi - c->s.lo > wide ? "wider than it has to be" : NULL;
}

/* A cubic from a, b, c, which are multiples of 3, and d of one coordinate. */
static void control_points(real a, real b, real c, real d, real p[4])
{
    p[0] = d;
    p[1] = d + c / 3;
    p[2] = d + (2 * c + b) / 3;
    p[3] = d + a + b + c;
}

/* Loops for the parameters t1 and t2; a cusp if they are the same. */
static void planted(struct random_state *r, real t1, real t2, real p[4])
{
    real a = 3 * (real)(double)random_between(r, -40, 40), b = 3 * (real)(double)random_between(r, -40, 40);
    real d = (real)(double)random_between(r, -40, 40);
    control_points(a, b, -(a * (t1 * t1 + t1 * t2 + t2 * t2) + b * (t1 + t2)), d, p);
}

static const char *try_cubic(const real *x, const real *y, struct crossings *answer)
{
    struct exact_loop z;
    loop_init(&z, x, y);
    answer->count = 0;
    const char *wrong = NULL;
    if (!z.flat) { /* else it is no curve with a loop */
        wrong = solve(3, x, y, NULL, STEPS_MAX) == SOLVED ? check(&z) : "not SOLVED";
        answer->count = loops.answer.crossings.count;
        answer->at[0] = loops.answer.crossings.at[0];
    }
    loop_clear(&z);
    return wrong;
}

/* The same records of the curve run through the other way, with x and y exchanged, and moved, where that is
 * exact. */
static const char *try_motions(const real *x, const real *y, const struct crossings *first)
{
    static struct crossings other;
    real u[4], v[4];
    const struct crossing *a = first->at, *b = other.at;
    bool same = true;
    for (int i = 0; i < 4; i++) {
        u[i] = y[3 - i] + 1;
        v[i] = x[3 - i] - 2;
        same = same && u[i] - 1 == y[3 - i] && v[i] + 2 == x[3 - i];
    }
    const char *wrong = try_cubic(u, v, &other);
    if (wrong || !same)
        return wrong;
    bool border = first->count && (a->t.lo == 0 || a->s.hi == 1);
    if (border || (other.count && (b->t.lo == 0 || b->s.hi == 1)))
        return NULL;
    if (first->count != other.count)
        return "not the same number of records the other way round";
    if (!first->count)
        return NULL;
    bool meet =
        a->t.lo <= 1 - b->s.lo && 1 - b->s.hi <= a->t.hi && a->s.lo <= 1 - b->t.lo && 1 - b->t.hi <= a->s.hi;
    return a->standing != b->standing ? "another standing the other way round"
           : meet                     ? NULL
                                      : "elsewhere the other way round";
}

static void check_cubic(const char *kind, int run, const real *x, const real *y)
{
    static struct crossings answer;
    const char *wrong = try_cubic(x, y, &answer);
    wrong = wrong ? wrong : try_motions(x, y, &answer);
    if (wrong)
        fail_msg("%s %d: %s", kind, run, wrong);
}

static void random_cubics(void **state)
{
    (void)state;
    for (int run = 0; run < RUNS; run++) {
        struct random_state r = random_for(5, "random", (uint64_t)run);
        real x[4], y[4];
        for (int i = 0; i < 4; i++) {
            x[i] = prop_dyadic(&r, 20);
            y[i] = prop_dyadic(&r, 20);
        }
        check_cubic("random cubic", run, x, y);
    }
}

static void planted_loops(void **state)
{
    (void)state;
    for (int run = 0; run < RUNS; run++) {
        struct random_state r = random_for(5, "loop", (uint64_t)run);
        real t1 = (real)(double)random_between(&r, -4, 36) / 32,
             t2 = (real)(double)random_between(&r, -4, 36) / 32;
        real x[4], y[4];
        planted(&r, t1, t2, x);
        planted(&r, t1, t2, y);
        check_cubic("loop", run, x, y);
    }
}

/* Exact cusps: at most one record, and nothing of those outside [0, 1]. */
static void planted_cusps(void **state)
{
    int told = 0;
    (void)state;
    for (int run = 0; run < RUNS; run++) {
        struct random_state r = random_for(5, "cusp", (uint64_t)run);
        int k = (int)random_between(&r, -4, 36);
        real x[4], y[4];
        planted(&r, (real)k / 32, (real)k / 32, x);
        planted(&r, (real)k / 32, (real)k / 32, y);
        check_cubic("cusp", run, x, y);
        const struct crossings *a = &loops.answer.crossings; /* of the motion: from 1 to 0 */
        told += a->count;
        if ((k < 0 || k > 32) && a->count > 0)
            fail_msg("cusp %d: told outside the curve", run);
    }
    assert_true(told > RUNS / 4); /* rounding does hide which it is */
}

static void near_cusps(void **state)
{
    int some[2] = {0, 0};
    (void)state;
    for (int run = 0; run < RUNS; run++) {
        struct random_state r = random_for(5, "near", (uint64_t)run);
        int k = (int)random_between(&r, 1, 31), bits = (int)random_between(&r, 10, REAL_BITS > 53 ? 50 : 36);
        real x[4], y[4], off = real_ldexp(random_bits(&r) & 1 ? 1 : -1, -bits);
        planted(&r, (real)k / 32, (real)k / 32, x);
        planted(&r, (real)k / 32, (real)k / 32, y);
        int i = (int)random_between(&r, 0, 3);
        x[i] = x[i] + off;
        check_cubic("near cusp", run, x, y);
        some[loops.answer.crossings.count > 0]++;
    }
    assert_true(some[0] > RUNS / 20 && some[1] > RUNS / 20); /* both sides */
}

/* Cusps of small curves with few bits, so that 2^-50 beside them is exact in doubles too. */
static void nearest_cusps(void **state)
{
    (void)state;
    for (int bits = 10; bits <= 50; bits++)
        for (int i = 0; i < 8; i++)
            for (int side = -1; side <= 1; side += 2) {
                real x[4] = {0, 1, 0, 1}, y[4] = {0, 1, 1, 0};
                real *p = i < 4 ? &x[i] : &y[i - 4];
                *p = *p + real_ldexp(side, -bits);
                check_cubic("2^-", bits, x, y);
            }
}

/* ---- what has no closed form ---- */

static real widest_candidate(void)
{
    const struct crossings *a = &loops.answer.crossings;
    real widest_yet = 0;
    for (int i = 0; i < a->count; i++) {
        assert_int_equal(a->at[i].standing, CANDIDATE);
        widest_yet =
            real_max(widest_yet, real_max(a->at[i].t.hi - a->at[i].t.lo, a->at[i].s.hi - a->at[i].s.lo));
    }
    return widest_yet;
}

/* The cusp cubic with weights 1, 2, 4, 8 and as a curve of degree 4: few records around the cusp. */
static void other_cusps(void **state)
{
    const real x[4] = {0, 4, 0, 4}, y[4] = {0, 4, 4, 0};
    real u[5], v[5], w[5];
    (void)state;
    for (int i = 0; i <= 4; i++) {
        u[i] = i == 0 ? x[0] : i == 4 ? x[3] : ((real)i * x[i - 1] + (real)(4 - i) * x[i]) / 4;
        v[i] = i == 0 ? y[0] : i == 4 ? y[3] : ((real)i * y[i - 1] + (real)(4 - i) * y[i]) / 4;
    }
    solve(4, u, v, NULL, STEPS);
    assert_true(loops.answer.crossings.count >= 1 && loops.answer.crossings.count <= 32);
    assert_true(widest_candidate() < (real)1 / 4096);
    for (int i = 0; i < 4; i++) {
        w[i] = real_ldexp(1, i);
        u[i] = x[i] * w[i];
        v[i] = y[i] * w[i];
    }
    solve(3, u, v, w, STEPS);
    assert_true(loops.answer.crossings.count >= 1 && loops.answer.crossings.count <= 32);
    assert_true(widest_candidate() < (real)1 / 4096);
}

/* A line there and back: f(t) = f(1 - t) for all t. */
static void folds(void **state)
{
    const real x[4] = {0, 2, 2, 0}, y[4] = {0, 1, 1, 0};
    (void)state;
    solve(3, x, y, NULL, STEPS);
    const struct crossings *a = &loops.answer.crossings;
    assert_int_equal(a->count, 1);
    assert_int_equal(a->at[0].standing, CANDIDATE);
    for (int k = 0; k <= 8; k++) {
        real t = (real)k / 16;
        assert_true(a->at[0].t.lo <= t && t <= a->at[0].t.hi && a->at[0].s.lo <= 1 - t &&
                    1 - t <= a->at[0].s.hi);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_cubics), cmocka_unit_test(planted_loops), cmocka_unit_test(planted_cusps),
        cmocka_unit_test(near_cusps),    cmocka_unit_test(nearest_cusps), cmocka_unit_test(other_cusps),
        cmocka_unit_test(folds),
    };
    solver_init(&loops, &certified_loops, 4, 4, 1);
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    solver_clear(&loops);
    return failed;
}
