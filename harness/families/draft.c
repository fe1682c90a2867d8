#include <string.h>

#include "draft.h"

static void points_init(struct points *p)
{
    memset(p, 0, sizeof *p);
    for (int i = 0; i <= DRAFT_DEGREE_MAX; i++) {
        fmpq_init(p->x[i]);
        fmpq_init(p->y[i]);
        fmpq_init(p->w[i]);
    }
}

static void points_clear(struct points *p)
{
    for (int i = 0; i <= DRAFT_DEGREE_MAX; i++) {
        fmpq_clear(p->x[i]);
        fmpq_clear(p->y[i]);
        fmpq_clear(p->w[i]);
    }
}

static void points_reset(struct points *p, int degree, bool rational)
{
    p->degree = degree;
    p->rational = rational;
    for (int i = 0; i <= DRAFT_DEGREE_MAX; i++) {
        fmpq_zero(p->x[i]);
        fmpq_zero(p->y[i]);
        fmpq_one(p->w[i]);
    }
}

void draft_init(struct draft *d)
{
    memset(d, 0, sizeof *d);
    points_init(&d->f);
    points_init(&d->g);
    for (int i = 0; i < PLANTED_MAX; i++) {
        fmpq_init(d->at[i].t);
        fmpq_init(d->at[i].s);
        fmpq_init(d->overlap[i]);
    }
    fmpq_init(d->gap);
}

void draft_clear(struct draft *d)
{
    points_clear(&d->f);
    points_clear(&d->g);
    for (int i = 0; i < PLANTED_MAX; i++) {
        fmpq_clear(d->at[i].t);
        fmpq_clear(d->at[i].s);
        fmpq_clear(d->overlap[i]);
    }
    fmpq_clear(d->gap);
}

void draft_reset(struct draft *d, int n, int m, bool rational)
{
    points_reset(&d->f, n, rational);
    points_reset(&d->g, m, rational);
    d->class_name = "";
    d->note[0] = '\0';
    d->planted = 0;
    d->complete = d->overlaps = d->beyond = false;
    d->count = -1;
    fmpq_zero(d->gap);
}

void shape_init(struct shape *s)
{
    fmpq_poly_init(s->x);
    fmpq_poly_init(s->y);
    fmpq_poly_init(s->w);
}

void shape_clear(struct shape *s)
{
    fmpq_poly_clear(s->x);
    fmpq_poly_clear(s->y);
    fmpq_poly_clear(s->w);
}

static void multiply_binomial(fmpq_t c, int n, int k)
{
    fmpz_t b;
    fmpz_init(b);
    fmpz_bin_uiui(b, (ulong)n, (ulong)k);
    fmpq_mul_fmpz(c, c, b);
    fmpz_clear(b);
}

static void divide_binomial(fmpq_t c, int n, int k)
{
    fmpz_t b;
    fmpz_init(b);
    fmpz_bin_uiui(b, (ulong)n, (ulong)k);
    fmpq_div_fmpz(c, c, b);
    fmpz_clear(b);
}

/* Bernstein coefficients of degree n: c[i] = sum over j <= i of a[j] C(i,j) / C(n,j). */
static void bernstein_from_power(fmpq_t *c, int n, const fmpq_poly_t a)
{
    fmpq_t term;
    fmpq_init(term);
    for (int i = 0; i <= n; i++) {
        fmpq_zero(c[i]);
        for (int j = 0; j <= i; j++) {
            fmpq_poly_get_coeff_fmpq(term, a, j);
            multiply_binomial(term, i, j);
            divide_binomial(term, n, j);
            fmpq_add(c[i], c[i], term);
        }
    }
    fmpq_clear(term);
}

