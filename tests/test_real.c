/* The number type: what real.h promises, at every precision, against exact rational arithmetic. */
#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/cases/number.h"

enum { TRIALS = 10000 };

static real add(real a, real b)
{
    return a + b;
}
static real subtract(real a, real b)
{
    return a - b;
}
static real multiply(real a, real b)
{
    return a * b;
}
static real divide(real a, real b)
{
    return a / b;
}

struct operation {
    real (*rounded)(real, real);
    void (*exact)(mpq_ptr, mpq_srcptr, mpq_srcptr);
};

static const struct operation operation[] = {
    {add, mpq_add},
    {subtract, mpq_sub},
    {multiply, mpq_mul},
    {divide, mpq_div},
};

/* Distance of neighbours in [2^(e-1), 2^e), e the exponent of a. */
static real spacing(real a)
{
    return real_ldexp(1, real_exponent(a) - REAL_BITS);
}

/* |rounded - exact| <= the half spacing at `rounded`, and nearest as real_from_rational has it. */
static void assert_nearest(real rounded, const mpq_t exact)
{
    mpq_t error, bound;

    mpq_init(error);
    mpq_init(bound);
    if (rounded == 0) {
        assert_int_equal(mpq_sgn(exact), 0);
    } else {
        real_to_rational(rounded, error);
        mpq_sub(error, error, exact);
        mpq_abs(error, error);
        real_to_rational(spacing(rounded) / 2, bound);
        assert_true(mpq_cmp(error, bound) <= 0);
    }
    assert_true(rounded == real_from_rational(exact));
    mpq_clear(error);
    mpq_clear(bound);
}

static void test_operations_are_nearest(void **state)
{
    (void)state;
    mpq_t p, q, exact;
    mpq_init(p);
    mpq_init(q);
    mpq_init(exact);
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(1, "operations", (uint64_t)i);
        /* Exponents close together, so that sums cancel and carry; short numbers, so that ties occur. */
        real a = i % 4 ? prop_bits(&r, (int)random_between(&r, -60, 60)) : prop_dyadic(&r, 30);
        real b = i % 3 ? prop_bits(&r, (int)random_between(&r, -60, 60)) : prop_dyadic(&r, 12);
        if (i % 5 == 0)
            b = real_ldexp(b, REAL_BITS - 20);
        b = b == 0 ? (real)1 : b;
        real_to_rational(a, p);
        real_to_rational(b, q);
        for (int k = 0; k < 4; k++) {
            operation[k].exact(exact, p, q);
            assert_nearest(operation[k].rounded(a, b), exact);
        }
    }
    mpq_clear(p);
    mpq_clear(q);
    mpq_clear(exact);
}

/* r = real_sqrt(a): (r - u/2)^2 <= a <= (r + u/2)^2 with u the spacing at r. */
static void test_sqrt_is_nearest(void **state)
{
    (void)state;
    mpq_t a, root, half, side;
    mpq_init(a);
    mpq_init(root);
    mpq_init(half);
    mpq_init(side);
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(2, "sqrt", (uint64_t)i);
        real x = real_abs(prop_bits(&r, (int)random_between(&r, -900, 900)));
        real_to_rational(x, a);
        real_to_rational(real_sqrt(x), root);
        real_to_rational(spacing(real_sqrt(x)) / 2, half);
        mpq_sub(side, root, half);
        mpq_mul(side, side, side);
        assert_true(mpq_cmp(side, a) <= 0);
        mpq_add(side, root, half);
        mpq_mul(side, side, side);
        assert_true(mpq_cmp(side, a) >= 0);
        x = prop_dyadic(&r, 20);
        assert_true(real_sqrt(x * x) == real_abs(x));
    }
    mpq_clear(a);
    mpq_clear(root);
    mpq_clear(half);
    mpq_clear(side);
    assert_true(real_sqrt(0) == 0);
}

/* Integers and doubles beside a real mean the reals of the same value. */
static void test_mixed_operands(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(3, "mixed", (uint64_t)i);
        real a = prop_bits(&r, (int)random_between(&r, -9, 9));
        int n = (int)random_between(&r, -9, 9);
        double d = ldexp((double)random_between(&r, -99, 99), (int)random_between(&r, -9, 9));
        real exact_n = (real)n, exact_d = (real)d;

        assert_true(a + n == a + exact_n && n + a == exact_n + a && a + d == a + exact_d);
        assert_true(a - n == a - exact_n && n - a == exact_n - a && d - a == exact_d - a);
        assert_true(a * n == a * exact_n && n * a == exact_n * a && d * a == exact_d * a);
        assert_true(n == 0 || a / n == a / exact_n);
        assert_true(n / a == exact_n / a && d / a == exact_d / a);
        assert_int_equal(a < n, a < exact_n);
        assert_int_equal(n < a, exact_n < a);
        assert_int_equal(a <= d, a <= exact_d);
        assert_true(exact_n == n && n == exact_n && exact_d == d && !(exact_n != n));
        assert_true((int)exact_n == n && (double)exact_d == d && real_to_double(exact_d) == d);
        real b = a;
        b += n;
        b -= d;
        b *= n;
        assert_true(b == (a + exact_n - exact_d) * exact_n);
        b = a;
        b /= 3;
        assert_true(b == a / (real)3 && -(-a) == a && -a == 0 - a);
    }
}

