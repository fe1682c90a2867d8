/* Paths for tests: made of lines and of cubics in pieces, their records, and where a record is. */
#ifndef FATLINE_TEST_PATHS_H
#define FATLINE_TEST_PATHS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/paths/path_job.h"
#include "../harness/cases/problem.h"

enum { RUNS = REAL_BITS > 113 ? 1 : REAL_BITS > 53 ? 3 : 40 };

static const volatile int never = 0;

/* Points of a segment: x then y, `degree + 1` each. */
static inline void add(struct path_draft *d, int degree, const real *c)
{
    assert_true(path_draft_add(d, degree, c, c + degree + 1, NULL));
}

static inline void add_line(struct path_draft *d, real x0, real y0, real x1, real y1)
{
    real c[4] = {x0, x1, y0, y1};
    add(d, 1, c);
}

static inline void polyline(struct path_set *set, int points, const real *x, const real *y)
{
    struct path_draft d;
    path_draft_begin(&d, "polyline");
    for (int i = 0; i + 1 < points; i++)
        add_line(&d, x[i], y[i], x[i + 1], y[i + 1]);
    path_draft_end(&d, set);
}

/* A cubic with control points k 2^-12 in [-1, 1], so that halving it twice is exact in doubles. */
static inline void random_cubic(struct random_state *r, real c[8])
{
    for (int i = 0; i < 8; i++)
        c[i] = prop_dyadic(r, 12);
}

static inline void halve(const real c[4], real left[4], real right[4])
{
    real a = (c[0] + c[1]) / 2, b = (c[1] + c[2]) / 2, e = (c[2] + c[3]) / 2;
    left[0] = c[0];
    left[1] = a;
    left[2] = (a + b) / 2;
    left[3] = right[0] = (left[2] + (b + e) / 2) / 2;
    right[1] = (b + e) / 2;
    right[2] = e;
    right[3] = c[3];
}

/* c in 2^cuts pieces, exactly. */
static inline void add_pieces(struct path_draft *d, const real c[8], int cuts)
{
    real left[8], right[8];
    if (cuts == 0) {
        add(d, 3, c);
        return;
    }
    halve(c, left, right);
    halve(c + 4, left + 4, right + 4);
    add_pieces(d, left, cuts - 1);
    add_pieces(d, right, cuts - 1);
}

static inline void pieces(struct path_set *set, const real c[8], int cuts)
{
    struct path_draft d;
    path_draft_begin(&d, "pieces");
    add_pieces(&d, c, cuts);
    path_draft_end(&d, set);
}

static inline void job_of(struct path_job *job, const struct loaded_path *a, const struct loaded_path *b)
{
    path_job_make(job, a, b, (real)1 / 1000000000000, STEPS_MAX);
    assert_true(path_job_run(job, &never));
}

static inline bool is_in(const struct path_span *s, int segment, real t)
{
    if (s->first == s->last)
        return s->first == segment && s->lo <= t && t <= s->hi;
    return (s->first == segment && s->lo <= t) || (s->last == segment && t <= s->hi);
}

static inline bool spans_touch(const struct path_span *p, const struct path_span *q)
{
    return p->first == q->first && p->last == q->last && p->lo <= q->hi && q->lo <= p->hi;
}

#endif
