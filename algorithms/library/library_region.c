/* The region of a control point: fatline.h's problem to region.h's, and the edges back. */
#include "../region.h"
#include "library.h"

enum { ALIGN = 64 };

struct fatline_region_workspace {
    int degree, count;
    bool solved;
    struct region_workspace workspace;
    struct region_problem problem;
    real *x, *y, *share, *weight, *knots; /* copies */
    struct region found;
    struct fatline_edge edge[REGION_EDGES_MAX];
};

/* ---- memory ---- */

static size_t rounded(size_t bytes)
{
    return (bytes + ALIGN - 1) / ALIGN * ALIGN;
}

/* Four numbers a control point, and count + degree + 1 knots. */
static size_t arrays_size(int degree, int count)
{
    return rounded((5 * (size_t)count + (size_t)degree + 1) * sizeof(real));
}

size_t fatline_region_workspace_size(int degree, int count)
{
    if (degree < 2 || degree > DEGREE_MAX || count <= degree) {
        return 0;
    }
    return rounded(sizeof(struct fatline_region_workspace)) + arrays_size(degree, count) +
           region_workspace_size(degree, count - degree);
}

struct fatline_region_workspace *fatline_region_workspace_init(void *memory, size_t size, int degree,
                                                               int count)
{
    if (!memory_fits(memory, size, fatline_region_workspace_size(degree, count))) {
        return NULL;
    }
    struct fatline_region_workspace *w = (struct fatline_region_workspace *)memory;
    char *arrays = (char *)memory + rounded(sizeof *w);
    w->degree = degree;
    w->count = count;
    w->solved = false;
    w->x = (real *)(void *)arrays;
    w->y = w->x + count;
    w->share = w->y + count;
    w->weight = w->share + count;
    w->knots = w->weight + count;
    region_workspace_init(&w->workspace, arrays + arrays_size(degree, count), degree, count - degree);
    return w;
}

/* ---- the problem ---- */

static const char *error_before(const struct fatline_region_problem *p)
{
    const struct fatline_spline *c = p ? &p->curve : NULL;
    if (!c || !c->points) {
        return "the problem or its points are missing";
    }
    if (c->degree < 2 || c->degree > DEGREE_MAX) {
        return "the degree is not 2 to 32";
    }
    if (c->count <= c->degree || (!c->knots && c->count != c->degree + 1)) {
        return "the number of control points does not suit the degree";
    }
    if (p->free < 0 || p->free >= c->count) {
        return "there is no control point of the number `free`";
    }
    if (!(p->tolerance >= 0 && p->tolerance < 1)) {
        return "the tolerance is not in [0, 1)";
    }
    return p->max_steps < 0 ? "max_steps is negative" : NULL;
}

static void take_family(struct fatline_region_workspace *w, const struct fatline_region_problem *p)
{
    const struct fatline_spline *c = &p->curve;
    struct control_family *f = &w->problem.family;
    for (int i = 0; i < c->count; i++) {
        w->x[i] = c->points[2 * i];
        w->y[i] = c->points[2 * i + 1];
        w->weight[i] = c->weights ? c->weights[i] : 1;
    }
    for (int i = 0; i <= c->count + c->degree; i++) {
        w->knots[i] = c->knots ? c->knots[i] : i > c->degree;
    }
    f->degree = c->degree;
    f->count = c->count;
    f->knots = w->knots;
    f->x = w->x;
    f->y = w->y;
    f->weight = c->weights ? w->weight : NULL;
    family_of_point(f, p->free, w->share);
    for (int i = 0; p->share && i < c->count; i++) {
        w->share[i] = p->share[i];
    }
}

static void take_problem(struct fatline_region_workspace *w, const struct fatline_region_problem *p)
{
    struct region_problem *to = &w->problem;
    bool all = p->from == 0 && p->to == 0;
    take_family(w, p);
    to->interval.lo = all ? to->family.knots[to->family.degree] : p->from;
    to->interval.hi = all ? to->family.knots[to->family.count] : p->to;
    to->sign = p->sign;
    to->loop_free = p->loop_free != 0;
    to->tolerance = p->tolerance;
    to->max_steps = p->max_steps > 0 ? p->max_steps : (int)REGION_STEPS_MAX;
}

/* NULL, or a sentence. */
static const char *error_after(const struct region_problem *p)
{
    const char *field;
    if (!region_problem_check(p, &field)) {
        return NULL;
    }
    static const struct {
        char first;
        const char *sentence;
    } of[] = {{'p', "a coordinate is not finite, or all control points are one"},
              {'k',
               "the knots decrease, are not finite, leave no interval, or repeat one inside more than degree "
               "times"},
              {'w', "a weight is not positive and finite"},
              {'f', "a share is not finite, or no control point moves"},
              {'i', "from..to is empty or not within the curve"},
              {'s', "the sign is neither 1 nor -1"}};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        if (of[i].first == field[0]) {
            return of[i].sentence;
        }
    }
    return "the problem is not one";
}

