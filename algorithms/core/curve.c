#include "curve.h"

#include "bernstein.h"

enum { DEGREES = 33, ORDER_MAX = 8, LEVELS_MAX = 16 };

struct point curve_point(int n, const real *x, const real *y, const real *w, real t)
{
    struct point p = {bernstein_value(n, x, t), bernstein_value(n, y, t)};
    if (w) {
        real weight = bernstein_value(n, w, t);
        p.x = p.x / weight;
        p.y = p.y / weight;
    }
    return p;
}

/* Derivatives 0..order of one polynomial; those above its degree are 0. */
static void polynomial_derivatives(int n, const real *c, real t, int order, real *out)
{
    real d[DEGREES];
    for (int i = 0; i <= n; i++) {
        d[i] = c[i];
    }
    for (int j = 0; j <= order; j++) {
        out[j] = j <= n ? bernstein_value(n - j, d, t) : (real)0;
        if (j < n) {
            bernstein_derivative(n - j, d, d);
        }
    }
}

void curve_derivatives(int n, const real *x, const real *y, const real *w, real t, int order,
                       struct point *out)
{
    real dx[ORDER_MAX + 1], dy[ORDER_MAX + 1], dw[ORDER_MAX + 1];
    polynomial_derivatives(n, x, t, order, dx);
    polynomial_derivatives(n, y, t, order, dy);
    if (w) {
        polynomial_derivatives(n, w, t, order, dw);
    }
    for (int j = 0; j <= order; j++) {
        out[j].x = dx[j];
        out[j].y = dy[j];
        if (!w) {
            continue;
        }
        for (int i = 1; i <= j; i++) {
            real c = binomial(j, i) * dw[i];
            out[j].x = out[j].x - c * out[j - i].x;
            out[j].y = out[j].y - c * out[j - i].y;
        }
        out[j].x = out[j].x / dw[0];
        out[j].y = out[j].y / dw[0];
    }
}

real norm_l2(int n, const real *x, const real *y)
{
    real sum = 0;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= n; j++) {
            real weight = binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j);
            sum += weight * (x[i] * x[j] + y[i] * y[j]);
        }
    }
    sum = sum / (real)(2 * n + 1);
    return sum > 0 ? real_sqrt(sum) : (real)0;
}

static real square_at(const real *x, const real *y, int i)
{
    return x[i] * x[i] + y[i] * y[i];
}

static real largest_square(int n, const real *c)
{
    real most = 0;
    for (int i = 0; i <= n; i++) {
        most = real_max(most, square_at(c, c + n + 1, i));
    }
    return most;
}

/* Depth first: a piece whose control points stay below what a point of the curve has reached adds nothing. */
static void climb(int n, const real *c, int levels, real *reached, real *bound)
{
    *reached = real_max(*reached, real_max(square_at(c, c + n + 1, 0), square_at(c, c + n + 1, n)));
    real most = largest_square(n, c);
    if (most <= *reached || levels == 0) {
        *bound = real_max(*bound, most);
        return;
    }
    real left[2 * DEGREES], right[2 * DEGREES];
    bernstein_halve(n, 2, c, left, right);
    climb(n, left, levels - 1, reached, bound);
    climb(n, right, levels - 1, reached, bound);
}

struct norm_enclosure norm_infinity(int n, const real *x, const real *y, int levels)
{
    real c[2 * DEGREES], reached = 0, bound = 0;
    for (int i = 0; i <= n; i++) {
        c[i] = x[i];
        c[n + 1 + i] = y[i];
    }
    climb(n, c, levels < LEVELS_MAX ? levels : LEVELS_MAX, &reached, &bound);
    bound = real_max(bound, reached);
    struct norm_enclosure e;
    real slack =
        (real)(n + 4) * LEVELS_MAX * REAL_EPSILON; /* of a point after `levels` halvings, and of its length */
    e.lo = real_sqrt(reached) * (1 - slack);
    e.hi = real_sqrt(bound) * (1 + slack);
    return e;
}

real norm_bb(int n, const real *x, const real *y)
{
    real most = 0;
    for (int i = 0; i <= n; i++) {
        most = real_max(most, square_at(x, y, i));
    }
    return real_sqrt(most);
}
