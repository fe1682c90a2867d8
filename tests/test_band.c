/* Bands: nothing where the polynomial is >= 0 is left out, proved by exact subdivision of every gap. */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/band.h"
#include "../algorithms/core/bernstein.h"

enum { DEGREE = BAND_DEGREE_MAX, LEVELS = 400 };

/* Is d below 0 everywhere on [0, 1], and at the ends if they count?  By halving, exactly. */
static bool is_negative(const struct dyadics *d, bool first, bool last, int levels)
{
    int inside = 0;
    for (int i = 1; i < d->n; i++)
        inside += mpz_sgn(d->m[i]) <= 0;
    bool below = inside == d->n - 1 && mpz_sgn(d->m[0]) <= 0 && mpz_sgn(d->m[d->n]) <= 0;
    bool ends = (!first || mpz_sgn(d->m[0]) < 0) && (!last || mpz_sgn(d->m[d->n]) < 0);
    bool zero = true;
    for (int i = 0; i <= d->n; i++)
        zero = zero && mpz_sgn(d->m[i]) == 0;
    if (!ends || zero || mpz_sgn(d->m[0]) > 0 || mpz_sgn(d->m[d->n]) > 0 || levels == 0)
        return false;
    if (below)
        return true;
    struct dyadics left, right;
    dyadics_init(&left);
    dyadics_init(&right);
    left.n = right.n = d->n;
    left.e = right.e = d->e - d->n;
    mpz_t *row = right.m;
    for (int i = 0; i <= d->n; i++)
        mpz_mul_2exp(row[i], d->m[i], (mp_bitcnt_t)d->n);
    mpz_set(left.m[0], row[0]);
    for (int k = 1; k <= d->n; k++) {
        for (int i = 0; i <= d->n - k; i++) {
            mpz_add(row[i], row[i], row[i + 1]);
            mpz_tdiv_q_2exp(row[i], row[i], 1); /* exact: n factors 2 were put in */
        }
        mpz_set(left.m[k], row[0]);
    }
    bool both = is_negative(&left, first, true, levels - 1) && is_negative(&right, true, last, levels - 1);
    dyadics_clear(&left);
    dyadics_clear(&right);
    return both;
}

/* c < 0 on the gap between lo and hi; at these themselves, which the band holds, it may be 0. */
static bool is_negative_between(int k, const real *c, real lo, real hi, bool first, bool last)
{
    mpq_t q[DEGREE + 1];
    struct dyadics d;
    mp_bitcnt_t bits = 0;
    dyadics_init(&d);
    rationals_init(k + 1, q);
    dyadics_set(&d, k, c);
    exact_restrict(&d, lo, hi, q);
    for (int i = 0; i <= k; i++) {
        mp_bitcnt_t own = mpz_scan1(mpq_denref(q[i]), 0);
        bits = own > bits ? own : bits;
    }
    d.n = k;
    d.e = -(long)bits;
    for (int i = 0; i <= k; i++) {
        mpq_mul_2exp(q[i], q[i], bits);
        mpz_set(d.m[i], mpq_numref(q[i]));
    }
    bool negative = is_negative(&d, first, last, LEVELS);
    rationals_clear(k + 1, q);
    dyadics_clear(&d);
    return negative;
}

static bool is_ordered(const struct band *b)
{
    bool ordered = b->count >= 0 && b->count <= BAND_PIECES_MAX;
    for (int i = 0; ordered && i < b->count; i++)
        ordered = b->lo[i] >= (i ? b->hi[i - 1] : (real)0) && b->lo[i] <= b->hi[i] && b->hi[i] <= 1;
    return ordered;
}

static bool covers(int k, const real *c, const struct band *b)
{
    real from = 0;
    for (int i = 0; i <= b->count; i++) {
        bool last = i == b->count;
        real to = last ? (real)1 : b->lo[i];
        if ((from < to || (last && b->count == 0)) && !is_negative_between(k, c, from, to, i == 0, last))
            return false;
        from = last ? to : b->hi[i];
    }
    return true;
}

