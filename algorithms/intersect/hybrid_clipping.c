/* Clip one curve, thickened to a band about its best approximation of degree k, to the fat line of the other.
 *
 * Lou and Liu, Curve intersection using hybrid clipping, Computers and Graphics 36, 2012; pseudo-code as in
 * D. Keglevic, Iskanje presecisc Bezierjevih krivulj z metodo hibridnih izrezkov.  With d the distance of f
 * from the chord line of g (unit normal), d0 that of its best approximation and |d - d0| <= delta, f can meet
 * g only where d0 + delta >= d_min and d0 - delta <= d_max.  Order per round at a crossing min(k + 1, 4).
 *
 * As published the discard rule reads AND, which never holds, and nothing is discarded: it must be OR.  Other
 * repairs: the normal has unit length (delta is a length); pairs are returned in the order (f, g); b_0 = b_m
 * takes another direction (fat_line); k >= n is exact, delta = 0; a box is tested once more before it is
 * returned; widths stop at the rounding of the parameters; every bound carries its rounding.
 *
 * hybrid_clipping_k clips the wider parameter interval, takes delta for the planar error, and halves both
 * curves when no more than half is removed.  hybrid_clipping_k_arc is the same body with the two-sided scalar
 * delta, the geometrically longer arc clipped and halved, and a test by oriented boxes before it is halved.
 * hybrid_clipping_k_scalar differs from hybrid_clipping_k in delta alone. */
#include "../core/band.h"
#include "../core/cells.h"
#include "../core/reduce.h"

/* Every entry of the registry gets its own copy of the body, with its rules as constants. */
#define ALWAYS_INLINE __attribute__((always_inline))

struct rules {
    int k;
    bool scalar;      /* delta: the two-sided scalar one, or the planar one of the papers */
    bool arc;         /* the variant: longer arc, oriented boxes */
    bool discard_and; /* control: the discard rule as printed */
    bool no_delta;    /* control: the band is taken for the curve */
    real stretch;     /* 1; the length of the normal */
};

/* Bernstein coefficients of degree k: a may meet b only where both polynomials are >= 0. */
struct bounds_of_distance {
    real above[BAND_DEGREE_MAX + 1], below[BAND_DEGREE_MAX + 1];
};

struct residual_range {
    real lo, hi;
};

/* q = the reduction of the distances d, and the range of d - q with its rounding. */
static inline struct residual_range reduce_distances(const struct reduction *r, const real *d, real *q)
{
    struct residual_range range = {0, 0};
    real rest[DEGREE_MAX + 1];
    reduction_apply(r, 1, d, q);
    if (!r->reduce) {
        return range;
    }
    real bound = reduction_residual(r, 1, d, q, rest);
    for (int i = 0; i <= r->n; i++) {
        range.lo = real_min(range.lo, rest[i]);
        range.hi = real_max(range.hi, rest[i]);
    }
    range.lo = range.lo - bound;
    range.hi = range.hi + bound;
    return range;
}

/* The distances reduced as they are, widened on either side by their residuals.  For a polynomial curve the
 * distances from the two lines add up to the thickness of the strip, and one reduction serves both; roundings
 * here: 3 u of thickness + |q| + |range|. */
static inline void reduce_scalar(const struct reduction *r, const struct strip *s, const struct arc *a,
                                 struct bounds_of_distance *out)
{
    real above[DEGREE_MAX + 1], below[DEGREE_MAX + 1];
    strip_distances(s, a, above, below);
    struct residual_range rest = reduce_distances(r, above, out->above), other = {-rest.hi, -rest.lo};
    real thickness = s->hi - s->lo, largest = thickness + rest.hi - rest.lo;
    if (a->w) {
        other = reduce_distances(r, below, out->below);
    }
    for (int i = 0; i <= r->k; i++) {
        largest = real_max(largest, real_abs(out->above[i]) + (rest.hi - rest.lo));
        out->below[i] = a->w ? out->below[i] : thickness - out->above[i];
        largest = real_max(largest, real_abs(out->below[i]) + (other.hi - other.lo));
    }
    real pad = 4 * REAL_EPSILON * largest;
    for (int i = 0; i <= r->k; i++) {
        out->above[i] = out->above[i] + (rest.hi + pad);
        out->below[i] = out->below[i] + (other.hi + pad);
    }
}

/* max |a_i - c_i| of the planar residuals. */
static inline real planar_norm(int n, const real *x, const real *y)
{
    real most = 0;
    for (int i = 0; i <= n; i++) {
        most = real_max(most, x[i] * x[i] + y[i] * y[i]);
    }
    return real_sqrt(most);
}

