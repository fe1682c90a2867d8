/* Random pairs made hard for programs that cut and round: crossings on cuts, slivers, scales and offsets. */
#include "family.h"

/* Control points k 2^-bits in [0, 1)^2. */
static void scatter(struct points *p, struct request *r, int bits)
{
    int64_t last = ((int64_t)1 << bits) - 1;
    for (int i = 0; i <= p->degree; i++) {
        points_set(p, i, (slong)random_between(&r->random, 0, last),
                   (slong)random_between(&r->random, 0, last));
        fmpq_div_2exp(p->x[i], p->x[i], (flint_bitcnt_t)bits);
        fmpq_div_2exp(p->y[i], p->y[i], (flint_bitcnt_t)bits);
    }
}

/* k 2^-depth strictly between 0 and 1. */
static void dyadic(fmpq_t t, struct request *r, int depth)
{
    fmpq_set_si(t, (slong)random_between(&r->random, 1, ((int64_t)1 << depth) - 1), (slong)1 << depth);
    fmpq_canonicalise(t);
}

bool family_on_cut(struct draft *d, struct request *r)
{
    int degree = r->n > r->m ? r->n : r->m, most = degree > 0 ? 24 / degree : 1, bits = 16;
    fmpq_t t, s;
    fmpq_init(t);
    fmpq_init(s);
    most = most > 6 ? 6 : most < 1 ? 1 : most;
    scatter(&d->f, r, bits);
    scatter(&d->g, r, bits);
    dyadic(t, r, 1 + (int)(r->index % (uint64_t)most));
    dyadic(s, r, 1 + (int)(r->index / (uint64_t)most % (uint64_t)most));
    draft_join(d, t, s);
    draft_plant(d, t, s, 1);
    bool simple = contact_order(d, t, s, 2, NULL) == 1;
    fmpq_clear(t);
    fmpq_clear(s);
    return simple;
}

static void flatten(struct points *p, flint_bitcnt_t by)
{
    for (int i = 0; i <= p->degree; i++)
        fmpq_div_2exp(p->y[i], p->y[i], by);
}

bool family_sliver(struct draft *d, struct request *r)
{
    static const slong turn[][2] = {{1, 0}, {0, 1}, {3, 2}, {-2, 3}, {1, 1}};
    flint_bitcnt_t j = 1 + r->index % 28;
    const slong *by = turn[r->index / 28 % 5];
    scatter(&d->f, r, 20);
    scatter(&d->g, r, 20);
    flatten(&d->f, j);
    flatten(&d->g, j);
    points_turn(&d->f, by[0], by[1]);
    points_turn(&d->g, by[0], by[1]);
    snprintf(d->note, sizeof d->note, "flattened by 2^-%d", (int)j);
    return true;
}

static void enlarge(struct points *p, int by)
{
    for (int i = 0; i <= p->degree; i++) {
        if (by < 0) {
            fmpq_div_2exp(p->x[i], p->x[i], (flint_bitcnt_t)-by);
            fmpq_div_2exp(p->y[i], p->y[i], (flint_bitcnt_t)-by);
        } else {
            fmpq_mul_2exp(p->x[i], p->x[i], (flint_bitcnt_t)by);
            fmpq_mul_2exp(p->y[i], p->y[i], (flint_bitcnt_t)by);
        }
    }
}

bool family_scaled(struct draft *d, struct request *r)
{
    enum { LARGEST = 498, STEP = 83, PLACES = 13 }; /* 2^498 is about 8e149 */
    int scale = (int)(r->index % PLACES) * STEP - LARGEST, far = (int)(r->index / PLACES % 4) * 10;
    int64_t reach = (int64_t)1 << far;
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    scatter(&d->f, r, 20);
    scatter(&d->g, r, 20);
    if (far) {
        fmpq_set_si(x, (slong)random_between(&r->random, -reach, reach), 1);
        fmpq_set_si(y, (slong)random_between(&r->random, -reach, reach), 1);
    }
    points_move(&d->f, x, y);
    points_move(&d->g, x, y);
    enlarge(&d->f, scale);
    enlarge(&d->g, scale);
    snprintf(d->note, sizeof d->note, "times 2^%d, moved by up to 2^%d of its size", scale, far);
    fmpq_clear(x);
    fmpq_clear(y);
    return true;
}

/* 0, or +-2^-e or twice that: sums of such numbers round away all but the largest, and a curve is straight,
 * or turns, in a part of it that is as short as the parameter's last digits. */
static void random_size(fmpq_t a, struct request *r)
{
    static const int shorter[] = {0, 0, 0, 10, 26, 27, 52, 53, 60, 100, 500};
    enum { SIZES = sizeof shorter / sizeof *shorter };
    int sign = (int)random_between(&r->random, 0, 5); /* 0 in two of six */
    fmpq_set_si(a, sign < 2 ? 0 : sign == 2 ? -1 : sign == 3 ? 2 : 1, 1);
    int e = shorter[random_between(&r->random, 0, SIZES - 1)];
    fmpq_div_2exp(a, a, (flint_bitcnt_t)e);
}

bool family_sizes(struct draft *d, struct request *r)
{
    struct points *p[2] = {&d->f, &d->g};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i <= p[k]->degree; i++) {
            random_size(p[k]->x[i], r);
            random_size(p[k]->y[i], r);
        }
    }
    return true;
}

bool family_point_curve(struct draft *d, struct request *r)
{
    struct points *point = r->index & 1 ? &d->g : &d->f, *other = r->index & 1 ? &d->f : &d->g;
    fmpq_t t, x, y;
    fmpq_init(t);
    fmpq_init(x);
    fmpq_init(y);
    scatter(other, r, 12);
    if (r->index / 2 % 4 == 3) { /* anywhere, else on the other curve */
        fmpq_set_si(x, (slong)random_between(&r->random, 0, 4095), 4096);
        fmpq_set_si(y, (slong)random_between(&r->random, 0, 4095), 4096);
        fmpq_canonicalise(x);
        fmpq_canonicalise(y);
    } else {
        fmpq_set_si(t, (slong)random_between(&r->random, 0, 8), 8);
        fmpq_canonicalise(t);
        points_value(x, y, other, t);
    }
    for (int i = 0; i <= point->degree; i++) {
        fmpq_set(point->x[i], x);
        fmpq_set(point->y[i], y);
    }
    d->class_name = "degenerate";
    fmpq_clear(t);
    fmpq_clear(x);
    fmpq_clear(y);
    return true;
}
