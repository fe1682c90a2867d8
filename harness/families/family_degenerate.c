/* Pairs where a derivative vanishes: cusps x = a u^2 + ..., y = b u^3 + ... inside, and the same at an end.
 */
#include "family.h"

/* The curve that has the cusp: f, unless its degree is too low. */
static bool cusp_on_g(const struct request *r)
{
    return r->n < 3;
}

/* A cusp on one curve at the origin; the other, in its own parameter, begins with u^x_from and u^y_from. */
static bool meet_cusp(struct draft *d, struct request *r, int x_from, int y_from, int multiplicity)
{
    fmpq_t t, s;
    random_places(t, s, r, 32);
    if (cusp_on_g(r)) {
        random_local(&d->g, r, s, 2, 3);
        random_local(&d->f, r, t, x_from, y_from);
    } else {
        random_local(&d->f, r, t, 2, 3);
        random_local(&d->g, r, s, x_from, y_from);
    }
    draft_plant(d, t, s, multiplicity);
    d->class_name = "degenerate";
    fmpq_clear(t);
    fmpq_clear(s);
    return finish(d, r);
}

bool family_cusp_crossed(struct draft *d, struct request *r)
{
    return meet_cusp(d, r, 1, 1, 2);
}

bool family_cusp_along(struct draft *d, struct request *r)
{
    return meet_cusp(d, r, 1, 2, 3);
}

/* With y^2 = c x^3 + ... on the one and y^2 = e x^3 + ... on the other, the multiplicity is 6 unless c = e.
 */
bool family_two_cusps(struct draft *d, struct request *r)
{
    bool common = r->index & 1;
    snprintf(d->note, sizeof d->note, common ? "common tangent" : "crossing tangents");
    return common ? meet_cusp(d, r, 2, 3, 6) : meet_cusp(d, r, 3, 2, 4);
}

/* Both curves begin with a doubled control point and cross once, elsewhere. */
static bool double_ends(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    random_places(t, s, r, r->weights ? 14 : 34);
    if (r->weights) {
        random_weights(&d->f, r);
        random_weights(&d->g, r);
    }
    random_slope(&d->f, r, false);
    random_slope(&d->g, r, true);
    points_set(&d->f, 1, 0, 0);
    points_set(&d->g, 1, 0, 0);
    draft_join(d, t, s);
    draft_plant(d, t, s, 1);
    snprintf(d->note, sizeof d->note, "both begin with derivative zero, and cross elsewhere");
    d->class_name = "transversal";
    d->complete = meet_at_most_once(d);
    fmpq_clear(t);
    fmpq_clear(s);
    return d->complete && finish(d, r);
}

bool family_zero_end(struct draft *d, struct request *r)
{
    bool shared = r->index % 3 == 1;
    fmpq_t t, s;
    if (r->index % 3 == 2)
        return double_ends(d, r);
    fmpq_init(t);
    fmpq_init(s);
    fmpq_set_si(t, random_coin(r), 1);
    fmpq_set_si(s, random_coin(r), 1);
    if (!shared)
        random_parameter(s, r, r->m, 32);
    random_local(&d->f, r, t, 2, 3);
    if (shared)
        random_local(&d->g, r, s, 3, 2);
    else
        random_local(&d->g, r, s, 1, 1);
    draft_plant(d, t, s, shared ? 4 : 2);
    snprintf(d->note, sizeof d->note, "%s",
             shared ? "common end, both derivatives zero" : "end on the other curve");
    d->class_name = "degenerate";
    fmpq_clear(t);
    fmpq_clear(s);
    return finish(d, r);
}
