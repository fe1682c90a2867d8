/* Contact of order 2, 3, 4 by construction.
 *
 * In the frame of the contact the one curve begins as phi(u) = (x1 u + x2 u^2 + ..., y2 u^2 + ...) and the
 * other as phi(sigma(v)), sigma(v) = c1 v + c2 v^2 + ..., both up to the order; the coefficients from there
 * on are random. Rational: phi times the curve's own weight polynomial, cut off at the order. */
#include "family.h"

/* k/4 with lo <= k <= hi, either sign if `either`. */
static void set_quarters(fmpq_poly_t p, slong j, struct request *r, int lo, int hi, bool either)
{
    fmpq_t a;
    fmpq_init(a);
    fmpq_set_si(a, (slong)random_between(&r->random, lo, hi), 4);
    fmpq_canonicalise(a);
    if (either && random_coin(r))
        fmpq_neg(a, a);
    fmpq_poly_set_coeff_fmpq(p, j, a);
    fmpq_clear(a);
}

/* phi, of degree below the order and at most `degree`. */
static void draw_start(fmpq_poly_t x, fmpq_poly_t y, struct request *r, int order, int degree, bool flat)
{
    set_quarters(x, 1, r, 4, 8, false);
    for (int j = 2; j < order && j <= degree; j++) {
        set_quarters(x, j, r, 0, 3, true);
        set_quarters(y, j, r, 1, 6, true);
    }
    if (flat)
        fmpq_poly_set_coeff_si(y, 2, 0);
}

static void draw_sigma(fmpq_poly_t sigma, struct request *r, int order)
{
    set_quarters(sigma, 1, r, 2, 6, true);
    for (int j = 2; j < order; j++)
        set_quarters(sigma, j, r, 0, 2, true);
}

/* Homogeneous coordinate: head times weight up to the order, then random numbers. */
static void finish_coordinate(fmpq_poly_t out, const fmpq_poly_t head, const fmpq_poly_t w, struct request *r,
                              int order, int degree)
{
    fmpq_poly_mullow(out, head, w, order);
    for (int j = order; j <= degree; j++)
        set_quarters(out, j, r, 1, 4, true);
}

/* Second coefficient of y for curvature k/4 in the sense y = (k/4) x^2 + ... */
static void set_curvature(struct shape *s, const fmpq_poly_t x, slong k)
{
    fmpq_t a, w;
    fmpq_init(a);
    fmpq_init(w);
    fmpq_poly_get_coeff_fmpq(a, x, 1);
    fmpq_poly_get_coeff_fmpq(w, s->w, 0);
    fmpq_mul(a, a, a);
    fmpq_mul(a, a, w);
    fmpq_mul_si(a, a, k);
    fmpq_div_2exp(a, a, 2);
    fmpq_poly_set_coeff_fmpq(s->y, 2, a);
    fmpq_clear(a);
    fmpq_clear(w);
}

enum sides { ANY, SAME, OPPOSITE };

/* Two different curvatures k/4 (order 2). */
static void draw_curvatures(slong k[2], struct request *r, enum sides sides)
{
    do {
        k[0] = (slong)random_between(&r->random, 1, 8);
        k[1] = (slong)random_between(&r->random, 1, 8);
    } while (k[0] == k[1] && sides == SAME);
    if (sides == OPPOSITE)
        k[1] = -k[1];
}

/* f(t) meets g(s) at the origin of the frame with contact `order`; false if it came out higher. */
static bool make_contact(struct draft *d, struct request *r, const fmpq_t t, const fmpq_t s, int order,
                         enum sides sides)
{
    bool swapped = r->n > r->m; /* the curve of lower degree begins */
    struct points *p = swapped ? &d->g : &d->f, *q = swapped ? &d->f : &d->g;
    struct shape head, other, c;
    fmpq_poly_t sigma;
    slong k[2];
    shape_init(&head);
    shape_init(&other);
    fmpq_poly_init(sigma);
    bool flat = order > 2 && p->degree > 2 && r->index % 3 == 2;
    draw_start(head.x, head.y, r, order, p->degree, flat);
    draw_sigma(sigma, r, order);
    draw_curvatures(k, r, sides);
    fmpq_poly_compose_series(other.x, head.x, sigma, order);
    fmpq_poly_compose_series(other.y, head.y, sigma, order);
    for (int i = 0; i < 2; i++) {
        struct points *own = i ? q : p;
        const struct shape *start = i ? &other : &head;
        shape_init(&c);
        random_local_weights(c.w, own, r, i != swapped ? s : t);
        finish_coordinate(c.x, start->x, c.w, r, order, own->degree);
        finish_coordinate(c.y, start->y, c.w, r, order, own->degree);
        if (sides != ANY)
            set_curvature(&c, start->x, k[i]);
        points_from_local(own, &c, i != swapped ? s : t);
        shape_clear(&c);
    }
    draft_plant(d, t, s, order);
    snprintf(d->note, sizeof d->note, "%s", flat ? "at an inflection" : "");
    d->class_name = "tangent";
    fmpq_poly_clear(sigma);
    shape_clear(&head);
    shape_clear(&other);
    return contact_order(d, t, s, order + 1, NULL) == order;
}

