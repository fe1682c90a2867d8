/* Records against solutions found with 113 bits: what fuzz_library.c believes of an answer.
 *
 * Newton's method on the curves of the given doubles (products of weight and coordinate are exact in 113
 * bits).  A place where it converges, with a condition below 2^30, is a solution to about 2^-75. */
#ifndef FATLINE_FUZZ_REFEREE_H
#define FATLINE_FUZZ_REFEREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../algorithms/fatline.h"

typedef __float128 quad;

/* Control points divided by the largest coordinate of both curves. */
struct quad_curve {
    int n;
    quad x[FATLINE_DEGREE_MAX + 1], y[FATLINE_DEGREE_MAX + 1], w[FATLINE_DEGREE_MAX + 1];
};

struct quad_spot {
    quad x, y, dx, dy;
};

struct quad_root {
    quad t, s;
};

static quad quad_abs(quad a)
{
    return a < 0 ? -a : a;
}

static void quad_curve_make(const struct fatline_curve *c, quad size, struct quad_curve *out)
{
    quad heavy = 0;
    out->n = c->degree;
    for (int i = 0; c->weights && i <= c->degree; i++)
        heavy = c->weights[i] > heavy ? c->weights[i] : heavy;
    for (int i = 0; i <= c->degree; i++) {
        out->w[i] = c->weights ? c->weights[i] / heavy : 1;
        out->x[i] = out->w[i] * (c->points[2 * i] / size);
        out->y[i] = out->w[i] * (c->points[2 * i + 1] / size);
    }
}

/* The value of one homogeneous coordinate and its derivative. */
static void quad_value(int n, const quad *c, quad t, quad *value, quad *slope)
{
    quad b[FATLINE_DEGREE_MAX + 1];
    for (int i = 0; i <= n; i++)
        b[i] = c[i];
    for (int k = n; k > 1; k--)
        for (int i = 0; i < k; i++)
            b[i] += t * (b[i + 1] - b[i]);
    *slope = n * (b[1] - b[0]);
    *value = b[0] + t * (b[1] - b[0]);
}

static void quad_at(const struct quad_curve *c, quad t, struct quad_spot *p)
{
    quad w, dw;
    quad_value(c->n, c->x, t, &p->x, &p->dx);
    quad_value(c->n, c->y, t, &p->y, &p->dy);
    quad_value(c->n, c->w, t, &w, &dw);
    p->x /= w;
    p->y /= w;
    p->dx = (p->dx - p->x * dw) / w;
    p->dy = (p->dy - p->y * dw) / w;
}

/* From *r; false: no convergence to a simple solution that may be called one. */
static bool quad_newton(const struct quad_curve *f, const struct quad_curve *g, struct quad_root *r)
{
    const quad small = (quad)1 / ((quad)(1LL << 60) * (1LL << 36)), condition = 1 << 30;
    for (int k = 0; k < 40; k++) {
        struct quad_spot p, q;
        quad_at(f, r->t, &p);
        quad_at(g, r->s, &q);
        quad x = p.x - q.x, y = p.y - q.y, det = p.dx * q.dy - p.dy * q.dx;
        quad u = quad_abs(p.dx) + quad_abs(p.dy), v = quad_abs(q.dx) + quad_abs(q.dy);
        if (!(quad_abs(det) > 0))
            return false;
        quad dt = (x * q.dy - y * q.dx) / det, ds = (x * p.dy - y * p.dx) / det;
        r->t -= dt;
        r->s -= ds;
        if (!(quad_abs(r->t) < 2 && quad_abs(r->s) < 2))
            return false;
        if (quad_abs(dt) < small && quad_abs(ds) < small)
            return u * v < condition * quad_abs(det) && u * condition > 1 && v * condition > 1;
    }
    return false;
}

/* ---- records ---- */

static const quad quad_pad = (quad)1 / ((quad)(1LL << 60) * (1LL << 10));

static bool quad_inside(double t_lo, double t_hi, double s_lo, double s_hi, const struct quad_root *r,
                        quad pad)
{
    return t_lo - pad <= r->t && r->t <= t_hi + pad && s_lo - pad <= r->s && r->s <= s_hi + pad;
}

