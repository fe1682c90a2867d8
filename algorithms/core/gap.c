#include "gap.h"

#include "bernstein.h"
#include "hull.h"

enum { POINTS = 33 };

/* ---- frame ---- */

static real euclidean(const struct arc *a, const real *c, int i)
{
    return a->w ? c[i] / a->w[i] : c[i];
}

real gap_frame(const struct arc *b, real scale, struct frame *f)
{
    const int m = b->degree;
    real x0 = euclidean(b, b->x, 0), y0 = euclidean(b, b->y, 0), x1 = euclidean(b, b->x, m),
         y1 = euclidean(b, b->y, m);
    real x = x1 - x0, y = y1 - y0, size = real_max(real_abs(x), real_abs(y));
    if (!(size > 0)) {
        return 0;
    }
    int e = -real_exponent(size);
    f->scale = scale;
    f->x0 = x0 + x / 2;
    f->y0 = y0 + y / 2;
    f->row[0][0] = f->row[1][1] = real_ldexp(x, e);
    f->row[0][1] = real_ldexp(y, e);
    f->row[1][0] = -f->row[0][1];
    frame_set_norms(f);
    real least = REAL_HUGE, most = 0, before = 0;
    for (int i = 0; i <= m; i++) {
        real along = f->row[0][0] * euclidean(b, b->x, i) + f->row[0][1] * euclidean(b, b->y, i);
        if (i > 0) {
            least = real_min(least, along - before);
            most = real_max(most, along - before);
        }
        before = along;
    }
    return most > 0 ? least / most : (real)0;
}

/* ---- common extent ---- */

/* Where the coordinate c, with weights w or none, may lie in [lo, hi]. */
static bool clip_to_extent(const struct arc *a, const real *c, real lo, real hi, struct interval *t)
{
    real above[POINTS], below[POINTS];
    for (int i = 0; i <= a->degree; i++) {
        above[i] = c[i] - (a->w ? lo * a->w[i] : lo);
        below[i] = (a->w ? hi * a->w[i] : hi) - c[i];
    }
    return hull_meet(a->degree, above, &t->lo, &t->hi) && hull_meet(a->degree, below, &t->lo, &t->hi);
}

/* nearby_extent widened both ranges by the error of a coordinate; here two more roundings of at most 2 norm
 * scale and the error of the other arc's come in. */
bool gap_common_extent(const struct arc *a, const struct arc *b, const struct frame *f, struct interval *t,
                       struct interval *s)
{
    real ca[POINTS], cb[POINTS], lo_a, hi_a, lo_b, hi_b;
    nearby_extent(a, f, ca, &lo_a, &hi_a);
    nearby_extent(b, f, cb, &lo_b, &hi_b);
    real lo = real_max(lo_a, lo_b), hi = real_min(hi_a, hi_b);
    real margin = f->norm[0] * (a->error + b->error + 16 * REAL_EPSILON * f->scale);
    if (lo > hi) {
        return false;
    }
    lo = lo - margin;
    hi = hi + margin;
    return clip_to_extent(a, ca, lo, hi, t) && clip_to_extent(b, cb, lo, hi, s);
}

/* ---- the gap ---- */

/* Where X_B is xa[0]: sigma's constant term.  Four steps of Newton's method, enough for 16 times the digits
 * that the chord gives; any number will do. */
static bool find_centre(const struct model *x, real value, real *at)
{
    real v = 0;
    for (int step = 0; step < 5; step++) {
        real slope, off = model_value(x, v, &slope) - value;
        if (!(slope > 0)) {
            return false;
        }
        v = real_max(-1, real_min(1, v - off / slope));
    }
    *at = v;
    return true;
}

/* tau with X(tau(u)) = X_A(u) - X_A(0) + ... up to degree k, X being about the centre: one more coefficient
 * is right after each round.  Any polynomial with tau(0) = 0 will do. */
