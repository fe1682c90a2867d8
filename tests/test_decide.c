/* What exact arithmetic settles is as the exact truth has it: every solution in a record of its own with its
 * multiplicity, shared arcs with their ranges, and nothing else. */
#include "generated.h"
#include "../harness/cases/number.h"
#include "../harness/cases/problem.h"
#include "../harness/judge/judge_strict.h"
#include "../harness/truth/decide.h"
#include "../harness/truth/exact.h"

enum { DIGITS = REAL_BITS > 113 ? 700 : 80, SECONDS = 60 };

static struct crossings crossings;

/* How a family fares. */
struct count {
    int max_steps;
    bool decide;
    int cases, right, multiple, exact_overlaps;
};

/* Narrower than a few units in the last place, or proved narrow before. */
static bool is_narrow(const struct interval *a, real before)
{
    return a->hi - a->lo <= real_max(64 * REAL_EPSILON, before);
}

static bool same_crossings(const struct test_case *c, real before)
{
    const struct case_expected *e = &c->expected;
    mpq_t pad;
    bool same = crossings.count == e->count;
    mpq_init(pad);
    mpz_ui_pow_ui(mpq_denref(pad), 10, DIGITS - 2);
    mpz_set_ui(mpq_numref(pad), 1);
    for (int k = 0; k < e->count && same; k++) { /* both are sorted by t, but perhaps for the last places */
        bool held = false;
        for (int i = 0; i < crossings.count && !held; i++) {
            const struct crossing *r = &crossings.at[i];
            held = interval_holds(&r->t, e->at[k].t, pad) && interval_holds(&r->s, e->at[k].s, pad) &&
                   r->standing == UNIQUE && r->multiplicity == e->at[k].multiplicity &&
                   is_narrow(&r->t, before) && is_narrow(&r->s, before);
        }
        same = held;
    }
    mpq_clear(pad);
    return same;
}

static bool same_overlaps(const struct test_case *c, struct count *n)
{
    bool same = crossings.overlaps == c->expected.overlaps;
    for (int i = 0; i < crossings.overlaps; i++) {
        const struct overlap *o = &crossings.overlap[i];
        n->exact_overlaps += o->exact;
        same = same && is_narrow(&o->t_outer, o->t_inner.hi - o->t_inner.lo + 16 * REAL_EPSILON) &&
               is_narrow(&o->s_outer, o->s_inner.hi - o->s_inner.lo + 16 * REAL_EPSILON);
    }
    return same;
}

static void try_case(struct test_case *c, void *context)
{
    struct count *n = (struct count *)context;
    const real tolerance = (real)1 / 1000000000;
    const struct intersector *a[] = {intersector_find("certified"), NULL};
    const struct exact_limits limits = {DIGITS, 0};
    struct owned_problem p;
    struct workspace w;
    char why[256];
    assert_null(exact_solve(c, &limits));
    assert_null(owned_problem_make(c, tolerance, n->max_steps, &p));
    workspace_make(&w, a, p.problem.f.degree, p.problem.g.degree, WORKSPACE_ROOM);
    enum outcome o = problem_solve(&p.problem, a[0], &w, &crossings);
    const char *trouble = n->decide ? decide(c, &p.problem, SECONDS, &o, &crossings) : NULL;
    if (trouble)
        fail_msg("%s: %s", c->id, trouble);
    bool right = same_crossings(c, tolerance) && same_overlaps(c, n);
    if (n->decide && (!right || o != SOLVED || judge_strict(c, &crossings, DIGITS, why)))
        fail_msg("%s: decided otherwise than it is, %s", c->id, why);
    n->cases++;
    n->right += right;
    for (int i = 0; i < crossings.count; i++)
        n->multiple += crossings.at[i].multiplicity > 1;
    workspace_clear(&w);
    owned_problem_clear(&p);
}

static struct count try_family(const char *family, const char *options, int max_steps, bool decide)
{
    struct count n;
    memset(&n, 0, sizeof n);
    n.max_steps = max_steps;
    n.decide = decide;
    generated_each(family, options, try_case, &n);
    print_message("%-18s %-8s %3d cases, %3d as the truth has it, %2d multiple\n", family,
                  decide ? "decided" : "", n.cases, n.right, n.multiple);
    return n;
}

