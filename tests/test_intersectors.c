/* Every intersector: no planted solution is lost, whatever the degrees, weights, domains, tolerance, steps
 * and room; every answer is well-formed; bad problems are refused; nothing is written outside the workspace.
 */
#include "nasty.h"
#include "solving.h"

enum { STEPS = REAL_BITS > 113 ? 150 : REAL_BITS > 53 ? 2000 : 20000 };

static struct solver solver;

/* Tolerances of every pair; the last is the least that is promised. */
static real tolerance(int i)
{
    return i == 0 ? (real)1 / 1000000 : i == 1 ? (real)1 / 1000000000000LL : 64 * REAL_EPSILON;
}

struct limits {
    int steps, room;
};

struct tally {
    int solved, unsupported, unfinished, lost;
};

/* Solves p at each tolerance; says which solution was lost. */
static void solve_planted(const struct intersector *a, const struct planted *p, int i,
                          const struct limits *limits, struct tally *tally)
{
    solver_init(&solver, a, p->f.curve.degree, p->g.curve.degree, limits->room);
    for (int k = 0; k < 3; k++) {
        struct problem problem = problem_of(&p->f.curve, &p->g.curve, tolerance(k), limits->steps);
        enum outcome o = solver_run(&solver, &problem);
        assert_true(o != INVALID);
        tally->solved += o == SOLVED;
        tally->unsupported += o == UNSUPPORTED;
        tally->unfinished += o == OUT_OF_STEPS || o == OUT_OF_ROOM;
        if (o != UNSUPPORTED && !is_covered(&problem, &solver, p->t, p->s)) {
            print_message("%s: %s, but lost the solution of pair %d, degrees %d and %d, at tolerance %g\n",
                          a->name, outcome_name(o), i, p->f.curve.degree, p->g.curve.degree,
                          real_to_double(tolerance(k)));
            tally->lost++;
        }
    }
    solver_clear(&solver);
}

/* Nothing is lost, but one in a hundred by what gives points without a proof. */
static void judge(const struct intersector *a, const char *what, const struct tally *t)
{
    print_message("%-24s %s: %d solved, %d unfinished, %d unsupported, %d lost\n", a->name, what, t->solved,
                  t->unfinished, t->unsupported, t->lost);
    assert_true(t->lost <= (a->points_only ? t->solved / 100 : 0));
}

typedef void make_function(struct planted *p, struct random_state *r, int i);

static void solve_many(const char *what, make_function *make, int count, const struct limits *limits)
{
    for (int k = 0; intersectors[k]; k++) {
        struct tally tally = {0, 0, 0, 0};
        for (int i = 0; i < count; i++) {
            struct random_state r = random_for(1, what, (uint64_t)i);
            struct planted p;
            make(&p, &r, i);
            solve_planted(intersectors[k], &p, i, &limits[i % 5], &tally);
        }
        judge(intersectors[k], what, &tally);
    }
}

static const struct limits plenty[5] = {{STEPS, WORKSPACE_ROOM},
                                        {STEPS, WORKSPACE_ROOM},
                                        {STEPS, WORKSPACE_ROOM},
                                        {STEPS, WORKSPACE_ROOM},
                                        {STEPS, WORKSPACE_ROOM}};

/* A quarter with one rational curve, a quarter with two, a third over other domains. */
static void make_any(struct planted *p, struct random_state *r, int i)
{
    int rational = i % 4 > 1 ? i % 4 - 1 : 0;
    planted_make(p, r, nasty_degree(r, 8), nasty_degree(r, 8), rational);
    if (i % 3 == 0)
        planted_domains(p, r);
}

static void test_random(void **state)
{
    (void)state;
    solve_many("random", make_any, trials(280), plenty);
}

static void make_high(struct planted *p, struct random_state *r, int i)
{
    (void)i;
    int most = REAL_BITS > 113 ? 10 : DEGREE_MAX;
    planted_make(p, r, (int)random_between(r, 9, most), nasty_degree(r, most), 0);
}

static void test_high_degree(void **state)
{
    (void)state;
    solve_many("high degree", make_high, REAL_BITS > 113 ? 1 : REAL_BITS > 53 ? 4 : 40, plenty);
}

