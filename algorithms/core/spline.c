#include "spline.h"

enum { DEGREE_LIMIT = 32 };

const char *spline_check(const struct spline *s)
{
    if (s->degree < 1 || s->degree > DEGREE_LIMIT) {
        return "degree must be 1 to 32";
    }
    if (s->count < s->degree + 1) {
        return "fewer control points than degree + 1";
    }
    for (int i = 0; i <= s->count + s->degree; i++) {
        if (!real_is_finite(s->knots[i])) {
            return "a knot is not finite";
        }
    }
    int run = 1;
    for (int i = 1; i <= s->count + s->degree; i++) {
        if (!(s->knots[i - 1] <= s->knots[i])) {
            return "knots decrease";
        }
        run = s->knots[i] == s->knots[i - 1] ? run + 1 : 1;
        int inner = s->knots[s->degree] < s->knots[i] && s->knots[i] < s->knots[s->count];
        if (run > (inner ? s->degree : s->degree + 1)) {
            return "a knot is repeated too often";
        }
    }
    return s->knots[s->degree] < s->knots[s->count] ? NULL : "the knots leave no interval";
}

int spline_pieces(const struct spline *s)
{
    int pieces = 0;
    for (int k = s->degree; k < s->count; k++) {
        pieces += s->knots[k] < s->knots[k + 1];
    }
    return pieces;
}

/* Knot index k of the index-th non-empty span [knots[k], knots[k+1]]. */
static int span_of(const struct spline *s, int index)
{
    int k = s->degree;
    for (;; k++) {
        if (s->knots[k] < s->knots[k + 1] && index-- == 0) {
            return k;
        }
    }
}

/* Blossom of the span's polynomial at (lo^(n-i), hi^i) by de Boor's triangle; argument j replaces one knot at
 * a time. d holds the n + 1 control points of the span. */
static real blossom(const struct spline *s, int k, real *d, int i)
{
    int n = s->degree;
    real lo = s->knots[k], hi = s->knots[k + 1];
    for (int round = 1; round <= n; round++) {
        real a = round <= n - i ? lo : hi;
        for (int j = n; j >= round; j--) {
            real left = s->knots[k - n + j], right = s->knots[k + 1 + j - round];
            real width = right - left;
            d[j] = ((right - a) / width) * d[j - 1] + ((a - left) / width) * d[j];
        }
    }
    return d[n];
}

void spline_piece(const struct spline *s, int index, struct spline_piece *out)
{
    int n = s->degree, k = span_of(s, index);
    out->lo = s->knots[k];
    out->hi = s->knots[k + 1];
    for (int c = 0; c < s->components; c++) {
        const real *p = s->points + c * s->count + (k - n);
        for (int i = 0; i <= n; i++) {
            real d[DEGREE_LIMIT + 1];
            for (int j = 0; j <= n; j++) {
                d[j] = p[j];
            }
            out->coefficients[c * (n + 1) + i] = blossom(s, k, d, i);
        }
    }
}