static const char *some(int count)
{
    static char options[128];
    int share = REAL_BITS > 113 ? 16 : REAL_BITS > 53 ? 4 : 1;
    snprintf(options, sizeof options, "--degree 3 --seed 12 --count %d", (count + share - 1) / share);
    return options;
}

/* A contact is one solution with its multiplicity; without the decision it is not known to be. */
static void test_contacts(void **state)
{
    (void)state;
    static const char *const family[] = {"tangent_same", "tangent_opposite", "endpoint_tangent",
                                         "smooth_join",  "contact_3",        "contact_4",
                                         "cusp_crossed", "cusp_along",       "two_cusps"};
    for (int i = 0; i < 9; i++) {
        struct count n = try_family(family[i], some(16), 20000, true);
        assert_true(n.right == n.cases && n.multiple == n.cases);
        struct count before = try_family(family[i], some(16), 20000, false);
        assert_true(before.right == 0); /* else this test could not fail */
    }
}

/* Ends: in or out is decided.  Near misses are dropped, close solutions told apart, also when the algorithm
 * was stopped long before. */
static void test_near(void **state)
{
    (void)state;
    static const char *const family[] = {"near_tangent", "zero_end", "shared_end", "endpoint",
                                         "near_overlap"};
    for (int i = 0; i < 5; i++) {
        struct count n = try_family(family[i], some(24), 20000, true);
        assert_true(n.right == n.cases);
        n = try_family(family[i], some(24), 3, true);
        assert_true(n.right == n.cases);
        n = try_family(family[i], some(24), 3, false);
        assert_true(n.right < n.cases);
    }
}

static void test_overlaps(void **state)
{
    (void)state;
    static const char *const family[] = {"overlap", "overlap_rational", "overlap_beside", "point_curve"};
    for (int i = 0; i < 4; i++) {
        struct count n = try_family(family[i], some(16), 20000, true);
        assert_true(n.right == n.cases && (i == 3 || n.exact_overlaps == n.cases));
        struct count before = try_family(family[i], some(16), 20000, false);
        assert_true(before.exact_overlaps == 0);
    }
}

/* Coordinates that are no numbers of this precision: 2/3 and 1/3, a tangency of the curves as stated. */
static void test_fractions(void **state)
{
    (void)state;
    static const char line[] =
        "{\"id\":\"thirds\",\"f\":{\"points\":[[\"0\",\"2/3\"],[\"1/2\",\"0\"],[\"1\",\"2/3\"]]},"
        "\"g\":{\"points\":[[\"0\",\"1/3\"],[\"1\",\"1/3\"]]}}";
    struct test_case c;
    struct count n = {20000, true, 0, 0, 0, 0};
    char error[512];
    assert_int_equal(case_parse(line, "here", 1, &c, error), CASE_READ);
    try_case(&c, &n);
    assert_true(n.right == 1 && n.multiple == 1);
    case_clear(&c);
}

/* Where the time does not suffice, the answer stays and the reason is told. */
static void try_limit(struct test_case *c, void *context)
{
    static struct crossings copy;
    const struct intersector *a[] = {intersector_find("certified"), NULL};
    struct owned_problem p;
    struct workspace w;
    assert_null(owned_problem_make(c, (real)1 / 1000, 2, &p));
    workspace_make(&w, a, p.problem.f.degree, p.problem.g.degree, WORKSPACE_ROOM);
    enum outcome o = problem_solve(&p.problem, a[0], &w, &crossings);
    memcpy((void *)&copy, (const void *)&crossings, sizeof copy);
    const char *trouble = decide(c, &p.problem, 0.02, &o, &crossings);
    assert_non_null(trouble);
    assert_string_equal(trouble, "time limit");
    assert_true(o == OUT_OF_STEPS && crossings.count == copy.count && crossings.count > 0);
    assert_true(crossings.at[0].t.lo == copy.at[0].t.lo && crossings.at[0].standing == CANDIDATE);
    workspace_clear(&w);
    owned_problem_clear(&p);
    (void)context;
}

static void test_time(void **state)
{
    (void)state;
    generated_each("random", "--degree 24 --count 1 --seed 3", try_limit, NULL);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_contacts),  cmocka_unit_test(test_near), cmocka_unit_test(test_overlaps),
        cmocka_unit_test(test_fractions), cmocka_unit_test(test_time),
    };
    (void)argc;
    generator_find(argv[0]);
    return cmocka_run_group_tests_name("decide", tests, NULL, NULL);
}
