/* Cusps that meet cusps, and doubled ends that touch: how many solutions there are at most, by Rouche's
 * theorem.
 *
 * Where a derivative vanishes on both curves neither is a graph (graphs.c, gap_model.c).  Let the parameters
 * of the level be t0 + z and s0 + v, and the homogeneous coordinates of its curves, less a common point, P(z)
 * with weight A(z), Q(v) with weight B(v).  Solutions are the zeros of
 *
 *     H(z, v) = P(z) B(v) - Q(v) A(z),
 *
 * a pair of polynomials; complex z, v too.  Write [P](r) = sum |P_k| r^k for a component.
 *
 * Tangents that cross.  P begins with P_p z^p, Q with Q_q v^q but for terms that are small.  Across Q_q, that
 * is with P, Q replaced by cross(., Q_q), let
 *
 *     [P](r) [B](s) - |P_p B_0| r^p + [Q](s) [A](r) < |P_p B_0| r^p,
 *
 * and across P_p the same with the letters exchanged.  Then for |z| = r, |v| <= s the first component of H is
 * nearer to P_p B_0 z^p than that is to 0, for |v| = s, |z| <= r the second to Q_q A_0 v^q; so H and (P_p B_0
 * z^p, -Q_q A_0 v^q) have equally many zeros in the polydisc, p q of them with multiplicity (Rouche for
 * several variables: the homotopy has no zero on the border).  Real solutions are among them: at most p q.
 * And with the left side over |P_p B_0|, |z|^p of a zero in the polydisc is at most that, less than r^p or
 * not: it shrinks to where they are, and one polydisc on the way where both conditions hold tells how many.
 *
 * All this is about the curves, not the nodes: it holds beyond them too, and all solutions in the first
 * polydisc are in the last.
 *
 * Tangents in common: cusps_common.c.
 *
 * Rounding.  P_k = C(n, k) times k-th differences of the level's control points, by de Casteljau's algorithm
 * at t0.  With the errors of the points (of x and of w x0: 2 c->error), the subtraction (3 u S) and the
 * differences' own rounding (2 k u S), S the level's scale, they are as if the points erred by E = 2 c->error
 * + (2 n + 8) u S, the difference by 2^k E; and by 4 (n + 1) eps of itself by the algorithm. All against the
 * largest weight. Sums of terms that are not negative err relatively by less than 4 (n + m) eps. */
#include "cusps.h"
#include "graphs.h"

enum { ORDER_MAX = 4 };

/* ---- power series ---- */

static void component_powers(int n, const real *c, real at, real error, real *out, real *errors)
{
    real d[TERMS], v[TERMS], many = 1, power = 1;
    for (int i = 0; i <= n; i++) {
        d[i] = c[i];
    }
    for (int k = 0; k <= n; k++) {
        real size = 0;
        for (int i = 0; i <= n - k; i++) {
            v[i] = d[i];
            size = real_max(size, real_abs(d[i]));
        }
        for (int j = n - k; j > 0; j--) {
            for (int i = 0; i < j; i++) {
                v[i] = (1 - at) * v[i] + at * v[i + 1];
            }
        }
        out[k] = many * v[0];
        errors[k] = many * (power * error + 4 * (n + 1) * REAL_EPSILON * size);
        for (int i = 0; i < n - k; i++) {
            d[i] = d[i + 1] - d[i];
        }
        many = many * (real)(n - k) / (real)(k + 1);
        power = 2 * power;
    }
}

