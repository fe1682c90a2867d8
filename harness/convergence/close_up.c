#include "close_up.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/case_fields.h"
#include "../cases/number.h"
#include "../run/memory.h"

/* b = b (1 - t) + a t for one step of de Casteljau's algorithm in place: c[i] between c[i] and c[i + 1]. */
static void blend(mpq_t c, const mpq_t next, const mpq_t t, mpq_t scratch)
{
    mpq_sub(scratch, next, c);
    mpq_mul(scratch, scratch, t);
    mpq_add(c, c, scratch);
}

/* Homogeneous coefficients of component k = 0, 1, 2: w X, w Y, w. */
static void homogeneous(const struct case_curve *c, int k, mpq_t *out)
{
    mpq_t *from = k == 0 ? c->x : k == 1 ? c->y : c->w;
    for (int i = 0; i <= c->degree; i++) {
        mpq_set(out[i], from[i]);
        if (k < 2 && c->rational)
            mpq_mul(out[i], out[i], c->w[i]);
    }
}

void curve_point_exact(const struct case_curve *c, const mpq_t t, mpq_t out[3])
{
    mpq_t *b = rationals_new(c->degree + 2);
    for (int k = 0; k < 3; k++) {
        homogeneous(c, k, b);
        for (int r = c->degree; r > 0; r--)
            for (int i = 0; i < r; i++)
                blend(b[i], b[i + 1], t, b[c->degree + 1]);
        mpq_set(out[k], b[0]);
    }
    rationals_free(b, c->degree + 2);
}

/* Applies a step of de Casteljau's algorithm at u / q to `count` + 1 integers, without the division by q. */
static void blend_integers(int count, mpz_t *v, const mpz_t u, const mpz_t q, mpz_t scratch)
{
    for (int i = 0; i < count; i++) { /* q v[i] + u (v[i + 1] - v[i]) */
        mpz_sub(scratch, v[i + 1], v[i]);
        mpz_mul(v[i], v[i], q);
        mpz_addmul(v[i], scratch, u);
    }
}

/* Numerators of b over their common denominator, and of lo and hi over theirs. */
struct integers {
    mpz_t lo, hi, q, denominator, scratch, *at, *part; /* n + 1 in each array */
};

static void integers_make(int n, mpq_t *b, const mpq_t lo, const mpq_t hi, struct integers *z)
{
    mpz_inits(z->lo, z->hi, z->q, z->denominator, z->scratch, NULL);
    z->at = memory_new((size_t)n + 1, sizeof *z->at);
    z->part = memory_new((size_t)n + 1, sizeof *z->part);
    mpz_set_si(z->denominator, 1);
    for (int i = 0; i <= n; i++)
        mpz_lcm(z->denominator, z->denominator, mpq_denref(b[i]));
    for (int i = 0; i <= n; i++) {
        mpz_inits(z->at[i], z->part[i], NULL);
        mpz_divexact(z->at[i], z->denominator, mpq_denref(b[i]));
        mpz_mul(z->at[i], z->at[i], mpq_numref(b[i]));
    }
    mpz_lcm(z->q, mpq_denref(lo), mpq_denref(hi));
    mpz_divexact(z->lo, z->q, mpq_denref(lo));
    mpz_mul(z->lo, z->lo, mpq_numref(lo));
    mpz_divexact(z->hi, z->q, mpq_denref(hi));
    mpz_mul(z->hi, z->hi, mpq_numref(hi));
}

static void integers_clear(int n, struct integers *z)
{
    for (int i = 0; i <= n; i++)
        mpz_clears(z->at[i], z->part[i], NULL);
    free(z->at);
    free(z->part);
    mpz_clears(z->lo, z->hi, z->q, z->denominator, z->scratch, NULL);
}

/* Coefficients over [lo, hi] in place: number i is the blossom at (lo^(n - i), hi^i).  In integers, for the
 * fractions of intermediate results would be reduced at every step. */
static void restrict_component(int n, mpq_t *b, const mpq_t lo, const mpq_t hi)
{
    struct integers z;
    integers_make(n, b, lo, hi, &z);
    mpz_pow_ui(z.scratch, z.q, (unsigned long)n);
    mpz_mul(z.denominator, z.denominator, z.scratch);
    for (int i = n; i >= 0; i--) {
        for (int k = 0; k <= i; k++)
            mpz_set(z.part[k], z.at[k]);
        for (int r = i; r > 0; r--)
            blend_integers(r, z.part, z.hi, z.q, z.scratch);
        mpz_set(mpq_numref(b[i]), z.part[0]);
        mpz_set(mpq_denref(b[i]), z.denominator);
        mpq_canonicalize(b[i]);
        blend_integers(i, z.at, z.lo, z.q,
                       z.scratch); /* at: n - i + 1 steps at lo so far, i coefficients are left */
    }
    integers_clear(n, &z);
}

