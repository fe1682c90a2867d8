/* The boundary from its visible parts, in the order of their normals. */
#include "carriers.h"
#include "form.h"
#include "planes.h"

enum { EDGE_MARKS = 64 };

/* A part of the boundary with its ends as unit vectors. */
struct part {
    struct region_edge edge; /* line: in the middle */
    real from[3], to[3];
};

struct parts {
    int count;
    struct part at[ARCS_MAX];
};

static void set_triple(const real *a, real *out)
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[i];
    }
}

/* The end at t of an arc, where w3 has the sign it has in the middle; at infinity the direction in which the
 * arc goes there. */
static void end_of_arc(const struct region_work *k, const struct carrier_arc *a, real t, real *v)
{
    const struct span_forms *f = &k->span[k->piece[a->piece].span].form;
    real w3;
    form_values(f->e, 3, k->pascal, f->w, t, v);
    form_values(f->e, 1, k->pascal, f->w + 2 * (f->e + 1), a->from.t + (a->to.t - a->from.t) / 2, &w3);
    triple_normalise(v);
    for (int i = 0; w3 < 0 && i < 3; i++) {
        v[i] = -v[i];
    }
}

static bool add_arc(const struct region_work *k, const struct carrier_arc *a, struct parts *out)
{
    const struct piece *piece = &k->piece[a->piece];
    struct half_plane plane;
    if (out->count == ARCS_MAX) {
        return false;
    }
    struct part *p = &out->at[out->count++];
    p->edge.type = EDGE_ARC;
    p->edge.span = piece->span;
    p->edge.t = k->sign > 0 ? a->from.t : a->to.t;
    p->edge.t1 = k->sign > 0 ? a->to.t : a->from.t;
    half_plane_at(k, piece->span, a->from.t + (a->to.t - a->from.t) / 2, false, &plane);
    set_triple(plane.l, p->edge.line);
    end_of_arc(k, a, p->edge.t, p->from);
    end_of_arc(k, a, p->edge.t1, p->to);
    return true;
}

/* ---- visible parts of lines ---- */

/* The ends of visible arcs that lie on an edge of the cone, as positions 0..1 between its vertices. */
static int marks_on_edge(const struct region_work *k, const struct carrier_arcs *visible, int edge,
                         const real *before, const real *after, real *position)
{
    const struct half_plane *plane = &k->cone.edge[edge].plane;
    int count = 0;
    real t;
    for (int i = 0; i < visible->count && count + 2 < EDGE_MARKS; i++) {
        const struct carrier_arc *a = &visible->at[i];
        const struct piece *piece = &k->piece[a->piece];
        const struct mark *ends[2] = {&a->from, &a->to};
        for (int j = 0; j < 2; j++) {
            bool touches = ends[j]->kind == MARK_END && plane_is_own(k, plane, piece, &t) && t == ends[j]->t;
            if (!touches && !(ends[j]->kind == MARK_EDGE && ends[j]->edge == edge)) {
                continue;
            }
            real v[3], a_part[3], b_part[3];
            envelope_at(k, piece->span, ends[j]->t, v);
            triple_cross(v, after, a_part);
            triple_cross(before, v, b_part);
            real x = triple_dot(a_part, plane->l), y = triple_dot(b_part, plane->l);
            if (x + y > 0) {
                position[count++] = y / (x + y);
            }
        }
    }
    return count;
}

static void on_edge(const real *before, const real *after, real position, real *v)
{
    for (int i = 0; i < 3; i++) {
        v[i] = before[i] + position * (after[i] - before[i]);
    }
    triple_normalise(v);
}

static void sort(int count, real *a)
{
    for (int i = 1; i < count; i++) {
        real x = a[i];
        int at = i;
        for (; at > 0 && a[at - 1] > x; at--) {
            a[at] = a[at - 1];
        }
        a[at] = x;
    }
}

/* What of an edge is visible is one segment. */
static bool add_edge(struct region_work *k, const struct carrier_arcs *visible, int edge, struct parts *out)
{
    const struct cone *c = &k->cone;
    const struct cone_edge *at = &c->edge[edge], *last = &c->edge[edge > 0 ? edge - 1 : c->count - 1];
    real position[EDGE_MARKS + 2], v[3], lo = 2, hi = -1;
    struct half_plane worst;
    int count = marks_on_edge(k, visible, edge, last->v, at->v, position);
    position[count++] = 0;
    position[count++] = 1;
    sort(count, position);
    for (int i = 0; i + 1 < count; i++) {
        on_edge(last->v, at->v, position[i] + (position[i + 1] - position[i]) / 2, v);
        if (position[i] >= 0 && position[i + 1] <= 1 && position[i + 1] - position[i] > 64 * REAL_EPSILON &&
            planes_hold(k, NULL, NULL, v, 8 * REAL_EPSILON + at->plane.error, &worst) != FAILS) {
            lo = real_min(lo, position[i]);
            hi = real_max(hi, position[i + 1]);
        }
    }
    if (lo > hi) {
        return true;
    }
    if (out->count == ARCS_MAX) {
        return false;
    }
    struct part *p = &out->at[out->count++];
    p->edge.type = at->plane.source == CHORD ? EDGE_CHORD : EDGE_LINE;
    p->edge.span = at->plane.span;
    p->edge.t = p->edge.t1 = at->plane.t;
    set_triple(at->plane.l, p->edge.line);
    on_edge(last->v, at->v, lo, p->from);
    on_edge(last->v, at->v, hi, p->to);
    return true;
}

