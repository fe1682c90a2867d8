/* Two arcs that run side by side: the second-order test.
 *
 * As graphs over one direction both have y'' in a known range (graphs.c).  If the ranges are disjoint, extend
 * each graph past its ends with the second derivative it has there.  Then the gap D = y_f - y_g, or its
 * negative, is strictly convex on the whole line: D'' between m and M, m > 0, the distances of the ranges.  A
 * solution in the nodes is a zero of D at an x in common; so there are at most two, with multiplicity.  D has
 * one least value; let x0 be a point of the common range near it (the end of the range if it is beyond) and
 * |D(x0) - d| <= e, |D'(x0) - k| <= e':
 *
 * The ends of the common range are known to 1.5 E <= x_error, and x0 is within 2 x_error and its own noise of
 * an end, so at an end solutions may lie as much as a = 4 x_error past x0.  There |D'| <= |D'(x0)| + M a, and
 * D differs from D(x0) by at most a times that: e and e' are enlarged by so much, and with these e and e'
 * what follows holds for x0 moved to the true end.
 *
 * - D(x) >= D(x0) - (D'(x0))^2 / (2m): if positive, there is no solution.  If x0 is the first end of the
 * range and D'(x0) >= 0, D >= D(x0) on it, likewise at the last.
 * - Solutions satisfy m dx^2 / 2 <= |D'(x0)| |dx| + |D(x0)|-: where D(x0) may be 0 they are all within rho =
 * (K + sqrt(K^2 + 2 m (e + |d|-))) / m of x0, K = |k| + e'.  That part is looked at closely (zoom.c), or is a
 * CLUSTER of two.
 * - D(x0) < 0 surely: D falls before x0's side of its least value and rises after it, so each side has at
 * most one zero. If D < 0 at the end of the common range on that side, there is none.  Else one is sought by
 * Newton's method and proved by cone.c in a rectangle U around it.  D is monotone on the side, and the gap on
 * U is monotone too, as the directions cross; the two overlap, so the gap is monotone on their union and has
 * no zero but this one: the side is settled. */
#include "graphs.h"

struct side {
    struct solver *z;
    int level;
    const struct level *v;
    const struct node *f, *g;
    const struct graphs *h;
    real sign; /* D = sign (y_f - y_g) */
    real m, M;
    real middle; /* a likely D'' */
};

static bool convex(const struct graphs *h, struct side *out)
{
    real above = h->curve_f.lo - h->curve_g.hi, below = h->curve_g.lo - h->curve_f.hi;
    if (!(above > 0) && !(below > 0)) {
        return false;
    }
    out->sign = above > 0 ? 1 : -1;
    out->m = real_max(above, below) * (1 - 4 * REAL_EPSILON);
    out->M = above > 0 ? h->curve_f.hi - h->curve_g.lo : h->curve_g.hi - h->curve_f.lo;
    out->middle = (out->m + out->M) / 2;
    return true;
}

static void look(const struct side *c, real t, real s, struct gap_view *out)
{
    gap_look(c->v, c->h, t, s, out);
    out->gap = c->sign * out->gap;
    out->slope = c->sign * out->slope;
}

/* The view at abscissa x; false if Newton's method does not get there. */
static bool look_at(const struct side *c, real x, struct gap_view *out)
{
    bool there = gap_look_at(c->v, c->f, c->g, c->h, x, out);
    out->gap = c->sign * out->gap;
    out->slope = c->sign * out->slope;
    return there;
}

/* The least gap within the common range; `end`: -1, 1 if it is at its first or last end, else 0. */
static bool look_at_least(const struct side *c, struct gap_view *out, int *end)
{
    const struct interval *range = &c->h->x;
    real t, s, second = c->middle, x = (range->lo + range->hi) / 2;
    gap_start(c->f, c->g, c->h, x, &t, &s);
    look(c, t, s, out);
    for (int k = 0; k < 12; k++) {
        real next = out->x - out->slope / second;
        *end = next <= range->lo ? -1 : next >= range->hi ? 1 : 0;
        next = clamp(next, range->lo, range->hi);
        bool there = *end ? real_abs(next - out->x) <= 2 * c->h->x_error
                          : out->slope * out->slope <= c->m * out->noise;
        if (there && gap_is_level(c->h, out)) {
            return true;
        }
        struct gap_view last = *out;
        gap_step(c->f, c->g, next, out, &t, &s);
        look(c, t, s, out);
        real secant = (out->slope - last.slope) / (out->x - last.x);
        second = secant > c->m && secant < c->M ? secant : c->middle;
    }
    return false;
}

