/* Shared arcs, and the common points beside them. */
#include "exact_arcs.h"
#include "exact_parameter.h"

#include <stdlib.h>

enum { PREC_BESIDE = 1 << 11, SPARE_BITS = 128 };

void range_list_clear(struct range_list *l)
{
    for (int i = 0; i < l->count; i++) {
        real_root_clear(&l->at[i].t0);
        real_root_clear(&l->at[i].t1);
        real_root_clear(&l->at[i].s0);
        real_root_clear(&l->at[i].s1);
    }
    free(l->at);
    *l = (struct range_list){0};
}

static bool same_corner(struct corner a, struct corner b)
{
    return a.at[0] == b.at[0] && a.at[1] == b.at[1];
}

static int direction(const struct arcs *k, const struct meeting *a)
{
    return k->side[0].rising[a->piece[0]] == k->side[1].rising[a->piece[1]] ? 1 : -1;
}

/* Does b go on where a ends, t growing and s in the same sense? */
static bool continues(const struct arcs *k, const struct meeting *a, const struct meeting *b)
{
    struct corner e = a->end[1];
    if (b->merged || a == b || !same_corner(e, b->end[0]) || direction(k, a) != direction(k, b))
        return false;
    int next = direction(k, a);
    bool t_goes_on = e.at[0] >= 0 ? b->piece[0] == a->piece[0] + 1 : b->piece[0] == a->piece[0];
    bool s_goes_on = e.at[1] >= 0 ? b->piece[1] == a->piece[1] + next : b->piece[1] == a->piece[1];
    return t_goes_on && s_goes_on && (e.at[0] >= 0 || e.at[1] >= 0);
}

static void merge(const struct arcs *k, struct meeting_list *m)
{
    for (int i = 0; i < m->count; i++)
        for (int j = 0; j < m->count && !m->at[i].merged; j++)
            if (continues(k, &m->at[i], &m->at[j])) {
                struct meeting *a = &m->at[i], *b = &m->at[j];
                /* a takes over b's end; its piece numbers follow, they are of use only at that end. */
                a->end[1] = b->end[1];
                a->piece[0] = b->piece[0];
                a->piece[1] = b->piece[1];
                b->merged = true;
                j = -1;
            }
}

/* Every meeting as a range; false if an end could not be computed.  The lower ends are computed before
 * merging. */
static bool collect_ranges(struct arcs *k, struct meeting_list *m, struct range_list *l)
{
    struct exact_range *range = calloc((size_t)m->count + 1, sizeof *range);
    bool done = true;
    for (int i = 0; i < m->count; i++) {
        struct exact_range *r = &range[i];
        real_root_init(&r->t0);
        real_root_init(&r->t1);
        real_root_init(&r->s0);
        real_root_init(&r->s1);
        done = done && arcs_corner(k, m->at[i].end[0], m->at[i].piece, &r->t0, &r->s0);
    }
    merge(k, m);
    l->at = range;
    l->count = 0;
    for (int i = 0; i < m->count; i++) {
        struct exact_range *r = &range[i];
        if (m->at[i].merged) {
            real_root_clear(&r->t0);
            real_root_clear(&r->t1);
            real_root_clear(&r->s0);
            real_root_clear(&r->s1);
            continue;
        }
        done = done && arcs_corner(k, m->at[i].end[1], m->at[i].piece, &r->t1, &r->s1);
        l->at[l->count++] = *r;
    }
    return done;
}

static bool is_corner(const struct meeting_list *m, struct corner c)
{
    for (int i = 0; i < m->count; i++)
        if (same_corner(m->at[i].end[0], c) || same_corner(m->at[i].end[1], c))
            return true;
    return false;
}

static void collect_touching(struct arcs *k, const struct meeting_list *m,
                             const struct meeting_list *touching, struct point_list *points)
{
    for (int i = 0; i < touching->count; i++) {
        struct corner c = touching->at[i].end[0];
        struct meeting_list earlier = {i, touching->at};
        if (is_corner(m, c) || is_corner(&earlier, c))
            continue;
        struct real_root *t = &k->side[0].breaks.at[c.at[0]], *s = &k->side[1].breaks.at[c.at[1]];
        struct exact_point *p = point_list_append(points, t, s);
        p->order_f = real_root_order(t, k->pair->f.stationary);
        p->order_g = real_root_order(s, k->pair->g.stationary);
    }
}