void curve_restrict(const struct case_curve *c, const mpq_t lo, const mpq_t hi, mpq_t origin[2],
                    struct case_curve *out)
{
    int length = c->degree + 1;
    memset(out, 0, sizeof *out);
    out->degree = c->degree;
    out->rational = c->rational;
    out->x = rationals_new(length);
    out->y = rationals_new(length);
    out->w = rationals_new(length);
    mpq_init(out->lo);
    mpq_init(out->hi);
    mpq_set_ui(out->hi, 1, 1);
    mpq_t *const part[3] = {out->x, out->y, out->w};
    for (int k = 0; k < 3; k++) {
        homogeneous(c, k, part[k]);
        restrict_component(c->degree, part[k], lo, hi);
    }
    for (int i = 0; i < length; i++)
        for (int k = 0; k < 2; k++) {
            mpq_div(part[k][i], part[k][i], out->w[i]);
            mpq_sub(part[k][i], part[k][i], origin[k]);
        }
}

void curve_clear(struct case_curve *c)
{
    rationals_free(c->x, c->degree + 1);
    rationals_free(c->y, c->degree + 1);
    rationals_free(c->w, c->degree + 1);
    mpq_clear(c->lo);
    mpq_clear(c->hi);
}

/* 2^-bits to 20 bits of the significand. */
static void power_of_two(double bits, mpq_t q)
{
    double whole = ceil(bits);
    mpq_set_d(q, nearbyint(ldexp(exp2(whole - bits), 20)));
    number_scale(q, -20 - (long)whole);
}

/* [t - part x, t + (1 - part) x] within [0, 1]. */
static void box_around(const mpq_t t, double bits, int numerator, mpq_t lo, mpq_t hi)
{
    mpq_t x, step, one;
    mpq_inits(x, step, one, NULL);
    power_of_two(bits, x);
    mpq_set_si(one, 1, 1);
    mpq_set_si(step, numerator, 20);
    mpq_mul(step, step, x);
    mpq_sub(lo, t, step);
    mpq_add(hi, lo, x);
    if (mpq_sgn(lo) < 0)
        mpq_set_si(lo, 0, 1);
    if (mpq_cmp(hi, one) > 0)
        mpq_set(hi, one);
    mpq_clears(x, step, one, NULL);
}

enum { PART_F = 7, PART_G = 12 }; /* twentieths of the box that lie below the solution */

void close_up_make(const struct test_case *c, const struct known_solution *z, double bits_x, double bits_y,
                   bool exchanged, struct test_case *out)
{
    const struct case_curve *first = exchanged ? &c->g : &c->f, *second = exchanged ? &c->f : &c->g;
    mpq_t lo, hi, *point = rationals_new(3);
    mpq_inits(lo, hi, NULL);
    curve_point_exact(&c->f, z->t, point);
    mpq_div(point[0], point[0], point[2]);
    mpq_div(point[1], point[1], point[2]);
    memset(out, 0, sizeof *out);
    box_around(exchanged ? z->s : z->t, bits_x, PART_F, lo, hi);
    curve_restrict(first, lo, hi, point, &out->f);
    box_around(exchanged ? z->t : z->s, bits_y, PART_G, lo, hi);
    curve_restrict(second, lo, hi, point, &out->g);
    mpq_clears(lo, hi, NULL);
    rationals_free(point, 3);
}

static void locate(const mpq_t t, double bits, int numerator, mpq_t out)
{
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    box_around(t, bits, numerator, lo, hi);
    mpq_sub(hi, hi, lo);
    mpq_sub(out, t, lo);
    mpq_div(out, out, hi);
    mpq_clears(lo, hi, NULL);
}

void close_up_solution(const struct known_solution *z, double bits_x, double bits_y, bool exchanged,
                       struct known_solution *out)
{
    mpq_inits(out->t, out->s, NULL);
    locate(exchanged ? z->s : z->t, bits_x, PART_F, out->t);
    locate(exchanged ? z->t : z->s, bits_y, PART_G, out->s);
    out->bits = z->bits - fmax(bits_x, bits_y) - 1;
    out->multiplicity = z->multiplicity;
    out->alone = out->extent = out->sine_bits = 0;
}

/* log2 |q|; -infinite for 0. */
static double rational_log2(const mpq_t q)
{
    long up, down;
    double a = mpz_get_d_2exp(&up, mpq_numref(q)), b = mpz_get_d_2exp(&down, mpq_denref(q));
    return log2(fabs(a / b)) + (double)(up - down);
}

static double largest_log2(const struct case_curve *c)
{
    double most = -INFINITY;
    for (int i = 0; i <= c->degree; i++)
        most = fmax(most, fmax(rational_log2(c->x[i]), rational_log2(c->y[i])));
    return most;
}

double extent_bits(const struct test_case *c)
{
    return -fmax(largest_log2(&c->f), largest_log2(&c->g));
}

void close_up_clear(struct test_case *c)
{
    curve_clear(&c->f);
    curve_clear(&c->g);
}
