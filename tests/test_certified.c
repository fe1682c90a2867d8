/* The certified algorithm against exact algebra: cases of every family that `fatline generate` makes are
 * solved by resultants to many digits, and every record is held to its word, without any tolerance.
 *
 * Every solution lies in just one record (or in an overlap); a UNIQUE holds exactly one, a simple one; a
 * CLUSTER no more than it says, and hardly less; nothing else claims anything.  Contacts take no longer the
 * smaller the gap is. */
#include <stdio.h>
#include <string.h>

#include "prop.h"
#include "../harness/truth/exact.h"
#include "../harness/cases/number.h"
#include "../harness/cases/problem.h"
#include "../harness/judge/judge_strict.h"

enum {
    DIGITS = REAL_BITS > 113  ? 700 /* finer than any radius */
             : REAL_BITS > 53 ? 80
                              : 40,
    SHARE = REAL_BITS > 113  ? 23 /* of the cases one in so many */
            : REAL_BITS > 53 ? 6
                             : 1
};

static char generator[4096];
static struct crossings crossings;

/* ---- one case ---- */

struct count {
    int cases, solved, solutions, unique, end, cluster, candidate, overlaps, steps, most_steps;
    real widest; /* of the clusters */
};

static void fail_case(const struct test_case *c, const char *why, int i)
{
    char lo[REAL_TEXT_MAX] = "-", hi[REAL_TEXT_MAX] = "-";
    if (i >= 0) {
        real_text(crossings.at[i].t.lo, lo, sizeof lo);
        real_text(crossings.at[i].t.hi, hi, sizeof hi);
    }
    fail_msg("%s: %s (record %d, t from %s to %s)", c->id, why, i, lo, hi);
}

/* The parameters of a solution are exact, or known to DIGITS digits. */
static void make_pad(mpq_t pad)
{
    mpq_init(pad);
    mpz_ui_pow_ui(mpq_denref(pad), 10, DIGITS - 2);
    mpz_set_ui(mpq_numref(pad), 1);
}

static bool is_in_overlap(const struct case_solution *x, const mpq_t pad)
{
    for (int i = 0; i < crossings.overlaps; i++)
        if (interval_holds(&crossings.overlap[i].t_outer, x->t, pad) &&
            interval_holds(&crossings.overlap[i].s_outer, x->s, pad))
            return true;
    return false;
}

/* Every solution in one record that proves something, or in candidates only. */
static void judge_solutions(const struct test_case *c, int held[], int weight[])
{
    mpq_t pad;
    make_pad(pad);
    for (int k = 0; k < c->expected.count; k++) {
        const struct case_solution *x = &c->expected.at[k];
        int proofs = 0, others = 0;
        for (int i = 0; i < crossings.count; i++) {
            const struct crossing *r = &crossings.at[i];
            if (!interval_holds(&r->t, x->t, pad) || !interval_holds(&r->s, x->s, pad))
                continue;
            held[i]++;
            weight[i] += x->multiplicity ? x->multiplicity : 1;
            proofs += r->standing != CANDIDATE;
            others += r->standing == CANDIDATE;
        }
        if (proofs > 1)
            fail_case(c, "one solution, two proofs", -1);
        if (proofs + others == 0 && !is_in_overlap(x, pad))
            fail_case(c, "a solution in no record", -1);
    }
    mpq_clear(pad);
}

static void judge_records(const struct test_case *c, const int held[], const int weight[], struct count *n)
{
    for (int i = 0; i < crossings.count; i++) {
        const struct crossing *r = &crossings.at[i];
        if (r->standing == UNIQUE && (held[i] != 1 || weight[i] != 1))
            fail_case(c, "UNIQUE, but not one simple solution", i);
        if (r->standing == END && weight[i] > 1)
            fail_case(c, "END, but not one simple solution", i);
        if (r->standing == CLUSTER && (weight[i] > r->at_most || r->at_most > weight[i] + 1))
            fail_case(c, "CLUSTER of another number", i);
        if (i > 0 && r->t.lo < r[-1].t.lo)
            fail_case(c, "not sorted", i);
        n->unique += r->standing == UNIQUE;
        n->end += r->standing == END;
        n->cluster += r->standing == CLUSTER;
        if (r->standing == CLUSTER)
            n->widest = real_max(n->widest, real_max(r->t.hi - r->t.lo, r->s.hi - r->s.lo));
        n->candidate += r->standing == CANDIDATE;
    }
}

