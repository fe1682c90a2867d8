/* Eight pairs of parts of one pair of cubics at a time: crowd.h.
 *
 * Rounding: a node is cut from the curve and halved once before the next round cuts its halves anew, and
 * lines and parabolas came raised as for a batch: the bounds are those of batch_kernel.h. */
#if defined(__x86_64__) && !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)

#define LANES 8
#include "crowd.h"

#include "batch_nodes.h"

enum { ROUNDS_OF_CROWD = 8, SOLVES_OF_CROWD = 64 };

struct nodes {
    int count;
    double f[2 * CROWD_MAX + CROWD_SLACK], g[2 * CROWD_MAX + CROWD_SLACK];
};

/* Nodes whose directions all cross the same way, as in struct batch_solves. */
struct crossed {
    int count;
    double f[SOLVES_OF_CROWD + LANES], g[SOLVES_OF_CROWD + LANES];
    double t[SOLVES_OF_CROWD + LANES], s[SOLVES_OF_CROWD + LANES];
    double reach_t[SOLVES_OF_CROWD + LANES], reach_s[SOLVES_OF_CROWD + LANES];
    double bend_f[SOLVES_OF_CROWD + LANES], bend_g[SOLVES_OF_CROWD + LANES];
};

struct crowd_work {
    struct front *z;
    struct arc f, g; /* the same in each lane */
    wide unit;
    struct crossed crossed;
};

LANES_INLINE void arc_spread(const double x[4], const double y[4], struct arc *out)
{
#pragma GCC unroll 4
    for (int i = 0; i < 4; i++) {
        out->x[i] = wide_of(x[i]);
        out->y[i] = wide_of(y[i]);
    }
}

/* ---- zeros ---- */

/* LANES of them from number `first` on. */
LANES_INLINE void hunt_of(const struct crowd_work *a, int first, struct hunt *h)
{
    const struct crossed *q = &a->crossed;
    int count = q->count - first;
    wide code_f = wide_load(q->f + first), code_g = wide_load(q->g + first);
    h->active = wide_first(count);
    h->unit = a->unit;
    h->arc[0] = a->f;
    h->arc[1] = a->g;
    h->t = wide_load(q->t + first);
    h->s = wide_load(q->s + first);
    h->f.lo = code_start(code_f);
    h->f.hi = h->f.lo + code_width(code_f);
    h->f.reach = wide_load(q->reach_t + first);
    h->f.bend = wide_load(q->bend_f + first);
    h->g.lo = code_start(code_g);
    h->g.hi = h->g.lo + code_width(code_g);
    h->g.reach = wide_load(q->reach_s + first);
    h->g.bend = wide_load(q->bend_g + first);
}

/* Is the zero next to a cut? */
static bool is_near_cut(struct interval node, double t, double radius)
{
    return (node.lo > 0 && t - radius <= node.lo) || (node.hi < 1 && t + radius >= node.hi);
}

/* false: too much is open */
LANES_INLINE bool tell(struct crowd_work *a, int first, const struct hunt *h, wide_mask proved, wide rt,
                       wide rs)
{
    double t[LANES], s[LANES], radius_t[LANES], radius_s[LANES];
    wide_store(t, h->t);
    wide_store(s, h->s);
    wide_store(radius_t, rt);
    wide_store(radius_s, rs);
    for (unsigned bits = wide_bits(h->active); bits; bits &= bits - 1) {
        int i = __builtin_ctz(bits);
        struct interval node_f = span_of_node(a->crossed.f[first + i]),
                        node_g = span_of_node(a->crossed.g[first + i]);
        bool told = wide_bits(proved) >> i & 1 && !is_near_cut(node_f, t[i], radius_t[i]) &&
                    !is_near_cut(node_g, s[i], radius_s[i]) &&
                    front_zero(a->z, t[i], radius_t[i], s[i], radius_s[i]);
        if (!told && !front_leave(a->z, node_f, node_g)) {
            return false;
        }
    }
    return true;
}

