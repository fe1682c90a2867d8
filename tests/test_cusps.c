/* Two cusps with a common tangent at one point: a CLUSTER of the multiplicity that is there, 6, 7, 8, and no
 * less would be true; what is near them is told apart; other ways to say the same pair have the same answer.
 */
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/cases/case.h"
#include "../harness/cases/problem.h"
#include "../harness/judge/judge_strict.h"
#include "../harness/truth/exact.h"

enum {
    DEGREE = 5,
    DIGITS = REAL_BITS > 113 ? 700 : 80,
    CASES = REAL_BITS > 113  ? 2
            : REAL_BITS > 53 ? 6
                             : 48,
    BITS = 24 /* coefficients are multiples of 2^-BITS */
};

/* Powers of the distance from the cusp, times 2^BITS, which is at the parameter place / 2^depth. */
struct local {
    int64_t x[DEGREE + 1], y[DEGREE + 1];
    int place, depth;
};

struct cusps {
    struct local f, g;
    int multiplicity;
    int near_bits; /* a simple solution 2^-near_bits from it; 0: none */
};

/* How the pair is said. */
struct way {
    bool swapped, f_back, g_back;
    int scale, ex, ey; /* coordinates times 2^scale; x points along (ex, ey) */
};

static int64_t unit(int quarters)
{
    return (int64_t)quarters << (BITS - 2);
}

static int64_t odd_quarters(struct random_state *r)
{
    return unit((int)(2 * random_between(r, -4, 4) + 1));
}

/* x = +-z^2 (1 + a z) for both, y from the third power on; with the same y up to the order p - 1 for g at the
 * same distance: then p there, and 3 on the other branch, or p if y begins with the fourth power. */
static void cusps_make(struct cusps *c, struct random_state *r, int agree, bool flat, int near_bits)
{
    memset(c, 0, sizeof *c);
    int64_t a = unit((int)random_between(r, -2, 2)), one = unit(4);
    for (int i = 0; i < 2; i++) {
        struct local *l = i ? &c->g : &c->f;
        l->x[2] = one;
        l->x[3] = a;
        l->depth = (int)random_between(r, 1, 3);
        l->place = (int)(random_between(r, 0, 1) ? 1 : (1 << l->depth) - 1);
    }
    for (int k = flat ? 4 : 3; k <= DEGREE; k++) {
        c->f.y[k] = odd_quarters(r);
        c->g.y[k] = k < agree ? c->f.y[k] : c->f.y[k] + unit(2) * (1 + (int)random_between(r, 0, 1));
    }
    c->multiplicity = (flat ? agree : 3) + agree;
    if (near_bits) { /* f's y less g's: z^3 d (z - 2^-near_bits) */
        c->g.y[5] = c->f.y[5];
        c->g.y[3] = c->f.y[3] + ((c->f.y[4] - c->g.y[4]) >> near_bits);
        c->near_bits = near_bits;
    }
    if (!flat && !near_bits && c->g.y[3] == -c->f.y[3]) { /* the other branch would agree */
        c->g.y[3] += unit(1);
    }
}

/* ---- to control points ---- */

static int64_t choose(int n, int k)
{
    int64_t c = 1;
    for (int i = 0; i < k; i++)
        c = c * (n - i) / (i + 1);
    return c;
}

/* Control points, times 10 2^(BITS + 5 depth). */
static void control_values(const int64_t *local, int place, int depth, int64_t out[DEGREE + 1])
{
    int64_t power[DEGREE + 1] = {0};
    for (int j = 0; j <= DEGREE; j++) {
        for (int k = 0; k <= j; k++) { /* (t - place / 2^depth)^j */
            int64_t term = local[j] * choose(j, k);
            for (int i = 0; i < j - k; i++)
                term *= -place;
            power[k] += term * ((int64_t)1 << (depth * (DEGREE - (j - k))));
        }
    }
    for (int i = 0; i <= DEGREE; i++) {
        out[i] = 0;
        for (int k = 0; k <= i; k++)
            out[i] += power[k] * choose(i, k) * (10 / choose(DEGREE, k));
    }
}

/* A dyadic number that a double holds. */
static void number_write(char **at, int64_t n, int exponent)
{
    int64_t size = n < 0 ? -n : n, odd = size;
    while (odd && odd % 2 == 0)
        odd /= 2;
    assert_true(odd < (int64_t)1 << 53);
    *at += sprintf(*at, "\"%s0x%llxp%d\"", n < 0 ? "-" : "", (unsigned long long)size, exponent);
}

