/* Where the value ranges of two monotone pieces meet. */
#include "exact_arcs.h"
#include "exact_algebraic.h"

#include <stdlib.h>

enum { PREC_LAST = 1 << 14 };

/* The value at one end of a piece: that of break `index` of `side`, or an infinity. */
struct level {
    int side, index, infinite;
};

static struct level level_of(const struct arcs *k, int side, int piece, bool upper)
{
    const struct side *d = &k->side[side];
    struct level v = {side, d->rising[piece] == upper ? piece + 1 : piece, 0};
    if (real_root_of(&d->breaks.at[v.index], d->den))
        v.infinite = upper ? 1 : -1;
    return v;
}

static void level_polynomial(fmpz_poly_t v, const struct side *d, const struct real_root *r)
{
    fmpz_poly_t p;
    fmpz_poly_init(p);
    if (r->exact) {
        fmpz_poly_set_coeff_fmpz(p, 1, fmpq_denref(r->value));
        fmpz_poly_set_coeff_fmpz(p, 0, fmpq_numref(r->value));
        fmpz_neg(p->coeffs, p->coeffs);
    } else {
        /* Without the poles, where the value has no polynomial. */
        fmpz_poly_gcd(p, r->p, d->den);
        fmpz_poly_div(p, r->p, p);
    }
    exact_value_polynomial(v, p, d->num, d->den);
    fmpz_poly_clear(p);
}

static void level_ball(arb_t v, const struct side *d, struct real_root *r, slong prec)
{
    arb_t b;
    arb_init(b);
    slong work = prec + 64 + labs(fmpz_poly_max_bits(d->num)) + labs(fmpz_poly_max_bits(d->den));
    real_root_refine(r, prec, false);
    fmpz_poly_t const *part[2] = {&d->num, &d->den};
    for (int i = 0; i < 2; i++) {
        arb_ptr to = i ? b : v;
        arb_zero(to);
        for (slong j = fmpz_poly_degree(*part[i]); j >= 0; j--) {
            arb_mul(to, to, r->ball, work);
            arb_add_fmpz(to, to, (*part[i])->coeffs + j, work);
        }
    }
    arb_div(v, v, b, work);
    arb_clear(b);
}

/* -1, 0, 1; 2 when it stays undecided. */
static int compare_levels(struct arcs *k, struct level a, struct level b)
{
    if (a.infinite || b.infinite)
        return (a.infinite > b.infinite) - (a.infinite < b.infinite);
    if (a.side == b.side && a.index == b.index)
        return 0;
    struct side *d = &k->side[a.side], *e = &k->side[b.side];
    struct real_root *x = &d->breaks.at[a.index], *y = &e->breaks.at[b.index];
    arb_t u, v;
    fmpz_poly_t pu, pv;
    arb_init(u);
    arb_init(v);
    fmpz_poly_init(pu);
    fmpz_poly_init(pv);
    level_polynomial(pu, d, x);
    level_polynomial(pv, e, y);
    int order = 2;
    for (slong prec = PREC_BREAK; order == 2 && prec <= PREC_LAST; prec *= 2) {
        level_ball(u, d, x, prec);
        level_ball(v, e, y, prec);
        order = exact_compare(u, pu, v, pv, prec);
    }
    arb_clear(u);
    arb_clear(v);
    fmpz_poly_clear(pu);
    fmpz_poly_clear(pv);
    return order;
}

static struct corner corner_at(struct arcs *k, const int piece[2], struct level v, bool *sure)
{
    struct corner c;
    for (int side = 0; side < 2; side++) {
        c.at[side] = -1;
        for (int upper = 0; upper < 2; upper++) {
            struct level own = level_of(k, side, piece[side], upper);
            int order = compare_levels(k, own, v);
            *sure = *sure && order != 2;
            if (order == 0)
                c.at[side] = own.index;
        }
    }
    return c;
}

/* Adds the meeting of two pieces, or the corner where they only touch. */
bool arcs_meet(struct arcs *k, int i, int j, struct meeting_list *m, struct meeting_list *touching)
{
    struct level low[2] = {level_of(k, 0, i, false), level_of(k, 1, j, false)};
    struct level high[2] = {level_of(k, 0, i, true), level_of(k, 1, j, true)};
    int below = compare_levels(k, low[0], low[1]), above = compare_levels(k, high[0], high[1]);
    struct level lo = below < 0 ? low[1] : low[0], hi = above > 0 ? high[1] : high[0];
    int order = compare_levels(k, lo, hi);
    if (below == 2 || above == 2 || order == 2)
        return false;
    if (order > 0)
        return true;
    bool sure = true;
    struct meeting new = {.piece = {i, j}};
    struct meeting_list *to = order < 0 ? m : touching;
    new.end[0] = corner_at(k, new.piece, k->side[0].rising[i] ? lo : hi, &sure);
    new.end[1] = corner_at(k, new.piece, k->side[0].rising[i] ? hi : lo, &sure);
    to->at = realloc(to->at, (size_t)(to->count + 1) * sizeof *to->at);
    to->at[to->count++] = new;
    return sure;
}
