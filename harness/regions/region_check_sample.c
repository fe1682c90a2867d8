/* A region against a sample of half-planes: its boundary fulfils them all, and what they leave is hardly
 * more. */
#include <math.h>
#include <stdio.h>

#include "region_check.h"
#include "region_sample.h"

enum { PER_SPAN = 512, REFINEMENTS = 3 };

/* Doubles evaluate a half-plane to about this, relative to its own coefficients. */
static const double rounding = 1e-8;
/* At a distance of D sizes of the curve lines are known to D roundings in direction, and heights to D^2. */
static const double remoteness = 1e-14;
/* Towards the middle by this part: the sample leaves a little more than the region. */
static const double inwards = 0.02;

static char message[200];

/* slack: of a polygon that stands for arcs.  Its unit is the power of two that scales the curve, and
 * Bernstein coefficients are a few times their form; in projective measure far out it grows with the square.
 */
static bool point_holds(const struct region_sample *s, const char *what, double x, double y, double slack)
{
    double height = region_sample_height(s, x, y), far = hypot(x - s->x0, y - s->y0) / s->size;
    if (height >= -rounding - slack * (1 + far * far) - remoteness * far * far)
        return true;
    snprintf(message, sizeof message, "%s (%.10g, %.10g) is outside a sampled half-plane by %.3g", what, x, y,
             -height);
    return false;
}

static bool edges_hold(const struct region_sample *s, const struct region_answer *a, double slack)
{
    for (int i = 0; i < a->region->count; i++) {
        const struct region_edge *e = &a->region->edge[i];
        if (!e->from_infinity &&
            !point_holds(s, "a vertex", real_to_double(e->from.x), real_to_double(e->from.y), slack))
            return false;
        if (!e->to_infinity &&
            !point_holds(s, "a vertex", real_to_double(e->to.x), real_to_double(e->to.y), slack))
            return false;
    }
    return true;
}

/* What the sample leaves, drawn together a little, is inside; its middle at any rate is. */
static bool corners_inside(const struct region_sample *s, const struct region_problem *p,
                           struct region_workspace *w, const struct region_answer *a)
{
    double x = 0, y = 0;
    for (int i = 0; i < s->corners; i++) {
        x += s->corner[i][0] / s->corners;
        y += s->corner[i][1] / s->corners;
    }
    for (int i = 0; i < s->corners; i++) {
        double cx = x + (1 - inwards) * (s->corner[i][0] - x), cy = y + (1 - inwards) * (s->corner[i][1] - y);
        struct point d;
        d.x = (real)(s->x0 + s->size * cx);
        d.y = (real)(s->y0 + s->size * cy);
        double distance = real_to_double(region_distance(p, w, a->region, d)) / s->size;
        if (distance < -rounding * (1 + hypot(cx, cy))) {
            snprintf(message, sizeof message, "(%.10g, %.10g) fulfils the samples but is outside by %.3g",
                     real_to_double(d.x), real_to_double(d.y), -distance * s->size);
            return false;
        }
    }
    return true;
}

/* Twice the area over the square of the diameter's box: 0 for what is thin. */
static double thickness(const struct region_sample *s)
{
    double area = 0, most = 0;
    for (int i = 0; i < s->corners; i++) {
        const double *q = s->corner[i], *r = s->corner[i + 1 < s->corners ? i + 1 : 0], *o = s->corner[0];
        area += (q[0] - o[0]) * (r[1] - o[1]) - (q[1] - o[1]) * (r[0] - o[0]);
        most = fmax(most, hypot(q[0] - o[0], q[1] - o[1]));
    }
    return most > 0 ? area / most / (1 + most) : 0;
}

static bool agrees(const struct region_sample *s, const struct region_problem *p, struct region_workspace *w,
                   const struct region_answer *a, double slack)
{
    if (a->region->kind == REGION_EMPTY) {
        if (s->corners == 0 || thickness(s) < 1e-4 ||
            (a->region->closed_kind >= REGION_BOUNDED &&
             !a->region->strict)) /* a sample passes over single points */
            return true;
        snprintf(message, sizeof message, "empty, but the samples leave (%.10g, %.10g) and more",
                 s->x0 + s->size * s->corner[0][0], s->y0 + s->size * s->corner[0][1]);
        return false;
    }
    return edges_hold(s, a, slack) && corners_inside(s, p, w, a);
}

/* A sample that leaves too much is made denser before it is believed. */
const char *region_check_sample(const struct region_problem *p, struct region_workspace *w,
                                const struct region_answer *a)
{
    struct region_sample s;
    struct region_problem plain = *p;
    bool good = p->loop_free || a->outcome != SOLVED; /* the sample knows nothing of loops */
    double tolerance = real_to_double(p->tolerance > 0 ? p->tolerance : real_ldexp(1, -20));
    double slack = a->method == region_methods[0] ? 0 : 32 * tolerance;
    int per_span = PER_SPAN;
    for (int i = 0; i < REFINEMENTS && !good; i++) {
        region_sample_make(&s, &plain, per_span);
        good = agrees(&s, p, w, a, slack);
        region_sample_clear(&s);
        per_span *= 8;
    }
    return good ? NULL : message;
}
