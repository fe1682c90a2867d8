/* Random families with room to solve them, for the tests of regions. */
#ifndef FATLINE_REGION_FAMILY_H
#define FATLINE_REGION_FAMILY_H

#include <stdlib.h>
#include <string.h>

#include "nasty.h"

#include "../harness/regions/region_check.h"
#include "../harness/regions/region_problem.h"
#include "../harness/regions/region_random.h"

/* One random family with room to solve it. */
struct family {
    struct region_case c;
    struct owned_region owned;
    struct owned_workspace room;
    struct region *region, *other;
};

static inline struct region *region_new(void)
{
    struct region *r = (struct region *)malloc(sizeof *r);
    assert_non_null(r);
    return r;
}

static inline void family_open(struct family *f, uint64_t seed, int lo, int hi, uint64_t index)
{
    char line[REGION_LINE_MAX], error[512];
    region_random_line(seed, lo, hi, index, line);
    if (region_case_parse(line, "random", (int)index, &f->c, error) != REGION_CASE_READ)
        fail_msg("%s", error);
    const char *wrong = owned_region_make(&f->c, -1, 0, REGION_STEPS_MAX, &f->owned);
    if (wrong)
        fail_msg("%s: %s", f->c.id, wrong);
    memset((void *)&f->room, 0, sizeof f->room);
    owned_workspace_fit(&f->room, &f->owned.problem);
    f->region = region_new();
    f->other = region_new();
}

static inline void family_close(struct family *f)
{
    free(f->region);
    free(f->other);
    owned_workspace_clear(&f->room);
    owned_region_clear(&f->owned);
    region_case_clear(&f->c);
}

static inline enum outcome find(struct family *f, const char *method, struct region *out)
{
    return region_solve(&f->owned.problem, region_method_find(method), &f->room.workspace, out);
}

static inline struct region_answer answer_of(struct family *f, const char *method, const struct region *r)
{
    struct region_answer a;
    memset((void *)&a, 0, sizeof a);
    a.id = f->c.id;
    a.method = region_method_find(method);
    a.outcome = SOLVED;
    a.sign = f->owned.problem.sign;
    a.region = r;
    return a;
}

static inline const char *sampled(struct family *f, const struct region *r)
{
    struct region_answer a = answer_of(f, "region_carriers", r);
    return region_check_sample(&f->owned.problem, &f->room.workspace, &a);
}

/* Of the control points, with some slack for what lies far out. */
static inline real size_of(const struct family *f)
{
    const struct control_family *p = &f->owned.problem.family;
    real size = 0;
    for (int i = 0; i < p->count; i++)
        size = real_max(size, real_max(real_abs(p->x[i]), real_abs(p->y[i])));
    return size;
}

static inline bool is_compact(const struct family *f)
{
    for (int i = 0; i < f->region->count; i++) {
        const struct region_edge *e = &f->region->edge[i];
        if (e->from_infinity || e->to_infinity ||
            real_abs(e->from.x) + real_abs(e->from.y) > 100 * size_of(f))
            return false;
    }
    return f->region->kind == REGION_BOUNDED;
}

#endif
