/* Questions about a point: is it inside, how far from the boundary, which allowed point is nearest. */
#include "arcs.h"
#include "boundary.h"
#include "family.h"
#include "pieces.h"
#include "planes.h"

#include "../core/bernstein.h"

enum { STACK = 2 * (REAL_BITS + 8), HALVINGS = 12 };

/* ---- inside? ---- */

/* h and its least reach: a point is inside by `margin` where h > margin |(A, B)|, and |(A, B)| is below the
 * form whose coefficients are those of the control points. */
struct heights {
    int l;
    real margin;
    real c[4 * FORM_MAX]; /* h, A, B, bound */
};

/* 1: all coefficients say inside; -1: an end is outside; 0: else. */
static int look(const struct heights *s, const real *c, bool *near)
{
    const real *h = c, *A = h + s->l + 1, *B = A + s->l + 1, *bound = B + s->l + 1;
    bool inside = true;
    for (int i = 0; i <= s->l; i++) {
        real reach = s->margin > 0 ? s->margin * real_sqrt(A[i] * A[i] + B[i] * B[i]) : (real)0;
        real left = h[i] - reach;
        inside = inside && left > bound[i];
        if ((i == 0 || i == s->l) && left < -bound[i]) {
            return -1;
        }
        *near = *near || ((i == 0 || i == s->l) && left <= bound[i]);
    }
    return inside ? 1 : 0;
}

static enum side test_form(struct region_work *k, const struct heights *s)
{
    real cut[4 * FORM_MAX], stack[STACK];
    bool near = false;
    int waiting = 0, seen = look(s, s->c, &near);
    if (seen != 0 || near) {
        return seen > 0 ? SIDE_INSIDE : seen < 0 ? SIDE_OUTSIDE : SIDE_BOUNDARY;
    }
    stack[waiting++] = 0;
    stack[waiting++] = 1;
    while (waiting > 0) {
        real hi = stack[--waiting], lo = stack[--waiting], middle = lo + (hi - lo) / 2;
        if (k->steps++ >= k->max_steps || waiting + 4 > STACK || middle <= lo || middle >= hi) {
            return SIDE_BOUNDARY;
        }
        const real ends[3] = {lo, middle, hi};
        for (int half = 1; half >= 0; half--) {
            bernstein_restrict(s->l, 4, s->c, ends[half], ends[half + 1], cut);
            seen = look(s, cut, &near);
            if (seen < 0) {
                return SIDE_OUTSIDE;
            }
            if (seen == 0) {
                stack[waiting++] = ends[half];
                stack[waiting++] = ends[half + 1];
            }
        }
        if (near) {
            return SIDE_BOUNDARY;
        }
    }
    return SIDE_INSIDE;
}

/* Most points are settled by a few halvings with one bound for all coefficients; SIDE_BOUNDARY: not this one.
 */
static enum side test_quickly(const struct span *span, const real *v)
{
    real h[HALVINGS + 1][FORM_MAX], bound = 2 * span->error;
    int l = span->form.l, length = l + 1, top = 0, halvings = 0;
    const real *A = span->form.L, *B = A + length, *C = B + length;
    for (int i = 0; i <= l; i++) {
        h[0][i] = A[i] * v[0] + B[i] * v[1] + C[i] * v[2];
    }
    while (top >= 0) {
        const real *c = h[top];
        real least = c[0];
        for (int i = 1; i <= l; i++) {
            least = real_min(least, c[i]);
        }
        if (least > bound) {
            top--;
            continue;
        }
        if (c[0] < -bound || c[l] < -bound) {
            return SIDE_OUTSIDE;
        }
        if (c[0] <= bound || c[l] <= bound || halvings++ == HALVINGS) {
            return SIDE_BOUNDARY;
        }
        real cell[FORM_MAX];
        for (int i = 0; i <= l; i++) {
            cell[i] = c[i];
        }
        bernstein_halve(l, 1, cell, h[top], h[top + 1]);
        top++;
    }
    return SIDE_INSIDE;
}

static enum side test_span(struct region_work *k, const struct span *span, const real *v, real margin)
{
    struct heights s;
    int l = span->form.l, length = l + 1;
    const real *A = span->form.L, *B = A + length, *C = B + length, *E = C + length;
    s.l = l;
    s.margin = margin;
    for (int i = 0; i <= l; i++) {
        s.c[i] = A[i] * v[0] + B[i] * v[1] + C[i] * v[2];
        s.c[3 * length + i] = 2 * REAL_EPSILON * E[i];
    }
    for (int i = 0; margin > 0 && i < 2 * length; i++) {
        s.c[length + i] = A[i];
    }
    for (int i = 0; !(margin > 0) && i < 2 * length; i++) {
        s.c[length + i] = 0;
    }
    return test_form(k, &s);
}

