/* Integer polynomials in two variables. */
#include "exact_poly.h"

#include <stdlib.h>
#include <time.h>
#include <flint/fmpz_vec.h>

double exact_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static slong terms(const struct biv *p)
{
    return (slong)(p->n + 1) * (p->m + 1);
}

void biv_init(struct biv *p, int n, int m)
{
    p->n = n;
    p->m = m;
    p->c = _fmpz_vec_init(terms(p));
}

void biv_clear(struct biv *p)
{
    _fmpz_vec_clear(p->c, terms(p));
    p->c = NULL;
}

bool biv_is_zero(const struct biv *p)
{
    return _fmpz_vec_is_zero(p->c, terms(p));
}

slong biv_bits(const struct biv *p)
{
    return labs(_fmpz_vec_max_bits(p->c, terms(p)));
}

void biv_make_primitive(struct biv *p)
{
    fmpz_t content;
    fmpz_init(content);
    _fmpz_vec_content(content, p->c, terms(p));
    if (!fmpz_is_zero(content) && !fmpz_is_one(content))
        _fmpz_vec_scalar_divexact_fmpz(p->c, p->c, terms(p), content);
    fmpz_clear(content);
}

void biv_set_cross(struct biv *p, const fmpz_poly_t a, const fmpz_poly_t b, const fmpz_poly_t c,
                   const fmpz_poly_t d)
{
    for (slong i = 0; i <= p->n; i++)
        for (slong j = 0; j <= p->m; j++) {
            fmpz *e = biv_at(p, (int)i, (int)j);
            fmpz_zero(e);
            if (i < a->length && j < b->length)
                fmpz_addmul(e, a->coeffs + i, b->coeffs + j);
            if (i < c->length && j < d->length)
                fmpz_submul(e, c->coeffs + i, d->coeffs + j);
        }
    biv_make_primitive(p);
}

void biv_trim(struct biv *p)
{
    int n = 0, m = 0;
    for (int i = 0; i <= p->n; i++)
        for (int j = 0; j <= p->m; j++)
            if (!fmpz_is_zero(biv_at(p, i, j))) {
                n = i > n ? i : n;
                m = j > m ? j : m;
            }
    struct biv r;
    biv_init(&r, n, m);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            fmpz_set(biv_at(&r, i, j), biv_at(p, i, j));
    biv_clear(p);
    *p = r;
}

void biv_swap_variables(struct biv *to, const struct biv *from)
{
    biv_init(to, from->m, from->n);
    for (int i = 0; i <= from->n; i++)
        for (int j = 0; j <= from->m; j++)
            fmpz_set(biv_at(to, j, i), biv_at(from, i, j));
}

void biv_shear(struct biv *to, const struct biv *from, int lambda)
{
    fmpz_t b;
    fmpz_init(b);
    biv_init(to, from->n, from->n + from->m);
    for (int i = 0; i <= from->n; i++)
        for (int k = 0; k <= i; k++) {
            fmpz_bin_uiui(b, i, k);
            for (int e = 0; e < i - k; e++)
                fmpz_mul_si(b, b, -lambda);
            for (int j = 0; j <= from->m; j++)
                fmpz_addmul(biv_at(to, k, i - k + j), b, biv_at(from, i, j));
        }
    fmpz_clear(b);
    biv_trim(to);
}

void biv_derive_t(struct biv *to, const struct biv *from)
{
    biv_init(to, from->n > 0 ? from->n - 1 : 0, from->m);
    for (int i = 1; i <= from->n; i++)
        for (int j = 0; j <= from->m; j++)
            fmpz_mul_si(biv_at(to, i - 1, j), biv_at(from, i, j), i);
}

void biv_derive_s(struct biv *to, const struct biv *from)
{
    biv_init(to, from->n, from->m > 0 ? from->m - 1 : 0);
    for (int i = 0; i <= from->n; i++)
        for (int j = 1; j <= from->m; j++)
            fmpz_mul_si(biv_at(to, i, j - 1), biv_at(from, i, j), j);
}

void biv_restrict_t(fmpz_poly_t to, const struct biv *from, const fmpq_t t)
{
    fmpz_t a, b, sum;
    fmpz_init(a);
    fmpz_init(b);
    fmpz_init(sum);
    fmpz_poly_zero(to);
    for (int j = 0; j <= from->m; j++) {
        fmpz_zero(sum); /* sum c_i num^i den^(n-i), by Horner with a running power of den */
        fmpz_one(b);
        for (int i = from->n; i >= 0; i--) {
            fmpz_mul(sum, sum, fmpq_numref(t));
            fmpz_mul(a, biv_at(from, i, j), b);
            fmpz_add(sum, sum, a);
            fmpz_mul(b, b, fmpq_denref(t));
        }
        fmpz_poly_set_coeff_fmpz(to, j, sum);
    }
    fmpz_clear(a);
    fmpz_clear(b);
    fmpz_clear(sum);
}

void biv_coefficients(arb_ptr to, const struct biv *p, const arb_t t, slong prec)
{
    for (int j = 0; j <= p->m; j++) {
        int i = p->n;
        while (i > 0 && fmpz_is_zero(biv_at(p, i, j)))
            i--;
        arb_set_round_fmpz(to + j, biv_at(p, i, j), prec);
        while (i-- > 0) {
            arb_mul(to + j, to + j, t, prec);
            arb_add_fmpz(to + j, to + j, biv_at(p, i, j), prec);
        }
    }
}

void biv_value(arb_t value, const struct biv *p, const arb_t t, const arb_t s, slong prec)
{
    arb_ptr c = _arb_vec_init(p->m + 1);
    arb_t sum;
    arb_init(sum);
    biv_coefficients(c, p, t, prec);
    for (int j = p->m; j >= 0; j--) {
        arb_mul(sum, sum, s, prec);
        arb_add(sum, sum, c + j, prec);
    }
    arb_swap(value, sum);
    arb_clear(sum);
    _arb_vec_clear(c, p->m + 1);
}
