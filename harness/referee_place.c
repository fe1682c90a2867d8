#include "referee_place.h"

#include <math.h>

#include "case_fields.h"

enum { POLISH_BITS = 384 };

/* ---- H at one point, at POLISH_BITS and exactly ------------------------------------------------------- */

/* Error below 2^-(POLISH_BITS - 16): n stages of mpf, |coefficients| <= 1, |1 - t| + |t| <= 33/32. */
static void value_polished(const struct referee_curve *c, const mpf_t t, mpf_t out[3])
{
    int n = c->degree;
    mpf_t b[QUAD_DEGREE_MAX + 1], u, d;
    mpf_init2(u, POLISH_BITS);
    mpf_init2(d, POLISH_BITS);
    for (int i = 0; i <= n; i++)
        mpf_init2(b[i], POLISH_BITS);
    mpf_ui_sub(u, 1, t);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i <= n; i++)
            mpf_set_q(b[i], c->at[k * (n + 1) + i]);
        for (int j = 1; j <= n; j++)
            for (int i = 0; i <= n - j; i++) {
                mpf_mul(d, t, b[i + 1]);
                mpf_mul(b[i], u, b[i]);
                mpf_add(b[i], b[i], d);
            }
        mpf_set(out[k], b[0]);
    }
    for (int i = 0; i <= n; i++)
        mpf_clear(b[i]);
    mpf_clears(u, d, NULL);
}

/* H rounded to double; for polynomial pairs the weights are 1. */
static void system_polished(const struct referee_pair *p, mpf_t z[2], double h[2])
{
    mpf_t f[3], g[3], d;
    mpf_init2(d, POLISH_BITS);
    for (int k = 0; k < 3; k++) {
        mpf_init2(f[k], POLISH_BITS);
        mpf_init2(g[k], POLISH_BITS);
    }
    value_polished(&p->f, z[0], f);
    value_polished(&p->g, z[1], g);
    for (int k = 0; k < 2; k++) {
        mpf_mul(f[k], f[k], g[2]);
        mpf_mul(d, g[k], f[2]);
        mpf_sub(d, f[k], d);
        h[k] = mpf_get_d(d);
    }
    for (int k = 0; k < 3; k++)
        mpf_clears(f[k], g[k], NULL);
    mpf_clear(d);
}

static void value_exact(const struct referee_curve *c, const mpq_t t, mpq_t out[3])
{
    int n = c->degree;
    mpq_t *b = rationals_new(n + 1), u, d;
    mpq_inits(u, d, NULL);
    mpq_set_ui(u, 1, 1);
    mpq_sub(u, u, t);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i <= n; i++)
            mpq_set(b[i], c->at[k * (n + 1) + i]);
        for (int j = 1; j <= n; j++)
            for (int i = 0; i <= n - j; i++) {
                mpq_mul(d, t, b[i + 1]);
                mpq_mul(b[i], u, b[i]);
                mpq_add(b[i], b[i], d);
            }
        mpq_set(out[k], b[0]);
    }
    rationals_free(b, n + 1);
    mpq_clears(u, d, NULL);
}

static bool is_zero(const struct referee_pair *p, const mpq_t t, const mpq_t s)
{
    mpq_t f[3], g[3];
    bool zero = true;
    for (int k = 0; k < 3; k++)
        mpq_inits(f[k], g[k], NULL);
    value_exact(&p->f, t, f);
    value_exact(&p->g, s, g);
    for (int k = 0; k < 2; k++) {
        mpq_mul(f[k], f[k], g[2]);
        mpq_mul(g[k], g[k], f[2]);
        zero = zero && mpq_equal(f[k], g[k]);
    }
    for (int k = 0; k < 3; k++)
        mpq_clears(f[k], g[k], NULL);
    return zero;
}

/* ---- the last digits ---------------------------------------------------------------------------------- */

/* Simplified Newton's method with the inverse in doubles gains 50 bits a step; the distance to the root is
 * bounded by the contraction proved (referee_krawczyk.h).  Returns false if the bound is not below 10^-40 in
 * both parameters. */
