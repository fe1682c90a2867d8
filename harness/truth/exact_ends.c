/* Ends of shared arcs: zeros of the common component inside monotone pieces. */
#include "exact_arcs.h"

enum { PREC_END = 256 };

static int sign_on(const struct biv *c, const arf_t t, const struct real_root *s)
{
    arb_t x, v;
    arb_init(x);
    arb_init(v);
    arb_set_arf(x, t);
    biv_value(v, c, x, s->ball, 2 * PREC_BREAK + biv_bits(c));
    int sign = arb_is_positive(v) ? 1 : arb_is_negative(v) ? -1 : 0;
    arb_clear(x);
    arb_clear(v);
    return sign;
}

/* A short fraction in (lo, hi) that solves c(t, s) = 0 exactly. */
static void recognise_end(struct real_root *r, const struct biv *c, const arf_t lo, const arf_t hi,
                          const struct real_root *s)
{
    fmpq_t a, b;
    fmpz_poly_t p;
    fmpq_init(a);
    fmpq_init(b);
    fmpz_poly_init(p);
    arf_get_fmpq(a, lo);
    arf_get_fmpq(b, hi);
    fmpq_simplest_between(a, a, b);
    biv_restrict_t(p, c, a);
    if (fmpz_bits(fmpq_denref(a)) < PREC_END / 3 && s->exact && real_root_of(s, p))
        real_root_set_exact(r, a);
    fmpq_clear(a);
    fmpq_clear(b);
    fmpz_poly_clear(p);
}

/* The only zero of t -> c(t, s) between two breaks. */
static bool solve_between(struct real_root *r, const struct biv *c, const struct real_root *from,
                          const struct real_root *to, const struct real_root *s)
{
    arf_t lo, hi, mid;
    arf_init(lo);
    arf_init(hi);
    arf_init(mid);
    arb_get_lbound_arf(lo, from->ball, PREC_BREAK);
    arb_get_ubound_arf(hi, to->ball, PREC_BREAK);
    arf_set_round(mid, arb_midref(from->ball), PREC_BREAK, ARF_RND_NEAR);
    int left = sign_on(c, mid, s), sign = left;
    for (int k = 0; k < PREC_END && sign; k++) {
        sign = 0;
        for (int part = 4; part >= 3 && sign == 0; part--) { /* the middle, or 3/8 should that be the zero */
            arf_sub(mid, hi, lo, PREC_BREAK, ARF_RND_NEAR);
            arf_mul_si(mid, mid, part, PREC_BREAK, ARF_RND_NEAR);
            arf_mul_2exp_si(mid, mid, -3);
            arf_add(mid, mid, lo, PREC_BREAK, ARF_RND_NEAR);
            sign = sign_on(c, mid, s);
        }
        if (sign)
            arf_set(sign == left ? lo : hi, mid);
    }
    arb_set_interval_arf(r->ball, lo, hi, PREC_BREAK);
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
        return solve_between(t, &k->component, &b[0]->at[piece[0]], &b[0]->at[piece[0] + 1], s);
    if (c.at[1] < 0) {
        struct biv swapped;
        biv_swap_variables(&swapped, &k->component);
        bool done = solve_between(s, &swapped, &b[1]->at[piece[1]], &b[1]->at[piece[1] + 1], t);
        biv_clear(&swapped);
        return done;
    }
    return true;
}
