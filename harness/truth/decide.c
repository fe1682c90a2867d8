#include "decide.h"

#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"
#include "exact_apart.h"

/* Of parameters that are no fractions; should the ends of a shared arc not be known to so many, fewer do. */
enum { DIGITS = REAL_BITS > 113 ? 700 : 80, DIGITS_LESS = 60 };

/* ---- is there anything to decide? ---- */

static bool is_same(real a, const mpq_t q, const mpq_t times)
{
    mpq_t exact, product;
    if (!real_is_finite(a))
        return false;
    mpq_inits(exact, product, NULL);
    real_to_rational(a, exact);
    mpq_mul(product, q, times);
    bool same = mpq_equal(exact, product);
    mpq_clears(exact, product, NULL);
    return same;
}

/* Is the problem's curve the case's? */
static bool is_exact(const struct case_curve *c, const struct curve *p)
{
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    bool same = is_same(p->domain.lo, c->lo, one) && is_same(p->domain.hi, c->hi, one);
    for (int i = 0; i <= c->degree && same; i++) {
        mpq_srcptr w = c->rational ? c->w[i] : one;
        same = is_same(p->x[i], c->x[i], w) && is_same(p->y[i], c->y[i], w) &&
               (!c->rational || is_same(p->w[i], c->w[i], one));
    }
    mpq_clear(one);
    return same;
}

/* As narrow as asked, or nearly as can be? */
static bool is_narrow(const struct problem *p, const struct crossing *c)
{
    real most = real_max(p->tolerance, 64 * REAL_EPSILON);
    return c->t.hi - c->t.lo <= most && c->s.hi - c->s.lo <= most;
}

static bool is_settled(const struct problem *p, const struct crossings *x, enum outcome outcome)
{
    bool settled = outcome == SOLVED;
    for (int i = 0; i < x->count && settled; i++)
        settled = x->at[i].standing == UNIQUE && x->at[i].multiplicity == 1 && is_narrow(p, &x->at[i]);
    for (int i = 0; i < x->overlaps && settled; i++)
        settled = x->overlap[i].exact;
    return settled;
}

/* ---- intervals ---- */

/* By rationals: |q - true| <= pad. */
struct rounding {
    mpq_t pad, none;
};

static int compare(real a, const mpq_t q)
{
    mpq_t exact;
    mpq_init(exact);
    real_to_rational(a, exact);
    int order = mpq_cmp(exact, q);
    mpq_clear(exact);
    return order;
}

/* The largest few reals at most q - pad (sign -1), or the least few at least q + pad (sign 1). */
static real beyond(const mpq_t q, const mpq_t pad, int sign)
{
    mpq_t bound;
    mpq_init(bound);
    if (sign < 0)
        mpq_sub(bound, q, pad);
    else
        mpq_add(bound, q, pad);
    real a = real_from_rational(bound);
    while (sign * compare(a, bound) < 0)
        a = a + (real)sign * (REAL_EPSILON * real_abs(a) + REAL_LEAST);
    mpq_clear(bound);
    return a;
}

/* Holds [lo, hi] give or take the pads, within the domain. */
static struct interval around(const mpq_t lo, const mpq_t hi, const mpq_t pad, const struct interval *domain)
{
    struct interval a = {real_max(beyond(lo, pad, -1), domain->lo), real_min(beyond(hi, pad, 1), domain->hi)};
    return a;
}

/* Lies in [lo, hi], give or take the pads; lo > hi: there is no such interval. */
static struct interval inside(const mpq_t lo, const mpq_t hi, const mpq_t pad)
{
    struct interval a = {beyond(lo, pad, 1), beyond(hi, pad, -1)};
    return a;
}

static bool holds(const struct interval *a, const mpq_t q, const mpq_t pad)
{
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    mpq_sub(lo, q, pad);
    mpq_add(hi, q, pad);
    bool inside = compare(a->lo, lo) <= 0 && compare(a->hi, hi) >= 0;
    mpq_clears(lo, hi, NULL);
    return inside;
}

/* Surely not in it. */
static bool excludes(const struct interval *a, const mpq_t q, const mpq_t pad)
{
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    mpq_sub(lo, q, pad);
    mpq_add(hi, q, pad);
    bool outside = compare(a->lo, hi) > 0 || compare(a->hi, lo) < 0;
    mpq_clears(lo, hi, NULL);
    return outside;
}

