/* One crossing near a joint, proved on both segments at once.
 *
 * Let h be one or two pieces of segments of a path, the second beginning where the first ends, each over a
 * part of its segment and with a parameter that runs over an interval of length 1, extended past its ends by
 * tangents; k likewise of the other path.  The differences A_i of all control points of h's pieces, the
 * directions, have cross(A_i, B_j) >= c > 0 with all directions of k (or <= -c); p and q are the least
 * degrees, V_h and V_k the largest 1-norms.  Then H(t, s) = h(t) - k(s) has exactly one zero x*, and for
 * every x = (t, s)
 *
 *     |t - t*| <= V_k |H(x)| / (p c),    |s - s*| <= V_h |H(x)| / (q c),    |.| the maximum norm.
 *
 * Proof.  As in intersect/certified/cone.c: h(t) - h(t') is the integral of h', which is the degree of the
 * piece times a convex combination of its directions; so it is (t - t') a U with a >= p and U in the convex
 * hull of the directions of both pieces.  Nothing asks h' to be continuous.
 *
 * Where these bounds, for an x at hand, lie within the pieces, x* is a solution and the only one there.
 *
 * Rounding.  Control points of a piece err by at most 8 n u S (bernstein_restrict), S the largest coordinate,
 * so directions by e = 17 n u S in each coordinate; cross products by e_h V_k + e_k V_h, e_h e_k and their
 * own 2 u V_h V_k, V_h and V_k raised by 2 e: 2 (e_h V_k + e_k V_h) covers all, for u V <= 4 u S <= e.  An
 * end of a segment is a control point of it; else a point errs by 3 n u S, and H by the sum and u |H|.  A
 * quarter of what covers all is spare; underflow of products, by u REAL_LEAST each, takes 8 u REAL_LEAST of
 * it, nothing where the bound is above 64 u REAL_LEAST.  Where products overflow nothing is proved. */
#include "../core/bernstein.h"
#include "paths.h"

enum { WAYS_MAX = 2 * DEGREE_MAX };

struct side {
    const struct path *path;
    int first, last; /* segments of the pieces; the same: one piece */
    real lo, hi;     /* the first piece from lo on, the last one up to hi */
    real at;         /* x: a parameter of the one piece */
    real px, py, point_error;
    int ways, pace;
    real x[WAYS_MAX], y[WAYS_MAX];
    real error, longest;
};

/* Differences of c over [lo, hi]. */
static void add_ways(struct side *s, const struct curve *c, real lo, real hi)
{
    real x[DEGREE_MAX + 1], y[DEGREE_MAX + 1], size = 0;
    int n = c->degree;
    bernstein_restrict(n, 1, c->x, lo, hi, x);
    bernstein_restrict(n, 1, c->y, lo, hi, y);
    for (int i = 0; i <= n; i++) {
        size = real_max(size, real_max(real_abs(c->x[i]), real_abs(c->y[i])));
    }
    s->error = real_max(s->error, 9 * n * REAL_EPSILON * size + REAL_LEAST);
    for (int i = 0; i < n; i++) {
        real dx = x[i + 1] - x[i], dy = y[i + 1] - y[i];
        s->longest = real_max(s->longest, real_abs(dx) + real_abs(dy));
        s->x[s->ways] = dx;
        s->y[s->ways++] = dy;
    }
    s->pace = s->pace < n ? s->pace : n;
}

/* The pieces around a span: up to `width` on either side of a joint, or of the middle of the span. */
static bool side_make(const struct path *path, const struct path_span *span, real width, struct side *s)
{
    bool begins = span->lo == 0 && path->before[span->first] >= 0;
    bool ends = span->hi == 1 && path->next[span->last] >= 0;
    s->path = path;
    s->first = span->first;
    s->last = span->last;
    if (s->first == s->last && begins != ends) {
        s->first = begins ? path->before[s->last] : s->first;
        s->last = ends ? path->next[s->first] : s->last;
    }
    bool one = s->first == s->last;
    if (path->segment[s->first].w || path->segment[s->last].w || (!one && path->next[s->first] != s->last)) {
        return false;
    }
    s->at = one ? span->lo + (span->hi - span->lo) / 2 : (real)1;
    s->lo = real_max(s->at - width, (real)0);
    s->hi = one ? real_min(s->at + width, (real)1) : width;
    return (begins && !one && span->first == s->last ? true : span->lo >= s->lo) &&
           (ends && !one && span->last == s->first ? true : span->hi <= s->hi);
}

