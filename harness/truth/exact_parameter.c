/* From a root on [0, 1] to the curve's own parameter, rounded. */
#include "exact_parameter.h"

#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"

enum { PREC_FIRST = 192, PREC_LAST = 1 << 14 };

/* ball of lo + (hi - lo) r. */
static void to_domain(arb_t v, const struct real_root *r, const struct case_curve *c, slong prec)
{
    fmpq_t lo, length;
    arb_t a;
    arb_init(a);
    fmpq_init(lo);
    fmpq_init(length);
    fmpq_set_mpq(lo, c->lo);
    fmpq_set_mpq(length, c->hi);
    fmpq_sub(length, length, lo);
    arb_set_fmpq(a, length, prec);
    arb_mul(v, r->ball, a, prec);
    arb_set_fmpq(a, lo, prec);
    arb_add(v, v, a, prec);
    fmpq_clear(lo);
    fmpq_clear(length);
    arb_clear(a);
}

static void exact_parameter(struct parameter *p, const struct real_root *r, const struct case_curve *c)
{
    mpq_t length;
    mpq_init(length);
    fmpq_get_mpq(p->q, r->value);
    mpq_sub(length, c->hi, c->lo);
    mpq_mul(p->q, p->q, length);
    mpq_add(p->q, p->q, c->lo);
    mpq_clear(length);
    p->text = mpq_get_str(NULL, 10, p->q);
    p->nearest = number_to_double(p->q);
}

slong parameter_bits(int digits)
{
    return (slong)(3.33 * digits) + 8;
}

bool parameter_set(struct parameter *p, struct real_root *r, const struct case_curve *c, int digits,
                   bool refine)
{
    mpq_init(p->q);
    p->text = NULL;
    arb_t v;
    arf_t lo, hi;
    arb_init(v);
    arf_init(lo);
    arf_init(hi);
    bool done = false;
    slong wanted = parameter_bits(digits);
    for (slong prec = PREC_FIRST; prec <= PREC_LAST && !done && !r->exact; prec *= 2) {
        if (refine)
            real_root_refine(r, wanted + prec, false);
        to_domain(v, r, c, 2 * (wanted + prec));
        arb_get_lbound_arf(lo, v, wanted + prec);
        arb_get_ubound_arf(hi, v, wanted + prec);
        p->nearest = arf_get_d(lo, ARF_RND_NEAR);
        done = arb_rel_accuracy_bits(v) >= wanted && p->nearest == arf_get_d(hi, ARF_RND_NEAR);
    }
    p->exact = r->exact;
    if (r->exact) {
        exact_parameter(p, r, c);
        done = true;
    } else {
        char *text = arb_get_str(v, digits, ARB_STR_NO_RADIUS);
        p->text = strdup(text);
        flint_free(text);
        done = done && number_parse(p->text, p->q);
    }
    arb_clear(v);
    arf_clear(lo);
    arf_clear(hi);
    return done;
}

void parameter_clear(struct parameter *p)
{
    mpq_clear(p->q);
    free(p->text);
}
