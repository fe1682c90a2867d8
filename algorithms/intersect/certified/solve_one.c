/* The one zero of two extended nodes: Newton's method, with a proved radius.
 *
 * Let x = (t, s) be local parameters, H(x) = f~(t) - g~(s), f~ and g~ extended by tangents past the node's
 * ends, and c the certified cross product of cone.c.  Nodes have widths h_f, h_g of local parameters, so with
 * B_t = V_g h_f / (p c) and B_s = V_f h_g / (q c)
 *
 *     |t - t*| <= B_t |H(x)|,   |s - s*| <= B_s |H(x)|                                               (1)
 *
 * at the zero x*.  Evaluated on the level's own curves, H errs by at most E = noise_f + noise_g + (slope
 * noises times the distances from the node), plus 2 u |H|.
 *
 * Exclusion.  If by (1) with |H~| + E the zero is outside [lo, hi] in t or s, no solution lies in the nodes.
 *
 * End.  A step d from x with the computed Jacobian J~ leaves |H(x + d)| <= |H~ + J~ d| + |J - J~||d| + E + R,
 * where R = (M_f dt^2 + M_g ds^2) / 2, M the bounds on f'' (f~' has the same Lipschitz constants).  Cramer's
 * rule leaves |H~ + J~ d| <= 12 u k |H| + 2.25 u way (tests/proofs/newton_rest.g, newton_quotient.g), with
 * way = |f'| |dt| + |g'| |ds| and k = |f'| |g'| / |det| in 1-norms; |H| is no more than way and what is left.
 * So with k u <= 1/128, which is looked at, it leaves at most 16 u (1 + k) way.  When R <= E the iteration
 * ends with N = 2 E + these terms as bound of |H(x + d)|, and (1) gives radii: computed to 16 u of itself
 * (newton_radius.g), which B makes up for.  E's own rounding is less than the 2 u S by which noise exceeds
 * what evaluate.h needs.
 *
 * Sharper.  (1) holds the worst direction of the whole node against the zero.  But x* is now known to lie
 * within the radii r of x, where f' differs from the last computed one by at most M_f (|dt| + r_t) + slope
 * noise = D_f, g' by D_g likewise.  With means U, W of f', g' between x and x*: (t - t*) cross(U, W) =
 * cross(H, W), so that
 *
 *     |t - t*| <= N (|g'| + 2 D_g) / (|det| - D_f |g'| - D_g |f'| - 2 D_f D_g),   s likewise,        (2)
 *
 * |det| less its rounding 4 u |f'| |g'|: N times the condition of the zero itself. */
#include "evaluate.h"

enum { ITERATIONS_MAX = 12 };

/* One side of the pair. */
struct arm {
    real lo, hi, width;
    real reach; /* B */
    real bend;  /* M, by local parameters */
    real noise, slope_noise;
};

static inline void arm_make(const struct source *c, const struct node *a, const struct node *other, real gap,
                            struct arm *out)
{
    out->lo = a->lo;
    out->hi = a->hi;
    out->width = a->hi - a->lo;
    out->reach = other->speed * out->width / (a->pace_lo * gap) * (1 + 8 * REAL_EPSILON);
    out->bend = a->bend / (out->width * out->width) * (1 + 8 * REAL_EPSILON);
    out->noise = c->noise;
    out->slope_noise = c->slope_noise;
}

/* The spot of the extended node at t; returns the distance of t from it. */
static inline real extended(const int n, const bool rational, const struct source *c, const struct arm *a,
                            real t, struct spot *p)
{
    real inside = clamp(t, a->lo, a->hi), past = t - inside;
    source_at_degree(n, rational, c, inside, p);
    if (past != 0) {
        p->x += past * p->dx;
        p->y += past * p->dy;
    }
    return real_abs(past);
}

/* The chords' meeting point. */
static inline void start(const struct node *f, int n, bool f_rational, const struct node *g, int m,
                         bool g_rational, real *t, real *s)
{
    const real *x = f->points, *y = x + n + 1, *a = g->points, *b = a + m + 1;
    real x0 = x[0], y0 = y[0], x1 = x[n], y1 = y[n], a0 = a[0], b0 = b[0], a1 = a[m], b1 = b[m];
    if (f_rational) {
        const real *w = y + n + 1;
        x0 = x0 / w[0];
        y0 = y0 / w[0];
        x1 = x1 / w[n];
        y1 = y1 / w[n];
    }
    if (g_rational) {
        const real *w = b + m + 1;
        a0 = a0 / w[0];
        b0 = b0 / w[0];
        a1 = a1 / w[m];
        b1 = b1 / w[m];
    }
    real ux = x1 - x0, uy = y1 - y0, vx = a1 - a0, vy = b1 - b0, rx = a0 - x0, ry = b0 - y0;
    real one = 1 / cross(ux, uy, vx, vy);
    *t = f->lo + (f->hi - f->lo) * (cross(rx, ry, vx, vy) * one);
    *s = g->lo + (g->hi - g->lo) * (cross(rx, ry, ux, uy) * one);
}

