/* Rings: rectangles of parameters all whose solutions lie in a smaller one, the core (cusps.c).
 *
 * That is so whatever became of the core.  So a pair within a ring and beside its core is empty, and what of
 * a CANDIDATE within a ring is beside the core holds no solution. */
#include "certified.h"

static bool within(const struct interval *a, const struct interval *b)
{
    return b->lo <= a->lo && a->hi <= b->hi;
}

static bool overlap(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

/* Arcs that leave a cusp together part slowly: they are halved to a part of the tolerance, or of the core
 * where there is more than the cusps in it. */
static real finer_than(real tolerance, real now, real core, bool more)
{
    const real of_tolerance = (real)1 / 64, of_core = (real)1 / 1024;
    real finer = real_min(now, tolerance * of_tolerance);
    return real_max(more ? real_min(finer, core * of_core) : finer, 4 * REAL_EPSILON);
}

void ring_add(struct solver *z, int level, const struct zero *clear, const struct zero *core, bool more)
{
    const struct level *v = &z->level[level];
    struct ring r = {{2, 2}, {2, 2}, {2, 2}, {2, 2}};
    if (core) {
        r.core_t = level_t(v, core->t - core->rt, core->t + core->rt);
        r.core_s = level_s(v, core->s - core->rs, core->s + core->rs);
    }
    if (region_inner(v, clear, &r.t, &r.s)) {
        const struct bounds *b = &z->p->bounds;
        z->narrow_t = finer_than(b->tolerance_t, z->narrow_t, r.core_t.hi - r.core_t.lo, more);
        z->narrow_s = finer_than(b->tolerance_s, z->narrow_s, r.core_s.hi - r.core_s.lo, more);
        z->ring[z->rings++ % RINGS_MAX] = r;
    }
}

bool is_in_ring(const struct solver *z, const struct interval *t, const struct interval *s)
{
    for (int i = 0; i < z->rings && i < RINGS_MAX; i++) {
        const struct ring *r = &z->ring[i];
        if (within(t, &r->t) && within(s, &r->s) && (!overlap(t, &r->core_t) || !overlap(s, &r->core_s))) {
            return true;
        }
    }
    return false;
}

static struct interval common_part(const struct interval *a, const struct interval *b)
{
    struct interval c = {real_max(a->lo, b->lo), real_min(a->hi, b->hi)};
    return c;
}

void rings_part(struct solver *z)
{
    for (int i = 0; i < z->rings && i < RINGS_MAX; i++) {
        const struct ring *r = &z->ring[i];
        for (int k = 0; k < z->out->count; k++) {
            struct crossing *c = &z->out->at[k];
            if (c->standing != CANDIDATE || !within(&c->t, &r->t) || !within(&c->s, &r->s)) {
                continue;
            }
            c->t = common_part(&c->t, &r->core_t);
            c->s = common_part(&c->s, &r->core_s);
            if (c->t.lo > c->t.hi || c->s.lo > c->s.hi) {
                *c = z->out->at[--z->out->count];
                k--;
            }
        }
    }
}
