#include "band.h"

#include <stdbool.h>

#include "bernstein.h"

/* ---- guesses of the roots in (0, 1), ascending ---- */

static int keep_inside(real r, real *root, int count)
{
    if (r > 0 && r < 1) {
        root[count++] = r;
    }
    return count;
}

static int roots_1(const real *c, real *root)
{
    return c[0] == c[1] ? 0 : keep_inside(c[0] / (c[0] - c[1]), root, 0);
}

static int roots_2(const real *c, real *root)
{
    real a = c[0] - 2 * c[1] + c[2], b = c[0] - c[1]; /* a t^2 - 2 b t + c0 */
    real d = b * b - a * c[0];
    if (d < 0) {
        return 0;
    }
    d = real_sqrt(d);
    real z = b >= 0 ? b + d : b - d;
    real r1 = z != 0 ? c[0] / z : -1, r2 = a != 0 ? z / a : -1;
    int count = keep_inside(real_min(r1, r2), root, 0);
    return keep_inside(real_max(r1, r2), root, count);
}

static real value_3(const real *a, real t, real *slope)
{
    *slope = (3 * a[3] * t + 2 * a[2]) * t + a[1];
    return ((a[3] * t + a[2]) * t + a[1]) * t + a[0];
}

/* Power coefficients a if k = 3, Bernstein coefficients if it is higher. */
static inline real value_slope(int k, const real *a, real t, real *slope)
{
    real scratch[BAND_DEGREE_MAX + 1];
    return k == 3 ? value_3(a, t, slope) : bernstein_value_slope(k, a, t, scratch, slope);
}

/* Newton's method kept inside [lo, hi], over which the polynomial of value_slope changes sign from vl to vh.
 */
static inline real root_between(int k, const real *a, real lo, real hi, real vl, real vh)
{
    real t = lo + (hi - lo) * (vl / (vl - vh)), slope;
    const real enough = 2 * REAL_EPSILON;
    for (int i = 0; i < REAL_BITS; i++) {
        real v = value_slope(k, a, t, &slope);
        if (v == 0) {
            return t;
        }
        if ((v < 0) == (vl < 0)) {
            lo = t;
        } else {
            hi = t;
        }
        real next = slope != 0 ? t - v / slope : lo;
        if (!(next > lo && next < hi)) {
            next = lo + (hi - lo) * (real)0.5;
        }
        real step = real_abs(next - t);
        t = next;
        if (step <= enough * t) {
            break;
        }
    }
    return t;
}

static int roots_3(const real *c, real *root)
{
    real a[4] = {c[0], 3 * (c[1] - c[0]), 3 * ((c[2] - c[1]) - (c[1] - c[0])),
                 (c[3] - c[0]) - 3 * (c[2] - c[1])};
    real slopes[3] = {c[1] - c[0], c[2] - c[1], c[3] - c[2]};
    real at[4], slope;
    at[0] = 0;
    int pieces = roots_2(slopes, at + 1) + 1, count = 0;
    at[pieces] = 1;
    real vl = c[0];
    for (int i = 0; i < pieces; i++) {
        real vh = i + 1 < pieces ? value_3(a, at[i + 1], &slope) : c[3];
        if ((vl < 0) != (vh < 0)) {
            count = keep_inside(root_between(3, a, at[i], at[i + 1], vl, vh), root, count);
        }
        vl = vh;
    }
    return count;
}

static int guess_roots(int k, const real *c, real *root);

/* Degrees above 3: one root at most between neighbouring roots of the derivative. */
static int roots_by_slope(int k, const real *c, real *root)
{
    real slopes[BAND_DEGREE_MAX], at[BAND_DEGREE_MAX + 1];
    for (int i = 0; i < k; i++) {
        slopes[i] = c[i + 1] - c[i];
    }
    at[0] = 0;
    int pieces = guess_roots(k - 1, slopes, at + 1) + 1, count = 0;
    at[pieces] = 1;
    real vl = c[0];
    for (int i = 0; i < pieces; i++) {
        real vh = i + 1 < pieces ? bernstein_value(k, c, at[i + 1]) : c[k];
        if ((vl < 0) != (vh < 0)) {
            count = keep_inside(root_between(k, c, at[i], at[i + 1], vl, vh), root, count);
        }
        vl = vh;
    }
    return count;
}

