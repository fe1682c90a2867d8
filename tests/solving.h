/* One solve in guarded memory of just the size asked for, and what every answer must satisfy. */
#ifndef FATLINE_SOLVING_H
#define FATLINE_SOLVING_H

#include <stdlib.h>
#include <string.h>

#include "planted.h"

enum { GUARD = 4096, GUARD_BYTE = 0xa5 };

struct solver {
    const struct intersector *algorithm;
    struct workspace workspace;
    unsigned char *memory;
    size_t size;
    struct {
        unsigned char before[GUARD];
        struct crossings crossings;
        unsigned char after[GUARD];
    } answer;
};

static inline void solver_init(struct solver *z, const struct intersector *a, int n, int m, int room)
{
    size_t scratch = a->scratch ? a->scratch(n, m) : 0;
    z->algorithm = a;
    z->size = workspace_size(n, m, room, scratch);
    z->memory = (unsigned char *)malloc(z->size + 2 * GUARD);
    assert_non_null(z->memory);
    memset(z->memory, GUARD_BYTE, z->size + 2 * GUARD);
    memset(z->answer.before, GUARD_BYTE, GUARD);
    memset(z->answer.after, GUARD_BYTE, GUARD);
    workspace_init(&z->workspace, z->memory + GUARD, n, m, room, scratch);
}

static inline bool is_guard(const unsigned char *bytes)
{
    for (int i = 0; i < GUARD; i++)
        if (bytes[i] != GUARD_BYTE)
            return false;
    return true;
}

/* Ends with a look at the guards. */
static inline void solver_clear(struct solver *z)
{
    bool intact = is_guard(z->memory) && is_guard(z->memory + GUARD + z->size) &&
                  is_guard(z->answer.before) && is_guard(z->answer.after);
    free(z->memory);
    if (!intact)
        fail_msg("%s: wrote outside its workspace or the answer", z->algorithm->name);
}

static inline struct problem problem_of(const struct curve *f, const struct curve *g, real tolerance,
                                        int max_steps)
{
    struct problem p;
    memset(&p, 0, sizeof p);
    p.f = *f;
    p.g = *g;
    p.tolerance = tolerance;
    p.max_steps = max_steps;
    p.known = NULL;
    return p;
}

/* Width asked for, or the narrowest there is: 4 eps of the domain, rounding of the map to it. */
static inline real widest(const struct problem *p, const struct interval *domain)
{
    real size = real_max(real_abs(domain->lo), real_abs(domain->hi));
    return real_max(p->tolerance, 4 * REAL_EPSILON * (domain->hi - domain->lo)) + 16 * REAL_EPSILON * size;
}

static inline bool is_part(const struct interval *a, const struct interval *domain)
{
    return domain->lo <= a->lo && a->lo <= a->hi && a->hi <= domain->hi;
}

/* NULL, or what is wrong with the answer whatever the solutions are. */
static inline const char *answer_mistake(const struct problem *p, enum outcome o, const struct crossings *c)
{
    if (c->count < 0 || c->count > CROSSINGS_MAX || c->overlaps < 0 || c->overlaps > OVERLAPS_MAX)
        return "counts beyond their limits";
    if ((o == INVALID || o == UNSUPPORTED) && (c->count || c->overlaps))
        return "records of a problem that was not taken";
    for (int i = 0; i < c->count; i++) {
        const struct crossing *x = &c->at[i];
        if (!is_part(&x->t, &p->f.domain) || !is_part(&x->s, &p->g.domain))
            return "a record outside the domain";
        if (o == SOLVED && x->standing == CANDIDATE &&
            (x->t.hi - x->t.lo > widest(p, &p->f.domain) || x->s.hi - x->s.lo > widest(p, &p->g.domain)))
            return "solved, but a candidate is wider than asked";
        if (i > 0 && (x->t.lo < x[-1].t.lo || (x->t.lo == x[-1].t.lo && x->s.lo < x[-1].s.lo)))
            return "records out of order";
    }
    return NULL;
}

static inline enum outcome solver_run(struct solver *z, const struct problem *p)
{
    struct crossings *c = &z->answer.crossings;
    enum outcome o = problem_solve(p, z->algorithm, &z->workspace, c);
    const char *mistake = answer_mistake(p, o, c);
    if (mistake)
        fail_msg("%s: %s (%s)", z->algorithm->name, mistake, outcome_name(o));
    return o;
}

/* lo - pad <= q <= hi + pad? */
static inline bool holds(const struct interval *a, const mpq_t q, real pad)
{
    mpq_t end, more;
    mpq_init(end);
    mpq_init(more);
    real_to_rational(pad, more);
    real_to_rational(a->lo, end);
    mpq_sub(end, end, more);
    bool inside = mpq_cmp(end, q) <= 0;
    real_to_rational(a->hi, end);
    mpq_add(end, end, more);
    inside = inside && mpq_cmp(q, end) <= 0;
    mpq_clear(end);
    mpq_clear(more);
    return inside;
}

/* Is (t, s), in local parameters, in some record?  Points without a proof are given 1e-6. */
static inline bool is_covered(const struct problem *p, const struct solver *z, real t, real s)
{
    const struct crossings *c = &z->answer.crossings;
    real pad = z->algorithm->points_only ? (real)1 / 1000000 : (real)0;
    real pad_t = pad * (p->f.domain.hi - p->f.domain.lo), pad_s = pad * (p->g.domain.hi - p->g.domain.lo);
    mpq_t exact_t, exact_s;
    bool covered = false;
    mpq_init(exact_t);
    mpq_init(exact_s);
    exact_parameter(&p->f.domain, t, exact_t);
    exact_parameter(&p->g.domain, s, exact_s);
    for (int i = 0; i < c->count && !covered; i++)
        covered = holds(&c->at[i].t, exact_t, pad_t) && holds(&c->at[i].s, exact_s, pad_s);
    for (int i = 0; i < c->overlaps && !covered; i++)
        covered = holds(&c->overlap[i].t_outer, exact_t, 0) && holds(&c->overlap[i].s_outer, exact_s, 0);
    mpq_clear(exact_t);
    mpq_clear(exact_s);
    return covered;
}

#endif
