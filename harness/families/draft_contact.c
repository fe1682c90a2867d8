/* Order of contact by power series. */
#include "draft.h"

/* Power series of x/w and y/w about t, without their constant terms, up to order `length` - 1. */
static void series_at(fmpq_poly_t x, fmpq_poly_t y, const struct points *p, const fmpq_t t, slong length)
{
    struct shape s;
    fmpq_poly_t shift;
    shape_init(&s);
    fmpq_poly_init(shift);
    fmpq_poly_set_coeff_fmpq(shift, 0, t);
    fmpq_poly_set_coeff_si(shift, 1, 1);
    shape_from_points(&s, p);
    fmpq_poly_compose(s.x, s.x, shift);
    fmpq_poly_compose(s.y, s.y, shift);
    fmpq_poly_compose(s.w, s.w, shift);
    fmpq_poly_div_series(x, s.x, s.w, length);
    fmpq_poly_div_series(y, s.y, s.w, length);
    fmpq_poly_set_coeff_si(x, 0, 0);
    fmpq_poly_set_coeff_si(y, 0, 0);
    fmpq_poly_clear(shift);
    shape_clear(&s);
}

static bool coefficient_is_zero(const fmpq_poly_t a, slong i)
{
    return i >= fmpq_poly_length(a) || fmpz_is_zero(fmpq_poly_numref(a) + i);
}

/* Order of y_f - y_g as functions of the common abscissa, at most limit; the difference is left in fy, the
 * parameters as functions of the abscissa in fx and gx. */
static int order_over_x(fmpq_poly_t fx, fmpq_poly_t fy, fmpq_poly_t gx, fmpq_poly_t gy, int limit)
{
    int order = 1;
    fmpq_poly_revert_series(fx, fx, limit + 1);
    fmpq_poly_compose_series(fy, fy, fx, limit + 1);
    fmpq_poly_revert_series(gx, gx, limit + 1);
    fmpq_poly_compose_series(gy, gy, gx, limit + 1);
    fmpq_poly_sub(fy, fy, gy);
    while (order < limit && coefficient_is_zero(fy, order))
        order++;
    return order;
}

static bool same_point(const struct draft *d, const fmpq_t t, const fmpq_t s)
{
    fmpq_t v[4];
    for (int k = 0; k < 4; k++)
        fmpq_init(v[k]);
    points_value(v[0], v[1], &d->f, t);
    points_value(v[2], v[3], &d->g, s);
    bool same = fmpq_equal(v[0], v[2]) && fmpq_equal(v[1], v[3]);
    for (int k = 0; k < 4; k++)
        fmpq_clear(v[k]);
    return same;
}

/* |a[1]| > |b[1]|. */
static bool rises_faster(const fmpq_poly_t a, const fmpq_poly_t b)
{
    fmpq_t u, v;
    fmpq_init(u);
    fmpq_init(v);
    fmpq_poly_get_coeff_fmpq(u, a, 1);
    fmpq_poly_get_coeff_fmpq(v, b, 1);
    fmpq_abs(u, u);
    fmpq_abs(v, v);
    bool faster = fmpq_cmp(u, v) > 0;
    fmpq_clear(u);
    fmpq_clear(v);
    return faster;
}

void contact_init(struct contact *c)
{
    fmpq_init(c->bend);
    fmpq_init(c->dt);
    fmpq_init(c->ds);
}

void contact_clear(struct contact *c)
{
    fmpq_clear(c->bend);
    fmpq_clear(c->dt);
    fmpq_clear(c->ds);
}

int contact_order(const struct draft *d, const fmpq_t t, const fmpq_t s, int limit, struct contact *c)
{
    fmpq_poly_t a[4];
    int order = 1;
    if (!same_point(d, t, s))
        return 0;
    for (int k = 0; k < 4; k++)
        fmpq_poly_init(a[k]);
    series_at(a[0], a[1], &d->f, t, limit + 1);
    series_at(a[2], a[3], &d->g, s, limit + 1);
    int x = rises_faster(a[1], a[0]); /* 1: the curves are taken as functions of y */
    if (coefficient_is_zero(a[x], 1) || (coefficient_is_zero(a[2], 1) && coefficient_is_zero(a[3], 1)))
        order = 0;
    else if (!coefficient_is_zero(a[2 + x], 1))
        order = order_over_x(a[x], a[1 - x], a[2 + x], a[3 - x], limit);
    if (c && order > 1) {
        c->over_y = x;
        fmpq_poly_get_coeff_fmpq(c->bend, a[1 - x], order);
        fmpq_poly_get_coeff_fmpq(c->dt, a[x], 1); /* reverted by order_over_x */
        fmpq_poly_get_coeff_fmpq(c->ds, a[2 + x], 1);
    }
    for (int k = 0; k < 4; k++)
        fmpq_poly_clear(a[k]);
    return order;
}
