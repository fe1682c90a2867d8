/* Translation, reversal and elevation, where they are exact, keep the groups of records. */
#include "nasty.h"
#include "solving.h"

#include "../algorithms/core/bernstein.h"

enum {
    PAIRS = REAL_BITS > 113  ? 15
            : REAL_BITS > 53 ? 40
                             : 200,
    STEPS = REAL_BITS > 113  ? 600
            : REAL_BITS > 53 ? 2000
                             : 20000,
    GROUPS_MAX = 64
};

/* Records closer than this are one group. */
#define APART ((real)1 / 1000000)

static struct solver first, second;

static enum outcome solve(struct solver *z, const struct planted *p)
{
    struct problem problem = problem_of(&p->f.curve, &p->g.curve, (real)1 / 1000000000, STEPS);
    return solver_run(z, &problem);
}

struct group {
    struct interval t, s;
};

struct groups {
    int count;
    struct group at[GROUPS_MAX];
};

static bool touch(const struct interval *a, const struct interval *b, real apart)
{
    return a->lo <= b->hi + apart && b->lo <= a->hi + apart;
}

static void join(struct interval *a, const struct interval *b)
{
    a->lo = real_min(a->lo, b->lo);
    a->hi = real_max(a->hi, b->hi);
}

/* Records that touch after widening are one group; false if there are too many. */
static bool group(const struct crossings *c, real apart, struct groups *out)
{
    out->count = 0;
    for (int i = 0; i < c->count; i++) {
        struct group g = {c->at[i].t, c->at[i].s};
        for (int k = 0; k < out->count;) {
            if (!touch(&out->at[k].t, &g.t, apart) || !touch(&out->at[k].s, &g.s, apart)) {
                k++;
                continue;
            }
            join(&g.t, &out->at[k].t);
            join(&g.s, &out->at[k].s);
            out->at[k] = out->at[--out->count];
            k = 0;
        }
        if (out->count == GROUPS_MAX)
            return false;
        out->at[out->count++] = g;
    }
    return true;
}

/* Are the groups of a and b the same, one to one? */
static bool is_matched(const struct groups *a, const struct groups *b, real apart)
{
    bool same = a->count == b->count;
    for (int i = 0; same && i < a->count; i++) {
        int partners = 0;
        for (int k = 0; k < b->count; k++)
            partners += touch(&a->at[i].t, &b->at[k].t, apart) && touch(&a->at[i].s, &b->at[k].s, apart);
        same = partners == 1;
    }
    return same;
}

/* Makes q from p by an exact change; `reversed` if f then runs backwards.  False if it would not be exact. */
typedef bool change_function(struct planted *q, struct random_state *r, bool *reversed);

/* By a multiple of 1/4 up to 64. */
static bool translate(struct planted *q, struct random_state *r, bool *reversed)
{
    real move[2] = {(int)random_between(r, -256, 256) * (real)0.25,
                    (int)random_between(r, -256, 256) * (real)0.25};
    struct prop_curve *both[2] = {&q->f, &q->g};
    (void)reversed;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i <= both[k]->curve.degree; i++) {
            real x = both[k]->x[i], y = both[k]->y[i], w = both[k]->w[i];
            both[k]->x[i] = x + w * move[0];
            both[k]->y[i] = y + w * move[1];
            if (both[k]->x[i] - w * move[0] != x || both[k]->y[i] - w * move[1] != y)
                return false;
        }
    return true;
}

static bool reverse(struct planted *q, struct random_state *r, bool *reversed)
{
    int n = q->f.curve.degree;
    real *c[3] = {q->f.x, q->f.y, q->f.w};
    (void)r;
    for (int k = 0; k < 3; k++)
        for (int i = 0; 2 * i < n; i++) {
            real a = c[k][i];
            c[k][i] = c[k][n - i];
            c[k][n - i] = a;
        }
    *reversed = true;
    return true;
}

/* By one or two degrees.  Multiples of (n + 1)(n + 2) can be elevated exactly: so a rational curve is
 * multiplied by that, a polynomial one was made so. */
