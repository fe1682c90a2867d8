/* Shared arcs.  Both curves run over one irreducible curve F, f = F(phi(t)), g = F(psi(s)) with rational phi
 * and psi (Lueroth), so the common component is the numerator of phi(t) - psi(s).  Between its critical
 * parameters each of phi, psi is monotone: two monotone pieces share the meeting of their value ranges. */
#include "exact_overlap.h"

#include <stdlib.h>
#include <flint/fmpz_mpoly.h>

enum {
    PREC_BREAK = 384,   /* of the critical parameters */
    PREC_END = 256,     /* of an end inside a piece */
    PREC_LAST = 1 << 14 /* of a comparison */
};

/* One side: value = num / den over [0, 1], its critical parameters and between them the monotone pieces. */
struct side {
    fmpz_poly_t num, den, slope; /* slope: num' den - num den' */
    struct root_list breaks;
    int *rising; /* of piece k, between breaks k and k + 1 */
};

struct arcs {
    const struct exact_pair *pair;
    struct biv component;
    struct side side[2]; /* t, s */
};

/* An end of the meeting of two pieces: a critical parameter, or -1 for a place inside the piece. */
struct corner {
    int at[2];
};

struct meeting {
    int piece[2];
    struct corner end[2]; /* by growing t */
    bool merged;
};

struct meeting_list {
    int count;
    struct meeting *at;
};

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

/* ---- the common component ---- */

static void to_mpoly(fmpz_mpoly_t to, const struct biv *p, const fmpz_mpoly_ctx_t ctx)
{
    fmpz_mpoly_zero(to, ctx);
    for (int i = 0; i <= p->n; i++)
        for (int j = 0; j <= p->m; j++)
            if (!fmpz_is_zero(biv_at(p, i, j))) {
                ulong power[2] = {(ulong)i, (ulong)j};
                fmpz_mpoly_set_coeff_fmpz_ui(to, biv_at(p, i, j), power, ctx);
            }
}

static void from_mpoly(struct biv *to, const fmpz_mpoly_t p, const fmpz_mpoly_ctx_t ctx)
{
    slong n = fmpz_mpoly_degree_si(p, 0, ctx), m = fmpz_mpoly_degree_si(p, 1, ctx);
    biv_init(to, n > 0 ? (int)n : 0, m > 0 ? (int)m : 0);
    for (int i = 0; i <= to->n; i++)
        for (int j = 0; j <= to->m; j++) {
            ulong power[2] = {(ulong)i, (ulong)j};
            fmpz_mpoly_get_coeff_fmpz_ui(biv_at(to, i, j), p, power, ctx);
        }
}

/* gcd(p, q), p / gcd, q / gcd; all initialised here. */
static bool split_component(struct biv *common, struct biv *p1, struct biv *q1, const struct biv *p,
                            const struct biv *q)
{
    fmpz_mpoly_ctx_t ctx;
    fmpz_mpoly_t a, b, g;
    fmpz_mpoly_ctx_init(ctx, 2, ORD_LEX);
    fmpz_mpoly_init(a, ctx);
    fmpz_mpoly_init(b, ctx);
    fmpz_mpoly_init(g, ctx);
    to_mpoly(a, p, ctx);
    to_mpoly(b, q, ctx);
    bool done =
        fmpz_mpoly_gcd(g, a, b, ctx) && fmpz_mpoly_divides(a, a, g, ctx) && fmpz_mpoly_divides(b, b, g, ctx);
    from_mpoly(common, g, ctx);
    from_mpoly(p1, a, ctx);
    from_mpoly(q1, b, ctx);
    fmpz_mpoly_clear(a, ctx);
    fmpz_mpoly_clear(b, ctx);
    fmpz_mpoly_clear(g, ctx);
    fmpz_mpoly_ctx_clear(ctx);
    return done;
}

/* ---- phi and psi ---- */