/* What is undecided when steps or room run out is among the records. */
static void test_limits(void **state)
{
    (void)state;
    static const struct limits tight[5] = {{1, 1}, {7, 8}, {30, WORKSPACE_ROOM}, {100, 5}, {1000, 16}};
    solve_many("limits", make_any, trials(280), tight);
}

/* Of pairs of degree product up to 9 over [0, 1], no intersector refuses more than one in a hundred. */
static void make_small(struct planted *p, struct random_state *r, int i)
{
    int n = 1 + (int)(random_bits(r) % 9);
    planted_make(p, r, n, (int)random_between(r, 1, 9 / n), 0);
    (void)i;
}

static void test_supported(void **state)
{
    (void)state;
    for (int k = 0; intersectors[k]; k++) {
        struct tally tally = {0, 0, 0, 0};
        for (int i = 0; i < trials(200); i++) {
            struct random_state r = random_for(1, "small", (uint64_t)i);
            struct planted p;
            make_small(&p, &r, i);
            solve_planted(intersectors[k], &p, i, plenty, &tally);
        }
        judge(intersectors[k], "small", &tally);
        assert_true(100 * tally.unsupported <= tally.solved + tally.unfinished);
    }
}

/* ---- what is not a problem ---- */

enum { MISTAKES = 19 };

/* Makes mistake k in p, whose curve f is rational of degree 3 with the coefficients of `f`. */
static void spoil(int k, struct problem *p, struct prop_curve *f, struct random_state *r)
{
    const real infinite = REAL_HUGE * 2, nan = infinite - infinite;
    struct curve *c = &p->f;
    switch (k) {
    case 0:
        c->degree = 0;
        break;
    case 1:
        c->degree = DEGREE_MAX + 1;
        break;
    case 2:
        c->degree = -1;
        break;
    case 3:
        p->tolerance = 0;
        break;
    case 4:
        p->tolerance = -1;
        break;
    case 5:
        p->tolerance = nan;
        break;
    case 6:
        p->tolerance = infinite;
        break;
    case 7:
        p->max_steps = 0;
        break;
    case 8:
        f->x[1] = nan;
        break;
    case 9:
        f->y[0] = infinite;
        break;
    case 10:
        f->w[1] = 0;
        break;
    case 11:
        f->w[0] = -1;
        break;
    case 12:
        f->w[c->degree] = nan;
        break;
    case 13:
        f->w[c->degree] = infinite;
        break;
    case 14:
        c->domain.hi = c->domain.lo;
        break;
    case 15:
        c->domain.lo = nan;
        break;
    case 16:
        c->domain.hi = infinite;
        break;
    case 17: /* weights that differ too much */
        f->w[1] = real_ldexp(f->w[0], random_bits(r) % 2 ? 260 : -260);
        break;
    default: /* a width that is not finite */
        c->domain.lo = -REAL_HUGE;
        c->domain.hi = REAL_HUGE;
        break;
    }
}

static void test_invalid(void **state)
{
    (void)state;
    for (int a = 0; intersectors[a]; a++)
        for (int i = 0; i < 2 * MISTAKES; i++) {
            struct random_state r = random_for(1, "invalid", (uint64_t)i);
            struct prop_curve f, g;
            prop_curve_make(&f, &r, 3, 20, true);
            prop_curve_make(&g, &r, 2, 20, i % 2);
            solver_init(&solver, intersectors[a], DEGREE_MAX, DEGREE_MAX, WORKSPACE_ROOM);
            struct problem p = problem_of(&f.curve, &g.curve, tolerance(0), STEPS);
            spoil(i % MISTAKES, &p, &f, &r);
            if (i >= MISTAKES) {
                struct curve c = p.f;
                p.f = p.g;
                p.g = c;
            }
            if (solver_run(&solver, &p) != INVALID)
                fail_msg("%s took mistake %d", intersectors[a]->name, i);
            solver_clear(&solver);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),    cmocka_unit_test(test_high_degree), cmocka_unit_test(test_limits),
        cmocka_unit_test(test_supported), cmocka_unit_test(test_invalid),
    };
    return cmocka_run_group_tests_name("intersectors", tests, NULL, NULL);
}
