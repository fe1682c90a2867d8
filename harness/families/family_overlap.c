/* Two curves on one carrier. */
#include "family.h"

/* p <- the carrier over [a, b] (reversed if a > b), at the degree of p. */
static void carry(struct points *p, const struct shape *carrier, slong a, slong b, slong unit)
{
    struct shape s;
    fmpq_poly_t line;
    int degree = p->degree;
    shape_init(&s);
    fmpq_poly_init(line);
    fmpq_poly_set_coeff_si(line, 1, b - a);
    fmpq_poly_set_coeff_si(line, 0, a);
    fmpq_poly_scalar_div_si(line, line, unit);
    fmpq_poly_compose(s.x, carrier->x, line);
    fmpq_poly_compose(s.y, carrier->y, line);
    fmpq_poly_one(s.w);
    points_from_shape(p, degree, &s);
    fmpq_poly_clear(line);
    shape_clear(&s);
}

/* f over [0, 1] of the carrier, g over [a, b] / 8, which reaches into it.  What they share of [a, b] is [lo,
 * hi] / 8. */
static void share_arc(struct draft *d, struct request *r, const struct shape *carrier, bool reversed)
{
    slong a = (slong)random_between(&r->random, -3, 5), length = (slong)random_between(&r->random, 2, 8);
    a = a + length <= 0 ? 1 : a;
    slong b = a + length, lo = a < 0 ? 0 : a, hi = b > 8 ? 8 : b;
    carry(&d->f, carrier, 0, 8, 8);
    carry(&d->g, carrier, a, b, 8);
    fmpq_set_si(d->overlap[0], lo, 8);
    fmpq_set_si(d->overlap[1], hi, 8);
    fmpq_set_si(d->overlap[2], lo - a, (ulong)length);
    fmpq_set_si(d->overlap[3], hi - a, (ulong)length);
    for (int k = 0; k < 4; k++)
        fmpq_canonicalise(d->overlap[k]);
    if (reversed)
        draft_reverse_g(d);
}

/* g(s) = carrier((s - s0)(1 + c s) e), s0 = 0 or 1/4, c in 1..3, increasing where it matters, below 1 at s
 * = 1. */
static void reparametrise(struct draft *d, struct request *r, const struct shape *carrier)
{
    slong quarter = (slong)random_between(&r->random, 0, 1), c = (slong)random_between(&r->random, 1, 3);
    struct shape s;
    fmpq_poly_t q;
    fmpq_poly_init(q);
    shape_init(&s);
    fmpq_poly_set_coeff_si(q, 0, -quarter); /* (4 s - quarter)(1 + c s) / 16, at most 1 at s = 1 */
    fmpq_poly_set_coeff_si(q, 1, 4 - quarter * c);
    fmpq_poly_set_coeff_si(q, 2, 4 * c);
    fmpq_poly_scalar_div_si(q, q, 16);
    carry(&d->f, carrier, 0, 1, 1);
    fmpq_poly_compose(s.x, carrier->x, q);
    fmpq_poly_compose(s.y, carrier->y, q);
    fmpq_poly_one(s.w);
    points_from_shape(&d->g, d->g.degree, &s);
    fmpq_zero(d->overlap[0]);
    fmpq_set_si(d->overlap[1], (4 - quarter) * (1 + c), 16);
    fmpq_set_si(d->overlap[2], quarter, 4);
    fmpq_one(d->overlap[3]);
    fmpq_canonicalise(d->overlap[1]);
    fmpq_poly_clear(q);
    shape_clear(&s);
}

/* Rational: the same control points with weights w[i] and w[i] 2^i trace the same arc (s and t are related by
 * a fraction of linear functions). */
static void reweigh(struct draft *d, struct request *r)
{
    random_weights(&d->f, r);
    random_slope(&d->f, r, false);
    points_copy(&d->g, &d->f);
    for (int i = 1; i <= d->g.degree; i++)
        fmpq_mul_2exp(d->g.w[i], d->g.w[i], (flint_bitcnt_t)i);
    for (int k = 0; k < 4; k++)
        fmpq_set_si(d->overlap[k], k & 1, 1);
    if (r->index & 1)
        draft_reverse_g(d);
    snprintf(d->note, sizeof d->note, "same arc, other weights%s", r->index & 1 ? ", reversed" : "");
}

static void share_carrier(struct draft *d, struct request *r)
{
    static const char *const notes[4] = {"sub-arc", "sub-arc reversed", "sub-arc elevated",
                                         "parameter replaced by a quadratic"};
    int variant = (int)(r->index % 4), low = r->n < r->m ? r->n : r->m;
    int degree = variant == 3                   ? (r->n < r->m / 2 ? r->n : r->m / 2)
                 : variant == 2 && r->n == r->m ? low - 1
                                                : low;
    struct shape carrier;
    if (degree < 1)
        variant = 0, degree = 1; /* nothing to elevate or to compose at degree 1 */
    d->f.degree = degree;
    shape_init(&carrier);
    random_slope(&d->f, r, false);
    shape_from_points(&carrier, &d->f);
    d->f.degree = r->n;
    if (variant == 3)
        reparametrise(d, r, &carrier);
    else
        share_arc(d, r, &carrier, variant == 1);
    snprintf(d->note, sizeof d->note, "%s, carrier of degree %d", notes[variant], degree);
    shape_clear(&carrier);
}

bool family_overlap(struct draft *d, struct request *r)
{
    d->class_name = "overlap";
    d->overlaps = true;
    if (r->weights)
        reweigh(d, r);
    else
        share_carrier(d, r);
    return finish(d, r);
}

/* A cubic with a loop; of higher degree, any polygon. */
static void draw_loop(struct points *p, struct request *r)
{
    static const slong low[4][2] = {{0, 0}, {6, 4}, {-9, 4}, {1, 0}},
                       high[4][2] = {{0, 0}, {12, 9}, {-3, 9}, {3, 1}};
    for (int i = 0; i <= p->degree; i++)
        if (p->degree == 3)
            points_set(p, i, (slong)random_between(&r->random, low[i][0], high[i][0]),
                       (slong)random_between(&r->random, low[i][1], high[i][1]));
        else
            points_set(p, i, (slong)random_between(&r->random, -15, 15),
                       (slong)random_between(&r->random, -15, 15));
}

bool family_overlap_beside(struct draft *d, struct request *r)
{
    struct shape carrier;
    int low = r->n < r->m ? r->n : r->m;
    d->class_name = "";
    d->overlaps = true;
    d->f.degree = low;
    shape_init(&carrier);
    draw_loop(&d->f, r);
    shape_from_points(&carrier, &d->f);
    d->f.degree = r->n;
    share_arc(d, r, &carrier, r->index & 1);
    shape_clear(&carrier);
    return finish(d, r);
}

bool family_near_overlap(struct draft *d, struct request *r)
{
    flint_bitcnt_t j = 1 + r->index * 5 % 36;
    fmpq_t a;
    fmpq_init(a);
    share_carrier(d, r);
    for (int i = 0; i <= d->g.degree; i++)
        for (int k = 0; k < 2; k++) {
            fmpq_set_si(a, (slong)random_between(&r->random, -8, 8), 8);
            fmpq_div_2exp(a, a, j);
            fmpq_add(k ? d->g.y[i] : d->g.x[i], k ? d->g.y[i] : d->g.x[i], a);
        }
    fmpq_clear(a);
    snprintf(d->note, sizeof d->note, "an overlap, g moved by up to 2^-%d of a unit", (int)j);
    return finish(d, r);
}
