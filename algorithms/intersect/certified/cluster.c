/* Contacts of higher order, and cusps: as many solutions as the first derivative of the gap that has one sign says.
 *
 * One node, the graph, is y = gamma(x) over its chord's direction.  The other, the free one, may be anything, a cusp too.
 * With its points (X(t), Y(t)) in that frame, solutions are zeros of G(t) = Y(t) - gamma(X(t)).  Past its ends gamma is
 * continued by its Taylor polynomials of degree SERIES, so G is defined on the whole node.  If the p-th derivative of G is
 * nowhere 0 there, G has at most p zeros, with multiplicity (Rolle); and since a solution of multiplicity k of the pair is a
 * zero of order k of G, the nodes hold at most p solutions.
 *
 * Where: G(t) = sum over k < p of G_k (t - c)^k + G_p(.) (t - c)^p with the Taylor coefficients G_k at any c, so that all
 * zeros are within r of c if |G_p| r^p > sum |G_k| r^k for all |G_p| and all larger r as well, which is so if it holds for
 * r (divide by r^p: the right side falls).  c is sought where G_(p-1) is 0: there r is about the p-th root of the
 * rounding errors when the solutions coincide.
 *
 * All derivatives are enclosed in balls: over the whole node by the range of the control points' differences, at one
 * parameter by de Casteljau's algorithm; composed as power series. */
#include "ball.h"
#include "graphs.h"

/* ---- enclosures of Taylor coefficients by the own parameter ---- */

/* A node in the frame of the graph. */
struct framed {
    int n;
    bool rational;
    real c[3][DEGREE_MAX + 1]; /* x, y, and w if rational; homogeneous */
    real error;                /* of x and y as coordinates, relative to the weights */
    real width;                /* own parameters to local ones */
};

static void frame_node(const struct source *c, const struct node *a, real ex, real ey, real x0, real y0,
                       struct framed *out)
{
    const real *x = a->points, *y = x + c->n + 1, *w = y + c->n + 1;
    out->n = c->n;
    out->rational = c->rational;
    out->width = a->hi - a->lo;
    out->error = 3 * c->node_error; /* |e|_1 <= 1.5, and rounding: 10 u S < E */
    for (int i = 0; i <= c->n; i++) {
        real weight = c->rational ? w[i] : (real)1, dx = x[i] - x0 * weight, dy = y[i] - y0 * weight;
        out->c[0][i] = ex * dx + ey * dy;
        out->c[1][i] = ex * dy - ey * dx;
        out->c[2][i] = weight;
    }
}

/* Largest weight of the node, for errors. */
static real weight_of(const struct framed *a)
{
    real most = a->c[2][0];
    for (int i = 1; i <= a->n; i++) {
        most = real_max(most, a->c[2][i]);
    }
    return most;
}

/* Range of the k-th Taylor coefficient C(n, k) (k-th differences) over the node if at < 0, else its value at `at`. */
static void component_series(const struct framed *a, int component, real at, real error, struct series *out)
{
    real d[DEGREE_MAX + 1], v[DEGREE_MAX + 1], many = 1;
    int n = a->n;
    for (int i = 0; i <= n; i++) {
        d[i] = a->c[component][i];
    }
    for (int k = 0; k <= SERIES; k++) {
        if (k > n) {
            out->c[k] = ball_of(0, 0);
            continue;
        }
        real lo = d[0], hi = d[0], spread = many * error; /* many = C(n, k) 2^k */
        for (int i = 0; i <= n - k; i++) {
            lo = real_min(lo, d[i]);
            hi = real_max(hi, d[i]);
            v[i] = d[i];
        }
        real power = real_ldexp(1, k), times = many / power;
        if (at < 0) {
            out->c[k] = ball_round((lo + hi) / 2 * times, (hi - lo) / 2 * times + spread);
        } else {
            for (int j = n - k; j > 0; j--) {
                for (int i = 0; i < j; i++) {
                    v[i] = (1 - at) * v[i] + at * v[i + 1];
                }
            }
            real size = real_max(real_abs(lo), real_abs(hi));
            out->c[k] = ball_round(v[0] * times, spread + 2 * n * REAL_EPSILON * size * times);
        }
        for (int i = 0; i < n - k; i++) {
            d[i] = d[i + 1] - d[i];
        }
        many = many * 2 * (real)(n - k) / (real)(k + 1);
    }
}

