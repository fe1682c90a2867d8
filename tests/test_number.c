/* Numbers as text, exact rationals and reals: agreement with MPFR and the C library, and round trips. */
#include <float.h>
#include <gmp.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/cases/number.h"

enum { TRIALS = 5000 };

struct format {
    int bits;
    long exponent_min;
};

static const struct format format[] = {{24, -149}, {53, -1074}, {113, -16494}, {2048, -5000}};

/* Integer with up to `bits` random bits. */
static void random_integer(struct random_state *r, int bits, mpz_t z)
{
    mpz_set_ui(z, 0);
    for (int have = 0; have < bits; have += 32) {
        mpz_mul_2exp(z, z, 32);
        mpz_add_ui(z, z, (unsigned long)(random_bits(r) >> 32));
    }
    mpz_fdiv_r_2exp(z, z, (mp_bitcnt_t)bits);
}

/* Any sign; every third one is a tie, or nearly one, of numbers of `bits` bits. */
static void random_rational(struct random_state *r, const struct format *f, mpq_t q)
{
    int kind = (int)random_between(r, 0, 5);

    random_integer(r, kind < 4 ? f->bits + 1 : (int)random_between(r, 1, 3000), mpq_numref(q));
    if (kind < 2)
        mpz_setbit(mpq_numref(q), 0);
    if (kind == 1) {
        mpz_mul_2exp(mpq_numref(q), mpq_numref(q), 3000);
        mpz_add_ui(mpq_numref(q), mpq_numref(q), 1);
    }
    random_integer(r, kind < 4 ? 1 : (int)random_between(r, 1, 3000), mpq_denref(q));
    if (mpz_sgn(mpq_denref(q)) == 0)
        mpz_set_ui(mpq_denref(q), 1);
    mpq_canonicalize(q);
    /* around 1, or around the smallest numbers of the format */
    number_scale(q, random_between(r, -70, 10) + (random_bits(r) & 1 ? f->exponent_min : 0));
    if (random_bits(r) & 1)
        mpq_neg(q, q);
}

/* By MPFR, whose numbers of exponent >= e + 1 are the multiples of 2^e, subnormal ones included. */
static void round_by_mpfr(const mpq_t q, const struct format *f, mpq_t rounded)
{
    mpfr_exp_t before = mpfr_get_emin();
    mpfr_t a;
    int ternary;

    mpfr_init2(a, f->bits);
    mpfr_set_emin(f->exponent_min + 1);
    ternary = mpfr_set_q(a, q, MPFR_RNDN);
    mpfr_subnormalize(a, ternary, MPFR_RNDN);
    mpfr_set_emin(before);
    mpfr_get_q(rounded, a);
    mpfr_clear(a);
}

static void test_round_agrees_with_mpfr(void **state)
{
    (void)state;
    mpq_t q, expected, got;
    long e;
    mpq_init(q);
    mpq_init(expected);
    mpq_init(got);
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(1, "round", (uint64_t)i);
        const struct format *f = &format[i % 4];
        random_rational(&r, f, q);
        round_by_mpfr(q, f, expected);
        number_round(q, f->bits, f->exponent_min, mpq_numref(got), &e);
        assert_true(e >= f->exponent_min && mpz_sizeinbase(mpq_numref(got), 2) <= (size_t)f->bits + 1);
        mpz_set_ui(mpq_denref(got), 1);
        number_scale(got, e);
        assert_true(mpq_equal(got, expected));
        if (f->bits == DBL_MANT_DIG && isfinite(number_to_double(q)))
            assert_true(number_to_double(q) == mpq_get_d(expected));
        real a = real_from_rational(q);
        if (f->bits == REAL_BITS && REAL_BITS <= 113 && real_is_finite(a)) {
            real_to_rational(a, got);
            assert_true(mpq_equal(got, expected));
        }
    }
    mpq_clear(q);
    mpq_clear(expected);
    mpq_clear(got);
}

