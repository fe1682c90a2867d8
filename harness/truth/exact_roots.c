/* Real roots of integer polynomials refined by bisection and interval Newton steps. */
#include "exact_roots.h"

#include <stdlib.h>
#include <flint/fmpz_poly_factor.h>
#include <arb_fmpz_poly.h>

enum {
    RATIONAL_BITS = 40, /* longest denominator looked for in a root */
    RATIONAL_PREC = 100 /* radius 2^-100: two fractions that short lie further apart */
};

void real_root_init(struct real_root *r)
{
    r->exact = false;
    r->multiplicity = 0;
    fmpq_init(r->value);
    fmpq_init(r->lo);
    fmpq_init(r->hi);
    fmpz_poly_init(r->p);
    arb_init(r->ball);
}

void real_root_clear(struct real_root *r)
{
    fmpq_clear(r->value);
    fmpq_clear(r->lo);
    fmpq_clear(r->hi);
    fmpz_poly_clear(r->p);
    arb_clear(r->ball);
}

void real_root_set(struct real_root *to, const struct real_root *from)
{
    to->exact = from->exact;
    to->multiplicity = from->multiplicity;
    fmpq_set(to->value, from->value);
    fmpq_set(to->lo, from->lo);
    fmpq_set(to->hi, from->hi);
    fmpz_poly_set(to->p, from->p);
    arb_set(to->ball, from->ball);
}

void real_root_set_exact(struct real_root *r, const fmpq_t value)
{
    r->exact = true;
    fmpq_set(r->value, value);
    arb_set_fmpq(r->ball, value, RATIONAL_PREC);
}

/* By balls of growing precision, and where these hold 0 for long by exact evaluation. */
int polynomial_sign(const fmpz_poly_t p, const fmpq_t x)
{
    arb_t b, v;
    int sign = 0;
    slong limit = 2 * labs(fmpz_poly_max_bits(p)) + 64 * fmpz_poly_length(p);
    arb_init(b);
    arb_init(v);
    for (slong prec = 128; prec < limit && sign == 0; prec *= 2) {
        arb_set_fmpq(b, x, prec);
        arb_fmpz_poly_evaluate_arb_horner(v, p, b, prec);
        sign = arb_is_positive(v) ? 1 : arb_is_negative(v) ? -1 : 0;
    }
    if (sign == 0) {
        fmpq_t y;
        fmpq_init(y);
        fmpz_poly_evaluate_fmpq(y, p, x);
        sign = fmpq_sgn(y);
        fmpq_clear(y);
    }
    arb_clear(b);
    arb_clear(v);
    return sign;
}

/* A fraction of few digits inside the ball that is a root is the root. */
static void recognise(struct real_root *r)
{
    fmpq_t a, b;
    arf_t lo, hi;
    fmpq_init(a);
    fmpq_init(b);
    arf_init(lo);
    arf_init(hi);
    arb_get_lbound_arf(lo, r->ball, ARF_PREC_EXACT);
    arb_get_ubound_arf(hi, r->ball, ARF_PREC_EXACT);
    arf_get_fmpq(a, lo);
    arf_get_fmpq(b, hi);
    fmpq_simplest_between(a, a, b);
    if (fmpz_bits(fmpq_denref(a)) <= RATIONAL_BITS && polynomial_sign(r->p, a) == 0)
        real_root_set_exact(r, a);
    fmpq_clear(a);
    fmpq_clear(b);
    arf_clear(lo);
    arf_clear(hi);
}

static bool is_within(const struct real_root *r, slong prec, bool relative)
{
    arf_t bound, radius;
    arf_init(bound);
    arf_init(radius);
    arf_set_mag(radius, arb_radref(r->ball));
    arf_one(bound);
    if (relative)
        arb_get_abs_lbound_arf(bound, r->ball, 30);
    if (arf_cmp_si(bound, 1) > 0)
        arf_one(bound);
    arf_mul_2exp_si(bound, bound, -prec);
    bool within = arf_cmp(radius, bound) <= 0;
    arf_clear(bound);
    arf_clear(radius);
    return within;
}

