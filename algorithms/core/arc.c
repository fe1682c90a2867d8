#include "arc.h"

struct extent {
    real lo, hi;
};

/* Range of nx X + ny Y over the control points. */
static struct extent project(const struct arc *a, real nx, real ny)
{
    struct extent e;
    for (int i = 0; i <= a->degree; i++) {
        real d = nx * a->x[i] + ny * a->y[i];
        if (a->w) {
            d = d / a->w[i];
        }
        if (i == 0) {
            e.lo = e.hi = d;
        } else if (d < e.lo) {
            e.lo = d;
        } else if (d > e.hi) {
            e.hi = d;
        }
    }
    return e;
}

static bool apart(const struct arc *a, const struct arc *b, real nx, real ny, real margin)
{
    struct extent ea = project(a, nx, ny), eb = project(b, nx, ny);
    real bound = (real_abs(nx) + real_abs(ny)) * margin;
    return ea.lo - eb.hi > bound || eb.lo - ea.hi > bound;
}

/* Rounding of a projection: two products, a sum, a quotient and the comparison, 6 u norm scale for each arc.
 */
static real separation(const struct arc *a, const struct arc *b, real scale)
{
    return a->error + b->error + 8 * REAL_EPSILON * scale;
}

static struct extent coordinate_range(const struct arc *a, const real *c)
{
    struct extent e;
    for (int i = 0; i <= a->degree; i++) {
        real d = a->w ? c[i] / a->w[i] : c[i];
        if (i == 0) {
            e.lo = e.hi = d;
        } else if (d < e.lo) {
            e.lo = d;
        } else if (d > e.hi) {
            e.hi = d;
        }
    }
    return e;
}

real arc_extent(const struct arc *a)
{
    struct extent x = coordinate_range(a, a->x), y = coordinate_range(a, a->y);
    return real_max(x.hi - x.lo, y.hi - y.lo);
}

bool arc_boxes_meet(const struct arc *a, const struct arc *b, real scale)
{
    real bound = separation(a, b, scale);
    struct extent ea = coordinate_range(a, a->x), eb = coordinate_range(b, b->x);
    if (ea.lo - eb.hi > bound || eb.lo - ea.hi > bound) {
        return false;
    }
    ea = coordinate_range(a, a->y);
    eb = coordinate_range(b, b->y);
    return !(ea.lo - eb.hi > bound || eb.lo - ea.hi > bound);
}

/* Point i minus point 0. */
static void from_start(const struct arc *a, int i, real *dx, real *dy)
{
    if (a->w) {
        *dx = a->x[i] / a->w[i] - a->x[0] / a->w[0];
        *dy = a->y[i] / a->w[i] - a->y[0] / a->w[0];
    } else {
        *dx = a->x[i] - a->x[0];
        *dy = a->y[i] - a->y[0];
    }
}

bool arc_oriented_boxes_meet(const struct arc *a, const struct arc *b, real scale)
{
    real margin = separation(a, b, scale);
    const struct arc *arcs[2] = {a, b};
    for (int k = 0; k < 2; k++) {
        real dx, dy;
        from_start(arcs[k], arcs[k]->degree, &dx, &dy);
        if (apart(a, b, -dy, dx, margin) || apart(a, b, dx, dy, margin)) {
            return false;
        }
    }
    return true;
}

/* A direction that b follows: its chord, or its farthest control point; false if b is a point to rounding. */
static bool direction(const struct arc *b, real *dx, real *dy, bool *chord)
{
    from_start(b, b->degree, dx, dy);
    real length = real_abs(*dx) + real_abs(*dy), far = length;
    *chord = true;
    if (b->degree > 1) {
        int farthest = b->degree;
        for (int i = 1; i < b->degree; i++) {
            real x, y;
            from_start(b, i, &x, &y);
            if (real_abs(x) + real_abs(y) > far) {
                far = real_abs(x) + real_abs(y);
                farthest = i;
            }
        }
        if (4 * length < far) {
            from_start(b, farthest, dx, dy);
            *chord = false;
        }
    }
    return far > 4 * b->error;
}

/* Sederberg and Nishita 1990: over the chord, distances of a quadratic fill at most 1/2, of a cubic at most
 * 3/4 or, with distances of both signs, 4/9 of their control values.  The chord's own ends may differ by
 * rounding: the bound is applied to what is left after the linear part. */
static void tighten(const struct arc *b, const real *d, struct extent *e)
{
    int m = b->degree;
    real lo = 0, hi = 0;
    for (int i = 1; i < m; i++) {
        real rest = d[i] - ((m - i) * d[0] + i * d[m]) / m;
        lo = real_min(lo, rest);
        hi = real_max(hi, rest);
    }
    real factor = m == 2 ? (real)0.5 : (lo < 0 && hi > 0) ? (real)4 / 9 : (real)0.75;
    e->lo = real_min(d[0], d[m]) + factor * lo;
    e->hi = real_max(d[0], d[m]) + factor * hi;
}

void fat_line(const struct arc *b, const struct arc *a, real scale, const struct fat_line_rule *rule,
              struct strip *out)
{
    real dx, dy;
    bool chord;
    if (direction(b, &dx, &dy, &chord)) {
        out->nx = -dy;
        out->ny = dx;
    } else {
        chord = false;
        if (!direction(a, &dx, &dy, &chord) && dx == 0 && dy == 0) {
            dx = 1;
        }
        chord = false;
        out->nx = dx;
        out->ny = dy;
    }
    if (rule->unit) {
        real length = real_sqrt(out->nx * out->nx + out->ny * out->ny);
        if (length > 0) {
            out->nx = out->nx / length * rule->stretch;
            out->ny = out->ny / length * rule->stretch;
        }
    }
    struct extent e;
    if (rule->tight && chord && !b->w && (b->degree == 2 || b->degree == 3)) {
        real d[4];
        for (int i = 0; i <= b->degree; i++) {
            d[i] = out->nx * b->x[i] + out->ny * b->y[i];
        }
        tighten(b, d, &e);
    } else {
        e = project(b, out->nx, out->ny);
    }
    out->norm = real_abs(out->nx) + real_abs(out->ny);
    real margin = out->norm * separation(a, b, scale);
    out->lo = e.lo - margin;
    out->hi = e.hi + margin;
}

void strip_distances(const struct strip *s, const struct arc *a, real *lower, real *upper)
{
    for (int i = 0; i <= a->degree; i++) {
        real d = s->nx * a->x[i] + s->ny * a->y[i];
        lower[i] = d - (a->w ? s->lo * a->w[i] : s->lo);
        upper[i] = d - (a->w ? s->hi * a->w[i] : s->hi);
    }
}
