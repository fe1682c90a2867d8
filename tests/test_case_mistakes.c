/* Case lines: every mistake is told with its place. */
#include "prop.h"

#include <stdio.h>
#include <string.h>

#include "../harness/cases/case.h"

static const char own[] = "\"f\":{\"points\":[[0,0],[1,2]]},\"g\":{\"points\":[[0,1],[1,1]]}";

/* Each mistake, and what the message must begin with behind "F:7: ". */
static const struct {
    const char *line, *message;
} mistakes[] = {
    {"", "line: "},
    {"{\"id\":\"a\"", "line: "},
    {"[1]", "line: an array, expected an object with id"},
    {"{\"id\":\"a\",\"id\":\"b\"}", "line: duplicate object key"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[NaN,0]]}}", "line: "},
    {"{\"id\":\"a\",\"f\":{\"points\":[[1e999,0]]}}", "line: "},
    {"{\"id\":\"a\"} {}", "line: "},
    {"{\"id\":\"\xff\"}", "line: "},
    {"{}", "id: missing, expected text"},
    {"{\"id\":7}", "id: an integer, expected text"},
    {"{\"id\":\"\"}", "id: 0 bytes long"},
    {"{\"id\":\"a\",\"class\":3}", "class: an integer, expected text"},
    {"{\"id\":\"a\"}", "f: missing, expected an object with points"},
    {"{\"id\":\"a\",\"f\":[]}", "f: an array, expected an object"},
    {"{\"id\":\"a\",\"f\":{}}", "f.points: missing, expected control points"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0]]}}", "f.points: 1 point, expected 2 to 33"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1],[2,0,1]]}}", "f.points[2]: 3 entries, expected 2"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1],[2,\"x\"]]}}",
     "f.points[2][1]: \"x\" is no number, expected"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1],[2,\"nan\"]]}}", "f.points[2][1]: \"nan\" is no number"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1],[2,null]]}}", "f.points[2][1]: null, expected a number"},
    {"{\"id\":\"a\",\"f\":{\"f64\":[[0,0],[true,1]]}}", "f.f64[1][0]: a truth value, expected a number"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1],[2,\"1/0\"]]}}", "f.points[2][1]: \"1/0\" is no number"},
    {"{\"id\":\"a\",\"f\":{\"degree\":3,\"points\":[[0,0],[1,1],[2,0]]}}",
     "f.points: 3 points, degree 3 needs 4"},
    {"{\"id\":\"a\",\"f\":{\"degree\":\"1\",\"points\":[[0,0],[1,1]]}}",
     "f.degree: text, expected an integer"},
    {"{\"id\":\"a\",\"f\":{\"degree\":33,\"points\":[[0,0],[1,1]]}}", "f.degree: 33, expected 1 to 32"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]],\"weights\":[1]}}", "f.weights: 1 entry, expected 2"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]],\"weights\":[1,0]}}",
     "f.weights[1]: a weight that is not"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]],\"w64\":[-1,1]}}", "f.w64[0]: a weight that is not"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]],\"domain\":[1,1]}}",
     "f.domain: its ends are not in order"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]],\"domain\":[0,{}]}}", "f.domain[1]: an object, expected"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]],\"wieghts\":[1,2]}}",
     "f.wieghts: unknown, expected points, weights, degree, domain, f64 or w64"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]]},\"g\":{\"Points\":[[0,0],[1,1]]}}",
     "g.Points: unknown, expected points"},
    {"{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]]},\"g\":3}", "g: an integer, expected an object"},
};

