/* Curves as fatline.h has them to curves as bezier.h has them, and the records back. */
#include "../core/curve.h"
#include "library.h"

enum { COMPONENTS = 3, LENGTH = COMPONENTS * (DEGREE_MAX + 1) };

struct fatline_workspace {
    int degree;
    struct workspace workspace;
    real f[LENGTH], g[LENGTH];
    struct fatline_crossing crossing[CROSSINGS_MAX];
    struct fatline_overlap overlap[OVERLAPS_MAX];
    struct crossings found;
};

/* ---- memory ---- */

static size_t head_size(void)
{
    enum { ALIGN = 64 };
    return (sizeof(struct fatline_workspace) + ALIGN - 1) / ALIGN * ALIGN;
}

size_t fatline_workspace_size(int degree)
{
    if (degree < 1 || degree > DEGREE_MAX) {
        return 0;
    }
    const struct intersector *a = intersector_find("certified");
    return head_size() + workspace_size(degree, degree, 1, a->scratch(degree, degree));
}

struct fatline_workspace *fatline_workspace_init(void *memory, size_t size, int degree)
{
    if (!memory_fits(memory, size, fatline_workspace_size(degree))) {
        return NULL;
    }
    const struct intersector *a = intersector_find("certified");
    struct fatline_workspace *w = (struct fatline_workspace *)memory;
    w->degree = degree;
    workspace_init(&w->workspace, (char *)memory + head_size(), degree, degree, 1,
                   a->scratch(degree, degree));
    return w;
}

/* ---- what is wrong? ---- */

enum fault { NOTHING, MISSING, DEGREE, WORKSPACE, COORDINATE, WEIGHT, WEIGHTS };

static const double ratio_max = 0x1p256;

static enum fault fault_of(const struct fatline_curve *c, int degree)
{
    if (!c || !c->points) {
        return MISSING;
    }
    if (c->degree < 1 || c->degree > DEGREE_MAX) {
        return DEGREE;
    }
    if (c->degree > degree) {
        return WORKSPACE;
    }
    double least = DBL_MAX, most = 0;
    for (int i = 0; i <= c->degree; i++) {
        double w = c->weights ? c->weights[i] : 1;
        if (!real_is_finite(c->points[2 * i]) || !real_is_finite(c->points[2 * i + 1])) {
            return COORDINATE;
        }
        if (!(w > 0) || !real_is_finite(w)) {
            return WEIGHT;
        }
        least = real_min(least, w);
        most = real_max(most, w);
    }
    return most / least > ratio_max ? WEIGHTS : NOTHING;
}

static const char *const errors[][2] = {
    {NULL, NULL},
    {"f or its points are missing", "g or its points are missing"},
    {"the degree of f is not 1 to 32", "the degree of g is not 1 to 32"},
    {"the degree of f is higher than the workspace was made for",
     "the degree of g is higher than the workspace was made for"},
    {"a coordinate of f is not finite", "a coordinate of g is not finite"},
    {"a weight of f is not positive and finite", "a weight of g is not positive and finite"},
    {"weights of f differ by more than 2^256", "weights of g differ by more than 2^256"},
};

/* NULL, or a sentence. */
static const char *error_of(int degree, const struct fatline_curve *f, const struct fatline_curve *g,
                            const struct fatline_options *o)
{
    enum fault of_f = fault_of(f, degree), of_g = fault_of(g, degree);
    if (of_f != NOTHING || of_g != NOTHING) {
        return of_f != NOTHING ? errors[of_f][0] : errors[of_g][1];
    }
    return options_error(o);
}

/* ---- from points and weights to homogeneous coordinates ---- */

static double extent_of(const struct fatline_curve *c, double most)
{
    for (int i = 0; i < 2 * (c->degree + 1); i++) {
        most = real_max(most, real_abs(c->points[i]));
    }
    return most;
}

/* e such that 2^e brings `extent` into [1, 2), as far as 2^e is a double. */
static int exponent_of(double extent)
{
    enum { MOST = 1000 };
    int e = extent > 0 ? 1 - real_exponent(extent) : 0;
    return e < MOST ? e : MOST;
}

/* c times 2^e.  Of a rational curve, weights are first brought below 2 by a power of two: then they are above
 * 2^-257, and products with coordinates of a curve of size 1 err by u of themselves or underflow by 2^-1075,
 * which is nothing beside u 2^-257. */
static void take_curve(const struct fatline_curve *c, int e, real *to, struct curve *out)
{
    int length = c->degree + 1;
    real *x = to, *y = x + length, *w = y + length, heavy = 0, by = real_ldexp(1, e);
    for (int i = 0; c->weights && i < length; i++) {
        heavy = real_max(heavy, c->weights[i]);
    }
    for (int i = 0; i < length; i++) {
        x[i] = c->points[2 * i] * by;
        y[i] = c->points[2 * i + 1] * by;
        if (c->weights) {
            w[i] = real_ldexp(c->weights[i], 1 - real_exponent(heavy));
            x[i] = w[i] * x[i];
            y[i] = w[i] * y[i];
        }
    }
    out->degree = c->degree;
    out->x = x;
    out->y = y;
    out->w = c->weights ? w : NULL;
    out->domain.lo = 0;
    out->domain.hi = 1;
}

/* ---- the records ---- */

static void give_records(struct fatline_workspace *w, int e)
{
    for (int i = 0; i < w->found.count; i++) {
        crossing_public(&w->found.at[i], &w->crossing[i]);
    }
    for (int i = 0; i < w->found.overlaps; i++) {
        overlap_public(&w->found.overlap[i], e, &w->overlap[i]);
    }
}

enum fatline_outcome fatline_intersect(struct fatline_workspace *w, const struct fatline_curve *f,
                                       const struct fatline_curve *g, const struct fatline_options *options,
                                       struct fatline_answer *out)
{
    const struct fatline_options usual = {TOLERANCE_USUAL, STEPS_MAX}, *o = options ? options : &usual;
    struct problem p = {0};
    out->error = error_of(w->degree, f, g, o);
    out->outcome = FATLINE_INVALID;
    out->count = out->overlaps = out->steps = 0;
    out->crossing = w->crossing;
    out->overlap = w->overlap;
    if (out->error) {
        return FATLINE_INVALID;
    }
    /* where one of them is rational, both are brought to size 1: take_curve */
    int e = f->weights || g->weights ? exponent_of(extent_of(g, extent_of(f, 0))) : 0;
    take_curve(f, e, w->f, &p.f);
    take_curve(g, e, w->g, &p.g);
    p.tolerance = o->tolerance > 0 ? o->tolerance : usual.tolerance;
    p.max_steps = o->max_steps > 0 ? o->max_steps : usual.max_steps;
    out->outcome = outcome_public(problem_solve(&p, intersector_find("certified"), &w->workspace, &w->found));
    out->count = w->found.count;
    out->overlaps = w->found.overlaps;
    out->steps = w->workspace.steps;
    give_records(w, e);
    return out->outcome;
}

void fatline_point(const struct fatline_curve *c, double t, double point[2])
{
    real coordinates[LENGTH];
    struct curve curve;
    int e = c->weights ? exponent_of(extent_of(c, 0)) : 0;
    take_curve(c, e, coordinates, &curve);
    struct point p = curve_point(curve.degree, curve.x, curve.y, curve.w, t);
    point[0] = real_ldexp(p.x, -e);
    point[1] = real_ldexp(p.y, -e);
}