static inline real max_norm(int length, const real *c)
{
    real most = 0;
    for (int i = 0; i < length; i++) {
        most = real_max(most, real_abs(c[i]));
    }
    return most;
}

/* The curve reduced, delta = max |a_i - c_i|: valid for |n| <= 1, for rational curves with |level| times the
 * residual of the weight added.  Rounding: of delta itself 4 u, of the residuals their bound in each
 * component, of the distances 5 u. */
static inline void reduce_vector(const struct reduction *r, const struct strip *s, const struct arc *a,
                                 bool no_delta, struct bounds_of_distance *out)
{
    real q[3 * (BAND_DEGREE_MAX + 1)], rest[3 * (DEGREE_MAX + 1)];
    int components = a->w ? 3 : 2, length = a->degree + 1, reduced = r->k + 1;
    const real *qx = q, *qy = q + reduced, *qw = q + 2 * reduced;
    reduction_apply(r, components, a->x, q);
    real level = real_max(real_abs(s->lo), real_abs(s->hi));
    real delta = 0, largest; /* >= max |q| */
    if (r->reduce) {
        real bound = reduction_residual(r, components, a->x, q, rest);
        delta = planar_norm(a->degree, rest, rest + length) + 2 * bound;
        if (a->w) {
            delta = delta + level * (max_norm(length, rest + 2 * length) + bound);
        }
        largest = bound / (2 * REAL_EPSILON); /* bound >= (k + 4) u max |q| */
    } else {
        largest = max_norm(components * reduced, q);
    }
    delta = no_delta ? (real)0 : delta;
    delta = delta + 4 * REAL_EPSILON * (delta + (s->norm + level) * largest + level);
    for (int i = 0; i < reduced; i++) {
        real d = s->nx * qx[i] + s->ny * qy[i];
        out->above[i] = d - (a->w ? s->lo * qw[i] : s->lo) + delta;
        out->below[i] = (a->w ? s->hi * qw[i] : s->hi) - d + delta;
    }
}

/* Where a may meet b, in local parameters of a. */
static inline void clip(const struct rules *rules, const struct reduction *r, const struct arc *a,
                        const struct arc *b, real scale, struct band *kept)
{
    const struct fat_line_rule line = {.unit = true, .tight = false, .stretch = rules->stretch};
    struct strip s;
    struct bounds_of_distance d;
    struct band above, below;
    fat_line(b, a, scale, &line, &s);
    if (rules->scalar) {
        reduce_scalar(r, &s, a, &d);
    } else {
        reduce_vector(r, &s, a, rules->no_delta, &d);
    }
    band_above(r->k, d.above, &above);
    if (above.count == 0 && !rules->discard_and) {
        kept->count = 0;
        return;
    }
    band_above(r->k, d.below, &below);
    if (rules->discard_and) {
        band_join(&above, &below, kept);
    } else {
        band_meet(&above, &below, kept);
    }
}

/* The paper clips the wider parameter interval, the variant the longer arc; never one that is narrow enough.
 */
static bool clips_g(const struct problem *p, const struct cell *c, const struct arc *f, const struct arc *g,
                    bool arc)
{
    real t = interval_width(&c->t), s = interval_width(&c->s);
    if (t <= p->bounds.tolerance_t || s <= p->bounds.tolerance_s) {
        return t <= p->bounds.tolerance_t;
    }
    return arc ? arc_extent(f) < arc_extent(g) : t < s;
}

static inline struct reduction reduction_at(const struct problem *p, const struct workspace *w, int k, bool g)
{
    int n = g ? p->g.degree : p->f.degree;
    const real *memory = w->scratch + (g ? reduction_length(p->f.degree, k) : 0);
    struct reduction r = {n, k < n ? k : n, k < n ? memory : NULL, memory + (n + 1) * (k + 1)};
    return r;
}

static inline ALWAYS_INLINE int shrink(const struct rules *rules, const struct problem *p,
                                       const struct workspace *w, struct cell *c,
                                       struct piece piece[PIECES_MAX])
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    bool on_g = clips_g(p, c, &f, &g, rules->arc);
    struct reduction r = reduction_at(p, w, rules->k, on_g);
    struct band kept;
    clip(rules, &r, on_g ? &g : &f, on_g ? &f : &g, p->bounds.scale, &kept);
    real width = interval_width(on_g ? &c->s : &c->t), widest = 0;
    for (int i = 0; i < kept.count; i++) {
        piece[i].t = c->t;
        piece[i].s = c->s;
        struct interval *a = on_g ? &piece[i].s : &piece[i].t;
        interval_clip(a, kept.lo[i], kept.hi[i]);
        widest = real_max(widest, interval_width(a));
    }
    if (kept.count == 0 || 2 * widest < width) {
        return kept.count;
    }
    if (rules->arc && !arc_oriented_boxes_meet(&f, &g, p->bounds.scale)) {
        return 0;
    }
    if (rules->arc && kept.count == 1) {
        cell_narrow(p, c, &piece[0]);
    }
    return HALVE;
}

