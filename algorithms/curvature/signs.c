#include "signs.h"

#include "form.h"

#include "../core/bernstein.h"
#include "../core/roots.h"

enum { STACK = REAL_BITS + 8, ROOTS = FORM_MAX, HALVINGS = 10 };

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

/* The rest of [0, 1] from lo to hi, cell by cell cut from the original. */
static enum verdict search(struct region_work *k, int n, const real *both, real lo, real hi, real *where)
{
    real cut[2 * FORM_MAX], stack[2 * STACK];
    int at, seen, waiting = 0;
    stack[waiting++] = lo;
    stack[waiting++] = hi;
    while (waiting > 0) {
        hi = stack[--waiting];
        lo = stack[--waiting];
        real middle = lo + (hi - lo) / 2;
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

static real least(int n, const real *c)
{
    real low = c[0];
    for (int i = 1; i <= n; i++) {
        low = real_min(low, c[i]);
    }
    return low;
}

static void copy(int n, const real *from, real *to)
{
    for (int i = 0; i <= n; i++) {
        to[i] = from[i];
    }
}

static real largest(int n, const real *c)
{
    real high = c[0];
    for (int i = 1; i <= n; i++) {
        high = real_max(high, c[i]);
    }
    return high;
}

/* A few halvings with one bound for all coefficients settle most forms. */
enum verdict form_holds(struct region_work *k, int n, const real *c, const real *bound, real *where)
{
    real half[HALVINGS + 2][FORM_MAX], both[2 * FORM_MAX], hi[HALVINGS + 2], lo = 0;
    int at, top = 0, halvings = 0, seen = look(n, c, bound, &at);
    if (seen != 0) {
        *where = at;
        return seen > 0 ? HOLDS : FAILS;
    }
    real low = least(n, bound), high = largest(n, bound);
    copy(n, c, both);
    copy(n, bound, both + n + 1);
    copy(n, c, half[0]);
    hi[0] = 1;
    while (top >= 0) {
        real *now = half[top];
        if (least(n, now) >= -low) {
            lo = hi[top--];
        } else if (now[0] < -high || now[n] < -high) {
            *where = now[0] < now[n] ? lo : hi[top];
            return FAILS;
        } else if (halvings == HALVINGS) {
            return search(k, n, both, lo, 1, where);
        } else {
            real cell[FORM_MAX];
            k->steps++;
            halvings++;
            copy(n, now, cell);
            bernstein_halve(n, 1, cell, half[top + 1], now);
            hi[top + 1] = lo + (hi[top] - lo) / 2;
            top++;
        }
    }
    return HOLDS;
}

/* ---- roots ---- */

/* The sign change between lo and hi, by Newton's steps where they stay inside and halving where not. */
static real polish(int n, const real *pascal, const real *c, real lo, real hi)
{
    real slope, t = lo + (hi - lo) / 2;
    real at_lo = lo == 0 ? c[0] : form_value_slope(n, pascal, c, lo, &slope);
    real at_hi = hi == 1 ? c[n] : form_value_slope(n, pascal, c, hi, &slope);
    if (at_lo == 0 || at_hi == 0 || (at_lo < 0) == (at_hi < 0)) {
        return at_lo == 0 ? lo : at_hi == 0 ? hi : t;
    }
    t = lo + (hi - lo) * (at_lo / (at_lo - at_hi));
    for (int i = 0; i < 2 * REAL_BITS; i++) {
        real f = form_value_slope(n, pascal, c, t, &slope);
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

/* Splits [0, 1] until every part has one change of sign or none.  -1: the errors, or roots that are close,
 * forbid it. */
static int isolate(int n, const real *pascal, const real *c, const real *error, int room, real *out)
{
    real half[HALVINGS + 2][FORM_MAX], hi[HALVINGS + 2], lo = 0, noise = 0;
    int top = 0, count = 0, halvings = 0;
    for (int i = 0; i <= n; i++) {
        noise = real_max(noise, error[i]);
    }
    copy(n, c, half[0]);
    hi[0] = 1;
    while (top >= 0) {
        real *now = half[top];
        int changes = 0;
        for (int i = 1; i <= n; i++) {
            changes += (now[i] < 0) != (now[i - 1] < 0);
        }
        if (real_abs(now[0]) <= noise || real_abs(now[n]) <= noise || count == room ||
            (changes > 1 && halvings++ == HALVINGS)) {
            return -1;
        }
        if (changes > 1) {
            real cell[FORM_MAX];
            copy(n, now, cell);
            bernstein_halve(n, 1, cell, half[top + 1], now);
            hi[top + 1] = lo + (hi[top] - lo) / 2;
            top++;
            continue;
        }
        if (changes == 1) {
            out[count++] = polish(n, pascal, c, lo, hi[top]);
        }
        lo = hi[top--];
    }
    return count;
}

static int sign_at(int n, const real *pascal, const real *c, real t)
{
    real f;
    form_values(n, 1, pascal, c, t, &f);
    return f > 0 ? 1 : f < 0 ? -1 : 0;
}

/* By enclosures that know the errors: a sign halfway between two of them differs from the one before where
 * there is an odd number of roots. */
static int enclose_roots(const struct region_work *k, int n, const real *c, const real *error, int room,
                         real *out)
{
    struct root found[ROOTS];
    int roots = roots_find(n, c, error, 16 * REAL_EPSILON, k->roots, n, found), count = 0;
    real left = 0;
    for (int i = 0; i < roots; i++) {
        real right = i + 1 < roots ? found[i].hi + (found[i + 1].lo - found[i].hi) / 2 : (real)1;
        bool reaches = found[i].lo <= 0 || found[i].hi >= 1;
        if (!reaches && sign_at(n, k->pascal, c, left) * sign_at(n, k->pascal, c, right) < 0) {
            if (count == room) {
                return -1;
            }
            out[count++] = polish(n, k->pascal, c, left, right);
        }
        left = right;
    }
    return count;
}

/* Takes out the factors t and 1 - t, which do not change the sign inside; returns the degree left. */
static int strip_ends(int n, const real *pascal, const real *c, const real *error, real *out, real *out_error)
{
    int lo = 0, hi = 0;
    while (lo < n && real_abs(c[lo]) <= error[lo]) {
        lo++;
    }
    while (lo + hi < n && real_abs(c[n - hi]) <= error[n - hi]) {
        hi++;
    }
    int m = n - lo - hi;
    const real *row = pascal_row(pascal, n) + lo, *less = pascal_row(pascal, m);
    for (int i = 0; i <= m; i++) {
        real factor = row[i] / less[i];
        out[i] = c[lo + i] * factor;
        out_error[i] = error[lo + i] * factor;
    }
    return m;
}

int form_crossings(struct region_work *k, int n, const real *c, const real *error, int room, real *out)
{
    real inner[FORM_MAX], inner_error[FORM_MAX];
    if (real_abs(c[0]) <= error[0] || real_abs(c[n]) <= error[n]) {
        n = strip_ends(n, k->pascal, c, error, inner, inner_error);
        c = inner;
        error = inner_error;
    }
    int changes = count_changes(n, c, error);
    if (n == 0 || changes == 0) {
        return 0;
    }
    if (changes == 1 && room > 0) {
        out[0] = polish(n, k->pascal, c, 0, 1);
        return 1;
    }
    int count = isolate(n, k->pascal, c, error, room, out);
    return count >= 0 ? count : enclose_roots(k, n, c, error, room, out);
}
