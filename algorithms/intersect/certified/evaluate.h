/* Points and derivatives of a source, in line.
 *
 * In Bernstein form with the binomials multiplied in beforehand: with v = 1 - t, sum of c[i] v^(n-i) t^i by
 * Horner's rule in v, the powers of t alongside.  Every term is >= 0 times its coefficient, so the error of a
 * value is at most (3n + 2) u |c|(t): n - i from v, n - 1 from the powers, 2 from the coefficient, 1 from its
 * product, n from sums.  Degrees 2 and 3 of values and derivatives with the constants of source.c:
 * tests/proofs/evaluate_quadratic.g, evaluate_cubic.g, slope_quadratic.g, slope_cubic.g. */
#ifndef FATLINE_CERTIFIED_EVALUATE_H
#define FATLINE_CERTIFIED_EVALUATE_H

#include "certified.h"

struct spot {
    real x, y, dx, dy;
};

static inline void sum_1(int n, const real *a, real t, real *x)
{
    real v = 1 - t, power = t, sum = a[0];
    for (int i = 1; i <= n; i++) {
        sum = sum * v + a[i] * power;
        power = power * t;
    }
    *x = sum;
}

static inline void sum_2(int n, const real *a, const real *b, real t, real *x, real *y)
{
    if (n == 3) {
        real v = 1 - t, vv = v * v, tt = t * t, w0 = vv * v, w1 = vv * t, w2 = v * tt, w3 = tt * t;
        *x = (w0 * a[0] + w1 * a[1]) + (w2 * a[2] + w3 * a[3]);
        *y = (w0 * b[0] + w1 * b[1]) + (w2 * b[2] + w3 * b[3]);
        return;
    }
    if (n == 2) {
        real v = 1 - t, w0 = v * v, w1 = v * t, w2 = t * t;
        *x = w0 * a[0] + w1 * a[1] + w2 * a[2];
        *y = w0 * b[0] + w1 * b[1] + w2 * b[2];
        return;
    }
    real v = 1 - t, power = t, sum = a[0], also = b[0];
    for (int i = 1; i <= n; i++) {
        sum = sum * v + a[i] * power;
        also = also * v + b[i] * power;
        power = power * t;
    }
    *x = sum;
    *y = also;
}

/* n and rational are those of c, given so that the compiler may know them. */
static inline void source_at_degree(const int n, const bool rational, const struct source *c, real t,
                                    struct spot *out)
{
    sum_2(n, c->value, c->value + n + 1, t, &out->x, &out->y);
    sum_2(n - 1, c->slope, c->slope + n, t, &out->dx, &out->dy);
    if (rational) {
        real w, dw;
        sum_1(n, c->value + 2 * (n + 1), t, &w);
        sum_1(n - 1, c->slope + 2 * n, t, &dw);
        real one = 1 / w;
        out->x = out->x * one;
        out->y = out->y * one;
        out->dx = (out->dx - out->x * dw) * one;
        out->dy = (out->dy - out->y * dw) * one;
    }
}

/* t in [0, 1]; errors at most noise and slope_noise. */
static inline void source_at(const struct source *c, real t, struct spot *out)
{
    source_at_degree(c->n, c->rational, c, t, out);
}

static inline real cross(real ax, real ay, real bx, real by)
{
    return ax * by - ay * bx;
}

static inline real clamp(real t, real lo, real hi)
{
    return t < lo ? lo : t > hi ? hi : t;
}

#endif
