/* From a line of a dataset to the build's problem: every coefficient is the exact one, rounded once. */
#include <stdio.h>
#include <string.h>

#include "prop.h"
#include "../harness/cases/number.h"
#include "../harness/cases/problem.h"

enum { TRIALS = 300, LINE_MAX_BYTES = 16384 };

/* Random fractions, decimals and doubles, so that hardly any is a real. */
static void random_number(struct random_state *r, char *text, bool positive)
{
    long long a = (long long)random_between(r, positive ? 1 : -99999, 99999);
    long long b = (long long)random_between(r, 1, 99999);

    switch (random_bits(r) % 3) {
    case 0:
        sprintf(text, "\"%lld/%lld\"", a, b);
        break;
    case 1:
        sprintf(text, "\"%lld.%llde%d\"", a, b, (int)random_between(r, -9, 2));
        break;
    default:
        sprintf(text, "\"%lldf\"", a);
    }
}

static void random_curve(struct random_state *r, char *text, bool rational)
{
    int degree = (int)random_between(r, 1, 12);
    char x[64], y[64];

    text += sprintf(text, "{\"degree\":%d,\"points\":[", degree);
    for (int i = 0; i <= degree; i++) {
        random_number(r, x, false);
        random_number(r, y, false);
        text += sprintf(text, "%s[%s,%s]", i ? "," : "", x, y);
    }
    text += sprintf(text, "]");
    if (rational) {
        text += sprintf(text, ",\"weights\":[");
        for (int i = 0; i <= degree; i++) {
            random_number(r, x, true);
            text += sprintf(text, "%s%s", i ? "," : "", x);
        }
        text += sprintf(text, "]");
    }
    sprintf(text, ",\"domain\":[\"%d/7\",\"%d/3\"]}", (int)random_between(r, -9, 9),
            (int)random_between(r, 5, 9));
}

static void assert_curve(const struct curve *got, const struct case_curve *exact)
{
    mpq_t product;

    mpq_init(product);
    assert_int_equal(got->degree, exact->degree);
    assert_true((got->w != NULL) == exact->rational);
    assert_true(got->domain.lo == real_from_rational(exact->lo) &&
                got->domain.hi == real_from_rational(exact->hi));
    for (int i = 0; i <= got->degree; i++) {
        if (got->w)
            assert_true(got->w[i] == real_from_rational(exact->w[i]));
        mpq_mul(product, exact->w[i], exact->x[i]);
        assert_true(got->x[i] == real_from_rational(got->w ? product : exact->x[i]));
        mpq_mul(product, exact->w[i], exact->y[i]);
        assert_true(got->y[i] == real_from_rational(got->w ? product : exact->y[i]));
    }
    mpq_clear(product);
}

static void test_coefficients_are_rounded_once(void **state)
{
    (void)state;
    static char f[LINE_MAX_BYTES], g[LINE_MAX_BYTES], line[3 * LINE_MAX_BYTES], error[512];
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(1, "problem", (uint64_t)i);
        struct test_case c;
        struct owned_problem p;
        random_curve(&r, f, i % 2);
        random_curve(&r, g, i % 3 == 0);
        sprintf(line, "{\"id\":\"p%d\",\"f\":%s,\"g\":%s}", i, f, g);
        if (case_parse(line, "test", 1, &c, error) != CASE_READ)
            fail_msg("%s\n%s", error, line);
        assert_null(owned_problem_make(&c, (real)1 / 1024, 77, &p));
        assert_true(p.problem.tolerance == (real)1 / 1024);
        assert_int_equal(p.problem.max_steps, 77);
        assert_curve(&p.problem.f, &c.f);
        assert_curve(&p.problem.g, &c.g);
        owned_problem_clear(&p);
        case_clear(&c);
    }
}

static void assert_refused(const char *f, const char *field)
{
    char line[2048], error[512];
    struct test_case c;
    struct owned_problem p;

    sprintf(line, "{\"id\":\"bad\",\"f\":%s,\"g\":{\"points\":[[0,0],[1,1]]}}", f);
    if (case_parse(line, "test", 1, &c, error) != CASE_READ)
        fail_msg("%s\n%s", error, line);
    const char *wrong = owned_problem_make(&c, (real)1 / 1024, 77, &p);
    assert_non_null(wrong);
    assert_memory_equal(wrong, field, strlen(field));
    assert_null(p.memory);
    case_clear(&c);
}

/* 1 + 10^-900, which is 1 at every precision. */
static void one_and_a_bit(char *text)
{
    text += sprintf(text, "1.");
    memset(text, '0', 899);
    strcpy(text + 899, "1");
}

/* What is exact and valid may still be no problem in this precision. */
static void test_range_of_the_precision(void **state)
{
    (void)state;
    char f[1024], bit[904];
    one_and_a_bit(bit);
    sprintf(f, "{\"points\":[[0,0],[1,0]],\"domain\":[1,\"%s\"]}", bit);
    assert_refused(f, "domain");
#if !defined(FATLINE_MULTI)
    assert_refused("{\"points\":[[\"1e4990\",0],[1,0]]}", "coordinates");
    assert_refused("{\"points\":[[0,0],[1,0]],\"weights\":[\"1e-4990\",1]}", "coordinates");
    assert_refused("{\"points\":[[0,0],[\"1e2500\",0]],\"weights\":[1,\"1e2500\"]}", "coordinates");
#endif
}

static size_t scratch_of_f(int n, int m)
{
    return (size_t)(1000 * n + m);
}

static const struct intersector frugal = {.name = "frugal"};
static const struct intersector hungry = {.name = "hungry", .scratch = scratch_of_f};

/* Each cell and all scratch can be written, whichever curve comes first. */
static void test_workspace(void **state)
{
    (void)state;
    const struct intersector *const list[] = {&frugal, &hungry, NULL};
    struct workspace w;
    workspace_make(&w, list, 3, 7, 5);
    assert_true(w.scratch_length >= 7003 && w.room == 5);
    memset(w.cell, 0, (size_t)w.room * sizeof *w.cell);
    for (size_t i = 0; i < w.scratch_length; i++)
        w.scratch[i] = 1;
    workspace_clear(&w);
    assert_null(w.cell);
    workspace_make(&w, list + 2, 1, 1, WORKSPACE_ROOM);
    assert_int_equal(w.scratch_length, 0);
    workspace_clear(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coefficients_are_rounded_once),
        cmocka_unit_test(test_range_of_the_precision),
        cmocka_unit_test(test_workspace),
    };
    return cmocka_run_group_tests_name("problem", tests, NULL, NULL);
}