/* All that wait; false: too much is open. */
LANES_TARGET static bool solve_crossed(struct crowd_work *a)
{
    enum { STEPS = 7 };
    struct powers p[2];
    powers_component(a->f.x, p[0].x);
    powers_component(a->f.y, p[0].y);
    powers_component(a->g.x, p[1].x);
    powers_component(a->g.y, p[1].y);
    for (int first = 0; first < a->crossed.count; first += LANES) {
        struct hunt h;
        wide rt, rs;
        hunt_of(a, first, &h);
        wide_mask moving = h.active;
        for (int k = 0; k < STEPS && wide_bits(moving); k++) {
            approach(&p[0], &p[1], &h, &moving);
        }
        wide_mask proved = hunt_end(&h, &rt, &rs);
        if (!tell(a, first, &h, proved, rt, rs)) {
            return false;
        }
    }
    a->crossed.count = 0;
    return true;
}

LANES_INLINE void cross_push(struct crossed *q, wide_mask which, wide code_f, wide code_g,
                             const struct arc *f, const struct arc *g, const struct cone *c)
{
    struct start start;
    start_of(code_f, code_g, f, g, c, &start);
    int to = q->count;
    wide_store(q->f + to, wide_pack(which, code_f));
    wide_store(q->g + to, wide_pack(which, code_g));
    wide_store(q->t + to, wide_pack(which, start.t));
    wide_store(q->s + to, wide_pack(which, start.s));
    wide_store(q->reach_t + to, wide_pack(which, start.reach_t));
    wide_store(q->reach_s + to, wide_pack(which, start.reach_s));
    wide_store(q->bend_f + to, wide_pack(which, start.bend_f));
    wide_store(q->bend_g + to, wide_pack(which, start.bend_g));
    q->count += __builtin_popcount(wide_bits(which));
}

/* ---- nodes ---- */

LANES_INLINE void node_push(struct nodes *to, wide_mask which, wide code_f, wide code_g)
{
    wide_store(to->f + to->count, wide_pack(which, code_f));
    wide_store(to->g + to->count, wide_pack(which, code_g));
    to->count += __builtin_popcount(wide_bits(which));
}

/* LANES nodes from number `first` on. */
LANES_INLINE void nodes_settle(struct crowd_work *a, const struct nodes *from, int first, struct nodes *to)
{
    struct arc part_f, part_g;
    struct cone c;
    wide_mask there = wide_first(from->count - first);
    wide code_f = wide_select(there, wide_load(from->f + first), wide_of(1)),
         code_g = wide_select(there, wide_load(from->g + first), wide_of(1));
    cut(&a->f, code_start(code_f), code_width(code_f), &part_f);
    cut(&a->g, code_start(code_g), code_width(code_g), &part_g);
    cone_of(&part_f, &part_g, a->unit, &c);
    wide_mask single = there & wide_less(wide_of(0), c.gap), rest = there & ~single;
    if (wide_bits(single)) {
        cross_push(&a->crossed, single, code_f, code_g, &part_f, &part_g, &c);
    }
    if (wide_bits(rest)) {
        struct halved h;
        halve_longer(code_f, code_g, a->unit, &part_f, &part_g, &c, &h);
        node_push(to, rest & h.meet[0], h.f[0], h.g[0]);
        node_push(to, rest & h.meet[1], h.f[1], h.g[1]);
    }
}

LANES_TARGET bool crowd_settle_avx512(struct crowd *c, struct front *z, int last_step)
{
    struct crowd_work a;
    struct nodes list[2];
    int now = 0;
    a.z = z;
    a.unit = wide_of(c->unit);
    a.crossed.count = 0;
    arc_spread(c->x[0], c->y[0], &a.f);
    arc_spread(c->x[1], c->y[1], &a.g);
    list[0].count = c->count;
    memcpy(list[0].f, c->f, (size_t)c->count * sizeof(double));
    memcpy(list[0].g, c->g, (size_t)c->count * sizeof(double));
    for (int round = 0; round < ROUNDS_OF_CROWD; round++, now = !now) {
        struct nodes *from = &list[now], *to = &list[!now];
        if (from->count < CROWD_LEAST || from->count > CROWD_MAX || z->steps + from->count > last_step) {
            break;
        }
        z->steps += from->count;
        to->count = 0;
        for (int first = 0; first < from->count; first += LANES) {
            nodes_settle(&a, from, first, to);
            if (a.crossed.count > SOLVES_OF_CROWD - LANES && !solve_crossed(&a)) {
                return false;
            }
        }
    }
    c->count = list[now].count;
    memcpy(c->f, list[now].f, (size_t)c->count * sizeof(double));
    memcpy(c->g, list[now].g, (size_t)c->count * sizeof(double));
    return solve_crossed(&a);
}

#endif
