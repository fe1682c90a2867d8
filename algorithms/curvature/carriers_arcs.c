/* Arcs of the envelope inside a convex polygon, cut by its edges. */
#include "carriers.h"
#include "form.h"
#include "planes.h"

#include "../core/bernstein.h"

enum { CUTS = 256 };

bool pieces_are_near(const struct piece *a, const struct piece *b)
{
    int turn = a->quarter - b->quarter;
    return a->type > 0 && b->type > 0 && a->chain == b->chain && turn >= -1 && turn <= 1;
}

static bool is_same_plane(const struct half_plane *a, const struct half_plane *b)
{
    real c[3], close = real_ldexp(1, -REAL_BITS / 2);
    triple_cross(a->l, b->l, c);
    return triple_dot(a->l, b->l) > 0 && triple_dot(c, c) <= close * close;
}

/* Also where it is the tangent of a neighbour at the knot between them. */
bool plane_is_own(const struct region_work *k, const struct half_plane *p, const struct piece *own, real *t)
{
    struct half_plane end;
    if (p->source != MEMBER) {
        return false;
    }
    if (p->span == own->span) {
        *t = p->t;
        return p->t >= own->lo && p->t <= own->hi;
    }
    bool after = p->span + 1 == own->span && own->lo == 0, before = p->span == own->span + 1 && own->hi == 1;
    *t = after ? (real)0 : (real)1;
    return (after || before) && half_plane_at(k, own->span, *t, true, &end) && is_same_plane(&end, p);
}

/* A convex arc lies on the right side of its own tangents, and of those of its smooth neighbours. */
static bool never_cuts(const struct region_work *k, const struct half_plane *p, const struct piece *own)
{
    real t;
    if (p->source == AT_INFINITY || plane_is_own(k, p, own, &t)) {
        return true;
    }
    for (int i = 0; p->source == MEMBER && i < k->pieces; i++) {
        const struct piece *home = &k->piece[i];
        if (home->span == p->span && p->t >= home->lo && p->t <= home->hi && pieces_are_near(home, own)) {
            return true;
        }
    }
    return false;
}

static void add_mark(struct mark *mark, int *count, real t, enum mark_kind kind, int edge)
{
    int at = (*count)++;
    for (; at > 0 && mark[at - 1].t > t; at--) {
        mark[at] = mark[at - 1];
    }
    mark[at].t = t;
    mark[at].kind = kind;
    mark[at].edge = edge;
}

/* Marks where the piece crosses edge number `edge`; false: it lies outside altogether. */
static bool cut_by_edge(struct region_work *k, const struct piece *p, int sign, int edge, struct mark *mark,
                        int *count)
{
    const struct half_plane *plane = &k->cone.edge[edge].plane;
    real g[DEGREE_MAX + 1], error[DEGREE_MAX + 1], root[DEGREE_MAX + 1];
    int e = k->span[p->span].form.e;
    bool some = false;
    for (int i = 0; i <= e; i++) {
        real x = p->w[i], y = p->w[e + 1 + i], z = p->w[2 * (e + 1) + i];
        g[i] = sign * (plane->l[0] * x + plane->l[1] * y + plane->l[2] * z);
        error[i] = (4 * REAL_EPSILON + plane->error) * (real_abs(x) + real_abs(y) + real_abs(z));
        some = some || g[i] > 0;
    }
    int roots = some ? form_crossings(k, e, g, error, DEGREE_MAX, root) : 0;
    for (int i = 0; i < roots && *count < CUTS - 1; i++) {
        add_mark(mark, count, p->lo + root[i] * (p->hi - p->lo), MARK_EDGE, edge);
    }
    return some;
}

/* The point at t, within rounding inside the cone. */
static bool is_inside(const struct region_work *k, const struct piece *p, real t)
{
    real v[3];
    envelope_at(k, p->span, t, v);
    for (int i = 0; i < k->cone.count; i++) {
        const struct half_plane *plane = &k->cone.edge[i].plane;
        if (triple_dot(plane->l, v) < -(8 * REAL_EPSILON + plane->error) && !never_cuts(k, plane, p)) {
            return false;
        }
    }
    return true;
}

static bool cut_piece(struct region_work *k, int piece, struct carrier_arcs *out)
{
    const struct piece *p = &k->piece[piece];
    struct mark mark[CUTS];
    int count = 0;
    real w3;
    form_values(k->span[p->span].form.e, 1, k->pascal,
                k->span[p->span].form.w + 2 * (k->span[p->span].form.e + 1), p->lo + (p->hi - p->lo) / 2,
                &w3);
    add_mark(mark, &count, p->lo, MARK_END, -1);
    for (int i = 0; i < k->cone.count; i++) {
        if (!never_cuts(k, &k->cone.edge[i].plane, p) &&
            !cut_by_edge(k, p, w3 < 0 ? -1 : 1, i, mark, &count)) {
            return true;
        }
    }
    add_mark(mark, &count, p->hi, MARK_END, -1);
    for (int i = 0; i + 1 < count; i++) {
        real middle = mark[i].t + (mark[i + 1].t - mark[i].t) / 2;
        if (mark[i + 1].t - mark[i].t <= 8 * REAL_EPSILON || !is_inside(k, p, middle)) {
            continue;
        }
        if (out->count == ARCS_MAX) {
            return false;
        }
        struct carrier_arc *a = &out->at[out->count++];
        a->piece = piece;
        a->from = mark[i];
        a->to = mark[i + 1];
    }
    return true;
}

bool arcs_inside(struct region_work *k, struct carrier_arcs *out)
{
    out->count = 0;
    for (int i = 0; i < k->pieces; i++) {
        if (k->piece[i].type > 0 && !cut_piece(k, i, out)) {
            return false;
        }
    }
    return true;
}

bool arcs_visible(struct region_work *k, const struct carrier_arcs *arcs,
                  const struct carrier_crossings *crossings, struct carrier_arcs *out)
{
    out->count = 0;
    for (int i = 0; i < arcs->count; i++) {
        const struct carrier_arc *a = &arcs->at[i];
        struct mark mark[CUTS];
        int count = 0, last = -1; /* last: where the arc added last ends, as a mark */
        add_mark(mark, &count, a->from.t, a->from.kind, a->from.edge);
        add_mark(mark, &count, a->to.t, a->to.kind, a->to.edge);
        for (int j = 0; j < crossings->count && count < CUTS; j++) {
            real t = crossings->at[j].t;
            if (crossings->at[j].arc == i && t > a->from.t && t < a->to.t) {
                add_mark(mark, &count, t, MARK_CROSSING, -1);
            }
        }
        for (int j = 0; j + 1 < count; j++) {
            real v[3];
            struct half_plane worst;
            envelope_at(k, k->piece[a->piece].span, mark[j].t + (mark[j + 1].t - mark[j].t) / 2, v);
            if (mark[j + 1].t - mark[j].t <= 8 * REAL_EPSILON ||
                planes_hold(k, &k->piece[a->piece], NULL, v, 8 * REAL_EPSILON, &worst) == FAILS) {
                continue;
            }
            if (last == j) {
                out->at[out->count - 1].to = mark[j + 1];
            } else if (out->count == ARCS_MAX) {
                return false;
            } else {
                out->at[out->count].piece = a->piece;
                out->at[out->count].from = mark[j];
                out->at[out->count++].to = mark[j + 1];
            }
            last = j + 1;
        }
    }
    return true;
}
