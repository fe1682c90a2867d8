/* hull_meet against the exact upper hull of the points (i/n, c[i]). */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/hull.h"

enum { DEGREE = 32 };

/* Corners of the upper hull, left to right. */
struct chain {
    int length, at[DEGREE + 1];
};

/* Does point k lie on or below the segment from i to j?  i < k < j. */
static bool is_below(const struct dyadics *d, int i, int k, int j)
{
    mpz_t rise, run;
    mpz_init(rise);
    mpz_init(run);
    mpz_sub(rise, d->m[j], d->m[i]);
    mpz_mul_si(rise, rise, k - i);
    mpz_sub(run, d->m[k], d->m[i]);
    mpz_mul_si(run, run, j - i);
    bool below = mpz_cmp(run, rise) <= 0;
    mpz_clear(rise);
    mpz_clear(run);
    return below;
}

static void upper_hull(const struct dyadics *d, struct chain *c)
{
    c->length = 0;
    for (int i = 0; i <= d->n; i++) {
        while (c->length > 1 && is_below(d, c->at[c->length - 2], c->at[c->length - 1], i))
            c->length--;
        c->at[c->length++] = i;
    }
}

/* Where the segment between i and j, on different sides of 0, meets 0. */
static void crossing(const struct dyadics *d, int i, int j, mpq_t out)
{
    mpz_t a;
    mpz_init(a);
    mpz_mul_si(a, d->m[i], j);
    mpz_submul_ui(a, d->m[j], (unsigned long)i);
    mpz_sub(mpq_denref(out), d->m[i], d->m[j]);
    mpz_mul_si(mpq_denref(out), mpq_denref(out), d->n);
    mpz_set(mpq_numref(out), a);
    mpq_canonicalize(out);
    mpz_clear(a);
}

/* The hull meets {y >= 0} over [lo, hi]; false if nowhere.  Its upper chain is concave. */
static bool exact_meet(int n, const real *c, mpq_t lo, mpq_t hi)
{
    struct dyadics d;
    struct chain chain;
    dyadics_init(&d);
    dyadics_set(&d, n, c);
    upper_hull(&d, &chain);
    int first = 0, last = chain.length - 1;
    while (first < chain.length && mpz_sgn(d.m[chain.at[first]]) < 0)
        first++;
    while (last >= 0 && mpz_sgn(d.m[chain.at[last]]) < 0)
        last--;
    mpq_set_ui(lo, 0, 1);
    mpq_set_ui(hi, 1, 1);
    if (first > 0 && first < chain.length)
        crossing(&d, chain.at[first - 1], chain.at[first], lo);
    if (last >= 0 && last < chain.length - 1)
        crossing(&d, chain.at[last], chain.at[last + 1], hi);
    dyadics_clear(&d);
    return first < chain.length;
}

/* Coefficients as of distances to a strip: small against what was subtracted, rising, falling, or any. */
static void make(struct random_state *r, int n, real *c)
{
    nasty_coefficients(r, n, c);
    if (random_bits(r) % 2) {
        real start = prop_bits(r, (int)random_between(r, -40, 1));
        for (int i = 0; i <= n; i++)
            c[i] = start + i * prop_dyadic(r, 20) * (real)0.125;
    }
}

/* What is kept covers the exact part of [lo, hi], and reaches past it by no more than 8 eps. */
static void check(int n, const real *c, struct interval t, int i)
{
    mpq_t from, to, a, pad;
    mpq_init(from);
    mpq_init(to);
    mpq_init(a);
    mpq_init(pad);
    mpq_set_ui(pad, 16, 1);
    mpq_div_2exp(pad, pad, REAL_BITS);
    bool meets = exact_meet(n, c, from, to);
    struct interval kept = t;
    real_to_rational(t.lo, a);
    if (mpq_cmp(from, a) < 0)
        mpq_set(from, a);
    real_to_rational(t.hi, a);
    if (mpq_cmp(to, a) > 0)
        mpq_set(to, a);
    meets = meets && mpq_cmp(from, to) <= 0;
    int found = hull_meet(n, c, &kept.lo, &kept.hi);
    if (!found)
        assert_true(kept.lo == t.lo && kept.hi == t.hi);
    assert_true(kept.lo >= t.lo && kept.hi <= t.hi && kept.lo <= kept.hi);
    if (meets) {
        real_to_rational(kept.lo, a);
        bool covers = found && mpq_cmp(a, from) <= 0;
        mpq_add(a, a, pad);
        bool close = mpq_cmp(a, from) >= 0;
        real_to_rational(kept.hi, a);
        covers = covers && mpq_cmp(a, to) >= 0;
        mpq_sub(a, a, pad);
        close = close && mpq_cmp(a, to) <= 0;
        if (!covers || !close)
            fail_msg("hull %d: degree %d: %s", i, n, covers ? "keeps too much" : "cuts off");
    }
    mpq_clear(from);
    mpq_clear(to);
    mpq_clear(a);
    mpq_clear(pad);
}

static void test_meet(void **state)
{
    (void)state;
    for (int i = 0; i < trials(20000); i++) {
        struct random_state r = random_for(1, "hull", (uint64_t)i);
        real c[DEGREE + 1];
        int n = nasty_degree(&r, DEGREE);
        make(&r, n, c);
        struct interval all = {0, 1};
        check(n, c, i % 2 ? all : nasty_interval(&r), i);
    }
}

/* The hull may touch 0 in one point only: it is kept. */
static void test_touch(void **state)
{
    (void)state;
    for (int n = 1; n <= DEGREE; n++)
        for (int k = 0; k <= n; k++) {
            real c[DEGREE + 1];
            for (int i = 0; i <= n; i++)
                c[i] = i == k ? 0 : -1 - i;
            const struct interval all = {0, 1};
            check(n, c, all, n);
        }
}

/* Nothing above 0: nothing is kept. */
static void test_below(void **state)
{
    (void)state;
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(1, "below", (uint64_t)i);
        real c[DEGREE + 1], lo = 0, hi = 1;
        int n = nasty_degree(&r, DEGREE);
        for (int k = 0; k <= n; k++)
            c[k] = -real_abs(prop_bits(&r, (int)random_between(&r, -200, 200)));
        assert_int_equal(hull_meet(n, c, &lo, &hi), 0);
        assert_true(lo == 0 && hi == 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_meet),
        cmocka_unit_test(test_touch),
        cmocka_unit_test(test_below),
    };
    return cmocka_run_group_tests_name("hull", tests, NULL, NULL);
}
