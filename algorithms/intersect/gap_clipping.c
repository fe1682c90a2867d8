/* Clip the gap between the two curves, taken as a function of one parameter: superlinear at contacts and
 * cusps too.
 *
 * One step on a pair of arcs.  Of the two, the one whose control polygon advances more evenly along its chord
 * is b, the other a.  Both are clipped to their common extent along that chord; over it, b's parameter is
 * eliminated: Y_A(t) - Y_B(sigma(t)), a polynomial of degree k with a proved remainder (core/gap.h), can be 0
 * only where it is within its remainder.  What is left of t is found by inverting that band, what is left of
 * s lies around sigma.  Order (k + 1) / mu at a solution of multiplicity mu where one of the curves is
 * regular: theorem, proof and relatives in core/gap.h.  No published method for two curves has more than
 * order 1 at contacts.
 *
 * Nothing is lost.  A pair is discarded if oriented boxes are apart, if there is no common extent, or if the
 * gap exceeds its remainder everywhere; each with its rounding.  Ends of curves need no care: parameters
 * outside [0, 1] do not exist, and where only end points face each other the common extent has shrunk to a
 * point, which is then the piece. Where b does not advance, or little is gained, the longer arc is halved. */
#include "../core/band.h"
#include "../core/cells.h"
#include "../core/gap.h"

#define ALWAYS_INLINE __attribute__((always_inline))

/* The two roles: a's and b's curve, the arcs, their parameters, and memory for cut control points. */
struct roles {
    bool b_is_f;
    const struct curve *curve_a, *curve_b;
    struct arc a, b;
    struct interval at, bt; /* a's and b's parameters */
    struct frame frame;
};

/* False: neither arc advances along its chord. */
static bool choose_roles(const struct problem *p, const struct cell *c, const struct arc *f,
                         const struct arc *g, struct roles *z)
{
    struct frame along_f, along_g;
    real even_f = gap_frame(f, p->bounds.scale, &along_f), even_g = gap_frame(g, p->bounds.scale, &along_g);
    z->b_is_f = even_f > even_g;
    z->curve_a = z->b_is_f ? &p->g : &p->f;
    z->curve_b = z->b_is_f ? &p->f : &p->g;
    z->a = z->b_is_f ? *g : *f;
    z->b = z->b_is_f ? *f : *g;
    z->at = z->b_is_f ? c->s : c->t;
    z->bt = z->b_is_f ? c->t : c->s;
    if (!(real_max(even_f, even_g) > 0)) {
        return false;
    }
    z->frame = z->b_is_f ? along_f : along_g;
    return true;
}

static void put_piece(const struct roles *z, const struct interval *at, const struct interval *bt,
                      struct piece *piece)
{
    piece->t = z->b_is_f ? *bt : *at;
    piece->s = z->b_is_f ? *at : *bt;
}

/* Clips to the common extent; cuts anew what loses more than an eighth.  False: there is none. */
static bool clip_along(struct roles *z, real *points_a, real *points_b)
{
    struct interval t = {0, 1}, s = {0, 1};
    const real most = (real)0.875;
    if (!gap_common_extent(&z->a, &z->b, &z->frame, &t, &s)) {
        return false;
    }
    if (t.hi - t.lo < most) {
        interval_clip(&z->at, t.lo, t.hi);
        bernstein_restrict(z->curve_a->degree, curve_components(z->curve_a), z->curve_a->x, z->at.lo,
                           z->at.hi, points_a);
        z->a = arc_of(z->curve_a, points_a, z->a.error);
    }
    if (s.hi - s.lo < most) {
        interval_clip(&z->bt, s.lo, s.hi);
        bernstein_restrict(z->curve_b->degree, curve_components(z->curve_b), z->curve_b->x, z->bt.lo,
                           z->bt.hi, points_b);
        z->b = arc_of(z->curve_b, points_b, z->b.error);
    }
    return true;
}

/* Pieces of the pair after the clip along the chord. */
static int clip_gap(const struct roles *z, const struct gap *gap, struct piece piece[PIECES_MAX])
{
    struct band above, below, kept;
    int pieces = 0;
    band_above(gap->k, gap->above, &above);
    band_above(gap->k, gap->below, &below);
    band_meet(&above, &below, &kept);
    for (int i = 0; i < kept.count; i++) {
        struct interval at = z->at, bt = z->bt, s = gap_partner(gap, kept.lo[i], kept.hi[i]);
        if (s.lo > 1 || s.hi < 0) {
            continue;
        }
        interval_clip(&at, kept.lo[i], kept.hi[i]);
        interval_clip(&bt, real_max(0, s.lo), real_min(1, s.hi));
        put_piece(z, &at, &bt, &piece[pieces++]);
    }
    return pieces;
}

