/* Curves given by their behaviour at one parameter. */
#include "family.h"

/* p(u + c), c = sign t0. */
static void shift(fmpq_poly_t p, const fmpq_t t0, int sign)
{
    fmpq_poly_t line;
    fmpq_t c;
    fmpq_poly_init(line);
    fmpq_init(c);
    fmpq_mul_si(c, t0, sign);
    fmpq_poly_set_coeff_fmpq(line, 0, c);
    fmpq_poly_set_coeff_si(line, 1, 1);
    fmpq_poly_compose(p, p, line);
    fmpq_clear(c);
    fmpq_poly_clear(line);
}

void random_local_weights(fmpq_poly_t w, struct points *p, struct request *r, const fmpq_t t0)
{
    struct shape s;
    fmpq_poly_one(w);
    if (!p->rational)
        return;
    random_weights(p, r);
    shape_init(&s);
    shape_from_points(&s, p);
    shift(s.w, t0, 1);
    fmpq_poly_set(w, s.w);
    shape_clear(&s);
}

void points_from_local(struct points *p, struct shape *local, const fmpq_t t0)
{
    shift(local->x, t0, -1);
    shift(local->y, t0, -1);
    shift(local->w, t0, -1);
    points_from_shape(p, p->degree, local);
}

void random_local(struct points *p, struct request *r, const fmpq_t t0, int x_from, int y_from)
{
    struct shape s;
    fmpq_t a;
    shape_init(&s);
    fmpq_init(a);
    random_local_weights(s.w, p, r, t0);
    for (int j = x_from; j <= p->degree; j++) {
        random_dyadic(a, r, 1, 3);
        fmpq_poly_set_coeff_fmpq(s.x, j, a);
    }
    for (int j = y_from; j <= p->degree; j++) {
        random_dyadic(a, r, 1, 3);
        fmpq_poly_set_coeff_fmpq(s.y, j, a);
    }
    points_from_local(p, &s, t0);
    fmpq_clear(a);
    shape_clear(&s);
}