static const char *find_arcs(struct arcs *k, struct range_list *ranges, struct point_list *points)
{
    struct meeting_list meetings = {0}, touching = {0};
    bool done = true;
    for (int i = 0; i + 1 < k->side[0].breaks.count && done; i++)
        for (int j = 0; j + 1 < k->side[1].breaks.count && done; j++)
            done = arcs_meet(k, i, j, &meetings, &touching);
    if (done) {
        struct meeting_list all = {0};
        all.at = malloc(((size_t)meetings.count + 1) * sizeof *all.at);
        for (int i = 0; i < meetings.count; i++)
            all.at[all.count++] = meetings.at[i];
        done = collect_ranges(k, &meetings, ranges);
        collect_touching(k, &all, &touching, points);
        free(all.at);
    }
    free(meetings.at);
    free(touching.at);
    return done ? NULL : "the ends of an overlap stayed undecided";
}

/* Does the component pass through the point?  Exact where a parameter is rational, else by balls: 1, 0, or -1
 * for undecided. */
static int on_component(const struct arcs *k, struct exact_point *c)
{
    fmpz_poly_t line;
    arb_t v;
    fmpz_poly_init(line);
    arb_init(v);
    real_root_refine(&c->t, PREC_BESIDE, false);
    real_root_refine(&c->s, PREC_BESIDE, false);
    biv_value(v, &k->component, c->t.ball, c->s.ball, PREC_BESIDE + biv_bits(&k->component));
    int on = arb_contains_zero(v) ? -1 : 0;
    if (on && c->t.exact) {
        biv_restrict_t(line, &k->component, c->t.value);
        on = real_root_of(&c->s, line);
    } else if (on && c->s.exact) {
        struct biv swapped;
        biv_swap_variables(&swapped, &k->component);
        biv_restrict_t(line, &swapped, c->s.value);
        on = real_root_of(&c->t, line);
        biv_clear(&swapped);
    }
    fmpz_poly_clear(line);
    arb_clear(v);
    return on;
}

/* Common zeros beside the component: those of p1, q1 where the component is not 0. */
static const char *find_beside(const struct arcs *k, const struct biv *p1, const struct biv *q1,
                               struct point_list *points)
{
    struct exact_system e = {.p = *p1, .q = *q1, .pair = k->pair, .whole = false};
    struct point_list all = {0};
    if (p1->n + p1->m == 0 || q1->n + q1->m == 0)
        return NULL;
    const char *trouble = exact_system_solve(&e, &all);
    for (int i = 0; i < all.count && !trouble; i++) {
        int on = on_component(k, &all.at[i]);
        if (on < 0)
            trouble = "a common point may lie on the overlap";
        if (on != 0)
            continue;
        all.at[i].multiplicity = exact_multiplicity(&e, &all.at[i]);
        if (all.at[i].multiplicity == 0)
            trouble = "the multiplicity of a common point stayed undecided";
        struct exact_point *c = point_list_append(points, &all.at[i].t, &all.at[i].s);
        c->multiplicity = all.at[i].multiplicity;
        c->order_f = all.at[i].order_f;
        c->order_g = all.at[i].order_g;
    }
    point_list_clear(&all);
    return trouble;
}

const char *exact_overlap_solve(const struct exact_pair *pair, const struct biv *p, const struct biv *q,
                                int digits, struct range_list *ranges, struct point_list *points)
{
    struct arcs k = {.pair = pair, .bits = parameter_bits(digits) + SPARE_BITS};
    struct biv p1, q1;
    for (int i = 0; i < 2; i++) {
        fmpz_poly_init(k.side[i].num);
        fmpz_poly_init(k.side[i].den);
        fmpz_poly_init(k.side[i].slope);
    }
    const char *trouble =
        arcs_split_component(&k.component, &p1, &q1, p, q) ? NULL : "no common component found";
    if (!trouble && !arcs_choose_values(&k))
        trouble = "no regular parameter of the common component found";
    if (!trouble) {
        arcs_find_pieces(&k.side[0]);
        arcs_find_pieces(&k.side[1]);
        trouble = find_arcs(&k, ranges, points);
    }
    if (!trouble)
        trouble = find_beside(&k, &p1, &q1, points);
    for (int i = 0; i < 2; i++) {
        fmpz_poly_clear(k.side[i].num);
        fmpz_poly_clear(k.side[i].den);
        fmpz_poly_clear(k.side[i].slope);
        root_list_clear(&k.side[i].breaks);
        free(k.side[i].rising);
    }
    biv_clear(&k.component);
    biv_clear(&p1);
    biv_clear(&q1);
    return trouble;
}