static void set_slope(struct side *d)
{
    fmpz_poly_t a, b;
    fmpz_poly_init(a);
    fmpz_poly_init(b);
    fmpz_poly_derivative(a, d->num);
    fmpz_poly_mul(a, a, d->den);
    fmpz_poly_derivative(b, d->den);
    fmpz_poly_mul(b, b, d->num);
    fmpz_poly_sub(d->slope, a, b);
    fmpz_poly_clear(a);
    fmpz_poly_clear(b);
}

/* Is the value finite at 0, at 1 and at every turning point? */
static bool poles_are_regular(const struct side *d)
{
    fmpz_poly_t g;
    fmpz_t v;
    fmpz_poly_init(g);
    fmpz_init(v);
    fmpz_poly_gcd(g, d->den, d->slope);
    bool regular = !fmpz_poly_is_zero(d->slope) && fmpz_poly_degree(g) == 0;
    fmpz_set_si(v, 1);
    fmpz_poly_evaluate_fmpz(v, d->den, v);
    regular = regular && !fmpz_is_zero(v);
    fmpz_poly_get_coeff_fmpz(v, d->den, 0);
    regular = regular && !fmpz_is_zero(v);
    fmpz_poly_clear(g);
    fmpz_clear(v);
    return regular;
}

/* phi = C(t, a) / C(t, b) up to a Moebius map, and psi by the same map from C = phi_num psi_den - phi_den
 * psi_num. */
static bool choose_values(struct arcs *k, const struct biv *swapped, int a, int b)
{
    struct side *t = &k->side[0], *s = &k->side[1];
    fmpz_poly_t c1, c2, u;
    fmpz_t a1, b1, a2, b2;
    fmpq_t x;
    fmpz_poly_init(c1);
    fmpz_poly_init(c2);
    fmpz_poly_init(u);
    fmpz_init(a1), fmpz_init(b1), fmpz_init(a2), fmpz_init(b2);
    fmpq_init(x);
    fmpq_set_si(x, a, 1);
    biv_restrict_t(t->num, swapped, x);
    fmpq_set_si(x, b, 1);
    biv_restrict_t(t->den, swapped, x);
    const int place[2] = {a + 1, -2 * a};
    for (int i = 0; i < 2; i++) {
        fmpq_set_si(x, place[i], 1);
        biv_restrict_t(i ? c2 : c1, &k->component, x);
        fmpz_poly_evaluate_fmpz(i ? a2 : a1, t->num, fmpq_numref(x));
        fmpz_poly_evaluate_fmpz(i ? b2 : b1, t->den, fmpq_numref(x));
    }
    fmpz_poly_scalar_mul_fmpz(s->den, c1, b2);
    fmpz_poly_scalar_mul_fmpz(u, c2, b1);
    fmpz_poly_sub(s->den, s->den, u);
    fmpz_poly_scalar_mul_fmpz(s->num, c1, a2);
    fmpz_poly_scalar_mul_fmpz(u, c2, a1);
    fmpz_poly_sub(s->num, s->num, u);
    set_slope(t);
    set_slope(s);
    fmpz_poly_clear(c1);
    fmpz_poly_clear(c2);
    fmpz_poly_clear(u);
    fmpz_clear(a1), fmpz_clear(b1), fmpz_clear(a2), fmpz_clear(b2);
    fmpq_clear(x);
    return poles_are_regular(t) && poles_are_regular(s);
}

static bool choose_regular_values(struct arcs *k)
{
    struct biv swapped;
    bool chosen = false;
    biv_swap_variables(&swapped, &k->component);
    for (int b = 2; b < 40 && !chosen; b++)
        for (int sign = -1; sign <= 1 && !chosen; sign += 2)
            chosen = choose_values(k, &swapped, sign * b + 1, sign * b);
    biv_clear(&swapped);
    return chosen;
}

static int by_ball(const void *a, const void *b)
{
    const struct real_root *x = a, *y = b;
    return arf_cmp(arb_midref(x->ball), arb_midref(y->ball));
}

