#include "hull.h"

/* Least and greatest crossing times n of the segments between points below and above 0. */
static inline real first_crossing(int n, const real *c)
{
    real first = n;
    for (int i = 0; i < n; i++) {
        if (c[i] >= 0) {
            continue;
        }
        for (int j = i + 1; j <= n; j++) {
            if (c[j] >= 0) {
                real x = i + (real)(j - i) * (c[i] / (c[i] - c[j]));
                first = x < first ? x : first;
            }
        }
    }
    return first;
}

static inline real last_crossing(int n, const real *c)
{
    real last = 0;
    for (int j = n; j > 0; j--) {
        if (c[j] >= 0) {
            continue;
        }
        for (int i = j - 1; i >= 0; i--) {
            if (c[i] >= 0) {
                real x = j - (real)(j - i) * (c[j] / (c[j] - c[i]));
                last = x > last ? x : last;
            }
        }
    }
    return last;
}

int hull_meet(int n, const real *c, int sign, real *lo, real *hi)
{
    real b[65];
    int above = 0;
    for (int i = 0; i <= n; i++) {
        b[i] = sign < 0 ? -c[i] : c[i];
        above += b[i] >= 0;
    }
    if (above == 0) {
        return 0;
    }
    if (above == n + 1) {
        return 1;
    }
    real a = *lo, z = *hi;
    const real pad = 4 * REAL_EPSILON;
    if (b[0] < 0) {
        a = real_max(a, first_crossing(n, b) / n - pad);
    }
    if (b[n] < 0) {
        z = real_min(z, last_crossing(n, b) / n + pad);
    }
    if (a > z) {
        return 0;
    }
    *lo = a;
    *hi = z;
    return 1;
}
