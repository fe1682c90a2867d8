/* No algorithm allocates in a call, but those in peers/ that say so (struct intersector, `allocates`).
 *
 * This program defines malloc and its kin itself, so calls from every library in it are counted. */
#include "prop.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "../harness/cases/problem.h"

/* Volatile: the compiler believes it knows what malloc changes. */
static volatile bool counting;
static volatile int allocations;

#ifdef __cplusplus
#define NO_THROW noexcept
extern "C" {
#else
#define NO_THROW
#endif

/* glibc's own, under the names that it exports for this purpose. */
extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);

void *malloc(size_t size) NO_THROW
{
    allocations = allocations + counting;
    return __libc_malloc(size);
}

void *calloc(size_t n, size_t size) NO_THROW
{
    allocations = allocations + counting;
    return __libc_calloc(n, size);
}

void *realloc(void *memory, size_t size) NO_THROW
{
    allocations = allocations + counting;
    return __libc_realloc(memory, size);
}

void *aligned_alloc(size_t alignment, size_t size) NO_THROW
{
    allocations = allocations + counting;
    return __libc_memalign(alignment, size);
}

int posix_memalign(void **memory, size_t alignment, size_t size) NO_THROW
{
    allocations = allocations + counting;
    *memory = __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
}

#ifdef __cplusplus
}
#endif

enum { DEGREE_MOST = REAL_BITS > 53 ? 4 : 8, STEPS = REAL_BITS > 113 ? 100 : 2000 };

static struct crossings crossings;

/* Allocations in one call. */
static int allocations_of(const struct intersector *a, const struct curve *f, const struct curve *g,
                          struct workspace *w)
{
    struct problem p;

    memset(&p, 0, sizeof p);
    p.f = *f;
    p.g = *g;
    p.tolerance = (real)1 / 1000000000000LL;
    p.max_steps = STEPS;
    allocations = 0;
    counting = true;
    problem_solve(&p, a, w, &crossings);
    counting = false;
    return allocations;
}

static void check_degrees(const struct intersector *a, int n, int m, bool rational, struct workspace *w)
{
    struct random_state r = random_for(1, "allocation", (uint64_t)(2 * (n * DEGREE_MAX + m) + rational));
    struct prop_curve f, g;

    prop_curve_make(&f, &r, n, 20, rational);
    prop_curve_make(&g, &r, m, 20, rational);
    if (allocations_of(a, &f.curve, &g.curve, w))
        fail_msg("%s: %d allocations on a random pair of degrees %d and %d", a->name, allocations, n, m);
    if (allocations_of(a, &f.curve, &f.curve, w))
        fail_msg("%s: %d allocations on an overlap of degree %d", a->name, allocations, n);
}

/* Random pairs and a curve with itself, which runs out of steps where overlaps are not decided. */
static void test_no_algorithm_allocates(void **state)
{
    int tested = 0;

    (void)state;
    for (int i = 0; intersectors[i]; i++) {
        struct workspace w;

        if (intersectors[i]->allocates)
            continue;
        workspace_make(&w, intersectors + i, DEGREE_MOST, DEGREE_MOST, WORKSPACE_ROOM);
        for (int n = 1; n <= DEGREE_MOST; n++)
            for (int m = 1; m <= n; m++)
                for (int rational = 0; rational < 2; rational++)
                    check_degrees(intersectors[i], n, m, rational, &w);
        workspace_clear(&w);
        tested++;
    }
    assert_true(tested > 0);
}

static void *volatile kept; /* so that no allocation can be left out */

static enum outcome allocate_once(const struct problem *p, struct workspace *w, struct crossings *out)
{
    (void)p;
    (void)w;
    (void)out;
    kept = malloc(100);
    kept = realloc(kept, 200);
    free(kept);
    return UNSUPPORTED;
}

/* Negative controls: the counter sees each way to allocate, also from within libc, and an algorithm's calls.
 */
static void test_counter_counts(void **state)
{
    static const struct intersector greedy = {"greedy", "allocates", "none", {0, 0, 0, 0}, allocate_once};
    struct random_state r = random_for(1, "greedy", 0);
    struct prop_curve f, g;
    struct workspace w;
    const struct intersector *const both[] = {&greedy, NULL};
    void *aligned = NULL;

    (void)state;
    counting = true;
    allocations = 0;
    kept = malloc(10);
    assert_int_equal(allocations, 1);
    kept = realloc(kept, 1000);
    assert_int_equal(allocations, 2);
    free(kept);
    kept = calloc(10, 10);
    assert_int_equal(allocations, 3);
    free(kept);
    kept = strdup("libc's own");
    assert_int_equal(allocations, 4);
    free(kept);
    assert_int_equal(posix_memalign(&aligned, 64, 64), 0);
    assert_int_equal(allocations, 5);
    free(aligned);
    kept = aligned_alloc(64, 64);
    assert_int_equal(allocations, 6);
    free(kept);
    counting = false;
    prop_curve_make(&f, &r, 3, 20, false);
    prop_curve_make(&g, &r, 3, 20, false);
    workspace_make(&w, both, 3, 3, WORKSPACE_ROOM);
    assert_int_equal(allocations_of(&greedy, &f.curve, &g.curve, &w), 2);
    workspace_clear(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counter_counts),
        cmocka_unit_test(test_no_algorithm_allocates),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
