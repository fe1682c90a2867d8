/* Case lines: every form is read to the exact value it denotes. */
#include "prop.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../harness/cases/case.h"
#include "../harness/cases/number.h"

static const char own[] = "\"f\":{\"points\":[[0,0],[1,2]]},\"g\":{\"points\":[[0,1],[1,1]]}";

/* Reads {"id":"a", curves, rest}. */
static void read_line(const char *curves, const char *rest, struct test_case *c)
{
    char line[4096], error[512] = "";
    snprintf(line, sizeof line, "{\"id\":\"a\",%s%s}", curves, rest);
    if (case_parse(line, "F", 7, c, error) != CASE_READ)
        fail_msg("%s\n%s", line, error);
}

static void assert_rational(const mpq_t q, const char *expected)
{
    mpq_t e;
    mpq_init(e);
    assert_true(number_parse(expected, e));
    if (!mpq_equal(q, e))
        fail_msg("%s instead of %s", mpq_get_str(NULL, 10, q), expected);
    mpq_clear(e);
}

static void test_smallest_case(void **state)
{
    (void)state;
    struct test_case c;
    read_line(own, "", &c);
    assert_string_equal(c.id, "a");
    assert_string_equal(c.class_name, "");
    assert_int_equal(c.line_number, 7);
    assert_string_equal(c.file, "F");
    assert_false(c.ambiguous || c.expected.known || c.f.rational || c.g.rational);
    assert_true(isnan(c.expected.tol));
    assert_int_equal(c.f.degree, 1);
    assert_rational(c.f.y[1], "2");
    assert_rational(c.f.w[1], "1");
    assert_rational(c.f.lo, "0");
    assert_rational(c.g.hi, "1");
    case_clear(&c);
}

/* A number is the same whichever form it has; JSON numbers are the doubles they denote. */
static void test_forms_of_a_coordinate(void **state)
{
    static const struct {
        const char *json, *value;
    } form[] = {{"\"-1.25e-3\"", "-1/800"},
                {"\"3/16\"", "3/16"},
                {"\"0x1.8p-4\"", "3/32"},
                {"\"0.1\"", "1/10"},
                {"\"0.1f\"", "13421773/134217728"},
                {"0.1", "3602879701896397/36028797018963968"},
                {"-3", "-3"},
                {"9007199254740993", "9007199254740992"},
                {"36893488147419103232", "36893488147419103232"},
                {"1e-300", "0x1.56e1fc2f8f359p-997"}};
    (void)state;
    for (size_t i = 0; i < sizeof form / sizeof *form; i++) {
        struct test_case c;
        char curves[512];
        snprintf(curves, sizeof curves,
                 "\"f\":{\"points\":[[0,0],[%s,0]]},\"g\":{\"f64\":[[0,%s],[1,1]],\"weights\":[1,2]}",
                 form[i].json, form[i].json);
        read_line(curves, "", &c);
        assert_rational(c.f.x[1], form[i].value);
        assert_rational(c.g.y[0], form[i].value);
        case_clear(&c);
    }
}

static void test_doubles_win_over_texts(void **state)
{
    (void)state;
    struct test_case c;
    read_line("\"f\":{\"degree\":1,\"points\":[[\"0.1\",0],[1,2]],\"f64\":[[0.5,0],[1,2]],"
              "\"weights\":[\"0.1\",1],\"w64\":[0.25,1]},"
              "\"g\":{\"f64\":[[0,1],[1,1],[2,3]],\"weights\":[\"1/3\",1,2],\"domain\":[\"-1/2\",3]}",
              ",\"class\":\"none\",\"near\":{\"ambiguous\":[\"close\"]}", &c);
    assert_rational(c.f.x[0], "1/2");
    assert_rational(c.f.w[0], "1/4");
    assert_rational(c.g.w[0], "1/3");
    assert_rational(c.g.lo, "-1/2");
    assert_rational(c.g.hi, "3");
    assert_int_equal(c.g.degree, 2);
    assert_true(c.f.rational && c.g.rational && c.ambiguous);
    assert_string_equal(c.class_name, "none");
    case_clear(&c);
}

static void test_expected(void **state)
{
    (void)state;
    struct test_case c;
    read_line(own,
              ",\"expected\":{\"count\":3,\"params\":[[0.75,0.5],[0.25,0.5],[0.125,0.3333333333333333]],"
              "\"exact\":[[\"3/4\",\"1/2\"],null,"
              "[\"0.125\",\"3.333333333333333333333333333333333333333e-1\"]],"
              "\"mult\":[2,null,1],\"cond\":[null,3,5.5],\"sin\":[0,-0.5,null],\"tol\":1e-9,"
              "\"overlap\":[[0,\"1/3\",1,0.5]]}",
              &c);
    const struct case_expected *e = &c.expected;
    assert_true(e->known && e->tol == 1e-9);
    assert_int_equal(e->count, 3);
    assert_rational(e->at[0].t, "1/8"); /* sorted by t */
    assert_rational(e->at[0].s, "3.333333333333333333333333333333333333333e-1");
    assert_rational(e->at[1].t, "1/4");
    assert_rational(e->at[2].t, "3/4");
    assert_false(e->at[0].exact || e->at[1].exact);
    assert_true(e->at[2].exact);
    assert_int_equal(e->at[0].multiplicity, 1);
    assert_int_equal(e->at[1].multiplicity, 0);
    assert_int_equal(e->at[2].multiplicity, 2);
    assert_true(e->at[0].cond == 5.5 && e->at[1].sine == -0.5 && e->at[2].sine == 0);
    assert_true(isnan(e->at[2].cond) && isnan(e->at[0].sine));
    assert_int_equal(e->overlaps, 1);
    assert_rational(e->overlap[0].t1, "1/3");
    assert_rational(e->overlap[0].s0, "1");
    case_expected_clear(&c.expected);
    assert_false(c.expected.known || c.expected.count || c.expected.overlaps);
    case_clear(&c);
}

