/* Curves that are not in general position: nothing is lost and every call ends, whatever it says. */
#include "nasty.h"
#include "solving.h"

#include <math.h>

#include "../algorithms/core/bernstein.h"

enum {
    STEPS = REAL_BITS > 113  ? 100
            : REAL_BITS > 53 ? 1000
                             : 3000,
    PAIRS = REAL_BITS > 113  ? 3
            : REAL_BITS > 53 ? 10
                             : 60,
    SAMPLES = 16
};

static struct solver solver;

/* Is f(i / SAMPLES) = g(s) with s = a i / SAMPLES + b covered for all i with s in [0, 1]?  Without domains.
 */
static bool is_line_covered(const struct problem *p, real a, real b)
{
    for (int i = 0; i <= SAMPLES; i++) {
        real t = (real)i / SAMPLES, s = a * t + b;
        if (s >= 0 && s <= 1 && !is_covered(p, &solver, t, s))
            return false;
    }
    return true;
}

/* A pair of curves that share a line of solutions s = a t + b. */
struct shared {
    struct prop_curve f, g;
    real a, b;
};

typedef void make_shared(struct shared *p, struct random_state *r, int i);

/* What gives points without a proof may stay silent about overlaps, but not call that solved. */
static void check_shared(const char *what, make_shared *make)
{
    for (int k = 0; intersectors[k]; k++) {
        int outcomes[INVALID + 1] = {0};
        for (int i = 0; i < PAIRS; i++) {
            struct random_state r = random_for(1, what, (uint64_t)i);
            struct shared p;
            make(&p, &r, i);
            solver_init(&solver, intersectors[k], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            struct problem problem = problem_of(&p.f.curve, &p.g.curve, (real)1 / 1000000000, STEPS);
            enum outcome o = solver_run(&solver, &problem);
            outcomes[o]++;
            if (o == INVALID || (o != UNSUPPORTED && !is_line_covered(&problem, p.a, p.b)))
                fail_msg("%s: %s, but a part of the overlap of pair %d (%s) is lost", intersectors[k]->name,
                         outcome_name(o), i, what);
            solver_clear(&solver);
        }
        print_message("%-24s %s: %d solved, %d out of steps, %d out of room, %d unsupported\n",
                      intersectors[k]->name, what, outcomes[SOLVED], outcomes[OUT_OF_STEPS],
                      outcomes[OUT_OF_ROOM], outcomes[UNSUPPORTED]);
    }
}

/* The same curve twice, every other one backwards. */
static void make_twice(struct shared *p, struct random_state *r, int i)
{
    int n = nasty_degree(r, 8);
    prop_curve_make(&p->f, r, n, 12, i % 3 == 0);
    prop_curve_copy(&p->g, &p->f);
    for (int k = 0; i % 2 && k <= n; k++) {
        p->g.x[k] = p->f.x[n - k];
        p->g.y[k] = p->f.y[n - k];
        p->g.w[k] = p->f.w[n - k];
    }
    p->a = i % 2 ? -1 : 1;
    p->b = i % 2;
}

/* A half or a quarter of f, cut exactly: s = 2 t - b. */
static void make_part(struct shared *p, struct random_state *r, int i)
{
    int n = nasty_degree(r, 8);
    prop_curve_make(&p->f, r, n, 12, i % 3 == 0);
    prop_curve_copy(&p->g, &p->f);
    p->a = 1;
    p->b = 0;
    for (int cut = 0; cut <= i % 2; cut++) {
        real left[DEGREE_MAX + 1], right[DEGREE_MAX + 1], *c[3] = {p->g.x, p->g.y, p->g.w};
        bool second = random_bits(r) % 2;
        for (int k = 0; k < 3; k++) {
            bernstein_halve(n, 1, c[k], left, right);
            for (int j = 0; j <= n; j++)
                c[k][j] = second ? right[j] : left[j];
        }
        p->a = 2 * p->a;
        p->b = 2 * p->b - second;
    }
}

/* g is a point of f, all its control points equal: f(t) = g(s) for one t and all s.  f is polynomial. */
static void make_point(struct shared *p, struct random_state *r, int i)
{
    int n = nasty_degree(r, 8), m = nasty_degree(r, 8);
    real t = prop_unit(r, 2);
    prop_curve_make(&p->g, r, n, 20, false); /* exchanged: the curve is g, the point f, so t stands for all */
    prop_curve_make(&p->f, r, m, 20, i % 2);
    real x = bernstein_value(n, p->g.x, t), y = bernstein_value(n, p->g.y, t);
    for (int k = 0; k <= m; k++) {
        p->f.w[k] = real_ldexp(1, (int)random_between(r, -2, 2) * (i % 2));
        p->f.x[k] = p->f.w[k] * x;
        p->f.y[k] = p->f.w[k] * y;
    }
    p->a = 0;
    p->b = t;
}

/* Both the same point: a solution everywhere, here on the diagonal and on s = 1 - t. */
static void make_points(struct shared *p, struct random_state *r, int i)
{
    real x = prop_dyadic(r, 20), y = prop_dyadic(r, 20);
    prop_curve_make(&p->f, r, nasty_degree(r, 8), 20, false);
    prop_curve_make(&p->g, r, nasty_degree(r, 8), 20, false);
    for (int k = 0; k <= 8; k++) {
        p->f.x[k] = p->g.x[k] = i % 4 ? x : (real)0;
        p->f.y[k] = p->g.y[k] = i % 4 ? y : (real)0;
    }
    p->a = i % 2 ? -1 : 1;
    p->b = i % 2;
}

/* The Bernstein coefficients of the sum over j of c[j] (m t + k)^j, c[0] = c[1] = 0; exact where the powers'
 * coefficients are multiples of the binomials. */
static void put_powers(int n, const int64_t *c, int m, int k, real *out)
{
    for (int i = 0; i <= n; i++) {
        double sum = 0;
        for (int j = 2; j <= n; j++) { /* the blossom: i arguments m + k, n - i arguments k */
            double term = 0;
            for (int l = 0; l <= j && l <= i; l++)
                if (j - l <= n - i)
                    term += (double)binomial(i, l) * (double)binomial(n - i, j - l) * pow(m + k, l) *
                            pow(k, j - l);
            sum += (double)c[j] / (double)binomial(n, j) * term;
        }
        out[i] = real_ldexp((real)sum, -16);
    }
}

/* f has a cusp inside, at t = 1/4, where g begins or, i odd, ends; every other two g has it in the middle. */
static void make_from_cusp(struct shared *p, struct random_state *r, int i)
{
    const int n = 3 + i % 3, common = n == 3 ? 3 : n == 4 ? 12 : 10;
    int64_t x[6], y[6];
    for (int j = 0; j <= n; j++) {
        x[j] = j < 2 ? 0 : common * (int64_t)random_between(r, -9, 9);
        y[j] = j < 2 ? 0 : common * (int64_t)random_between(r, -9, 9);
    }
    if (x[2] * y[3] == x[3] * y[2]) { /* an ordinary cusp */
        x[2] = y[3] = common;
        x[3] = y[2] = 0;
    }
    prop_curve_make(&p->f, r, n, 12, false);
    prop_curve_make(&p->g, r, n, 12, false);
    put_powers(n, x, 4, -1, p->f.x);
    put_powers(n, y, 4, -1, p->f.y);
    int inside = i / 2 % 2, m = inside ? 4 : 2, back = i % 2;
    put_powers(n, x, back ? -m : m, inside ? (back ? 2 : -2) : back ? 2 : 0, p->g.x);
    put_powers(n, y, back ? -m : m, inside ? (back ? 2 : -2) : back ? 2 : 0, p->g.y);
    p->a = back ? -4 / m : 4 / m; /* 4 t - 1 = 2 s, 2 - 2 s, 4 s - 2 or 2 - 4 s */
    p->b = inside ? (back ? (real)3 / 4 : (real)1 / 4) : back ? (real)3 / 2 : (real)-1 / 2;
}

/* Beside the arc there is nothing at the cusp, and it takes no thousands of steps to say so. */
static void test_overlap_from_cusp(void **state)
{
    (void)state;
    const real tolerance = real_ldexp(1, -REAL_BITS * 9 / 16); /* 1e-9 in double */
    int most = 0, candidates = 0;
    for (int i = 0; REAL_BITS <= 113 && i < 5 * PAIRS; i++) {
        struct random_state r = random_for(1, "overlap from a cusp", (uint64_t)i);
        struct shared p;
        make_from_cusp(&p, &r, i);
        solver_init(&solver, intersector_find("certified"), p.f.curve.degree, p.g.curve.degree,
                    WORKSPACE_ROOM);
        struct problem problem = problem_of(&p.f.curve, &p.g.curve, tolerance, 100000);
        enum outcome o = solver_run(&solver, &problem);
        const struct crossings *out = &solver.answer.crossings;
        for (int k = 0; k < out->count; k++)
            candidates += out->at[k].standing == CANDIDATE;
        most = solver.workspace.steps > most ? solver.workspace.steps : most;
        if (o != SOLVED || out->overlaps != 1 || !is_line_covered(&problem, p.a, p.b))
            fail_msg("pair %d: %s after %d steps, %d overlaps, %d records", i, outcome_name(o),
                     solver.workspace.steps, out->overlaps, out->count);
        solver_clear(&solver);
    }
    print_message("at most %d steps, %d candidates\n", most, candidates);
    assert_true(candidates == 0 && most <= (REAL_BITS > 53 ? 16000 : 4000));
}

static void test_overlaps(void **state)
{
    (void)state;
    check_shared("curve twice", make_twice);
    check_shared("part of a curve", make_part);
    check_shared("part of a curve from a cusp", make_from_cusp);
}

static void test_points(void **state)
{
    (void)state;
    check_shared("point on a curve", make_point);
    check_shared("point twice", make_points);
}

/* A point off the curve by far: no record. */
static void test_far_point(void **state)
{
    (void)state;
    for (int k = 0; intersectors[k]; k++)
        for (int i = 0; i < PAIRS; i++) {
            struct random_state r = random_for(1, "far", (uint64_t)i);
            struct shared p;
            make_points(&p, &r, 1);
            prop_curve_make(&p.f, &r, nasty_degree(&r, 8), 20, i % 2);
            for (int j = 0; j <= p.g.curve.degree; j++)
                p.g.x[j] = 2;
            solver_init(&solver, intersectors[k], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            struct problem problem = problem_of(&p.f.curve, &p.g.curve, (real)1 / 1000000000, STEPS);
            enum outcome o = solver_run(&solver, &problem);
            assert_true(o == UNSUPPORTED || (o == SOLVED && solver.answer.crossings.count == 0));
            solver_clear(&solver);
        }
}

/* ---- one solution or two, known ---- */

typedef void make_single(struct planted *p, struct random_state *r, int i);

/* What gives points without a proof may lose one in twenty. */
static void check_single(const char *what, make_single *make, bool both_ends)
{
    for (int k = 0; intersectors[k]; k++) {
        int taken = 0, solved = 0, lost = 0;
        for (int i = 0; i < PAIRS; i++) {
            struct random_state r = random_for(1, what, (uint64_t)i);
            struct planted p;
            make(&p, &r, i);
            solver_init(&solver, intersectors[k], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            struct problem problem = problem_of(&p.f.curve, &p.g.curve, (real)1 / 1000000000, STEPS);
            enum outcome o = solver_run(&solver, &problem);
            taken += o != UNSUPPORTED;
            solved += o == SOLVED;
            if (o == INVALID ||
                (o != UNSUPPORTED && (!is_covered(&problem, &solver, p.t, p.s) ||
                                      (both_ends && !is_covered(&problem, &solver, 1 - p.t, p.s))))) {
                print_message("%s: %s, but the solution of pair %d (%s) is lost\n", intersectors[k]->name,
                              outcome_name(o), i, what);
                lost++;
            }
            solver_clear(&solver);
        }
        print_message("%-24s %s: %d of %d taken, %d solved, %d lost\n", intersectors[k]->name, what, taken,
                      PAIRS, solved, lost);
        assert_true(lost == 0 || (intersectors[k]->points_only && 20 * lost <= taken));
    }
}

static void move_g_to(struct planted *p, real t, real s)
{
    p->t = t;
    p->s = s;
    plant_by_moving(p);
}

/* f(0) = f(1), and g passes through it. */
static void make_closed(struct planted *p, struct random_state *r, int i)
{
    int n = 2 + nasty_degree(r, 6);
    (void)i;
    prop_curve_make(&p->f, r, n, 20, false);
    prop_curve_make(&p->g, r, nasty_degree(r, 8), 20, false);
    p->f.x[n] = p->f.x[0];
    p->f.y[n] = p->f.y[0];
    move_g_to(p, 0, prop_unit(r, 3));
}

static void put_on_line(struct prop_curve *c, int dx, int dy)
{
    for (int i = 0; i <= c->curve.degree; i++) {
        c->y[i] = dy * c->x[i];
        c->x[i] = dx * c->x[i];
    }
}

/* All control points of f, or of both, on lines; where these are the same the curves overlap. */
static void make_collinear(struct planted *p, struct random_state *r, int i)
{
    int dx = (int)random_between(r, -3, 3);
    prop_curve_make(&p->f, r, nasty_degree(r, 8), 20, false);
    prop_curve_make(&p->g, r, nasty_degree(r, 8), 20, false);
    put_on_line(&p->f, dx, 1);
    if (i % 2)
        put_on_line(&p->g, i % 4 == 1 ? dx : dx - 1, 1);
    move_g_to(p, prop_unit(r, 3), prop_unit(r, 3));
}

/* f is written in a degree too high by 1 to 24. */
static void make_elevated(struct planted *p, struct random_state *r, int i)
{
    int n = (int)random_between(r, 1, 4), more = 1 + i % 24;
    planted_make(p, r, n, nasty_degree(r, 8), 0);
    p->t = i % 2; /* the ends are kept whatever the rounding */
    plant_by_moving(p);
    bernstein_elevate(n, p->f.x, more, p->f.x);
    bernstein_elevate(n, p->f.y, more, p->f.y);
    p->f.curve.degree = n + more;
}

/* Control points repeated: at the start, at the end, or three times inside. */
static void make_repeated(struct planted *p, struct random_state *r, int i)
{
    int n = (int)random_between(r, 3, 8), from = i % 3 == 0 ? 0 : i % 3 == 1 ? n - 2 : n / 2 - 1;
    prop_curve_make(&p->f, r, n, 20, false);
    prop_curve_make(&p->g, r, nasty_degree(r, 8), 20, false);
    for (int k = 1; k < 3; k++) {
        p->f.x[from + k] = p->f.x[from];
        p->f.y[from + k] = p->f.y[from];
    }
    move_g_to(p, prop_unit(r, 3), prop_unit(r, 3));
}

static void test_closed(void **state)
{
    (void)state;
    check_single("closed", make_closed, true);
}

static void test_collinear(void **state)
{
    (void)state;
    check_single("collinear", make_collinear, false);
}

static void test_elevated(void **state)
{
    (void)state;
    check_single("elevated", make_elevated, false);
}

static void test_repeated(void **state)
{
    (void)state;
    check_single("repeated", make_repeated, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_overlaps), cmocka_unit_test(test_overlap_from_cusp),
        cmocka_unit_test(test_points),   cmocka_unit_test(test_far_point),
        cmocka_unit_test(test_closed),   cmocka_unit_test(test_collinear),
        cmocka_unit_test(test_elevated), cmocka_unit_test(test_repeated),
    };
    return cmocka_run_group_tests_name("degenerate", tests, NULL, NULL);
}