/* t_inner of a record within the exact range, within t_outer; s likewise. */
static void judge_overlaps(const struct test_case *c)
{
    const struct case_overlap *o = c->expected.overlap;
    if (crossings.overlaps != c->expected.overlaps)
        fail_case(c, "another number of overlaps", -1);
    mpq_t none;
    mpq_init(none);
    for (int i = 0; i < crossings.overlaps; i++, o++) {
        const struct overlap *r = &crossings.overlap[i];
        mpq_t lo, hi;
        mpq_inits(lo, hi, NULL);
        if (!interval_holds(&r->t_outer, o->t0, none) || !interval_holds(&r->t_outer, o->t1, none) ||
            !interval_holds(&r->s_outer, o->s0, none) || !interval_holds(&r->s_outer, o->s1, none))
            fail_case(c, "an overlap is not within its record", -1);
        real_to_rational(r->t_inner.lo, lo);
        real_to_rational(r->t_inner.hi, hi);
        if (mpq_cmp(lo, o->t0) < 0 || mpq_cmp(hi, o->t1) > 0)
            fail_case(c, "t_inner is more than the overlap", -1);
        if (r->reversed != (mpq_cmp(o->s0, o->s1) > 0))
            fail_case(c, "an overlap runs the other way", -1);
        mpq_clears(lo, hi, NULL);
    }
    mpq_clear(none);
}

static void solve_case(struct test_case *c, real tolerance, struct count *n)
{
    static int held[CROSSINGS_MAX], weight[CROSSINGS_MAX];
    const struct intersector *a[] = {intersector_find("certified"), NULL};
    const struct exact_limits limits = {DIGITS, 0};
    struct owned_problem p;
    struct workspace w;
    const char *trouble = exact_solve(c, &limits);
    if (trouble)
        fail_msg("%s: no truth: %s", c->id, trouble);
    assert_null(owned_problem_make(c, tolerance, 20000, &p));
    workspace_make(&w, a, p.problem.f.degree, p.problem.g.degree, WORKSPACE_ROOM);
    enum outcome o = problem_solve(&p.problem, a[0], &w, &crossings);
    memset(held, 0, sizeof held);
    memset(weight, 0, sizeof weight);
    judge_solutions(c, held, weight);
    judge_records(c, held, weight, n);
    judge_overlaps(c);
    n->cases++;
    n->solved += o == SOLVED;
    n->solutions += c->expected.count;
    n->overlaps += crossings.overlaps;
    n->steps += w.steps;
    n->most_steps = w.steps > n->most_steps ? w.steps : n->most_steps;
    workspace_clear(&w);
    owned_problem_clear(&p);
}

/* ---- a family ---- */

static struct count solve_cases(const char *family, const char *degrees, int first, int count, int seed,
                                real tolerance)
{
    struct count n;
    struct case_reader reader;
    struct test_case c;
    char command[sizeof generator + 256];
    memset(&n, 0, sizeof n);
    snprintf(command, sizeof command, "'%s' %s --degree %s --first %d --count %d --seed %d", generator,
             family, degrees, first, count, seed);
    FILE *stream = popen(command, "r");
    assert_non_null(stream);
    case_reader_init(&reader, stream, family);
    while (case_read(&reader, &c) == CASE_READ) {
        solve_case(&c, tolerance, &n);
        case_clear(&c);
    }
    case_reader_clear(&reader);
    assert_int_equal(pclose(stream), 0);
    print_message(
        "%-24s %-8s %3d cases, %3d solved: %3d solutions; %3d UNIQUE, %2d END, %2d CLUSTER, %2d CANDIDATE, "
        "%2d overlaps; %d steps, at most %d\n",
        family, degrees, n.cases, n.solved, n.solutions, n.unique, n.end, n.cluster, n.candidate, n.overlaps,
        n.steps, n.most_steps);
    assert_true(n.cases > 0);
    return n;
}

static struct count solve_family(const char *family, const char *degrees, int cases, real tolerance)
{
    return solve_cases(family, degrees, 0, cases / SHARE ? cases / SHARE : 1, 11, tolerance);
}

static real loose(void)
{
    return (real)1 / 1000000000;
}

/* ---- the tests ---- */

/* Nothing but UNIQUE where all solutions are simple and inside; END at an end. */
static void test_simple(void **state)
{
    (void)state;
    static const char *const family[] = {"random",          "nice",           "nine", "many",
                                         "circle_crossing", "random_rational"};
    static const char *const degrees[] = {"2,3,4,3x5,8", "2,3,5,8", "2,3,4", "3,4", "2,3", "2,3,3x2"};
    for (int i = 0; i < 6; i++) {
        struct count n = solve_family(family[i], degrees[i], i < 2 ? 40 : 12, loose());
        assert_true(n.solved == n.cases && n.unique + n.end == n.solutions && !n.cluster && !n.candidate);
    }
    struct count ends = solve_family("shared_end", "2,3,5", 24, loose());
    assert_true(ends.end == ends.cases && !ends.unique && !ends.candidate);
    struct count end = solve_family("endpoint", "2,3,5", 24, loose());
    assert_true(end.end == end.cases && !end.unique && !end.candidate);
}

/* However little is asked for, nothing wider than rounding comes back from polynomial curves. */
static void test_narrow(void **state)
{
    (void)state;
    struct count n = solve_family("random", "3,5", 20, 16 * REAL_EPSILON);
    assert_true(n.unique == n.solutions && !n.candidate);
    n = solve_family("size_mismatch", "3", 80, loose());
    assert_true(n.unique == n.solutions && n.solved == n.cases);
}