/* Breaks: 0, 1, the zeros of the slope and of the denominator between. */
static void find_pieces(struct side *d)
{
    fmpz_poly_t p, ends;
    fmpq_t mid, other;
    arf_t m;
    fmpz_poly_init(p);
    fmpz_poly_init(ends);
    fmpq_init(mid);
    fmpq_init(other);
    arf_init(m);
    fmpz_poly_set_coeff_si(ends, 1, -1); /* t^2 - t */
    fmpz_poly_set_coeff_si(ends, 2, 1);
    fmpz_poly_mul(p, d->slope, d->den);
    fmpz_poly_mul(p, p, ends);
    root_list_find(&d->breaks, p);
    for (int i = 0; i < d->breaks.count; i++)
        real_root_refine(&d->breaks.at[i], PREC_BREAK, false);
    qsort(d->breaks.at, (size_t)d->breaks.count, sizeof *d->breaks.at, by_ball);
    d->rising = calloc((size_t)d->breaks.count, sizeof *d->rising);
    for (int i = 0; i + 1 < d->breaks.count; i++) {
        arf_add(m, arb_midref(d->breaks.at[i].ball), arb_midref(d->breaks.at[i + 1].ball), PREC_BREAK,
                ARF_RND_NEAR);
        arf_mul_2exp_si(m, m, -1);
        arf_get_fmpq(mid, m);
        fmpz_poly_evaluate_fmpq(other, d->slope, mid);
        d->rising[i] = fmpq_sgn(other) > 0;
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(ends);
    fmpq_clear(mid);
    fmpq_clear(other);
    arf_clear(m);
}

/* ---- values at the breaks ---- */

/* The value at one end of a piece: that of break `index` of `side`, or an infinity. */
struct level {
    int side, index, infinite;
};

static struct level level_of(const struct arcs *k, int side, int piece, bool upper)
{
    const struct side *d = &k->side[side];
    struct level v = {side, d->rising[piece] == upper ? piece + 1 : piece, 0};
    if (real_root_of(&d->breaks.at[v.index], d->den))
        v.infinite = upper ? 1 : -1;
    return v;
}

static void level_polynomial(fmpz_poly_t v, const struct side *d, const struct real_root *r)
{
    fmpz_poly_t p;
    fmpz_poly_init(p);
    if (r->exact) {
        fmpz_poly_set_coeff_fmpz(p, 1, fmpq_denref(r->value));
        fmpz_poly_set_coeff_fmpz(p, 0, fmpq_numref(r->value));
        fmpz_neg(p->coeffs, p->coeffs);
    } else {
        /* Without the poles, where the value has no polynomial. */
        fmpz_poly_gcd(p, r->p, d->den);
        fmpz_poly_div(p, r->p, p);
    }
    exact_value_polynomial(v, p, d->num, d->den);
    fmpz_poly_clear(p);
}

static void level_ball(arb_t v, const struct side *d, struct real_root *r, slong prec)
{
    arb_t b;
    arb_init(b);
    slong work = prec + 64 + labs(fmpz_poly_max_bits(d->num)) + labs(fmpz_poly_max_bits(d->den));
    real_root_refine(r, prec, false);
    fmpz_poly_t const *part[2] = {&d->num, &d->den};
    for (int i = 0; i < 2; i++) {
        arb_ptr to = i ? b : v;
        arb_zero(to);
        for (slong j = fmpz_poly_degree(*part[i]); j >= 0; j--) {
            arb_mul(to, to, r->ball, work);
            arb_add_fmpz(to, to, (*part[i])->coeffs + j, work);
        }
    }
    arb_div(v, v, b, work);
    arb_clear(b);
}

/* -1, 0, 1; 2 when it stays undecided. */
static int compare_levels(struct arcs *k, struct level a, struct level b)
{
    if (a.infinite || b.infinite)
        return (a.infinite > b.infinite) - (a.infinite < b.infinite);
    if (a.side == b.side && a.index == b.index)
        return 0;
    struct side *d = &k->side[a.side], *e = &k->side[b.side];
    struct real_root *x = &d->breaks.at[a.index], *y = &e->breaks.at[b.index];
    arb_t u, v;
    fmpz_poly_t pu, pv;
    arb_init(u);
    arb_init(v);
    fmpz_poly_init(pu);
    fmpz_poly_init(pv);
    level_polynomial(pu, d, x);
    level_polynomial(pv, e, y);
    int order = 2;
    for (slong prec = PREC_BREAK; order == 2 && prec <= PREC_LAST; prec *= 2) {
        level_ball(u, d, x, prec);
        level_ball(v, e, y, prec);
        order = exact_compare(u, pu, v, pv, prec);
    }
    arb_clear(u);
    arb_clear(v);
    fmpz_poly_clear(pu);
    fmpz_poly_clear(pv);
    return order;
}

/* ---- meetings of pieces ---- */

static struct corner corner_at(struct arcs *k, const int piece[2], struct level v, bool *sure)
{
    struct corner c;
    for (int side = 0; side < 2; side++) {
        c.at[side] = -1;
        for (int upper = 0; upper < 2; upper++) {
            struct level own = level_of(k, side, piece[side], upper);
            int order = compare_levels(k, own, v);
            *sure = *sure && order != 2;
            if (order == 0)
                c.at[side] = own.index;
        }
    }
    return c;
}

/* Adds the meeting of two pieces, or the corner where they only touch. */
static bool meet(struct arcs *k, int i, int j, struct meeting_list *m, struct meeting_list *touching)
{
    struct level low[2] = {level_of(k, 0, i, false), level_of(k, 1, j, false)};
    struct level high[2] = {level_of(k, 0, i, true), level_of(k, 1, j, true)};
    int below = compare_levels(k, low[0], low[1]), above = compare_levels(k, high[0], high[1]);
    struct level lo = below < 0 ? low[1] : low[0], hi = above > 0 ? high[1] : high[0];
    int order = compare_levels(k, lo, hi);
    if (below == 2 || above == 2 || order == 2)
        return false;
    if (order > 0)
        return true;
    bool sure = true;
    struct meeting new = {.piece = {i, j}};
    struct meeting_list *to = order < 0 ? m : touching;
    new.end[0] = corner_at(k, new.piece, k->side[0].rising[i] ? lo : hi, &sure);
    new.end[1] = corner_at(k, new.piece, k->side[0].rising[i] ? hi : lo, &sure);
    to->at = realloc(to->at, (size_t)(to->count + 1) * sizeof *to->at);
    to->at[to->count++] = new;
    return sure;
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

/* ---- parameters of the corners ---- */

static int sign_on(const struct biv *c, const arf_t t, const struct real_root *s)
{
    arb_t x, v;
    arb_init(x);
    arb_init(v);
    arb_set_arf(x, t);
    biv_value(v, c, x, s->ball, 2 * PREC_BREAK + biv_bits(c));
    int sign = arb_is_positive(v) ? 1 : arb_is_negative(v) ? -1 : 0;
    arb_clear(x);
    arb_clear(v);
    return sign;
}

/* A short fraction in (lo, hi) that solves c(t, s) = 0 exactly. */
static void recognise_end(struct real_root *r, const struct biv *c, const arf_t lo, const arf_t hi,
                          const struct real_root *s)
{
    fmpq_t a, b;
    fmpz_poly_t p;
    fmpq_init(a);
    fmpq_init(b);
    fmpz_poly_init(p);
    arf_get_fmpq(a, lo);
    arf_get_fmpq(b, hi);
    fmpq_simplest_between(a, a, b);
    biv_restrict_t(p, c, a);
    if (fmpz_bits(fmpq_denref(a)) < PREC_END / 3 && s->exact && real_root_of(s, p))
        real_root_set_exact(r, a);
    fmpq_clear(a);
    fmpq_clear(b);
    fmpz_poly_clear(p);
}

/* The only zero of t -> c(t, s) between two breaks. */
static bool solve_between(struct real_root *r, const struct biv *c, const struct real_root *from,
                          const struct real_root *to, const struct real_root *s)
{
    arf_t lo, hi, mid;
    arf_init(lo);
    arf_init(hi);
    arf_init(mid);
    arb_get_lbound_arf(lo, from->ball, PREC_BREAK);
    arb_get_ubound_arf(hi, to->ball, PREC_BREAK);
    arf_set_round(mid, arb_midref(from->ball), PREC_BREAK, ARF_RND_NEAR);
    int left = sign_on(c, mid, s), sign = left;
    for (int k = 0; k < PREC_END && sign; k++) {
        sign = 0;
        for (int part = 4; part >= 3 && sign == 0; part--) { /* the middle, or 3/8 should that be the zero */
            arf_sub(mid, hi, lo, PREC_BREAK, ARF_RND_NEAR);
            arf_mul_si(mid, mid, part, PREC_BREAK, ARF_RND_NEAR);
            arf_mul_2exp_si(mid, mid, -3);
            arf_add(mid, mid, lo, PREC_BREAK, ARF_RND_NEAR);
            sign = sign_on(c, mid, s);
        }
        if (sign)
            arf_set(sign == left ? lo : hi, mid);
    }
    arb_set_interval_arf(r->ball, lo, hi, PREC_BREAK);
    recognise_end(r, c, lo, hi, s);
    arf_clear(lo);
    arf_clear(hi);
    arf_clear(mid);
    return left != 0 && sign != 0;
}

static bool corner_parameters(struct arcs *k, struct corner c, const int piece[2], struct real_root *t,
                              struct real_root *s)
{
    struct root_list *b[2] = {&k->side[0].breaks, &k->side[1].breaks};
    struct real_root *to[2] = {t, s};
    for (int side = 0; side < 2; side++)
        if (c.at[side] >= 0)
            real_root_set(to[side], &b[side]->at[c.at[side]]);
    if (c.at[0] < 0)
        return solve_between(t, &k->component, &b[0]->at[piece[0]], &b[0]->at[piece[0] + 1], s);
    if (c.at[1] < 0) {
        struct biv swapped;
        biv_swap_variables(&swapped, &k->component);
        bool done = solve_between(s, &swapped, &b[1]->at[piece[1]], &b[1]->at[piece[1] + 1], t);
        biv_clear(&swapped);
        return done;
    }
    return true;
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
        done = done && corner_parameters(k, m->at[i].end[0], m->at[i].piece, &r->t0, &r->s0);
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
        done = done && corner_parameters(k, m->at[i].end[1], m->at[i].piece, &r->t1, &r->s1);
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
            done = meet(k, i, j, &meetings, &touching);
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
    real_root_refine(&c->t, PREC_LAST / 8, false);
    real_root_refine(&c->s, PREC_LAST / 8, false);
    biv_value(v, &k->component, c->t.ball, c->s.ball, PREC_LAST / 8 + biv_bits(&k->component));
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
                                struct range_list *ranges, struct point_list *points)
{
    struct arcs k = {.pair = pair};
    struct biv p1, q1;
    for (int i = 0; i < 2; i++) {
        fmpz_poly_init(k.side[i].num);
        fmpz_poly_init(k.side[i].den);
        fmpz_poly_init(k.side[i].slope);
    }
    const char *trouble = split_component(&k.component, &p1, &q1, p, q) ? NULL : "no common component found";
    if (!trouble && !choose_regular_values(&k))
        trouble = "no regular parameter of the common component found";
    if (!trouble) {
        find_pieces(&k.side[0]);
        find_pieces(&k.side[1]);
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
