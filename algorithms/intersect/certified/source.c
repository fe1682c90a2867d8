/* A curve of a level, made ready for evaluation; and the errors that go with it. */
#include "../../core/bernstein.h"
#include "evaluate.h"

size_t source_length(int n)
{
    return 3 * (size_t)(2 * n + 1);
}

struct weights {
    real least, most;
};

static struct weights weights_of(const struct source *c)
{
    struct weights w = {1, 1};
    if (c->rational) {
        const real *at = c->points + 2 * (c->n + 1);
        w.least = w.most = at[0];
        for (int i = 1; i <= c->n; i++) {
            w.least = real_min(w.least, at[i]);
            w.most = real_max(w.most, at[i]);
        }
    }
    return w;
}

static inline void scaled_component(const int n, const real *c, real *value, real *slope, real *longest)
{
    real above = 1, below = 1; /* C(n, i), C(n-1, i) */
    for (int i = 0; i < n; i++) {
        real step = c[i + 1] - c[i];
        value[i] = above * c[i];
        slope[i] = below * (n * step);
        *longest = real_max(*longest, real_abs(step));
        above = above * (real)(n - i) / (real)(i + 1);
        below = below * (real)(n - 1 - i) / (real)(i + 1);
    }
    value[n] = c[n];
}

static void cubic_component(const real *c, real *value, real *slope, real *longest)
{
    real a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
    value[0] = c[0];
    value[1] = 3 * c[1];
    value[2] = 3 * c[2];
    value[3] = c[3];
    slope[0] = 3 * a;
    slope[1] = 6 * b;
    slope[2] = 3 * d;
    *longest = real_max(*longest, real_max(real_max(real_abs(a), real_abs(b)), real_abs(d)));
}

static void scaled_coefficients(struct source *c, real *longest)
{
    int n = c->n;
    *longest = 0;
    for (int k = 0; k < (c->rational ? 3 : 2); k++) {
        if (n == 3) {
            cubic_component(c->points + k * 4, c->value + k * 4, c->slope + k * 3, longest);
        } else {
            scaled_component(n, c->points + k * (n + 1), c->value + k * (n + 1), c->slope + k * n, longest);
        }
    }
}

/* Values: (3n + 2) u S, by evaluate.h, and binomials of degree above 54 up to 20 u; differences are rounded
 * once, products with n and the binomial twice.  Rational: numerator and denominator err so against w > 0,
 * the quotient adds 2 u S; and the derivative (X' - x W') / W with |X'| <= 2 n S w, |W'| <= n w for w the
 * largest weight. */
void source_init(struct source *c, real scale, real *numbers)
{
    const real u = REAL_EPSILON / 2;
    int n = c->n;
    c->value = numbers;
    c->slope = numbers + 3 * (n + 1);
    real longest;
    scaled_coefficients(c, &longest);
    real relative = (3 * n + 4) * u;
    if (!c->rational) {
        c->noise = relative * scale + c->error;
        c->slope_noise = n * ((relative + 2 * u) * longest + 2 * c->error);
        return;
    }
    struct weights w = weights_of(c);
    c->noise = (2 * relative + 4 * u) * scale + c->error;
    c->slope_noise = n * (w.most / w.least) * (8 * relative * scale + 4 * c->error + 2 * c->noise);
}