/* Where the type ends. */
static void test_largest(void **state)
{
    (void)state;
    mpq_t q;
    mpq_init(q);
    mpq_set_d(q, DBL_MAX);
    assert_true(number_to_double(q) == DBL_MAX);
    assert_true(number_parse("0x1.fffffffffffff7ffffp1023", q) && number_to_double(q) == DBL_MAX);
    assert_true(number_parse("0x1.fffffffffffff8p1023", q) && number_to_double(q) == INFINITY);
    assert_true(number_parse("-1e4000", q) && number_to_double(q) == -INFINITY);
#if !defined(FATLINE_MULTI)
    real_to_rational(-REAL_HUGE, q);
    assert_true(real_from_rational(q) == -REAL_HUGE);
    mpq_mul_2exp(q, q, 1);
    assert_true(real_from_rational(q) < -REAL_HUGE);
    real a = 7;
    assert_false(real_parse("-1e4999", &a));
    assert_true(a == 7);
#endif
    mpq_clear(q);
}

/* Finite, any exponent of the type, subnormal ones included; small ones and whole ones more often. */
static real random_real(struct random_state *r)
{
    static const int range[] = {3, 60, REAL_BITS == 53 ? 1023 : 16000};
    int e = (int)random_between(r, -range[random_bits(r) % 3], 60);

    if (random_bits(r) % 4 == 0)
        return prop_dyadic(r, 20) * (double)random_between(r, 0, 1 << 20);
    if (REAL_BITS < 2048 && random_bits(r) % 4 == 0)
        e = (int)random_between(r, -60, 0) + (REAL_BITS == 53 ? -1021 : -16381);
    return prop_bits(r, e);
}

static void test_round_trips(void **state)
{
    (void)state;
    char text[REAL_TEXT_MAX];
    mpq_t q, exact;
    mpq_init(q);
    mpq_init(exact);
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(2, "round trips", (uint64_t)i);
        real a = random_real(&r), b;
        real_text(a, text, sizeof text);
        assert_true(strlen(text) < REAL_TEXT_MAX - 40);
        assert_true(real_parse(text, &b) && a == b);
        real_to_rational(a, exact);
        assert_true(real_from_rational(exact) == a);
        if (REAL_BITS > 53) /* the text is a hex float, and so exact */
            assert_true(number_parse(text, q) && mpq_equal(q, exact));
        gmp_snprintf(text, 40, "%lld/%lld", (long long)random_between(&r, -999999, 999999),
                     (long long)random_between(&r, 1, 999999));
        assert_true(number_parse(text, q) && real_parse(text, &b) && b == real_from_rational(q));
    }
    mpq_clear(q);
    mpq_clear(exact);
}

/* The value and the sign of a zero. */
static void assert_same_double(double a, double b)
{
    assert_true(a == b && !signbit(a) == !signbit(b));
}

static double random_double(struct random_state *r)
{
    double a;

    do {
        uint64_t bits = random_bits(r);
        if (bits % 8 == 0)
            return ldexp((double)random_between(r, -99999, 99999), -(int)random_between(r, 0, 30));
        memcpy(&a, &bits, sizeof a);
    } while (!isfinite(a));
    return a;
}

static void test_shortest_text(void **state)
{
    (void)state;
    char text[64], shorter[64];
    int e;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(3, "shortest", (uint64_t)i);
        double a = i % 10 ? random_double(&r) : ldexp(random_double(&r), -1080);
        number_text_double(a, text, sizeof text);
        assert_same_double(strtod(text, NULL), a);
        if (fabs(frexp(a, &e)) == 0.5 || a == 0)
            continue;
        int digits = 0;
        for (const char *c = text; *c && *c != 'e'; c++)
            digits += *c >= '1' || (*c == '0' && digits);
        if (!strchr(text, '.')) /* zeros that end an integer say where the point is */
            for (const char *c = text + strcspn(text, "e"); c > text && *--c == '0';)
                digits--;
        snprintf(shorter, sizeof shorter, "%.*e", digits - 2 < 0 ? 0 : digits - 2, a);
        assert_true(digits == 1 || strtod(shorter, NULL) != a);
    }
}

static void test_agrees_with_c_library(void **state)
{
    (void)state;
    char text[128];
    mpq_t q;
    mpq_init(q);
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(4, "strtod", (uint64_t)i);
        double a = random_double(&r);
        snprintf(text, sizeof text, "%.*e", (int)random_between(&r, 0, 25), a);
        assert_true(number_parse(text, q) && number_to_double(q) == strtod(text, NULL));
        snprintf(text, sizeof text, "%a", a);
        assert_true(number_parse(text, q) && number_to_double(q) == a);
        a = ldexp(random_unit(&r) - 0.5, (int)random_between(&r, -152, 120));
        snprintf(text, sizeof text, "%.*gf", (int)random_between(&r, 1, 25), a);
        assert_true(number_parse(text, q) && number_to_double(q) == strtof(text, NULL));
    }
    mpq_clear(q);
}