/* Two, none, or one CLUSTER of two; at every gap in about the same time. */
static void test_near_tangent(void **state)
{
    (void)state;
    struct count n = solve_family("near_tangent", "2,3", 92, loose());
    assert_true(n.unique == n.solutions && !n.cluster && !n.candidate && n.solved == n.cases);
    assert_true(n.most_steps <= 200 && n.steps <= 32 * n.cases);
    /* of degree 8 the rounding of sixth differences of a short arc is more than they are */
    static const int hard[] = {18, 86, 110, 178};
    for (int i = 0; i < 4; i += SHARE / 6 + 1) {
        struct count h = solve_cases("near_tangent", "8", hard[i], 1, 1, 16 * REAL_EPSILON);
        assert_true(h.solved == 1 && h.unique == h.solutions && !h.candidate && h.most_steps <= 200);
    }
    static const char *const family[] = {"tangent_same", "tangent_opposite", "smooth_join",
                                         "endpoint_tangent"};
    for (int i = 0; i < 4; i++) {
        struct count t = solve_family(family[i], "2,3,5", 18, loose());
        assert_true(t.cluster == t.cases && !t.candidate && t.solved == t.cases);
        assert_true(t.most_steps <= 400);
    }
}

/* One CLUSTER each, whatever the tolerance, as narrow as twice the digits leave a contact of that order. */
static void test_contacts(void **state)
{
    (void)state;
    static const struct {
        const char *family, *degrees;
        int order, cases;
    } of[] = {{"contact_3", "2,3,5", 3, 30},
              {"contact_4", "3,4,5", 4, 120},
              {"cusp_crossed", "3,4,5", 2, 60},
              {"cusp_along", "3,4,5", 3, 60}};
    const real tolerances[] = {(real)1 / 1000, 16 * REAL_EPSILON};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++) {
            struct count n = solve_family(of[i].family, of[i].degrees, of[i].cases, tolerances[k]);
            assert_true(n.cluster == n.cases && !n.candidate && n.solved == n.cases);
            assert_true(n.most_steps <= 400);
            assert_true(k == 0 || n.widest <= real_ldexp(1, 10 - 2 * REAL_BITS / of[i].order));
        }
}

/* Of contacts with another solution nearby, of those at a cut and of those that are very flat, a few each of
 * thousands: the same. */
static void test_hard_contacts(void **state)
{
    (void)state;
    static const struct {
        const char *family, *degrees;
        int first, seed;
    } of[] = {{"contact_4", "5", 112, 1}, {"contact_4", "5", 211, 1},    {"contact_4", "5", 576, 1},
              {"contact_4", "5", 596, 1}, {"contact_4", "5", 339, 1},    {"contact_4", "4", 623, 2},
              {"contact_4", "5", 220, 2}, {"contact_4", "3", 100, 1},    {"contact_4", "4", 26, 1},
              {"contact_4", "4", 255, 2}, {"cusp_crossed", "5", 252, 1}, {"cusp_along", "5", 290, 1}};
    for (size_t i = 0; i < sizeof of / sizeof of[0]; i += SHARE / 6 + 1) {
        struct count n = solve_cases(of[i].family, of[i].degrees, of[i].first, 1, of[i].seed,
                                     i % 2 ? loose() : 16 * REAL_EPSILON);
        assert_true(n.cluster == 1 && !n.candidate && n.solved == 1 && n.most_steps <= 400);
        assert_true(n.widest <= real_ldexp(1, 10 - REAL_BITS / 2));
    }
}

/* A cusp at a cusp, and doubled ends that touch: a CLUSTER of at most so many. */
static void test_cusps(void **state)
{
    (void)state;
    struct count n = solve_family("two_cusps", "3,4", 12, (real)1 / 1000);
    assert_true(n.cluster == n.cases && !n.candidate);
    n = solve_family("zero_end", "2,3", 18, (real)1 / 1000);
    assert_true(3 * n.cluster >= n.cases && !n.candidate && n.solved == n.cases);
    solve_family("near_disjoint", "3,5", 17, loose());
}

static void test_overlaps(void **state)
{
    (void)state;
    struct count n = solve_family("overlap", "2,3,4", 12, loose());
    assert_true(n.overlaps == n.cases && n.most_steps <= 2000);
    n = solve_family("overlap_rational", "2,3", 6, loose());
    assert_true(n.overlaps == n.cases);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_simple),        cmocka_unit_test(test_narrow),
        cmocka_unit_test(test_near_tangent),  cmocka_unit_test(test_contacts),
        cmocka_unit_test(test_hard_contacts), cmocka_unit_test(test_cusps),
        cmocka_unit_test(test_overlaps),
    };
    const char *slash = strrchr(argv[0], '/');
    (void)argc;
    snprintf(generator, sizeof generator, "%.*s/../../double/fatline-generate",
             slash ? (int)(slash - argv[0]) : 1, slash ? argv[0] : ".");
    return cmocka_run_group_tests_name("certified", tests, NULL, NULL);
}