static bool crossing_holds(const struct fatline_crossing *c, const struct quad_root *r, quad pad)
{
    return quad_inside(c->t_lo, c->t_hi, c->s_lo, c->s_hi, r, pad);
}

static bool overlap_has(const struct fatline_overlap *o, const struct quad_root *r)
{
    return quad_inside(o->t_outer_lo, o->t_outer_hi, o->s_outer_lo, o->s_outer_hi, r, quad_pad);
}

/* A solution lies in a record, and well inside at most one that claims to know it. */
static bool root_is_told(const struct fatline_answer *a, const struct quad_root *r)
{
    bool told = false;
    int claims = 0;
    for (int i = 0; i < a->count; i++) {
        told = told || crossing_holds(&a->crossing[i], r, quad_pad);
        claims +=
            a->crossing[i].standing != FATLINE_CANDIDATE && crossing_holds(&a->crossing[i], r, -quad_pad);
    }
    for (int i = 0; i < a->overlaps; i++)
        told = told || overlap_has(&a->overlap[i], r);
    return told && claims <= 1;
}

enum { ROOTS_MAX = 64 };

struct quad_roots {
    int count;
    struct quad_root at[ROOTS_MAX];
};

static void roots_add(struct quad_roots *all, const struct quad_root *r)
{
    const quad same = (quad)1 / (1LL << 60);
    for (int i = 0; i < all->count; i++)
        if (quad_abs(all->at[i].t - r->t) < same && quad_abs(all->at[i].s - r->s) < same)
            return;
    if (all->count < ROOTS_MAX)
        all->at[all->count++] = *r;
}

/* A UNIQUE's own solution, sought from its middle.  Where it is too ill-conditioned for us, nothing is said.
 */
static bool unique_is_true(const struct quad_curve *f, const struct quad_curve *g,
                           const struct fatline_crossing *c, struct quad_roots *all)
{
    struct quad_root r = {((quad)c->t_lo + c->t_hi) / 2, ((quad)c->s_lo + c->s_hi) / 2};
    if (!quad_newton(f, g, &r))
        return true;
    roots_add(all, &r);
    return crossing_holds(c, &r, quad_pad);
}

static bool counts_are_true(const struct fatline_answer *a, const struct quad_roots *all)
{
    for (int i = 0; i < a->count; i++) {
        int held = 0;
        for (int k = 0; k < all->count; k++)
            held += crossing_holds(&a->crossing[i], &all->at[k], -quad_pad);
        if (a->crossing[i].standing != FATLINE_CANDIDATE && held > a->crossing[i].at_most)
            return false;
    }
    return true;
}

static quad quad_size(const struct fatline_curve *c, quad size)
{
    for (int i = 0; i < 2 * (c->degree + 1); i++)
        size = quad_abs(c->points[i]) > size ? quad_abs(c->points[i]) : size;
    return size;
}

/* Starts are drawn from the bytes. */
static bool referee_agrees(const struct fatline_curve *f, const struct fatline_curve *g,
                           const struct fatline_answer *a, const uint8_t *data, size_t length)
{
    enum { UNIQUE_MAX = 20 };
    static struct quad_curve p, q;
    struct quad_roots all = {0};
    quad size = quad_size(g, quad_size(f, 0));
    uint64_t hash = 14695981039346656037u;
    if (!(size > 0))
        return true;
    quad_curve_make(f, size, &p);
    quad_curve_make(g, size, &q);
    for (int i = 0; i < a->count && i < UNIQUE_MAX; i++)
        if (a->crossing[i].standing == FATLINE_UNIQUE && !unique_is_true(&p, &q, &a->crossing[i], &all))
            return false;
    for (size_t i = 0; i < length; i++)
        hash = (hash ^ data[i]) * 1099511628211u;
    for (int k = 0; k < (f->degree + g->degree > 12 ? 2 : 8); k++) {
        hash = hash * 6364136223846793005u + 1442695040888963407u;
        struct quad_root r = {(quad)(hash >> 48) / 65536, (quad)(hash >> 32 & 65535) / 65536};
        if (quad_newton(&p, &q, &r) && quad_inside(0, 1, 0, 1, &r, 0))
            roots_add(&all, &r);
    }
    for (int k = 0; k < all.count; k++)
        if (!root_is_told(a, &all.at[k]))
            return false;
    return counts_are_true(a, &all);
}

#endif