/* About the local parameter t; reach: how far the node's ends are. */
static void germ_make(const struct level *v, const struct source *c, const struct node *a, real t, real x0,
                      real y0, struct germ *out)
{
    const real *x = c->points, *y = x + c->n + 1, *w = y + c->n + 1;
    real px[TERMS], py[TERMS], ones[TERMS], spare[TERMS], most = 1;
    for (int i = 0; i <= c->n; i++) {
        ones[i] = c->rational ? w[i] : (real)1;
        px[i] = x[i] - x0 * ones[i];
        py[i] = y[i] - y0 * ones[i];
        most = real_max(most, ones[i]);
    }
    real error = (2 * c->error + (2 * c->n + 8) * (REAL_EPSILON / 2) * v->scale) * most;
    out->n = c->n;
    out->t = t;
    out->reach = real_max(t - a->lo, a->hi - t) * (1 + REAL_EPSILON);
    component_powers(c->n, px, t, error, out->x, spare);
    component_powers(c->n, py, t, error, out->y, out->error);
    real weight_error = c->rational ? (c->error + c->n * REAL_EPSILON) * most : (real)0;
    component_powers(c->n, ones, t, weight_error, out->w, out->error_w);
    for (int k = 0; k <= c->n; k++) {
        out->error[k] = real_max(out->error[k], spare[k]);
    }
}

/* The power that counts for most on the node; 0: the first. */
static int leading(const struct germ *a)
{
    real most = 0, power = 1;
    int best = 0;
    for (int k = 1; k <= a->n && k <= ORDER_MAX; k++) {
        power = power * a->reach;
        real size = (real_abs(a->x[k]) + real_abs(a->y[k])) * power;
        if (size > most) {
            most = size;
            best = k;
        }
    }
    return best > 1 ? best : 0;
}

/* By Newton's method to where the power before p vanishes along it; is p then the leading one? */
static bool centre_of_order(const struct level *v, const struct source *c, const struct node *a, int p,
                            real x0, real y0, struct germ *out)
{
    real t = (a->lo + a->hi) / 2;
    for (int digits = 1; digits < REAL_BITS; digits = 2 * digits) { /* a step doubles them */
        germ_make(v, c, a, t, x0, y0, out);
        real along = out->x[p - 1] * out->x[p] + out->y[p - 1] * out->y[p];
        real square = out->x[p] * out->x[p] + out->y[p] * out->y[p];
        if (!(square > 0)) {
            return false;
        }
        real next = clamp(t - along / (p * square), a->lo, a->hi);
        if (real_abs(next - t) <= 4 * REAL_EPSILON * (a->hi - a->lo)) {
            break;
        }
        t = next;
    }
    return leading(out) == p;
}

/* Where the derivative is as good as zero, of order p - 1; p, or 0: there is no such place. */
static int centre(const struct level *v, const struct source *c, const struct node *a, real x0, real y0,
                  struct germ *out)
{
    for (int p = 2; p <= ORDER_MAX && p <= c->n; p++) {
        if (centre_of_order(v, c, a, p, x0, y0, out)) {
            return p;
        }
    }
    return 0;
}

/* ---- sums ---- */

/* Of |u . (x, y)_k| r^k for k of from..to, and of the errors. */
static real sum_along(const struct germ *a, real ux, real uy, int from, int to, real r)
{
    real sum = 0, norm = real_abs(ux) + real_abs(uy);
    for (int k = to < a->n ? to : a->n; k >= from; k--) {
        real size = real_abs(ux * a->x[k] + uy * a->y[k]) +
                    norm * (a->error[k] + 2 * REAL_EPSILON * (real_abs(a->x[k]) + real_abs(a->y[k])));
        sum = sum * r + size;
    }
    for (int k = 0; k < from; k++) {
        sum = sum * r;
    }
    return sum;
}

/* Of weights, without the first. */
static real sum_weights(const struct germ *a, real r)
{
    real sum = 0;
    for (int k = a->n; k >= 1; k--) {
        sum = (sum + real_abs(a->w[k]) + a->error_w[k]) * r;
    }
    return sum;
}

static real all_weights(const struct germ *a, real r)
{
    return a->w[0] + a->error_w[0] + sum_weights(a, r);
}

/* |u . (x, y)_k| at least. */
static real least_along(const struct germ *a, real ux, real uy, int k)
{
    real size = real_abs(ux * a->x[k] + uy * a->y[k]), norm = real_abs(ux) + real_abs(uy);
    return size - norm * (a->error[k] + 2 * REAL_EPSILON * (real_abs(a->x[k]) + real_abs(a->y[k])));
}

