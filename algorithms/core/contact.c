#include "contact.h"

#include "bernstein.h"
#include "patch.h"
#include "roots.h"

/* An arc in coordinates along T and N from an origin, homogeneous: x, y, w of degree n.  As a curve it errs
 * by `error` in both; its coefficients by `cut` times least_w.  reach bounds its coordinates. */
struct local {
    int n;
    real x[POINTS_MAX], y[POINTS_MAX], w[POINTS_MAX];
    real error, cut, reach, least_w, most_w;
};

/* T = (x, y), of which the larger component is 1, and the origin. */
struct frame {
    real x, y, px, py;
};

/* Blossom of c at (a^(n-i), b^i), i = 0..n: error 3n u max|c| in [0, 1]; up to 1/(8n) outside, where the
 * weights of a step add up to 1 + 1/(4n), 4/3 times as much. */
static void cut_at(int n, const real *c, real a, real b, real *out)
{
    for (int i = 0; i <= n; i++) {
        real q[POINTS_MAX];
        for (int j = 0; j <= n; j++) {
            q[j] = c[j];
        }
        for (int k = 0; k < n; k++) {
            real x = k < i ? b : a;
            for (int j = 0; j < n - k; j++) {
                q[j] = (1 - x) * q[j] + x * q[j + 1];
            }
        }
        out[i] = q[0];
    }
}

/* c from a to b (a > b: backwards); false if weights are not sure to be positive.  |x| <= extent w: 3n u
 * extent max w from the blossom, as much again from weights, 4u from the origin; the frame multiplies by |x|
 * + |y|. */
static bool localize(const struct lowered *c, real a, real b, const struct frame *frame, struct local *out)
{
    const int n = c->polygon.degree;
    const real *h = c->homogeneous, *w = c->polygon.w;
    real x[POINTS_MAX], y[POINTS_MAX], most = 1;
    out->n = n;
    cut_at(n, h, a, b, x);
    cut_at(n, h + n + 1, a, b, y);
    for (int i = 0; i <= n; i++) {
        out->w[i] = 1;
        most = w && (i == 0 || w[i] > most) ? w[i] : most;
    }
    if (w) {
        cut_at(n, w, a, b, out->w);
    }
    out->least_w = out->most_w = out->w[0];
    for (int i = 0; i <= n; i++) {
        out->least_w = real_min(out->least_w, out->w[i]);
        out->most_w = real_max(out->most_w, out->w[i]);
    }
    if (out->least_w <= most / 1024) {
        return false;
    }
    bool past = real_min(a, b) < 0 || real_max(a, b) > 1;
    real norm = real_abs(frame->x) + real_abs(frame->y);
    real steps = (w ? 6 * n : 3 * n) * (past ? (real)4 / 3 : (real)1) + 4;
    out->cut = norm * steps * (REAL_EPSILON / 2) * c->extent * (most / out->least_w);
    out->error = out->cut + norm * c->polygon.error;
    out->reach = 0;
    for (int i = 0; i <= n; i++) {
        real dx = x[i] - frame->px * out->w[i], dy = y[i] - frame->py * out->w[i];
        out->x[i] = frame->x * dx + frame->y * dy;
        out->y[i] = frame->x * dy - frame->y * dx;
        out->reach = real_max(out->reach, real_max(real_abs(out->x[i]), real_abs(out->y[i])) / out->w[i]);
    }
    out->reach += out->error;
    return true;
}

/* Bounds of |c'| over an arc of parameter length `width`, for coefficients that err by `off`; 0 if c' may
 * vanish. */
static void slope_bounds(int n, const real *c, real width, real off, real *least, real *most)
{
    real lo = REAL_HUGE, hi = -REAL_HUGE;
    for (int i = 0; i < n; i++) {
        lo = real_min(lo, c[i + 1] - c[i]);
        hi = real_max(hi, c[i + 1] - c[i]);
    }
    *most = n * (real_max(real_abs(lo), real_abs(hi)) + 2 * off) / width;
    *least = real_max(0, n * (real_max(lo, -hi) - 2 * off) / width);
}

/* |s - s'| <= along eta and |N.(g(s) - g(s'))| <= along drift where |T.(g(s) - g(s'))| <= along, both in [lo,
 * hi]: by the mean value theorem for x - x(s') w, whose slope is x' up to reach |w'|.  false: g may stand
 * still along T. */
static bool find_remainder(const struct lowered *g, real lo, real hi, const struct frame *frame, real *eta,
                           real *drift)
{
    struct local h;
    real least, most, side, turn, width = hi - lo;
    if (!localize(g, lo, hi, frame, &h)) {
        return false;
    }
    real off = h.cut * h.most_w;
    slope_bounds(h.n, h.x, width, off, &least, &most);
    slope_bounds(h.n, h.y, width, off, &most, &side);
    slope_bounds(h.n, h.w, width, g->polygon.w ? off / g->extent : (real)0, &most, &turn);
    least -= h.reach * turn;
    *eta = least > 0 ? h.most_w / least * (1 + 16 * REAL_EPSILON) : (real)0;
    *drift = *eta * (side + h.reach * turn) / h.least_w * (1 + 16 * REAL_EPSILON);
    return least > 0;
}

