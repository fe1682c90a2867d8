/* Cusps that meet cusps, and doubled ends that touch: how many solutions there are at most, by Rouche's
 * theorem.
 *
 * Where a derivative vanishes on both curves neither is a graph (graphs.c, gap_model.c).  Let the nodes' own
 * parameters be t0 + z and s0 + v, and their homogeneous coordinates, less a common point, P(z) with weight
 * A(z), Q(v) with weight B(v).  Solutions are the zeros of
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
 * Tangents in common.  p = q = 2, along the tangent H begins with a z^2 - c v^2, across it with b z^3 - d
 * v^3. Scale v so that |c| = |a|.  On the border of the polydisc |z|, |v| <= r let the first component differ
 * from the terms named by at most e1 |a| r^2, e1 <= 1/2, the second by e2 r^3.  If the first vanishes
 * somewhere on the way from those terms to H, then v^2 / z^2 (or, where |v| = r, its inverse) is a / c (1 +
 * x), |x| <= e1, and its power 3/2 differs from (a / c)^(3/2) by at most 2 e1.  There the terms of the second
 * are at least M - 2 e1 max(|b|, |d|), M = ||b| - |d|| if a c > 0, else sqrt(b^2 + d^2); so if that is more
 * than e2, the homotopy has no zero on the border.  The pair a z^2 - c v^2, b z^3 - d v^3 has one of
 * multiplicity 6: at most 6.  Where this is so for all r of an interval, no solution has max(|z|, |v|) in it.
 *
 * Rounding.  P_k = C(n, k) times k-th differences, by de Casteljau's algorithm at t0: control points err by 2
 * E each after the subtraction, so the difference by 2^k of that, and 2 n eps of itself by the algorithm.
 * Sums of terms that are not negative err relatively by less than 4 (n + m) eps. */
#include "graphs.h"

enum { ORDER_MAX = 4, TERMS = DEGREE_MAX + 1 };

/* Homogeneous coordinates at a parameter of a node, as powers; error: of x and y, and of w. */
struct germ {
    int n;
    real t, reach; /* own parameter; how far the node's ends are from it */
    real x[TERMS], y[TERMS], w[TERMS], error[TERMS], error_w[TERMS];
};

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