static void test_forms(void **state)
{
    (void)state;
    static const char *const same[][2] = {
        {"-1.25e-3", "-1/800"},
        {"+3/16", "0x3p-4"},
        {"6/4", "1.5"},
        {"0/7", "-0.000"},
        {"0x1.8p-4", "3/32"},
        {"0X.8P+1", "1."},
        {"0x1f", "31"},
        {"-0xAp0", "-10e0"},
        {".5", "5E-1"},
        {"0.1f", "13421773/134217728"},
        {"16777217f", "16777216"},
        {"16777219.f", "16777220"},
        {"1e-46f", "0"},
        {"3.4028235e38f", "0x1.fffffep127"},
        {"100000000000000000000000000000001/100000000000000000000000000000000",
         "1.00000000000000000000000000000001"},
        {"1e-5000", "0.1e-4999"},
    };
    mpq_t p, q;
    mpq_init(p);
    mpq_init(q);
    for (size_t i = 0; i < sizeof same / sizeof *same; i++)
        if (!number_parse(same[i][0], p) || !number_parse(same[i][1], q) || !mpq_equal(p, q))
            fail_msg("%s is not %s", same[i][0], same[i][1]);
    mpq_clear(p);
    mpq_clear(q);
}

static void reject(const char *text)
{
    bool exponent_of_multi = REAL_BITS == 2048 && strncmp(text, "0x1p", 4) == 0 && strlen(text) < 12;
    real a = 7;
    mpq_t q;

    mpq_init(q);
    mpq_set_ui(q, 3, 7);
    if (number_parse(text, q) || mpq_cmp_ui(q, 3, 7) != 0)
        fail_msg("\"%s\" was taken for a number", text);
    if (!exponent_of_multi && (real_parse(text, &a) || a != 7))
        fail_msg("\"%s\" was taken for a real", text);
    mpq_clear(q);
}

static void test_rejects(void **state)
{
    (void)state;
    char bad[] =
        "nan inf -inf NaN infinity 1/0 1/ /2 1/-2 1.5/2 1/2/3 1/2f - + --1 . e5 1e 1e+ 1e5001 1e-5001 "
        "1ee5 1.2.3 0x 0xp1 0x. 0x1.8p 0x1p20001 0x1p-20001 0x1.8p1f 0xg 1f2 1ff 1e39f f "
        "3.40282357e38f 1,5 1_000 0x1@5 12a 1e99999999999999999999 0x1p99999999999999999999999";
    char text[NUMBER_LENGTH_MAX + 2];

    for (char *word = strtok(bad, " "); word; word = strtok(NULL, " "))
        reject(word);
    reject("");
    reject(" 1");
    reject("1 ");
    reject("0x1 ");
    memset(text, '1', sizeof text);
    text[NUMBER_LENGTH_MAX + 1] = '\0';
    reject(text);
}

#if defined(FATLINE_MULTI)
/* Exponents far beyond those of number_parse survive. */
static void test_wide_exponents(void **state)
{
    (void)state;
    char text[REAL_TEXT_MAX];
    for (int i = 0; i < 100; i++) {
        struct random_state r = random_for(5, "wide", (uint64_t)i);
        real a = prop_bits(&r, (int)random_between(&r, -1000000000, 1000000000)), b;
        real_text(a, text, sizeof text);
        assert_true(strlen(text) < REAL_TEXT_MAX - 40 && real_parse(text, &b) && a == b);
    }
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_agrees_with_mpfr),
        cmocka_unit_test(test_largest),
        cmocka_unit_test(test_round_trips),
        cmocka_unit_test(test_shortest_text),
        cmocka_unit_test(test_agrees_with_c_library),
        cmocka_unit_test(test_forms),
        cmocka_unit_test(test_rejects),
#if defined(FATLINE_MULTI)
        cmocka_unit_test(test_wide_exponents),
#endif
    };
    return cmocka_run_group_tests_name("number", tests, NULL, NULL);
}