/* x and y of the node over all of it, or at a parameter. */
static void node_series(const struct framed *a, real at, struct series *x, struct series *y)
{
    real weight = a->rational ? weight_of(a) : (real)1;
    component_series(a, 0, at, a->error * weight, x);
    component_series(a, 1, at, a->error * weight, y);
    if (!a->rational) {
        return;
    }
    struct series w, one;
    component_series(a, 2, at, a->error * weight, &w);
    /* one = 1 / w: one[k] = -(sum over j >= 1 of w[j] one[k-j]) / w[0] */
    struct ball first = ball_least(w.c[0]) > 0 ? ball_invert(w.c[0]) : ball_of(0, REAL_HUGE);
    one.c[0] = first;
    for (int k = 1; k <= SERIES; k++) {
        struct ball sum = ball_of(0, 0);
        for (int j = 1; j <= k; j++) {
            sum = ball_subtract(sum, ball_multiply(w.c[j], one.c[k - j]));
        }
        one.c[k] = ball_multiply(sum, first);
    }
    series_multiply(x, 0, &one, x);
    series_multiply(y, 0, &one, y);
}

/* ---- the gap ---- */

/* gamma as a series in x - X(s), for s in the graph's node or at one s; run: the least |X'|. */
static bool graph_series(const struct framed *graph, real at, struct series *gamma, real *run)
{
    struct series x, y, s;
    node_series(graph, at, &x, &y);
    *run = ball_least(x.c[1]);
    if (!(*run > 0)) {
        return false;
    }
    series_revert(&x, &s);
    series_compose(&y, &s, gamma);
    return true;
}

/* Past the ends, up to `beyond`, by Taylor polynomials: the j-th coefficient changes by sum over i > j of C(i, j) gamma_i
 * beyond^(i-j). */
static void graph_continue(struct series *gamma, real beyond)
{
    for (int j = 0; j < SERIES && beyond > 0; j++) {
        real times = 1, power = 1;
        for (int i = j + 1; i <= SERIES; i++) {
            times = times * (real)i / (real)(i - j);
            power = power * beyond;
            gamma->c[j].rad += times * ball_most(gamma->c[i]) * power * (1 + 64 * REAL_EPSILON);
        }
    }
}

/* The constant terms of G are left out. */
static void gap_series(const struct series *x, const struct series *y, const struct series *gamma, struct series *out)
{
    struct series below;
    series_compose(gamma, x, &below);
    for (int k = 1; k <= SERIES; k++) {
        out->c[k] = ball_subtract(y->c[k], below.c[k]);
    }
}

struct touch {
    struct framed graph, loose;
    struct series range;   /* of G over the node */
    struct series gamma;   /* over the graph's node, and continued */
    real swing;            /* |SERIES-th Taylor coefficient| of X over the free node, at most */
    real run;              /* |X'| of the graph, at least; own parameters */
    int order;             /* p */
};

/* How far the free node goes past the graph's ends. */
static real reach_beyond(const struct touch *c)
{
    const struct framed *a = &c->loose, *g = &c->graph;
    real lo = g->c[0][0] / g->c[2][0], hi = g->c[0][g->n] / g->c[2][g->n], beyond = 0;
    if (lo > hi) {
        real swap = lo;
        lo = hi;
        hi = swap;
    }
    for (int i = 0; i <= a->n; i++) {
        real x = a->c[0][i] / a->c[2][i];
        beyond = real_max(beyond, real_max(lo - x, x - hi));
    }
    return beyond > 0 ? beyond + 2 * (a->error + g->error) : 2 * (a->error + g->error);
}

/* The first derivative of G from the second on that is nowhere 0. */
static bool order_of(struct touch *c)
{
    struct series x, y;
    if (!graph_series(&c->graph, -1, &c->gamma, &c->run)) {
        return false;
    }
    graph_continue(&c->gamma, reach_beyond(c));
    node_series(&c->loose, -1, &x, &y);
    gap_series(&x, &y, &c->gamma, &c->range);
    c->swing = ball_most(x.c[SERIES]);
    for (int p = 2; p <= SERIES; p++) {
        if (ball_least(c->range.c[p]) > 0) {
            c->order = p;
            return true;
        }
    }
    return false;
}

/* ---- the place ---- */

struct place {
    real at, as;           /* own parameters of the free node and of the graph */
    struct series x, gap;  /* at them; gap.c[0] is G itself */
    real off;              /* |X(at) - X(as)| at most */
};

/* The graph's own parameter with abscissa x, roughly; from `as`. */
static real graph_parameter(const struct framed *g, real x, real as)
{
    for (int k = 0; k < 4; k++) {
        struct series gx, gy;
        node_series(g, as, &gx, &gy);
        as = clamp(as + (x - gx.c[0].mid) / gx.c[1].mid, 0, 1);
    }
    return as;
}

/* G at c->at: gamma's series belongs to the abscissa of `as`, h less than X(at); its coefficients change by less than
 * |h| (j + 1) gamma_(j+1) over the node. */
