/* What is no path is called so, with its segment, and nothing is written but where it should be. */
#include <math.h>
#include <string.h>

#include "library_paths.h"

static void expect_error(struct run *z, const struct fatline_path *a, const struct fatline_path *b,
                         const struct fatline_options *o, const char *error, int segment)
{
    memset(z->memory, 0x33, z->a.size);
    assert_int_equal(fatline_paths(z->w, a, b, o, 0, &z->a), FATLINE_INVALID);
    assert_true(z->a.count == 0 && z->a.overlaps == 0 && z->a.done == 0);
    assert_int_equal(z->a.segment, segment);
    if (!z->a.error || !strstr(z->a.error, error))
        fail_msg("\"%s\" does not say \"%s\"", z->a.error ? z->a.error : "", error);
    for (size_t i = 0; i < z->a.size; i++)
        if (z->memory[i] != 0x33)
            fail_msg("byte %zu of the memory was written", i);
}

static void bad_numbers(void **state)
{
    (void)state;
    static const double none[] = {NAN, INFINITY, -INFINITY};
    struct random_state r = random_for(72, "library_paths", 0);
    struct both a, b;
    struct run z;
    both_init(&a);
    both_init(&b);
    add_chain(&a, &r, 9, 5, true, false);
    add_chain(&b, &r, 7, 3, false, false);
    run_init(&z, &a.path, &b.path, 100);
    size_t at = 0;
    for (int i = 0; i < a.path.count; i++) {
        size_t k = at + (size_t)random_between(&r, 0, a.degree[i]), y = 2 * k + 1;
        double point = a.points[y], weight = a.weights[k];
        a.points[y] = none[i % 3];
        expect_error(&z, &a.path, &b.path, NULL, "coordinate of the first path", i);
        expect_error(&z, &b.path, &a.path, NULL, "coordinate of the second path", i);
        a.points[y] = point;
        a.weights[k] = i % 2 ? 0 : none[i % 3];
        expect_error(&z, &a.path, &b.path, NULL, "weight of the first path", i);
        a.weights[k] = weight * 0x1p257 * 16;
        expect_error(&z, &a.path, NULL, NULL, "weights of a segment of the first path", i);
        a.weights[k] = weight * 1.5;
        a.points[y] = 0x1p1001;
        expect_error(&z, &a.path, NULL, NULL, "2^1000", i);
        a.points[y] = point;
        a.weights[k] = weight;
        for (int bad = 0; bad < 2; bad++) {
            unsigned char degree = a.degree[i];
            a.degree[i] = bad ? 33 : 0;
            expect_error(&z, &b.path, &a.path, NULL, "degree of a segment of the second path", i);
            assert_int_equal(fatline_paths_workspace_size(&a.path, NULL), 0);
            assert_int_equal(fatline_paths_memory_size(&b.path, &a.path, 1), 0);
            a.degree[i] = degree;
        }
        at += (size_t)a.degree[i] + 1;
    }
    assert_int_equal(solve(&z, &a.path, &b.path), FATLINE_SOLVED);
    run_clear(&z);
    both_clear(&a);
    both_clear(&b);
}

static void mistakes_are_told(void **state)
{
    (void)state;
    static const int wrong[][2] = {{1, 2}, {0, 0}, {0, 8}, {0, -1}};
    const struct fatline_options tolerance = {NAN, 0}, steps = {0, -1};
    struct random_state r = random_for(73, "library_paths", 0);
    struct both a;
    struct run z;
    both_init(&a);
    add_chain(&a, &r, 8, 3, false, false);
    run_init(&z, &a.path, NULL, 100);
    struct fatline_path p = a.path;
    expect_error(&z, NULL, NULL, NULL, "first path or its points are missing", -1);
    expect_error(&z, &p, NULL, &tolerance, "tolerance", -1);
    expect_error(&z, &p, NULL, &steps, "max_steps", -1);
    expect_error(&z, &p, &p, NULL, "workspace is too small", -1);
    for (int k = 0; k < 4; k++) {
        p.subpath = wrong[k];
        p.subpaths = 2;
        expect_error(&z, &p, NULL, NULL, "subpaths", -1);
    }
    p.subpaths = 0;
    expect_error(&z, &p, NULL, NULL, "subpaths", -1);
    p = a.path;
    for (int k = 0; k < 2; k++) {
        p.count = k ? (1 << 30) + 1 : -1;
        expect_error(&z, &p, NULL, NULL, "number of segments", -1);
        assert_int_equal(fatline_paths_workspace_size(&p, NULL), 0);
    }
    p = a.path;
    p.points = NULL;
    expect_error(&z, &p, NULL, NULL, "missing", -1);
    assert_int_equal(fatline_paths(z.w, &a.path, NULL, NULL, 7, &z.a), FATLINE_INVALID);
    assert_non_null(strstr(z.a.error, "first"));
    z.a.memory = NULL;
    assert_int_equal(fatline_paths(z.w, &a.path, NULL, NULL, 0, &z.a), FATLINE_INVALID);
    assert_non_null(strstr(z.a.error, "memory"));
    z.a.memory = z.memory + 4;
    assert_int_equal(fatline_paths(z.w, &a.path, NULL, NULL, 0, &z.a), FATLINE_INVALID);
    z.a.memory = z.memory;
    size_t size = z.a.size;
    for (z.a.size = 0; z.a.size < 1000000; z.a.size += 99999)
        assert_int_equal(fatline_paths(z.w, &a.path, NULL, NULL, 0, &z.a), FATLINE_OUT_OF_ROOM);
    z.a.size = size;
    p.count = 0;
    assert_true(solve(&z, &p, NULL) == FATLINE_SOLVED && z.a.count == 0);
    run_clear(&z);
    both_clear(&a);
}

static void memory_is_checked(void **state)
{
    (void)state;
    struct both a;
    both_init(&a);
    add_walk(&a, 1000, 1, 0);
    a.path.weights = NULL;
    size_t size = fatline_paths_workspace_size(&a.path, NULL);
    char *memory = (char *)malloc(size);
    assert_true(size < 1500000 + 1000 * 200);
    assert_true(fatline_paths_memory_size(&a.path, NULL, 1000) < 2000000 + 1000 * (12 + 200));
    assert_true(fatline_paths_memory_size(&a.path, NULL, -1) == 0);
    assert_null(fatline_paths_workspace_init(NULL, size));
    assert_null(fatline_paths_workspace_init(memory + 4, size));
    assert_null(fatline_paths_workspace_init(memory, 1000));
    assert_non_null(fatline_paths_workspace_init(memory, size));
    free(memory);
    both_clear(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_numbers),
        cmocka_unit_test(mistakes_are_told),
        cmocka_unit_test(memory_is_checked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
