/* Ends of shared arcs: zeros of the common component inside monotone pieces. */
#include "exact_arcs.h"

/* An end near 0 is as small as a quotient of doubles may be. */
enum { SMALLEST = 2200, REFINED_MOST = 4 };

/* Of c(t, s) by balls: 0 if it is 0, or too near to tell. */
static int sign_on(const struct biv *c, const arf_t t, struct real_root *s, slong prec)
{
    arb_t x, v;
    arb_init(x);
    arb_init(v);
    arb_set_arf(x, t);
    arb_zero(v);
    for (int k = 0; k <= REFINED_MOST && arb_contains_zero(v); k++) {
        if (k > 0 || s->exact)
            real_root_refine(s, prec << k, false);
        biv_value(v, c, x, s->ball, (prec << (k + 1)) + biv_bits(c));
    }
    int sign = arb_is_positive(v) ? 1 : arb_is_negative(v) ? -1 : 0;
    arb_clear(x);
    arb_clear(v);
    return sign;
}

/* Where s is a fraction: an end that is one, because c(t, s) is linear in t, or short. */
static void recognise_end(struct real_root *r, const struct biv *c, const arf_t lo, const arf_t hi,
                          const struct real_root *s)
{
    struct biv swapped;
    fmpq_t a, b;
    fmpz_poly_t p;
    if (!s->exact)
        return;
    fmpq_init(a);
    fmpq_init(b);
    fmpz_poly_init(p);
    biv_swap_variables(&swapped, c);
    biv_restrict_t(p, &swapped, s->value);
    arf_get_fmpq(a, lo);
    arf_get_fmpq(b, hi);
    fmpq_simplest_between(a, a, b);
    if (fmpz_poly_degree(p) == 1) {
        fmpq_set_fmpz_frac(a, p->coeffs, p->coeffs + 1);
        fmpq_neg(a, a);
    }
    if (polynomial_sign(p, a) == 0)
        real_root_set_exact(r, a);
    biv_clear(&swapped);
    fmpq_clear(a);
    fmpq_clear(b);
    fmpz_poly_clear(p);
}

/* hi - lo <= 2^-bits of the larger of the two? */
static bool is_narrow(const arf_t lo, const arf_t hi, slong bits)
{
    arf_t width, most;
    arf_init(width);
    arf_init(most);
    arf_sub(width, hi, lo, MAG_BITS, ARF_RND_UP);
    arf_mul_2exp_si(width, width, bits);
    arf_abs(most, arf_cmpabs(lo, hi) > 0 ? lo : hi);
    bool narrow = arf_cmp(width, most) <= 0;
    arf_clear(width);
    arf_clear(most);
    return narrow;
}

/* The only zero of t -> c(t, s) between two breaks, to `bits` bits. */
static bool solve_between(struct real_root *r, const struct biv *c, const struct real_root *from,
                          const struct real_root *to, struct real_root *s, slong bits)
{
    const slong prec = bits + PREC_BREAK;
    arf_t lo, hi, mid;
    arf_init(lo);
    arf_init(hi);
    arf_init(mid);
    arb_get_lbound_arf(lo, from->ball, prec);
    arb_get_ubound_arf(hi, to->ball, prec);
    arf_set_round(mid, arb_midref(from->ball), prec, ARF_RND_NEAR);
    int left = sign_on(c, mid, s, prec), sign = left;
    for (slong k = 0; k < bits + SMALLEST && sign && !is_narrow(lo, hi, bits); k++) {
        sign = 0;
        for (int part = 4; part >= 3 && sign == 0; part--) { /* the middle, or 3/8 should that be the zero */
            arf_sub(mid, hi, lo, prec, ARF_RND_NEAR);
            arf_mul_si(mid, mid, part, prec, ARF_RND_NEAR);
            arf_mul_2exp_si(mid, mid, -3);
            arf_add(mid, mid, lo, prec, ARF_RND_NEAR);
            sign = sign_on(c, mid, s, prec);
        }
        if (sign)
            arf_set(sign == left ? lo : hi, mid);
    }
    arb_set_interval_arf(r->ball, lo, hi, prec);
    recognise_end(r, c, lo, hi, s);
    arf_clear(lo);
    arf_clear(hi);
    arf_clear(mid);
    return left != 0 && sign != 0;
}

bool arcs_corner(struct arcs *k, struct corner c, const int piece[2], struct real_root *t,
                 struct real_root *s)
{
    struct root_list *b[2] = {&k->side[0].breaks, &k->side[1].breaks};
    struct real_root *to[2] = {t, s};
    for (int side = 0; side < 2; side++)
        if (c.at[side] >= 0)
            real_root_set(to[side], &b[side]->at[c.at[side]]);
    if (c.at[0] < 0)
        return solve_between(t, &k->component, &b[0]->at[piece[0]], &b[0]->at[piece[0] + 1], s, k->bits);
    if (c.at[1] < 0) {
        struct biv swapped;
        biv_swap_variables(&swapped, &k->component);
        bool done = solve_between(s, &swapped, &b[1]->at[piece[1]], &b[1]->at[piece[1] + 1], t, k->bits);
        biv_clear(&swapped);
        return done;
    }
    return true;
}
