#include "arc.h"

enum { DEGREES = 33 };

struct extent {
    real lo, hi;
};

/* Euclidean control points: the arc's own arrays, or quotients by the weights. */
struct points {
    int degree;
    const real *x, *y;
    real of_x[DEGREES], of_y[DEGREES];
};

static inline void euclidean(const struct arc *a, struct points *e)
{
    e->degree = a->degree;
    e->x = a->x;
    e->y = a->y;
    if (a->w) {
        int i = 0;
        do {
            e->of_x[i] = a->x[i] / a->w[i];
            e->of_y[i] = a->y[i] / a->w[i];
        } while (i++ < a->degree);
        e->x = e->of_x;
        e->y = e->of_y;
    }
}

static inline struct extent range(int n, const real *c)
{
    struct extent e = {c[0], c[0]};
    for (int i = 1; i <= n; i++) {
        e.lo = real_min(e.lo, c[i]);
        e.hi = real_max(e.hi, c[i]);
    }
    return e;
}

/* Range of nx X + ny Y over the control points. */
static inline struct extent project(const struct points *e, real nx, real ny)
{
    real d = nx * e->x[0] + ny * e->y[0];
    struct extent r = {d, d};
    for (int i = 1; i <= e->degree; i++) {
        d = nx * e->x[i] + ny * e->y[i];
        r.lo = real_min(r.lo, d);
        r.hi = real_max(r.hi, d);
    }
    return r;
}

static inline bool apart(const struct extent *a, const struct extent *b, real bound)
{
    return a->lo - b->hi > bound || b->lo - a->hi > bound;
}

/* Rounding of a projection: a quotient, two products, a sum and the comparison, 6 u norm scale for each arc.
 */
static inline real separation(const struct arc *a, const struct arc *b, real scale)
{
    return a->error + b->error + 8 * REAL_EPSILON * scale;
}

real arc_extent(const struct arc *a)
{
    struct points e;
    euclidean(a, &e);
    struct extent x = range(e.degree, e.x), y = range(e.degree, e.y);
    return real_max(x.hi - x.lo, y.hi - y.lo);
}

bool arc_boxes_meet(const struct arc *a, const struct arc *b, real scale)
{
    real bound = separation(a, b, scale);
    struct points pa, pb;
    euclidean(a, &pa);
    euclidean(b, &pb);
    struct extent ea = range(pa.degree, pa.x), eb = range(pb.degree, pb.x);
    if (apart(&ea, &eb, bound)) {
        return false;
    }
    ea = range(pa.degree, pa.y);
    eb = range(pb.degree, pb.y);
    return !apart(&ea, &eb, bound);
}

static bool apart_along(const struct points *a, const struct points *b, real nx, real ny, real margin)
{
    struct extent ea = project(a, nx, ny), eb = project(b, nx, ny);
    return apart(&ea, &eb, (real_abs(nx) + real_abs(ny)) * margin);
}

bool arc_oriented_boxes_meet(const struct arc *a, const struct arc *b, real scale)
{
    real margin = separation(a, b, scale);
    struct points pa, pb;
    euclidean(a, &pa);
    euclidean(b, &pb);
    const struct points *both[2] = {&pa, &pb};
    for (int k = 0; k < 2; k++) {
        const struct points *e = both[k];
        real dx = e->x[e->degree] - e->x[0], dy = e->y[e->degree] - e->y[0];
        if (apart_along(&pa, &pb, -dy, dx, margin) || apart_along(&pa, &pb, dx, dy, margin)) {
            return false;
        }
    }
    return true;
}

/* A direction that e follows: its chord, or its farthest control point from the first if the chord is shorter
 * than a quarter of that.  Returns the length of the longest difference. */
static inline real direction(const struct points *e, real *dx, real *dy, bool *chord)
{
    real x0 = e->x[0], y0 = e->y[0];
    *dx = e->x[e->degree] - x0;
    *dy = e->y[e->degree] - y0;
    real length = real_abs(*dx) + real_abs(*dy), far = length;
    int farthest = e->degree;
    for (int i = 1; i < e->degree; i++) {
        real r = real_abs(e->x[i] - x0) + real_abs(e->y[i] - y0);
        if (r > far) {
            far = r;
            farthest = i;
        }
    }
    *chord = 4 * length >= far;
    if (!*chord) {
        *dx = e->x[farthest] - x0;
        *dy = e->y[farthest] - y0;
    }
    return far;
}

/* Sederberg and Nishita 1990: over the chord, distances of a quadratic fill at most 1/2, of a cubic at most
 * 3/4 or, with distances of both signs, 4/9 of their control values.  The chord's own ends may differ by
 * rounding: the bound is applied to what is left after the linear part. */
static inline void tighten(int m, const real *d, struct extent *e)
{
    real lo = 0, hi = 0;
    if (m == 2) {
        real rest = d[1] - (d[0] + d[2]) * (real)0.5;
        lo = real_min(rest, lo) * (real)0.5;
        hi = real_max(rest, hi) * (real)0.5;
    } else {
        const real third = (real)1 / 3;
        real step = (d[3] - d[0]) * third;
        real r1 = d[1] - (d[0] + step), r2 = d[2] - (d[3] - step);
        lo = real_min(real_min(r1, r2), lo);
        hi = real_max(real_max(r1, r2), hi);
        real factor = lo < 0 && hi > 0 ? 4 * third * third : (real)0.75;
        factor = factor + 4 * REAL_EPSILON; /* 4/9 came rounded */
        lo = factor * lo;
        hi = factor * hi;
    }
    e->lo = real_min(d[0], d[m]) + lo;
    e->hi = real_max(d[0], d[m]) + hi;
}

void fat_line(const struct arc *b, const struct arc *a, real scale, const struct fat_line_rule *rule,
              struct strip *out)
{
    struct points e;
    struct extent r;
    real dx, dy;
    bool chord;
    euclidean(b, &e);
    if (direction(&e, &dx, &dy, &chord) > 4 * b->error) {
        out->nx = -dy;
        out->ny = dx;
    } else {
        struct points other;
        euclidean(a, &other);
        if (!(direction(&other, &dx, &dy, &chord) > 0)) {
            dx = 1;
        }
        chord = false;
        out->nx = dx;
        out->ny = dy;
    }
    if (rule->unit) {
        real length = real_sqrt(out->nx * out->nx + out->ny * out->ny);
        if (length > 0) {
            length = rule->stretch / length;
            out->nx = out->nx * length;
            out->ny = out->ny * length;
        }
    }
    if (rule->tight && chord && !b->w && (b->degree == 2 || b->degree == 3)) {
        real d[4];
        for (int i = 0; i <= b->degree; i++) {
            d[i] = out->nx * b->x[i] + out->ny * b->y[i];
        }
        tighten(b->degree, d, &r);
    } else {
        r = project(&e, out->nx, out->ny);
    }
    out->norm = real_abs(out->nx) + real_abs(out->ny);
    real margin = out->norm * separation(a, b, scale);
    out->lo = r.lo - margin;
    out->hi = r.hi + margin;
}

void strip_distances(const struct strip *s, const struct arc *a, real *above, real *below)
{
    if (a->w) {
        for (int i = 0; i <= a->degree; i++) {
            real d = s->nx * a->x[i] + s->ny * a->y[i];
            above[i] = d - s->lo * a->w[i];
            below[i] = s->hi * a->w[i] - d;
        }
        return;
    }
    for (int i = 0; i <= a->degree; i++) {
        real d = s->nx * a->x[i] + s->ny * a->y[i];
        above[i] = d - s->lo;
        below[i] = s->hi - d;
    }
}