/* ---- order ---- */

static int upper(const real *line)
{
    return line[1] > 0 || (line[1] == 0 && line[0] > 0);
}

/* By the angle of the normal, from 0 to 2 pi. */
static bool comes_before(const struct part *a, const struct part *b)
{
    const real *p = a->edge.line, *q = b->edge.line;
    if (upper(p) != upper(q)) {
        return upper(p);
    }
    return p[0] * q[1] - p[1] * q[0] > 0;
}

static void sort_parts(struct parts *p)
{
    for (int i = 1; i < p->count; i++) {
        struct part x = p->at[i];
        int at = i;
        for (; at > 0 && comes_before(&x, &p->at[at - 1]); at--) {
            p->at[at] = p->at[at - 1];
        }
        p->at[at] = x;
    }
}

static bool continues(const struct part *a, const struct part *b)
{
    return a->edge.type == EDGE_ARC && b->edge.type == EDGE_ARC && a->edge.span == b->edge.span &&
           a->edge.t1 == b->edge.t;
}

static void append(struct part *a, const struct part *b)
{
    a->edge.t1 = b->edge.t1;
    set_triple(b->to, a->to);
}

/* Arcs that go on at a root of A or B become one. */
static void merge(struct parts *p)
{
    int kept = 0;
    for (int i = 0; i < p->count; i++) {
        if (kept > 0 && continues(&p->at[kept - 1], &p->at[i])) {
            append(&p->at[kept - 1], &p->at[i]);
        } else {
            p->at[kept++] = p->at[i];
        }
    }
    if (kept > 1 && continues(&p->at[kept - 1], &p->at[0])) {
        append(&p->at[kept - 1], &p->at[0]);
        p->at[0] = p->at[--kept];
    }
    p->count = kept;
}

/* ---- joints ---- */

/* The end of a part and the start of the next are one point, that of the arc if there is one; or both are at
 * infinity. */
static bool join(struct part *a, struct part *b)
{
    real c[3], close = real_ldexp(1, -REAL_BITS / 2);
    bool infinite = vertex_is_infinite(a->to, 8 * REAL_EPSILON);
    if (infinite || vertex_is_infinite(b->from, 8 * REAL_EPSILON)) {
        return infinite && vertex_is_infinite(b->from, 8 * REAL_EPSILON);
    }
    triple_cross(a->to, b->from, c);
    if (triple_dot(c, c) > close * close) {
        return false;
    }
    if (a->edge.type == EDGE_ARC) {
        set_triple(a->to, b->from);
    } else {
        set_triple(b->from, a->to);
    }
    return true;
}

static void set_end(const real *v, struct point *p, bool *infinite)
{
    *infinite = vertex_is_infinite(v, 8 * REAL_EPSILON);
    p->x = *infinite ? v[0] : v[0] / v[2];
    p->y = *infinite ? v[1] : v[1] / v[2];
}

static void write_edges(const struct region_work *k, const struct parts *p, struct region *out)
{
    struct half_plane plane;
    out->kind = p->count > 0 ? REGION_BOUNDED : REGION_EMPTY;
    out->count = p->count;
    for (int i = 0; i < p->count; i++) {
        struct region_edge *e = &out->edge[i];
        *e = p->at[i].edge;
        set_end(p->at[i].from, &e->from, &e->from_infinity);
        set_end(p->at[i].to, &e->to, &e->to_infinity);
        if (e->type == EDGE_ARC && half_plane_at(k, e->span, e->t, false, &plane)) {
            set_triple(plane.l, e->line);
        }
        if (e->from_infinity || e->to_infinity) {
            out->kind = REGION_UNBOUNDED;
        }
    }
}

bool carriers_join(struct region_work *k, const struct carrier_arcs *visible, struct region *out)
{
    struct parts parts;
    parts.count = 0;
    for (int i = 0; i < visible->count; i++) {
        if (!add_arc(k, &visible->at[i], &parts)) {
            return false;
        }
    }
    for (int i = 0; i < k->cone.count; i++) {
        if (k->cone.edge[i].plane.corner && !add_edge(k, visible, i, &parts)) {
            return false;
        }
    }
    sort_parts(&parts);
    merge(&parts);
    out->certified = true;
    for (int i = 0; i < parts.count; i++) {
        out->certified = join(&parts.at[i], &parts.at[i + 1 < parts.count ? i + 1 : 0]) && out->certified;
    }
    write_edges(k, &parts, out);
    return true;
}
