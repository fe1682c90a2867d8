/* A chunk of pairs, step by step, each step for all pairs before the next: the curves as they are; those that
 * need it cut in four; what still needs it halved, again and again; and Newton's method for all that came
 * out. */
#ifndef FATLINE_BATCH_STEPS_H
#define FATLINE_BATCH_STEPS_H

#include "batch_nodes.h"

/* ---- lists ---- */

LANES_TARGET static void solve_waiting(struct batch_chunk *z, bool all)
{
    struct batch_solves *q = &z->solves;
    double *const list[] = {q->f, q->g, q->t, q->s, q->reach_t, q->reach_s, q->bend_f, q->bend_g};
    const int lists = sizeof list / sizeof *list;
    int first = 0;
    list_pad_whole(q->pair, q->count);
    for (int k = 0; k < lists; k++) {
        list_pad(list[k], q->count);
    }
    for (; first + 2 * LANES <= q->count || (all && first < q->count); first += 2 * LANES) {
        solve_lanes(z, q, first);
    }
    for (int i = first; i < q->count; i++) {
        q->pair[i - first] = q->pair[i];
    }
    for (int k = 0; k < lists; k++) {
        for (int i = first; i < q->count; i++) {
            list[k][i - first] = list[k][i];
        }
    }
    q->count = first < q->count ? q->count - first : 0;
}

/* Nodes with one zero at most: Newton's method begins where their chords meet. */
LANES_INLINE void push_solve(struct batch_chunk *z, wide_mask which, wide at, wide code_f, wide code_g,
                             const struct arc *f, const struct arc *g, const struct cone *c)
{
    struct batch_solves *q = &z->solves;
    struct start start;
    start_of(code_f, code_g, f, g, c, &start);
    int to = q->count;
    wide_store_whole(q->pair + to, wide_pack(which, at));
    wide_store(q->f + to, wide_pack(which, code_f));
    wide_store(q->g + to, wide_pack(which, code_g));
    wide_store(q->t + to, wide_pack(which, start.t));
    wide_store(q->s + to, wide_pack(which, start.s));
    wide_store(q->reach_t + to, wide_pack(which, start.reach_t));
    wide_store(q->reach_s + to, wide_pack(which, start.reach_s));
    wide_store(q->bend_f + to, wide_pack(which, start.bend_f));
    wide_store(q->bend_g + to, wide_pack(which, start.bend_g));
    q->count += __builtin_popcount(wide_bits(which));
    if (q->count > SOLVES - LANES) {
        solve_waiting(z, false);
    }
}

LANES_INLINE void push_item(struct batch_chunk *z, struct batch_items *to, wide_mask which, wide at,
                            wide code_f, wide code_g)
{
    int count = to->count;
    if (count > ITEMS - LANES) {
        leave_alone(z, which, at);
        return;
    }
    wide_store_whole(to->pair + count, wide_pack(which, at));
    wide_store(to->f + count, wide_pack(which, code_f));
    wide_store(to->g + count, wide_pack(which, code_g));
    to->count = count + __builtin_popcount(wide_bits(which));
}

/* ---- the curves as they are ---- */

/* Not all numbers, too large or too small for the bounds to hold; *unit as in struct batch_chunk.  The sum is
 * no number if one of the coordinates is none, and infinite or none if one is infinite. */
LANES_INLINE wide_mask odd_pairs(const struct arc *f, const struct arc *g, const struct octagon *box_f,
                                 const struct octagon *box_g, wide *unit)
{
    wide sum_x = (f->x[0] + f->x[1]) + (f->x[2] + f->x[3]), sum_y = (f->y[0] + f->y[1]) + (f->y[2] + f->y[3]);
    wide sum_a = (g->x[0] + g->x[1]) + (g->x[2] + g->x[3]), sum_b = (g->y[0] + g->y[1]) + (g->y[2] + g->y[3]);
    wide most = wide_of(0);
#pragma GCC unroll 2
    for (int k = 0; k < 2; k++) {
        wide most_f = wide_max(wide_abs(box_f->low[k]), wide_abs(box_f->high[k]));
        wide most_g = wide_max(wide_abs(box_g->low[k]), wide_abs(box_g->high[k]));
        most = wide_max(most, wide_max(most_f, most_g));
    }
    const double large = 0x1p200, small = 0x1p-200;
    *unit = most * (DBL_EPSILON / 2);
    return ~(wide_less(wide_abs((sum_x + sum_y) + (sum_a + sum_b)), wide_of(2 * LANES * large)) &
             wide_less(most, wide_of(large)) & wide_less(wide_of(small), most));
}

/* The pairs from `first` on. */
LANES_INLINE void load_first(const struct batch_chunk *z, int first, struct arc *f, struct arc *g)
{
    const struct batch *b = z->batch;
    if (first + LANES <= z->count && !b->f_index && !b->g_index) {
        load_next(&b->f, z->first + first, f);
        load_next(&b->g, z->first + first, g);
    } else {
        load_pairs(z, z->all + first, f, g);
    }
}