static int guess_roots(int k, const real *c, real *root)
{
    switch (k) {
    case 1:
        return roots_1(c, root);
    case 2:
        return roots_2(c, root);
    case 3:
        return roots_3(c, root);
    default:
        return roots_by_slope(k, c, root);
    }
}

/* ---- proofs ---- */

/* Is the polynomial, of coefficients c with error at most `error` each, below 0 on [0, 1]? */
static int is_negative(int k, const real *c, real error, int depth)
{
    int below = 1;
    for (int i = 0; i <= k; i++) {
        below &= c[i] < -error;
    }
    if (below || c[0] >= -error || c[k] >= -error || depth == 0) {
        return below;
    }
    real left[BAND_DEGREE_MAX + 1], right[BAND_DEGREE_MAX + 1];
    bernstein_halve(k, 1, c, left, right);
    real more = 2 * error; /* halving adds k u max|c|, below the 8k u max|c| that error began with */
    return is_negative(k, left, more, depth - 1) && is_negative(k, right, more, depth - 1);
}

struct polynomial {
    int k;
    const real *c;
    real error; /* of a restriction: 8 k u max|c| */
};

static int is_negative_between(const struct polynomial *p, real lo, real hi)
{
    real part[BAND_DEGREE_MAX + 1];
    bernstein_restrict(p->k, 1, p->c, lo, hi, part);
    return is_negative(p->k, part, p->error, 5);
}

/* The same between the stationary points: halving takes many steps to tell a maximum just below 0 from one at
 * 0, but over an interval that ends there the Bernstein coefficients of a parabola do not rise above it. */
static int is_negative_by_parts(const struct polynomial *p, real lo, real hi)
{
    real slopes[BAND_DEGREE_MAX], at[BAND_DEGREE_MAX];
    if (p->k == 1) {
        return 0;
    }
    for (int i = 0; i < p->k; i++) {
        slopes[i] = p->c[i + 1] - p->c[i];
    }
    int count = guess_roots(p->k - 1, slopes, at);
    for (int i = 0; i < count; i++) {
        if (at[i] > lo && at[i] < hi) {
            if (!is_negative_between(p, lo, at[i])) {
                return 0;
            }
            lo = at[i];
        }
    }
    return is_negative_between(p, lo, hi);
}

/* How far from its root r the polynomial is sure to have left 0: four times the rounding over the slope. */
static real first_pad(const struct polynomial *p, real r)
{
    real scratch[BAND_DEGREE_MAX + 1], slope;
    bernstein_value_slope(p->k, p->c, r, scratch, &slope);
    const real least = 4 * REAL_EPSILON;
    return slope != 0 ? least + 4 * p->error / real_abs(slope) : 1;
}

/* Narrows the gap (*lo, *hi) between guesses to a part that is proved negative; 0 if there is no such part.
 */
static int prove_gap(const struct polynomial *p, real *lo, real *hi)
{
    real width = *hi - *lo;
    real pad_lo = *lo > 0 ? first_pad(p, *lo) : 0, pad_hi = *hi < 1 ? first_pad(p, *hi) : 0;
    const real quarter = (real)0.25;
    for (int attempt = 0; attempt < 4; attempt++) {
        pad_lo = real_min(pad_lo, quarter * width);
        pad_hi = real_min(pad_hi, quarter * width);
        real a = *lo + pad_lo, b = *hi - pad_hi;
        if (is_negative_between(p, a, b) || is_negative_by_parts(p, a, b)) {
            *lo = a;
            *hi = b;
            return 1;
        }
        pad_lo = 32 * pad_lo;
        pad_hi = 32 * pad_hi;
    }
    return 0;
}

static void band_add(struct band *b, real lo, real hi)
{
    if (b->count > 0 && (lo <= b->hi[b->count - 1] || b->count == BAND_PIECES_MAX)) {
        b->hi[b->count - 1] = real_max(hi, b->hi[b->count - 1]);
        return;
    }
    b->lo[b->count] = lo;
    b->hi[b->count++] = hi;
}

/* Value by Horner's scheme in power form from monotone coefficients; error at most 16 u max|c| for k <= 3:
 * the power coefficients are at most 6 max|c| in sum and come with 3 roundings.  Above, by de Casteljau: 3k
 * u. */