enum side region_contains(const struct region_problem *p, struct region_workspace *w, struct point d,
                          real margin)
{
    struct region_work *k = w->work;
    enum side side = k->singular ? SIDE_OUTSIDE : SIDE_INSIDE;
    real v[3];
    (void)p;
    k->steps = 0;
    family_point_in(k, d, v);
    real reach = margin / k->scale * v[2]; /* v is the point times v[2] */
    for (int i = 0; i < k->spans && side != SIDE_OUTSIDE; i++) {
        enum side one = reach > 0 ? SIDE_BOUNDARY : test_quickly(&k->span[i], v);
        one = one == SIDE_BOUNDARY ? test_span(k, &k->span[i], v, reach) : one;
        side = one < side ? one : side;
    }
    for (int i = 0; i < k->chords && side != SIDE_OUTSIDE; i++) {
        const struct half_plane *c = &k->chord[i];
        real bound = c->error + 4 * REAL_EPSILON;
        real left = c->l[0] * v[0] + c->l[1] * v[1] + c->l[2] * v[2] -
                    reach * real_sqrt(c->l[0] * c->l[0] + c->l[1] * c->l[1]);
        side = left < -bound ? SIDE_OUTSIDE : left <= bound ? SIDE_BOUNDARY : side;
    }
    return side;
}

/* ---- how far? ---- */

static struct point point_in(const struct region_work *k, struct point d)
{
    struct point p = {(d.x - k->centre_x) / k->scale, (d.y - k->centre_y) / k->scale};
    return p;
}

/* An edge in normalised coordinates and the parameter of its span. */
static struct region_edge edge_in(const struct region_work *k, const struct region_edge *e)
{
    const struct span *s = &k->span[e->span];
    struct region_edge in = *e;
    in.t = (e->t - s->lo) / (s->hi - s->lo);
    in.t1 = (e->t1 - s->lo) / (s->hi - s->lo);
    in.from = e->from_infinity ? e->from : point_in(k, e->from);
    in.to = e->to_infinity ? e->to : point_in(k, e->to);
    in.line[2] = (e->line[2] + e->line[0] * k->centre_x + e->line[1] * k->centre_y) / k->scale;
    return in;
}

static real square(struct point a, struct point b)
{
    real x = a.x - b.x, y = a.y - b.y;
    return x * x + y * y;
}

/* Nearest point of a segment, ray or line. */
static struct point nearest_on_line(const struct region_edge *e, struct point d)
{
    real height = e->line[0] * d.x + e->line[1] * d.y + e->line[2];
    struct point foot = {d.x - height * e->line[0], d.y - height * e->line[1]};
    real x = e->line[1], y = -e->line[0]; /* the way from `from` to `to` */
    if (!e->from_infinity && (foot.x - e->from.x) * x + (foot.y - e->from.y) * y < 0) {
        return e->from;
    }
    if (!e->to_infinity && (foot.x - e->to.x) * x + (foot.y - e->to.y) * y > 0) {
        return e->to;
    }
    return foot;
}

static struct point nearest_on_arc(struct region_work *k, const struct region_edge *e, struct point d)
{
    struct envelope a;
    real t[FORM_MAX], v[3];
    struct point best = e->from_infinity ? e->to : e->from;
    bool any = !e->from_infinity || !e->to_infinity;
    if (!e->to_infinity && square(d, e->to) < square(d, best)) {
        best = e->to;
    }
    envelope_make(k, e, &a);
    int count = envelope_feet(k, e, &a, d, t);
    for (int i = 0; i < count; i++) {
        envelope_at(k, e->span, t[i], v);
        struct point p = {v[0] / v[2], v[1] / v[2]};
        if (!any || square(d, p) < square(d, best)) {
            best = p;
            any = true;
        }
    }
    return best;
}

static struct point nearest_on_boundary(struct region_work *k, const struct region *r, struct point d)
{
    struct point best = d;
    for (int i = 0; i < r->count; i++) {
        struct region_edge e = edge_in(k, &r->edge[i]);
        struct point p = e.type == EDGE_ARC ? nearest_on_arc(k, &e, d) : nearest_on_line(&e, d);
        if (i == 0 || square(d, p) < square(d, best)) {
            best = p;
        }
    }
    return best;
}

real region_distance(const struct region_problem *p, struct region_workspace *w, const struct region *r,
                     struct point d)
{
    struct region_work *k = w->work;
    if (r->kind == REGION_EMPTY || r->kind == REGION_PLANE) {
        return r->kind == REGION_EMPTY ? -REAL_HUGE : REAL_HUGE;
    }
    struct point at = point_in(k, d);
    real distance = k->scale * real_sqrt(square(at, nearest_on_boundary(k, r, at)));
    return region_contains(p, w, d, 0) != SIDE_OUTSIDE ? distance : -distance;
}

struct point region_nearest(const struct region_problem *p, struct region_workspace *w,
                            const struct region *r, struct point d)
{
    struct region_work *k = w->work;
    struct point at = point_in(k, d);
    if (r->kind == REGION_EMPTY || r->kind == REGION_PLANE || region_contains(p, w, d, 0) != SIDE_OUTSIDE) {
        return d;
    }
    struct point n = nearest_on_boundary(k, r, at);
    struct point out = {k->centre_x + k->scale * n.x, k->centre_y + k->scale * n.y};
    return out;
}
