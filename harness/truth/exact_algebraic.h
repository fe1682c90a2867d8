/* Real algebraic numbers compared. */
#ifndef FATLINE_EXACT_ALGEBRAIC_H
#define FATLINE_EXACT_ALGEBRAIC_H

#include "exact_roots.h"

/* -1, 0, 1: how a and b compare, where a is the value num / den at a root of pa and b likewise; 2: the
 * precision is too low.  va, vb: polynomials that vanish at a and b. */
int exact_compare(const arb_t a, const fmpz_poly_t va, const arb_t b, const fmpz_poly_t vb, slong prec);
/* A polynomial that vanishes at num / den wherever p vanishes (den is not 0 there). */
void exact_value_polynomial(fmpz_poly_t v, const fmpz_poly_t p, const fmpz_poly_t num, const fmpz_poly_t den);
/* As exact_compare, of x / w at t and u / v at s. */
int exact_compare_quotients(const struct real_root *t, const fmpz_poly_t x, const fmpz_poly_t w,
                            const struct real_root *s, const fmpz_poly_t u, const fmpz_poly_t v, slong prec);

#endif