/* a[j] = C(n,j) times the j-th forward difference of c. */
static void power_from_bernstein(fmpq_poly_t a, int n, fmpq_t *c)
{
    fmpq_t sum, term;
    fmpq_init(sum);
    fmpq_init(term);
    fmpq_poly_zero(a);
    for (int j = 0; j <= n; j++) {
        fmpq_zero(sum);
        for (int i = 0; i <= j; i++) {
            fmpq_set(term, c[i]);
            multiply_binomial(term, j, i);
            if ((j - i) & 1)
                fmpq_sub(sum, sum, term);
            else
                fmpq_add(sum, sum, term);
        }
        multiply_binomial(sum, n, j);
        fmpq_poly_set_coeff_fmpq(a, j, sum);
    }
    fmpq_clear(sum);
    fmpq_clear(term);
}

void points_from_shape(struct points *p, int degree, const struct shape *s)
{
    p->degree = degree;
    bernstein_from_power(p->x, degree, s->x);
    bernstein_from_power(p->y, degree, s->y);
    bernstein_from_power(p->w, degree, s->w);
    for (int i = 0; i <= degree; i++) {
        fmpq_div(p->x[i], p->x[i], p->w[i]);
        fmpq_div(p->y[i], p->y[i], p->w[i]);
    }
}

void shape_from_points(struct shape *s, const struct points *p)
{
    struct points h;
    points_init(&h);
    for (int i = 0; i <= p->degree; i++) {
        fmpq_mul(h.x[i], p->x[i], p->w[i]);
        fmpq_mul(h.y[i], p->y[i], p->w[i]);
        fmpq_set(h.w[i], p->w[i]);
    }
    power_from_bernstein(s->x, p->degree, h.x);
    power_from_bernstein(s->y, p->degree, h.y);
    power_from_bernstein(s->w, p->degree, h.w);
    points_clear(&h);
}

void points_set(struct points *p, int i, slong x, slong y)
{
    fmpq_set_si(p->x[i], x, 1);
    fmpq_set_si(p->y[i], y, 1);
}

void points_copy(struct points *p, const struct points *q)
{
    p->degree = q->degree;
    p->rational = q->rational;
    for (int i = 0; i <= q->degree; i++) {
        fmpq_set(p->x[i], q->x[i]);
        fmpq_set(p->y[i], q->y[i]);
        fmpq_set(p->w[i], q->w[i]);
    }
}

void points_elevate(struct points *p, int degree)
{
    struct shape s;
    if (degree == p->degree)
        return;
    shape_init(&s);
    shape_from_points(&s, p);
    points_from_shape(p, degree, &s);
    shape_clear(&s);
}

void points_reverse(struct points *p)
{
    for (int i = 0, j = p->degree; i < j; i++, j--) {
        fmpq_swap(p->x[i], p->x[j]);
        fmpq_swap(p->y[i], p->y[j]);
        fmpq_swap(p->w[i], p->w[j]);
    }
}

void points_value(fmpq_t x, fmpq_t y, const struct points *p, const fmpq_t t)
{
    struct shape s;
    fmpq_t w;
    shape_init(&s);
    fmpq_init(w);
    shape_from_points(&s, p);
    fmpq_poly_evaluate_fmpq(x, s.x, t);
    fmpq_poly_evaluate_fmpq(y, s.y, t);
    fmpq_poly_evaluate_fmpq(w, s.w, t);
    fmpq_div(x, x, w);
    fmpq_div(y, y, w);
    fmpq_clear(w);
    shape_clear(&s);
}

void points_move(struct points *p, const fmpq_t x, const fmpq_t y)
{
    for (int i = 0; i <= p->degree; i++) {
        fmpq_add(p->x[i], p->x[i], x);
        fmpq_add(p->y[i], p->y[i], y);
    }
}

void points_turn(struct points *p, slong a, slong b)
{
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    for (int i = 0; i <= p->degree; i++) {
        fmpq_mul_si(x, p->x[i], b);
        fmpq_mul_si(y, p->y[i], b);
        fmpq_mul_si(p->x[i], p->x[i], a);
        fmpq_mul_si(p->y[i], p->y[i], a);
        fmpq_sub(p->x[i], p->x[i], y);
        fmpq_add(p->y[i], p->y[i], x);
    }
    fmpq_clear(x);
    fmpq_clear(y);
}