static void invert_series(const struct model *x, const struct model *xa, struct model *tau)
{
    const int k = x->k;
    struct model bend = *x, rest;
    bend.c[0] = bend.c[1] = 0;
    tau->k = k;
    tau->rest = tau->c[0] = 0;
    for (int j = 1; j <= k; j++) {
        tau->c[j] = xa->c[j] / x->c[1];
    }
    for (int round = 1; round < k; round++) {
        model_compose(&bend, tau, &rest);
        for (int j = 1; j <= k; j++) {
            tau->c[j] = (xa->c[j] - rest.c[j]) / x->c[1];
        }
    }
}

/* Where b's parameter and the values of tau lie, about the centre: within [-1, 1] moved, and tau's control
 * points.  False: farther out than 4. */
static bool find_reach(const struct model *tau, real centre, struct interval *v)
{
    real b[MODEL_MAX + 1],
        rounding = model_to_bernstein(tau, 1, b) + 4 * REAL_EPSILON * (1 + real_abs(centre));
    v->lo = -1 - centre;
    v->hi = 1 - centre;
    for (int i = 0; i <= tau->k; i++) {
        v->lo = real_min(v->lo, b[i]);
        v->hi = real_max(v->hi, b[i]);
    }
    v->lo = v->lo - rounding;
    v->hi = v->hi + rounding;
    return -4 <= v->lo && v->hi <= 4;
}

/* Differences d[0..k-1] of m's Bernstein coefficients on [lo, hi], or on a little more, r = max(|lo|, |hi|);
 * returns a bound of their errors: twice that of model_to_bernstein and of bernstein_restrict, one rounding.
 */
static real slopes_over(const struct model *m, const struct interval *v, real r, real *d)
{
    const int k = m->k;
    real b[MODEL_MAX + 1], part[MODEL_MAX + 1], rounding = model_to_bernstein(m, r, b), largest = 0;
    real lo = real_max(0, (v->lo + r) / (2 * r) - 2 * REAL_EPSILON),
         hi = real_min(1, (v->hi + r) / (2 * r) + 2 * REAL_EPSILON);
    for (int i = 0; i <= k; i++) {
        largest = real_max(largest, real_abs(b[i]));
    }
    bernstein_restrict(k, 1, b, lo, hi, part);
    for (int i = 0; i < k; i++) {
        d[i] = part[i + 1] - part[i];
    }
    return 2 * rounding + (8 * k + 2) * REAL_EPSILON * largest;
}

/* Bounds over v: X' >= least > 0, |Y'| <= steepest X'.  False if there are none.  The coefficients of the
 * hodographs carry over to all v: X' >= min d_i, and steepest X' -+ Y' has positive coefficients. */
static bool bound_slopes(const struct model *x, const struct model *y, const struct interval *v, real *least,
                         real *steepest)
{
    const int k = x->k;
    const real r = real_max(-v->lo, v->hi);
    real dx[MODEL_MAX + 1], dy[MODEL_MAX + 1];
    real error_x = slopes_over(x, v, r, dx), error_y = slopes_over(y, v, r, dy);
    *least = REAL_HUGE;
    *steepest = 0;
    for (int i = 0; i < k; i++) {
        real d = dx[i] - error_x;
        if (!(d > 0)) {
            return false;
        }
        *least = real_min(*least, d);
        *steepest = real_max(*steepest, (real_abs(dy[i]) + error_y) / d);
    }
    const real few = 64 * REAL_EPSILON; /* the quotients here, and an interval longer by at most 56 of 2 */
    *least = *least * (1 - few) * k / (v->hi - v->lo);
    *steepest += few * *steepest;
    return true;
}

/* p(tau) - q: its coefficients, and in rest a bound of what they leave out. */
static void compose_difference(const struct model *p, const struct model *tau, const struct model *q,
                               struct model *out)
{
    model_compose(p, tau, out);
    for (int j = 0; j <= p->k; j++) {
        out->rest += REAL_EPSILON * (real_abs(out->c[j]) + real_abs(q->c[j]));
        out->c[j] = q->c[j] - out->c[j];
    }
}

