/* Common zeros of two polynomials in the unit square: roots of both resultants, paired by proof.
 *
 * A pair of roots is excluded when the balls of p or q over it do not hold 0.  It is confirmed
 *   - both rational: by substitution;
 *   - one rational: by the greatest common divisor of p and q on that line;
 *   - a simple zero: by Krawczyk's test (Moore and Qi 1982) on a box that holds no other roots of the
 * resultants;
 *   - a multiple zero: by comparing both coordinates of f(t) and g(s) as algebraic numbers. */
#include "exact_system.h"
#include "exact_algebraic.h"

#include <stdlib.h>
#include <flint/fmpz_poly_factor.h>
#include <arb_fmpz_poly.h>

enum { PREC_FIRST = 128, PREC_LAST = 1 << 15 };

struct exact_point *point_list_append(struct point_list *l, const struct real_root *t,
                                      const struct real_root *s)
{
    l->at = realloc(l->at, (size_t)(l->count + 1) * sizeof *l->at);
    struct exact_point *c = &l->at[l->count++];
    real_root_init(&c->t);
    real_root_init(&c->s);
    real_root_set(&c->t, t);
    real_root_set(&c->s, s);
    c->multiplicity = c->order_f = c->order_g = 0;
    return c;
}

void point_list_clear(struct point_list *l)
{
    for (int i = 0; i < l->count; i++) {
        real_root_clear(&l->at[i].t);
        real_root_clear(&l->at[i].s);
    }
    free(l->at);
    *l = (struct point_list){0};
}

enum fate { OPEN, EXCLUDED, CONFIRMED };

struct search {
    const struct exact_system *e;
    struct biv pt, ps, qt, qs; /* partial derivatives */
    struct root_list t, s;
    enum fate *fate; /* of pair (i, j) at i s.count + j */
    slong bits;
};

static bool excluded(const struct search *a, const struct real_root *t, const struct real_root *s, slong prec)
{
    arb_t v;
    arb_init(v);
    biv_value(v, &a->e->p, t->ball, s->ball, prec);
    if (arb_contains_zero(v))
        biv_value(v, &a->e->q, t->ball, s->ball, prec);
    bool is = !arb_contains_zero(v);
    arb_clear(v);
    return is;
}

/* Exact: t is rational.  Do p and q have a common zero (t, s)? */
static bool common_on_line(const struct biv *p, const struct biv *q, const struct real_root *t,
                           const struct real_root *s)
{
    fmpz_poly_t a, b;
    fmpz_poly_init(a);
    fmpz_poly_init(b);
    biv_restrict_t(a, p, t->value);
    biv_restrict_t(b, q, t->value);
    fmpz_poly_gcd(a, a, b);
    bool is = real_root_of(s, a);
    fmpz_poly_clear(a);
    fmpz_poly_clear(b);
    return is;
}

static enum fate decide_rational(const struct search *a, const struct real_root *t, const struct real_root *s)
{
    bool is;
    if (t->exact) {
        is = common_on_line(&a->e->p, &a->e->q, t, s);
    } else {
        struct biv p, q;
        biv_swap_variables(&p, &a->e->p);
        biv_swap_variables(&q, &a->e->q);
        is = common_on_line(&p, &q, s, t);
        biv_clear(&p);
        biv_clear(&q);
    }
    return is ? CONFIRMED : EXCLUDED;
}

/* The ball r widened to radius 2^-scale, if no other root of the list comes into it; else false. */
static bool widened(arb_t box, const struct root_list *l, const struct real_root *r, slong scale)
{
    arb_t lo, hi;
    arb_init(lo);
    arb_init(hi);
    arb_set(box, r->ball);
    arb_add_error_2exp_si(box, -scale);
    arb_set_fmpq(lo, r->lo, 2 * scale + 64);
    arb_set_fmpq(hi, r->hi, 2 * scale + 64);
    bool alone = arb_lt(lo, box) && arb_lt(box, hi);
    for (int k = 0; k < l->count && alone; k++)
        alone = &l->at[k] == r || !arb_overlaps(box, l->at[k].ball);
    arb_clear(lo);
    arb_clear(hi);
    return alone;
}