/* ---- the region ---- */

static void give_edge(const struct region_edge *e, struct fatline_edge *to)
{
    to->type = e->type == EDGE_LINE ? FATLINE_LINE : e->type == EDGE_ARC ? FATLINE_ARC : FATLINE_CHORD;
    to->from_infinity = e->from_infinity;
    to->to_infinity = e->to_infinity;
    to->from[0] = e->from.x;
    to->from[1] = e->from.y;
    to->to[0] = e->to.x;
    to->to[1] = e->to.y;
    for (int k = 0; k < 3; k++) {
        to->line[k] = e->line[k];
    }
    to->t = e->t;
    to->t1 = e->t1;
}

static void give_region(struct fatline_region_workspace *w, struct fatline_region *out)
{
    const struct region *r = &w->found;
    out->kind = r->kind == REGION_BOUNDED     ? FATLINE_BOUNDED
                : r->kind == REGION_UNBOUNDED ? FATLINE_UNBOUNDED
                : r->kind == REGION_PLANE     ? FATLINE_PLANE
                                              : FATLINE_EMPTY;
    out->certified = r->certified;
    out->count = r->count;
    for (int i = 0; i < r->count; i++) {
        give_edge(&r->edge[i], &w->edge[i]);
    }
    if (r->kind == REGION_BOUNDED) {
        out->area = r->area;
        out->disc[0] = r->disc_centre.x;
        out->disc[1] = r->disc_centre.y;
        out->disc[2] = r->disc_radius;
    }
}

enum fatline_outcome fatline_region_solve(struct fatline_region_workspace *w,
                                          const struct fatline_region_problem *p, struct fatline_region *out)
{
    const struct fatline_region nothing = {.outcome = FATLINE_INVALID, .edge = w->edge};
    *out = nothing;
    w->solved = false;
    if ((out->error = error_before(p)) != NULL) {
        return FATLINE_INVALID;
    }
    if (p->curve.degree > w->degree || p->curve.count > w->count) {
        return out->outcome = FATLINE_OUT_OF_ROOM;
    }
    take_problem(w, p);
    if ((out->error = error_after(&w->problem)) != NULL) {
        return FATLINE_INVALID;
    }
    out->outcome = outcome_public(
        region_solve(&w->problem, region_method_find("region_carriers"), &w->workspace, &w->found));
    if (out->outcome == FATLINE_UNSUPPORTED) {
        out->error = "with weights, the degree is at most 17";
    }
    w->solved = out->outcome == FATLINE_SOLVED;
    if (w->solved) {
        give_region(w, out);
    }
    return out->outcome;
}

/* ---- questions ---- */

enum fatline_side fatline_region_contains(struct fatline_region_workspace *w, double x, double y,
                                          double margin)
{
    struct point d = {x, y};
    if (!w->solved || !real_is_finite(x) || !real_is_finite(y) || !(margin >= 0) || !real_is_finite(margin)) {
        return FATLINE_OUTSIDE;
    }
    enum side side = region_contains(&w->problem, &w->workspace, d, margin);
    return side == SIDE_INSIDE ? FATLINE_INSIDE : side == SIDE_BOUNDARY ? FATLINE_BOUNDARY : FATLINE_OUTSIDE;
}

/* The distance is right to rounding or to the tolerance: somewhat less of it is proved. */
double fatline_region_safe_radius(struct fatline_region_workspace *w, double x, double y)
{
    struct point d = {x, y};
    if (fatline_region_contains(w, x, y, 0) != FATLINE_INSIDE) {
        return 0;
    }
    if (w->found.kind == REGION_PLANE) {
        return HUGE_VAL;
    }
    double distance = region_distance(&w->problem, &w->workspace, &w->found, d);
    for (int k = 48; k > 0 && distance > 0; k -= k > 8 ? 8 : 1) {
        double radius = distance - real_ldexp(distance, -k);
        if (fatline_region_contains(w, x, y, radius) == FATLINE_INSIDE) {
            return radius;
        }
    }
    return 0;
}

void fatline_region_nearest(struct fatline_region_workspace *w, double x, double y, double nearest[2])
{
    struct point d = {x, y};
    if (w->solved && real_is_finite(x) && real_is_finite(y)) {
        d = region_nearest(&w->problem, &w->workspace, &w->found, d);
    }
    nearest[0] = d.x;
    nearest[1] = d.y;
}