static void side_fill(struct side *s)
{
    const struct curve *c = &s->path->segment[s->first], *d = &s->path->segment[s->last];
    s->ways = 0;
    s->pace = DEGREE_MAX;
    s->error = s->longest = 0;
    if (s->first != s->last) {
        add_ways(s, c, s->lo, 1);
        add_ways(s, d, 0, s->hi);
        s->px = d->x[0];
        s->py = d->y[0];
        s->point_error = 0;
    } else {
        add_ways(s, c, s->lo, s->hi);
        s->px = bernstein_value(c->degree, c->x, s->at);
        s->py = bernstein_value(c->degree, c->y, s->at);
        s->point_error = s->error;
    }
    s->longest += 2 * s->error;
}

/* c of the theorem, or 0. */
static real least_cross(const struct side *h, const struct side *k)
{
    real least = REAL_HUGE, most = -REAL_HUGE;
    for (int i = 0; i < h->ways; i++) {
        for (int j = 0; j < k->ways; j++) {
            real a = h->x[i] * k->y[j] - h->y[i] * k->x[j];
            least = real_min(least, a);
            most = real_max(most, a);
        }
    }
    real bound = 2 * (h->error * k->longest + k->error * h->longest), c = real_max(least, -most) - bound;
    return bound > 32 * REAL_EPSILON * REAL_LEAST && c > 0 && real_is_finite(c) ? c : (real)0;
}

/* x* is nearer than `far` (of the pieces' own parameter) to x: false if that may be outside, else *span is
 * where it is. */
static bool narrow(const struct side *s, real far, struct path_span *span)
{
    if (s->first != s->last) {
        span->first = s->first;
        span->last = s->last;
        span->lo = 1 - far * (1 - s->lo) - REAL_EPSILON;
        span->hi = far * s->hi + REAL_EPSILON;
        return 2 * far < 1;
    }
    real pad = far * (s->hi - s->lo) * (1 + 8 * REAL_EPSILON) + 2 * REAL_EPSILON;
    span->first = span->last = s->first;
    span->lo = s->at - pad;
    span->hi = s->at + pad;
    return span->lo > s->lo && span->hi < s->hi;
}

/* Parameters on either side of the joint, or of the middle of a span. */
static real region_width(void)
{
    return real_ldexp(1, -REAL_BITS / 3);
}

bool path_joint_prove(const struct path *a, const struct path *b, struct path_span *span_a,
                      struct path_span *span_b)
{
    const real width = region_width();
    struct side h, k;
    struct path_span at_a, at_b;
    if (!side_make(a, span_a, width, &h) || !side_make(b, span_b, width, &k)) {
        return false;
    }
    side_fill(&h);
    side_fill(&k);
    real c = least_cross(&h, &k);
    if (!(c > 0)) {
        return false;
    }
    real miss = real_max(real_abs(h.px - k.px), real_abs(h.py - k.py)) * (1 + 2 * REAL_EPSILON) +
                h.point_error + k.point_error;
    real by = miss * (1 + 16 * REAL_EPSILON) / c;
    if (!narrow(&h, by * k.longest / h.pace, &at_a) || !narrow(&k, by * h.longest / k.pace, &at_b)) {
        return false;
    }
    *span_a = at_a;
    *span_b = at_b;
    return true;
}

/* Half the region: the middle of a narrowed span is that of the region to rounding. */
static bool is_beside(const struct path_span *r, const struct path_span *q)
{
    const real width = region_width() / 2;
    if (r->first != r->last) {
        bool begins = q->first == r->first && q->lo >= 1 - width, ends = q->last == r->last && q->hi <= width;
        return q->first == q->last ? begins || ends : begins && ends;
    }
    real middle = r->lo + (r->hi - r->lo) / 2;
    return q->first == r->first && q->last == r->last && q->lo >= middle - width && q->hi <= middle + width;
}

bool path_joint_holds(const struct path_record *r, const struct path_record *q, bool self)
{
    return (is_beside(&r->a, &q->a) && is_beside(&r->b, &q->b)) ||
           (self && is_beside(&r->a, &q->b) && is_beside(&r->b, &q->a));
}