/* Planted roots: products of linear factors with Bernstein coefficients r, r - 1, rounded. */
static void plant_roots(struct random_state *r, int k, real *c)
{
    real root = nasty_unit(r), sign = random_bits(r) % 2 ? 1 : -1;
    c[0] = sign * root;
    c[1] = sign * (root - 1);
    for (int n = 1; n < k; n++) {
        real gap = real_ldexp(prop_unit(r, 10), -(int)random_between(r, 0, REAL_BITS));
        root =
            random_bits(r) % 3 == 0 ? nasty_unit(r) : root + gap; /* often close to the one before, or it */
        c[n + 1] = c[n] * (root - 1);
        for (int i = n; i > 0; i--)
            c[i] = ((n + 1 - i) * (c[i] * root) + i * (c[i - 1] * (root - 1))) / (n + 1);
        c[0] = c[0] * root;
    }
}

static void make(struct random_state *r, int k, real *c)
{
    switch (random_bits(r) % 4) {
    case 0:
        nasty_coefficients(r, k, c);
        break;
    case 1: /* a double root in exact numbers: (t - root)^2 times at most a linear factor */
        for (int i = 0; i <= k; i++)
            c[i] = 0;
        {
            real root = prop_unit(r, 6), sign = random_bits(r) % 2 ? 1 : -1;
            real square[3] = {root * root, root * (root - 1), (1 - root) * (1 - root)};
            real line[2] = {3 * sign * prop_unit(r, 6), 3 * sign * prop_dyadic(r, 6)};
            for (int i = 0; i <= k && k < 3; i++)
                c[i] = k == 2 ? sign * square[i] : line[i];
            if (k >= 3) {
                c[0] = square[0] * line[0];
                c[1] = (2 * square[1] * line[0] + square[0] * line[1]) / 3;
                c[2] = (square[2] * line[0] + 2 * square[1] * line[1]) / 3;
                c[3] = square[2] * line[1];
                bernstein_elevate(3, c, k - 3, c);
            }
        }
        break;
    case 2:
        plant_roots(r, k, c);
        break;
    default: /* as the algorithms meet them: nearly linear, small against the interval */
        for (int i = 0; i <= k; i++)
            c[i] = prop_dyadic(r, 20) * (real)0.001 + i * prop_bits(r, 0);
    }
}

static void test_above(void **state)
{
    (void)state;
    for (int i = 0; i < trials(12000); i++) {
        struct random_state r = random_for(1, "band", (uint64_t)i);
        int k = 1 + i % DEGREE;
        real c[DEGREE + 1];
        struct band b;
        make(&r, k, c);
        band_above(k, c, &b);
        if (!is_ordered(&b))
            fail_msg("band %d: degree %d: pieces overlap", i, k);
        if (!covers(k, c, &b))
            fail_msg("band %d: degree %d: a part above 0 is missing", i, k);
    }
}

/* Roots 1/4 and 3/4 apart from each other by far: the band is the exact set, to 2^12 eps. */
static void test_close(void **state)
{
    (void)state;
    const real few = 4096 * REAL_EPSILON;
    for (int i = 0; i < trials(3000); i++) {
        struct random_state r = random_for(1, "close", (uint64_t)i);
        int k = 1 + i % DEGREE;
        real a = (real)0.125 + prop_unit(&r, 20) / 4, z = (real)0.625 + prop_unit(&r, 20) / 4;
        real c[DEGREE + 1] = {a, a - 1, 0, 0, 0, 0}; /* a - t */
        struct band b;
        if (k == 2) {
            c[0] = a * z;
            c[1] = (a * (z - 1) + (a - 1) * z) / 2;
            c[2] = (a - 1) * (z - 1);
        } else if (k >= 3) {
            c[0] = 3 * a * z;
            c[1] = a * (z - 1) + (a - 1) * z + a * z;
            c[2] = (a - 1) * (z - 1) + a * (z - 1) + (a - 1) * z;
            c[3] = 3 * (a - 1) * (z - 1);
            bernstein_elevate(3, c, k - 3, c);
        }
        band_above(k, c, &b);
        assert_int_equal(b.count, k == 1 ? 1 : 2);
        assert_true(b.lo[0] == 0 && b.hi[0] >= a && b.hi[0] <= a + few);
        if (k > 1)
            assert_true(b.lo[1] <= z && b.lo[1] >= z - few && b.hi[1] == 1);
    }
}