static void germ_make(const struct source *c, const struct node *a, real t, real x0, real y0,
                      struct germ *out)
{
    const real *x = a->points, *y = x + c->n + 1, *w = y + c->n + 1;
    real px[TERMS], py[TERMS], ones[TERMS], spare[TERMS], most = 1;
    for (int i = 0; i <= c->n; i++) {
        ones[i] = c->rational ? w[i] : (real)1;
        px[i] = x[i] - x0 * ones[i];
        py[i] = y[i] - y0 * ones[i];
        most = real_max(most, ones[i]);
    }
    out->n = c->n;
    out->t = t;
    out->reach = real_max(t, 1 - t) * (1 + REAL_EPSILON);
    component_powers(c->n, px, t, 2 * c->node_error * most, out->x, spare);
    component_powers(c->n, py, t, 2 * c->node_error * most, out->y, out->error);
    component_powers(c->n, ones, t, c->rational ? c->node_error * most : (real)0, out->w, out->error_w);
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
static bool centre_of_order(const struct source *c, const struct node *a, int p, real x0, real y0,
                            struct germ *out)
{
    real t = (real)0.5;
    for (int digits = 1; digits < REAL_BITS; digits = 2 * digits) { /* a step doubles them */
        germ_make(c, a, t, x0, y0, out);
        real along = out->x[p - 1] * out->x[p] + out->y[p - 1] * out->y[p];
        real square = out->x[p] * out->x[p] + out->y[p] * out->y[p];
        if (!(square > 0)) {
            return false;
        }
        real next = clamp(t - along / (p * square), 0, 1);
        if (real_abs(next - t) <= 4 * REAL_EPSILON) {
            break;
        }
        t = next;
    }
    return leading(out) == p;
}

/* Where the derivative is as good as zero, of order p - 1; p, or 0: there is no such place. */
static int centre(const struct source *c, const struct node *a, real x0, real y0, struct germ *out)
{
    for (int p = 2; p <= ORDER_MAX && p <= c->n; p++) {
        if (centre_of_order(c, a, p, x0, y0, out)) {
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

struct box {
    real r, s;
};

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

/* ---- tangents in common ---- */

/* Sum of |u . P_k| r^(k - lead): terms below `lead` at the least r, those above at the largest. */
static real sum_off(const struct germ *a, real ux, real uy, int lead, real lo, real hi)
{
    real below = 0, above = 0;
    if (lead > 0) {
        below = sum_along(a, ux, uy, 0, lead - 1, lo);
        for (int k = 0; k < lead; k++) {
            below = below / lo;
        }
    }
    if (lead < a->n) {
        above = sum_along(a, ux, uy, lead + 1, a->n, hi);
        for (int k = 0; k < lead; k++) {
            above = above / hi;
        }
    }
    return below + above;
}

/* P B less P_lead B_0 r^lead, over r^lead. */
static real rest_of(const struct germ *a, const struct germ *b, real ux, real uy, int lead, real lo, real hi)
{
    real off = sum_off(a, ux, uy, lead, lo, hi), spread = sum_weights(b, hi) + b->error_w[0];
    real main = real_abs(ux * a->x[lead] + uy * a->y[lead]), least = least_along(a, ux, uy, lead);
    return ((off + (main - least)) * (b->w[0] + spread) + main * spread) * slack(a, b);
}

/* Is there no solution with lo <= max(|z|, |v|) <= hi, and at most 6 within? Own parameters are scaled. */
static bool ring_is_free(const struct germ *f, const struct germ *g, real lo, real hi)
{
    real ex = f->x[2], ey = f->y[2], length = real_sqrt(ex * ex + ey * ey);
    ex = ex / length;
    ey = ey / length;
    if (f->n < 3 && g->n < 3) {
        return false;
    }
    real a = (ex * f->x[2] + ey * f->y[2]) * g->w[0], c = (ex * g->x[2] + ey * g->y[2]) * f->w[0];
    real b = f->n < 3 ? (real)0 : (ex * f->y[3] - ey * f->x[3]) * g->w[0];
    real d = g->n < 3 ? (real)0 : (ex * g->y[3] - ey * g->x[3]) * f->w[0];
    real off = real_abs(real_abs(a) - real_abs(c)); /* of the scaling */
    real size = real_abs(a) - 8 * REAL_EPSILON * real_abs(a);
    real e1 = (rest_of(f, g, ex, ey, 2, lo, hi) + rest_of(g, f, ex, ey, 2, lo, hi) + off) / size +
              16 * REAL_EPSILON;
    int lead_f = f->n < 3 ? f->n : 3, lead_g = g->n < 3 ? g->n : 3;
    real across = 0;
    across += lead_f == 3 ? rest_of(f, g, -ey, ex, 3, lo, hi)
                          : sum_along(f, -ey, ex, 0, f->n, lo) / (lo * lo * lo) * all_weights(g, hi);
    across += lead_g == 3 ? rest_of(g, f, -ey, ex, 3, lo, hi)
                          : sum_along(g, -ey, ex, 0, g->n, lo) / (lo * lo * lo) * all_weights(f, hi);
    b = real_abs(b);
    d = real_abs(d);
    real least = a * c > 0 ? real_abs(b - d) : real_sqrt(b * b + d * d), more = 16 * REAL_EPSILON * (b + d);
    return e1 <= (real)0.5 && least - 2 * e1 * real_max(b, d) - more > across * (1 + 16 * REAL_EPSILON);
}

static void rescale(struct germ *a, real by)
{
    real power = 1;
    for (int k = 0; k <= a->n; k++) {
        real *part[5] = {&a->x[k], &a->y[k], &a->w[k], &a->error[k], &a->error_w[k]};
        for (int i = 0; i < 5; i++) {
            *part[i] = *part[i] * power;
        }
        a->error[k] += 2 * (k + 2) * REAL_EPSILON * (real_abs(a->x[k]) + real_abs(a->y[k]));
        a->error_w[k] += 2 * (k + 2) * REAL_EPSILON * real_abs(a->w[k]);
        power = power * by;
    }
    a->reach = a->reach / by * (1 + 4 * REAL_EPSILON);
}

/* At most 6 solutions, all within out of the centres. */
static bool common(const struct germ *f, const struct germ *g, struct box *out)
{
    struct germ b = *g;
    real ex = f->x[2], ey = f->y[2];
    real a = (ex * f->x[2] + ey * f->y[2]) * g->w[0], c = (ex * g->x[2] + ey * g->y[2]) * f->w[0];
    if (!(real_abs(c) > 0)) {
        return false;
    }
    real by = real_sqrt(real_abs(a / c)), r;
    rescale(&b, by);
    r = real_max(f->reach, b.reach);
    bool any = false;
    for (int k = 0; k < REAL_BITS && ring_is_free(f, &b, r / 2, r); k++) {
        r = r / 2;
        any = true;
    }
    out->r = real_min(r, f->reach);
    out->s = real_min(r * by * (1 + 4 * REAL_EPSILON), g->reach);
    return any;
}

/* ---- the pair ---- */

static enum verdict settle_box(struct solver *z, const struct pair *at, const struct germ *a,
                               const struct germ *b, const struct box *box, int at_most)
{
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    real wide = f->hi - f->lo, high = g->hi - g->lo;
    const real small = (real)1 / 16;
    if (!(box->r <= small * a->reach && box->s <= small * b->reach)) {
        return OPEN; /* sharp turns rather than cusps: halves tell more */
    }
    struct zero x = {f->lo + wide * a->t, g->lo + high * b->t,
                     wide * box->r * (1 + 4 * REAL_EPSILON) + 2 * REAL_EPSILON,
                     high * box->s * (1 + 4 * REAL_EPSILON) + 2 * REAL_EPSILON};
    return region_settle(z, at->level, f, g, &x, at_most, false);
}

enum verdict cusps_settle(struct solver *z, const struct pair *at)
{
    const struct level *v = &z->level[at->level];
    const struct node *f = &z->f.node[at->f], *g = &z->g.node[at->g];
    struct germ a, b;
    struct box box;
    struct spot o;
    source_at(&v->f, (f->lo + f->hi) / 2, &o);
    int p = centre(&v->f, f, o.x, o.y, &a);
    if (!p) {
        return OPEN;
    }
    source_at(&v->f, f->lo + (f->hi - f->lo) * a.t, &o);
    p = centre(&v->f, f, o.x, o.y, &a);
    int q = centre(&v->g, g, o.x, o.y, &b);
    if (!p || !q) {
        return OPEN;
    }
    if (crossed(&a, p, &b, q, &box)) {
        return settle_box(z, at, &a, &b, &box, p * q);
    }
    if (p == 2 && q == 2 && common(&a, &b, &box)) {
        return settle_box(z, at, &a, &b, &box, 6);
    }
    return OPEN;
}