static int sign_of(real a)
{
    return (a > 0) - (a < 0);
}

static void test_order_is_that_of_the_rationals(void **state)
{
    (void)state;
    mpq_t p, q;
    mpq_init(p);
    mpq_init(q);
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(4, "order", (uint64_t)i);
        real a = prop_bits(&r, (int)random_between(&r, -2, 2));
        real b = i % 2 ? prop_bits(&r, (int)random_between(&r, -2, 2)) : a + (i % 3 - 1) * spacing(a);
        real_to_rational(a, p);
        real_to_rational(b, q);
        int order = mpq_cmp(p, q);
        assert_int_equal(a < b, order < 0);
        assert_int_equal(a <= b, order <= 0);
        assert_int_equal(a > b, order > 0);
        assert_int_equal(a >= b, order >= 0);
        assert_int_equal(a == b, order == 0);
        assert_int_equal(a != b, order != 0);
        assert_int_equal(sign_of(a), mpq_sgn(p));
        assert_true(real_abs(a) >= 0 && real_min(a, b) <= real_max(a, b));
    }
    mpq_clear(p);
    mpq_clear(q);
}

static void test_exponents(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(5, "exponents", (uint64_t)i);
        int e = (int)random_between(&r, -400, 400), shift = (int)random_between(&r, -400, 400);
        real a = prop_bits(&r, e);
        assert_int_equal(real_exponent(a), e);
        assert_true(real_ldexp(1, e - 1) <= real_abs(a) && real_abs(a) < real_ldexp(1, e));
        assert_true(real_ldexp(real_ldexp(a, shift), -shift) == a);
        assert_int_equal(real_exponent(real_ldexp(a, shift)), e + shift);
    }
}

static void test_constants(void **state)
{
    (void)state;
    static const real table[] = {1, (real)1 / 3, 2 * (real)0.5};
    real zero = 0, infinite = REAL_HUGE * 2, nan = zero / zero;

    assert_true(REAL_EPSILON == real_ldexp(1, 1 - REAL_BITS));
    assert_true(1 + REAL_EPSILON > 1 && 1 + REAL_EPSILON / 2 == 1 && 1 - REAL_EPSILON / 2 < 1);
    assert_true(8 * REAL_EPSILON == real_ldexp(REAL_EPSILON, 3));
    assert_true(real_is_finite(REAL_HUGE) && real_is_finite(zero) && real_is_finite(-zero));
    assert_false(real_is_finite(infinite) || real_is_finite(-infinite) || real_is_finite(nan));
    assert_true(REAL_HUGE > 1e300 && infinite > REAL_HUGE && -infinite < 0);
    assert_false(nan == nan || nan < 0 || nan > 0 || nan <= 0 || 0 >= nan || nan < infinite);
    assert_false(nan <= zero || zero >= nan || nan <= nan || nan > zero || nan == zero);
    assert_true(nan != nan && nan != 0 && zero == -zero && 1 / infinite == 0);
    assert_false(real_is_finite(1 / zero) || real_is_finite(real_sqrt(-1)));
    assert_true(table[0] == table[2] && real_abs(3 * table[1] - 1) <= REAL_EPSILON);
}

#if defined(FATLINE_MULTI)

static void *refuse(size_t size)
{
    fail_msg("allocated %zu bytes", size);
    return NULL;
}

static void test_plain_bytes(void **state)
{
    (void)state;
    struct random_state r = random_for(6, "bytes", 0);
    real a = prop_bits(&r, 5), b;
    real *zeroed = (real *)calloc(1, sizeof *zeroed);

    assert_true(zeroed[0] != zeroed[0] && !real_is_finite(zeroed[0]) && zeroed[0] + 1 != zeroed[0] + 1);
    memcpy(&b, &a, sizeof a);
    assert_true(a == b && a - b == 0);
    free(zeroed);
}

/* MPFR and GMP take their memory through GMP's hooks; arithmetic takes none. */
static void test_no_allocation(void **state)
{
    (void)state;
    struct random_state r = random_for(7, "allocation", 0);
    real a = prop_bits(&r, 5), b = prop_bits(&r, -5), c = 0;
    void *(*allocate)(size_t);
    void *(*reallocate)(void *, size_t, size_t);
    void (*release)(void *, size_t);

    mp_get_memory_functions(&allocate, &reallocate, &release);
    mp_set_memory_functions(refuse, reallocate, release);
    for (int i = 1; i < 100; i++) {
        c += (a * b + a / b - real_sqrt(real_abs(b))) / i + 0.5 * (a - i);
        c = c < 0 ? -c : 3 * c;
        a = real_ldexp(a + (double)b, i % 3 - 1);
    }
    mp_set_memory_functions(allocate, reallocate, release);
    assert_true(c > 0);
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_operations_are_nearest),
        cmocka_unit_test(test_sqrt_is_nearest),
        cmocka_unit_test(test_mixed_operands),
        cmocka_unit_test(test_order_is_that_of_the_rationals),
        cmocka_unit_test(test_exponents),
        cmocka_unit_test(test_constants),
#if defined(FATLINE_MULTI)
        cmocka_unit_test(test_plain_bytes),
        cmocka_unit_test(test_no_allocation),
#endif
    };
    return cmocka_run_group_tests_name("real", tests, NULL, NULL);
}
