#include "bernstein.h"

real bernstein_value(int n, const real *c, real t)
{
    real b[65];
    real u = 1 - t;
    for (int i = 0; i <= n; i++) {
        b[i] = c[i];
    }
    for (int k = n; k > 0; k--) {
        for (int i = 0; i < k; i++) {
            b[i] = u * b[i] + t * b[i + 1];
        }
    }
    return b[0];
}

real bernstein_value_slope(int n, const real *c, real t, real *scratch, real *slope)
{
    real *b = scratch;
    real u = 1 - t;
    for (int i = 0; i <= n; i++) {
        b[i] = c[i];
    }
    for (int k = n; k > 1; k--) {
        for (int i = 0; i < k; i++) {
            b[i] = u * b[i] + t * b[i + 1];
        }
    }
    *slope = n * (b[1] - b[0]);
    return u * b[0] + t * b[1];
}

/* One component over [0, hi], then over [lo/hi, 1] of that: weights u, h and v, r. */
static inline void cut(int n, real *c, real u, real h, real v, real r)
{
    if (u > 0) {
        for (int k = 1; k <= n; k++) {
            for (int i = n; i >= k; i--) {
                c[i] = u * c[i - 1] + h * c[i];
            }
        }
    }
    if (r > 0) {
        for (int k = 1; k <= n; k++) {
            for (int i = 0; i <= n - k; i++) {
                c[i] = v * c[i] + r * c[i + 1];
            }
        }
    }
}

/* The same for cubics, two chains at a time in registers. */
static inline void cut_3(const real *c, real u, real h, real v, real r, real *out)
{
    real c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3];
    if (u > 0) {
        c3 = u * c2 + h * c3;
        c2 = u * c1 + h * c2;
        c1 = u * c0 + h * c1;
        c3 = u * c2 + h * c3;
        c2 = u * c1 + h * c2;
        c3 = u * c2 + h * c3;
    }
    if (r > 0) {
        c0 = v * c0 + r * c1;
        c1 = v * c1 + r * c2;
        c2 = v * c2 + r * c3;
        c0 = v * c0 + r * c1;
        c1 = v * c1 + r * c2;
        c0 = v * c0 + r * c1;
    }
    out[0] = c0;
    out[1] = c1;
    out[2] = c2;
    out[3] = c3;
}

void bernstein_restrict(int n, int components, const real *c, real lo, real hi, real *out)
{
    real u = 1 - hi, v = 1, r = 0;
    if (lo > 0) {
        v = (hi - lo) / hi;
        r = lo / hi;
    }
    for (int k = 0; k < components; k++, c += n + 1, out += n + 1) {
        if (n == 3) {
            cut_3(c, u, hi, v, r, out);
            continue;
        }
        for (int i = 0; i <= n; i++) {
            out[i] = c[i];
        }
        cut(n, out, u, hi, v, r);
    }
}

void bernstein_halve(int n, int components, const real *c, real *left, real *right)
{
    const real half = (real)0.5;
    for (int k = 0; k < components; k++, c += n + 1, left += n + 1, right += n + 1) {
        for (int i = 0; i <= n; i++) {
            right[i] = c[i];
        }
        left[0] = c[0];
        for (int j = 1; j <= n; j++) {
            for (int i = 0; i <= n - j; i++) {
                right[i] = (right[i] + right[i + 1]) * half;
            }
            left[j] = right[0];
        }
    }
}

void bernstein_derivative(int n, const real *c, real *out)
{
    for (int i = 0; i < n; i++) {
        out[i] = n * (c[i + 1] - c[i]);
    }
}

void bernstein_elevate(int n, const real *c, int r, real *out)
{
    for (int i = 0; i <= n; i++) {
        out[i] = c[i];
    }
    for (int d = n + 1; d <= n + r; d++) {
        out[d] = out[d - 1];
        for (int i = d - 1; i > 0; i--) {
            out[i] = (i * out[i - 1] + (d - i) * out[i]) / d;
        }
    }
}

real binomial(int n, int i)
{
    real b = 1;
    if (i > n - i) {
        i = n - i;
    }
    for (int k = 1; k <= i; k++) {
        b = b * (real)(n - i + k) / (real)k;
    }
    return b;
}

void bernstein_multiply(int n, const real *a, int m, const real *b, real *out)
{
    for (int k = 0; k <= n + m; k++) {
        int first = k > m ? k - m : 0, last = k < n ? k : n;
        /* weight of a[i] b[k-i], and from one i to the next by the ratio of the hypergeometric weights */
        real weight = binomial(n, first) * binomial(m, k - first) / binomial(n + m, k);
        real sum = 0;
        for (int i = first; i <= last; i++) {
            sum += weight * a[i] * b[k - i];
            if (i < last) {
                weight = weight * (real)((n - i) * (k - i)) / (real)((i + 1) * (m - k + i + 1));
            }
        }
        out[k] = sum;
    }
}
