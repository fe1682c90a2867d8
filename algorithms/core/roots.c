#include "roots.h"

#include "bernstein.h"

enum { STACK_MAX = REAL_BITS + 16 }; /* intervals waiting: one for each halving of [0, 1] */

size_t roots_scratch(int n)
{
    return (size_t)n + 1 + 2 * STACK_MAX;
}

/* Left end, times n, of {hull of (i, sign c[i] - error) is not above 0}, if sign c[0] > error; else 0.  It
 * lies on a segment from a point above to a later point that is not (hull.h), so it is the least crossing of
 * these. step = -1 looks from the other end.  n + 1 if all points are above. */
static real first_crossing(int n, const real *c, int step, real error)
{
    real sign = c[0] < 0 ? -1 : 1;
    real first = n + 1;
    if (sign * c[0] <= error) {
        return 0;
    }
    for (int j = 1; j <= n; j++) {
        real below = sign * c[step * j] - error;
        if (below > 0) {
            continue;
        }
        for (int i = 0; i < j && i < first; i++) {
            real above = sign * c[step * i] - error;
            if (above > 0) {
                first = real_min(first, i + (j - i) * (above / (above - below)));
            }
        }
    }
    return first;
}

/* Narrows [lo, hi], over which c are the coefficients, to where the hull of the band meets 0; false: nowhere.
 * The quotients have relative error 3u, their sum with i and the division by n two more: 5u <= 4 eps of the
 * width; the map to [lo, hi] adds 3u of the width and u of the result. */
static bool clip(int n, const real *c, real error, real *lo, real *hi)
{
    real left = first_crossing(n, c, 1, error);
    if (left > n) {
        return false;
    }
    real right = first_crossing(n, c + n, -1, error);
    real width = *hi - *lo;
    real pad = (4 * width + *hi) * REAL_EPSILON;
    real a = *lo + width * (left / n) - pad, b = *hi - width * (right / n) + pad;
    if (right > n || a > b) {
        return false;
    }
    *lo = real_max(*lo, a);
    *hi = real_min(*hi, b);
    return true;
}

/* Most sign changes of any sequence within `error` of c. */
static int sign_changes(int n, const real *c, real error)
{
    int changes = 0, last = 0;
    for (int i = 0; i <= n; i++) {
        int sign = c[i] > error ? 1 : c[i] < -error ? -1 : 0;
        if (sign == 0) {
            changes++; /* it may differ from what stands before; before the first, from what comes after */
            last = -last;
        } else {
            changes += last == -sign;
            last = sign;
        }
    }
    return changes < n ? changes : n;
}

static real largest(int n, const real *c)
{
    real most = 0;
    for (int i = 0; i <= n; i++) {
        most = real_max(most, real_abs(c[i]));
    }
    return most;
}

/* Counts roots over intervals around r, wider and wider, up to the neighbours: close to a root of
 * multiplicity k all coefficients drown in the error, farther off k sign changes stand out. */
static void count_roots(int n, const real *c, real error, real left, real right, real *scratch,
                        struct root *r)
{
    real reach = real_max(r->hi - r->lo, 4 * REAL_EPSILON);
    r->at_most = n;
    r->single = false;
    for (bool all = false; !all && r->at_most > 1; reach = 8 * reach) {
        real lo = r->lo - reach, hi = r->hi + reach;
        all = lo <= left && hi >= right;
        lo = real_max(lo, left);
        hi = real_min(hi, right);
        bernstein_restrict(n, 1, c, lo, hi, scratch);
        int most = sign_changes(n, scratch, error);
        r->at_most = most < r->at_most ? most : r->at_most;
        r->single = most == 1 && real_abs(scratch[0]) > error && real_abs(scratch[n]) > error;
    }
}

static int keep(real lo, real hi, int count, int room, struct root *out)
{
    if (count > 0 && (lo <= out[count - 1].hi || count == room)) {
        out[count - 1].hi = hi;
        return count;
    }
    out[count].lo = lo;
    out[count].hi = hi;
    return count + 1;
}

/* Every cell is cut from c itself between its exact ends: 8n u max|c| once (bernstein.h), whatever the depth.
 */
int roots_find(int n, const real *c, real error, real tolerance, real *scratch, int room, struct root *out)
{
    real *q = scratch, *stack = scratch + n + 1;
    int waiting = 1, count = 0;
    const real noise = error + 4 * n * REAL_EPSILON * largest(n, c);
    stack[0] = 0;
    stack[1] = 1;
    while (waiting > 0) {
        real lo = stack[2 * --waiting], hi = stack[2 * waiting + 1];
        bernstein_restrict(n, 1, c, lo, hi, q);
        real width = hi - lo;
        if (!clip(n, q, noise, &lo, &hi)) {
            continue;
        }
        real middle = lo + (hi - lo) / 2;
        bool stuck = waiting + 2 > STACK_MAX || middle <= lo || middle >= hi;
        if (hi - lo <= tolerance || stuck || largest(n, q) <= 2 * noise) {
            count = keep(lo, hi, count, room, out);
            continue;
        }
        if (5 * (hi - lo) > 4 * width) {
            stack[2 * waiting] = middle;
            stack[2 * waiting++ + 1] = hi;
            hi = middle;
        }
        stack[2 * waiting] = lo;
        stack[2 * waiting++ + 1] = hi;
    }
    for (int i = 0; i < count; i++) {
        real left = i > 0 ? out[i - 1].hi : 0, right = i + 1 < count ? out[i + 1].lo : 1;
        count_roots(n, c, noise, left, right, q, &out[i]);
    }
    return count;
}