static bool elevate(struct planted *q, struct random_state *r, bool *reversed)
{
    int n = q->f.curve.degree, more = (int)random_between(r, 1, 2);
    real *c[3] = {q->f.x, q->f.y, q->f.w};
    mpq_t before, after;
    bool exact = true;
    (void)reversed;
    mpq_init(before);
    mpq_init(after);
    for (int k = 0; k < (q->f.curve.w ? 3 : 2); k++) {
        for (int i = 0; q->f.curve.w && i <= n; i++)
            c[k][i] = c[k][i] * ((n + 1) * (n + 2));
        exact_value(n, c[k], (real)0.375, before);
        bernstein_elevate(n, c[k], more, c[k]);
        exact_value(n + more, c[k], (real)0.375, after);
        exact = exact && mpq_equal(before, after);
    }
    mpq_clear(before);
    mpq_clear(after);
    q->f.curve.degree = n + more;
    return exact;
}

/* Random curves of degree up to 6, dyadic coordinates with 20 bits times (n + 1)(n + 2), n the degree of f.
 */
static void make_multiples(struct planted *p, struct random_state *r, int i)
{
    int n = nasty_degree(r, 6);
    prop_curve_make(&p->f, r, n, 20, i % 3 == 0);
    prop_curve_make(&p->g, r, nasty_degree(r, 6), 20, i % 4 == 0);
    struct prop_curve *both[2] = {&p->f, &p->g};
    for (int k = 0; k < 2; k++)
        for (int j = 0; j <= both[k]->curve.degree; j++) {
            both[k]->x[j] = both[k]->x[j] * ((n + 1) * (n + 2));
            both[k]->y[j] = both[k]->y[j] * ((n + 1) * (n + 2));
        }
}

/* Groups as found, in the parameter of the unchanged f; false if the solve was not finished. */
static bool solve_groups(struct solver *z, const struct intersector *a, const struct planted *p,
                         bool reversed, struct groups *out)
{
    solver_init(z, a, p->f.curve.degree, p->g.curve.degree, WORKSPACE_ROOM);
    bool good = solve(z, p) == SOLVED && group(&z->answer.crossings, APART, out);
    solver_clear(z);
    for (int i = 0; good && reversed && i < out->count; i++) {
        real lo = out->at[i].t.lo;
        out->at[i].t.lo = 1 - out->at[i].t.hi;
        out->at[i].t.hi = 1 - lo;
    }
    return good;
}

/* Of the changes that are exact; pairs with an answer for one form only are counted, not compared. */
static void compare_groups(const char *what, change_function *change)
{
    for (int a = 0; intersectors[a]; a++) {
        int compared = 0, half = 0, found = 0;
        for (int i = 0; i < PAIRS; i++) {
            struct random_state r = random_for(1, what, (uint64_t)i);
            struct planted p, q;
            struct groups before, after;
            bool reversed = false;
            make_multiples(&p, &r, i);
            planted_copy(&q, &p);
            if (!change(&q, &r, &reversed))
                continue;
            bool solved = solve_groups(&first, intersectors[a], &p, false, &before);
            bool again = solve_groups(&second, intersectors[a], &q, reversed, &after);
            half += solved != again;
            if (!solved || !again)
                continue;
            compared++;
            found += before.count;
            if (!is_matched(&before, &after, APART))
                fail_msg("%s: pair %d has %d groups, %d after: %s", intersectors[a]->name, i, before.count,
                         after.count, what);
        }
        print_message("%-24s %s: %d compared, %d groups, %d finished in one form only\n",
                      intersectors[a]->name, what, compared, found, half);
        assert_true(4 * compared >= 3 * PAIRS && 20 * half <= PAIRS);
        assert_true(found > 0);
    }
}

static void test_translate(void **state)
{
    (void)state;
    compare_groups("translation", translate);
}

static void test_reverse(void **state)
{
    (void)state;
    compare_groups("reversal", reverse);
}

static void test_elevate(void **state)
{
    (void)state;
    compare_groups("elevation", elevate);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_translate),
        cmocka_unit_test(test_reverse),
        cmocka_unit_test(test_elevate),
    };
    return cmocka_run_group_tests_name("invariance", tests, NULL, NULL);
}