/* ---- crossings ---- */

static bool record_holds(const struct crossing *c, const struct case_solution *x, const struct rounding *r)
{
    const mpq_t *pad = x->exact ? &r->none : &r->pad;
    return holds(&c->t, x->t, *pad) && holds(&c->s, x->s, *pad);
}

static bool record_excludes(const struct crossing *c, const struct case_solution *x, const struct rounding *r)
{
    const mpq_t *pad = x->exact ? &r->none : &r->pad;
    return excludes(&c->t, x->t, *pad) || excludes(&c->s, x->s, *pad);
}

static bool excludes_others(const struct crossing *c, const struct case_expected *e, int k,
                            const struct rounding *r)
{
    for (int i = 0; i < e->count; i++)
        if (i != k && !record_excludes(c, &e->at[i], r))
            return false;
    return true;
}

/* A UNIQUE of the answer, as narrow as asked, that holds solution k, a simple one, and nothing else; or NULL.
 */
static const struct crossing *proof_of(const struct problem *p, const struct crossings *x,
                                       const struct case_expected *e, int k, const struct rounding *r)
{
    for (int i = 0; i < x->count && e->at[k].multiplicity == 1; i++) {
        const struct crossing *c = &x->at[i];
        if (c->standing == UNIQUE && is_narrow(p, c) && record_holds(c, &e->at[k], r) &&
            excludes_others(c, e, k, r))
            return c;
    }
    return NULL;
}

static struct crossing record_of(const struct problem *p, const struct case_solution *x,
                                 const struct rounding *r)
{
    const mpq_t *pad = x->exact ? &r->none : &r->pad;
    struct crossing c;
    memset((void *)&c, 0, sizeof c);
    c.t = around(x->t, x->t, *pad, &p->f.domain);
    c.s = around(x->s, x->s, *pad, &p->g.domain);
    c.standing = UNIQUE;
    c.at_most = x->multiplicity ? x->multiplicity : 1;
    c.multiplicity = x->multiplicity;
    return c;
}

static bool meet(const struct crossing *a, const struct crossing *b)
{
    return a->t.lo <= b->t.hi && b->t.lo <= a->t.hi && a->s.lo <= b->s.hi && b->s.lo <= a->s.hi;
}

static void join(struct crossing *a, const struct crossing *b)
{
    a->t.lo = real_min(a->t.lo, b->t.lo);
    a->t.hi = real_max(a->t.hi, b->t.hi);
    a->s.lo = real_min(a->s.lo, b->s.lo);
    a->s.hi = real_max(a->s.hi, b->s.hi);
    a->standing = CLUSTER;
    a->at_most += b->at_most;
    a->multiplicity = 0;
}

/* Adds c; rectangles that meet cannot tell their solutions apart. */
static void add(struct crossings *out, struct crossing c)
{
    for (int i = 0; i < out->count; i++)
        if (meet(&out->at[i], &c)) {
            join(&c, &out->at[i]);
            out->at[i] = out->at[--out->count];
            i = -1;
        }
    out->at[out->count++] = c;
}

static int order(const void *a, const void *b)
{
    const struct crossing *p = (const struct crossing *)a, *q = (const struct crossing *)b;
    if (p->t.lo != q->t.lo)
        return p->t.lo < q->t.lo ? -1 : 1;
    return p->s.lo < q->s.lo ? -1 : p->s.lo > q->s.lo;
}

static void settle_crossings(const struct problem *p, const struct case_expected *e, bool same,
                             const struct crossings *from, const struct rounding *r, struct crossings *to)
{
    for (int k = 0; k < e->count; k++) {
        const struct crossing *proof = same ? proof_of(p, from, e, k, r) : NULL;
        struct crossing c = proof ? *proof : record_of(p, &e->at[k], r);
        c.multiplicity = e->at[k].multiplicity;
        add(to, c);
    }
    qsort((void *)to->at, (size_t)to->count, sizeof *to->at, order);
}

/* ---- overlaps ---- */