static const struct {
    const char *rest, *message;
} later_mistakes[] = {
    {",\"near\":3", "near: an integer, expected an object"},
    {",\"near\":{\"ambiguous\":3}", "near.ambiguous: an integer, expected an array"},
    {",\"expected\":3", "expected: an integer, expected an object"},
    {",\"expected\":{}", "expected.count: missing"},
    {",\"expected\":{\"count\":-1}", "expected.count: -1, expected 0 to"},
    {",\"expected\":{\"count\":2}", "expected.params: missing, expected 2 pairs"},
    {",\"expected\":{\"count\":2,\"params\":[[0,0]]}", "expected.params: 1 entry, expected 2"},
    {",\"expected\":{\"params\":[[0,0]],\"mult\":[]}", "expected.mult: 0 entries, expected 1"},
    {",\"expected\":{\"params\":[[0,0]],\"mult\":[-1]}", "expected.mult[0]: -1, expected 0 to"},
    {",\"expected\":{\"params\":[[0,0]],\"cond\":[\"1\"]}",
     "expected.cond[0]: text, expected a number or null"},
    {",\"expected\":{\"params\":[[0,0]],\"sin\":[{}]}",
     "expected.sin[0]: an object, expected a number or null"},
    {",\"expected\":{\"params\":[[0]]}", "expected.params[0]: 1 entry, expected 2"},
    {",\"expected\":{\"params\":[[0,\"y\"]]}", "expected.params[0][1]: \"y\" is no number"},
    {",\"expected\":{\"params\":[[0,0]],\"exact\":[[0]]}", "expected.exact[0]: 1 entry, expected 2"},
    {",\"expected\":{\"params\":[[0,0]],\"exact\":[[0,\"?\"]]}", "expected.exact[0][1]: \"?\" is no number"},
    {",\"expected\":{\"count\":0,\"tol\":-1}", "expected.tol: -1, expected"},
    {",\"expected\":{\"count\":0,\"overlap\":[[0,1,2]]}", "expected.overlap[0]: 3 entries, expected 4"},
    {",\"expected\":{\"count\":0,\"overlap\":[[1,0,0,1]]}", "expected.overlap[0]: t0 > t1"},
};

static void assert_mistake(const char *line, const char *message)
{
    struct test_case c;
    char error[512] = "", expected[256];
    enum case_status status = case_parse(line, "F", 7, &c, error);
    snprintf(expected, sizeof expected, "F:7: %s", message);
    if (status != CASE_BAD || strncmp(error, expected, strlen(expected)))
        fail_msg("%s\n  says    %s\n  expected %s", line, error, expected);
}

static void test_mistakes_are_located(void **state)
{
    char line[1024];
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++)
        assert_mistake(mistakes[i].line, mistakes[i].message);
    for (size_t i = 0; i < sizeof later_mistakes / sizeof *later_mistakes; i++) {
        snprintf(line, sizeof line, "{\"id\":\"a\",%s%s}", own, later_mistakes[i].rest);
        assert_mistake(line, later_mistakes[i].message);
    }
}

/* Degree 1 to 32 is read; degree 33 is not. */
static void test_degrees(void **state)
{
    (void)state;
    for (int n = 1; n <= 33; n++) {
        char line[2048], points[1024] = "[0,1]", error[512];
        struct test_case c;
        for (int i = 1; i <= n; i++)
            snprintf(points + strlen(points), sizeof points - strlen(points), ",[%d,1]", i);
        snprintf(line, sizeof line, "{\"id\":\"a\",\"f\":{\"points\":[[0,0],[1,1]]},\"g\":{\"points\":[%s]}}",
                 points);
        if (n > 32) {
            assert_mistake(line, "g.points: 34 points, expected 2 to 33 (degree 1 to 32)");
            continue;
        }
        assert_int_equal(case_parse(line, "F", 1, &c, error), CASE_READ);
        assert_int_equal(c.g.degree, n);
        assert_true(mpq_cmp_ui(c.g.x[n], (unsigned long)n, 1) == 0);
        case_clear(&c);
    }
}

/* Every prefix of a line is a mistake, none a crash. */
static void test_truncated_lines(void **state)
{
    char line[1024], error[512];
    struct test_case c;
    (void)state;
    int n = snprintf(line, sizeof line, "{\"id\":\"a\",%s,\"expected\":{\"params\":[[0,0]]}}", own);
    assert_int_equal(case_parse(line, "F", 1, &c, error), CASE_READ);
    case_clear(&c);
    while (n-- > 0) {
        line[n] = 0;
        assert_int_equal(case_parse(line, "F", 1, &c, error), CASE_BAD);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mistakes_are_located),
        cmocka_unit_test(test_degrees),
        cmocka_unit_test(test_truncated_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
