/* Isolating intervals of real roots: Descartes' rule of signs and bisection (Collins and Akritas 1976). */
#include "exact_roots.h"

#include <stdlib.h>
#include <flint/fmpz_poly_factor.h>

static struct real_root *append(struct root_list *l, const fmpz_poly_t p, int multiplicity)
{
    l->at = realloc(l->at, (size_t)(l->count + 1) * sizeof *l->at);
    struct real_root *r = &l->at[l->count++];
    real_root_init(r);
    fmpz_poly_set(r->p, p);
    r->multiplicity = multiplicity;
    return r;
}

static void drop(struct root_list *l, int count)
{
    while (l->count > count)
        real_root_clear(&l->at[--l->count]);
}

/* Sign changes of (1 + x)^d p(1 / (1 + x)): at least the number of roots in (0, 1), equal if it is 0 or 1. */
static int descartes(const fmpz_poly_t p)
{
    fmpz_poly_t q;
    fmpz_poly_init(q);
    fmpz_poly_reverse(q, p, p->length);
    fmpz_poly_taylor_shift(q, q, &(fmpz){1});
    int changes = 0, last = 0;
    for (slong i = 0; i < q->length && changes < 2; i++) {
        int sign = fmpz_sgn(q->coeffs + i);
        changes += sign * last < 0;
        last = sign ? sign : last;
    }
    fmpz_poly_clear(q);
    return changes;
}

static void set_dyadic(fmpq_t x, const fmpz_t c, ulong k)
{
    fmpz_one(fmpq_denref(x));
    fmpz_mul_2exp(fmpq_denref(x), fmpq_denref(x), k);
    fmpz_set(fmpq_numref(x), c);
    fmpq_canonicalise(x);
}

/* p(x) over ((c, c + 1) / 2^k) is `node` over (0, 1).  Appends the isolating intervals below; a root at a
 * middle stops everything and is left in `middle`: true. */
static bool isolate(struct root_list *l, const fmpz_poly_t p, int multiplicity, const fmpz_poly_t node,
                    const fmpz_t c, ulong k, fmpq_t middle)
{
    int changes = descartes(node);
    if (changes == 0)
        return false;
    fmpz_t e;
    fmpz_init(e);
    if (changes == 1) {
        struct real_root *r = append(l, p, multiplicity);
        set_dyadic(r->lo, c, k);
        fmpz_add_ui(e, c, 1);
        set_dyadic(r->hi, e, k);
        fmpz_add(e, c, e); /* (2 c + 1) / 2^(k + 1), give or take 1 / 2^(k + 1) */
        arb_set_fmpz(r->ball, e);
        arb_mul_2exp_si(r->ball, r->ball, -(slong)k - 1);
        arb_add_error_2exp_si(r->ball, -(slong)k - 1);
        fmpz_clear(e);
        return false;
    }
    fmpz_poly_t half;
    fmpz_poly_init(half);
    fmpz_poly_set(half, node);
    for (slong i = 0; i < half->length; i++)
        fmpz_mul_2exp(half->coeffs + i, half->coeffs + i, (ulong)(half->length - 1 - i));
    fmpz_mul_2exp(e, c, 1);
    bool stopped = isolate(l, p, multiplicity, half, e, k + 1, middle);
    fmpz_poly_taylor_shift(half, half, &(fmpz){1});
    fmpz_add_ui(e, e, 1);
    if (!stopped && fmpz_is_zero(half->coeffs)) {
        set_dyadic(middle, e, k + 1);
        stopped = true;
    }
    stopped = stopped || isolate(l, p, multiplicity, half, e, k + 1, middle);
    fmpz_poly_clear(half);
    fmpz_clear(e);
    return stopped;
}

/* Divides p by its rational root x and appends x. */
static void take_exact(struct root_list *l, fmpz_poly_t p, const fmpq_t x, int multiplicity)
{
    real_root_set_exact(append(l, p, multiplicity), x);
    fmpz_poly_t linear;
    fmpz_poly_init(linear);
    fmpz_poly_set_coeff_fmpz(linear, 1, fmpq_denref(x));
    fmpz_poly_set_coeff_fmpz(linear, 0, fmpq_numref(x));
    fmpz_neg(linear->coeffs, linear->coeffs);
    fmpz_poly_div(p, p, linear);
    fmpz_poly_clear(linear);
}

/* All roots in [0, 1] of the squarefree p. */
static void find_simple(struct root_list *l, fmpz_poly_t p, int multiplicity)
{
    fmpq_t x;
    fmpz_t zero;
    fmpq_init(x);
    fmpz_init(zero);
    for (int end = 0; end <= 1; end++) {
        fmpq_set_si(x, end, 1);
        if (fmpz_poly_degree(p) > 0 && polynomial_sign(p, x) == 0)
            take_exact(l, p, x, multiplicity);
    }
    int before = l->count;
    while (fmpz_poly_degree(p) > 0 && isolate(l, p, multiplicity, p, zero, 0, x)) {
        drop(l, before);
        take_exact(l, p, x, multiplicity);
        before = l->count;
    }
    fmpq_clear(x);
    fmpz_clear(zero);
}

void root_list_find(struct root_list *l, const fmpz_poly_t p)
{
    fmpz_poly_factor_t parts;
    l->count = 0;
    l->at = NULL;
    fmpz_poly_factor_init(parts);
    fmpz_poly_factor_squarefree(parts, p);
    for (slong k = 0; k < parts->num; k++)
        find_simple(l, parts->p + k, (int)parts->exp[k]);
    fmpz_poly_factor_clear(parts);
}

void root_list_clear(struct root_list *l)
{
    drop(l, 0);
    free(l->at);
    l->at = NULL;
}