static struct reduction reduction_at(const struct problem *p, const struct workspace *w, int k, bool g)
{
    int n = g ? p->g.degree : p->f.degree;
    const real *memory = w->scratch + (g ? reduction_length(p->f.degree, k) : 0);
    struct reduction r = {n, k < n ? k : n, k < n ? memory : NULL, memory + (n + 1) * (k + 1)};
    return r;
}

/* What is left of t0 by s0, as a part of its area; of s alone, or of t alone, where the other is narrow
 * enough. */
static real part_left(const struct problem *p, const struct interval *t0, const struct interval *s0,
                      const struct interval *t, const struct interval *s)
{
    real whole_t = interval_width(t0), whole_s = interval_width(s0);
    if (whole_t <= p->bounds.tolerance_t) {
        return interval_width(s) / whole_s;
    }
    real left_t = interval_width(t) / whole_t;
    return whole_s <= p->bounds.tolerance_s ? left_t : left_t * (interval_width(s) / whole_s);
}

/* One clip along a chord and one of the gap.  HALVE: neither arc advances along its chord. */
static inline ALWAYS_INLINE int clip(int k, const struct problem *p, const struct workspace *w,
                                     const struct cell *c, struct piece piece[PIECES_MAX])
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    struct roles z;
    struct gap gap;
    real points_a[3 * (DEGREE_MAX + 1)], points_b[3 * (DEGREE_MAX + 1)];
    if (!arc_oriented_boxes_meet(&f, &g, p->bounds.scale)) {
        return 0;
    }
    if (!choose_roles(p, c, &f, &g, &z)) {
        return HALVE;
    }
    if (!clip_along(&z, points_a, points_b)) {
        return 0;
    }
    struct reduction ra = reduction_at(p, w, k, z.b_is_f), rb = reduction_at(p, w, k, !z.b_is_f);
    if (gap_between(&z.a, &z.b, &z.frame, &ra, &rb, k, &gap)) {
        return clip_gap(&z, &gap, piece);
    }
    put_piece(&z, &z.at, &z.bt, &piece[0]);
    return 1;
}

/* Every piece must be half of the area or less.  A clip that leaves one piece between that and seven eighths
 * is repeated on it once: long arcs need that to come within reach of the theorem, and halving makes two. */
static inline ALWAYS_INLINE int shrink(int k, const struct problem *p, const struct workspace *w,
                                       struct cell *c, struct piece piece[PIECES_MAX])
{
    const struct interval t = c->t, s = c->s;
    for (int i = 0; i < 2; i++) {
        real most = 0;
        int pieces = clip(k, p, w, c, piece);
        if (pieces <= 0) {
            return pieces;
        }
        for (int j = 0; j < pieces; j++) {
            most = real_max(most, part_left(p, &t, &s, &piece[j].t, &piece[j].s));
        }
        if (2 * most < 1) {
            return pieces;
        }
        if (pieces > 1) {
            break;
        }
        cell_narrow(p, c, &piece[0]);
        if (8 * most > 7) {
            break;
        }
    }
    return HALVE;
}

static enum outcome solve(const struct problem *p, struct workspace *w, struct crossings *out, int k,
                          shrink_function *step)
{
    if (!w->planned) {
        struct reduction unused;
        reduction_init(&unused, p->f.degree, k, w->scratch);
        reduction_init(&unused, p->g.degree, k, w->scratch + reduction_length(p->f.degree, k));
    }
    return solve_by_shrinking(p, w, out, step, cell_arcs_may_meet, LONGER_ARC);
}

static size_t scratch(int k, int n, int m)
{
    return 2 * (size_t)(n + m + 2) * (size_t)(k + 1);
}

/* The orders are (k + 1) / mu, at a cusp that is crossed mu = 2. */
#define GAP(k_)                                                                                              \
    CELL_METHOD(gap_clipping, k_, "clip the gap of the curves over one parameter, degree " #k_,              \
                "fatline; relatives: Juttler and Moore, A quadratic clipping step, 2011", k_ + 1,            \
                (k_ + 1) / 2.0, (k_ + 1) / 3.0, (k_ + 1) / 2.0)

GAP(2)
GAP(3)
GAP(4)
GAP(5)
