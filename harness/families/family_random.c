/* Pairs without a design, and pairs that do not meet. */
#include "family.h"

/* Control points k 2^-bits in [0, 1)^2; weights k/8 in [1/2, 4]. */
static void scatter(struct points *p, struct request *r, int bits)
{
    for (int i = 0; i <= p->degree; i++) {
        points_set(p, i, (slong)random_between(&r->random, 0, ((int64_t)1 << bits) - 1),
                   (slong)random_between(&r->random, 0, ((int64_t)1 << bits) - 1));
        fmpq_div_2exp(p->x[i], p->x[i], (flint_bitcnt_t)bits);
        fmpq_div_2exp(p->y[i], p->y[i], (flint_bitcnt_t)bits);
        if (p->rational)
            fmpq_set_si(p->w[i], (slong)random_between(&r->random, 4, 32), 8);
        fmpq_canonicalise(p->w[i]);
    }
}

bool family_random(struct draft *d, struct request *r)
{
    scatter(&d->f, r, 20);
    scatter(&d->g, r, 20);
    return true;
}

bool family_far(struct draft *d, struct request *r)
{
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    scatter(&d->f, r, 20);
    scatter(&d->g, r, 20);
    fmpq_set_si(x, (slong)random_between(&r->random, -256, 256), 1);
    fmpq_set_si(y, (slong)random_between(&r->random, -256, 256), 1);
    points_move(&d->g, x, y);
    d->class_name = "none";
    d->complete = boxes_apart(d);
    fmpq_clear(x);
    fmpq_clear(y);
    return d->complete;
}

/* g = f elevated, and moved upwards by a Bernstein polynomial with coefficients 2^-j (1..4): x is increasing
 * and the same function of the parameter on both, so f(t) = g(s) would need t = s. */
bool family_near_disjoint(struct draft *d, struct request *r)
{
    struct points *low = r->n <= r->m ? &d->f : &d->g, *high = r->n <= r->m ? &d->g : &d->f;
    int degree = high->degree;
    flint_bitcnt_t j = 4 + r->index % 17;
    fmpq_t up;
    fmpq_init(up);
    if (r->weights)
        random_weights(low, r);
    random_slope(low, r, false);
    for (int i = 0; i <= low->degree; i++) { /* to a size of about 1 */
        fmpq_div_2exp(low->x[i], low->x[i], 6);
        fmpq_div_2exp(low->y[i], low->y[i], 6);
    }
    points_copy(high, low);
    points_elevate(high, degree);
    for (int i = 0; i <= degree; i++) {
        fmpq_set_si(up, (slong)random_between(&r->random, 8, 32), 8);
        fmpq_div_2exp(up, up, j);
        fmpq_add(high->y[i], high->y[i], up);
    }
    snprintf(d->note, sizeof d->note, "2^-%d of the unit apart", (int)j);
    d->class_name = "none";
    d->complete = true;
    fmpq_clear(up);
    return finish(d, r);
}
