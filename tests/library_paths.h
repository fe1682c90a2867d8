/* Paths as fatline_paths takes them and as the program `fatline paths` does, and memory between guards. */
#ifndef FATLINE_TESTS_LIBRARY_PATHS_H
#define FATLINE_TESTS_LIBRARY_PATHS_H

#include <stdlib.h>
#include <string.h>

#include "prop.h"

#include "../algorithms/fatline.h"
#include "../harness/paths/path_job.h"

enum { GUARD = 64, BAND = 0x5a };

/* ---- paths ---- */

/* The same path twice: as the library takes it, and as the program does. */
struct both {
    struct fatline_path path;
    double *points, *weights;
    unsigned char *degree;
    size_t used;
    struct path_draft draft;
};

enum { SEGMENTS_MAX = 20000, POINTS_MAX = 5 * (int)SEGMENTS_MAX };

static inline void both_init(struct both *z)
{
    memset(z, 0, sizeof *z);
    z->points = (double *)malloc(2 * POINTS_MAX * sizeof(double));
    z->weights = (double *)malloc(POINTS_MAX * sizeof(double));
    z->degree = (unsigned char *)malloc(SEGMENTS_MAX);
    z->path.points = z->points;
    z->path.weights = z->weights;
    z->path.degree = z->degree;
    path_draft_begin(&z->draft, "both");
}

/* w: NULL or weights. */
static inline void add(struct both *z, int degree, const double *x, const double *y, const double *w)
{
    double wx[DEGREE_MAX + 1], wy[DEGREE_MAX + 1];
    assert_true(z->path.count < SEGMENTS_MAX && z->used < POINTS_MAX - DEGREE_MAX);
    for (int i = 0; i <= degree; i++) {
        z->points[2 * z->used] = x[i];
        z->points[2 * z->used + 1] = y[i];
        z->weights[z->used++] = w ? w[i] : 3;
        wx[i] = w ? w[i] * x[i] : x[i];
        wy[i] = w ? w[i] * y[i] : y[i];
    }
    z->degree[z->path.count++] = (unsigned char)degree;
    assert_true(path_draft_add(&z->draft, degree, wx, wy, w));
}

static inline void both_clear(struct both *z)
{
    free(z->points);
    free(z->weights);
    free(z->degree);
    path_draft_clear(&z->draft);
}

/* Curves end to end of degree 1 to `most`, one in three rational if asked for. */
static inline void add_chain(struct both *z, struct random_state *r, int count, int most, bool rational,
                             bool closed)
{
    double x[DEGREE_MAX + 1], y[DEGREE_MAX + 1], w[DEGREE_MAX + 1], first_x = 0, first_y = 0;
    x[0] = first_x = prop_unit(r, 20);
    y[0] = first_y = prop_unit(r, 20);
    for (int i = 0; i < count; i++) {
        int n = (int)random_between(r, 1, most);
        for (int k = 1; k <= n; k++) {
            x[k] = x[k - 1] + prop_dyadic(r, 20) / 4;
            y[k] = y[k - 1] + prop_dyadic(r, 20) / 4;
        }
        if (closed && i + 1 == count) {
            x[n] = first_x;
            y[n] = first_y;
        }
        for (int k = 0; k <= n; k++)
            w[k] = k == 0 || k == n ? 1 : (double)(2 * random_between(r, 1, 64) + 1) / 32;
        add(z, n, x, y, rational && n > 1 && random_between(r, 0, 2) == 0 ? w : NULL);
        x[0] = x[n];
        y[0] = y[n];
    }
}

static inline void add_walk(struct both *z, int count, uint64_t seed, uint64_t index)
{
    struct path_set set = {0, 0, NULL};
    path_random(&set, "walk", count, seed, index);
    for (int i = 0; i < count; i++)
        add(z, 3, set.at[0].segment[i].x, set.at[0].segment[i].y, NULL);
    path_set_clear(&set);
}

/* Segment i of the other, without its weights. */
static inline void add_reversed(struct both *z, const struct both *other, int i)
{
    int n = other->degree[i];
    size_t at = 0;
    double x[DEGREE_MAX + 1], y[DEGREE_MAX + 1];
    for (int j = 0; j < i; j++)
        at += (size_t)other->degree[j] + 1;
    for (int k = 0; k <= n; k++) {
        x[k] = other->points[2 * (at + (size_t)(n - k))];
        y[k] = other->points[2 * (at + (size_t)(n - k)) + 1];
    }
    add(z, n, x, y, NULL);
}

/* ---- a call ---- */

struct run {
    struct fatline_paths_workspace *w;
    char *workspace, *memory;
    size_t size;
    struct fatline_paths_answer a;
};

/* Bytes beyond those that are told of have to stay as they are. */
static inline char *guarded(size_t size)
{
    char *memory = (char *)malloc(size + GUARD);
    memset(memory + size, BAND, GUARD);
    return memory;
}

static inline void check_guard(const char *memory, size_t size)
{
    for (int i = 0; i < GUARD; i++)
        assert_int_equal(memory[size + (size_t)i], BAND);
}

static inline void run_init(struct run *z, const struct fatline_path *a, const struct fatline_path *b,
                            int records)
{
    memset(z, 0, sizeof *z);
    z->size = fatline_paths_workspace_size(a, b);
    z->a.size = fatline_paths_memory_size(a, b, records);
    assert_true(z->size > 0 && z->a.size > 0);
    z->workspace = guarded(z->size);
    z->memory = guarded(z->a.size);
    z->a.memory = z->memory;
    z->w = fatline_paths_workspace_init(z->workspace, z->size);
    assert_non_null(z->w);
}

/* Memory for more, with what was there. */
static inline void run_grow(struct run *z, size_t size)
{
    char *larger = guarded(size);
    check_guard(z->memory, z->a.size);
    memset(larger, 0x77, size);
    memcpy(larger, z->memory, z->a.size < size ? z->a.size : size);
    free(z->memory);
    z->memory = larger;
    z->a.memory = larger;
    z->a.size = size;
}

static inline void run_clear(struct run *z)
{
    check_guard(z->workspace, z->size);
    check_guard(z->memory, z->a.size);
    free(z->workspace);
    free(z->memory);
}

static inline enum fatline_outcome solve(struct run *z, const struct fatline_path *a,
                                         const struct fatline_path *b)
{
    enum fatline_outcome o = fatline_paths(z->w, a, b, NULL, 0, &z->a);
    assert_null(z->a.error);
    assert_true(o == (z->a.open > 0 ? FATLINE_OUT_OF_STEPS : FATLINE_SOLVED));
    return o;
}

#endif
