/* Exchanging f and g, and scaling by powers of two, changes no bit of an answer. */
#include "nasty.h"
#include "solving.h"

#include "../algorithms/crossings.h"

enum {
    PAIRS = REAL_BITS > 113  ? 3
            : REAL_BITS > 53 ? 40
                             : 200,
    STEPS = REAL_BITS > 113  ? 600
            : REAL_BITS > 53 ? 2000
                             : 20000
};

static struct solver first, second;

static void make(struct planted *p, struct random_state *r, int i)
{
    int rational = i % 4 > 1 ? i % 4 - 1 : 0;
    planted_make(p, r, nasty_degree(r, 8), nasty_degree(r, 8), rational);
    if (i % 3 == 0)
        planted_domains(p, r);
}

static enum outcome solve(struct solver *z, const struct planted *p)
{
    struct problem problem = problem_of(&p->f.curve, &p->g.curve, (real)1 / 1000000000, STEPS);
    return solver_run(z, &problem);
}

static bool is_same_interval(const struct interval *a, const struct interval *b)
{
    return a->lo == b->lo && a->hi == b->hi;
}

static bool is_same(const struct crossings *a, const struct crossings *b)
{
    bool same = a->count == b->count && a->overlaps == b->overlaps && a->merged == b->merged;
    for (int i = 0; same && i < a->count; i++) {
        const struct crossing *x = &a->at[i], *y = &b->at[i];
        same = is_same_interval(&x->t, &y->t) && is_same_interval(&x->s, &y->s) &&
               x->standing == y->standing && x->at_most == y->at_most && x->multiplicity == y->multiplicity;
    }
    return same;
}

static void transpose(struct crossings *c)
{
    for (int i = 0; i < c->count; i++) {
        struct interval t = c->at[i].t;
        c->at[i].t = c->at[i].s;
        c->at[i].s = t;
    }
    crossings_sort(c);
}

static void exchange(struct planted *to, const struct planted *from)
{
    prop_curve_copy(&to->f, &from->g);
    prop_curve_copy(&to->g, &from->f);
}

/* Also curves that differ in their domains only. */
static void test_exchange(void **state)
{
    (void)state;
    for (int a = 0; intersectors[a]; a++)
        for (int i = 0; i < PAIRS; i++) {
            struct random_state r = random_for(1, "exchange", (uint64_t)i);
            struct planted p, q;
            make(&p, &r, i);
            if (i % 20 == 0) {
                prop_curve_copy(&p.g, &p.f);
                p.g.curve.domain.lo = 2;
                p.g.curve.domain.hi = 6;
            }
            exchange(&q, &p);
            solver_init(&first, intersectors[a], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            solver_init(&second, intersectors[a], q.f.curve.degree, q.g.curve.degree, WORKSPACE_ROOM);
            enum outcome o = solve(&first, &p);
            enum outcome other = solve(&second, &q);
            transpose(&second.answer.crossings);
            if (o != other || first.workspace.steps != second.workspace.steps ||
                !is_same(&first.answer.crossings, &second.answer.crossings))
                fail_msg("%s: pair %d differs when f and g are exchanged", intersectors[a]->name, i);
            solver_clear(&first);
            solver_clear(&second);
        }
}

/* By 2^e; the homogeneous coordinates of rational curves are multiplied by 2^(e/2) besides. */
static void scale(struct planted *p, int e)
{
    struct prop_curve *both[2] = {&p->f, &p->g};
    for (int k = 0; k < 2; k++) {
        int weigh = both[k]->curve.w ? e / 2 : 0;
        for (int i = 0; i <= both[k]->curve.degree; i++) {
            both[k]->x[i] = real_ldexp(both[k]->x[i], e + weigh);
            both[k]->y[i] = real_ldexp(both[k]->y[i], e + weigh);
            both[k]->w[i] = real_ldexp(both[k]->w[i], weigh);
        }
    }
}

static void test_scale(void **state)
{
    (void)state;
    static const int exponent[] = {1, -1, 40, -40, 400, -400, 600, -600};
    for (int a = 0; intersectors[a]; a++)
        for (int i = 0; i < PAIRS; i++) {
            struct random_state r = random_for(1, "scale", (uint64_t)i);
            struct planted p, q;
            make(&p, &r, i);
            planted_copy(&q, &p);
            scale(&q, exponent[i % 8]);
            solver_init(&first, intersectors[a], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            enum outcome o = solve(&first, &p);
            solver_init(&second, intersectors[a], p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
            enum outcome other = solve(&second, &q);
            if (o != other || first.workspace.steps != second.workspace.steps ||
                !is_same(&first.answer.crossings, &second.answer.crossings))
                fail_msg("%s: pair %d differs when scaled by 2^%d", intersectors[a]->name, i,
                         exponent[i % 8]);
            solver_clear(&first);
            solver_clear(&second);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exchange),
        cmocka_unit_test(test_scale),
    };
    return cmocka_run_group_tests_name("same bits", tests, NULL, NULL);
}
