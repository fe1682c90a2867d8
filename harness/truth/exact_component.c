/* The common component of two parts of one curve, and the functions phi and psi whose difference it is. */
#include "exact_arcs.h"

#include <stdlib.h>
#include <flint/fmpz_mpoly.h>

static void to_mpoly(fmpz_mpoly_t to, const struct biv *p, const fmpz_mpoly_ctx_t ctx)
{
    fmpz_mpoly_zero(to, ctx);
    for (int i = 0; i <= p->n; i++)
        for (int j = 0; j <= p->m; j++)
            if (!fmpz_is_zero(biv_at(p, i, j))) {
                ulong power[2] = {(ulong)i, (ulong)j};
                fmpz_mpoly_set_coeff_fmpz_ui(to, biv_at(p, i, j), power, ctx);
            }
}

static void from_mpoly(struct biv *to, const fmpz_mpoly_t p, const fmpz_mpoly_ctx_t ctx)
{
    slong n = fmpz_mpoly_degree_si(p, 0, ctx), m = fmpz_mpoly_degree_si(p, 1, ctx);
    biv_init(to, n > 0 ? (int)n : 0, m > 0 ? (int)m : 0);
    for (int i = 0; i <= to->n; i++)
        for (int j = 0; j <= to->m; j++) {
            ulong power[2] = {(ulong)i, (ulong)j};
            fmpz_mpoly_get_coeff_fmpz_ui(biv_at(to, i, j), p, power, ctx);
        }
}

/* gcd(p, q), p / gcd, q / gcd; all initialised here. */
bool arcs_split_component(struct biv *common, struct biv *p1, struct biv *q1, const struct biv *p,
                          const struct biv *q)
{
    fmpz_mpoly_ctx_t ctx;
    fmpz_mpoly_t a, b, g;
    fmpz_mpoly_ctx_init(ctx, 2, ORD_LEX);
    fmpz_mpoly_init(a, ctx);
    fmpz_mpoly_init(b, ctx);
    fmpz_mpoly_init(g, ctx);
    to_mpoly(a, p, ctx);
    to_mpoly(b, q, ctx);
    bool done =
        fmpz_mpoly_gcd(g, a, b, ctx) && fmpz_mpoly_divides(a, a, g, ctx) && fmpz_mpoly_divides(b, b, g, ctx);
    from_mpoly(common, g, ctx);
    from_mpoly(p1, a, ctx);
    from_mpoly(q1, b, ctx);
    fmpz_mpoly_clear(a, ctx);
    fmpz_mpoly_clear(b, ctx);
    fmpz_mpoly_clear(g, ctx);
    fmpz_mpoly_ctx_clear(ctx);
    return done;
}

/* ---- phi and psi ---- */

static void set_slope(struct side *d)
{
    fmpz_poly_t a, b;
    fmpz_poly_init(a);
    fmpz_poly_init(b);
    fmpz_poly_derivative(a, d->num);
    fmpz_poly_mul(a, a, d->den);
    fmpz_poly_derivative(b, d->den);
    fmpz_poly_mul(b, b, d->num);
    fmpz_poly_sub(d->slope, a, b);
    fmpz_poly_clear(a);
    fmpz_poly_clear(b);
}

/* Is the value finite at 0, at 1 and at every turning point? */
static bool poles_are_regular(const struct side *d)
{
    fmpz_poly_t g;
    fmpz_t v;
    fmpz_poly_init(g);
    fmpz_init(v);
    fmpz_poly_gcd(g, d->den, d->slope);
    bool regular = !fmpz_poly_is_zero(d->slope) && fmpz_poly_degree(g) == 0;
    fmpz_set_si(v, 1);
    fmpz_poly_evaluate_fmpz(v, d->den, v);
    regular = regular && !fmpz_is_zero(v);
    fmpz_poly_get_coeff_fmpz(v, d->den, 0);
    regular = regular && !fmpz_is_zero(v);
    fmpz_poly_clear(g);
    fmpz_clear(v);
    return regular;
}

/* phi = C(t, a) / C(t, b) up to a Moebius map, and psi by the same map from C = phi_num psi_den - phi_den
 * psi_num. */