static bool make_inner_contact(struct draft *d, struct request *r, int order, enum sides sides)
{
    fmpq_t t, s;
    bool good;
    random_places(t, s, r, 30);
    good = make_contact(d, r, t, s, order, sides);
    fmpq_clear(t);
    fmpq_clear(s);
    return good && finish(d, r);
}

bool family_tangent_same(struct draft *d, struct request *r)
{
    return make_inner_contact(d, r, 2, SAME);
}

bool family_tangent_opposite(struct draft *d, struct request *r)
{
    return make_inner_contact(d, r, 2, OPPOSITE);
}

bool family_contact_3(struct draft *d, struct request *r)
{
    return make_inner_contact(d, r, 3, ANY);
}

bool family_contact_4(struct draft *d, struct request *r)
{
    return make_inner_contact(d, r, 4, ANY);
}

/* By index mod 3: an end of f, an end of g, an end of both. */
bool family_endpoint_tangent(struct draft *d, struct request *r)
{
    fmpq_t t, s;
    bool good;
    random_places(t, s, r, 30);
    if (r->index % 3 != 1)
        fmpq_set_si(t, random_coin(r), 1);
    if (r->index % 3 != 0)
        fmpq_set_si(s, random_coin(r), 1);
    good = make_contact(d, r, t, s, 2, random_coin(r) ? SAME : OPPOSITE);
    fmpq_clear(t);
    fmpq_clear(s);
    return good && finish(d, r);
}

/* Do roots at the distance sqrt(gap / |bend|) keep away from the ends, by half of t's distance from them? */
static bool roots_inside(const fmpq_t t, const fmpq_t rate, const fmpq_t bend, const fmpq_t gap)
{
    fmpq_t a, b;
    bool inside;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_mul(a, rate, rate);
    fmpq_mul(a, a, gap);
    fmpq_div(a, a, bend);
    fmpq_abs(a, a); /* the square of their distance from t */
    fmpq_sub_si(b, t, 1);
    fmpq_neg(b, b);
    if (fmpq_cmp(t, b) < 0)
        fmpq_set(b, t);
    fmpq_div_2exp(b, b, 1);
    fmpq_mul(b, b, b);
    inside = fmpq_cmp(a, b) <= 0;
    fmpq_clear(a);
    fmpq_clear(b);
    return inside;
}

/* Moves g by 2^-exponent along the axis nearest to the normal: into f, or apart from it. */
static bool open_gap(struct draft *d, int exponent, bool apart)
{
    const struct planted *at = &d->at[0];
    struct contact c;
    fmpq_t zero;
    contact_init(&c);
    fmpq_init(zero);
    contact_order(d, at->t, at->s, 2, &c);
    fmpq_set_si(d->gap, fmpq_sgn(c.bend) * (apart ? -1 : 1),
                1); /* bend x^2 - gap: two zeros if of one sign */
    fmpq_div_2exp(d->gap, d->gap, (flint_bitcnt_t)exponent);
    if (c.over_y)
        points_move(&d->g, d->gap, zero);
    else
        points_move(&d->g, zero, d->gap);
    bool good =
        apart || (roots_inside(at->t, c.dt, c.bend, d->gap) && roots_inside(at->s, c.ds, c.bend, d->gap));
    fmpq_clear(zero);
    contact_clear(&c);
    return good;
}

/* Up to here another draw will do where the coordinates do not fit in doubles. */
enum { GAP_IN_DOUBLES = 50 };

/* Contact 2, then opened: two roots in even cases, none in odd ones. */
bool family_near_tangent(struct draft *d, struct request *r)
{
    int exponent =
        r->gap ? r->gap + (int)((r->index >> 1) % (uint64_t)r->gaps) : 5 + (int)((r->index >> 1) * 19 % 46);
    bool apart = r->index & 1;
    if (!make_inner_contact(d, r, 2, r->index & 2 ? SAME : OPPOSITE) || !open_gap(d, exponent, apart))
        return false;
    d->beyond = exponent > GAP_IN_DOUBLES;
    snprintf(d->note, sizeof d->note, "contact opened by 2^-%d, %s", exponent, apart ? "apart" : "two roots");
    d->planted = 0; /* at[0] is where the contact was */
    d->class_name = "";
    return true;
}