static void curve_write(char **at, const char *name, const struct local *l, const struct way *w, bool back)
{
    int64_t x[DEGREE + 1], y[DEGREE + 1];
    control_values(l->x, l->place, l->depth, x);
    control_values(l->y, l->place, l->depth, y);
    *at += sprintf(*at, "\"%s\":{\"points\":[", name);
    for (int i = 0; i <= DEGREE; i++) {
        int k = back ? DEGREE - i : i, exponent = w->scale - BITS - DEGREE * l->depth;
        *at += sprintf(*at, i ? ",[" : "[");
        number_write(at, w->ex * x[k] - w->ey * y[k], exponent);
        *at += sprintf(*at, ",");
        number_write(at, w->ey * x[k] + w->ex * y[k], exponent);
        *at += sprintf(*at, "]");
    }
    *at += sprintf(*at, "]}");
}

static void case_make(const struct cusps *c, const struct way *w, struct test_case *out)
{
    char line[4096], error[512], *at = line;
    at += sprintf(at, "{\"id\":\"cusps\",");
    curve_write(&at, "f", w->swapped ? &c->g : &c->f, w, w->f_back);
    at += sprintf(at, ",");
    curve_write(&at, "g", w->swapped ? &c->f : &c->g, w, w->g_back);
    sprintf(at, "}");
    assert_int_equal(case_parse(line, "cusps", 1, out, error), CASE_READ);
}

/* ---- answers ---- */

struct answer {
    struct crossings crossings;
    enum outcome outcome;
    int steps;
    int unique, cluster, candidate, at_most; /* at_most: the largest */
};

static void answer_find(struct test_case *c, const char *algorithm, real tolerance, struct answer *out)
{
    const struct intersector *a[] = {intersector_find(algorithm), NULL};
    struct owned_problem p;
    struct workspace w;
    assert_null(owned_problem_make(c, tolerance, 20000, &p));
    workspace_make(&w, a, DEGREE, DEGREE, WORKSPACE_ROOM);
    memset((void *)out, 0, sizeof *out);
    out->outcome = problem_solve(&p.problem, a[0], &w, &out->crossings);
    out->steps = w.steps;
    for (int i = 0; i < out->crossings.count; i++) {
        const struct crossing *x = &out->crossings.at[i];
        out->unique += x->standing == UNIQUE || x->standing == END;
        out->cluster += x->standing == CLUSTER;
        out->candidate += x->standing == CANDIDATE;
        out->at_most = x->at_most > out->at_most ? x->at_most : out->at_most;
    }
    workspace_clear(&w);
    owned_problem_clear(&p);
}

static int multiplicity_at_most(const struct test_case *c)
{
    int most = 0;
    for (int i = 0; i < c->expected.count; i++)
        most = c->expected.at[i].multiplicity > most ? c->expected.at[i].multiplicity : most;
    return most;
}

/* A word less than the algorithm's is not true. */
static void assert_sharp(const struct test_case *c, struct answer *a)
{
    char why[256];
    for (int i = 0; i < a->crossings.count; i++) {
        struct crossing *x = &a->crossings.at[i];
        if (x->standing == CLUSTER && x->at_most == multiplicity_at_most(c)) {
            x->at_most--;
            assert_true(judge_strict(c, &a->crossings, DIGITS, why) > 0);
            x->at_most++;
        }
    }
}

struct tally {
    int cases, sharp, most_steps, most_records;
};

static struct answer answer;

/* A simple solution so near may share a CLUSTER of one more with the cusps. */
static bool may_merge(const struct cusps *c, real tolerance)
{
    const real coarse = (real)1 / 1000;
    return c->near_bits > 0 && (tolerance >= coarse || (REAL_BITS == 53 && c->near_bits > 11));
}

static void hold(const struct cusps *c, const struct way *w, const char *what, int number, struct tally *n)
{
    static const char *const algorithm[] = {"certified", "certified_scalar"};
    const struct exact_limits limits = {DIGITS, 0};
    const real tolerance[] = {(real)1 / 1000, (real)1 / 1000000000, real_ldexp(1, -40)};
    struct test_case k;
    char why[256];
    case_make(c, w, &k);
    assert_null(exact_solve(&k, &limits));
    if (multiplicity_at_most(&k) != c->multiplicity)
        fail_msg("%s %d: multiplicity %d, not %d", what, number, multiplicity_at_most(&k), c->multiplicity);
    for (int i = 0; i < 6 && intersector_find(algorithm[i / 3]); i++) {
        answer_find(&k, algorithm[i / 3], tolerance[i % 3], &answer);
        if (judge_strict(&k, &answer.crossings, DIGITS, why))
            fail_msg("%s %d, %s: %s", what, number, algorithm[i / 3], why);
        if (answer.outcome != SOLVED || answer.candidate || answer.cluster != 1 ||
            answer.at_most > c->multiplicity + may_merge(c, tolerance[i % 3]))
            fail_msg("%s %d, %s at %g: %s, %d candidates, %d clusters, at most %d, not %d", what, number,
                     algorithm[i / 3], real_to_double(tolerance[i % 3]), outcome_name(answer.outcome),
                     answer.candidate, answer.cluster, answer.at_most, c->multiplicity);
        n->cases++;
        n->sharp += answer.at_most == c->multiplicity;
        n->most_steps = answer.steps > n->most_steps ? answer.steps : n->most_steps;
        n->most_records = answer.crossings.count > n->most_records ? answer.crossings.count : n->most_records;
        assert_sharp(&k, &answer);
    }
    case_clear(&k);
}

