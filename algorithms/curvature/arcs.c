#include "arcs.h"

#include "../core/bernstein.h"
#include "form.h"
#include "pieces.h"
#include "planes.h"

enum { RING = 256 }; /* coefficients of a series that are looked back on: at most 64 */

void envelope_make(const struct region_work *k, const struct region_edge *edge, struct envelope *out)
{
    const struct span_forms *f = &k->span[edge->span].form;
    out->e = f->e;
    bernstein_restrict(f->e, 3, f->w, real_min(edge->t, edge->t1), real_max(edge->t, edge->t1), out->w);
}

/* ---- area ---- */

/* Coefficients of powers of t. */
static void to_powers(int n, const real *c, real *out)
{
    for (int i = 0; i <= n; i++) {
        out[i] = c[i];
    }
    for (int k = 1; k <= n; k++) {
        for (int i = n; i >= k; i--) {
            out[i] = out[i] - out[i - 1];
        }
    }
    for (int i = 0; i <= n; i++) {
        out[i] = out[i] * binomial(n, i);
    }
}

static void power_derivative(int n, const real *a, real *out)
{
    for (int i = 0; i < n; i++) {
        out[i] = (i + 1) * a[i + 1];
    }
}

/* Integral over [-1, 1] of numerator / denominator, of degree n both, by their power series; the terms fall
 * because |coefficients of the denominator| do. */
static real integrate_series(int n, const real *numerator, const real *denominator, real tolerance)
{
    real ring[RING], sum = 0, first = 1 / denominator[0];
    int small = 0;
    for (int i = 0; i < 8 * REAL_BITS && small <= n; i++) {
        real g = i <= n ? numerator[i] : (real)0;
        for (int j = 1; j <= n && j <= i; j++) {
            g -= denominator[j] * ring[(i - j) % RING];
        }
        g = g * first;
        ring[i % RING] = g;
        sum += i % 2 == 0 ? 2 * g / (i + 1) : (real)0;
        small = real_abs(g) <= tolerance * real_abs(sum) ? small + 1 : 0;
    }
    return sum;
}

/* (X Y' - Y X') / Z^2 over one panel, by powers of the distance from its middle; false: Z changes too much
 * over it for the series. */
static bool integrate_panel(int e, const real *w, real tolerance, real *integral)
{
    real left[3 * (DEGREE_MAX + 1)], right[3 * (DEGREE_MAX + 1)];
    real x[DEGREE_MAX + 1], y[DEGREE_MAX + 1], z[DEGREE_MAX + 1], dx[DEGREE_MAX + 1], dy[DEGREE_MAX + 1];
    real numerator[2 * DEGREE_MAX + 1], denominator[2 * DEGREE_MAX + 1], rest = 0;
    bernstein_halve(e, 3, w, left, right);
    to_powers(e, right + 2 * (e + 1), z);
    for (int i = 1; i <= e; i++) {
        rest += real_abs(z[i]);
    }
    if (4 * rest > 3 * real_abs(z[0])) {
        return false;
    }
    to_powers(e, right, x);
    to_powers(e, right + e + 1, y);
    power_derivative(e, x, dx);
    power_derivative(e, y, dy);
    form_clear(2 * e, numerator);
    form_clear(2 * e, denominator);
    if (e > 0) {
        form_add_product(e, x, e - 1, dy, 1, numerator);
        form_add_product(e, y, e - 1, dx, -1, numerator);
    }
    form_add_product(e, z, e, z, 1, denominator);
    *integral = integrate_series(2 * e, numerator, denominator, tolerance);
    return true;
}

real envelope_area(const struct region_edge *edge, const struct envelope *a, struct point about,
                   real tolerance)
{
    real w[3 * (DEGREE_MAX + 1)], panel[3 * (DEGREE_MAX + 1)], lo = 0, width = 1, sum = 0;
    int length = a->e + 1;
    for (int i = 0; i < length; i++) {
        w[2 * length + i] = a->w[2 * length + i];
        w[i] = a->w[i] - about.x * w[2 * length + i];
        w[length + i] = a->w[length + i] - about.y * w[2 * length + i];
    }
    while (lo < 1 && width > REAL_EPSILON) {
        real hi = real_min(1, lo + width), part;
        bernstein_restrict(a->e, 3, w, lo, hi, panel);
        if (integrate_panel(a->e, panel, tolerance, &part)) {
            sum += part;
            lo = hi;
            width = 2 * width;
        } else {
            width = width / 2;
        }
    }
    return (edge->t < edge->t1 ? sum : -sum) / 2;
}

/* ---- distance ---- */

void envelope_tangent(const struct region_work *k, const struct region_edge *edge, real t, real *line)
{
    struct half_plane p;
    half_plane_at(k, edge->span, t, false, &p);
    real length = real_sqrt(p.l[0] * p.l[0] + p.l[1] * p.l[1]);
    for (int i = 0; i < 3; i++) {
        line[i] = p.l[i] / length;
    }
}

/* d/dt of the square of the distance from d to the arc has the sign of the product of these two scaled forms,
 * up to the constant sign of Z: the way from d, (X - x Z, Y - y Z), and the direction of e', (X'Z - X Z',
 * ...). */
