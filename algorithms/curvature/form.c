#include "form.h"

enum { LENGTH = 97 };

size_t pascal_size(int rows)
{
    return (size_t)(rows + 1) * (size_t)(rows + 2) / 2;
}

void pascal_fill(int rows, real *pascal)
{
    for (int n = 0; n <= rows; n++) {
        const real *above = pascal - n;
        pascal[0] = pascal[n] = 1;
        for (int i = 1; i < n; i++) {
            pascal[i] = above[i - 1] + above[i];
        }
        pascal += n + 1;
    }
}

void form_scale(int n, const real *pascal, const real *c, real *out)
{
    const real *row = pascal_row(pascal, n);
    for (int i = 0; i <= n; i++) {
        out[i] = c[i] * row[i];
    }
}

void form_unscale(int n, const real *pascal, const real *c, real *out)
{
    const real *row = pascal_row(pascal, n);
    for (int i = 0; i <= n; i++) {
        out[i] = c[i] / row[i];
    }
}

void form_add_product(int n, const real *a, int m, const real *b, int factor, real *sum)
{
    for (int i = 0; i <= n; i++) {
        real ai = factor < 0 ? -a[i] : a[i];
        if (ai == 0) {
            continue;
        }
        for (int j = 0; j <= m; j++) {
            sum[i + j] += ai * b[j];
        }
    }
}

void form_clear(int n, real *c)
{
    for (int i = 0; i <= n; i++) {
        c[i] = 0;
    }
}

/* The n + 1 Bernstein polynomials at t. */
static void basis(int n, const real *pascal, real t, real *b)
{
    const real *row = pascal_row(pascal, n);
    real u = 1 - t, power = 1;
    for (int i = 0; i <= n; i++) {
        b[i] = row[i] * power;
        power = power * t;
    }
    power = u;
    for (int i = n - 1; i >= 0; i--) {
        b[i] = b[i] * power;
        power = power * u;
    }
}

void form_values(int n, int components, const real *pascal, const real *c, real t, real *out)
{
    real b[LENGTH];
    basis(n, pascal, t, b);
    for (int k = 0; k < components; k++, c += n + 1) {
        real sum = c[0] * b[0];
        for (int i = 1; i <= n; i++) {
            sum += c[i] * b[i];
        }
        out[k] = sum;
    }
}

void form_values_slopes(int n, int components, const real *pascal, const real *c, real t, real *value,
                        real *slope)
{
    real b[LENGTH];
    if (n > 0) {
        basis(n - 1, pascal, t, b);
    }
    for (int k = 0; k < components; k++, c += n + 1) {
        real left = 0, right = 0;
        for (int i = 0; i < n; i++) {
            left += c[i] * b[i];
            right += c[i + 1] * b[i];
        }
        value[k] = n > 0 ? (1 - t) * left + t * right : c[0];
        slope[k] = 0;
        for (int i = 0; i < n; i++) {
            slope[k] += (c[i + 1] - c[i]) * b[i];
        }
        slope[k] = n * slope[k];
    }
}

real form_value_slope(int n, const real *pascal, const real *c, real t, real *slope)
{
    real value;
    form_values_slopes(n, 1, pascal, c, t, &value, slope);
    return value;
}
