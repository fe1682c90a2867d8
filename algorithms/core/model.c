#include "model.h"

/* krawtchouk[n][i][j]: coefficient of z^j in (1 + z)^i (1 - z)^(n-i). */
static const signed char krawtchouk[MODEL_MAX + 1][MODEL_MAX + 1][MODEL_MAX + 1] = {
    {{1}},
    {{1, -1}, {1, 1}},
    {{1, -2, 1}, {1, 0, -1}, {1, 2, 1}},
    {{1, -3, 3, -1}, {1, -1, -1, 1}, {1, 1, -1, -1}, {1, 3, 3, 1}},
    {{1, -4, 6, -4, 1}, {1, -2, 0, 2, -1}, {1, 0, -2, 0, 1}, {1, 2, 0, -2, -1}, {1, 4, 6, 4, 1}},
    {{1, -5, 10, -10, 5, -1},
     {1, -3, 2, 2, -3, 1},
     {1, -1, -2, 2, 1, -1},
     {1, 1, -2, -2, 1, 1},
     {1, 3, 2, -2, -3, -1},
     {1, 5, 10, 10, 5, 1}},
};

static const signed char choose[MODEL_MAX + 1][MODEL_MAX + 1] = {
    {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}};

/* B(i,n) = 2^-n C(n,i) (1 + u)^i (1 - u)^(n-i).  n + 1 roundings in each sum; since |krawtchouk[n][i][j]| <=
 * C(n,j), the coefficients err by at most (n + 1) 2^n u_0 max|b| together.  A polynomial whose Bernstein
 * coefficients are all within `off` of these differs by at most that. */
void model_of_bernstein(int n, const real *b, real off, int k, struct model *out)
{
    const real unit = (real)1 / (real)(1 << n);
    real largest = 0;
    for (int i = 0; i <= n; i++) {
        largest = real_max(largest, real_abs(b[i]));
    }
    for (int j = 0; j <= n; j++) {
        real sum = b[0] * krawtchouk[n][0][j];
        for (int i = 1; i <= n; i++) {
            sum += b[i] * (choose[n][i] * krawtchouk[n][i][j]);
        }
        out->c[j] = sum * unit;
    }
    for (int j = n + 1; j <= k; j++) {
        out->c[j] = 0;
    }
    out->k = k;
    out->rest = off + ((n + 1) * (1 << n)) * REAL_EPSILON * largest;
}

real model_size(const struct model *m, real r)
{
    real sum = real_abs(m->c[m->k]);
    for (int j = m->k - 1; j >= 0; j--) {
        sum = sum * r + real_abs(m->c[j]);
    }
    return sum;
}

real model_value(const struct model *m, real u, real *slope)
{
    real v = m->c[m->k], d = 0;
    for (int j = m->k - 1; j >= 0; j--) {
        d = d * u + v;
        v = v * u + m->c[j];
    }
    *slope = d;
    return v;
}

/* u^j has the Bernstein coefficients krawtchouk[k][i][j] / C(k,j): the blossom at i ones and k - i times -1.
 */
real model_to_bernstein(const struct model *m, real r, real *b)
{
    const int k = m->k;
    real d[MODEL_MAX + 1], power = 1, size = 0;
    for (int j = 0; j <= k; j++) {
        d[j] = m->c[j] * power;
        size += real_abs(d[j]);
        power = power * r;
        if (choose[k][j] > 1) {
            d[j] = d[j] / (int)choose[k][j];
        }
    }
    for (int i = 0; i <= k; i++) {
        real sum = d[0];
        for (int j = 1; j <= k; j++) {
            sum += d[j] * (int)krawtchouk[k][i][j];
        }
        b[i] = sum;
    }
    return (2 * k + 4) * (REAL_EPSILON / 2) * size;
}

void model_shift(struct model *m, real at)
{
    for (int i = 0; i < m->k; i++) {
        for (int j = m->k - 1; j >= i; j--) {
            m->c[j] += at * m->c[j + 1];
        }
    }
}

/* Horner's scheme.  One stage multiplies by q and adds a coefficient of p: the kept sums err by k + 2
 * roundings, relative to |out| |q| + |p_j|; what is dropped is at most the sum of |out_i| |q_j| over i + j >
 * k. */
void model_compose(const struct model *p, const struct model *q, struct model *out)
{
    const int k = p->k;
    const real u = REAL_EPSILON / 2;
    real tail[MODEL_MAX + 2]; /* sum of |q_l| over l >= j */
    tail[k + 1] = 0;
    for (int j = k; j >= 1; j--) {
        tail[j] = tail[j + 1] + real_abs(q->c[j]);
    }
    out->k = k;
    out->c[0] = p->c[k];
    out->rest = 0;
    for (int top = 0, j = k - 1; j >= 0; j--) {
        real size = 0, dropped = 0, product[MODEL_MAX + 1];
        for (int i = 0; i <= top; i++) {
            real c = real_abs(out->c[i]);
            size += c;
            if (i > 0) {
                dropped += c * tail[k - i + 1];
            }
        }
        for (int l = 1; l <= k; l++) {
            real sum = 0;
            for (int i = l - 1 < top ? l - 1 : top; i >= 0; i--) {
                sum += out->c[i] * q->c[l - i];
            }
            product[l] = sum;
        }
        for (int l = 1; l <= k; l++) {
            out->c[l] = product[l];
        }
        out->c[0] = p->c[j];
        out->rest = out->rest * tail[1] + dropped + (k + 2) * u * (size * tail[1] + real_abs(p->c[j]));
        top = k;
    }
    out->rest += out->rest / 64;
}
