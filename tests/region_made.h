/* Families in memory of their own, and their regions, for tests. */
#ifndef FATLINE_TEST_REGION_MADE_H
#define FATLINE_TEST_REGION_MADE_H

#include "region_family.h"
#include "region_proof.h"

enum { POINTS = 40, KNOTS = 80 };

/* A family with its numbers beside it; not to be copied. */
struct made {
    struct region_problem p;
    real x[POINTS], y[POINTS], weight[POINTS], share[POINTS], knots[KNOTS];
};

static inline void made_link(struct made *m)
{
    struct control_family *f = &m->p.family;
    f->x = m->x;
    f->y = m->y;
    f->knots = m->knots;
    f->share = m->share;
    f->weight = f->weight ? m->weight : NULL;
}

static inline void made_from(const struct region_problem *p, struct made *m)
{
    m->p = *p;
    for (int i = 0; i < p->family.count; i++) {
        m->x[i] = p->family.x[i];
        m->y[i] = p->family.y[i];
        m->share[i] = p->family.share[i];
        m->weight[i] = p->family.weight ? p->family.weight[i] : (real)1;
    }
    for (int i = 0; i <= p->family.count + p->family.degree; i++)
        m->knots[i] = p->family.knots[i];
    made_link(m);
}

/* A Bezier curve over [0, 1] with control point i free. */
static inline void made_bezier(struct made *m, int degree, int i, int sign)
{
    memset((void *)&m->p, 0, sizeof m->p);
    m->p.family.degree = degree;
    m->p.family.count = degree + 1;
    for (int k = 0; k <= degree; k++) {
        m->knots[k] = 0;
        m->knots[degree + 1 + k] = 1;
        m->weight[k] = 1;
    }
    m->p.interval.lo = 0;
    m->p.interval.hi = 1;
    m->p.sign = sign;
    m->p.tolerance = 0; /* zeroed memory is no number at multi */
    m->p.max_steps = REGION_STEPS_MAX;
    made_link(m);
    family_of_point(&m->p.family, i, m->share);
}

/* Solves m into out, with a workspace that the caller clears. */
static inline void solve(const struct made *m, struct owned_workspace *room, struct region *out)
{
    owned_workspace_fit(room, &m->p);
    assert_int_equal(region_solve(&m->p, region_methods[0], &room->workspace, out), SOLVED);
}

#endif
