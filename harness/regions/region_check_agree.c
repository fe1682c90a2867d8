/* Two methods on one problem: the region found exactly, and a polygon that holds it and is hardly larger. */
#include <stdio.h>

#include "region_check.h"

/* In sizes of the curve: what is farther is not compared, and an edge farther than this may be at infinity.
 */
enum { REACH = 1024, INFINITE = 64 };

static char message[200];

struct frame {
    struct point centre;
    real size;
};

static struct frame frame_of(const struct control_family *f)
{
    struct frame a = {{f->x[0], f->y[0]}, 0};
    for (int i = 1; i < f->count; i++)
        a.size = real_max(a.size, real_max(real_abs(f->x[i] - f->x[0]), real_abs(f->y[i] - f->y[0])));
    return a;
}

/* Square of the distance from the curve, in sizes. */
static real far_square(const struct frame *f, struct point p)
{
    real x = (p.x - f->centre.x) / f->size, y = (p.y - f->centre.y) / f->size;
    return x * x + y * y;
}

static bool is_within(const struct frame *f, const struct region *r, real sizes)
{
    for (int i = 0; i < r->count; i++) {
        const struct region_edge *e = &r->edge[i];
        if (e->from_infinity || e->to_infinity || far_square(f, e->from) > sizes * sizes)
            return false;
    }
    return r->kind == REGION_BOUNDED;
}

/* Some point of the region is within REACH. */
static bool is_present(const struct region_problem *p, struct region_workspace *w, const struct frame *f,
                       const struct region *r)
{
    return r->kind != REGION_EMPTY && region_distance(p, w, r, f->centre) > -REACH * f->size;
}

static bool vertices_held(const struct region_problem *p, struct region_workspace *w, const struct frame *f,
                          const struct region *exact, const struct region *polygon)
{
    for (int i = 0; i < exact->count; i++) {
        const struct region_edge *e = &exact->edge[i];
        real far = far_square(f, e->to);
        if (e->to_infinity || far > (real)REACH * REACH)
            continue;
        real outside = -region_distance(p, w, polygon, e->to) / f->size;
        if (outside > (real)1e-9 * (1 + far)) {
            snprintf(message, sizeof message, "the vertex (%.10g, %.10g) is outside the polygon by %.3g",
                     real_to_double(e->to.x), real_to_double(e->to.y), real_to_double(outside * f->size));
            return false;
        }
    }
    return true;
}

/* The polygon's points miss a condition by no more than 32 tolerances (region_check_sample.c), at most. */
static bool areas_agree(const struct frame *f, const struct region *exact, const struct region *polygon,
                        real tolerance)
{
    real around = 0, far = 0;
    for (int i = 0; i < polygon->count; i++) {
        const struct region_edge *e = &polygon->edge[i];
        real x = e->to.x - e->from.x, y = e->to.y - e->from.y;
        around += real_sqrt(x * x + y * y);
        far = real_max(far, far_square(f, e->to));
    }
    real more = polygon->area - exact->area, slack = 32 * tolerance * f->size * (1 + far) * around;
    if (more > slack || more < -(real)1e-9 * (1 + far) * f->size * around) {
        snprintf(message, sizeof message, "areas differ: %.12g, and %.12g of the polygon",
                 real_to_double(exact->area), real_to_double(polygon->area));
        return false;
    }
    return true;
}

const char *region_check_agree(const struct region_problem *p, struct region_workspace *w,
                               const struct region *exact, const struct region *polygon)
{
    const struct frame f = frame_of(&p->family);
    real tolerance = p->tolerance > 0 ? p->tolerance : real_ldexp(1, -20);
    bool present = is_present(p, w, &f, exact), there = is_present(p, w, &f, polygon);
    bool thin = exact->kind == REGION_EMPTY && is_within(&f, polygon, REACH) &&
                polygon->disc_radius < 32 * tolerance * f.size;
    if (!present && (!there || thin))
        return NULL;
    if (present != there || (exact->kind == REGION_PLANE) != (polygon->kind == REGION_PLANE)) {
        snprintf(message, sizeof message, "kinds differ: %s, and %s of the polygon",
                 region_kind_name(exact->kind), region_kind_name(polygon->kind));
        return message;
    }
    if (!vertices_held(p, w, &f, exact, polygon))
        return message;
    bool both = exact->kind == REGION_BOUNDED && polygon->kind == REGION_BOUNDED;
    if (both && is_within(&f, exact, REACH) && !areas_agree(&f, exact, polygon, tolerance))
        return message;
    if (!both && (is_within(&f, exact, INFINITE) || is_within(&f, polygon, INFINITE)) &&
        exact->kind != polygon->kind) {
        snprintf(message, sizeof message, "one is %s, the other %s", region_kind_name(exact->kind),
                 region_kind_name(polygon->kind));
        return message;
    }
    return NULL;
}
