#include "boundary.h"

#include "family.h"

bool vertex_is_infinite(const real *v, real error)
{
    return v[2] <= real_max(2 * error, real_ldexp(1, -REAL_BITS * 3 / 4));
}

static real parameter_out(const struct region_work *k, int span, real t)
{
    const struct span *s = &k->span[span];
    return t == 1 ? s->hi : s->lo + t * (s->hi - s->lo);
}

static void set_end(const real *v, real error, struct point *p, bool *infinite)
{
    *infinite = vertex_is_infinite(v, error);
    p->x = *infinite ? v[0] : v[0] / v[2];
    p->y = *infinite ? v[1] : v[1] / v[2];
}

static void set_line(const struct cone *c, int i, struct region_edge *e)
{
    const struct cone_edge *at = &c->edge[i], *before = &c->edge[i > 0 ? i - 1 : c->count - 1];
    e->type = at->plane.source == CHORD ? EDGE_CHORD : EDGE_LINE;
    e->span = at->plane.span;
    e->t = e->t1 = at->plane.t;
    for (int j = 0; j < 3; j++) {
        e->line[j] = at->plane.l[j];
    }
    set_end(before->v, before->error, &e->from, &e->from_infinity);
    set_end(at->v, at->error, &e->to, &e->to_infinity);
}

bool boundary_of_cone(const struct cone *c, struct region *out)
{
    bool bounded = c->count > 2;
    out->count = 0;
    out->kind = REGION_PLANE;
    for (int i = 0; c->count > 1 && i < c->count; i++) {
        bounded = bounded && !vertex_is_infinite(c->edge[i].v, c->edge[i].error);
        if (c->edge[i].plane.source == AT_INFINITY) {
            continue;
        }
        if (out->count == REGION_EDGES_MAX) {
            return false;
        }
        set_line(c, i, &out->edge[out->count++]);
        out->kind = REGION_UNBOUNDED;
    }
    out->kind = bounded ? REGION_BOUNDED : out->kind;
    return true;
}

static void point_out(const struct region_work *k, struct point *p)
{
    p->x = k->centre_x + k->scale * p->x;
    p->y = k->centre_y + k->scale * p->y;
}

void boundary_out(const struct region_work *k, struct region *r)
{
    for (int i = 0; i < r->count; i++) {
        struct region_edge *e = &r->edge[i];
        real line[3];
        e->t = parameter_out(k, e->span, e->t);
        e->t1 = parameter_out(k, e->span, e->t1);
        family_line_out(k, e->line, line);
        for (int j = 0; j < 3; j++) {
            e->line[j] = line[j];
        }
        if (!e->from_infinity) {
            point_out(k, &e->from);
        }
        if (!e->to_infinity) {
            point_out(k, &e->to);
        }
    }
    r->area = r->area * k->scale * k->scale;
    r->disc_radius = r->disc_radius * k->scale;
    point_out(k, &r->disc_centre);
    for (int i = 0; i < 2; i++) {
        point_out(k, &r->closed[i]);
    }
}
