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

void form_values(int n, int components, const real *c, real t, real *out)
{
    real b[LENGTH], u = 1 - t;
    for (int k = 0; k < components; k++, c += n + 1) {
        for (int i = 0; i <= n; i++) {
            b[i] = c[i];
        }
        for (int j = n; j > 0; j--) {
            for (int i = 0; i < j; i++) {
                b[i] = u * b[i] + t * b[i + 1];
            }
        }
        out[k] = b[0];
    }
}
