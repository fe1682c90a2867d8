#include "reduce.h"

size_t reduction_length(int n, int k)
{
    return k < n ? 2 * (size_t)(n + 1) * (size_t)(k + 1) : 0;
}

static long choose(int n, int i)
{
    long b = 1;
    if (i < 0 || i > n) {
        return 0;
    }
    for (int j = 1; j <= i; j++) {
        b = b * (n - i + j) / j;
    }
    return b;
}

/* D times the integral of L_j B(i,n) over [0, 1], D = (n+1)(n+2)...(n+1+k), L_j the shifted Legendre
 * polynomial sum over l of (-1)^(j-l) C(j,l) C(j+l,l) t^l; the integral of t^l B(i,n) is (i+1)...(i+l) /
 * ((n+1)...(n+1+l)).  Below 2^42 for n <= 32, k <= 5. */
static long legendre_moment(int n, int k, int j, int i)
{
    long sum = 0;
    for (int l = 0; l <= j; l++) {
        long term = choose(j, l) * choose(j + l, l);
        for (int q = 1; q <= l; q++) {
            term *= i + q;
        }
        for (int q = l + 1; q <= k; q++) {
            term *= n + 1 + q;
        }
        sum += (j - l) % 2 ? -term : term;
    }
    return sum;
}

/* C(k,r) times the coefficient r of L_j in degree k: in degree j it is (-1)^(j+q) C(j,q), then elevated. */
static long legendre_coefficient(int k, int j, int r)
{
    long sum = 0;
    for (int q = 0; q <= j; q++) {
        long term = choose(j, q) * choose(j, q) * choose(k - j, r - q);
        sum += (j + q) % 2 ? -term : term;
    }
    return sum;
}

void reduction_init(struct reduction *r, int n, int k, real *memory)
{
    r->n = n;
    r->k = k < n ? k : n;
    if (k >= n) {
        r->reduce = r->elevate = NULL;
        return;
    }
    real *reduce = memory, *elevate = memory + (k + 1) * (n + 1);
    long common = 1;
    long coefficient[REDUCED_MAX + 1][REDUCED_MAX + 1];
    for (int q = 1; q <= k + 1; q++) {
        common *= n + q;
    }
    for (int j = 0; j <= k; j++) {
        for (int row = 0; row <= k; row++) {
            coefficient[j][row] = (2 * j + 1) * legendre_coefficient(k, j, row);
        }
    }
    for (int i = 0; i <= n; i++) {
        long moment[REDUCED_MAX + 1];
        for (int j = 0; j <= k; j++) {
            moment[j] = legendre_moment(n, k, j, i);
        }
        for (int row = 0; row <= k; row++) {
            long sum = 0;
            for (int j = 0; j <= k; j++) {
                sum += coefficient[j][row] * moment[j];
            }
            reduce[row * (n + 1) + i] = (real)sum / ((real)common * (real)choose(k, row));
            elevate[i * (k + 1) + row] = (real)(choose(k, row) * choose(n - k, i - row)) / (real)choose(n, i);
        }
    }
    r->reduce = reduce;
    r->elevate = elevate;
}

void reduction_apply(const struct reduction *r, int components, const real *c, real *out)
{
    int length = r->n + 1;
    if (!r->reduce) {
        for (int i = 0; i < components * length; i++) {
            out[i] = c[i];
        }
        return;
    }
    const real *a = r->reduce;
    for (int row = 0; row <= r->k; row++, a += length) {
        if (components == 2) { /* a polynomial curve: both coordinates in one pass over the matrix */
            real x = 0, y = 0;
            for (int i = 0; i < length; i++) {
                x += a[i] * c[i];
                y += a[i] * c[length + i];
            }
            out[row] = x;
            out[r->k + 1 + row] = y;
            continue;
        }
        for (int j = 0; j < components; j++) {
            real sum = 0;
            for (int i = 0; i < length; i++) {
                sum += a[i] * c[j * length + i];
            }
            out[j * (r->k + 1) + row] = sum;
        }
    }
}

real reduction_residual(const struct reduction *r, int components, const real *c, const real *q,
                        real *residual)
{
    int length = r->n + 1, reduced = r->k + 1;
    real largest = 0, rest = 0;
    if (!r->reduce) {
        for (int i = 0; i < components * length; i++) {
            residual[i] = 0;
        }
        return 0;
    }
    for (int j = 0; j < components * reduced; j++) {
        largest = real_max(largest, real_abs(q[j]));
    }
    for (int j = 0; j < components; j++, c += length, q += reduced, residual += length) {
        const real *a = r->elevate;
        for (int i = 0; i < length; i++, a += reduced) {
            real sum = a[0] * q[0];
            for (int l = 1; l < reduced; l++) {
                sum += a[l] * q[l];
            }
            residual[i] = c[i] - sum;
            rest = real_max(rest, real_abs(residual[i]));
        }
    }
    return ((r->k + 4) * largest + rest) * (REAL_EPSILON / 2);
}
