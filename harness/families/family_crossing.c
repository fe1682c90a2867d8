/* Transversal crossings of which nothing but the place is special. */
#include "family.h"

/* f falls within 45 degrees of one axis, g of the other, f(t) = g(s): they meet there and nowhere else. */
static bool cross_at(struct draft *d, struct request *r, const fmpq_t t, const fmpq_t s,
                     const char *class_name)
{
    if (r->weights) {
        random_weights(&d->f, r);
        random_weights(&d->g, r);
    }
    random_slope(&d->f, r, false);
    random_slope(&d->g, r, true);
    draft_join(d, t, s);
    draft_plant(d, t, s, 1);
    d->class_name = class_name;
    d->complete = meet_at_most_once(d);
    return d->complete && finish(d, r);
}

bool family_nice(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    bool good;
    random_places(t, s, r, r->weights ? 14 : 34);
    good = cross_at(d, r, t, s, "transversal");
    fmpq_clear(t);
    fmpq_clear(s);
    return good;
}

/* By index: f begins, f ends, g begins, g ends at the crossing. */
bool family_endpoint(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    bool good;
    random_places(t, s, r, r->weights ? 14 : 34);
    fmpq_set_si(r->index & 2 ? s : t, r->index & 1, 1);
    good = cross_at(d, r, t, s, "endpoint");
    fmpq_clear(t);
    fmpq_clear(s);
    return good;
}

bool family_shared_end(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    bool good;
    fmpq_init(t);
    fmpq_init(s);
    fmpq_set_si(t, r->index & 1, 1);
    fmpq_set_si(s, r->index >> 1 & 1, 1);
    good = cross_at(d, r, t, s, "endpoint");
    fmpq_clear(t);
    fmpq_clear(s);
    return good;
}

/* Both go from left to right, g from where f ends, its first leg a multiple of f's last: no common abscissa
 * but there. */
bool family_smooth_join(struct draft *d, struct request *r)
{
    fmpq_t one, zero, x, y;
    struct points *f = &d->f, *g = &d->g;
    slong twice = (slong)random_between(&r->random, 1, 4);
    fmpq_init(one);
    fmpq_init(zero);
    fmpq_init(x);
    fmpq_init(y);
    fmpq_one(one);
    if (r->weights) {
        random_weights(f, r);
        random_weights(g, r);
    }
    random_slope(f, r, false);
    random_slope(g, r, false);
    fmpq_sub(x, f->x[f->degree], f->x[f->degree - 1]);
    fmpq_sub(y, f->y[f->degree], f->y[f->degree - 1]);
    fmpq_mul_si(x, x, twice);
    fmpq_mul_si(y, y, twice);
    fmpq_div_2exp(x, x, 1);
    fmpq_div_2exp(y, y, 1);
    fmpq_sub(x, x, g->x[1]);
    fmpq_sub(y, y, g->y[1]);
    for (int i = 1; i <= g->degree; i++) {
        fmpq_add(g->x[i], g->x[i], x);
        fmpq_add(g->y[i], g->y[i], y);
    }
    draft_join(d, one, zero);
    int order = contact_order(d, one, zero, 8, NULL);
    draft_plant(d, one, zero, order);
    d->class_name = "tangent";
    d->complete = true;
    fmpq_clear(one);
    fmpq_clear(zero);
    fmpq_clear(x);
    fmpq_clear(y);
    return order >= 2 && order < 8 && finish(d, r);
}