static void test_tolerance_of_the_judge(void **state)
{
    static const struct {
        const char *rest;
        double asked, tol;
    } t[] = {{"", 1e-9, 1e-9},
             {"", 1e-15, 1e-12},
             {",\"expected\":{\"params\":[[0,0]],\"cond\":[999],\"mult\":[1]}", 1e-15, 1e-9},
             {",\"expected\":{\"params\":[[0,0]],\"mult\":[2]}", 1e-15, 1e-6},
             {",\"expected\":{\"params\":[[0,0]],\"sin\":[0]}", 1e-3, 1e-3},
             {",\"class\":\"degenerate\",\"expected\":{\"count\":0}", 1e-15, 1e-6},
             {",\"class\":\"tangent\",\"expected\":{\"count\":0,\"tol\":1e-8}", 1e-15, 1e-8}};
    (void)state;
    for (size_t i = 0; i < sizeof t / sizeof *t; i++) {
        struct test_case c;
        read_line(own, t[i].rest, &c);
        if (fabs(case_tolerance(&c, t[i].asked) / t[i].tol - 1) > 1e-12)
            fail_msg("%s: %g instead of %g", t[i].rest, case_tolerance(&c, t[i].asked), t[i].tol);
        case_clear(&c);
    }
}

/* The reader counts lines, passes over blank ones, and goes on after a bad one. */
static void test_reader_goes_on(void **state)
{
    char text[2048], line[512];
    struct case_reader r;
    struct test_case c;
    (void)state;
    snprintf(line, sizeof line, "{\"id\":\"a\",%s}", own);
    int n = snprintf(text, sizeof text, "%s\n\n  \nnot json\n%s\nx%cy\n%s", line, line, 0, line);
    FILE *stream = fmemopen(text, (size_t)n, "r");
    case_reader_init(&r, stream, "cases.jsonl");
    static const int good[] = {1, 0, 5, 0, 7};
    static const char *const bad[] = {NULL, "cases.jsonl:4: line: ", NULL, "cases.jsonl:6: line: a byte 0",
                                      NULL};
    for (int i = 0; i < 5; i++) {
        assert_int_equal(case_read(&r, &c), good[i] ? CASE_READ : CASE_BAD);
        if (good[i]) {
            assert_int_equal(c.line_number, good[i]);
            case_clear(&c);
        } else {
            assert_int_equal(strncmp(r.error, bad[i], strlen(bad[i])), 0);
        }
    }
    assert_int_equal(case_read(&r, &c), CASE_END);
    assert_int_equal(case_read(&r, &c), CASE_END);
    case_reader_clear(&r);
    fclose(stream);
}

/* Random doubles written as JSON numbers are read exactly, and the line copied on reads back the same. */
static void test_round_trip(void **state)
{
    (void)state;
    for (int trial = 0; trial < 500; trial++) {
        struct random_state r = random_for(3, "round trip", (uint64_t)trial);
        double x[4], y[4];
        char line[2048], number[2][64], error[512];
        int n = (int)random_between(&r, 1, 3), at;
        struct test_case c, copy;
        at = snprintf(line, sizeof line,
                      "{\"id\":\"a\",\"g\":{\"points\":[[0,0],[1,\"2/7\"]]},\"f\":{\"f64\":[");
        for (int i = 0; i <= n; i++) {
            x[i] = ldexp(random_unit(&r) - 0.5, (int)random_between(&r, -300, 300));
            y[i] = ldexp(random_unit(&r) - 0.5, (int)random_between(&r, -1080, 1000));
            number_text_double(x[i], number[0], sizeof number[0]);
            number_text_double(y[i], number[1], sizeof number[1]);
            at += snprintf(line + at, sizeof line - (size_t)at, "%s[%s,%s]", i ? "," : "", number[0],
                           number[1]);
        }
        snprintf(line + at, sizeof line - (size_t)at, "]}}");
        assert_int_equal(case_parse(line, "F", 1, &c, error), CASE_READ);
        char *written = json_dumps(c.line, JSON_COMPACT);
        assert_int_equal(case_parse(written, "F", 1, &copy, error), CASE_READ);
        for (int i = 0; i <= n; i++) {
            assert_true(number_to_double(c.f.x[i]) == x[i] && number_to_double(c.f.y[i]) == y[i]);
            assert_true(mpq_equal(c.f.x[i], copy.f.x[i]) && mpq_equal(c.f.y[i], copy.f.y[i]));
        }
        assert_true(json_equal(c.line, copy.line));
        free(written);
        case_clear(&copy);
        case_clear(&c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_smallest_case),
        cmocka_unit_test(test_forms_of_a_coordinate),
        cmocka_unit_test(test_doubles_win_over_texts),
        cmocka_unit_test(test_expected),
        cmocka_unit_test(test_tolerance_of_the_judge),
        cmocka_unit_test(test_reader_goes_on),
        cmocka_unit_test(test_round_trip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
