/* A cusp as x = a T^2, y = power series of T: the parameter and the bounds of cusps_common.c. */
#include "cusps_model.h"

/* Sum of |c_k| s^(k - from), k >= from. */
static real sum_sizes(const real *c, int from, int n, real s)
{
    real sum = 0;
    for (int k = n; k >= from; k--) {
        sum = sum * s + real_abs(c[k]);
    }
    return sum;
}

static void model_turn(const struct germ *a, real ex, real ey, struct model *out)
{
    real norm = real_abs(ex) + real_abs(ey);
    out->n = a->n;
    for (int k = 0; k <= a->n; k++) {
        real x = a->x[k], y = a->y[k];
        out->x[k] = ex * x + ey * y;
        out->y[k] = ex * y - ey * x;
        out->w[k] = a->w[k];
        out->off_x[k] = out->off_y[k] = norm * (a->error[k] + 2 * REAL_EPSILON * (real_abs(x) + real_abs(y)));
        out->off_w[k] = a->error_w[k];
    }
    for (int k = 0; k < 2; k++) {
        out->off_x[k] += real_abs(out->x[k]);
        out->x[k] = 0;
    }
    out->bend = out->x[2] / out->w[0];
}

/* The largest disc, of radii that are powers of two, with q <= 1/2: p / p_0 differs from 1 by `bent`, A /
 * A_0 by `heavy`. */
static bool model_disc(struct model *a)
{
    enum { HALVINGS = 64 };
    const real up = 1 + 8 * (a->n + 8) * REAL_EPSILON, down = 1 - 8 * (a->n + 8) * REAL_EPSILON;
    real r = 4, size = real_abs(a->x[2]);
    for (int k = 0; k < HALVINGS && size > 0; k++, r = r / 2) {
        real bent = r * sum_sizes(a->x, 3, a->n, r) / size * up;
        real heavy = r * sum_sizes(a->w, 1, a->n, r) / a->w[0] * up;
        a->q = (bent + heavy) / (1 - heavy) * up;
        a->lightest = (a->w[0] * (1 - heavy) - sum_sizes(a->off_w, 0, a->n, r) * up) * down;
        if (heavy <= (real)0.25 && a->q <= (real)0.5 && a->lightest > 0) {
            real root = real_sqrt(1 - a->q);
            a->r = r;
            a->in = r * root * (1 - 4 * REAL_EPSILON);
            a->out = 1 / root * (1 + 4 * REAL_EPSILON);
            a->most = sum_sizes(a->y, 0, a->n, r) / a->lightest * up;
            return true;
        }
    }
    return false;
}

static struct ball quotient(real a, real b)
{
    return ball_round(a / b, 0);
}

/* sqrt(a) where a begins with 1. */
static void series_sqrt(const struct series *a, struct series *out)
{
    out->c[0] = ball_of(1, 0);
    for (int k = 1; k <= SERIES; k++) { /* 2 out_k = a_k - sum of out_i out_(k-i), 0 < i < k */
        struct ball rest = a->c[k];
        for (int i = 1; i < k; i++) {
            rest = ball_subtract(rest, ball_multiply(out->c[i], out->c[k - i]));
        }
        out->c[k] = ball_of(rest.mid / 2, rest.rad / 2);
    }
}

/* B_0 to B_6. */
static void model_series(struct model *a)
{
    struct series x, y, w, one, root;
    for (int k = 0; k <= SERIES; k++) {
        x.c[k] = k + 2 <= a->n ? quotient(a->x[k + 2], a->x[2]) : ball_of(0, 0);
        y.c[k] = k <= a->n ? quotient(a->y[k], a->w[0]) : ball_of(0, 0);
        w.c[k] = k <= a->n ? quotient(a->w[k], a->w[0]) : ball_of(0, 0);
    }
    series_invert(&w, SERIES, &one);
    series_multiply(&x, 0, &one, SERIES, &x);
    series_multiply(&y, 0, &one, SERIES, &y);
    series_sqrt(&x, &root);
    x.c[0] = ball_of(0, 0);
    for (int k = 1; k <= SERIES; k++) {
        x.c[k] = root.c[k - 1];
    }
    series_graph(&x, &y, &a->height);
}

bool model_make(const struct germ *of, real ex, real ey, struct model *out)
{
    model_turn(of, ex, ey, out);
    if (!model_disc(out)) {
        return false;
    }
    model_series(out);
    return true;
}

/* P/A - P'/A' = (P - P')/A - (P'/A') (A - A')/A. */
static real away(const struct model *a, const real *c, const real *off, real s)
{
    real weights = sum_sizes(a->off_w, 0, a->n, s), sum = sum_sizes(off, 0, a->n, s);
    if (weights > 0) {
        sum += sum_sizes(c, 0, a->n, s) / a->lightest * weights;
    }
    return sum / a->lightest;
}

real model_away_x(const struct model *a, real s)
{
    return away(a, a->x, a->off_x, s);
}

real model_away_y(const struct model *a, real s)
{
    return away(a, a->y, a->off_y, s);
}