static bool polish(const struct referee_pair *p, const struct quad_root *root, mpq_t z[2], mpq_t radius[2])
{
    mpf_t x[2];
    double h[2], most = 0, moved = 0;

    for (int i = 0; i < 2; i++) {
        mpf_init2(x[i], POLISH_BITS);
        rational_from_quad(z[i], root->at[i]);
        mpf_set_q(x[i], z[i]);
    }
    for (int step = 0; step < 4; step++) {
        system_polished(p, x, h);
        for (int i = 0; i < 2 && step < 3; i++) {
            double d = (double)root->inverse[i][0] * h[0] + (double)root->inverse[i][1] * h[1];
            mpf_t by;
            mpf_init2(by, POLISH_BITS);
            mpf_set_d(by, d);
            mpf_sub(x[i], x[i], by);
            mpf_clear(by);
            moved += fabs(d) / root->scale[i];
        }
    }
    for (int i = 0; i < 2; i++) {
        const double *y = root->proof[i], noise = ldexp(1, 20 - POLISH_BITS);
        double row = fabs(y[0]) * (fabs(h[0]) + noise) + fabs(y[1]) * (fabs(h[1]) + noise);
        most = fmax(most, row / root->scale[i]);
    }
    most = most / (1 - root->contraction) * (1 + 0x1p-40);
    for (int i = 0; i < 2; i++) {
        mpq_set_f(z[i], x[i]);
        mpq_set_d(radius[i], most * root->scale[i] * (1 + 0x1p-40));
        mpf_clear(x[i]);
    }
    return moved < QUAD_ROOT_MARGIN && most < QUAD_ROOT_MARGIN &&
           most * fmax(root->scale[0], root->scale[1]) < 1e-40;
}

/* The first convergent of z's continued fraction within radius of z. */
static void simplest_near(const mpq_t z, const mpq_t radius, mpq_t out)
{
    mpz_t n, d, a, h[2], k[2];
    mpq_t off;
    mpz_inits(n, d, a, h[0], h[1], k[0], k[1], NULL);
    mpq_init(off);
    mpz_set(n, mpq_numref(z));
    mpz_set(d, mpq_denref(z));
    mpz_set_ui(h[0], 1); /* h[0] / k[0]: the latest convergent */
    mpz_set_ui(k[1], 1);
    while (mpz_sgn(d)) {
        mpz_fdiv_qr(a, n, n, d);
        mpz_swap(n, d);
        mpz_addmul(h[1], a, h[0]);
        mpz_addmul(k[1], a, k[0]);
        mpz_swap(h[0], h[1]);
        mpz_swap(k[0], k[1]);
        mpz_set(mpq_numref(out), h[0]);
        mpz_set(mpq_denref(out), k[0]);
        mpq_sub(off, out, z);
        mpq_abs(off, off);
        if (mpq_cmp(off, radius) <= 0)
            break;
    }
    mpz_clears(n, d, a, h[0], h[1], k[0], k[1], NULL);
    mpq_clear(off);
}

/* With respect to [0, 1]; NOT_KNOWN: 0 or 1 is within the radius, and is put into `end`. */
static enum place place_of(const mpq_t z, const mpq_t radius, mpq_t end)
{
    mpq_t lo, hi;
    enum place place = INSIDE;
    mpq_inits(lo, hi, NULL);
    mpq_sub(lo, z, radius);
    mpq_add(hi, z, radius);
    if (mpq_sgn(hi) < 0 || mpq_cmp_ui(lo, 1, 1) > 0)
        place = OUTSIDE;
    else if (mpq_sgn(lo) <= 0 || mpq_cmp_ui(hi, 1, 1) >= 0) {
        place = NOT_KNOWN;
        mpq_set_ui(end, mpq_sgn(lo) > 0, 1);
    }
    mpq_clears(lo, hi, NULL);
    return place;
}

/* A zero of H within the radius of z lies in the domain of the proof, so it is the root itself. */
enum place referee_place(const struct referee_pair *p, const struct quad_root *root, struct case_solution *a)
{
    enum { GUESS_BITS = 90 };
    mpq_t z[2], radius[2], guess[2];
    enum place place = INSIDE;
    bool guessed = true;

    for (int i = 0; i < 2; i++)
        mpq_inits(z[i], radius[i], guess[i], NULL);
    a->exact = false;
    bool polished = polish(p, root, z, radius);
    for (int i = 0; i < 2 && polished && place != OUTSIDE; i++) {
        enum place one = place_of(z[i], radius[i], guess[i]);
        if (one == INSIDE)
            simplest_near(z[i], radius[i], guess[i]);
        else
            place = one;
        guessed = guessed && mpz_sizeinbase(mpq_denref(guess[i]), 2) <= GUESS_BITS;
    }
    if (!polished)
        place = NOT_KNOWN;
    else if (place != OUTSIDE && guessed && is_zero(p, guess[0], guess[1])) {
        place = INSIDE;
        a->exact = true;
    }
    for (int i = 0; i < 2; i++) {
        mpq_set(i ? a->s : a->t, a->exact ? guess[i] : z[i]);
        mpq_clears(z[i], radius[i], guess[i], NULL);
    }
    return place;
}
