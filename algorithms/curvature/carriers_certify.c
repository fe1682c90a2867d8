/* The certificate: vertices and arcs fulfil all conditions.
 *
 * An arc is convex where w3 and M keep their signs and its normals stay within a half turn; then it fulfils
 * the conditions of its own tangents, and lies in the triangle of its ends and the point where their tangents
 * meet.  Triangles are halved until their corners fulfil the other conditions.  Towards infinity, where
 * tangents are almost one line and meet nowhere in particular, the arc's control points take their place:
 * conditions are linear, and the arc's points are positive combinations of them. */
#include "carriers.h"
#include "form.h"
#include "planes.h"

#include "../core/bernstein.h"

enum { TRIANGLES = 400, STACK = 64 };

/* A form does not change its sign on [lo, hi], to rounding. */
static bool keeps_sign(struct region_work *k, int n, const real *c, const real *bound, real lo, real hi)
{
    real cut[FORM_MAX], cut_bound[FORM_MAX], middle, where;
    if (n < 0) {
        return false;
    }
    bernstein_restrict(n, 1, c, lo, hi, cut);
    bernstein_restrict(n, 1, bound, lo, hi, cut_bound);
    form_values(n, 1, k->pascal, cut, (real)1 / 2, &middle);
    for (int i = 0; middle < 0 && i <= n; i++) {
        cut[i] = -cut[i];
    }
    return form_holds(k, n, cut, cut_bound, &where) == HOLDS;
}

static bool is_convex(struct region_work *k, const struct carrier_arc *a)
{
    const struct span_forms *f = &k->span[k->piece[a->piece].span].form;
    struct half_plane from, to;
    real g[FORM_MAX], bound[FORM_MAX];
    for (int i = 0; i <= f->e; i++) {
        bound[i] = 16 * k->degree * REAL_EPSILON;
    }
    if (!keeps_sign(k, f->e, f->w + 2 * (f->e + 1), bound, a->from.t, a->to.t) ||
        !keeps_sign(k, f->m, f->M, f->M + f->m + 1, a->from.t, a->to.t) ||
        !half_plane_at(k, k->piece[a->piece].span, a->from.t, false, &from) ||
        !half_plane_at(k, k->piece[a->piece].span, a->to.t, false, &to)) {
        return false;
    }
    real x = from.l[0] + to.l[0], y = from.l[1] + to.l[1];
    for (int i = 0; i <= f->l; i++) {
        g[i] = f->L[i] * x + f->L[f->l + 1 + i] * y;
        bound[i] = 4 * REAL_EPSILON * f->L[3 * (f->l + 1) + i];
    }
    return keeps_sign(k, f->l, g, bound, a->from.t, a->to.t);
}

static bool holds_at(struct region_work *k, const struct piece *except, const real *v, real error)
{
    struct half_plane worst;
    return planes_hold(k, except, NULL, v, error, &worst) == HOLDS;
}

/* All control points of the arc over [lo, hi], as vectors with the sign that the arc has in its middle. */
static bool hull_holds(struct region_work *k, const struct piece *p, real lo, real hi)
{
    const struct span_forms *f = &k->span[p->span].form;
    const real noise = 16 * k->degree * REAL_EPSILON; /* of coefficients of size below 4 */
    real w[3 * FORM_MAX], middle;
    int length = f->e + 1;
    bernstein_restrict(f->e, 3, f->w, lo, hi, w);
    form_values(f->e, 1, k->pascal, w + 2 * length, (real)1 / 2, &middle);
    for (int i = 0; i < length; i++) {
        real v[3];
        for (int c = 0; c < 3; c++) {
            v[c] = middle < 0 ? -w[c * length + i] : w[c * length + i];
        }
        real size = triple_normalise(v);
        if (!(size > noise) || !holds_at(k, p, v, noise / size)) {
            return false;
        }
    }
    return true;
}

/* Where the tangents at both ends meet. */
static bool apex_holds(struct region_work *k, const struct piece *p, real lo, real hi)
{
    struct half_plane from, to;
    real v[3], error;
    if (!half_plane_at(k, p->span, lo, false, &from) || !half_plane_at(k, p->span, hi, false, &to)) {
        return false;
    }
    const struct half_plane *first = k->sign > 0 ? &from : &to, *second = k->sign > 0 ? &to : &from;
    triple_meet(first->l, first->error, second->l, second->error, v, &error); /* counter-clockwise: Z >= 0 */
    return error < real_ldexp(1, -REAL_BITS / 4) ? holds_at(k, p, v, error) : hull_holds(k, p, lo, hi);
}

static bool arc_holds(struct region_work *k, const struct carrier_arc *a)
{
    const struct piece *p = &k->piece[a->piece];
    real stack[STACK], v[3];
    int waiting = 0;
    stack[waiting++] = a->from.t;
    stack[waiting++] = a->to.t;
    for (int triangles = 0; waiting > 0; triangles++) {
        real hi = stack[--waiting], lo = stack[--waiting], middle = lo + (hi - lo) / 2;
        if (apex_holds(k, p, lo, hi)) {
            continue;
        }
        envelope_at(k, p->span, middle, v);
        if (triangles >= TRIANGLES || waiting + 4 > STACK || !holds_at(k, p, v, 8 * REAL_EPSILON)) {
            return false;
        }
        stack[waiting++] = lo;
        stack[waiting++] = middle;
        stack[waiting++] = middle;
        stack[waiting++] = hi;
    }
    return true;
}

static bool is_end_of(const struct region_work *k, const struct carrier_arc *a, const real *v)
{
    real end[3], c[3], close = real_ldexp(1, -REAL_BITS / 2);
    for (int i = 0; i < 2; i++) {
        envelope_at(k, k->piece[a->piece].span, i ? a->to.t : a->from.t, end);
        triple_cross(v, end, c);
        if (triple_dot(c, c) <= close * close) {
            return true;
        }
    }
    return false;
}

/* An end of an edge: a point, or a direction.  It lies on the convex arcs that end there, and so fulfils
 * their own conditions. */
static bool end_holds(struct region_work *k, const struct carrier_arcs *visible, struct point p,
                      bool infinite)
{
    real v[3] = {p.x, p.y, infinite ? (real)0 : (real)1};
    struct half_plane worst;
    const struct piece *own[2] = {NULL, NULL};
    int arcs = 0;
    triple_normalise(v);
    for (int i = 0; i < visible->count && arcs < 2; i++) {
        if (is_end_of(k, &visible->at[i], v)) {
            own[arcs++] = &k->piece[visible->at[i].piece];
        }
    }
    return planes_hold(k, own[0], own[1], v, 64 * REAL_EPSILON, &worst) == HOLDS;
}

/* The tangent at the start of an edge is known well enough for its conditions to mean something. */
static bool is_sharp(const struct region_work *k, const struct region_edge *e)
{
    struct half_plane plane;
    return half_plane_at(k, e->span, e->t, false, &plane) && plane.error < real_ldexp(1, -REAL_BITS * 3 / 8);
}

bool carriers_certify(struct region_work *k, const struct carrier_arcs *visible, const struct region *r)
{
    for (int i = 0; i < visible->count; i++) {
        if (!is_convex(k, &visible->at[i]) || !arc_holds(k, &visible->at[i])) {
            return false;
        }
    }
    for (int i = 0; i < r->count; i++) {
        const struct region_edge *e = &r->edge[i];
        if (!is_sharp(k, e) || !end_holds(k, visible, e->to, e->to_infinity) ||
            (e->from_infinity && !end_holds(k, visible, e->from, true))) {
            return false;
        }
    }
    return true;
}
