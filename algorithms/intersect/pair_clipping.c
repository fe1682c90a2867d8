/* Clip both curves at once: each a fat curve of degree k, after preconditioning, with proof of what the box
 * holds.
 *
 * Order k + 1 in both parameters at a crossing, for every k (theorem and proof in core/pair.h), where the fat
 * line of hybrid clipping cannot get past 4; k = 1 is to be compared with Krawczyk's operator (R. Krawczyk,
 * Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, 1969; R. Moore, A test for existence
 * of solutions to nonlinear systems, 1977).  Relative: B. Juttler, B. Moore, A quadratic clipping step with
 * superquadratic convergence for bivariate polynomial systems, 2011, a fat line against a fat conic.
 *
 * A box that is proved to hold exactly one solution is a UNIQUE record, no matter how narrow rounding lets it
 * become. Where the arcs are too bent or too parallel for a step, they are tested by oriented boxes and the
 * longer is halved: at contacts, always. */
#include "../core/cells.h"
#include "../core/pair.h"

#define ALWAYS_INLINE __attribute__((always_inline))

enum { PAIR_DEGREE_MAX = 3 };

/* The reductions of f's degree to 1, ..., k, then those of g's: laid out one after the other in scratch. */
static void reductions_at(const struct problem *p, const struct workspace *w, int k, struct reduction *rf,
                          struct reduction *rg)
{
    real *memory = w->scratch;
    for (int i = 0; i < 2 * k; i++) {
        int d = i % k + 1, n = i < k ? p->f.degree : p->g.degree;
        struct reduction r = {n, d < n ? d : n, d < n ? memory : NULL, memory + (n + 1) * (d + 1)};
        *(i < k ? &rf[d - 1] : &rg[d - 1]) = r;
        memory += reduction_length(n, d);
    }
}

/* A quarter of the area, or less, is left; of a curve that is narrow enough nothing more is asked. */
static bool is_gain(const struct problem *p, const struct cell *c, const struct pair_box *box)
{
    real t = interval_width(&box->t), s = interval_width(&box->s);
    if (interval_width(&c->t) <= p->bounds.tolerance_t) {
        return 2 * s < 1;
    }
    return interval_width(&c->s) <= p->bounds.tolerance_s ? 2 * t < 1 : 4 * t * s < 1;
}

static inline ALWAYS_INLINE int shrink(int k, const struct problem *p, const struct workspace *w,
                                       struct cell *c, struct piece piece[PIECES_MAX])
{
    struct arc f = cell_f(p, c), g = cell_g(p, c);
    struct pair_box box;
    if (!c->proved && !arc_oriented_boxes_meet(&f, &g, p->bounds.scale)) {
        return 0;
    }
    struct reduction rf[PAIR_DEGREE_MAX], rg[PAIR_DEGREE_MAX];
    reductions_at(p, w, k, rf, rg);
    enum pair_outcome outcome = pair_clip(&f, &g, p->bounds.scale, rf, rg, k, &box);
    if (outcome != BOXED) {
        return outcome == NOWHERE_MET ? 0 : HALVE;
    }
    c->proved = c->proved || box.holds_one;
    piece[0].t = c->t;
    piece[0].s = c->s;
    interval_clip(&piece[0].t, box.t.lo, box.t.hi);
    interval_clip(&piece[0].s, box.s.lo, box.s.hi);
    if (is_gain(p, c, &box)) {
        return 1;
    }
    cell_narrow(p, c, &piece[0]);
    return c->proved && box.at_floor ? ACCEPT : HALVE;
}

static enum outcome solve(const struct problem *p, struct workspace *w, struct crossings *out, int k,
                          shrink_function *step)
{
    real *memory = w->scratch;
    for (int i = 0; !w->planned && i < 2 * k; i++) {
        struct reduction unused;
        int d = i % k + 1, n = i < k ? p->f.degree : p->g.degree;
        reduction_init(&unused, n, d, memory);
        memory += reduction_length(n, d);
    }
    return solve_by_shrinking(p, w, out, step, cell_arcs_may_meet, LONGER_ARC);
}

static size_t scratch(int k, int n, int m)
{
    return (size_t)(n + m + 2) * (size_t)(k * (k + 3));
}

#define PAIR(k_)                                                                                             \
    CELL_METHOD(pair_clipping, k_,                                                                           \
                "both curves as fat curves of degree " #k_ ", preconditioned; boxes proved unique",          \
                "fatline; relatives: Krawczyk 1969, Juttler and Moore 2011", k_ + 1, 1, 0, 0)

PAIR(1)
PAIR(2)
PAIR(3)
