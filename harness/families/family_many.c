/* Oscillating pairs.  If f stays within |x| <= 1 while y swings p times between < -1 and > 1, and g stays
 * within |y| <= 1 while x swings q times, each swing of f meets each swing of g: p q solutions at the least.
 * With p q = n m these are all, and simple (Bezout). */
#include "family.h"

/* p->y: Bernstein coefficients of (9/8) T_k, elevated to the curve's degree, on a grid of 2^-20, each moved
 * by at most 2^-5; p->x: from -1 to 1 in nearly equal steps. */
static void oscillate(struct points *p, struct request *r, int k)
{
    int degree = p->degree;
    fmpz_t b;
    fmpz_init(b);
    p->degree = k;
    for (int i = 0; i <= k; i++) { /* T_k: (-1)^(k-i) C(2k, 2i) / C(k, i) */
        fmpq_set_si(p->y[i], (k - i) & 1 ? -9 : 9, 8);
        fmpz_bin_uiui(b, 2 * (ulong)k, 2 * (ulong)i);
        fmpq_mul_fmpz(p->y[i], p->y[i], b);
        fmpz_bin_uiui(b, (ulong)k, (ulong)i);
        fmpq_div_fmpz(p->y[i], p->y[i], b);
        fmpq_zero(p->x[i]);
    }
    points_elevate(p, degree);
    for (int i = 0; i <= degree; i++) {
        slong jitter = (slong)random_between(&r->random, -16384, 16384) * 2;
        slong along = (slong)random_between(&r->random, 0, 16384) * 2;
        fmpq_mul_2exp(p->y[i], p->y[i], 20);
        fmpz_fdiv_q(fmpq_numref(p->y[i]), fmpq_numref(p->y[i]), fmpq_denref(p->y[i]));
        fmpz_one(fmpq_denref(p->y[i]));
        fmpq_add_si(p->y[i], p->y[i], jitter);
        fmpq_div_2exp(p->y[i], p->y[i], 20);
        slong x = (2 * i - degree) * (1 << 20) / degree;
        fmpq_set_si(p->x[i], 2 * i < degree ? x + along : x - along, 1);
        fmpq_div_2exp(p->x[i], p->x[i], 20);
    }
    fmpz_clear(b);
}

/* Are there k + 1 increasing parameters where y is > 1 and < -1 in turn?  Tried are multiples of 1/256. |x|
 * <= 1 by its control points. */
static bool swings(const struct points *p, int k)
{
    struct shape s;
    fmpq_t t, y;
    int found = 0, last = 0;
    shape_init(&s);
    fmpq_init(t);
    fmpq_init(y);
    shape_from_points(&s, p);
    for (int i = 0; i <= 256; i++) {
        fmpq_set_si(t, i, 256);
        fmpq_canonicalise(t);
        fmpq_poly_evaluate_fmpq(y, s.y, t);
        int side = fmpq_cmp_si(y, 1) > 0 ? 1 : fmpq_cmp_si(y, -1) < 0 ? -1 : 0;
        if (side != 0 && side != last) {
            last = side;
            found++;
        }
    }
    fmpq_clear(t);
    fmpq_clear(y);
    shape_clear(&s);
    return found > k;
}

static bool cross_often(struct draft *d, struct request *r, int k, int l)
{
    oscillate(&d->f, r, k);
    oscillate(&d->g, r, l);
    if (!swings(&d->f, k) || !swings(&d->g, l))
        return false;
    for (int i = 0; i <= d->g.degree; i++)
        fmpq_swap(d->g.x[i], d->g.y[i]);
    return finish(d, r);
}

bool family_nine(struct draft *d, struct request *r)
{
    d->class_name = "transversal";
    d->count = r->n * r->m;
    return cross_often(d, r, r->n, r->m);
}

bool family_many(struct draft *d, struct request *r)
{
    int k = (int)random_between(&r->random, 2, r->n), l = (int)random_between(&r->random, 2, r->m);
    snprintf(d->note, sizeof d->note, "%d swings against %d: at least %d solutions", k, l, k * l);
    return cross_often(d, r, k, l);
}