static real slack(const struct germ *a, const struct germ *b)
{
    return 1 + 8 * (a->n + b->n + 4) * REAL_EPSILON;
}

/* ---- tangents that cross ---- */

/* What bounds |z|^p of all zeros with |z| <= r, |v| <= s: the condition is that it is less than r^p.  Across
 * (ux, uy). */
static real bound_crossed(const struct germ *a, int p, real r, const struct germ *b, real s, real ux, real uy)
{
    real wx = -uy, wy = ux, lead = least_along(a, wx, wy, p);
    real first = b->w[0] - b->error_w[0], last = b->w[0] + b->error_w[0], power = 1;
    for (int k = 0; k < p; k++) {
        power = power * r;
    }
    if (!(lead > 0) || !(first > 0)) {
        return REAL_HUGE;
    }
    real high = sum_along(a, wx, wy, 0, a->n, r);
    real other = sum_along(a, wx, wy, 0, p - 1, r);
    if (p < a->n) {
        other += sum_along(a, wx, wy, p + 1, a->n, r);
    }
    /* the leading coefficient's own error is among the rest */
    other += (real_abs(wx * a->x[p] + wy * a->y[p]) - lead) * power;
    real rest = other * last + high * sum_weights(b, s) + 2 * b->error_w[0] * high +
                sum_along(b, wx, wy, 0, b->n, s) * all_weights(a, r);
    return rest / (lead * first) * slack(a, b);
}

static real root_of(real a, int p)
{
    real guess = 1;
    if (p == 2) {
        return real_sqrt(a) * (1 + 4 * REAL_EPSILON);
    }
    if (p == 4) {
        return real_sqrt(real_sqrt(a)) * (1 + 8 * REAL_EPSILON);
    }
    while (guess * guess * guess > a && guess > REAL_EPSILON) { /* within a factor of 2 is enough */
        guess = guess / 2;
    }
    return 2 * guess;
}

/* At most p q solutions, all within out of the centres; false if that is not proved.  Where one arc is much
 * longer than the other, the conditions may hold together only when it has been cut down. */
static bool crossed(const struct germ *a, int p, const struct germ *b, int q, struct box *out)
{
    real bx = b->x[q], by = b->y[q], ax = a->x[p], ay = a->y[p], r = a->reach, s = b->reach;
    bool counted = false;
    for (int k = 0; k < 128; k++) {
        real next_r = root_of(bound_crossed(a, p, r, b, s, bx, by), p);
        real next_s = root_of(bound_crossed(b, q, s, a, r, ax, ay), q);
        counted |= next_r < r && next_s < s;
        const real less = (real)15 / 16;
        bool same = !(next_r < less * r) && !(next_s < less * s);
        r = real_min(r, next_r);
        s = real_min(s, next_s);
        if (same) {
            break;
        }
    }
    out->r = r;
    out->s = s;
    return counted;
}

/* ---- the pair ---- */

/* What is around the centres, larger (up: 1) or smaller (-1) by rounding. */
static struct zero region_of(const struct germ *a, const struct germ *b, const struct box *box, int up)
{
    real more = 1 + 4 * up * REAL_EPSILON, pad = 2 * up * REAL_EPSILON;
    struct zero x = {a->t, b->t, box->r * more + pad, box->s * more + pad};
    return x;
}

static bool is_within(const struct box *a, real share, real r, real s)
{
    return a->r <= share * r && a->s <= share * s;
}

/* As if the germ were exact. */
static void without_errors(const struct germ *a, struct germ *out)
{
    *out = *a;
    for (int k = 0; k <= a->n; k++) {
        out->error[k] = out->error_w[k] = 0;
    }
}

/* Where little is gained, halves tell more: sharp turns are no cusps.  Unless it is the errors that make the
 * box so large. */
