/* Weights far from 1: a common factor changes no bit of an answer, great ratios lose no solution, and beyond
 * the ratio allowed there is no problem. */
#include "nasty.h"
#include "solving.h"

enum { TRIALS = REAL_BITS > 113 ? 3 : REAL_BITS > 53 ? 12 : 60, STEPS = REAL_BITS > 53 ? 200 : 1000 };

/* All of c's homogeneous coordinates times 2^e: the same curve. */
static void multiply(struct prop_curve *c, int e)
{
    for (int i = 0; i <= c->curve.degree && c->curve.w; i++) {
        c->x[i] = real_ldexp(c->x[i], e);
        c->y[i] = real_ldexp(c->y[i], e);
        c->w[i] = real_ldexp(c->w[i], e);
    }
}

static bool same_interval(const struct interval *a, const struct interval *b)
{
    return a->lo == b->lo && a->hi == b->hi;
}

static bool same_records(const struct crossings *a, const struct crossings *b)
{
    bool same = a->count == b->count && a->overlaps == b->overlaps;
    for (int i = 0; same && i < a->count; i++)
        same = same_interval(&a->at[i].t, &b->at[i].t) && same_interval(&a->at[i].s, &b->at[i].s) &&
               a->at[i].standing == b->at[i].standing;
    return same;
}

static void compare(const struct intersector *a, struct planted *p, int e_f, int e_g, int i)
{
    struct problem q = problem_of(&p->f.curve, &p->g.curve, (real)1 / 1000000000, STEPS);
    static struct solver plain, weighted;
    solver_init(&plain, a, p->f.curve.degree, p->g.curve.degree, WORKSPACE_ROOM);
    solver_init(&weighted, a, p->f.curve.degree, p->g.curve.degree, WORKSPACE_ROOM);
    enum outcome before = solver_run(&plain, &q);
    multiply(&p->f, e_f);
    multiply(&p->g, e_g);
    enum outcome after = solver_run(&weighted, &q);
    multiply(&p->f, -e_f);
    multiply(&p->g, -e_g);
    if (before != after || !same_records(&plain.answer.crossings, &weighted.answer.crossings))
        fail_msg("%s: pair %d, weights times 2^%d and 2^%d: another answer", a->name, i, e_f, e_g);
    if (before != UNSUPPORTED && !is_covered(&q, &weighted, p->t, p->s))
        fail_msg("%s: pair %d lost its solution", a->name, i);
    solver_clear(&plain);
    solver_clear(&weighted);
}

static void test_common_factor(void **state)
{
    (void)state;
    static const int factors[] = {-900, -300, -200, -60, -46, -40, 1, 20, 50, 60, 200, 300, 900};
    const uint64_t many = sizeof factors / sizeof *factors;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(1, "weights", (uint64_t)i);
        struct planted p;
        planted_make(&p, &r, (int)random_between(&r, 1, 8), (int)random_between(&r, 2, 8), 1 + i % 2);
        int e_f = factors[random_bits(&r) % many], e_g = factors[random_bits(&r) % many];
        for (int k = 0; intersectors[k]; k++)
            compare(intersectors[k], &p, e_f, e_g, i);
    }
}

/* Both curves begin at one point, with weights 2^-250 to 1. */
static void make_steep(struct planted *p, struct random_state *r)
{
    prop_curve_make(&p->f, r, (int)random_between(r, 2, 8), 20, true);
    prop_curve_make(&p->g, r, (int)random_between(r, 2, 8), 20, true);
    real x = prop_dyadic(r, 10), y = prop_dyadic(r, 10);
    struct prop_curve *both[2] = {&p->f, &p->g};
    for (int k = 0; k < 2; k++) {
        struct prop_curve *c = both[k];
        c->x[0] = c->w[0] * x;
        c->y[0] = c->w[0] * y;
        for (int i = 0; i <= c->curve.degree; i++) {
            int e = random_bits(r) % 2 ? 0 : (int)random_between(r, -250, 0);
            c->x[i] = real_ldexp(c->x[i], e);
            c->y[i] = real_ldexp(c->y[i], e);
            c->w[i] = real_ldexp(c->w[i], e);
        }
    }
    p->t = p->s = 0;
}

static void test_great_ratios(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(2, "weights", (uint64_t)i);
        struct planted p;
        make_steep(&p, &r);
        assert_true(is_planted(&p));
        struct problem q = problem_of(&p.f.curve, &p.g.curve, (real)1 / 1000000000, STEPS);
        for (int k = 0; intersectors[k]; k++) {
            static struct solver z;
            if (intersectors[k]->points_only)
                continue;
            solver_init(&z, intersectors[k], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            if (solver_run(&z, &q) != UNSUPPORTED && !is_covered(&q, &z, p.t, p.s))
                fail_msg("%s: pair %d lost its solution", intersectors[k]->name, i);
            solver_clear(&z);
        }
    }
}

static void test_ratio_beyond_the_limit(void **state)
{
    (void)state;
    for (int beyond = 0; beyond < 2; beyond++) {
        struct random_state r = random_for(3, "weights", (uint64_t)beyond);
        struct planted p;
        static struct solver z;
        planted_make(&p, &r, 3, 3, 2);
        for (int i = 0; i <= 3; i++)
            p.f.x[i] = p.f.y[i] = p.f.w[i] = 1;
        p.f.x[2] = p.f.y[2] = p.f.w[2] = real_ldexp(1, -256 - beyond);
        struct problem q = problem_of(&p.f.curve, &p.g.curve, (real)1 / 1000000000, STEPS);
        solver_init(&z, intersectors[0], 3, 3, WORKSPACE_ROOM);
        assert_true((solver_run(&z, &q) == INVALID) == (beyond == 1));
        solver_clear(&z);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_common_factor),
        cmocka_unit_test(test_great_ratios),
        cmocka_unit_test(test_ratio_beyond_the_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