/* An approximate inverse of the Jacobian at the point m, as exact numbers; false if it may be singular. */
static bool approximate_inverse(const struct search *a, arb_ptr y, arb_srcptr m, slong prec)
{
    const struct biv *derivative[4] = {&a->pt, &a->ps, &a->qt, &a->qs};
    arb_t det;
    arb_init(det);
    for (int i = 0; i < 4; i++)
        biv_value(y + i, derivative[i], m, m + 1, prec);
    arb_mul(det, y, y + 3, prec);
    arb_submul(det, y + 1, y + 2, prec);
    bool regular = !arb_contains_zero(det);
    arb_swap(y, y + 3);
    arb_neg(y + 1, y + 1);
    arb_neg(y + 2, y + 2);
    for (int i = 0; i < 4 && regular; i++) {
        arb_div(y + i, y + i, det, prec);
        arb_get_mid_arb(y + i, y + i);
    }
    arb_clear(det);
    return regular;
}

/* Row `row` of Krawczyk's operator m - Y F(m) + (I - Y J(b)) (b - m). */
static void krawczyk_row(arb_t k, int row, arb_srcptr y, arb_srcptr value, arb_srcptr jacobian, arb_srcptr m,
                         arb_srcptr b, slong prec)
{
    arb_t e, r;
    arb_init(e);
    arb_init(r);
    arb_mul(k, y + 2 * row, value, prec);
    arb_addmul(k, y + 2 * row + 1, value + 1, prec);
    arb_sub(k, m + row, k, prec);
    for (int col = 0; col < 2; col++) {
        arb_mul(e, y + 2 * row, jacobian + col, prec);
        arb_addmul(e, y + 2 * row + 1, jacobian + 2 + col, prec);
        arb_sub_si(e, e, row == col, prec);
        arb_sub(r, m + col, b + col, prec);
        arb_addmul(k, e, r, prec);
    }
    arb_clear(e);
    arb_clear(r);
}

/* Does Krawczyk's operator map the box b (two balls) into its interior? */
static bool krawczyk(const struct search *a, arb_srcptr b, slong prec)
{
    arb_ptr m = _arb_vec_init(2), v = _arb_vec_init(2), j = _arb_vec_init(4), y = _arb_vec_init(4);
    const struct biv *derivative[4] = {&a->pt, &a->ps, &a->qt, &a->qs};
    arb_t k;
    arb_init(k);
    arb_get_mid_arb(m, b);
    arb_get_mid_arb(m + 1, b + 1);
    biv_value(v, &a->e->p, m, m + 1, prec);
    biv_value(v + 1, &a->e->q, m, m + 1, prec);
    for (int i = 0; i < 4; i++)
        biv_value(j + i, derivative[i], b, b + 1, prec);
    bool in = approximate_inverse(a, y, m, prec);
    for (int row = 0; row < 2 && in; row++) {
        krawczyk_row(k, row, y, v, j, m, b, prec);
        in = arb_contains_interior(b + row, k);
    }
    arb_clear(k);
    _arb_vec_clear(m, 2);
    _arb_vec_clear(v, 2);
    _arb_vec_clear(j, 4);
    _arb_vec_clear(y, 4);
    return in;
}

static bool confirmed_simple(const struct search *a, const struct real_root *t, const struct real_root *s,
                             slong prec)
{
    arb_ptr box = _arb_vec_init(2);
    bool is = widened(box, &a->t, t, prec / 3) && widened(box + 1, &a->s, s, prec / 3) &&
              krawczyk(a, box, prec + a->bits);
    _arb_vec_clear(box, 2);
    return is;
}

static enum fate decide_multiple(const struct search *a, const struct real_root *t, const struct real_root *s,
                                 slong prec)
{
    const struct exact_curve *f = &a->e->pair->f, *g = &a->e->pair->g;
    int x = exact_compare_quotients(t, f->x, f->w, s, g->x, g->w, prec);
    int y = x == 0 ? exact_compare_quotients(t, f->y, f->w, s, g->y, g->w, prec) : x;
    if (y == 2)
        return OPEN;
    return x == 0 && y == 0 ? CONFIRMED : EXCLUDED;
}

