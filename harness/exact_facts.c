/* Point, angle and condition of one common point, from balls. */
#include "exact_answer.h"

#include <math.h>
#include <arb_fmpz_poly.h>

enum { PREC_FIRST = 192, PREC_LAST = 1 << 14 };

/* Point and derivative, (x, y) and (dx, dy), by the parameter on [0, 1]. */
static void curve_balls(arb_ptr out, const struct exact_answer *a, const struct exact_curve *c, const arb_t t,
                        slong prec)
{
    const fmpz_poly_struct *part[3] = {c->x, c->y, c->w};
    arb_ptr v = _arb_vec_init(3), d = _arb_vec_init(3);
    fmpz_poly_t derivative;
    fmpz_poly_init(derivative);
    for (int i = 0; i < 3; i++) {
        arb_fmpz_poly_evaluate_arb_horner(v + i, part[i], t, prec);
        fmpz_poly_derivative(derivative, part[i]);
        arb_fmpz_poly_evaluate_arb_horner(d + i, derivative, t, prec);
    }
    for (int i = 0; i < 2; i++) { /* (x / w)' = (x' - (x / w) w') / w */
        arb_div(out + i, v + i, v + 2, prec);
        arb_set(out + 2 + i, d + i);
        arb_submul(out + 2 + i, out + i, d + 2, prec);
        arb_div(out + 2 + i, out + 2 + i, v + 2, prec);
        arb_div_fmpz(out + i, out + i, a->scale[i], prec);
        arb_div_fmpz(out + 2 + i, out + 2 + i, a->scale[i], prec);
    }
    fmpz_poly_clear(derivative);
    _arb_vec_clear(v, 3);
    _arb_vec_clear(d, 3);
}

static double to_double(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

static double norm(arb_srcptr d, slong prec)
{
    arb_t n;
    arb_init(n);
    arb_hypot(n, d, d + 1, prec);
    double r = to_double(n);
    arb_clear(n);
    return r;
}

static double length_of_domain(const struct case_curve *c)
{
    return mpq_get_d(c->hi) - mpq_get_d(c->lo);
}

static double largest_coordinate(const struct test_case *c)
{
    const struct case_curve *curve[2] = {&c->f, &c->g};
    double size = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i <= curve[k]->degree; i++)
            size = fmax(size, fmax(fabs(mpq_get_d(curve[k]->x[i])), fabs(mpq_get_d(curve[k]->y[i]))));
    return size;
}

/* The condition: a relative change e of the coordinates moves the curves by up to e times the largest
 * coordinate, and t by at most |g'| / |f' x g'| times that, s by |f'| / |f' x g'|. */
struct exact_facts exact_facts_of(const struct exact_answer *a, const struct test_case *c,
                                  struct exact_point *p)
{
    struct exact_facts r = {.sine = NAN, .cond = NAN};
    arb_ptr f = _arb_vec_init(4), g = _arb_vec_init(4);
    arb_t cross, sine;
    arb_init(cross);
    arb_init(sine);
    bool settled = false;
    for (slong prec = PREC_FIRST; prec <= PREC_LAST && !settled; prec *= 2) {
        slong work =
            prec + 64 + labs(fmpz_poly_max_bits(a->pair.f.x)) + labs(fmpz_poly_max_bits(a->pair.g.x));
        real_root_refine(&p->t, prec, true);
        real_root_refine(&p->s, prec, true);
        curve_balls(f, a, &a->pair.f, p->t.ball, work);
        curve_balls(g, a, &a->pair.g, p->s.ball, work);
        arb_mul(cross, f + 2, g + 3, work);
        arb_submul(cross, f + 3, g + 2, work);
        settled = p->multiplicity != 1 || arb_rel_accuracy_bits(cross) > 60;
    }
    r.x = to_double(f);
    r.y = to_double(f + 1);
    double fd = norm(f + 2, PREC_LAST) / length_of_domain(&c->f);
    double gd = norm(g + 2, PREC_LAST) / length_of_domain(&c->g);
    if (p->order_f == 0 && p->order_g == 0 && p->multiplicity > 0) {
        arb_hypot(sine, f + 2, f + 3, PREC_FIRST);
        arb_div(cross, cross, sine, PREC_FIRST);
        arb_hypot(sine, g + 2, g + 3, PREC_FIRST);
        arb_div(cross, cross, sine, PREC_FIRST);
        r.sine = p->multiplicity == 1 ? to_double(cross) : 0;
        if (p->multiplicity == 1)
            r.cond = largest_coordinate(c) * fmax(1 / fd, 1 / gd) / fabs(r.sine);
    }
    _arb_vec_clear(f, 4);
    _arb_vec_clear(g, 4);
    arb_clear(cross);
    arb_clear(sine);
    return r;
}

bool exact_same_place(const struct exact_answer *a, const struct exact_point *p, const struct exact_point *q)
{
    arb_ptr u = _arb_vec_init(4), v = _arb_vec_init(4);
    slong work =
        PREC_FIRST + 64 + labs(fmpz_poly_max_bits(a->pair.f.x)) + labs(fmpz_poly_max_bits(a->pair.f.y));
    curve_balls(u, a, &a->pair.f, p->t.ball, work);
    curve_balls(v, a, &a->pair.f, q->t.ball, work);
    bool same = arb_overlaps(u, v) && arb_overlaps(u + 1, v + 1);
    _arb_vec_clear(u, 4);
    _arb_vec_clear(v, 4);
    return same;
}
