#include "hull.h"

/* Least and greatest crossing, times n, of the segments between points below and above 0.  The segment from i
 * to j crosses at (j c[i] - i c[j]) / (c[i] - c[j]), sums of terms of one sign: relative error 4 u. */
static inline real first_crossing(int n, const real *c)
{
    real first = n, ri = 0;
    for (int i = 0; i < n; i++, ri += 1) {
        if (c[i] >= 0) {
            break; /* segments from later points begin behind the crossing that leads up to i */
        }
        real rj = ri + 1;
        for (int j = i + 1; j <= n; j++, rj += 1) {
            if (c[j] >= 0) {
                first = real_min(first, (rj * c[i] - ri * c[j]) / (c[i] - c[j]));
            }
        }
    }
    return first;
}

static inline real last_crossing(int n, const real *c)
{
    real last = 0, rj = n;
    for (int j = n; j > 0; j--, rj -= 1) {
        if (c[j] >= 0) {
            break;
        }
        real ri = rj - 1;
        for (int i = j - 1; i >= 0; i--, ri -= 1) {
            if (c[i] >= 0) {
                last = real_max(last, (rj * c[i] - ri * c[j]) / (c[i] - c[j]));
            }
        }
    }
    return last;
}

int hull_meet(int n, const real *c, real *lo, real *hi)
{
    int above = 0;
    for (int i = 0; i <= n; i++) {
        above += c[i] >= 0;
    }
    if (above == 0) {
        return 0;
    }
    if (above == n + 1) {
        return 1;
    }
    real a = *lo, z = *hi;
    const real pad = 4 * REAL_EPSILON;
    if (c[0] < 0) {
        a = real_max(a, first_crossing(n, c) / n - pad);
    }
    if (c[n] < 0) {
        z = real_min(z, last_crossing(n, c) / n + pad);
    }
    if (a > z) {
        return 0;
    }
    *lo = a;
    *hi = z;
    return 1;
}