/* Halves the interval (lo, hi) by the exact sign at its middle. */
static void bisect(struct real_root *r, slong prec)
{
    fmpq_t mid;
    fmpq_init(mid);
    fmpq_add(mid, r->lo, r->hi);
    fmpq_div_2exp(mid, mid, 1);
    int sign = polynomial_sign(r->p, mid);
    if (sign == 0)
        real_root_set_exact(r, mid);
    else if (sign == polynomial_sign(r->p, r->lo))
        fmpq_set(r->lo, mid);
    else
        fmpq_set(r->hi, mid);
    if (!r->exact) {
        arb_t hi;
        arb_init(hi);
        arb_set_fmpq(r->ball, r->lo, prec);
        arb_set_fmpq(hi, r->hi, prec);
        arb_union(r->ball, r->ball, hi, prec);
        arb_clear(hi);
    }
    fmpq_clear(mid);
}

/* One interval Newton step; false if it gained less than one bit in two. */
static bool newton(struct real_root *r, const fmpz_poly_t derivative, slong prec)
{
    arb_t mid, step, slope;
    mag_t before;
    arb_init(mid);
    arb_init(step);
    arb_init(slope);
    mag_init_set(before, arb_radref(r->ball));
    arb_fmpz_poly_evaluate_arb_horner(slope, derivative, r->ball, prec);
    bool gained = !arb_contains_zero(slope);
    if (gained) {
        arb_get_mid_arb(mid, r->ball);
        arb_fmpz_poly_evaluate_arb_horner(step, r->p, mid, prec);
        arb_div(step, step, slope, prec);
        arb_sub(mid, mid, step, prec);
        arb_intersection(r->ball, r->ball, mid, prec);
        mag_mul_2exp_si(before, before, -1);
        gained = mag_cmp(arb_radref(r->ball), before) < 0;
    }
    arb_clear(mid);
    arb_clear(step);
    arb_clear(slope);
    mag_clear(before);
    return gained;
}

void real_root_refine(struct real_root *r, slong prec, bool relative)
{
    slong work = prec + 64 + labs(fmpz_poly_max_bits(r->p)) + fmpz_poly_length(r->p);
    if (r->exact) {
        arb_set_fmpq(r->ball, r->value, work);
        return;
    }
    fmpz_poly_t derivative;
    fmpz_poly_init(derivative);
    fmpz_poly_derivative(derivative, r->p);
    bool by_newton = true;
    while (!r->exact && !is_within(r, prec, relative)) {
        by_newton = by_newton && newton(r, derivative, work);
        if (!by_newton) {
            bisect(r, work);
            by_newton = !r->exact && newton(r, derivative, work);
        }
        work += 8; /* roundings never stop the progress for good */
    }
    if (!r->exact && prec >= RATIONAL_PREC)
        recognise(r);
    if (r->exact)
        arb_set_fmpq(r->ball, r->value, work);
    fmpz_poly_clear(derivative);
}

bool real_root_of(const struct real_root *r, const fmpz_poly_t q)
{
    if (fmpz_poly_is_zero(q) || r->exact)
        return fmpz_poly_is_zero(q) || polynomial_sign(q, r->value) == 0;
    fmpz_poly_t g;
    fmpz_poly_init(g);
    fmpz_poly_gcd(g, q, r->p); /* a factor of p: at most one root in (lo, hi), none at the ends */
    bool is = fmpz_poly_degree(g) > 0 && polynomial_sign(g, r->lo) != polynomial_sign(g, r->hi);
    fmpz_poly_clear(g);
    return is;
}

int real_root_order(const struct real_root *r, const fmpz_poly_t q)
{
    int order = 0;
    fmpz_poly_t d;
    fmpz_poly_init(d);
    fmpz_poly_set(d, q);
    while (!fmpz_poly_is_zero(d) && real_root_of(r, d)) {
        order++;
        fmpz_poly_derivative(d, d);
    }
    fmpz_poly_clear(d);
    return order;
}