/* Coordinate along T and its slope at the middle. */
static void at_middle(const struct local *h, real *x, real *slope)
{
    real scratch[POINTS_MAX], dx, dw;
    real v = bernstein_value_slope(h->n, h->x, (real)1 / 2, scratch, &dx);
    real w = bernstein_value_slope(h->n, h->w, (real)1 / 2, scratch, &dw);
    *x = v / w;
    *slope = (dx - *x * dw) / w;
}

/* The parameters of g that go with the ends of f's arc; false if there are none nearby. */
static bool choose_ends(const struct local *f, const struct local *g, const struct interval *s, int m,
                        real *a, real *b)
{
    real x, y, dx, dy, width = s->hi - s->lo;
    at_middle(f, &x, &dx);
    at_middle(g, &y, &dy);
    if (dy == 0) {
        return false;
    }
    real middle = s->lo + width * ((real)1 / 2 + (x - y) / dy), half = width * dx / dy / 2;
    *a = middle - half;
    *b = middle + half;
    real lo = real_min(*a, *b), hi = real_max(*a, *b);
    return 8 * m * real_max(-lo, hi - 1) < 1 && lo < hi;
}

/* Coefficients of w_f w_g (f - g) along T and N, and of w_f w_g; returns max |f - g| along T. */
static real subtract(const struct local *f, const struct local *g, real *across, real *weight)
{
    const int n = f->n, m = g->n;
    real p[CONTACT_DEGREE_MAX + 1], q[CONTACT_DEGREE_MAX + 1], along = 0;
    bernstein_multiply(n, f->w, m, g->w, weight);
    bernstein_multiply(n, f->x, m, g->w, p);
    bernstein_multiply(n, f->w, m, g->x, q);
    for (int k = 0; k <= n + m; k++) {
        along = real_max(along, real_abs(p[k] - q[k]) / weight[k]);
    }
    bernstein_multiply(n, f->y, m, g->w, p);
    bernstein_multiply(n, f->w, m, g->y, q);
    for (int k = 0; k <= n + m; k++) {
        across[k] = p[k] - q[k];
    }
    return along;
}

int contact_meet(const struct lowered *f, const struct interval *t, const struct lowered *g,
                 const struct interval *s, real tolerance, real *scratch,
                 struct contact_piece out[CONTACT_DEGREE_MAX + 1])
{
    const int n = f->polygon.degree, m = g->polygon.degree;
    struct patch patch;
    struct local a, b;
    real first, last, eta, drift, c[CONTACT_DEGREE_MAX + 1], error[CONTACT_DEGREE_MAX + 1];
    struct root root[CONTACT_DEGREE_MAX + 1];
    const real width = t->hi - t->lo;
    if (width < 64 * REAL_EPSILON || s->hi - s->lo < 64 * REAL_EPSILON) {
        return -1;
    }
    patch_cut(g, s->lo, s->hi, &patch);
    const struct frame frame = {patch.x, patch.y, patch.px, patch.py};
    if (!localize(f, t->lo, t->hi, &frame, &a) || !localize(g, s->lo, s->hi, &frame, &b) ||
        !choose_ends(&a, &b, s, m, &first, &last) || !localize(g, first, last, &frame, &b) ||
        !find_remainder(g, real_min(s->lo, real_min(first, last)), real_max(s->hi, real_max(first, last)),
                        &frame, &eta, &drift)) {
        return -1;
    }
    real along = subtract(&a, &b, c, error);
    real off =
        a.error + b.error +
        (n + m + 8) * REAL_EPSILON * (a.reach + b.reach) * (a.most_w / a.least_w) * (b.most_w / b.least_w);
    along += off;
    for (int k = 0; k <= n + m; k++) {
        error[k] = error[k] * (off + along * drift) * (1 + 16 * REAL_EPSILON);
    }
    int found = roots_find(n + m, c, error, tolerance / width, scratch, n + m + 1, root), count = 0;
    for (int i = 0; i < found; i++) {
        real pad = 4 * REAL_EPSILON, spread = along * eta + pad;
        real x = first + (last - first) * root[i].lo, y = first + (last - first) * root[i].hi;
        struct contact_piece p = {
            {real_max(t->lo, t->lo + width * root[i].lo - pad),
             real_min(t->hi, t->lo + width * root[i].hi + pad)},
            {real_max(s->lo, real_min(x, y) - spread), real_min(s->hi, real_max(x, y) + spread)}};
        if (p.s.lo <= p.s.hi) {
            out[count++] = p;
        }
    }
    return count;
}
