/* Intersection multiplicity of an isolated common zero. */
#include "exact_system.h"

#include <flint/fmpz_poly_factor.h>
#include <arb_fmpz_poly.h>

enum { PREC_FIRST = 256, PREC_LAST = 1 << 13 };

/* Number of pivots that complete elimination in ball arithmetic finds: the rank is at least that. */
static int rank_at_least(arb_ptr a, int size, slong prec)
{
    arb_t c;
    arb_init(c);
    int rank = 0;
    for (; rank < size; rank++) {
        int row = -1, col = -1;
        for (int i = rank; i < size; i++)
            for (int j = rank; j < size; j++)
                if (!arb_contains_zero(a + i * size + j) &&
                    (row < 0 ||
                     arf_cmpabs(arb_midref(a + i * size + j), arb_midref(a + row * size + col)) > 0))
                    row = i, col = j;
        if (row < 0)
            break;
        for (int j = 0; j < size && row != rank; j++)
            arb_swap(a + row * size + j, a + rank * size + j);
        for (int i = 0; i < size && col != rank; i++)
            arb_swap(a + i * size + col, a + i * size + rank);
        for (int i = rank + 1; i < size; i++) {
            arb_div(c, a + i * size + rank, a + rank * size + rank, prec);
            for (int j = rank + 1; j < size; j++)
                arb_submul(a + i * size + j, c, a + rank * size + j, prec);
        }
    }
    arb_clear(c);
    return rank;
}

/* Do p and q have at most `common` common zeros, counted on the projective line, on the line t?  By the rank
 * of Sylvester's matrix of the two restrictions. */
static bool at_most_common(const struct biv *p, const struct biv *q, const arb_t t, int common, slong prec)
{
    int size = p->m + q->m;
    arb_ptr a = _arb_vec_init(size * size), c = _arb_vec_init(p->m + 1), d = _arb_vec_init(q->m + 1);
    biv_coefficients(c, p, t, prec);
    biv_coefficients(d, q, t, prec);
    for (int i = 0; i < q->m; i++)
        for (int j = 0; j <= p->m; j++)
            arb_set(a + i * size + i + j, c + j);
    for (int i = 0; i < p->m; i++)
        for (int j = 0; j <= q->m; j++)
            arb_set(a + (q->m + i) * size + i + j, d + j);
    bool is = rank_at_least(a, size, prec) >= size - common;
    _arb_vec_clear(a, size * size);
    _arb_vec_clear(c, p->m + 1);
    _arb_vec_clear(d, q->m + 1);
    return is;
}

/* u is a root of r; its multiplicity there, 0 if the precision is too low. */
static int multiplicity_in(const fmpz_poly_t r, const arb_t u, slong prec)
{
    fmpz_poly_factor_t parts;
    arb_t v;
    int found = 0, multiplicity = 0;
    fmpz_poly_factor_init(parts);
    arb_init(v);
    fmpz_poly_factor_squarefree(parts, r);
    for (slong k = 0; k < parts->num; k++) {
        slong work = prec + 64 + labs(fmpz_poly_max_bits(parts->p + k));
        arb_fmpz_poly_evaluate_arb_horner(v, parts->p + k, u, work);
        if (arb_contains_zero(v)) {
            multiplicity = (int)parts->exp[k];
            found++;
        }
    }
    arb_clear(v);
    fmpz_poly_factor_clear(parts);
    return found == 1 ? multiplicity : 0;
}

/* The pencil u = t + lambda s. */
static int sheared(const struct exact_system *e, const struct exact_point *c, int lambda, int common,
                   slong prec)
{
    struct biv p, q;
    arb_t u;
    fmpz_poly_t r;
    int multiplicity = 0;
    arb_init(u);
    fmpz_poly_init(r);
    biv_shear(&p, &e->p, lambda);
    biv_shear(&q, &e->q, lambda);
    slong work = prec + 64 + biv_bits(&p) + biv_bits(&q);
    arb_mul_si(u, c->s.ball, lambda, work);
    arb_add(u, u, c->t.ball, work);
    if (at_most_common(&p, &q, u, common, work) &&
        biv_resultant(r, &p, &q, p.n * q.m + q.n * p.m, NULL, e->pair->deadline))
        multiplicity = multiplicity_in(r, u, prec);
    biv_clear(&p);
    biv_clear(&q);
    arb_clear(u);
    fmpz_poly_clear(r);
    return multiplicity;
}

static bool jacobian_is_regular(const struct exact_system *e, const struct exact_point *c, slong prec)
{
    struct biv d[4];
    arb_ptr v = _arb_vec_init(4);
    biv_derive_t(&d[0], &e->p);
    biv_derive_s(&d[1], &e->p);
    biv_derive_t(&d[2], &e->q);
    biv_derive_s(&d[3], &e->q);
    for (int i = 0; i < 4; i++)
        biv_value(v + i, &d[i], c->t.ball, c->s.ball, prec);
    arb_mul(v, v, v + 3, prec);
    arb_submul(v, v + 1, v + 2, prec);
    bool regular = !arb_contains_zero(v);
    for (int i = 0; i < 4; i++)
        biv_clear(&d[i]);
    _arb_vec_clear(v, 4);
    return regular;
}

int exact_multiplicity(const struct exact_system *e, struct exact_point *c)
{
    static const int slope[] = {1, 2, -1, 3, -2, 5};
    if (c->t.multiplicity == 1 || c->s.multiplicity == 1)
        return 1;
    /* On a line through (t, s) the restrictions have a common zero there of order common_*, at least. */
    int common_f = e->whole ? c->order_f + 1 : 1, common_g = e->whole ? c->order_g + 1 : 1;
    int common = common_f < common_g ? common_f : common_g, multiplicity = 0;
    struct biv p, q;
    biv_swap_variables(&p, &e->p);
    biv_swap_variables(&q, &e->q);
    for (slong k = 0, prec = PREC_FIRST; prec <= PREC_LAST && multiplicity == 0; prec *= 2, k++) {
        slong work = prec + 64 + biv_bits(&e->p) + biv_bits(&e->q);
        real_root_refine(&c->t, prec, false);
        real_root_refine(&c->s, prec, false);
        if (jacobian_is_regular(e, c, work))
            multiplicity = 1;
        else if (at_most_common(&e->p, &e->q, c->t.ball, common_g, work))
            multiplicity = c->t.multiplicity;
        else if (at_most_common(&p, &q, c->s.ball, common_f, work))
            multiplicity = c->s.multiplicity;
        else
            multiplicity = sheared(e, c, slope[k], common, prec);
    }
    biv_clear(&p);
    biv_clear(&q);
    return multiplicity;
}
