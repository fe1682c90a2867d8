/* The certified algorithm held to its word on families that are hard for it, and the judge who holds it: a
 * record that is tampered with is caught. */
#include "generated.h"
#include "../harness/cases/number.h"
#include "../harness/cases/problem.h"
#include "../harness/judge/judge_strict.h"
#include "../harness/truth/exact.h"

enum { DIGITS = REAL_BITS > 113 ? 700 : 80 };

static struct crossings crossings;

struct count {
    real tolerance;
    int wide; /* UNIQUE wider than asked */
    int cases, solved, unique, end, cluster, candidate, overlaps, most_records, most_steps, caught, tampered;
};

static real middle(const struct interval *a)
{
    return a->lo + (a->hi - a->lo) / 2;
}

/* Each of these breaks a word; is it noticed? */
static void tamper(const struct test_case *c, struct count *n)
{
    static struct crossings copy;
    char why[256];
    for (int way = 0; way < 4 && crossings.count > 0; way++) {
        memcpy((void *)&copy, (const void *)&crossings, sizeof copy);
        struct crossing *r = &copy.at[0];
        if (way == 0) { /* the record is gone */
            copy.at[0] = copy.at[--copy.count];
        } else if (way == 1) { /* it is elsewhere */
            real t = middle(&r->t), far = t < (real)0.5 ? (real)0.875 : (real)0.125;
            r->t.lo = r->t.hi = far;
        } else if (way == 2 && r->standing == CLUSTER) {
            r->at_most = 0;
        } else if (way == 2) { /* twice */
            copy.at[copy.count++] = copy.at[0];
        } else if (r->standing == UNIQUE) {
            r->multiplicity = 2;
        } else {
            r->standing = UNIQUE;
            r->multiplicity = 0;
        }
        bool holds_none = crossings.at[0].standing == END || crossings.at[0].standing == CANDIDATE;
        n->tampered += !holds_none;
        n->caught += !holds_none && judge_strict(c, &copy, DIGITS, why) > 0;
    }
}

static void try_case(struct test_case *c, void *context)
{
    struct count *n = (struct count *)context;
    const struct intersector *a[] = {intersector_find("certified"), NULL};
    const struct exact_limits limits = {DIGITS, 0};
    struct owned_problem p;
    struct workspace w;
    char why[256];
    if (exact_solve(c, &limits))
        return; /* an end that is not known to so many digits */
    assert_null(owned_problem_make(c, n->tolerance, 20000, &p));
    workspace_make(&w, a, p.problem.f.degree, p.problem.g.degree, WORKSPACE_ROOM);
    enum outcome o = problem_solve(&p.problem, a[0], &w, &crossings);
    if (judge_strict(c, &crossings, DIGITS, why))
        fail_msg("%s: %s", c->id, why);
    tamper(c, n);
    n->cases++;
    n->solved += o == SOLVED;
    n->overlaps += crossings.overlaps;
    n->most_records = crossings.count > n->most_records ? crossings.count : n->most_records;
    n->most_steps = w.steps > n->most_steps ? w.steps : n->most_steps;
    for (int i = 0; i < crossings.count; i++) {
        n->unique += crossings.at[i].standing == UNIQUE;
        n->wide +=
            crossings.at[i].standing == UNIQUE && crossings.at[i].t.hi - crossings.at[i].t.lo > n->tolerance;
        n->end += crossings.at[i].standing == END;
        n->cluster += crossings.at[i].standing == CLUSTER;
        n->candidate += crossings.at[i].standing == CANDIDATE;
    }
    workspace_clear(&w);
    owned_problem_clear(&p);
}

static struct count try_family(const char *family, const char *degrees, int count)
{
    struct count n;
    char options[128];
    int share = REAL_BITS > 113 ? 24 : REAL_BITS > 53 ? 4 : 1;
    memset((void *)&n, 0, sizeof n);
    n.tolerance = (real)1 / 1000000000;
    snprintf(options, sizeof options, "--degree %s --seed 17 --count %d", degrees,
             (count + share - 1) / share);
    generated_each(family, options, try_case, &n);
    print_message(
        "%-15s %-6s %3d cases, %3d solved: %3d UNIQUE, %3d END, %3d CLUSTER, %d CANDIDATE, %d overlaps; "
        "at most %d records, %d steps\n",
        family, degrees, n.cases, n.solved, n.unique, n.end, n.cluster, n.candidate, n.overlaps,
        n.most_records, n.most_steps);
    assert_int_equal(n.caught, n.tampered);
    return n;
}

/* One CLUSTER of at most 4 or 6, at any tolerance. */
static void test_cusps(void **state)
{
    (void)state;
    struct count n = try_family("two_cusps", "3,4,5", 24);
    assert_true(n.cluster >= n.cases * 9 / 10 && n.solved >= n.cases * 9 / 10);
    n = try_family("zero_end", "2,3,5", 24);
    assert_true(n.solved == n.cases && n.candidate * 20 <= n.cases);
}

/* Nothing but proofs. */
static void test_hard(void **state)
{
    (void)state;
    static const char *const family[] = {"on_cut", "sliver", "scaled"};
    for (int i = 0; i < 3; i++) {
        struct count n = try_family(family[i], "2,3,5", 56);
        assert_true(n.solved == n.cases && !n.candidate && !n.cluster);
    }
    struct count n = try_family("smooth_join", "3,5", 60);
    assert_true(n.solved == n.cases && n.cluster == n.cases);
}

/* A curve that is a point is on the other or not; an arc is one overlap, whatever else there is. */
static void test_arcs(void **state)
{
    (void)state;
    struct count n = try_family("point_curve", "2,3,5", 24);
    assert_true(n.solved == n.cases && n.overlaps >= n.cases * 3 / 4 && !n.candidate);
    n = try_family("overlap_beside", "3,4", 24);
    assert_true(n.solved == n.cases && n.overlaps == n.cases && !n.candidate && !n.cluster);
}

/* Pairs that were answered wrongly once: a record rounded inwards, one zero told twice, a root wider than
 * asked because another was being looked at. */
static void test_once_wrong(void **state)
{
    (void)state;
    static const struct {
        const char *family, *options;
        int one_in; /* the tolerance */
    } table[] = {
        {"zero_end", "--degree 5 --seed 9 --first 51", 1000000},
        {"two_cusps", "--degree 3 --seed 1 --first 495", 1000},
        {"two_cusps", "--degree 3 --seed 1 --first 331", 1000},
        {"near_tangent", "--degree 4 --seed 1 --first 1558", 1 << 24},
        {"near_tangent", "--degree 5 --seed 1 --first 1040", 1 << 24},
        {"contact_4", "--degree 4 --seed 1 --first 640", 1000},
        {"sliver", "--degree 8 --seed 1 --first 2329", 1 << 30},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct count n;
        memset((void *)&n, 0, sizeof n);
        n.tolerance = (real)1 / table[i].one_in;
        generated_each(table[i].family, table[i].options, try_case, &n);
        assert_true(n.cases == 1 && n.wide == 0 && n.caught == n.tampered);
    }
}

/* Arcs nearly one neither fill the list nor take long. */
static void test_near_overlap(void **state)
{
    (void)state;
    struct count n = try_family("near_overlap", "2,3", 72);
    assert_true(n.most_records <= 300 && n.most_steps <= 5000);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cusps),        cmocka_unit_test(test_hard),       cmocka_unit_test(test_arcs),
        cmocka_unit_test(test_near_overlap), cmocka_unit_test(test_once_wrong),
    };
    (void)argc;
    generator_find(argv[0]);
    return cmocka_run_group_tests_name("strict", tests, NULL, NULL);
}
