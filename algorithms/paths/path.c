/* Which segments follow each other. */
#include "../core/twofold.h"
#include "paths.h"

/* a / v = b / w?  v, w > 0. */
static bool same_quotient(real a, real v, real b, real w)
{
    if (v == w) {
        return a == b;
    }
    struct twofold p = exact_product(a, w), q = exact_product(b, v);
    return p.hi == q.hi && p.lo == q.lo;
}

bool path_same_point(const struct curve *c, int i, const struct curve *d, int j)
{
    real v = c->w ? c->w[i] : (real)1, w = d->w ? d->w[j] : (real)1;
    return same_quotient(c->x[i], v, d->x[j], w) && same_quotient(c->y[i], v, d->y[j], w);
}

static bool is_point(const struct curve *c)
{
    for (int i = 1; i <= c->degree; i++) {
        if (!path_same_point(c, 0, c, i)) {
            return false;
        }
    }
    return true;
}

bool path_takes(const struct curve *c)
{
    const real ratio = real_ldexp(1, 256);
    real light = 1, heavy = 1;
    if (c->degree < 1 || c->degree > DEGREE_MAX || c->domain.lo != 0 || c->domain.hi != 1) {
        return false;
    }
    for (int i = 0; i <= c->degree; i++) {
        real w = c->w ? c->w[i] : (real)1;
        if (!(w > 0) || !real_is_finite(w) || !real_is_finite(c->x[i] / w) || !real_is_finite(c->y[i] / w)) {
            return false;
        }
        light = i > 0 ? real_min(light, w) : w;
        heavy = i > 0 ? real_max(heavy, w) : w;
    }
    return heavy / ratio <= light;
}

/* Marks first..last-1, points in one place; one remains if no neighbour goes through it. */
static void mark_points(struct path *path, int first, int last, bool attached)
{
    for (int i = first; i < last; i++) {
        path->next[i] = i == first && !attached ? PATH_END : PATH_POINT;
        if (path->degree && path->next[i] == PATH_POINT) {
            path->degree[i] = 0;
        }
    }
}

void path_link(struct path *path, int first, int last)
{
    const struct curve *c = path->segment;
    int begin = PATH_END, end = PATH_END; /* first and latest that are not passed over */
    for (int i = first; i < last; i++) {
        path->next[i] = path->before[i] = PATH_END;
    }
    for (int i = first, k; i < last; i = k) {
        for (k = i; k < last && is_point(&c[k]) && path_same_point(&c[i], 0, &c[k], 0); k++) {
        }
        if (k == i) {
            k = i + 1;
            continue;
        }
        bool attached = (i > first && path_same_point(&c[i - 1], c[i - 1].degree, &c[i], 0)) ||
                        (k < last && path_same_point(&c[i], 0, &c[k], 0));
        mark_points(path, i, k, attached);
    }
    for (int i = first; i < last; i++) {
        if (path->next[i] == PATH_POINT) {
            continue;
        }
        if (end >= 0 && path_same_point(&c[end], c[end].degree, &c[i], 0)) {
            path->next[end] = i;
            path->before[i] = end;
        }
        begin = begin < 0 ? i : begin;
        end = i;
    }
    if (end >= 0 && !is_point(&c[end]) && path_same_point(&c[end], c[end].degree, &c[begin], 0)) {
        path->next[end] = begin;
        path->before[begin] = end;
    }
}
