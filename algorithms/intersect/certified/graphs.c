/* Two nodes as graphs over one direction, and what keeps them apart there. */
#include "graphs.h"

/* ---- strips ---- */

static real at_x(const struct source *c, const struct node *a, int i)
{
    int n = c->n;
    return c->rational ? a->points[i] / a->points[2 * (n + 1) + i] : a->points[i];
}

static real at_y(const struct source *c, const struct node *a, int i)
{
    int n = c->n;
    return c->rational ? a->points[n + 1 + i] / a->points[2 * (n + 1) + i] : a->points[n + 1 + i];
}

/* Range of the offsets ux (y - y0) - uy (x - x0) of a's control points. */
static struct interval offsets(const struct source *c, const struct node *a, real ux, real uy, real x0,
                               real y0)
{
    real d = ux * (at_y(c, a, 0) - y0) - uy * (at_x(c, a, 0) - x0);
    struct interval r = {d, d};
    for (int i = 1; i <= c->n; i++) {
        d = ux * (at_y(c, a, i) - y0) - uy * (at_x(c, a, i) - x0);
        r.lo = real_min(r.lo, d);
        r.hi = real_max(r.hi, d);
    }
    return r;
}

/* The same for polynomial cubics. */
static struct interval offsets_cubic(const real *x, const real *y, real ux, real uy, real x0, real y0)
{
    real a = ux * (y[0] - y0) - uy * (x[0] - x0), b = ux * (y[1] - y0) - uy * (x[1] - x0);
    real c = ux * (y[2] - y0) - uy * (x[2] - x0), d = ux * (y[3] - y0) - uy * (x[3] - x0);
    struct interval r = {real_min(real_min(a, b), real_min(c, d)), real_max(real_max(a, b), real_max(c, d))};
    return r;
}

static struct interval offsets_of(const struct source *c, const struct node *a, real ux, real uy, real x0,
                                  real y0)
{
    return c->n == 3 && !c->rational ? offsets_cubic(a->points, a->points + 4, ux, uy, x0, y0)
                                     : offsets(c, a, ux, uy, x0, y0);
}

/* Along a's chord.  An offset errs by the points' 2 E |u|_1 (twice, for x0, y0) and 8 u S |u|_1 of rounding.
 */
static bool apart_along(const struct source *c, const struct node *a, const struct source *d,
                        const struct node *b)
{
    real x0 = at_x(c, a, 0), y0 = at_y(c, a, 0), ux = at_x(c, a, c->n) - x0, uy = at_y(c, a, c->n) - y0;
    struct interval own = offsets_of(c, a, ux, uy, x0, y0), other = offsets_of(d, b, ux, uy, x0, y0);
    real bound = 4 * (c->node_error + d->node_error) * (real_abs(ux) + real_abs(uy));
    return own.lo - other.hi > bound || other.lo - own.hi > bound;
}

bool strips_apart(const struct level *v, const struct node *f, const struct node *g)
{
    return apart_along(&v->f, f, &v->g, g) || apart_along(&v->g, g, &v->f, f);
}

/* ---- graphs ---- */

/* Range of |e . direction| with its error; false if a direction may point back, or they turn too much. */
static bool run_of(const struct node *a, real ex, real ey, real sign, struct interval *run)
{
    const real *ax = a->way, *ay = ax + a->ways;
    real d = sign * (ex * ax[0] + ey * ay[0]);
    run->lo = run->hi = d;
    for (int i = 1; i < a->ways; i++) {
        d = sign * (ex * ax[i] + ey * ay[i]);
        run->lo = real_min(run->lo, d);
        run->hi = real_max(run->hi, d);
    }
    real pad = 2 * a->error;
    run->lo -= pad;
    run->hi += pad;
    return 8 * run->lo > run->hi;
}

/* With N of degree d = ways - 1: cross(N, N') = d sum of B(k, 2d-2) K[k], K as in nodes.c with (x, y) for (x,
 * w): weights C(d-1,i) C(d-1,k-i) / C(2d-2,k) times x[i] y[k-i+1] - x[i+1] y[k-i]. */
static struct interval turn_of(const struct node *a)
{
    int d = a->ways - 1;
    const real *x = a->way, *y = x + a->ways;
    real c = cross(x[0], y[0], x[1], y[1]), e;
    struct interval r = {c, c};
    if (d == 2) {
        c = (real)0.5 * cross(x[0], y[0], x[2], y[2]);
        e = cross(x[1], y[1], x[2], y[2]);
        r.lo = real_min(r.lo, real_min(c, e));
        r.hi = real_max(r.hi, real_max(c, e));
    } else if (d > 2) {
        real turn[4 * DEGREE_MAX];
        direction_turn(a, turn);
        for (int k = 1; k <= 2 * d - 2; k++) {
            r.lo = real_min(r.lo, turn[k]);
            r.hi = real_max(r.hi, turn[k]);
        }
    }
    return r;
}

