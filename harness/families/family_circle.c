/* Circular arcs, exact: (1 - u^2, 2 u) / (1 + u^2) is a quarter, with control points (1,0), (1,1), (0,1) and
 * weights 1, 1, 2; at u = 1/2 it points in the direction (3, 4) / 5, at u = 1/3 in (4, 3) / 5. */
#include "family.h"

/* The quarter circle of this radius about (x, y). */
static void set_quarter(struct points *p, slong x, slong y, slong radius)
{
    p->degree = 2;
    points_set(p, 0, x + radius, y);
    points_set(p, 1, x + radius, y + radius);
    points_set(p, 2, x, y + radius);
    fmpq_set_si(p->w[0], 1, 1);
    fmpq_set_si(p->w[1], 1, 1);
    fmpq_set_si(p->w[2], 2, 1);
}

static bool finish_arcs(struct draft *d, struct request *r)
{
    points_elevate(&d->f, r->n);
    points_elevate(&d->g, r->m);
    return finish(d, r);
}

static void half_turn(struct points *p)
{
    points_turn(p, -1, 0);
}

/* Both pass through the origin: f at u = 1/2, its centre -5 k (3, 4) / 5, g likewise with (4, 3) or turned by
 * a quarter; the directions of their radii differ there. */
bool family_circle_crossing(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    slong k = (slong)random_between(&r->random, 1, 40), l = (slong)random_between(&r->random, 1, 40);
    fmpq_init(t);
    fmpq_init(s);
    set_quarter(&d->f, -3 * k, -4 * k, 5 * k);
    set_quarter(&d->g, -4 * l, -3 * l, 5 * l);
    slong turns = (slong)random_between(&r->random, 0, 3);
    for (slong i = 0; i < turns; i++)
        points_turn(&d->g, 0, 1);
    fmpq_set_si(t, 1, 2);
    fmpq_set_si(s, 1, 3);
    draft_plant(d, t, s, 1);
    fmpq_clear(t);
    fmpq_clear(s);
    return finish_arcs(d, r);
}

/* Circles that touch have one point in common. */
bool family_circle_tangent(struct draft *d, struct request *r)
{
    fmpq_t half;
    slong k = (slong)random_between(&r->random, 1, 40), l;
    do
        l = (slong)random_between(&r->random, 1, 40);
    while (l == k);
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    set_quarter(&d->f, -3 * k, -4 * k, 5 * k);
    set_quarter(&d->g, -3 * l, -4 * l, 5 * l);
    if (r->index & 1)
        half_turn(&d->g);
    snprintf(d->note, sizeof d->note, "from %s", r->index & 1 ? "outside" : "inside");
    draft_plant(d, half, half, 2);
    d->class_name = "tangent";
    d->complete = true;
    fmpq_clear(half);
    return finish_arcs(d, r);
}