static inline real norm_1(real x, real y)
{
    return real_abs(x) + real_abs(y);
}

/* A Newton step at hand. */
struct step {
    real dt, ds, det, df, dg; /* df, dg: 1-norms of the derivatives */
    real error;               /* E */
};

static inline void radii(const struct arm *f, const struct arm *g, const struct step *d, struct zero *out)
{
    real tilt = d->df * d->dg / d->det, way = d->df * real_abs(d->dt) + d->dg * real_abs(d->ds);
    real left = 2 * d->error + way * (8 * REAL_EPSILON * (1 + tilt)) + f->slope_noise * real_abs(d->dt) +
                g->slope_noise * real_abs(d->ds);
    real rt = f->reach * left, rs = g->reach * left;
    real change_f = f->bend * (real_abs(d->dt) + rt) + f->slope_noise;
    real change_g = g->bend * (real_abs(d->ds) + rs) + g->slope_noise;
    real least = d->det - change_f * d->dg - change_g * d->df - 2 * change_f * change_g -
                 4 * REAL_EPSILON * d->df * d->dg;
    if (2 * least > d->det) {
        real by = left * (1 + 8 * REAL_EPSILON) / least;
        rt = real_min(rt, by * (d->dg + 2 * change_g));
        rs = real_min(rs, by * (d->df + 2 * change_f));
    }
    out->rt = rt + REAL_EPSILON * real_abs(out->t); /* the last subtraction, and t +- rt, round too */
    out->rs = rs + REAL_EPSILON * real_abs(out->s);
}

static inline enum search newton(const int n, const bool f_rational, const int m, const bool g_rational,
                                 const struct level *v, const struct node *f, const struct node *g, real c,
                                 struct zero *out)
{
    struct arm a, b;
    arm_make(&v->f, f, g, c, &a);
    arm_make(&v->g, g, f, c, &b);
    real t, s;
    start(f, n, f_rational, g, m, g_rational, &t, &s);
    for (int k = 0; k < ITERATIONS_MAX; k++) {
        struct spot p, q;
        struct step d;
        real past_f = extended(n, f_rational, &v->f, &a, t, &p),
             past_g = extended(m, g_rational, &v->g, &b, s, &q);
        real x = p.x - q.x, y = p.y - q.y, far = real_max(real_abs(x), real_abs(y));
        d.error = a.noise + b.noise + past_f * a.slope_noise + past_g * b.slope_noise;
        /* t +- rt rounds too */
        real rt = a.reach * (far * (1 + 4 * REAL_EPSILON) + d.error) + REAL_EPSILON * real_abs(t);
        real rs = b.reach * (far * (1 + 4 * REAL_EPSILON) + d.error) + REAL_EPSILON * real_abs(s);
        if ((t - rt > a.hi) | (t + rt < a.lo) | (s - rs > b.hi) | (s + rs < b.lo)) {
            return NO_ZERO;
        }
        real det = cross(p.dx, p.dy, q.dx, q.dy), one = 1 / det;
        d.dt = cross(x, y, q.dx, q.dy) * one;
        d.ds = cross(x, y, p.dx, p.dy) * one;
        t -= d.dt;
        s -= d.ds;
        if (a.bend * (d.dt * d.dt) + b.bend * (d.ds * d.ds) <= 2 * d.error) {
            d.det = real_abs(det);
            d.df = norm_1(p.dx, p.dy);
            d.dg = norm_1(q.dx, q.dy);
            if (!(64 * REAL_EPSILON * (d.df * d.dg) <= d.det)) {
                return STUCK;
            }
            out->t = t;
            out->s = s;
            radii(&a, &b, &d, out);
            return t - out->rt > a.hi || t + out->rt < a.lo || s - out->rs > b.hi || s + out->rs < b.lo
                       ? NO_ZERO
                       : ZERO;
        }
    }
    return STUCK;
}

enum search solve_one(const struct level *v, const struct node *f, const struct node *g, real c,
                      struct zero *out)
{
    int n = v->f.n, m = v->g.n;
    if (!v->f.rational && !v->g.rational) {
        if (n == 3 && m == 3) {
            return newton(3, false, 3, false, v, f, g, c, out);
        }
        if (n == 2 && m == 2) {
            return newton(2, false, 2, false, v, f, g, c, out);
        }
        return newton(n, false, m, false, v, f, g, c, out);
    }
    return newton(n, v->f.rational, m, v->g.rational, v, f, g, c, out);
}