static bool choose_values(struct arcs *k, const struct biv *swapped, int a, int b)
{
    struct side *t = &k->side[0], *s = &k->side[1];
    fmpz_poly_t c1, c2, u;
    fmpz_t a1, b1, a2, b2;
    fmpq_t x;
    fmpz_poly_init(c1);
    fmpz_poly_init(c2);
    fmpz_poly_init(u);
    fmpz_init(a1), fmpz_init(b1), fmpz_init(a2), fmpz_init(b2);
    fmpq_init(x);
    fmpq_set_si(x, a, 1);
    biv_restrict_t(t->num, swapped, x);
    fmpq_set_si(x, b, 1);
    biv_restrict_t(t->den, swapped, x);
    const int place[2] = {a + 1, -2 * a};
    for (int i = 0; i < 2; i++) {
        fmpq_set_si(x, place[i], 1);
        biv_restrict_t(i ? c2 : c1, &k->component, x);
        fmpz_poly_evaluate_fmpz(i ? a2 : a1, t->num, fmpq_numref(x));
        fmpz_poly_evaluate_fmpz(i ? b2 : b1, t->den, fmpq_numref(x));
    }
    fmpz_poly_scalar_mul_fmpz(s->den, c1, b2);
    fmpz_poly_scalar_mul_fmpz(u, c2, b1);
    fmpz_poly_sub(s->den, s->den, u);
    fmpz_poly_scalar_mul_fmpz(s->num, c1, a2);
    fmpz_poly_scalar_mul_fmpz(u, c2, a1);
    fmpz_poly_sub(s->num, s->num, u);
    set_slope(t);
    set_slope(s);
    fmpz_poly_clear(c1);
    fmpz_poly_clear(c2);
    fmpz_poly_clear(u);
    fmpz_clear(a1), fmpz_clear(b1), fmpz_clear(a2), fmpz_clear(b2);
    fmpq_clear(x);
    return poles_are_regular(t) && poles_are_regular(s);
}

bool arcs_choose_values(struct arcs *k)
{
    struct biv swapped;
    bool chosen = false;
    biv_swap_variables(&swapped, &k->component);
    for (int b = 2; b < 40 && !chosen; b++)
        for (int sign = -1; sign <= 1 && !chosen; sign += 2)
            chosen = choose_values(k, &swapped, sign * b + 1, sign * b);
    biv_clear(&swapped);
    return chosen;
}

static int by_ball(const void *a, const void *b)
{
    const struct real_root *x = a, *y = b;
    return arf_cmp(arb_midref(x->ball), arb_midref(y->ball));
}

/* Breaks: 0, 1, the zeros of the slope and of the denominator between. */
void arcs_find_pieces(struct side *d)
{
    fmpz_poly_t p, ends;
    fmpq_t mid, other;
    arf_t m;
    fmpz_poly_init(p);
    fmpz_poly_init(ends);
    fmpq_init(mid);
    fmpq_init(other);
    arf_init(m);
    fmpz_poly_set_coeff_si(ends, 1, -1); /* t^2 - t */
    fmpz_poly_set_coeff_si(ends, 2, 1);
    fmpz_poly_mul(p, d->slope, d->den);
    fmpz_poly_mul(p, p, ends);
    root_list_find(&d->breaks, p);
    for (int i = 0; i < d->breaks.count; i++)
        real_root_refine(&d->breaks.at[i], PREC_BREAK, false);
    qsort(d->breaks.at, (size_t)d->breaks.count, sizeof *d->breaks.at, by_ball);
    d->rising = calloc((size_t)d->breaks.count, sizeof *d->rising);
    for (int i = 0; i + 1 < d->breaks.count; i++) {
        arf_add(m, arb_midref(d->breaks.at[i].ball), arb_midref(d->breaks.at[i + 1].ball), PREC_BREAK,
                ARF_RND_NEAR);
        arf_mul_2exp_si(m, m, -1);
        arf_get_fmpq(mid, m);
        fmpz_poly_evaluate_fmpq(other, d->slope, mid);
        d->rising[i] = fmpq_sgn(other) > 0;
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(ends);
    fmpq_clear(mid);
    fmpq_clear(other);
    arf_clear(m);
}
