/* A region against the `expected` of its line. */
#include <stdio.h>
#include <string.h>

#include "region_check.h"
#include "../cases/number.h"

static char message[200];

static const char *wrong(const char *what, double a, double b)
{
    snprintf(message, sizeof message, "%s: %.17g, expected %.17g", what, a, b);
    return message;
}

/* Expected texts have 22 digits or are exact; at double that is more than enough. */
static real allowed(void)
{
    return REAL_BITS > 53 ? (real)1e-20 : (real)1e-12;
}

static bool read(const json_t *v, real *a)
{
    return json_is_string(v) && real_parse(json_string_value(v), a);
}

/* Of the vertices' box, or of the curve where that has no size. */
static real size_of(const struct region_problem *p, const json_t *vertices)
{
    real lo[2] = {0, 0}, hi[2] = {0, 0}, x, size;
    for (size_t i = 0; i < json_array_size(vertices); i++)
        for (int c = 0; c < 2; c++)
            if (read(json_array_get(json_array_get(vertices, i), (size_t)c), &x)) {
                lo[c] = i == 0 ? x : real_min(lo[c], x);
                hi[c] = i == 0 ? x : real_max(hi[c], x);
            }
    size = real_max(hi[0] - lo[0], hi[1] - lo[1]);
    for (int i = 0; !(size > 0) && i < p->family.count; i++)
        size = real_max(size, real_max(real_abs(p->family.x[i] - p->family.x[0]),
                                       real_abs(p->family.y[i] - p->family.y[0])));
    return real_max(size, 1);
}

static bool near(real a, real b, real bound)
{
    return real_abs(a - b) <= bound;
}

/* null stands for an end at infinity. */
static bool same_point(const json_t *v, struct point p, bool infinite, real bound)
{
    real x, y;
    if (json_is_null(v) || !v)
        return infinite;
    return !infinite && read(json_array_get(v, 0), &x) && read(json_array_get(v, 1), &y) &&
           near(p.x, x, bound) && near(p.y, y, bound);
}

static bool same_line(const json_t *v, const real *line, real bound)
{
    for (int i = 0; i < 3; i++) {
        real a;
        if (!read(json_array_get(v, (size_t)i), &a) || !near(line[i], a, i < 2 ? allowed() * 16 : bound))
            return false;
    }
    return true;
}

static bool same_edge(const json_t *v, const struct region_edge *e, real bound)
{
    real t0, t1;
    const char *type = json_string_value(json_object_get(v, "type"));
    if (!type || strcmp(type, edge_type_name(e->type)) ||
        !same_point(json_object_get(v, "from"), e->from, e->from_infinity, bound) ||
        !same_point(json_object_get(v, "to"), e->to, e->to_infinity, bound))
        return false;
    if (e->type != EDGE_ARC)
        return same_line(json_object_get(v, "line"), e->line, bound);
    return read(json_object_get(v, "t0"), &t0) && read(json_object_get(v, "t1"), &t1) &&
           near(e->t, t0, 1000 * allowed()) && near(e->t1, t1, 1000 * allowed());
}

/* The two cyclic lists agree from some start on. */
static const char *compare_edges(const json_t *edges, const struct region *r, real bound)
{
    int n = (int)json_array_size(edges);
    if (n != r->count)
        return wrong("number of edges", r->count, n);
    for (int shift = 0; shift < n; shift++) {
        int i = 0;
        while (i < n && same_edge(json_array_get(edges, (size_t)i), &r->edge[(i + shift) % n], bound))
            i++;
        if (i == n)
            return NULL;
    }
    return n ? "the edges differ" : NULL;
}

/* vertices_exact[i] belongs to vertex i where it is not null: some vertex of the region is there. */
static const char *compare_exact(const json_t *vertices, const struct region *r, real bound)
{
    for (size_t i = 0; i < json_array_size(vertices); i++) {
        const json_t *v = json_array_get(vertices, i);
        bool found = json_is_null(v) || json_is_null(json_array_get(v, 0));
        for (int j = 0; j < r->count && !found; j++)
            found = same_point(v, r->edge[j].to, r->edge[j].to_infinity, bound) ||
                    same_point(v, r->edge[j].from, r->edge[j].from_infinity, bound);
        if (!found)
            return "a vertex known exactly is missing";
    }
    return NULL;
}

