#include "referee_pair.h"

#include <math.h>
#include <quadmath.h>
#include <stdint.h>

#include "../cases/case_fields.h"
#include "../cases/number.h"

/* ---- scaling ------------------------------------------------------------------------------------------ */

/* e with |q| <= 2^e. */
static long exponent_above(const mpq_t q)
{
    return (long)mpz_sizeinbase(mpq_numref(q), 2) - (long)mpz_sizeinbase(mpq_denref(q), 2) + 1;
}

static void scale(mpq_t q, long e)
{
    if (e >= 0)
        mpq_mul_2exp(q, q, (mp_bitcnt_t)e);
    else
        mpq_div_2exp(q, q, (mp_bitcnt_t)-e);
}

static long largest_exponent(const mpq_t *q, int count, long most)
{
    for (int i = 0; i < count; i++)
        if (mpq_sgn(q[i]) && exponent_above(q[i]) > most)
            most = exponent_above(q[i]);
    return most;
}

static double largest_coordinate(const struct case_curve *c, double most)
{
    for (int i = 0; i <= c->degree; i++)
        most = fmax(most, fmax(fabs(number_to_double(c->x[i])), fabs(number_to_double(c->y[i]))));
    return most;
}

/* Euclidean coordinates into x and y, moved. */
static void translate(const struct case_curve *c, const struct case_curve *origin, struct referee_curve *e)
{
    int length = c->degree + 1;
    e->degree = c->degree;
    e->at = rationals_new(3 * length);
    for (int i = 0; i < length; i++) {
        mpq_sub(e->at[i], c->x[i], origin->x[0]);
        mpq_sub(e->at[length + i], c->y[i], origin->y[0]);
        mpq_set_ui(e->at[2 * length + i], 1, 1);
    }
}

/* Scaled by 2^-most; weights by a power of two of their own, then multiplied in. */
static void homogenise(const struct case_curve *c, long most, struct referee_curve *e)
{
    int length = c->degree + 1;
    long heavy = c->rational ? largest_exponent((const mpq_t *)c->w, length, -1000000) : 0;
    for (int i = 0; i < length; i++) {
        scale(e->at[i], -most);
        scale(e->at[length + i], -most);
        if (!c->rational)
            continue;
        mpq_set(e->at[2 * length + i], c->w[i]);
        scale(e->at[2 * length + i], -heavy);
        mpq_mul(e->at[i], e->at[i], e->at[2 * length + i]);
        mpq_mul(e->at[length + i], e->at[length + i], e->at[2 * length + i]);
    }
}

void referee_pair_make(const struct test_case *c, struct referee_pair *p)
{
    p->rational = c->f.rational || c->g.rational;
    translate(&c->f, &c->f, &p->f);
    translate(&c->g, &c->f, &p->g);
    long most = largest_exponent((const mpq_t *)p->f.at, 2 * (c->f.degree + 1), -1000000);
    most = largest_exponent((const mpq_t *)p->g.at, 2 * (c->g.degree + 1), most);
    if (most == -1000000) /* all one point */
        most = 0;
    homogenise(&c->f, most, &p->f);
    homogenise(&c->g, most, &p->g);
    p->size = largest_coordinate(&c->g, largest_coordinate(&c->f, 0));
    p->unit = ldexp(1, (int)most);
}

void referee_pair_clear(struct referee_pair *p)
{
    rationals_free(p->f.at, 3 * (p->f.degree + 1));
    rationals_free(p->g.at, 3 * (p->g.degree + 1));
}

/* ---- rationals and binary128 -------------------------------------------------------------------------- */

/* Within 2^-112 |a| of a; exact if a has at most 113 bits.  128 bits of the quotient are cut off and rounded.
 */
static quad to_quad(const mpq_t a, mpz_t z)
{
    if (!mpq_sgn(a))
        return 0;
    long shift = 127 - ((long)mpz_sizeinbase(mpq_numref(a), 2) - (long)mpz_sizeinbase(mpq_denref(a), 2));
    if (shift >= 0)
        mpz_mul_2exp(z, mpq_numref(a), (mp_bitcnt_t)shift);
    else
        mpz_tdiv_q_2exp(z, mpq_numref(a), (mp_bitcnt_t)-shift);
    mpz_tdiv_q(z, z, mpq_denref(a));
    uint64_t limb[3] = {0, 0, 0}; /* below 2^129 */
    mpz_export(limb, NULL, -1, 8, 0, 0, z);
    quad q = (((quad)limb[2] * 0x1p64Q) + limb[1]) * 0x1p64Q + limb[0];
    return ldexpq(mpq_sgn(a) < 0 ? -q : q, (int)-shift);
}

void rational_from_quad(mpq_t a, quad q)
{
    int e;
    quad m = ldexpq(frexpq(fabsq(q), &e), 113);
    uint64_t high = (uint64_t)(m * 0x1p-64Q), low = (uint64_t)(m - (quad)high * 0x1p64Q);
    uint64_t limb[2] = {low, high};
    mpz_import(mpq_numref(a), 2, -1, 8, 0, 0, limb);
    mpz_set_ui(mpq_denref(a), 1);
    if (q < 0)
        mpq_neg(a, a);
    scale(a, q == 0 ? 0 : e - 113);
}

static void round_curve(const struct referee_curve *e, struct quad_curve *c)
{
    int length = e->degree + 1;
    mpz_t z;
    mpz_init(z);
    c->degree = e->degree;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < length; i++)
            c->at[k][i] = to_quad(e->at[k * length + i], z);
    mpz_clear(z);
}

void referee_pair_round(const struct referee_pair *p, struct quad_pair *q)
{
    q->rational = p->rational;
    round_curve(&p->f, &q->f);
    round_curve(&p->g, &q->g);
}