/* How far the curve moves at most while its parameter changes by d. */
static real reach(const struct curve *c, real d)
{
    real most = 0, light = 1, heavy = 1;
    for (int i = 0; i <= c->degree && c->w; i++) {
        light = i ? real_min(light, c->w[i]) : c->w[i];
        heavy = i ? real_max(heavy, c->w[i]) : c->w[i];
    }
    for (int i = 0; i <= c->degree; i++) {
        real w = c->w ? c->w[i] : (real)1;
        most = real_max(most, real_max(real_abs(c->x[i]), real_abs(c->y[i])) / w);
    }
    /* |f'| <= n r^2 max |P_i+1 - P_i|, r the ratio of the weights (Floater 1992) */
    real ratio = heavy / light;
    return 4 * c->degree * ratio * ratio * most * d / (c->domain.hi - c->domain.lo);
}

/* An arc of no length at a parameter that is no number of this precision: a number next to it stands for it.
 */
static void make_degenerate(const struct curve *c, struct interval *inner, const struct interval *outer,
                            struct overlap *o)
{
    if (inner->lo <= inner->hi)
        return;
    inner->lo = inner->hi = outer->lo;
    o->exact = false;
    o->distance = real_max(o->distance, reach(c, outer->hi - outer->lo));
}

static struct overlap overlap_of(const struct problem *p, const struct case_overlap *x,
                                 const struct rounding *r)
{
    const mpq_t *pad = x->exact ? &r->none : &r->pad;
    struct overlap o;
    o.reversed = mpq_cmp(x->s0, x->s1) > 0;
    mpq_srcptr s0 = o.reversed ? x->s1 : x->s0, s1 = o.reversed ? x->s0 : x->s1;
    o.t_outer = around(x->t0, x->t1, *pad, &p->f.domain);
    o.s_outer = around(s0, s1, *pad, &p->g.domain);
    o.t_inner = inside(x->t0, x->t1, *pad);
    o.s_inner = inside(s0, s1, *pad);
    o.exact = true;
    o.distance = 0;
    make_degenerate(&p->f, &o.t_inner, &o.t_outer, &o);
    make_degenerate(&p->g, &o.s_inner, &o.s_outer, &o);
    return o;
}

/* ---- all ---- */

static const char *settle(const struct problem *p, const struct case_expected *e, bool same, int digits,
                          struct crossings *x)
{
    if (e->count > CROSSINGS_MAX || e->overlaps > OVERLAPS_MAX)
        return "more solutions than an answer has room for";
    struct crossings *from = (struct crossings *)malloc(sizeof *from);
    struct rounding r;
    if (!from)
        return "out of memory";
    memcpy((void *)from, (const void *)x, sizeof *from);
    mpq_inits(r.pad, r.none, NULL);
    mpz_ui_pow_ui(mpq_denref(r.pad), 10, (unsigned long)(digits - 2));
    mpz_set_ui(mpq_numref(r.pad), 1);
    x->count = x->overlaps = 0;
    x->merged = false;
    settle_crossings(p, e, same, from, &r, x);
    for (int i = 0; i < e->overlaps; i++)
        x->overlap[x->overlaps++] = overlap_of(p, &e->overlap[i], &r);
    mpq_clears(r.pad, r.none, NULL);
    free(from);
    return NULL;
}

const char *decide(const struct test_case *c, const struct problem *p, double seconds, enum outcome *outcome,
                   struct crossings *x)
{
    bool same = is_exact(&c->f, &p->f) && is_exact(&c->g, &p->g);
    struct case_expected e;
    struct exact_limits limits = {DIGITS, seconds};
    if (*outcome != SOLVED && *outcome != OUT_OF_STEPS && *outcome != OUT_OF_ROOM)
        return "there is no answer to decide";
    if (same && is_settled(p, x, *outcome))
        return NULL;
    const char *trouble = exact_solve_apart(c, &limits, &e);
    if (trouble && strstr(trouble, "rounded")) {
        limits.digits = DIGITS_LESS;
        trouble = exact_solve_apart(c, &limits, &e);
    }
    if (trouble)
        return trouble;
    trouble = settle(p, &e, same, limits.digits, x);
    case_expected_clear(&e);
    if (!trouble)
        *outcome = SOLVED;
    return trouble;
}
