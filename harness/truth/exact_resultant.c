/* Resultants of integer polynomials in two variables: evaluation and interpolation modulo many primes. */
#include "exact_poly.h"

#include <stdlib.h>
#include <flint/nmod_poly.h>
#include <flint/ulong_extras.h>

/* The k-th prime above 2^62; the table grows as it is asked for. */
static mp_limb_t large_prime(int k)
{
    enum { STEP = 64 };
    static mp_limb_t *table;
    static int known, room;
    while (known <= k) {
        if (known == room)
            table = realloc(table, (size_t)(room += STEP) * sizeof *table);
        table[known] = n_nextprime(known ? table[known - 1] : UWORD(1) << 62, 0);
        known++;
    }
    return table[k];
}

/* A polynomial in two variables modulo a prime; column j is a polynomial in t of length[j] coefficients. */
struct residue {
    int m;
    mp_limb_t *c;
    int *length;
};

static void residue_init(struct residue *r, const struct biv *p)
{
    r->m = p->m;
    r->c = malloc((size_t)(slong)(p->n + 1) * (p->m + 1) * sizeof *r->c);
    r->length = malloc((size_t)(p->m + 1) * sizeof *r->length);
    for (int j = 0; j <= p->m; j++) {
        r->length[j] = p->n + 1;
        while (r->length[j] > 0 && fmpz_is_zero(biv_at(p, r->length[j] - 1, j)))
            r->length[j]--;
    }
}

static void residue_clear(struct residue *r)
{
    free(r->c);
    free(r->length);
}

static void residue_set(struct residue *r, const struct biv *p, nmod_t mod)
{
    for (int j = 0; j <= p->m; j++)
        for (int i = 0; i < r->length[j]; i++)
            r->c[j * (p->n + 1) + i] = fmpz_get_nmod(biv_at(p, i, j), mod);
}

/* to(s) = r(t, s). */
static void residue_value(nmod_poly_t to, const struct residue *r, int n, mp_limb_t t, nmod_t mod)
{
    nmod_poly_fit_length(to, r->m + 1);
    for (int j = 0; j <= r->m; j++) {
        mp_limb_t sum = 0;
        for (int i = r->length[j] - 1; i >= 0; i--)
            sum = nmod_add(nmod_mul(sum, t, mod), r->c[j * (n + 1) + i], mod);
        to->coeffs[j] = sum;
    }
    to->length = r->m + 1;
    _nmod_poly_normalise(to);
}

/* Resultant of a and b as polynomials of formal degrees m and l: a lower true degree of one of them brings in
 * a power of the other's leading coefficient. */
static mp_limb_t formal_resultant(const nmod_poly_t a, const nmod_poly_t b, int m, int l, nmod_t mod)
{
    if (a->length == 0 || b->length == 0)
        return m + l == 0;
    int i = m + 1 - (int)a->length, j = l + 1 - (int)b->length;
    if (i > 0 && j > 0)
        return 0;
    mp_limb_t r = nmod_poly_resultant(a, b);
    if (i > 0) {
        r = nmod_mul(r, nmod_pow_ui(b->coeffs[l], (ulong)i, mod), mod);
        if (i % 2 && l % 2)
            r = nmod_neg(r, mod);
    }
    if (j > 0)
        r = nmod_mul(r, nmod_pow_ui(a->coeffs[m], (ulong)j, mod), mod);
    return r;
}

/* log2 of the sum of the absolute coefficients, rounded up. */
static slong norm_bits(const struct biv *p)
{
    fmpz_t sum;
    fmpz_init(sum);
    for (slong i = 0; i < (slong)(p->n + 1) * (p->m + 1); i++)
        if (fmpz_sgn(p->c + i) < 0)
            fmpz_sub(sum, sum, p->c + i);
        else
            fmpz_add(sum, sum, p->c + i);
    slong bits = (slong)fmpz_bits(sum);
    fmpz_clear(sum);
    return bits;
}

/* The resultant modulo one prime; false if it has too few points where w is not 0. */
static bool resultant_modulo(nmod_poly_t r, struct residue *a, struct residue *b, const struct biv *p,
                             const struct biv *q, int degree, const fmpz_poly_struct *w, mp_limb_t *point)
{
    nmod_t mod = r->mod;
    mp_limb_t *value = point + degree + 1;
    nmod_poly_t x, y, v;
    nmod_poly_init_mod(x, mod);
    nmod_poly_init_mod(y, mod);
    nmod_poly_init_mod(v, mod);
    residue_set(a, p, mod);
    residue_set(b, q, mod);
    if (w)
        fmpz_poly_get_nmod_poly(v, w);
    int k = 0;
    for (mp_limb_t t = 0; k <= degree && t < (mp_limb_t)degree + 4096; t++) {
        mp_limb_t d = w ? nmod_poly_evaluate_nmod(v, t) : 1;
        if (d == 0)
            continue;
        residue_value(x, a, p->n, t, mod);
        residue_value(y, b, q->n, t, mod);
        mp_limb_t e = formal_resultant(x, y, p->m, q->m, mod);
        if (d != 1)
            e = nmod_mul(e, n_invmod(nmod_pow_ui(d, (ulong)p->m, mod), mod.n), mod);
        point[k] = t;
        value[k++] = e;
    }
    if (k > degree)
        nmod_poly_interpolate_nmod_vec(r, point, value, degree + 1);
    nmod_poly_clear(x);
    nmod_poly_clear(y);
    nmod_poly_clear(v);
    return k > degree;
}

bool biv_resultant(fmpz_poly_t r, const struct biv *p, const struct biv *q, int degree,
                   const fmpz_poly_struct *w, double deadline)
{
    slong bound = q->m * norm_bits(p) + p->m * norm_bits(q) + 2 + (w ? degree : 0), bits = 0;
    mp_limb_t *point = malloc(2 * (size_t)(degree + 1) * sizeof *point);
    struct residue a, b;
    fmpz_t modulus;
    bool in_time = true;
    residue_init(&a, p);
    residue_init(&b, q);
    fmpz_init_set_ui(modulus, 1);
    fmpz_poly_zero(r);
    for (int k = 0; bits <= bound && in_time; k++) {
        nmod_poly_t part;
        nmod_poly_init(part, large_prime(k));
        if (resultant_modulo(part, &a, &b, p, q, degree, w, point)) {
            if (bits == 0)
                fmpz_poly_set_nmod_poly(r, part);
            else
                fmpz_poly_CRT_ui(r, r, modulus, part, 1);
            fmpz_mul_ui(modulus, modulus, part->mod.n);
            bits += 62;
        }
        nmod_poly_clear(part);
        in_time = deadline == 0 || exact_clock() < deadline;
    }
    fmpz_clear(modulus);
    residue_clear(&a);
    residue_clear(&b);
    free(point);
    return in_time;
}
