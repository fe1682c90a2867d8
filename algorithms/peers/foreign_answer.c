/* See foreign_answer.h. */
#include "foreign_answer.h"

#include <math.h>

#include "../crossings.h"

#define FOREIGN_BEYOND (1.0 / 65536)

void foreign_curve(const struct curve *c, double *number, struct peer_curve *to)
{
    const int length = c->degree + 1;
    for (int i = 0; i < length; i++) {
        number[2 * i] = c->w ? c->x[i] / c->w[i] : c->x[i];
        number[2 * i + 1] = c->w ? c->y[i] / c->w[i] : c->y[i];
    }
    for (int i = 0; c->w && i < length; i++) {
        number[2 * length + i] = c->w[i];
    }
    to->degree = c->degree;
    to->point = number;
    to->weight = c->w ? number + 2 * length : NULL;
}

/* False if t is none of [0, 1]. */
static bool into_domain(double *t, double beyond)
{
    if (!(*t >= -beyond && *t <= 1 + beyond)) {
        return false;
    }
    *t = *t < 0 ? 0 : *t > 1 ? 1 : *t;
    return true;
}

static void add_root(const struct problem *p, const double root[2], struct crossings *out)
{
    double t = root[0], s = root[1];
    if (into_domain(&t, fmax(p->bounds.tolerance_t, FOREIGN_BEYOND)) &&
        into_domain(&s, fmax(p->bounds.tolerance_s, FOREIGN_BEYOND))) {
        const struct crossing c = {{t, t}, {s, s}, CANDIDATE, 0, 0};
        crossings_add(out, &c);
    }
}

/* Both curves lie in one box of half width scale. */
static void add_overlap(const struct problem *p, const double *ends, struct crossings *out)
{
    const double from = ends[2] < ends[3] ? ends[2] : ends[3], to = ends[2] < ends[3] ? ends[3] : ends[2];
    if (out->overlaps < OVERLAPS_MAX) {
        struct overlap *o = &out->overlap[out->overlaps++];
        o->t_outer.lo = o->t_inner.lo = fmin(ends[0], ends[1]);
        o->t_outer.hi = o->t_inner.hi = fmax(ends[0], ends[1]);
        o->s_outer.lo = o->s_inner.lo = from;
        o->s_outer.hi = o->s_inner.hi = to;
        o->reversed = (ends[0] < ends[1]) != (ends[2] < ends[3]);
        o->exact = false;
        o->distance = 4 * p->bounds.scale;
    }
}

enum outcome foreign_answer(const struct problem *p, enum peer_outcome outcome,
                            const struct peer_roots *roots, struct crossings *out)
{
    static const double all[4] = {0, 1, 0, 1};
    if (outcome != PEER_SOLVED) {
        return outcome == PEER_REFUSED ? UNSUPPORTED : GAVE_UP;
    }
    for (int i = 0; i < roots->count && i < PEER_ROOTS; i++) {
        add_root(p, roots->root[i], out);
    }
    for (int i = 0; i < roots->overlaps && i < PEER_OVERLAPS; i++) {
        add_overlap(p, roots->overlap[i], out);
    }
    if (roots->coincident) {
        add_overlap(p, all, out);
    }
    return roots->count > PEER_ROOTS ? OUT_OF_ROOM : SOLVED;
}
