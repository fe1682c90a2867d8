/* Not an algorithm: it is told the first three digits of every root and merely takes Newton steps from there,
 * as many as this precision needs.  What nobody can beat who computes roots by evaluating the curves, and so
 * the measure of how far each algorithm is from the limit.
 *
 * Each step at a simple root about doubles the bits that are right.  At a contact the answer is as far off as
 * Newton's method is after so few steps. */
#include "../bezier.h"
#include "../crossings.h"

enum { TOLD_BITS = 10 };

static inline int steps_needed(void)
{
    int steps = 0;
    for (int bits = TOLD_BITS; bits < REAL_BITS; bits *= 2) {
        steps++;
    }
    return steps;
}

/* Value and slope by de Casteljau's algorithm. */
static inline void value_slope(int n, const real *c, real t, real *value, real *slope)
{
    real p[DEGREE_MAX + 1];
    p[0] = c[0];
    p[1] = c[1];
    for (int i = 2; i <= n; i++) {
        p[i] = c[i];
    }
    for (int r = n; r > 1; r--) {
        for (int i = 0; i < r; i++) {
            p[i] = p[i] + t * (p[i + 1] - p[i]);
        }
    }
    *value = p[0] + t * (p[1] - p[0]);
    *slope = n * (p[1] - p[0]);
}

static inline void point_and_tangent(const struct curve *c, real t, real point[2], real tangent[2])
{
    value_slope(c->degree, c->x, t, &point[0], &tangent[0]);
    value_slope(c->degree, c->y, t, &point[1], &tangent[1]);
    if (c->w) {
        real w, slope;
        value_slope(c->degree, c->w, t, &w, &slope);
        for (int k = 0; k < 2; k++) {
            point[k] = point[k] / w;
            tangent[k] = (tangent[k] - point[k] * slope) / w;
        }
    }
}

static inline void step(const struct problem *p, real *t, real *s)
{
    real f[2], g[2], df[2], dg[2];
    point_and_tangent(&p->f, *t, f, df);
    point_and_tangent(&p->g, *s, g, dg);
    real x = g[0] - f[0], y = g[1] - f[1], determinant = dg[0] * df[1] - df[0] * dg[1];
    if (determinant != 0) {
        *t = *t + (dg[0] * y - dg[1] * x) / determinant;
        *s = *s + (df[0] * y - df[1] * x) / determinant;
    }
}

static struct interval around(real t, real tolerance)
{
    struct interval i;
    i.lo = real_min(1, real_max(0, t - tolerance / 2));
    i.hi = real_max(0, real_min(1, t + tolerance / 2));
    return i;
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    const int steps = steps_needed();
    (void)w;
    for (int i = 0; i < p->known_count; i++) {
        const struct known *k = &p->known[i];
        real t = p->swapped ? k->s : k->t, s = p->swapped ? k->t : k->s;
        for (int j = 0; j < steps; j++) {
            step(p, &t, &s);
        }
        struct crossing c;
        c.t = around(t, p->bounds.tolerance_t);
        c.s = around(s, p->bounds.tolerance_s);
        c.standing = CANDIDATE;
        c.at_most = c.multiplicity = 0;
        crossings_add(out, &c);
    }
    return SOLVED;
}

extern const struct intersector newton_floor;
const struct intersector newton_floor = {
    "floor",
    "no algorithm: told three digits of every root, Newton steps from there; the limit of all",
    "none: a yardstick",
    {0, 0, 0, 0},
    intersect,
    NULL,
    true,
    false,
    NULL};
