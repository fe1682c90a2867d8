/* Real algebraic numbers compared: values of quotients of polynomials at real roots. */
#include "exact_algebraic.h"

#include <stdlib.h>
#include <arb_fmpz_poly.h>

void exact_value_polynomial(fmpz_poly_t v, const fmpz_poly_t p, const fmpz_poly_t num, const fmpz_poly_t den)
{
    struct biv a, b; /* in (v, t): p(t) and num(t) - v den(t) */
    int n = (int)fmpz_poly_degree(p), m = (int)fmpz_poly_degree(num);
    m = fmpz_poly_degree(den) > m ? (int)fmpz_poly_degree(den) : m;
    biv_init(&a, 0, n);
    biv_init(&b, 1, m);
    for (int j = 0; j <= n; j++)
        fmpz_poly_get_coeff_fmpz(biv_at(&a, 0, j), p, j);
    for (int j = 0; j <= m; j++) {
        fmpz_poly_get_coeff_fmpz(biv_at(&b, 0, j), num, j);
        fmpz_poly_get_coeff_fmpz(biv_at(&b, 1, j), den, j);
        fmpz_neg(biv_at(&b, 1, j), biv_at(&b, 1, j));
    }
    biv_resultant(v, &a, &b, n, NULL, 0);
    biv_clear(&a);
    biv_clear(&b);
}

int exact_compare(const arb_t a, const fmpz_poly_t va, const arb_t b, const fmpz_poly_t vb, slong prec)
{
    if (!arb_overlaps(a, b))
        return arb_lt(a, b) ? -1 : 1;
    arb_t both;
    fmpz_poly_t h, d;
    arb_init(both);
    fmpz_poly_init(h);
    fmpz_poly_init(d);
    fmpz_poly_mul(h, va, vb);
    fmpz_poly_derivative(d, h);
    fmpz_poly_gcd(d, h, d);
    fmpz_poly_div(h, h,
                  d); /* squarefree: monotone over `both`, it has one root there, and a and b are roots */
    fmpz_poly_derivative(d, h);
    arb_union(both, a, b, prec);
    arb_fmpz_poly_evaluate_arb_horner(both, d, both, prec + labs(fmpz_poly_max_bits(d)));
    int order = arb_contains_zero(both) ? 2 : 0;
    arb_clear(both);
    fmpz_poly_clear(h);
    fmpz_poly_clear(d);
    return order;
}

static void ball_of_quotient(arb_t v, const fmpz_poly_t num, const fmpz_poly_t den, const arb_t t, slong prec)
{
    arb_t d;
    arb_init(d);
    arb_fmpz_poly_evaluate_arb_horner(v, num, t, prec);
    arb_fmpz_poly_evaluate_arb_horner(d, den, t, prec);
    arb_div(v, v, d, prec);
    arb_clear(d);
}

int exact_compare_quotients(const struct real_root *t, const fmpz_poly_t x, const fmpz_poly_t w,
                            const struct real_root *s, const fmpz_poly_t u, const fmpz_poly_t v, slong prec)
{
    arb_t a, b;
    fmpz_poly_t va, vb;
    arb_init(a);
    arb_init(b);
    fmpz_poly_init(va);
    fmpz_poly_init(vb);
    slong work = prec + 64 + labs(fmpz_poly_max_bits(x)) + labs(fmpz_poly_max_bits(u));
    ball_of_quotient(a, x, w, t->ball, work);
    ball_of_quotient(b, u, v, s->ball, work);
    exact_value_polynomial(va, t->p, x, w);
    exact_value_polynomial(vb, s->p, u, v);
    int order = exact_compare(a, va, b, vb, prec);
    arb_clear(a);
    arb_clear(b);
    fmpz_poly_clear(va);
    fmpz_poly_clear(vb);
    return order;
}
