/* Pieces that several families share. */
#include "family.h"

bool random_coin(struct request *r)
{
    return random_bits(&r->random) >> 63;
}

void random_dyadic(fmpq_t a, struct request *r, int size, int bits)
{
    int64_t most = (int64_t)size << bits, k;
    do
        k = random_between(&r->random, -most, most);
    while (k == 0);
    fmpq_set_si(a, (slong)k, 1);
    fmpq_div_2exp(a, a, (flint_bitcnt_t)bits);
}

void random_parameter(fmpq_t t, struct request *r, int degree, int budget)
{
    int bits = budget / degree;
    bits = bits < 1 ? 1 : bits > 5 ? 5 : bits;
    int64_t c = (int64_t)1 << bits;
    if (r->index % 2 == 1 && c > 2)
        c = random_between(&r->random, 3, c);
    fmpq_set_si(t, (slong)random_between(&r->random, (c + 4) / 5, 4 * c / 5), (ulong)c);
    fmpq_canonicalise(t);
}

void random_places(fmpq_t t, fmpq_t s, struct request *r, int budget)
{
    fmpq_init(t);
    fmpq_init(s);
    random_parameter(t, r, r->n, budget);
    random_parameter(s, r, r->m, budget);
}

void random_weights(struct points *p, struct request *r)
{
    for (int i = 1; i <= p->degree; i++)
        fmpq_set_si(p->w[i], (slong)1 << random_between(&r->random, 0, 3), 2);
    for (int i = 0; i <= p->degree; i++)
        fmpq_canonicalise(p->w[i]);
}

void random_slope(struct points *p, struct request *r, bool upright)
{
    slong along = 0, across = 0;
    points_set(p, 0, 0, 0);
    for (int i = 1; i <= p->degree; i++) {
        slong step = (slong)random_between(&r->random, 8, 31);
        along += step;
        across += (slong)random_between(&r->random, 1 - step, step - 1);
        points_set(p, i, upright ? across : along, upright ? along : across);
    }
}

bool finish(struct draft *d, struct request *r)
{
    slong a, b;
    fmpq_t x, y;
    do {
        a = (slong)random_between(&r->random, -3, 3);
        b = (slong)random_between(&r->random, -3, 3);
    } while (a == 0 && b == 0);
    points_turn(&d->f, a, b);
    points_turn(&d->g, a, b);
    if (random_coin(r))
        draft_reverse_g(d);
    if (!draft_scale(d))
        return false;
    fmpq_init(x);
    fmpq_init(y);
    random_dyadic(x, r, 1, 3);
    random_dyadic(y, r, 1, 3);
    points_move(&d->f, x, y);
    points_move(&d->g, x, y);
    fmpq_clear(x);
    fmpq_clear(y);
    return draft_scale(d);
}