/* y'' by x is cross(f', f'') / (e . f')^3 = d K / (pace (e . N)^3).  K errs by (d + 8) e V: 4 e V by the
 * directions' errors e, (4 d + 16) 2 u V^2 <= (d + 4) e V by rounding, since u V <= e / 8. */
static struct interval curvature_of(const struct node *a, const struct interval *run, real sign)
{
    struct interval out = {0, 0};
    int d = a->ways - 1;
    if (d == 0) {
        return out;
    }
    struct interval k = turn_of(a);
    real pad = (d + 8) * a->error * a->speed, lo = k.lo - pad, hi = k.hi + pad;
    if (sign < 0) {
        real swap = lo;
        lo = -hi;
        hi = -swap;
    }
    real least = a->pace_lo * (run->lo * run->lo * run->lo),
         most = a->pace_hi * (run->hi * run->hi * run->hi);
    out.lo = d * lo / (lo > 0 ? most : least);
    out.hi = d * hi / (hi > 0 ? least : most);
    real slack = 32 * REAL_EPSILON;
    out.lo -= slack * real_abs(out.lo);
    out.hi += slack * real_abs(out.hi);
    return out;
}

/* From own to local parameters, by x' = pace e . N. */
static void run_localize(const struct node *a, struct interval *run)
{
    real width = a->hi - a->lo;
    run->lo = run->lo * a->pace_lo / width * (1 - 8 * REAL_EPSILON);
    run->hi = run->hi * a->pace_hi / width * (1 + 8 * REAL_EPSILON);
}

bool graphs_init(const struct level *v, const struct node *f, const struct node *g, struct graphs *out)
{
    const int n = v->f.n, m = v->g.n;
    real ux = at_x(&v->f, f, n) - at_x(&v->f, f, 0), uy = at_y(&v->f, f, n) - at_y(&v->f, f, 0);
    real wx = at_x(&v->g, g, m) - at_x(&v->g, g, 0), wy = at_y(&v->g, g, m) - at_y(&v->g, g, 0);
    real u = real_sqrt(ux * ux + uy * uy), w = real_sqrt(wx * wx + wy * wy);
    out->sign = ux * wx + uy * wy < 0 ? -1 : 1;
    real ex = ux / u + out->sign * wx / w, ey = uy / u + out->sign * wy / w;
    real length = real_sqrt(ex * ex + ey * ey);
    ex = ex / length;
    ey = ey / length;
    out->ex = ex;
    out->ey = ey;
    if (!(length > (real)0.5) || !run_of(f, ex, ey, 1, &out->run_f) ||
        !run_of(g, ex, ey, out->sign, &out->run_g)) {
        return false;
    }
    out->curve_f = curvature_of(f, &out->run_f, 1);
    out->curve_g = curvature_of(g, &out->run_g, out->sign);
    run_localize(f, &out->run_f);
    run_localize(g, &out->run_g);
    real most =
        real_max(real_max(out->curve_f.hi, -out->curve_f.lo), real_max(out->curve_g.hi, -out->curve_g.lo));
    out->bend = most;
    /* the common part in x, from end points that err by the nodes' errors */
    bool ahead = out->sign > 0;
    out->x_f.lo = ex * at_x(&v->f, f, 0) + ey * at_y(&v->f, f, 0);
    out->x_f.hi = ex * at_x(&v->f, f, n) + ey * at_y(&v->f, f, n);
    out->x_g.lo = ex * at_x(&v->g, g, ahead ? 0 : m) + ey * at_y(&v->g, g, ahead ? 0 : m);
    out->x_g.hi = ex * at_x(&v->g, g, ahead ? m : 0) + ey * at_y(&v->g, g, ahead ? m : 0);
    out->x_error = 2 * (v->f.node_error + v->g.node_error);
    out->x.lo = real_max(out->x_f.lo, out->x_g.lo);
    out->x.hi = real_min(out->x_f.hi, out->x_g.hi);
    out->apart = out->x.lo - out->x.hi > 2 * out->x_error;
    if (out->x.lo > out->x.hi) {
        out->x.lo = out->x.hi = (out->x.lo + out->x.hi) / 2;
    }
    return true;
}

/* Parameters of an arc whose abscissa x, increasing, lies in [lo, hi]: from each end by the largest and the
 * least |x'|. */
static struct interval abscissas(const struct node *a, const struct interval *x, const struct interval *run,
                                 real lo, real hi)
{
    real from_start = real_max(lo - x->lo, (real)0) / run->hi,
         from_end = real_max(x->hi - hi, (real)0) / run->hi;
    real before_end = real_max(x->hi - lo, (real)0) / run->lo,
         after_start = real_max(hi - x->lo, (real)0) / run->lo;
    struct interval out;
    out.lo = real_max(a->lo + from_start, a->hi - before_end);
    out.hi = real_min(a->hi - from_end, a->lo + after_start);
    return out;
}