static bool place_look(const struct touch *c, struct place *at)
{
    struct series y, gamma, gx, gy;
    real run;
    node_series(&c->loose, at->at, &at->x, &y);
    at->as = graph_parameter(&c->graph, at->x.c[0].mid, at->as);
    node_series(&c->graph, at->as, &gx, &gy);
    if (!graph_series(&c->graph, at->as, &gamma, &run)) {
        return false;
    }
    struct ball h = ball_subtract(at->x.c[0], gx.c[0]);
    real most = ball_most(h);
    struct ball first = ball_multiply(gamma.c[1], h);
    first.rad += ball_most(c->gamma.c[2]) * most * most;
    at->gap.c[0] = ball_subtract(ball_subtract(y.c[0], gamma.c[0]), first);
    struct ball constant = at->gap.c[0];
    for (int j = 1; j < SERIES; j++) {
        gamma.c[j].rad += most * (j + 1) * ball_most(c->gamma.c[j + 1]);
    }
    gap_series(&at->x, &y, &gamma, &at->gap);
    at->gap.c[0] = constant;
    at->off = most;
    return true;
}

/* Are all zeros within r?  By own parameters. */
static bool is_within(const struct touch *c, const struct place *at, real r)
{
    real lower = 0, power = 1;
    for (int k = 0; k < c->order; k++) {
        lower += ball_most(at->gap.c[k]) * power;
        power = power * r;
    }
    return ball_least(c->range.c[c->order]) * power > lower * (1 + 32 * REAL_EPSILON);
}

static bool is_empty(const struct touch *c, const struct place *at)
{
    real more = 0;
    for (int k = 1; k < c->order; k++) {
        more += ball_most(at->gap.c[k]);
    }
    more += ball_most(c->range.c[c->order]);
    return ball_least(at->gap.c[0]) > more * (1 + 32 * REAL_EPSILON);
}

static bool place_find(const struct touch *c, struct place *at)
{
    at->at = at->as = (real)0.5;
    for (int k = 0; k < 4; k++) {
        if (!place_look(c, at)) {
            return false;
        }
        int p = c->order;
        real next = clamp(at->at - at->gap.c[p - 1].mid / (p * at->gap.c[p].mid), 0, 1);
        if (real_abs(next - at->at) <= 4 * at->gap.c[p - 1].rad / real_abs(at->gap.c[p].mid)) {
            break;
        }
        at->at = next;
    }
    return place_look(c, at);
}

/* How far X(t) is from X(at) at most, for t within r. */
static real excursion(const struct touch *c, const struct place *at, real r)
{
    real sum = 0, power = r;
    for (int k = 1; k < SERIES; k++) {
        sum += ball_most(at->x.c[k]) * power;
        power = power * r;
    }
    return sum + c->swing * power;
}

static enum verdict settle_one_way(struct solver *z, int level, const struct node *f, const struct node *g,
                                   const struct touch *c, bool f_is_graph)
{
    const real least = real_ldexp(1, -REAL_BITS), most = (real)1 / 8;
    struct place at;
    if (!place_find(c, &at)) {
        return OPEN;
    }
    if (is_empty(c, &at)) {
        return CLOSED;
    }
    real r = most;
    if (!is_within(c, &at, r)) {
        return OPEN;
    }
    while (r > least && is_within(c, &at, r / 2)) {
        r = r / 2;
    }
    real rs = (excursion(c, &at, r) + at.off) / c->run;
    const struct node *loose = f_is_graph ? g : f, *graph = f_is_graph ? f : g;
    real t = loose->lo + (loose->hi - loose->lo) * at.at, s = graph->lo + (graph->hi - graph->lo) * at.as;
    real rt = r * (loose->hi - loose->lo) * (1 + 8 * REAL_EPSILON) + REAL_EPSILON;
    rs = rs * (graph->hi - graph->lo) * (1 + 8 * REAL_EPSILON) + REAL_EPSILON;
    struct zero x = {t, s, rt, rs};
    if (f_is_graph) {
        struct zero swapped = {s, t, rs, rt};
        x = swapped;
    }
    return region_settle(z, level, f, g, &x, c->order);
}

enum verdict cluster_settle(struct solver *z, int level, const struct node *f, const struct node *g)
{
    const struct level *v = &z->level[level];
    for (int way = 0; way < 2; way++) {
        const struct node *graph = way ? f : g, *loose = way ? g : f;
        const struct source *graph_of = way ? &v->f : &v->g, *loose_of = way ? &v->g : &v->f;
        struct touch c;
        if (graph->wide) {
            continue;
        }
        int n = graph_of->n;
        const real *x = graph->points, *y = x + n + 1;
        real first = graph_of->rational ? y[n + 1] : (real)1, last = graph_of->rational ? y[2 * n + 1] : (real)1;
        real x0 = x[0] / first, y0 = y[0] / first, ex = x[n] / last - x0, ey = y[n] / last - y0;
        real length = real_sqrt(ex * ex + ey * ey);
        if (!(length > 0)) {
            continue;
        }
        frame_node(graph_of, graph, ex / length, ey / length, x0, y0, &c.graph);
        frame_node(loose_of, loose, ex / length, ey / length, x0, y0, &c.loose);
        if (order_of(&c) && settle_one_way(z, level, f, g, &c, way) == CLOSED) {
            return CLOSED;
        }
    }
    return OPEN;
}
