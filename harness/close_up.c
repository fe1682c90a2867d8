#include "close_up.h"

#include <math.h>
#include <string.h>

#include "case_fields.h"
#include "number.h"

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

/* Coefficients over [lo, hi] in place.  The first ones of [0, hi] come from de Casteljau at hi, those of [lo,
 * hi] from one at lo / hi of its own, whose last coefficients are kept; by symmetry hi = 0 only if the box is
 * the point 0. */
static void restrict_component(int n, mpq_t *b, const mpq_t lo, const mpq_t hi)
{
    mpq_t part, scratch;
    mpq_init(part);
    mpq_init(scratch);
    for (int r = 1; r <= n; r++)
        for (int i = n; i >= r; i--) { /* b[i] becomes the blossom (hi^r) of b[i - r..i] */
            mpq_sub(scratch, b[i], b[i - 1]);
            mpq_mul(scratch, scratch, hi);
            mpq_add(b[i], b[i - 1], scratch);
        }
    if (mpq_sgn(hi) != 0) {
        mpq_div(part, lo, hi);
        for (int r = n; r > 0; r--)
            for (int i = 0; i < r; i++)
                blend(b[i], b[i + 1], part, scratch);
    }
    mpq_clear(part);
    mpq_clear(scratch);
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
    out->alone = out->sine_bits = 0;
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