static struct way way_of(struct random_state *r)
{
    struct way w = {random_between(r, 0, 1) == 1, random_between(r, 0, 1) == 1,
                    random_between(r, 0, 1) == 1, -5,
                    (int)random_between(r, 1, 3), (int)random_between(r, -3, 3)};
    return w;
}

static struct tally hold_all(const char *what, int agree, bool flat, bool away)
{
    struct tally n = {0, 0, 0, 0};
    for (int i = 0; i < CASES; i++) {
        struct random_state r = random_for(1, what, (uint64_t)i);
        struct cusps c;
        struct way w = way_of(&r);
        cusps_make(&c, &r, agree, flat, 0);
        for (int k = 2; away && k <= DEGREE; k++)
            c.g.x[k] = -c.g.x[k];
        hold(&c, &w, what, i, &n);
    }
    print_message("%-28s %3d answers, at most %d steps, %d records\n", what, n.cases, n.most_steps,
                  n.most_records);
    return n;
}

/* 3 + 3, 3 + 4, 3 + 5; 4 + 4 where y begins with the fourth power; 3 + 3 where they point away from each
 * other: the bound is what is there. */
static void test_multiplicities(void **state)
{
    (void)state;
    static const struct {
        const char *what;
        int agree;
        bool flat, away;
    } table[] = {{"cusps of 6", 3, false, false},
                 {"cusps of 7", 4, false, false},
                 {"cusps of 8", 5, false, false},
                 {"flat cusps of 8", 4, true, false},
                 {"cusps away of 6", 3, false, true}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct tally n = hold_all(table[i].what, table[i].agree, table[i].flat, table[i].away);
        assert_int_equal(n.sharp, n.cases);
        assert_true(n.most_steps <= 1000 && n.most_records <= 16);
    }
}

/* A simple solution 2^-4 to 2^-20 away, on the branch where the cusps nearly agree. */
static void test_near(void **state)
{
    (void)state;
    struct tally n = {0, 0, 0, 0};
    int distances = 17, cases = CASES > distances ? CASES : distances;
    for (int i = 0; i < cases; i += cases / CASES) {
        struct random_state r = random_for(1, "near cusps", (uint64_t)i);
        struct cusps c;
        struct way w = way_of(&r);
        cusps_make(&c, &r, 3, false, 4 + i % distances);
        hold(&c, &w, "near cusps", i, &n);
    }
    print_message("%-28s %3d answers, %d of them told apart, at most %d steps, %d records\n", "near cusps",
                  n.cases, n.sharp, n.most_steps, n.most_records);
    assert_true(n.most_steps <= 1000);
}

/* Swapped, backwards, larger, turned: as many records of each kind, and as many solutions in them. */
static void test_invariance(void **state)
{
    (void)state;
    const struct way ways[] = {{true, false, false, -5, 1, 0},   {false, true, false, -5, 1, 0},
                               {false, false, true, -5, 1, 0},   {false, false, false, 40, 1, 0},
                               {false, false, false, -60, 1, 0}, {false, false, false, -5, 0, 1},
                               {false, false, false, -5, -1, 0}};
    for (int i = 0; i < CASES; i++) {
        struct random_state r = random_for(1, "same cusps", (uint64_t)i);
        struct way plain = {false, false, false, -5, 1, 0};
        struct cusps c;
        struct test_case k;
        cusps_make(&c, &r, 3 + i % 3, false, 0);
        case_make(&c, &plain, &k);
        answer_find(&k, "certified", (real)1 / 1000000, &answer);
        struct answer first = answer;
        case_clear(&k);
        for (size_t j = 0; j < sizeof ways / sizeof *ways; j++) {
            case_make(&c, &ways[j], &k);
            answer_find(&k, "certified", (real)1 / 1000000, &answer);
            case_clear(&k);
            if (answer.outcome != first.outcome || answer.unique != first.unique ||
                answer.cluster != first.cluster || answer.at_most != first.at_most || answer.candidate)
                fail_msg("case %d, way %zu: %d UNIQUE and %d CLUSTER of %d, not %d and %d of %d", i, j,
                         answer.unique, answer.cluster, answer.at_most, first.unique, first.cluster,
                         first.at_most);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_multiplicities),
        cmocka_unit_test(test_near),
        cmocka_unit_test(test_invariance),
    };
    return cmocka_run_group_tests_name("cusps", tests, NULL, NULL);
}