static enum verdict settle_region(const struct side *c, const struct gap_view *at, real radius)
{
    real pad = 2 * at->noise + real_abs(at->hx);
    struct zero region;
    region.t = at->t;
    region.s = at->s;
    region.rt = (radius + pad) / c->h->run_f.lo + 2 * REAL_EPSILON;
    region.rs = (radius + pad) / c->h->run_g.lo + 2 * REAL_EPSILON;
    const real small = (real)1 / 4;
    if (region.rt > small * (c->f->hi - c->f->lo) || region.rs > small * (c->g->hi - c->g->lo)) {
        return OPEN; /* half the arcs may do better */
    }
    const real wide = (real)1 / 64;
    bool whole = c->level > 0 && c->f->hi - c->f->lo == 1 && c->g->hi - c->g->lo == 1;
    if (whole && c->v->f.low && c->v->g.low && real_max(region.rt, region.rs) > wide) {
        return OPEN; /* there are more digits to be had (cluster_fine.c) */
    }
    return region_settle(c->z, c->level, c->f, c->g, &region, 2, false);
}

/* The zero on one side of `from`, by Newton's method; false if it leaves the nodes or loses its way. */
static bool descend(const struct side *c, const struct gap_view *from, int direction, struct gap_view *now)
{
    /* d + k dx + D'' dx^2 / 2 = 0 */
    real slope = direction * from->slope, depth = real_max(-from->gap, (real)0), x_end, t, s;
    real root = real_sqrt(slope * slope + 2 * c->middle * depth);
    real dx = slope > 0 ? 2 * depth / (slope + root) : (root - slope) / c->middle;
    x_end = direction < 0 ? -c->h->x.lo : c->h->x.hi;
    *now = *from;
    for (int k = 0; k < 8; k++) {
        real x = direction * now->x + dx, beyond = x - x_end;
        if (beyond > c->h->x_error && beyond > dx / 2) {
            return false;
        }
        gap_step(c->f, c->g, direction * x, now, &t, &s);
        look(c, t, s, now);
        real rate = direction * now->slope;
        if (!(rate > 0)) {
            return false;
        }
        dx = -now->gap / rate;
        if (real_abs(now->gap) <= 64 * now->gap_error && gap_is_level(c->h, now)) {
            return true;
        }
    }
    return false;
}

/* The view holds for an end of the common range, which may be elsewhere by 4 x_error. */
static void widen(const struct side *c, struct gap_view *at)
{
    const real away = 4 * c->h->x_error;
    at->slope_error += c->M * away;
    at->gap_error += away * (real_abs(at->slope) + at->slope_error);
}

/* One side of `at` (-1: smaller x), where D is monotone. */
static enum verdict settle_side(const struct side *c, const struct gap_view *at, int direction)
{
    struct gap_view now;
    if (descend(c, at, direction, &now)) {
        /* the directions cross where x is nearer to the zero than slope / curvatures */
        real reach = (real)0.25 * real_abs(now.slope) / real_max(c->h->bend, c->M);
        struct zero guess = {now.t, now.s, 0, 0}, found;
        real wt = real_min(reach / c->h->run_f.hi, c->f->hi - c->f->lo);
        real ws = real_min(reach / c->h->run_g.hi, c->g->hi - c->g->lo);
        if (zero_prove(c->z, c->level, &guess, wt, ws, &found) == ZERO) {
            return CLOSED;
        }
    }
    if (!look_at(c, direction < 0 ? c->h->x.lo : c->h->x.hi, &now)) {
        return OPEN;
    }
    widen(c, &now);
    return now.gap < -now.gap_error ? CLOSED : OPEN;
}

enum verdict contact_settle(struct solver *z, int level, const struct node *f, const struct node *g,
                            const struct graphs *h)
{
    struct side c = {z, level, &z->level[level], f, g, h, 1, 0, 0, 0};
    struct gap_view at;
    int end;
    if (!convex(h, &c) || !look_at_least(&c, &at, &end)) {
        return OPEN;
    }
    if (end) {
        widen(&c, &at);
    }
    /* at an end: how much D may fall into the range; else, to its least value */
    real steep = (end ? real_max(end * at.slope, (real)0) : real_abs(at.slope)) + at.slope_error;
    if (end && end * at.slope < -at.slope_error) {
        steep = 0;
    }
    real least = at.gap - at.gap_error - steep * steep / (2 * c.m);
    if (least > 0) {
        return CLOSED;
    }
    const int many = 64;
    if (at.gap > -many * at.gap_error && (!end || steep > 0)) {
        real sum = real_abs(at.slope) + at.slope_error, depth = at.gap_error + real_max(-at.gap, (real)0);
        return settle_region(&c, &at, (sum + real_sqrt(sum * sum + 2 * c.m * depth)) / c.m);
    }
    enum verdict before = end < 0 ? CLOSED : settle_side(&c, &at, -1);
    enum verdict after = end > 0 ? CLOSED : settle_side(&c, &at, 1);
    return before == CLOSED && after == CLOSED ? CLOSED : OPEN;
}
