/* Rows and the line about the circumstances of a run. */
#include "prop.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../harness/run/row.h"

/* What row_write writes of `row`, read back. */
static json_t *written(json_t *row)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    row_write(stream, row);
    fclose(stream);
    assert_true(size > 1 && text[size - 1] == '\n' && !memchr(text, '\n', size - 1));
    json_t *back = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    assert_non_null(back);
    free(text);
    return back;
}

static void test_rows_carry_the_run(void **state)
{
    (void)state;
    for (int trial = 0; trial < 1000; trial++) {
        struct random_state r = random_for(1, "row", (uint64_t)trial);
        double a = random_unit(&r) * 1e9;
        json_t *row = written(json_pack("{s:f}", "a", a));
        assert_true(json_real_value(json_object_get(row, "a")) == a);
        assert_string_equal(json_string_value(json_object_get(row, "run")), row_run_id());
        json_decref(row);
    }
}

static void assert_text(const json_t *object, const char *name, const char *expected)
{
    const char *text = json_string_value(json_object_get(object, name));
    if (!text || !*text || (expected && strcmp(text, expected)))
        fail_msg("%s: %s, expected %s", name, text ? text : "no text", expected ? expected : "some");
}

static void test_environment(void **state)
{
    static const char *const texts[] = {"date", "cpu", "kernel", "compiler", "flags", "governor", "commit"};
    char program[] = "/some/where/fatline-time", option[] = "--tolerance", odd[] = "a\"b\xff";
    char *argv[] = {program, option, odd, NULL};
    (void)state;
    json_t *row = written(row_environment(3, argv, "quad"));
    const json_t *e = json_object_get(row, "environment"), *libraries = json_object_get(e, "libraries"),
                 *file;
    size_t i;
    for (i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_text(e, texts[i], NULL);
    assert_text(e, "program", "fatline-time");
    assert_text(e, "precision", "quad");
    assert_text(e, "run", row_run_id());
    assert_int_equal(json_integer_value(json_object_get(e, "schema")), ROW_SCHEMA);
    assert_int_equal(json_array_size(json_object_get(e, "arguments")), 3);
    assert_true(json_integer_value(json_object_get(e, "cpus")) > 0);
    assert_non_null(strstr(json_string_value(json_object_get(e, "flags")), "-DFATLINE_QUAD"));
    assert_text(libraries, "gmp", NULL);
    assert_text(libraries, "flint", NULL);
    assert_true(json_array_size(json_object_get(libraries, "files")) > 0);
    json_array_foreach(json_object_get(libraries, "files"), i, file)
    {
        assert_int_equal(access(json_string_value(file), R_OK), 0);
    }
    json_decref(row);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows_carry_the_run),
        cmocka_unit_test(test_environment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