/* A polygon that stands for arcs is larger by its perimeter times what its vertices may miss. */
static real excess(const struct region_problem *p, const struct region *r, real area)
{
    real tolerance = p->tolerance > 0 ? p->tolerance : real_ldexp(1, -20), around = 0, size = 0;
    for (int i = 0; i < r->count; i++) {
        real x = r->edge[i].to.x - r->edge[i].from.x, y = r->edge[i].to.y - r->edge[i].from.y;
        around += real_sqrt(x * x + y * y);
    }
    for (int i = 0; i < p->family.count; i++)
        size = real_max(size, real_max(real_abs(p->family.x[i] - p->family.x[0]),
                                       real_abs(p->family.y[i] - p->family.y[0])));
    return 8 * tolerance * around * real_max(size, around) / area;
}

/* Printed to 18 digits. */
static const char *compare_area(const json_t *expected, const struct region_problem *p,
                                const struct region *r, bool fine)
{
    const json_t *exact = json_object_get(expected, "area_exact");
    const json_t *text = exact ? exact : json_object_get(expected, "area");
    real area, bound = exact ? allowed() : real_max(allowed(), (real)1e-17);
    if (!text)
        return NULL;
    return read(text, &area) && near(r->area, area, area * (fine ? bound : excess(p, r, area)))
               ? NULL
               : wrong("area", real_to_double(r->area), real_to_double(area));
}

static const char *compare_points(const json_t *points, enum side not_this, const struct region_problem *p,
                                  struct region_workspace *w)
{
    for (size_t i = 0; i < json_array_size(points); i++) {
        struct point d;
        if (read(json_array_get(json_array_get(points, i), 0), &d.x) &&
            read(json_array_get(json_array_get(points, i), 1), &d.y) &&
            region_contains(p, w, d, 0) == not_this) {
            snprintf(message, sizeof message, "(%.10g, %.10g) is %s", real_to_double(d.x),
                     real_to_double(d.y),
                     not_this == SIDE_INSIDE ? "inside, expected outside" : "outside, expected inside");
            return message;
        }
    }
    return NULL;
}

static const char *compare_kind(const json_t *expected, const struct region *r)
{
    const char *kind = json_string_value(json_object_get(expected, "kind"));
    bool given = json_object_get(expected, "kind");
    const char *closed = json_string_value(json_object_get(expected, "closed_kind"));
    const json_t *strict = json_object_get(expected, "strict_nonempty");
    if (given && (!kind || strcmp(kind, region_kind_name(r->kind)))) {
        snprintf(message, sizeof message, "kind: %s, expected %s", region_kind_name(r->kind),
                 kind ? kind : "text");
        return message;
    }
    if (closed && strcmp(closed, region_kind_name(r->closed_kind))) {
        snprintf(message, sizeof message, "closed_kind: %s, expected %s", region_kind_name(r->closed_kind),
                 closed);
        return message;
    }
    bool nonempty = r->kind != REGION_EMPTY && r->strict;
    return strict && json_is_true(strict) != nonempty ? "strict_nonempty differs" : NULL;
}

/* `closed`: the point; the two ends of the segment; the end of the ray and another point of it. */
static const char *compare_closed(const json_t *closed, const struct region *r, real bound)
{
    bool same = true, swapped = true;
    size_t n = json_array_size(closed);
    if (r->closed_kind == REGION_POINT || r->closed_kind == REGION_SEGMENT || r->closed_kind == REGION_RAY) {
        n = r->closed_kind == REGION_SEGMENT ? n : n > 0;
        for (size_t i = 0; i < n && i < 2; i++) {
            same = same && same_point(json_array_get(closed, i), r->closed[i], false, bound);
            swapped = swapped && same_point(json_array_get(closed, i), r->closed[1 - i], false, bound);
        }
    }
    return same || (swapped && r->closed_kind == REGION_SEGMENT) ? NULL : "closed: other points";
}

const char *region_check_expected(const struct region_case *c, const struct region_problem *p,
                                  struct region_workspace *w, const struct region_answer *a)
{
    const json_t *expected = json_object_get(c->line, "expected");
    const struct region *r = a->region;
    real size = size_of(p, json_object_get(expected, "vertices")), bound = size * allowed();
    bool exact = a->method == region_methods[0]; /* the others have polygons for arcs */
    const char *found = compare_kind(expected, r);
    if (!found) /* found by moving the conditions a little */
        found = compare_closed(json_object_get(expected, "closed"), r, size * (real)1e-6);
    if (!found && exact && json_object_get(expected, "edges_ccw"))
        found = compare_edges(json_object_get(expected, "edges_ccw"), r, bound);
    if (!found && exact)
        found = compare_exact(json_object_get(expected, "vertices_exact"), r, bound);
    if (!found)
        found = compare_area(expected, p, r, exact);
    if (!found)
        found = compare_points(json_object_get(expected, "inside"), SIDE_OUTSIDE, p, w);
    if (!found)
        found = compare_points(json_object_get(expected, "outside"), SIDE_INSIDE, p, w);
    return found;
}
