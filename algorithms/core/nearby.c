#include "nearby.h"

#include "bernstein.h"

enum { POINTS = 33, PRODUCTS = POINTS + NEARBY_DEGREE_MAX };

void frame_set_norms(struct frame *f)
{
    for (int j = 0; j < 2; j++) {
        f->norm[j] = real_abs(f->row[j][0]) + real_abs(f->row[j][1]);
    }
}

/* How far coordinate j of a computed point is from the true one: the arc's error, and of the frame, and of a
 * quotient by the weight, 5 roundings of at most 2 norm scale each, and one of norm scale. */
static real frame_error(const struct arc *a, const struct frame *f, int j)
{
    return f->norm[j] * (a->error + 6 * REAL_EPSILON * f->scale);
}

/* Homogeneous coordinates of a in the frame: out[0..n] and out[n+1..2n+1]. */
static void transform(const struct arc *a, const struct frame *f, real *out)
{
    const int n = a->degree;
    for (int i = 0; i <= n; i++) {
        real x = a->x[i] - (a->w ? f->x0 * a->w[i] : f->x0), y = a->y[i] - (a->w ? f->y0 * a->w[i] : f->y0);
        out[i] = f->row[0][0] * x + f->row[0][1] * y;
        out[n + 1 + i] = f->row[1][0] * x + f->row[1][1] * y;
    }
}

static void bound_difference(int n, const real *c, real *most, real *steepest)
{
    *most = real_abs(c[0]);
    *steepest = 0;
    for (int i = 1; i <= n; i++) {
        *most = real_max(*most, real_abs(c[i]));
        *steepest = real_max(*steepest, real_abs(c[i] - c[i - 1]));
    }
    *steepest = n * *steepest;
}

/* The residual's Bernstein coefficients bound the difference; n times its differences the slope's, where each
 * coefficient's error counts 2n times. */
static void reduce_polynomial(const struct arc *a, const struct frame *f, const struct reduction *r,
                              const real *c, struct nearby *out)
{
    const int n = a->degree;
    real q[2 * (NEARBY_DEGREE_MAX + 1)], rest[2 * POINTS];
    reduction_apply(r, 2, c, q);
    real bound = r->reduce ? reduction_residual(r, 2, c, q, rest) : (real)0;
    out->degree = r->k;
    for (int j = 0; j < 2; j++) {
        real most = 0, steepest = 0, error = bound + frame_error(a, f, j);
        if (r->reduce) {
            bound_difference(n, rest + j * (n + 1), &most, &steepest);
        }
        out->off[j] = most + error;
        out->slope_off[j] = steepest + 2 * n * error;
        for (int i = 0; i <= r->k; i++) {
            out->c[j][i] = q[j * (r->k + 1) + i];
        }
    }
}

/* ---- rational arcs ---- */

/* Points near (1 - cos((2i + 1) pi / (2k + 2))) / 2, in units of 2^-10. */
static const short nodes[NEARBY_DEGREE_MAX + 1][NEARBY_DEGREE_MAX + 1] = {{512},
                                                                          {150, 874},
                                                                          {69, 512, 955},
                                                                          {39, 316, 708, 985},
                                                                          {25, 211, 512, 813, 999},
                                                                          {17, 150, 379, 645, 874, 1007}};

/* Bernstein coefficients of the polynomial of degree k with these values: divided differences, then Newton's
 * form, multiplied out factor by factor.  (t - node) has the Bernstein coefficients -node, 1 - node. */
static void interpolate(int k, const real *node, real *value, real *out)
{
    for (int j = 1; j <= k; j++) {
        for (int i = k; i >= j; i--) {
            value[i] = (value[i] - value[i - 1]) / (node[i] - node[i - j]);
        }
    }
    out[0] = value[k];
    for (int m = 1; m <= k; m++) {
        real at = node[k - m];
        out[m] = out[m - 1] * (1 - at) + value[k - m];
        for (int i = m - 1; i > 0; i--) {
            out[i] = (i * (out[i - 1] * (1 - at)) - (m - i) * (out[i] * at)) / m + value[k - m];
        }
        out[0] = value[k - m] - out[0] * at;
    }
}

struct weight {
    real least, most, steepest; /* of the Bernstein coefficients; of the derivative */
    real elevated[PRODUCTS + 1];
};