static bool is_worth(const struct germ *a, int p, const struct germ *b, int q, const struct box *box,
                     bool cross)
{
    const real small = (real)1 / 16, less = (real)1 / 2;
    if (is_within(box, small, a->reach, b->reach)) {
        return true;
    }
    struct germ f, g;
    struct common c;
    struct box exact = {REAL_HUGE, REAL_HUGE};
    without_errors(a, &f);
    without_errors(b, &g);
    if (cross) {
        crossed(&f, p, &g, q, &exact);
    } else if (cusps_common(&f, &g, &c)) {
        exact = c.ring[c.rings - 1].core;
    }
    return is_within(&exact, less, box->r, box->s);
}

static enum verdict settle_crossed(struct solver *z, const struct pair *at, const struct germ *a, int p,
                                   const struct germ *b, int q, const struct box *box)
{
    const struct box reach = {a->reach, b->reach};
    struct zero core = region_of(a, b, box, 1), clear = region_of(a, b, &reach, -1);
    if (!is_worth(a, p, b, q, box, true) || region_settle_all(z, at->level, &core, p * q) == OPEN) {
        return OPEN;
    }
    region_solved(z, at->level, &clear);
    return CLOSED;
}

static bool lies_in(const struct node *a, real x, real radius)
{
    return x - radius <= a->lo && a->hi <= x + radius;
}

/* The core has been settled. */
static enum verdict leave_rest(struct solver *z, const struct pair *at, const struct zero *clear)
{
    region_solved(z, at->level, clear);
    return pair_push_around(z, at, clear);
}

/* An outer ring: a closer look at its core if it is small, else what of the pair lies around the ring, and in
 * the core, becomes pairs. */
static enum verdict take_out(struct solver *z, const struct pair *at, const struct zero *clear,
                             const struct zero *core, bool small, int at_most)
{
    if (small && region_look_all(z, at->level, core, at_most) == CLOSED) {
        return leave_rest(z, at, clear);
    }
    return pair_push_around(z, at, clear) == CLOSED ? pair_narrow(z, at, core) : OPEN;
}

/* What lies around the innermost ring is left to other pairs. */
static enum verdict settle_common(struct solver *z, const struct pair *at, const struct germ *a,
                                  const struct germ *b, const struct common *c)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    const struct common_ring *last = &c->ring[c->rings - 1];
    const real small = (real)1 / 16;
    struct zero core, clear;
    for (const struct common_ring *r = c->ring; r <= last; r++) {
        core = region_of(a, b, &r->core, 1);
        clear = region_of(a, b, &r->clear, -1);
        ring_add(z, at->level, &clear, r->at_most > 0 ? &core : NULL, r < last);
        if (r < last && !(lies_in(f, core.t, core.rt) && lies_in(g, core.s, core.rs))) {
            return take_out(z, at, &clear, &core, is_within(&r->core, small, a->reach, b->reach), r->at_most);
        }
    }
    if (last->at_most > 0 && (!is_worth(a, 2, b, 2, &last->core, false) ||
                              region_settle_all(z, at->level, &core, last->at_most) == OPEN)) {
        return OPEN;
    }
    return leave_rest(z, at, &clear);
}

enum verdict cusps_settle(struct solver *z, const struct pair *at)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    struct germ a, b;
    struct box box;
    struct common common;
    struct spot o;
    source_at(&v->f, (f->lo + f->hi) / 2, &o);
    int p = centre(v, &v->f, f, o.x, o.y, &a);
    if (!p) {
        return OPEN;
    }
    source_at(&v->f, a.t, &o);
    p = centre(v, &v->f, f, o.x, o.y, &a);
    int q = centre(v, &v->g, g, o.x, o.y, &b);
    if (!p || !q) {
        return OPEN;
    }
    if (crossed(&a, p, &b, q, &box)) {
        return settle_crossed(z, at, &a, p, &b, q, &box);
    }
    if (p == 2 && q == 2 && cusps_common(&a, &b, &common)) {
        return settle_common(z, at, &a, &b, &common);
    }
    return OPEN;
}
