/* The same crossing at other sizes and other degrees. */
#include "family.h"

/* Moves the control points p by a unit or two so that the sum of C(n,i) w[i] p[i], w[0] = 1, is 0: the curve
 * then passes through 0 at 1/2.  Points and weights are integers. */
static void centre(fmpq_t *p, const fmpq_t *w, int n)
{
    fmpz_t sum, q, k[DRAFT_DEGREE_MAX + 1];
    fmpz_init(sum);
    fmpz_init(q);
    for (int i = 0; i <= n; i++) {
        fmpz_init(k[i]);
        fmpz_bin_uiui(k[i], (ulong)n, (ulong)i);
        fmpz_mul(k[i], k[i], fmpq_numref(w[i]));
        fmpz_addmul(sum, k[i], fmpq_numref(p[i]));
    }
    for (int pass = 0; pass <= n; pass++) { /* the largest factor first, 1 last */
        int best = 0;
        for (int i = 1; i <= n; i++)
            if (fmpz_cmp(k[i], k[best]) > 0)
                best = i;
        if (fmpz_is_zero(k[best]))
            break;
        fmpz_ndiv_qr(q, sum, sum, k[best]);
        fmpz_sub(fmpq_numref(p[best]), fmpq_numref(p[best]), q);
        fmpz_zero(k[best]);
    }
    for (int i = 0; i <= n; i++)
        fmpz_clear(k[i]);
    fmpz_clear(sum);
    fmpz_clear(q);
}

/* p[i] <- the integer next to 16 (p[i] - x). */
static void refine(fmpq_t *p, int n, const fmpq_t x)
{
    for (int i = 0; i <= n; i++) {
        fmpq_sub(p[i], p[i], x);
        fmpq_mul_2exp(p[i], p[i], 4);
        fmpz_fdiv_q(fmpq_numref(p[i]), fmpq_numref(p[i]), fmpq_denref(p[i]));
        fmpz_one(fmpq_denref(p[i]));
    }
}

/* A slope in integers with the origin at parameter 1/2; weights 1, 2, 4. */
static void slope_through_origin(struct points *p, struct request *r, bool upright)
{
    fmpq_t half, x, y;
    fmpq_init(half);
    fmpq_init(x);
    fmpq_init(y);
    fmpq_set_si(half, 1, 2);
    for (int i = 1; p->rational && i <= p->degree; i++)
        fmpq_set_si(p->w[i], (slong)1 << random_between(&r->random, 0, 2), 1);
    random_slope(p, r, upright);
    points_value(x, y, p, half);
    refine(p->x, p->degree, x);
    refine(p->y, p->degree, y);
    centre(p->x, (const fmpq_t *)p->w, p->degree);
    centre(p->y, (const fmpq_t *)p->w, p->degree);
    fmpq_clear(half);
    fmpq_clear(x);
    fmpq_clear(y);
}

bool family_size_mismatch(struct draft *d, struct request *r)
{
    fmpq_t half, x, y;
    struct points *small = r->index & 1 ? &d->g : &d->f;
    flint_bitcnt_t j = 1 + (r->index >> 1) * 17 % 40;
    fmpq_init(half);
    fmpq_init(x);
    fmpq_init(y);
    fmpq_set_si(half, 1, 2);
    fmpq_set_si(x, 128 * (slong)random_between(&r->random, -7, 7), 1);
    fmpq_set_si(y, 128 * (slong)random_between(&r->random, -7, 7), 1);
    slope_through_origin(&d->f, r, false);
    slope_through_origin(&d->g, r, true);
    for (int i = 0; i <= small->degree; i++) {
        fmpq_div_2exp(small->x[i], small->x[i], j);
        fmpq_div_2exp(small->y[i], small->y[i], j);
    }
    points_move(&d->f, x, y);
    points_move(&d->g, x, y);
    draft_plant(d, half, half, 1);
    snprintf(d->note, sizeof d->note, "%s shrunk by 2^-%d", r->index & 1 ? "g" : "f", (int)j);
    d->class_name = "transversal";
    d->complete = meet_at_most_once(d) && contact_order(d, half, half, 2, NULL) == 1;
    fmpq_clear(half);
    fmpq_clear(x);
    fmpq_clear(y);
    return d->complete && finish(d, r);
}

bool family_degree_sweep(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    fmpq_init(t);
    fmpq_init(s);
    random_parameter(t, r, 2, 10);
    random_parameter(s, r, 2, 10);
    d->f.degree = d->g.degree = 2;
    random_slope(&d->f, r, false);
    random_slope(&d->g, r, true);
    draft_join(d, t, s);
    draft_plant(d, t, s, 1);
    d->class_name = "transversal";
    d->complete = meet_at_most_once(d);
    points_elevate(&d->f, r->n);
    points_elevate(&d->g, r->m);
    fmpq_clear(t);
    fmpq_clear(s);
    return finish(d, r);
}