static int distance_slope(const struct envelope *a, const real *pascal, struct point d, real *g)
{
    int e = a->e, m = 2 * e - 2, length = e + 1;
    real way[2][FORM_MAX], at[3][FORM_MAX], slope[3][FORM_MAX], direction[2][FORM_MAX];
    for (int c = 0; c < 3; c++) {
        const real *from = a->w + c * length;
        for (int i = 0; i < e; i++) {
            at[c][i] = from[i] * pascal_row(pascal, e - 1)[i];
            slope[c][i] = (from[i + 1] - from[i]) * pascal_row(pascal, e - 1)[i];
        }
    }
    form_clear(3 * e - 2, g);
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i <= e; i++) {
            way[c][i] =
                (a->w[c * length + i] - (c ? d.y : d.x) * a->w[2 * length + i]) * pascal_row(pascal, e)[i];
        }
        form_clear(m, direction[c]);
        form_add_product(e - 1, slope[c], e - 1, at[2], 1, direction[c]);
        form_add_product(e - 1, at[c], e - 1, slope[2], -1, direction[c]);
        form_add_product(e, way[c], m, direction[c], 1, g);
    }
    form_unscale(3 * e - 2, pascal, g, g);
    return 3 * e - 2;
}

int envelope_feet(struct region_work *k, const struct region_edge *edge, const struct envelope *a,
                  struct point d, real *t)
{
    real g[FORM_MAX], error[FORM_MAX], most = 0;
    real lo = real_min(edge->t, edge->t1), hi = real_max(edge->t, edge->t1);
    int n = distance_slope(a, k->pascal, d, g);
    for (int i = 0; i <= n; i++) {
        most = real_max(most, real_abs(g[i]));
    }
    for (int i = 0; i <= n; i++) {
        error[i] = 16 * n * REAL_EPSILON * most;
    }
    int feet = form_crossings(k, n, g, error, FORM_MAX, t);
    for (int i = 0; i < feet; i++) {
        t[i] = lo + t[i] * (hi - lo);
    }
    return feet < 0 ? 0 : feet;
}

/* Step of Newton's method for (x w3 - w1) B - (y w3 - w2) A = 0: the way from the arc to d is along the
 * normal. */
static real foot_step(const struct region_work *k, const struct region_edge *edge, struct point d, real t)
{
    const struct span_forms *f = &k->span[edge->span].form;
    real w[3], dw[3], n[2], dn[2];
    form_values_slopes(f->e, 3, k->pascal, f->w, t, w, dw);
    form_values_slopes(f->l, 2, k->pascal, f->L, t, n, dn);
    real x = d.x * w[2] - w[0], y = d.y * w[2] - w[1], dx = d.x * dw[2] - dw[0], dy = d.y * dw[2] - dw[1];
    real slope = dx * n[1] + x * dn[1] - dy * n[0] - y * dn[0];
    return slope != 0 ? (x * n[1] - y * n[0]) / slope : (real)0;
}

/* Moves to `to` if the tangent there is nearer to d. */
static bool try_tangent(const struct region_work *k, const struct region_edge *edge, struct point d, real to,
                        real *t, real *line)
{
    real next[3], at = real_min(real_max(edge->t, edge->t1), real_max(real_min(edge->t, edge->t1), to));
    envelope_tangent(k, edge, at, next);
    if (!((next[0] - line[0]) * d.x + (next[1] - line[1]) * d.y + (next[2] - line[2]) < 0)) {
        return false;
    }
    *t = at;
    for (int j = 0; j < 3; j++) {
        line[j] = next[j];
    }
    return true;
}

void envelope_touch(const struct region_work *k, const struct region_edge *edge, struct point d, real reach,
                    real *t, real *line)
{
    enum { STEPS = 4, HALVINGS = 3 };
    int halvings = 0;
    for (int i = 0; i < STEPS; i++) {
        if (try_tangent(k, edge, d, *t - foot_step(k, edge, d, *t), t, line)) {
            halvings = HALVINGS;
        } else if (halvings++ >= HALVINGS) {
            return;
        } else if (!try_tangent(k, edge, d, *t + reach / 2, t, line) &&
                   !try_tangent(k, edge, d, *t - reach / 2, t, line)) {
            reach = reach / 4;
        }
    }
}

real envelope_opposite(const struct region_work *k, const struct region_edge *edge, const real *line, real a,
                       real b)
{
    enum { STEPS = 8 };
    const struct span_forms *f = &k->span[edge->span].form;
    real n[2], dn[2], t = a + (b - a) / 2, lo = real_min(a, b), hi = real_max(a, b);
    for (int i = 0; i < STEPS; i++) {
        form_values_slopes(f->l, 2, k->pascal, f->L, t, n, dn);
        real slope = dn[0] * line[1] - dn[1] * line[0];
        real step = slope != 0 ? (n[0] * line[1] - n[1] * line[0]) / slope : (real)0, next = t - step;
        if (!(next > lo && next < hi)) {
            return a + (b - a) / 2;
        }
        t = next;
        if (real_abs(step) <= 4 * REAL_EPSILON) {
            break;
        }
    }
    return t;
}