/* d_X or d_Y: both arcs' distances from their models, and the rounding of the shift (model_shift). */
static real model_error(const struct model *a, const struct model *b, real at, real reach)
{
    return a->rest + b->rest + b->k * REAL_EPSILON * model_size(b, 2 * real_abs(at) + reach);
}

/* Bernstein coefficients of the gap plus and minus its bound, and of s = (1 + centre + tau) / 2. */
static void write_gap(const struct model *gap, real bound, const struct model *tau, real centre, real eta,
                      struct gap *out)
{
    const int k = gap->k;
    real b[MODEL_MAX + 1], rounding = model_to_bernstein(gap, 1, b), size = model_size(gap, 1);
    bound = bound + gap->rest + rounding;
    bound += bound / 64 + 4 * REAL_EPSILON * size;
    out->k = k;
    for (int i = 0; i <= k; i++) {
        out->above[i] = bound + b[i];
        out->below[i] = bound - b[i];
    }
    rounding = model_to_bernstein(tau, 1, b);
    for (int i = 0; i <= k; i++) {
        out->sigma[i] = (1 + centre + b[i]) / 2;
    }
    out->eta = (eta + rounding) / 2;
    out->eta += out->eta / 64 + 4 * REAL_EPSILON * (1 + real_abs(centre) + model_size(tau, 1));
}

bool gap_between(const struct arc *a, const struct arc *b, const struct frame *f, const struct reduction *ra,
                 const struct reduction *rb, int k, struct gap *out)
{
    struct nearby na, nb;
    struct model xa, ya, xb, yb, tau, rest, gap;
    struct interval reach;
    real centre, least, steepest;
    nearby_init(a, f, ra, k, &na);
    nearby_init(b, f, rb, k, &nb);
    model_of_bernstein(na.degree, na.c[0], na.off[0], k, &xa);
    model_of_bernstein(na.degree, na.c[1], na.off[1], k, &ya);
    model_of_bernstein(nb.degree, nb.c[0], nb.off[0], k, &xb);
    model_of_bernstein(nb.degree, nb.c[1], nb.off[1], k, &yb);
    if (!find_centre(&xb, xa.c[0], &centre)) {
        return false;
    }
    model_shift(&xb, centre);
    model_shift(&yb, centre);
    if (!(xb.c[1] > 0)) {
        return false;
    }
    invert_series(&xb, &xa, &tau);
    if (!find_reach(&tau, centre, &reach) || !bound_slopes(&xb, &yb, &reach, &least, &steepest)) {
        return false;
    }
    compose_difference(&xb, &tau, &xa, &rest);
    compose_difference(&yb, &tau, &ya, &gap);
    const real farthest = real_max(-reach.lo, reach.hi);
    real off = model_size(&rest, 1) + rest.rest + model_error(&xa, &xb, centre, farthest);
    off += off / 64;
    real eta = off / least;
    write_gap(&gap, off * steepest + model_error(&ya, &yb, centre, farthest), &tau, centre, eta + eta / 64,
              out);
    return true;
}

/* Errors of bernstein_restrict: 8k u_0 max|sigma|. */
struct interval gap_partner(const struct gap *g, real lo, real hi)
{
    real part[MODEL_MAX + 1], largest = 0;
    bernstein_restrict(g->k, 1, g->sigma, lo, hi, part);
    struct interval s = {part[0], part[0]};
    for (int i = 0; i <= g->k; i++) {
        s.lo = real_min(s.lo, part[i]);
        s.hi = real_max(s.hi, part[i]);
        largest = real_max(largest, real_abs(g->sigma[i]));
    }
    real margin = g->eta + 8 * g->k * REAL_EPSILON * largest;
    s.lo = s.lo - margin;
    s.hi = s.hi + margin;
    return s;
}
