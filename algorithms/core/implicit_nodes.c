/* The resultant by evaluation: balls of the determinant at positive nodes z = v / (1 - v), then interpolation
 * in the basis z^k.  It loses a few bits for each degree of the result, which only a long number type can
 * afford. */
#include "implicit.h"

#include <math.h>

#include "bernstein.h"

size_t implicit_by_nodes_scratch(int d, int e)
{
    return 2 * (size_t)d * d + 3 * (size_t)(d * e + 1);
}

/* (1 + z)^degree times a weighted coordinate, as sum of C(n, i) w_i x_i z^i; x == NULL: of the weight. */
static real form_at(const struct polygon *b, const real *x, real z)
{
    real sum = 0;
    for (int i = b->degree; i >= 0; i--) {
        real term = binomial(b->degree, i);
        term = b->w ? term * b->w[i] : term;
        sum = sum * z + (x ? term * x[i] : term);
    }
    return sum;
}

static void swap_rows(int d, real *m, int i, int j)
{
    for (int k = 0; k < 2 * d; k++) {
        real a = m[i * 2 * d + k];
        m[i * 2 * d + k] = m[j * 2 * d + k];
        m[j * 2 * d + k] = a;
    }
}

/* Row i -= (m[i][k] / m[k][k]) row k; balls are pairs (value, error), row after row. */
static void eliminate(int d, real *m, int i, int k)
{
    const real eps = REAL_EPSILON;
    real *row = m + i * 2 * d;
    const real *pivot = m + k * 2 * d;
    real p = real_abs(pivot[2 * k]), factor = row[2 * k] / pivot[2 * k];
    real size = real_abs(factor);
    real error = (row[2 * k + 1] + size * pivot[2 * k + 1]) / (p - pivot[2 * k + 1]) + 2 * eps * size;
    for (int j = k + 1; j < d; j++) {
        real product = factor * pivot[2 * j];
        row[2 * j] -= product;
        row[2 * j + 1] += error * (real_abs(pivot[2 * j]) + pivot[2 * j + 1]) + size * pivot[2 * j + 1] +
                          eps * (real_abs(product) + real_abs(row[2 * j]));
    }
}

/* Multiplies the ball (value, error) by another. */
static void multiply_ball(real *ball, real value, real error)
{
    ball[1] = ball[1] * (real_abs(value) + error) + real_abs(ball[0]) * error;
    ball[0] *= value;
    ball[1] += REAL_EPSILON * real_abs(ball[0]);
}

/* Ball of the determinant by elimination with row exchange, every operation with its error.  Where no pivot
 * is surely different from 0, what is left is bounded by the product of its row sums. */
static void determinant(int d, real *m, real ball[2])
{
    ball[0] = 1;
    ball[1] = 0;
    for (int k = 0; k < d; k++) {
        int best = k;
        for (int i = k + 1; i < d; i++) {
            if (real_abs(m[i * 2 * d + 2 * k]) > real_abs(m[best * 2 * d + 2 * k])) {
                best = i;
            }
        }
        if (best != k) {
            swap_rows(d, m, best, k);
            ball[0] = -ball[0];
        }
        if (real_abs(m[k * 2 * d + 2 * k]) <= 2 * m[k * 2 * d + 2 * k + 1]) {
            for (int i = k; i < d; i++) {
                real sum = 0;
                for (int j = k; j < d; j++) {
                    sum += real_abs(m[i * 2 * d + 2 * j]) + m[i * 2 * d + 2 * j + 1];
                }
                multiply_ball(ball, 0, sum);
            }
            return;
        }
        for (int i = k + 1; i < d; i++) {
            eliminate(d, m, i, k);
        }
        multiply_ball(ball, m[k * 2 * d + 2 * k], m[k * 2 * d + 2 * k + 1]);
    }
}

/* det of the Bezout matrix at the point of b with parameter z, times (weight of b)^d (1 + z)^N.  The point is
 * within (8e + 8) u max|b| in each coordinate, the weight relatively within (4e + 2) u: all weights are
 * positive. */
static void value_at(const struct polygon *a, const struct polygon *b, real z, real *m, real ball[2])
{
    const int d = a->degree, e = b->degree;
    real weight = form_at(b, NULL, z), most = 0;
    real x = form_at(b, b->x, z) / weight, y = form_at(b, b->y, z) / weight;
    for (int i = 0; i <= e; i++) {
        most = real_max(most, real_max(real_abs(b->x[i]), real_abs(b->y[i])));
    }
    const struct polygon point = {0, &x, &y, &weight, b->error + (4 * e + 4) * REAL_EPSILON * most};
    implicit_matrix(a, &point, m);
    for (int k = 0; k < d; k++) {
        for (int l = 0; l < k; l++) {
            m[2 * (k * d + l)] = m[2 * (l * d + k)];
            m[2 * (k * d + l) + 1] = m[2 * (l * d + k) + 1];
        }
    }
    determinant(d, m, ball);
    ball[1] += d * (4 * e + 2) * REAL_EPSILON * real_abs(ball[0]);
}

/* Coefficients of the polynomial in z with the values f at increasing positive nodes, in place (A. Bjorck, V.
 * Pereyra 1970).  |error| <= 7n u |V^-1| |f| (N. Higham, Accuracy and Stability of Numerical Algorithms,
 * section 22.3); V^-1 has alternating signs, so for values of alternating signs the result is |V^-1| |f| up
 * to signs. */
static void interpolate(int n, const real *z, real *f)
{
    for (int k = 0; k < n; k++) {
        for (int i = n; i > k; i--) {
            f[i] = (f[i] - f[i - 1]) / (z[i] - z[i - k - 1]);
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int i = k; i < n; i++) {
            f[i] -= z[k] * f[i + 1];
        }
    }
}

void implicit_by_nodes(const struct polygon *a, const struct polygon *b, real *scratch, real *c, real *error)
{
    const int n = a->degree * b->degree;
    real *m = scratch, *z = m + 2 * a->degree * a->degree, *value = z + n + 1, *off = value + n + 1;
    for (int i = 0; i <= n; i++) {
        double angle = (2 * i + 1) * (3.14159265358979 / (4 * n + 4)); /* exact nodes need no exact angles */
        real ball[2];
        z[i] = tan(angle) * tan(angle); /* v = sin^2: the zeros of a Chebyshev polynomial */
        value_at(a, b, z[i], m, ball);
        value[i] = ball[0];
        off[i] = ball[1] + (4 * n) * REAL_EPSILON * real_abs(ball[0]);
        off[i] = i % 2 ? -off[i] : off[i];
    }
    interpolate(n, z, value);
    interpolate(n, z, off);
    for (int i = 0; i <= n; i++) {
        off[i] = real_abs(off[i]);
    }
    implicit_unscale(n, value, c, error);
}
