/* Real roots of integer polynomials: exact or in isolating intervals, refined as far as asked. */
#ifndef FATLINE_EXACT_ROOTS_H
#define FATLINE_EXACT_ROOTS_H

#include "exact_poly.h"

/* One real root.  Either `exact` and it is `value`, or it is the only root of the squarefree p in the open
 * interval (lo, hi), at whose ends p has opposite signs.  The ball holds it always. */
struct real_root {
    bool exact;
    fmpq_t value, lo, hi;
    fmpz_poly_t p;
    int multiplicity; /* in the polynomial it came from */
    arb_t ball;
};

int polynomial_sign(const fmpz_poly_t p, const fmpq_t x); /* of p(x), exact */

void real_root_init(struct real_root *r);
void real_root_clear(struct real_root *r);
void real_root_set(struct real_root *to, const struct real_root *from);
void real_root_set_exact(struct real_root *r, const fmpq_t value);
/* Ball within radius 2^-prec (and 2^-prec |root| when `relative`); a short rational root is recognised. */
void real_root_refine(struct real_root *r, slong prec, bool relative);
/* Does q vanish there?  Decided exactly. */
bool real_root_of(const struct real_root *r, const fmpz_poly_t q);
/* Multiplicity of the root in q, 0 if q does not vanish there; decided exactly. */
int real_root_order(const struct real_root *r, const fmpz_poly_t q);

struct root_list {
    int count;
    struct real_root *at;
};

/* The distinct real roots of p (not 0) in the closed interval [0, 1] with their multiplicities, ascending
 * within each squarefree factor.  By Descartes' rule and bisection (Collins and Akritas 1976). */
void root_list_find(struct root_list *l, const fmpz_poly_t p);
void root_list_clear(struct root_list *l);

#endif
