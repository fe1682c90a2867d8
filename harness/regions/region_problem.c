#include "region_problem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"
#include "../run/memory.h"

static real *fill(const mpq_t *from, int n, real *to)
{
    for (int i = 0; i < n; i++)
        to[i] = real_from_rational(from[i]);
    return to + n;
}

static void set_handle(const struct region_case *c, int free_point, real *share, struct control_family *f)
{
    if (free_point >= 0)
        family_of_point(f, free_point, share);
    else if (c->members > 0)
        family_of_group(f, c->members, c->member, share);
    else
        family_of_drag(f, real_from_rational(c->drag), share);
}

const char *owned_region_make(const struct region_case *c, int free_point, real tolerance, int max_steps,
                              struct owned_region *p)
{
    static char message[160];
    struct control_family *f = &p->problem.family;
    const char *field;
    size_t n = (size_t)c->count;
    memset((void *)p, 0, sizeof *p);
    p->memory = (real *)memory_resized(NULL, (5 * n + (size_t)c->degree + 1) * sizeof(real));
    real *x = p->memory, *y = fill(c->x, c->count, x), *w = fill(c->y, c->count, y);
    real *knots = fill(c->w, c->count, w), *share = fill(c->knots, c->count + c->degree + 1, knots);
    f->degree = c->degree;
    f->count = c->count;
    f->x = x;
    f->y = y;
    f->weight = c->rational ? w : NULL;
    f->knots = knots;
    set_handle(c, free_point, share, f);
    p->problem.interval.lo = real_from_rational(c->lo);
    p->problem.interval.hi = real_from_rational(c->hi);
    p->problem.sign = c->sign;
    p->problem.loop_free = c->loop_free;
    p->problem.tolerance = tolerance;
    p->problem.max_steps = max_steps;
    const char *wrong = region_problem_check(&p->problem, &field);
    if (wrong) {
        snprintf(message, sizeof message, "%s: %s", field, wrong);
        owned_region_clear(p);
    }
    return wrong ? message : NULL;
}

void owned_region_clear(struct owned_region *p)
{
    free(p->memory);
    p->memory = NULL;
}

void owned_workspace_fit(struct owned_workspace *w, const struct region_problem *p)
{
    int degree = p->family.degree, spans = p->family.count - p->family.degree;
    if (w->memory && degree <= w->workspace.degree && spans <= w->workspace.spans)
        return;
    if (w->memory) {
        degree = degree > w->workspace.degree ? degree : w->workspace.degree;
        spans = spans > w->workspace.spans ? spans : w->workspace.spans;
        free(w->memory);
    }
    w->memory = memory_resized(NULL, region_workspace_size(degree, spans));
    region_workspace_init(&w->workspace, w->memory, degree, spans);
}

void owned_workspace_clear(struct owned_workspace *w)
{
    free(w->memory);
    w->memory = NULL;
}