static enum fate decide(const struct search *a, const struct real_root *t, const struct real_root *s,
                        slong prec)
{
    if (excluded(a, t, s, prec + a->bits))
        return EXCLUDED;
    if (t->exact || s->exact)
        return decide_rational(a, t, s);
    if (confirmed_simple(a, t, s, prec))
        return CONFIRMED;
    if (t->multiplicity > 1 && s->multiplicity > 1 && prec > PREC_FIRST)
        return decide_multiple(a, t, s, prec);
    return OPEN;
}

static const char *pair_up(struct search *a)
{
    int open = a->t.count * a->s.count;
    for (slong prec = PREC_FIRST; open > 0; prec *= 2) {
        for (int i = 0; i < a->t.count; i++)
            real_root_refine(&a->t.at[i], prec, false);
        for (int j = 0; j < a->s.count; j++)
            real_root_refine(&a->s.at[j], prec, false);
        open = 0;
        for (int k = 0; k < a->t.count * a->s.count; k++) {
            if (a->fate[k] == OPEN)
                a->fate[k] = decide(a, &a->t.at[k / a->s.count], &a->s.at[k % a->s.count], prec);
            open += a->fate[k] == OPEN;
        }
        if (open > 0 && prec >= PREC_LAST)
            return "a common point stayed undecided at 32768 bits";
        if (open > 0 && a->e->pair->deadline > 0 && exact_clock() > a->e->pair->deadline)
            return "time limit";
    }
    return NULL;
}

const char EXACT_COMMON_COMPONENT[] = "the curves have a common component";

static const char *find_roots(const struct exact_system *e, struct search *a)
{
    const struct exact_curve *f = &e->pair->f, *g = &e->pair->g;
    struct biv p, q;
    fmpz_poly_t r;
    fmpz_poly_init(r);
    int degree = e->whole ? f->n * g->n : e->p.n * e->q.m + e->q.n * e->p.m;
    bool in_time = biv_resultant(r, &e->p, &e->q, degree, e->whole ? f->w : NULL, e->pair->deadline);
    bool common = in_time && fmpz_poly_is_zero(r);
    if (in_time && !common)
        root_list_find(&a->t, r);
    if (a->t.count > 0) {
        biv_swap_variables(&p, &e->p);
        biv_swap_variables(&q, &e->q);
        in_time = biv_resultant(r, &p, &q, degree, e->whole ? g->w : NULL, e->pair->deadline);
        if (in_time)
            root_list_find(&a->s, r);
        biv_clear(&p);
        biv_clear(&q);
    }
    fmpz_poly_clear(r);
    return common ? EXACT_COMMON_COMPONENT : in_time ? NULL : "time limit";
}

static const char *collect(struct search *a, struct point_list *l)
{
    const struct exact_pair *pair = a->e->pair;
    for (int i = 0; i < a->t.count; i++)
        for (int j = 0; j < a->s.count; j++)
            if (a->fate[i * a->s.count + j] == CONFIRMED) {
                struct exact_point *c = point_list_append(l, &a->t.at[i], &a->s.at[j]);
                c->order_f = real_root_order(&c->t, pair->f.stationary);
                c->order_g = real_root_order(&c->s, pair->g.stationary);
                c->multiplicity = a->e->whole ? exact_multiplicity(a->e, c) : 0;
                if (a->e->whole && c->multiplicity == 0)
                    return "the multiplicity of a common point stayed undecided";
            }
    return NULL;
}

const char *exact_system_solve(const struct exact_system *e, struct point_list *l)
{
    struct search a = {.e = e};
    const char *trouble = find_roots(e, &a);
    biv_derive_t(&a.pt, &e->p);
    biv_derive_s(&a.ps, &e->p);
    biv_derive_t(&a.qt, &e->q);
    biv_derive_s(&a.qs, &e->q);
    a.bits = 64 + biv_bits(&e->p) + biv_bits(&e->q);
    a.fate = calloc((size_t)(a.t.count * a.s.count + 1), sizeof *a.fate);
    if (!trouble)
        trouble = pair_up(&a);
    if (!trouble)
        trouble = collect(&a, l);
    free(a.fate);
    biv_clear(&a.pt);
    biv_clear(&a.ps);
    biv_clear(&a.qt);
    biv_clear(&a.qs);
    root_list_clear(&a.t);
    root_list_clear(&a.s);
    return trouble;
}