static bool holds(const struct band *b, real t)
{
    bool inside = false;
    for (int i = 0; i < b->count; i++)
        inside = inside || (b->lo[i] <= t && t <= b->hi[i]);
    return inside;
}

static void make_band(struct random_state *r, struct band *b)
{
    real at = 0;
    b->count = (int)random_between(r, 0, BAND_PIECES_MAX);
    for (int i = 0; i < b->count; i++) {
        b->lo[i] = at + (i ? (1 + (int)(random_bits(r) % 3)) : (int)(random_bits(r) % 3)) * (real)0.03125;
        b->hi[i] = b->lo[i] + (int)(random_bits(r) % 3) * (real)0.03125;
        at = b->hi[i];
    }
}

/* Common part and union, point by point; where pieces had to be joined, more may be kept but not less. */
static void test_sets(void **state)
{
    (void)state;
    for (int i = 0; i < trials(5000); i++) {
        struct random_state r = random_for(1, "sets", (uint64_t)i);
        struct band a, b, common, all;
        make_band(&r, &a);
        make_band(&r, &b);
        band_meet(&a, &b, &common);
        band_join(&a, &b, &all);
        assert_true(is_ordered(&common) && is_ordered(&all));
        for (int k = 0; k <= 64; k++) {
            real t = (real)k / 64;
            bool both = holds(&a, t) && holds(&b, t), either = holds(&a, t) || holds(&b, t);
            assert_true(!both || holds(&common, t));
            assert_true(!either || holds(&all, t));
            assert_true(both || !holds(&common, t) || common.count == BAND_PIECES_MAX);
            assert_true(either || !holds(&all, t) || all.count == BAND_PIECES_MAX);
        }
    }
}

/* -(1 - t)^2 + d^2 and its mirror image, degrees 2 to 5: beside its stationary point at an end the polynomial
 * is small for long, and what is kept is d wide nevertheless, down to where d^2 is rounding. */
static void test_stationary_end(void **state)
{
    (void)state;
    for (int e = 1; 2 * e < REAL_BITS - 12; e++)
        for (int k = 2; k <= DEGREE; k++) {
            real d = real_ldexp(1, -e), c[DEGREE + 1] = {d * d - 1, d * d, d * d}, mirrored[DEGREE + 1];
            struct band kept, other;
            bernstein_elevate(2, c, k - 2, c);
            for (int i = 0; i <= k; i++)
                mirrored[i] = c[k - i];
            band_above(k, c, &kept);
            band_above(k, mirrored, &other);
            if (kept.count != 1 || kept.hi[0] < 1 || kept.hi[0] - kept.lo[0] > 2 * d)
                fail_msg("degree %d, 2^-%d: %d intervals, not one to the end", k, e, kept.count);
            if (other.count != 1 || other.lo[0] > 0 || other.hi[0] > 2 * d)
                fail_msg("degree %d, 2^-%d, mirrored: %d intervals, not one from the start", k, e,
                         other.count);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_above),
        cmocka_unit_test(test_close),
        cmocka_unit_test(test_sets),
        cmocka_unit_test(test_stationary_end),
    };
    return cmocka_run_group_tests_name("band", tests, NULL, NULL);
}
