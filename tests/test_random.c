/* The generator: the published sequence, exact ranges, streams that do not depend on the order of use. */
#include "prop.h"

#include <inttypes.h>

/* First values of splitmix64 (Vigna's reference code) from state 1234567. */
static void test_published_sequence(void **state)
{
    static const uint64_t expected[] = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                        4593380528125082431u, 16408922859458223821u};
    struct random_state r = {1234567};
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++)
        assert_true(random_bits(&r) == expected[i]);
}

static void test_ranges(void **state)
{
    static const int64_t range[][2] = {{0, 0}, {-3, 3}, {INT64_MIN, INT64_MAX}, {INT64_MAX - 1, INT64_MAX}};
    struct random_state r = random_for(1, "ranges", 0);
    (void)state;
    for (size_t k = 0; k < sizeof range / sizeof *range; k++)
        for (int i = 0; i < 10000; i++) {
            int64_t n = random_between(&r, range[k][0], range[k][1]);
            assert_true(range[k][0] <= n && n <= range[k][1]);
        }
    for (int i = 0; i < 100000; i++) {
        double u = random_unit(&r);
        assert_true(u >= 0 && u < 1 && u * 0x1p53 == (double)(int64_t)(u * 0x1p53));
    }
}

/* Chi-square of 7 faces, 6 degrees of freedom: above 33 once in 100,000 times (the seed is fixed). */
static void test_faces_are_equally_likely(void **state)
{
    enum { FACES = 7, THROWS = 70000 };
    int count[FACES] = {0};
    double chi_square = 0;
    struct random_state r = random_for(5, "faces", 0);
    (void)state;
    for (int i = 0; i < THROWS; i++)
        count[random_between(&r, -3, 3) + 3]++;
    for (int i = 0; i < FACES; i++) {
        double excess = count[i] - (double)THROWS / FACES;
        chi_square += excess * excess * FACES / THROWS;
    }
    assert_true(chi_square < 33);
}

/* Streams of neighbouring seeds, families and indices differ in about half of their bits. */
static void test_streams_differ(void **state)
{
    long ones = 0, bits = 0;
    (void)state;
    for (uint64_t i = 0; i < 1000; i++) {
        struct random_state a = random_for(i, "a", i), again = random_for(i, "a", i);
        struct random_state other[] = {random_for(i + 1, "a", i), random_for(i, "b", i),
                                       random_for(i, "a", i + 1)};
        uint64_t first = random_bits(&a);
        assert_true(first == random_bits(&again));
        for (int k = 0; k < 3; k++) {
            ones += __builtin_popcountll(first ^ random_bits(&other[k]));
            bits += 64;
        }
    }
    assert_true(ones > 0.49 * bits && ones < 0.51 * bits); /* 0.01 is 8 standard deviations */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_published_sequence),
        cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_faces_are_equally_likely),
        cmocka_unit_test(test_streams_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
