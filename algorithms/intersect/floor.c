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

static inline void step(const struct curve *a, const struct curve *b, real *t, real *s)
{
    real f[2], g[2], df[2], dg[2];
    point_and_tangent(a, *t, f, df);
    point_and_tangent(b, *s, g, dg);
    real x = g[0] - f[0], y = g[1] - f[1], determinant = dg[0] * df[1] - df[0] * dg[1];
    if (determinant != 0) {
        real one = 1 / determinant;
        *t = *t + (dg[0] * y - dg[1] * x) * one;
        *s = *s + (df[0] * y - df[1] * x) * one;
    }
}

/* For cubics without weights the compiler sees the degrees. */
static inline void newton(const struct curve *a, const struct curve *b, real *t, real *s)
{
    const int steps = steps_needed();
    if (a->degree == 3 && b->degree == 3 && !a->w && !b->w) {
        const struct curve f = {3, a->x, a->y, NULL, a->domain}, g = {3, b->x, b->y, NULL, b->domain};
        for (int j = 0; j < steps; j++) {
            step(&f, &g, t, s);
        }
        return;
    }
    for (int j = 0; j < steps; j++) {
        step(a, b, t, s);
    }
}

static inline struct interval around(real t, real tolerance)
{
    struct interval i;
    i.lo = real_min(1, real_max(0, t - tolerance / 2));
    i.hi = real_max(0, real_min(1, t + tolerance / 2));
    return i;
}

static inline void add(struct crossings *out, real t, real s, real tolerance_t, real tolerance_s)
{
    struct crossing *c = &out->at[out->count++];
    c->t = around(t, tolerance_t);
    c->s = around(s, tolerance_s);
    c->standing = CANDIDATE;
    c->at_most = c->multiplicity = 0;
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    (void)w;
    for (int i = 0; i < p->known_count && i < CROSSINGS_MAX; i++) {
        const struct known *k = &p->known[i];
        real t = p->swapped ? k->s : k->t, s = p->swapped ? k->t : k->s;
        newton(&p->f, &p->g, &t, &s);
        add(out, t, s, p->bounds.tolerance_t, p->bounds.tolerance_s);
    }
    return SOLVED;
}

static inline bool is_whole(const struct interval *domain)
{
    return domain->lo == 0 && domain->hi == 1;
}

/* A limit does not pay for copies: the problem as it came, if it can be taken so. */
static enum front_answer front(const struct problem *p, struct workspace *w, struct crossings *out,
                               struct rest *rest)
{
    const real narrowest = 4 * REAL_EPSILON, widest = (real)1 / 16;
    real tolerance = real_min(widest, real_max(narrowest, p->tolerance)), rests = 0;
    (void)w, (void)rest;
    if (p->known_count < 1 || p->known_count > CROSSINGS_MAX || !is_whole(&p->f.domain) ||
        !is_whole(&p->g.domain) || !(p->tolerance > 0) || p->max_steps <= 0) {
        return FRONT_REFUSED;
    }
    for (int i = 0; i < p->known_count; i++) {
        real t = p->known[i].t, s = p->known[i].s;
        newton(&p->f, &p->g, &t, &s);
        rests += (t - t) + (s - s);
        add(out, t, s, tolerance, tolerance);
    }
    if (!(rests == 0)) { /* a coordinate that is not finite, perhaps */
        out->count = 0;
        return FRONT_REFUSED;
    }
    crossings_sort(out);
    return FRONT_DONE;
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
    NULL,
    front};