/* margin: 1; 0 only in a control, which then takes every control point for exact. */
static inline enum outcome solve(const struct problem *p, struct workspace *w, struct crossings *out, int k,
                                 shrink_function *step, enum halving rule, int margin)
{
    if (!w->planned) {
        struct reduction unused;
        reduction_init(&unused, p->f.degree, k, w->scratch);
        reduction_init(&unused, p->g.degree, k, w->scratch + reduction_length(p->f.degree, k));
    }
    if (margin) {
        return solve_by_shrinking(p, w, out, step, cell_arcs_may_meet, rule);
    }
    struct problem q = *p;
    q.bounds.scale = q.bounds.f = q.bounds.g = 0;
    return solve_by_shrinking(&q, w, out, step, cell_arcs_may_meet, rule);
}

static inline size_t scratch_length(int n, int m, int k)
{
    return 2 * (size_t)(n + m + 2) * (size_t)(k + 1);
}

/* One entry of the registry: its rules, its step, its order per round at contact 1, its name and summary. */
#define HYBRID(id, degree, scalar_, variant, rule, wrong_and, wrong_delta, margin, stretch, order_, what)    \
    static int id##_shrink(const struct problem *p, const struct workspace *w, struct cell *c,               \
                           struct piece piece[PIECES_MAX])                                                   \
    {                                                                                                        \
        const struct rules rules = {degree, scalar_, variant, wrong_and, wrong_delta, stretch};              \
        return shrink(&rules, p, w, c, piece);                                                               \
    }                                                                                                        \
    static enum outcome id##_intersect(const struct problem *p, struct workspace *w, struct crossings *out)  \
    {                                                                                                        \
        return solve(p, w, out, degree, id##_shrink, rule, margin);                                          \
    }                                                                                                        \
    static size_t id##_scratch(int n, int m)                                                                 \
    {                                                                                                        \
        return scratch_length(n, m, degree);                                                                 \
    }                                                                                                        \
    extern const struct intersector id;                                                                      \
    const struct intersector id = {                                                                          \
        .name = #id,                                                                                         \
        .summary = what,                                                                                     \
        .reference = "Lou and Liu, Curve intersection using hybrid clipping, 2012",                          \
        .claimed = {order_, 1, 0, 0},                                                                        \
        .intersect = id##_intersect,                                                                         \
        .scratch = id##_scratch,                                                                             \
        .points_only = false,                                                                                \
    };

HYBRID(hybrid_clipping_1, 1, false, false, FOUR_WAY, false, false, 1, 1, 2,
       "clip a band of degree 1 to the other's fat line")
HYBRID(hybrid_clipping_2, 2, false, false, FOUR_WAY, false, false, 1, 1, 3,
       "clip a band of degree 2 to the other's fat line")
HYBRID(hybrid_clipping_3, 3, false, false, FOUR_WAY, false, false, 1, 1, 4,
       "clip a band of degree 3 to the other's fat line")
HYBRID(hybrid_clipping_2_scalar, 2, true, false, FOUR_WAY, false, false, 1, 1, 3,
       "degree 2 as published, but for a scalar delta")
HYBRID(hybrid_clipping_3_scalar, 3, true, false, FOUR_WAY, false, false, 1, 1, 4,
       "degree 3 as published, but for a scalar delta")
HYBRID(hybrid_clipping_1_arc, 1, true, true, LONGER_ARC, false, false, 1, 1, 2,
       "degree 1, scalar delta, longer arc, oriented boxes")
HYBRID(hybrid_clipping_2_arc, 2, true, true, LONGER_ARC, false, false, 1, 1, 3,
       "degree 2, scalar delta, longer arc, oriented boxes")
HYBRID(hybrid_clipping_3_arc, 3, true, true, LONGER_ARC, false, false, 1, 1, 4,
       "degree 3, scalar delta, longer arc, oriented boxes")

HYBRID(control_discard_and, 2, false, false, FOUR_WAY, true, false, 1, 1, 0,
       "control: discards where both conditions fail, as printed")
HYBRID(control_no_margin, 3, false, false, FOUR_WAY, false, false, 0, 1, 0,
       "control: bounds without their rounding")
HYBRID(control_normal_not_unit, 2, false, false, FOUR_WAY, false, false, 1, 8, 0,
       "control: a normal of length 8")
HYBRID(control_no_delta, 2, false, false, FOUR_WAY, false, true, 1, 1, 0,
       "control: delta = 0, the band taken for the curve")
