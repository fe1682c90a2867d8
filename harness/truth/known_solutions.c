#include "known_solutions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/case_fields.h"
#include "../convergence/close_up.h"
#include "exact.h"
#include "../cases/number.h"
#include "../run/memory.h"

static void to_local(const struct case_curve *c, const mpq_t t, mpq_t out)
{
    mpq_t width;
    mpq_init(width);
    mpq_sub(width, c->hi, c->lo);
    mpq_sub(out, t, c->lo);
    mpq_div(out, out, width);
    mpq_clear(width);
}

/* f(t) = g(s) exactly, for local parameters? */
static bool is_solution(const struct test_case *c, const struct known_solution *z)
{
    mpq_t *a = rationals_new(6);
    bool same = true;
    curve_point_exact(&c->f, z->t, a);
    curve_point_exact(&c->g, z->s, a + 3);
    for (int k = 0; k < 2; k++) {
        mpq_mul(a[k], a[k], a[5]);
        mpq_mul(a[3 + k], a[3 + k], a[2]);
        same = same && mpq_equal(a[k], a[3 + k]);
    }
    rationals_free(a, 6);
    return same;
}

/* The chord of c from t to a parameter 2^-CHORD away, divided by that: a direction right to as many bits. */
static void direction(const struct case_curve *c, const mpq_t t, double out[2])
{
    enum { CHORD = 200 };
    mpq_t other, *a = rationals_new(6);
    mpq_init(other);
    mpq_set_si(other, mpq_cmp_ui(t, 1, 2) > 0 ? -1 : 1, 1);
    number_scale(other, -CHORD);
    mpq_add(other, other, t);
    curve_point_exact(c, t, a);
    curve_point_exact(c, other, a + 3);
    for (int k = 0; k < 2; k++) {
        mpq_div(a[k], a[k], a[2]);
        mpq_div(a[3 + k], a[3 + k], a[5]);
        mpq_sub(a[k], a[3 + k], a[k]);
        number_scale(a[k], CHORD);
        out[k] = mpq_get_d(a[k]);
    }
    mpq_clear(other);
    rationals_free(a, 6);
}

static double sine_bits(const struct test_case *c, const struct known_solution *z)
{
    double a[2], b[2];
    if (z->multiplicity != 1)
        return 0;
    direction(&c->f, z->t, a);
    direction(&c->g, z->s, b);
    double bits = -log2(fabs(a[0] * b[1] - a[1] * b[0]) / (hypot(a[0], a[1]) * hypot(b[0], b[1])));
    return isfinite(bits) ? bits : 0;
}

/* -log2 |a - b|, at most BITS. */
static double distance_bits(const mpq_t a, const mpq_t b)
{
    enum { BITS = 1000 };
    mpq_t d;
    mpq_init(d);
    mpq_sub(d, a, b);
    double distance = fabs(mpq_get_d(d));
    mpq_clear(d);
    return distance > 0 ? fmin(-log2(distance), BITS) : BITS;
}

static double alone_bits(const struct known_solutions *k, int i)
{
    double bits = 0;
    for (int j = 0; j < k->count; j++)
        if (j != i)
            bits = fmax(bits,
                        fmin(distance_bits(k->at[i].t, k->at[j].t), distance_bits(k->at[i].s, k->at[j].s)));
    return bits;
}

/* Copies c->expected; digits: of what is not exact. */
static void take(const struct test_case *c, int digits, struct known_solutions *k)
{
    struct test_case whole;
    k->count = c->expected.count;
    k->at = memory_new((size_t)k->count + 1, sizeof *k->at);
    for (int i = 0; i < k->count; i++) {
        const struct case_solution *from = &c->expected.at[i];
        struct known_solution *to = &k->at[i];
        mpq_inits(to->t, to->s, NULL);
        to_local(&c->f, from->t, to->t);
        to_local(&c->g, from->s, to->s);
        to->bits = from->exact ? INFINITY : digits * log2(10) - 1; /* of at most 1: significant digits */
        to->multiplicity = from->multiplicity;
        to->sine_bits = sine_bits(c, to);
        close_up_make(c, to, 0, 0, false, &whole);
        to->extent = extent_bits(&whole);
        close_up_clear(&whole);
    }
    for (int i = 0; i < k->count; i++)
        k->at[i].alone = alone_bits(k, i);
}

static bool are_exact(const struct test_case *c, const struct known_solutions *k)
{
    bool all = true;
    for (int i = 0; i < k->count; i++)
        all = all && c->expected.at[i].exact && k->at[i].multiplicity > 0 && is_solution(c, &k->at[i]);
    return all;
}

const char *known_solutions_make(struct test_case *c, int digits, double seconds, struct known_solutions *k)
{
    struct exact_limits limits = {digits < 40 ? 40 : digits, seconds};
    if (c->expected.known && (c->expected.count > 0 || c->expected.overlaps == 0)) {
        take(c, 0, k);
        if (are_exact(c, k))
            return NULL;
        known_solutions_clear(k);
    }
    const char *why_not = exact_solve(c, &limits);
    if (!why_not)
        take(c, limits.digits, k);
    return why_not;
}

void known_solutions_clear(struct known_solutions *k)
{
    for (int i = 0; i < k->count; i++)
        mpq_clears(k->at[i].t, k->at[i].s, NULL);
    free(k->at);
    k->at = NULL;
    k->count = 0;
}