static inline real value(int k, const real *c, real t)
{
    if (k > 3) {
        return bernstein_value(k, c, t);
    }
    if (k == 1) {
        return c[0] + (c[1] - c[0]) * t;
    }
    real b1 = c[1] - c[0];
    if (k == 2) {
        return c[0] + (2 * b1 + ((c[2] - c[1]) - b1) * t) * t;
    }
    real b2 = c[2] - c[1];
    return c[0] + 3 * (b1 + ((b2 - b1) + ((c[3] - b2 - c[2]) - (b2 - b1)) * ((real)1 / 3) * t) * t) * t;
}

/* For c increasing from c[0] < 0 <= c[k]: a point that is not beyond the root, but by rounding close to it.
 * The value there, with its rounding, proves it; 0 if the guess is not good enough. */
static inline real before_root(int k, const real *c, real largest)
{
    real root[BAND_DEGREE_MAX], r;
    int count = guess_roots(k, c, root);
    if (count == 0) {
        return c[k] > 0 ? 0 : 1;
    }
    r = root[count - 1];
    const real error = 32 * REAL_EPSILON;
    real scratch[BAND_DEGREE_MAX + 1], slope = c[k] - c[0]; /* of the order of the polynomial's own */
    real pad = 2 * error * largest / slope + 2 * REAL_EPSILON;
    for (int attempt = 0; attempt < 4; attempt++) {
        real t = r - pad;
        if (t <= 0) {
            return 0;
        }
        if (value(k, c, t) < -error * largest) {
            return t;
        }
        bernstein_value_slope(k, c, t, scratch, &slope); /* smaller where a stationary point is near */
        pad = real_max(32 * pad, slope > 0 ? 2 * error * largest / slope : (real)0);
    }
    return 0;
}

/* Monotone Bernstein coefficients: the polynomial is monotone, and one point tells its sign on one side. */
static bool monotone_above(int k, const real *c, real largest, struct band *out)
{
    bool up = true, down = true;
    for (int i = 0; i < k; i++) {
        up &= c[i] <= c[i + 1];
        down &= c[i] >= c[i + 1];
    }
    if (!up && !down) {
        return false;
    }
    real d[BAND_DEGREE_MAX + 1];
    for (int i = 0; i <= k; i++) {
        d[i] = up ? c[i] : c[k - i];
    }
    real t = before_root(k, d, largest);
    band_add(out, up ? t : 0, up ? 1 : 1 - t);
    return true;
}

void band_above(int k, const real *c, struct band *out)
{
    real largest = 0;
    int above = 0;
    for (int i = 0; i <= k; i++) {
        largest = real_max(largest, real_abs(c[i]));
        above += c[i] >= 0;
    }
    out->count = 0;
    if (above == 0) {
        return;
    }
    if (above == k + 1) {
        band_add(out, 0, 1);
        return;
    }
    if (monotone_above(k, c, largest, out)) {
        return;
    }
    struct polynomial p = {k, c, 8 * k * (REAL_EPSILON / 2) * largest};
    real at[BAND_DEGREE_MAX + 2];
    at[0] = 0;
    int gaps = 1 + guess_roots(k, c, at + 1);
    at[gaps] = 1;
    real from = 0; /* everything in [from, at[i]] is kept so far */
    for (int i = 0; i < gaps; i++) {
        real lo = at[i], hi = at[i + 1];
        if (bernstein_value(k, c, lo + (hi - lo) * (real)0.5) >= 0 || !prove_gap(&p, &lo, &hi)) {
            continue;
        }
        if (lo > 0) {
            band_add(out, from, lo);
        }
        from = hi;
    }
    if (from < 1) {
        band_add(out, from, 1);
    }
}

void band_meet(const struct band *a, const struct band *b, struct band *out)
{
    out->count = 0;
    for (int i = 0, j = 0; i < a->count && j < b->count;) {
        real lo = real_max(a->lo[i], b->lo[j]), hi = real_min(a->hi[i], b->hi[j]);
        if (lo <= hi) {
            band_add(out, lo, hi);
        }
        if (a->hi[i] < b->hi[j]) {
            i++;
        } else {
            j++;
        }
    }
}

void band_join(const struct band *a, const struct band *b, struct band *out)
{
    out->count = 0;
    for (int i = 0, j = 0; i < a->count || j < b->count;) {
        bool first = j == b->count || (i < a->count && a->lo[i] <= b->lo[j]);
        const struct band *from = first ? a : b;
        int k = first ? i++ : j++;
        band_add(out, from->lo[k], from->hi[k]);
    }
}