void graphs_common(const struct node *f, const struct node *g, const struct graphs *h, real pad,
                   struct zero *out)
{
    real more = 2 * h->x_error + pad, lo = h->x.lo - more, hi = h->x.hi + more;
    struct interval t = abscissas(f, &h->x_f, &h->run_f, lo, hi),
                    s = abscissas(g, &h->x_g, &h->run_g, lo, hi);
    if (h->sign < 0) { /* g runs backwards */
        real first = g->lo + (g->hi - s.hi);
        s.hi = g->hi - (s.lo - g->lo);
        s.lo = first;
    }
    out->t = (t.lo + t.hi) / 2;
    out->s = (s.lo + s.hi) / 2;
    out->rt = real_max(t.hi - t.lo, (real)0) / 2 + REAL_EPSILON;
    out->rs = real_max(s.hi - s.lo, (real)0) / 2 + REAL_EPSILON;
}

/* ---- the gap ---- */

/* With r = f(t) - g(s) in the frame, (hx, hy), and slopes y' of both: the gap at X_f(t) is
 *     y_f - y_g(X_f) = hy - y_g' hx - y_g'' hx^2 / 2,   its slope y_f' - y_g' - y_g'' hx.
 * Noise: E in each coordinate, |e|_1 <= 1.5; slopes err by 1.5 (1 + |y'|) slope noise / x', and 8 u of
 * themselves. */
void gap_look(const struct level *v, const struct graphs *h, real t, real s, struct gap_view *out)
{
    struct spot p, q;
    source_at(&v->f, t, &p);
    source_at(&v->g, s, &q);
    real rx = p.x - q.x, ry = p.y - q.y;
    out->t = t;
    out->s = s;
    out->run_f = h->ex * p.dx + h->ey * p.dy;
    out->run_g = h->ex * q.dx + h->ey * q.dy;
    real slope_f = cross(h->ex, h->ey, p.dx, p.dy) / out->run_f,
         slope_g = cross(h->ex, h->ey, q.dx, q.dy) / out->run_g;
    real noise = v->f.noise + v->g.noise, steep = 1 + real_abs(slope_f) + real_abs(slope_g);
    out->x = h->ex * p.x + h->ey * p.y;
    out->hx = h->ex * rx + h->ey * ry;
    real hy = cross(h->ex, h->ey, rx, ry);
    out->gap = hy - slope_g * out->hx;
    out->slope = slope_f - slope_g;
    out->slope_error = h->bend * real_abs(out->hx) + 8 * REAL_EPSILON * steep +
                       (real)1.5 * steep * (v->f.slope_noise / h->run_f.lo + v->g.slope_noise / h->run_g.lo);
    out->gap_error = (real)1.5 * noise * steep +
                     real_abs(out->hx) * (out->slope_error + 8 * REAL_EPSILON * steep) +
                     8 * REAL_EPSILON * real_abs(hy);
    out->noise = noise;
}

void gap_start(const struct node *f, const struct node *g, const struct graphs *h, real x, real *t, real *s)
{
    real of_f = (x - h->x_f.lo) / (h->x_f.hi - h->x_f.lo), of_g = (x - h->x_g.lo) / (h->x_g.hi - h->x_g.lo);
    if (h->sign < 0) {
        of_g = 1 - of_g;
    }
    *t = clamp(f->lo + (f->hi - f->lo) * of_f, f->lo, f->hi);
    *s = clamp(g->lo + (g->hi - g->lo) * of_g, g->lo, g->hi);
}

void gap_step(const struct node *f, const struct node *g, real x, const struct gap_view *from, real *t,
              real *s)
{
    *t = clamp(from->t + (x - from->x) / from->run_f, f->lo, f->hi);
    *s = clamp(from->s + (x - from->x + from->hx) / from->run_g, g->lo, g->hi);
}

bool gap_is_level(const struct graphs *h, const struct gap_view *at)
{
    return 8 * (h->bend * at->hx * at->hx) <= at->noise &&
           8 * real_abs(at->hx) * at->slope_error <= at->noise;
}

bool gap_look_at(const struct level *v, const struct node *f, const struct node *g, const struct graphs *h,
                 real x, struct gap_view *out)
{
    real t, s;
    gap_start(f, g, h, x, &t, &s);
    for (int k = 0; k < 8; k++) {
        gap_look(v, h, t, s, out);
        if (real_abs(out->x - x) <= 2 * h->x_error && gap_is_level(h, out)) {
            return true;
        }
        gap_step(f, g, x, out, &t, &s);
    }
    return false;
}
