#include "signs.h"

#include "../core/bernstein.h"
#include "../core/roots.h"

enum { STACK = REAL_BITS + 8, ROOTS = FORM_MAX };

/* ---- positivity ---- */

/* 1: no coefficient is below its bound; -1: one at an end of the cell is, and *at tells which end; 0: else.
 */
static int look(int n, const real *c, const real *bound, int *at)
{
    bool all = true;
    for (int i = 0; i <= n; i++) {
        all = all && c[i] >= -bound[i];
    }
    *at = c[0] < -bound[0] ? 0 : 1;
    return all ? 1 : c[0] < -bound[0] || c[n] < -bound[n] ? -1 : 0;
}

enum verdict form_holds(struct region_work *k, int n, const real *c, const real *bound, real *where)
{
    real both[2 * FORM_MAX], cut[2 * FORM_MAX], stack[2 * STACK];
    int at, waiting = 0, seen = look(n, c, bound, &at);
    if (seen != 0) {
        *where = at;
        return seen > 0 ? HOLDS : FAILS;
    }
    for (int i = 0; i <= n; i++) {
        both[i] = c[i];
        both[n + 1 + i] = bound[i];
    }
    stack[waiting++] = 0;
    stack[waiting++] = 1;
    while (waiting > 0) {
        real hi = stack[--waiting], lo = stack[--waiting], middle = lo + (hi - lo) / 2;
        if (k->steps++ >= k->max_steps || waiting + 4 > 2 * STACK || middle <= lo || middle >= hi) {
            return UNSURE;
        }
        const real ends[3] = {lo, middle, hi};
        for (int half = 1; half >= 0; half--) {
            bernstein_restrict(n, 2, both, ends[half], ends[half + 1], cut);
            seen = look(n, cut, cut + n + 1, &at);
            if (seen < 0) {
                *where = ends[half + at];
                return FAILS;
            }
            if (seen == 0) {
                stack[waiting++] = ends[half];
                stack[waiting++] = ends[half + 1];
            }
        }
    }
    return HOLDS;
}

/* ---- roots ---- */

/* The sign change between lo and hi, by Newton's steps where they stay inside and halving where not. */
static real polish(int n, const real *c, real lo, real hi)
{
    real scratch[FORM_MAX], slope, t = lo + (hi - lo) / 2;
    real at_lo = bernstein_value_slope(n, c, lo, scratch, &slope);
    real at_hi = bernstein_value_slope(n, c, hi, scratch, &slope);
    if (at_lo == 0 || at_hi == 0 || (at_lo < 0) == (at_hi < 0)) {
        return at_lo == 0 ? lo : at_hi == 0 ? hi : t;
    }
    t = lo + (hi - lo) * (at_lo / (at_lo - at_hi));
    for (int i = 0; i < 2 * REAL_BITS; i++) {
        real f = bernstein_value_slope(n, c, t, scratch, &slope);
        if (f == 0) {
            return t;
        }
        if ((f < 0) == (at_lo < 0)) {
            lo = t;
        } else {
            hi = t;
        }
        real step = slope != 0 ? f / slope : (real)1, next = t - step;
        if (!(next > lo && next < hi)) {
            if (real_abs(step) <= 2 * REAL_EPSILON * t || hi - lo <= 2 * REAL_EPSILON * hi) {
                return t;
            }
            next = lo + (hi - lo) / 2;
        } else if (real_abs(next - t) <= REAL_EPSILON * t) {
            return next;
        }
        t = next;
    }
    return t;
}

/* Changes of sign among coefficients that stand out from their errors; -1 if not all do. */
static int count_changes(int n, const real *c, const real *error)
{
    int changes = 0;
    for (int i = 0; i <= n; i++) {
        if (real_abs(c[i]) <= error[i]) {
            return -1;
        }
        changes += i > 0 && (c[i] < 0) != (c[i - 1] < 0);
    }
    return changes;
}

static int sign_at(int n, const real *c, real t)
{
    real scratch[FORM_MAX], slope;
    real f = n > 0 ? bernstein_value_slope(n, c, t, scratch, &slope) : c[0];
    return f > 0 ? 1 : f < 0 ? -1 : 0;
}

/* A sign halfway between two enclosures differs from the one before where there is an odd number of roots. */
int form_crossings(struct region_work *k, int n, const real *c, const real *error, int room, real *out)
{
    struct root found[ROOTS];
    int changes = count_changes(n, c, error), count = 0;
    if (n == 0 || changes == 0) {
        return 0;
    }
    if (changes == 1 && room > 0) {
        out[0] = polish(n, c, 0, 1);
        return 1;
    }
    int roots = roots_find(n, c, error, 16 * REAL_EPSILON, k->roots, n, found);
    real left = 0;
    for (int i = 0; i < roots; i++) {
        real right = i + 1 < roots ? found[i].hi + (found[i + 1].lo - found[i].hi) / 2 : (real)1;
        bool reaches = found[i].lo <= 0 || found[i].hi >= 1;
        if (!reaches && sign_at(n, c, left) * sign_at(n, c, right) < 0) {
            if (count == room) {
                return -1;
            }
            out[count++] = polish(n, c, left, right);
        }
        left = right;
    }
    return count;
}
