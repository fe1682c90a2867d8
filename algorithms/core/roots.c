#include "roots.h"

#include "bernstein.h"

enum { STACK_MAX = REAL_BITS + 16 }; /* intervals waiting: one for each halving of [0, 1] */

size_t roots_scratch(int n)
{
    return 3 * ((size_t)n + 1) + 2 * STACK_MAX;
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

/* Most sign changes of any sequence within the errors of c. */
static int sign_changes(int n, const real *c, const real *error)
{
    int changes = 0, last = 0;
    for (int i = 0; i <= n; i++) {
        int sign = c[i] > error[i] ? 1 : c[i] < -error[i] ? -1 : 0;
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

/* The polynomial between errors, and room for its coefficients and errors over a cell.  `noise` bounds the
 * errors over [0, 1]; it contains those of cutting, 8n u |c| (bernstein.h), and passes through the cut as |c|
 * does. */
struct band {
    int n;
    const real *c;
    real *error, *cut, *cut_error;
    real noise;
};

/* Errors of the coefficients over a cell; returns the largest. */
static real cut_errors(const struct band *b, real lo, real hi)
{
    bernstein_restrict(b->n, 1, b->error, lo, hi, b->cut_error);
    return largest(b->n, b->cut_error);
}

/* Counts roots over intervals around r, wider and wider, up to the neighbours: close to a root of
 * multiplicity k all coefficients drown in the error, farther off k sign changes stand out. */
static void count_roots(const struct band *b, real left, real right, struct root *r)
{
    const int n = b->n;
    real reach = real_max(r->hi - r->lo, 4 * REAL_EPSILON);
    r->at_most = n;
    r->single = false;
    for (bool all = false; !all && !r->single; reach = 8 * reach) {
        real lo = r->lo - reach, hi = r->hi + reach;
        all = lo <= left && hi >= right;
        lo = real_max(lo, left);
        hi = real_min(hi, right);
        bernstein_restrict(n, 1, b->c, lo, hi, b->cut);
        cut_errors(b, lo, hi);
        int most = sign_changes(n, b->cut, b->cut_error);
        r->at_most = most < r->at_most ? most : r->at_most;
        r->single =
            most == 1 && real_abs(b->cut[0]) > b->cut_error[0] && real_abs(b->cut[n]) > b->cut_error[n];
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

/* Narrows a cell; 0: it is empty, 1: it may become narrower yet, 2: the errors forbid it.  Errors over the
 * cell itself are looked at where those over [0, 1] are too large. */
static int shrink(const struct band *b, real *lo, real *hi)
{
    const real left = *lo, right = *hi;
    bernstein_restrict(b->n, 1, b->c, left, right, b->cut);
    if (!clip(b->n, b->cut, b->noise, lo, hi)) {
        return 0;
    }
    real size = largest(b->n, b->cut);
    if (size > 8 * b->noise) {
        return 1;
    }
    real noise = cut_errors(b, left, right);
    *lo = left;
    *hi = right;
    return !clip(b->n, b->cut, noise, lo, hi) ? 0 : size > 2 * noise ? 1 : 2;
}

/* Every cell is cut from c itself between its exact ends, so that rounding does not grow with the depth. */
int roots_find(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
               struct root *out)
{
    struct band b = {n, c, scratch, scratch + n + 1, scratch + 2 * (n + 1), 0};
    real *stack = scratch + 3 * (n + 1);
    int waiting = 1, count = 0;
    for (int i = 0; i <= n; i++) {
        b.error[i] = error[i] + 4 * n * REAL_EPSILON * real_abs(c[i]);
        b.error[i] += b.error[i] / 64; /* the rounding of the bounds themselves, and of cutting them */
    }
    b.noise = largest(n, b.error);
    stack[0] = 0;
    stack[1] = 1;
    while (waiting > 0) {
        real lo = stack[2 * --waiting], hi = stack[2 * waiting + 1], width = hi - lo;
        int may_shrink = shrink(&b, &lo, &hi);
        if (may_shrink == 0) {
            continue;
        }
        real middle = lo + (hi - lo) / 2;
        bool stuck = waiting + 2 > STACK_MAX || middle <= lo || middle >= hi;
        if (hi - lo <= tolerance || stuck || may_shrink == 2) {
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
        count_roots(&b, i > 0 ? out[i - 1].hi : 0, i + 1 < count ? out[i + 1].lo : 1, &out[i]);
    }
    return count;
}
