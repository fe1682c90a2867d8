#include "roots.h"

#include "bernstein.h"
#include "zeros.h"

enum {
    STACK_MAX = REAL_BITS + 16, /* intervals waiting: one for each halving of [0, 1] */
    REDUCED_TO_MAX = 3
};

/* Also for all lower degrees, which may be reduced where n is too high. */
size_t roots_scratch(int n)
{
    int reduced = n < ZEROS_DEGREE_MAX ? n : ZEROS_DEGREE_MAX;
    return 3 * ((size_t)n + 1) + 2 * STACK_MAX + reduction_length(reduced, REDUCED_TO_MAX);
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
static bool clip_hull(int n, const real *c, real error, real *lo, real *hi)
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
    const struct reduction *reduction; /* NULL: clip by hulls */
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

/* Pieces of [lo, hi], over which the coefficients are those of cut, that may hold roots. */
static int clip(const struct band *b, real error, real lo, real hi, struct interval piece[ZEROS_PIECES_MAX])
{
    if (!b->reduction) {
        piece[0].lo = lo;
        piece[0].hi = hi;
        return clip_hull(b->n, b->cut, error, &piece[0].lo, &piece[0].hi);
    }
    int count = zeros_by_reduction(b->reduction, b->cut, error, piece);
    real width = hi - lo,
         pad = 2 * hi * REAL_EPSILON; /* the map to [lo, hi]: 3u of the width, u of the result */
    for (int i = 0; i < count; i++) {
        piece[i].lo = piece[i].lo > 0 ? real_max(lo, lo + width * piece[i].lo - pad) : lo;
        piece[i].hi = piece[i].hi < 1 ? real_min(hi, lo + width * piece[i].hi + pad) : hi;
    }
    return count;
}

/* Clips a cell; *final: the errors forbid that it become narrower yet.  Errors over the cell itself are
 * looked at where those over [0, 1] are too large. */
static int shrink(const struct band *b, real lo, real hi, struct interval piece[ZEROS_PIECES_MAX],
                  bool *final)
{
    bernstein_restrict(b->n, 1, b->c, lo, hi, b->cut);
    int count = clip(b, b->noise, lo, hi, piece);
    real size = largest(b->n, b->cut);
    *final = false;
    if (count == 0 || size > 8 * b->noise) {
        return count;
    }
    real noise = cut_errors(b, lo, hi);
    *final = size <= 2 * noise;
    return clip(b, noise, lo, hi, piece);
}

/* If one piece is more than `most` of the width: both halves of what all pieces span. */
static int halve_if_wide(real most, real width, int count, struct interval piece[ZEROS_PIECES_MAX])
{
    real widest = 0;
    for (int i = 0; i < count; i++) {
        widest = real_max(widest, piece[i].hi - piece[i].lo);
    }
    if (widest <= most * width) {
        return count;
    }
    real lo = piece[0].lo, hi = piece[count - 1].hi, middle = lo + (hi - lo) / 2;
    piece[0].hi = piece[1].lo = middle;
    piece[1].hi = hi;
    return 2;
}

/* A piece that needs no more work, or can have none. */
static bool is_done(const struct interval *a, real tolerance)
{
    real middle = a->lo + (a->hi - a->lo) / 2;
    return a->hi - a->lo <= tolerance || middle <= a->lo || middle >= a->hi;
}

/* Every cell is cut from c itself between its exact ends, so that rounding does not grow with the depth.
 * `most`: what a clip may leave without being halved. */
static int search(const struct band *b, real tolerance, real most, real *stack, int room, struct root *out,
                  struct root_search *log)
{
    int waiting = 1, count = 0;
    stack[0] = 0;
    stack[1] = 1;
    while (waiting > 0) {
        real lo = stack[2 * --waiting], hi = stack[2 * waiting + 1];
        struct interval piece[ZEROS_PIECES_MAX + 1];
        bool final, full = waiting + ZEROS_PIECES_MAX > STACK_MAX;
        if (log) {
            log->clips++;
        }
        if (log && log->watch) {
            log->watch(log->log, lo, hi);
        }
        int pieces = shrink(b, lo, hi, piece, &final), done = 0;
        while (done < pieces && (final || full || is_done(&piece[done], tolerance))) {
            count = keep(piece[done].lo, piece[done].hi, count, room, out);
            done++;
        }
        if (done < pieces) {
            pieces = done + halve_if_wide(most, hi - lo, pieces - done, piece + done);
        }
        for (int i = pieces - 1; i >= done; i--) {
            stack[2 * waiting] = piece[i].lo;
            stack[2 * waiting++ + 1] = piece[i].hi;
        }
    }
    return count;
}

static int find(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
                struct root *out, const struct reduction *reduction, real most, struct root_search *log)
{
    struct band b = {n, c, scratch, scratch + n + 1, scratch + 2 * (n + 1), 0, reduction};
    for (int i = 0; i <= n; i++) {
        b.error[i] = error[i] + 4 * n * REAL_EPSILON * real_abs(c[i]);
        b.error[i] += b.error[i] / 64; /* the rounding of the bounds themselves, and of cutting them */
    }
    b.noise = largest(n, b.error);
    int count = search(&b, tolerance, most, scratch + 3 * (n + 1), room, out, log);
    for (int i = 0; i < count; i++) {
        count_roots(&b, i > 0 ? out[i - 1].hi : 0, i + 1 < count ? out[i + 1].lo : 1, &out[i]);
    }
    return count;
}

/* ---- the finders ---- */

static int find_by_hull(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
                        struct root *out, struct root_search *log)
{
    return find(n, c, error, tolerance, scratch, room, out, NULL, (real)4 / 5, log);
}

static int find_by_reduction(int k, int n, const real *c, const real *error, real tolerance, real *scratch,
                             int room, struct root *out, struct root_search *log)
{
    struct reduction reduction;
    if (n > ZEROS_DEGREE_MAX) {
        return find_by_hull(n, c, error, tolerance, scratch, room, out, log);
    }
    reduction_init(&reduction, n, k, scratch + 3 * (n + 1) + 2 * STACK_MAX);
    return find(n, c, error, tolerance, scratch, room, out, &reduction, (real)1 / 2, log);
}

static int find_by_quadratic(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
                             struct root *out, struct root_search *log)
{
    return find_by_reduction(2, n, c, error, tolerance, scratch, room, out, log);
}

static int find_by_cubic(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
                         struct root *out, struct root_search *log)
{
    return find_by_reduction(3, n, c, error, tolerance, scratch, room, out, log);
}

static const struct root_finder hull = {
    "hull", "Sederberg and Nishita, Curve intersection using Bezier clipping, 1990", find_by_hull};
static const struct root_finder quadratic = {
    "quadratic", "Barton and Juttler, Computing roots of polynomials by quadratic clipping, 2007",
    find_by_quadratic};
static const struct root_finder cubic = {
    "cubic",
    "Liu, Zhang, Lin and Wang, Fast approach for computing roots of polynomials using cubic clipping, 2009",
    find_by_cubic};

const struct root_finder *const root_finders[] = {&hull, &quadratic, &cubic, NULL};

int roots_find(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
               struct root *out)
{
    return find_by_hull(n, c, error, tolerance, scratch, room, out, NULL);
}
