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

/* first_crossing for cubics, unrolled; backwards it is 3 minus the last crossing. */
static inline real first_crossing_3(real c0, real c1, real c2, real c3)
{
    real first = 3;
    if (c3 >= 0) {
        first = 3 * c0 / (c0 - c3);
    }
    if (c2 >= 0) {
        first = real_min(first, 2 * c0 / (c0 - c2));
    }
    if (c1 >= 0) {
        return real_min(first, c0 / (c0 - c1));
    }
    if (c3 >= 0) {
        first = real_min(first, (3 * c1 - c3) / (c1 - c3));
    }
    if (c2 >= 0) {
        return real_min(first, (2 * c1 - c2) / (c1 - c2));
    }
    return c3 >= 0 ? real_min(first, (3 * c2 - 2 * c3) / (c2 - c3)) : first;
}

/* The same interval for cubics. */
static inline int hull_meet_3(const real *c, real *lo, real *hi)
{
    real c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3], a = *lo, z = *hi;
    const real pad = 4 * REAL_EPSILON, third = (real)1 / 3;
    if (c0 < 0) {
        if (c1 < 0 && c2 < 0 && c3 < 0) {
            return 0;
        }
        a = real_max(a, first_crossing_3(c0, c1, c2, c3) * third - pad);
    }
    if (c3 < 0) {
        z = real_min(z, 1 - first_crossing_3(c3, c2, c1, c0) * third + pad);
    }
    if (a > z) {
        return 0;
    }
    *lo = a;
    *hi = z;
    return 1;
}

int hull_meet(int n, const real *c, real *lo, real *hi)
{
    if (n == 3) {
        return hull_meet_3(c, lo, hi);
    }
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