LANES_TARGET static void begin(struct batch_chunk *z)
{
    const wide root = wide_of(1);
    for (int first = 0; first < z->count; first += LANES) {
        struct arc f, g;
        struct octagon box_f, box_g;
        struct cone c;
        wide unit, at = wide_load_whole(z->all + first);
        wide_mask there = wide_first(z->count - first);
        load_first(z, first, &f, &g);
        octagon_box(&f, &box_f);
        octagon_box(&g, &box_g);
        wide_mask odd = there & odd_pairs(&f, &g, &box_f, &box_g, &unit);
        wide_mask open = there & ~odd & ~boxes_apart(&box_f, &box_g, unit);
        wide_store(z->unit + first, unit);
        if (wide_bits(odd)) {
            leave_alone(z, odd, at);
        }
        if (!wide_bits(open)) {
            continue;
        }
        octagon_corners(&f, &box_f);
        octagon_corners(&g, &box_g);
        open &= ~octagons_apart(&box_f, &box_g, unit);
        if (!wide_bits(open)) {
            continue;
        }
        cone_of(&f, &g, unit, &c);
        wide_mask single = open & wide_less(wide_of(0), c.gap), rest = open & ~single;
        if (wide_bits(single)) {
            push_solve(z, single, at, root, root, &f, &g, &c);
        }
        wide_store_whole(z->crossed_pair + z->crossed, wide_pack(rest, at));
        z->crossed += __builtin_popcount(wide_bits(rest));
    }
}

/* ---- both curves in four ---- */

LANES_INLINE void quarters(const struct arc *c, struct octagon out[4])
{
    struct arc half[2], part[2];
    halve(c, &half[0], &half[1]);
#pragma GCC unroll 2
    for (int k = 0; k < 2; k++) {
        halve(&half[k], &part[0], &part[1]);
        octagon_of(&part[0], &out[2 * k]);
        octagon_of(&part[1], &out[2 * k + 1]);
    }
}

/* From the pair at `first` of the list on, until half the items are used; returns the next. */
LANES_TARGET static int cut_in_four(struct batch_chunk *z, int first, struct batch_items *to)
{
    list_pad_whole(z->crossed_pair, z->crossed);
    to->count = 0;
    for (; first < z->crossed && to->count <= ITEMS / 2; first += LANES) {
        struct arc f, g;
        struct octagon part_f[4], part_g[4];
        wide at = wide_load_whole(z->crossed_pair + first), unit = wide_gather(z->unit, at);
        wide_mask there = wide_first(z->crossed - first);
        load_pairs(z, z->crossed_pair + first, &f, &g);
        quarters(&f, part_f);
        quarters(&g, part_g);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                wide_mask meet = there & ~octagons_apart(&part_f[i], &part_g[j], unit);
                wide_store_whole(to->pair + to->count, wide_pack(meet, at));
                wide_store(to->f + to->count, wide_of(4 + i));
                wide_store(to->g + to->count, wide_of(4 + j));
                to->count += __builtin_popcount(wide_bits(meet));
            }
        }
    }
    return first;
}

/* ---- nodes ---- */

LANES_INLINE void push_halves(struct batch_chunk *z, struct batch_items *to, wide_mask which, wide at,
                              wide code_f, wide code_g, wide unit, const struct arc *f, const struct arc *g,
                              const struct cone *c)
{
    struct halved h;
    halve_longer(code_f, code_g, unit, f, g, c, &h);
#pragma GCC unroll 2
    for (int k = 0; k < 2; k++) {
        push_item(z, to, which & h.meet[k], at, h.f[k], h.g[k]);
    }
}

LANES_TARGET static void settle_items(struct batch_chunk *z, struct batch_items *from, struct batch_items *to)
{
    list_pad_whole(from->pair, from->count);
    list_pad(from->f, from->count);
    list_pad(from->g, from->count);
    for (int first = 0; first < from->count; first += LANES) {
        struct arc f, g, part_f, part_g;
        struct cone c;
        wide at = wide_load_whole(from->pair + first), unit = wide_gather(z->unit, at);
        wide code_f = wide_load(from->f + first), code_g = wide_load(from->g + first);
        wide_mask there = wide_first(from->count - first);
        load_pairs(z, from->pair + first, &f, &g);
        cut(&f, code_start(code_f), code_width(code_f), &part_f);
        cut(&g, code_start(code_g), code_width(code_g), &part_g);
        cone_of(&part_f, &part_g, unit, &c);
        wide_mask single = there & wide_less(wide_of(0), c.gap), rest = there & ~single;
        if (wide_bits(single)) {
            push_solve(z, single, at, code_f, code_g, &part_f, &part_g, &c);
        }
        if (wide_bits(rest)) {
            push_halves(z, to, rest, at, code_f, code_g, unit, &part_f, &part_g, &c);
        }
    }
}

LANES_INLINE void settle_rounds(struct batch_chunk *z)
{
    int now = 0;
    for (int round = 0; round < ROUNDS && z->items[now].count > 0; round++, now = !now) {
        z->items[!now].count = 0;
        settle_items(z, &z->items[now], &z->items[!now]);
    }
    for (int i = 0; i < z->items[now].count; i++) {
        leave_alone(z, wide_first(1), wide_of(z->items[now].pair[i]));
    }
}

LANES_INLINE void settle_chunk(struct batch_chunk *z)
{
    z->crossed = z->solves.count = 0;
    begin(z);
    for (int first = 0; first < z->crossed;) {
        first = cut_in_four(z, first, &z->items[0]);
        settle_rounds(z);
    }
    solve_waiting(z, true);
}

#endif
