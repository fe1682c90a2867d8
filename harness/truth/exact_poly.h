/* Integer polynomials in one and two variables for the exact truth. */
#ifndef FATLINE_EXACT_POLY_H
#define FATLINE_EXACT_POLY_H

#include <gmp.h>
#include <stdbool.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpq.h>
#include <arb.h>

/* sum c[i (m + 1) + j] t^i s^j, i = 0..n, j = 0..m; n and m are formal degrees. */
struct biv {
    int n, m;
    fmpz *c;
};

void biv_init(struct biv *p, int n, int m); /* the zero polynomial */
void biv_clear(struct biv *p);
static inline fmpz *biv_at(const struct biv *p, int i, int j)
{
    return p->c + i * (p->m + 1) + j;
}
bool biv_is_zero(const struct biv *p);
/* p(t, s) = a(t) b(s) - c(t) d(s), divided by its content. */
void biv_set_cross(struct biv *p, const fmpz_poly_t a, const fmpz_poly_t b, const fmpz_poly_t c,
                   const fmpz_poly_t d);
void biv_make_primitive(struct biv *p);
void biv_trim(struct biv *p);                                    /* formal degrees down to the true ones */
void biv_swap_variables(struct biv *to, const struct biv *from); /* to is initialised here */
/* to(u, s) = from(u - lambda s, s), with true degrees; to is initialised here. */
void biv_shear(struct biv *to, const struct biv *from, int lambda);
void biv_derive_t(struct biv *to, const struct biv *from); /* to is initialised here */
void biv_derive_s(struct biv *to, const struct biv *from);
/* The polynomial s -> from(t, s) times a positive integer. */
void biv_restrict_t(fmpz_poly_t to, const struct biv *from, const fmpq_t t);
void biv_value(arb_t value, const struct biv *p, const arb_t t, const arb_t s, slong prec);
/* Coefficients of s -> p(t, s), m + 1 of them. */
void biv_coefficients(arb_ptr to, const struct biv *p, const arb_t t, slong prec);
slong biv_bits(const struct biv *p); /* of the largest coefficient */

/* Resultant of p and q as polynomials in s of formal degrees p->m and q->m (so a common zero at s = infinity
 * counts), divided by w^(p->m) when w is not NULL; the quotient is known to be a polynomial of degree at most
 * `degree`.  Evaluation and interpolation modulo as many primes as the bound of the coefficients asks for:
 * a determinant of polynomials is at most the product of its rows' sums of absolute coefficients, and a
 * factor of degree d at most 2^d times that (Mignotte).  False when the processor time passes `deadline` (0:
 * none). */
bool biv_resultant(fmpz_poly_t r, const struct biv *p, const struct biv *q, int degree,
                   const fmpz_poly_struct *w, double deadline);

double exact_clock(void); /* processor time in seconds */

#endif
