/* What is planted in a draft, its scale, and what can be proved of it. */
#include <stdlib.h>

#include "draft.h"

void draft_plant(struct draft *d, const fmpq_t t, const fmpq_t s, int multiplicity)
{
    struct planted *a = &d->at[d->planted++];
    fmpq_set(a->t, t);
    fmpq_set(a->s, s);
    a->multiplicity = multiplicity;
}

static void one_minus(fmpq_t a)
{
    fmpq_sub_si(a, a, 1);
    fmpq_neg(a, a);
}

void draft_reverse_g(struct draft *d)
{
    points_reverse(&d->g);
    for (int i = 0; i < d->planted; i++)
        one_minus(d->at[i].s);
    one_minus(d->overlap[2]);
    one_minus(d->overlap[3]);
}

void draft_join(struct draft *d, const fmpq_t t, const fmpq_t s)
{
    fmpq_t x, y, u, v;
    fmpq_init(x);
    fmpq_init(y);
    fmpq_init(u);
    fmpq_init(v);
    points_value(x, y, &d->f, t);
    points_value(u, v, &d->g, s);
    fmpq_sub(x, x, u);
    fmpq_sub(y, y, v);
    points_move(&d->g, x, y);
    fmpq_clear(x);
    fmpq_clear(y);
    fmpq_clear(u);
    fmpq_clear(v);
}

/* A multiple of the odd part of every denominator, and of nothing else. */
static void odd_denominator(fmpz_t l, fmpq_t *c, int n)
{
    fmpz_t odd;
    fmpz_init(odd);
    for (int i = 0; i <= n; i++) {
        fmpz_tdiv_q_2exp(odd, fmpq_denref(c[i]), fmpz_val2(fmpq_denref(c[i])));
        fmpz_lcm(l, l, odd);
    }
    fmpz_clear(odd);
}

/* e with 2^(e-1) <= max |c[i]| < 2^e, or the given e if that is larger. */
static slong exponent_max(slong e, fmpq_t *c, int n)
{
    for (int i = 0; i <= n; i++) {
        slong own = (slong)fmpz_bits(fmpq_numref(c[i])) - (slong)fmpz_bits(fmpq_denref(c[i])) + 1;
        if (!fmpq_is_zero(c[i]) && own > e)
            e = own; /* exact: the denominators are powers of two */
    }
    return e;
}

static void multiply(fmpq_t *c, int n, const fmpz_t l, slong e)
{
    for (int i = 0; i <= n; i++) {
        fmpq_mul_fmpz(c[i], c[i], l);
        if (e > 0)
            fmpq_div_2exp(c[i], c[i], (flint_bitcnt_t)e);
        else
            fmpq_mul_2exp(c[i], c[i], (flint_bitcnt_t)-e);
    }
}

static void scale_weights(struct points *p)
{
    fmpz_t l;
    fmpz_init_set_ui(l, 1);
    odd_denominator(l, p->w, p->degree);
    multiply(p->w, p->degree, l, 0);
    fmpz_clear(l);
}

bool draft_scale(struct draft *d)
{
    fmpz_t l, one;
    slong e = WORD_MIN;
    fmpq_t *list[4] = {d->f.x, d->f.y, d->g.x, d->g.y};
    int degree[4] = {d->f.degree, d->f.degree, d->g.degree, d->g.degree};
    fmpz_init_set_ui(l, 1);
    fmpz_init_set_ui(one, 1);
    for (int k = 0; k < 4; k++)
        odd_denominator(l, list[k], degree[k]);
    for (int k = 0; k < 4; k++) {
        multiply(list[k], degree[k], l, 0);
        e = exponent_max(e, list[k], degree[k]);
    }
    for (int k = 0; k < 4; k++)
        multiply(list[k], degree[k], one, e);
    scale_weights(&d->f);
    scale_weights(&d->g);
    fmpz_clear(l);
    fmpz_clear(one);
    return draft_fits(d);
}

/* Numerator of at most 53 bits over a power of two of moderate size, or an integer of 53 significant bits. */
static bool fits_double(const fmpq_t a)
{
    const fmpz *den = fmpq_denref(a), *num = fmpq_numref(a);
    slong bits = (slong)fmpz_bits(num), exponent = (slong)fmpz_val2(den);
    if (fmpz_is_zero(num))
        return true;
    return (slong)fmpz_bits(den) == exponent + 1 && exponent < 1000 && bits < 1000 &&
           bits - (slong)fmpz_val2(num) <= 53;
}

static bool points_fit(const struct points *p)
{
    for (int i = 0; i <= p->degree; i++)
        if (!fits_double(p->x[i]) || !fits_double(p->y[i]) || !fits_double(p->w[i]) || fmpq_sgn(p->w[i]) <= 0)
            return false;
    return true;
}

bool draft_fits(const struct draft *d)
{
    return points_fit(&d->f) && points_fit(&d->g);
}

/* Sign of the determinant of leg i of p and leg j of q; 2 if one of the legs is zero. */
static int turn_sign(const struct points *p, int i, const struct points *q, int j)
{
    fmpq_t a, b, c, e;
    int sign;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_init(c);
    fmpq_init(e);
    fmpq_sub(a, p->x[i + 1], p->x[i]);
    fmpq_sub(b, p->y[i + 1], p->y[i]);
    fmpq_sub(c, q->x[j + 1], q->x[j]);
    fmpq_sub(e, q->y[j + 1], q->y[j]);
    bool zero = (fmpq_is_zero(a) && fmpq_is_zero(b)) || (fmpq_is_zero(c) && fmpq_is_zero(e));
    fmpq_mul(a, a, e);
    fmpq_mul(b, b, c);
    sign = zero ? 2 : fmpq_cmp(a, b);
    fmpq_clear(a);
    fmpq_clear(b);
    fmpq_clear(c);
    fmpq_clear(e);
    return zero ? 2 : (sign > 0) - (sign < 0);
}

bool meet_at_most_once(const struct draft *d)
{
    int common = 2;
    for (int i = 0; i < d->f.degree; i++)
        for (int j = 0; j < d->g.degree; j++) {
            int sign = turn_sign(&d->f, i, &d->g, j);
            if (sign == 2)
                continue;
            if (sign == 0 || (common != 2 && sign != common))
                return false;
            common = sign;
        }
    return common != 2;
}

/* Some p[i] <= some q[j]. */
static bool reaches(fmpq_t *p, int n, fmpq_t *q, int m)
{
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            if (fmpq_cmp(p[i], q[j]) <= 0)
                return true;
    return false;
}

bool boxes_apart(const struct draft *d)
{
    int n = d->f.degree, m = d->g.degree;
    fmpq_t *fx = (fmpq_t *)d->f.x, *fy = (fmpq_t *)d->f.y, *gx = (fmpq_t *)d->g.x, *gy = (fmpq_t *)d->g.y;
    return !reaches(fx, n, gx, m) || !reaches(gx, m, fx, n) || !reaches(fy, n, gy, m) ||
           !reaches(gy, m, fy, n);
}