/* p = x - c w, in degree n + k, has the Bernstein coefficients p[i] with an error below `rounding`: elevation
 * 4k u_0, product n + k + 6, the difference 1.  |x / w - c| = |p / w| <= max |p[i]| / (w elevated)[i], where
 * elevation may have made w too large by 4k u_0; (p / w)' = p' / w - (p / w) w' / w. The true x and w are
 * within (error / 2) w and (error / (2 scale)) w of these: with phi = x / w the derivative moves by (q' -
 * (phi' - true phi') w') / w, q = (true x - x) - phi (true w - w), at most 8n (most / least)^2 error. */
static void bound_rational(const struct arc *a, const struct frame *f, const struct weight *w, int k, int j,
                           const real *x, struct nearby *out)
{
    const int n = a->degree, degree = n + k;
    real raised[PRODUCTS + 1], product[PRODUCTS + 1], largest_x = 0, largest_c = 0, off = 0, steepest = 0;
    for (int i = 0; i <= n; i++) {
        largest_x = real_max(largest_x, real_abs(x[i]));
    }
    for (int i = 0; i <= k; i++) {
        largest_c = real_max(largest_c, real_abs(out->c[j][i]));
    }
    bernstein_elevate(n, x, k, raised);
    bernstein_multiply(k, out->c[j], n, a->w, product);
    real rounding = (degree + 4 * k + 8) * (REAL_EPSILON / 2) * (largest_x + largest_c * w->most);
    for (int i = 0; i <= degree; i++) {
        product[i] = raised[i] - product[i];
        off = real_max(off, (real_abs(product[i]) + rounding) / w->elevated[i]);
        steepest = i > 0 ? real_max(steepest, real_abs(product[i] - product[i - 1])) : (real)0;
    }
    off += off / 64;
    real slope = (degree * (steepest + 2 * rounding) + off * w->steepest) / w->least,
         spread = w->most / w->least;
    real error = frame_error(a, f, j);
    out->off[j] = off + error;
    out->slope_off[j] = slope + slope / 64 + 8 * n * spread * spread * error;
}

static void measure_weight(const struct arc *a, int k, struct weight *w)
{
    w->least = w->most = a->w[0];
    w->steepest = 0;
    for (int i = 1; i <= a->degree; i++) {
        w->least = real_min(w->least, a->w[i]);
        w->most = real_max(w->most, a->w[i]);
        w->steepest = real_max(w->steepest, real_abs(a->w[i] - a->w[i - 1]));
    }
    w->steepest = a->degree * w->steepest;
    bernstein_elevate(a->degree, a->w, k, w->elevated);
}

static void interpolate_rational(const struct arc *a, const struct frame *f, int k, const real *c,
                                 struct nearby *out)
{
    const int n = a->degree;
    real node[NEARBY_DEGREE_MAX + 1], value[2][NEARBY_DEGREE_MAX + 1];
    struct weight w;
    measure_weight(a, k, &w);
    for (int i = 0; i <= k; i++) {
        node[i] = (real)(int)nodes[k][i] / 1024;
        real weight = bernstein_value(n, a->w, node[i]);
        for (int j = 0; j < 2; j++) {
            value[j][i] = bernstein_value(n, c + j * (n + 1), node[i]) / weight;
        }
    }
    out->degree = k;
    for (int j = 0; j < 2; j++) {
        interpolate(k, node, value[j], out->c[j]);
        bound_rational(a, f, &w, k, j, c + j * (n + 1), out);
    }
}

void nearby_init(const struct arc *a, const struct frame *f, const struct reduction *r, int k,
                 struct nearby *out)
{
    real c[2 * POINTS];
    transform(a, f, c);
    if (a->w) {
        interpolate_rational(a, f, k, c, out);
    } else {
        reduce_polynomial(a, f, r, c, out);
    }
}

void nearby_extent(const struct arc *a, const struct frame *f, real *out, real *lo, real *hi)
{
    real c[2 * POINTS], error = frame_error(a, f, 0);
    transform(a, f, c);
    for (int i = 0; i <= a->degree; i++) {
        real d = a->w ? c[i] / a->w[i] : c[i];
        *lo = i > 0 ? real_min(*lo, d) : d;
        *hi = i > 0 ? real_max(*hi, d) : d;
        if (out) {
            out[i] = c[i];
        }
    }
    *lo = *lo - error;
    *hi = *hi + error;
}
