/* The Taylor coefficients of the gap with twice the digits.
 *
 * The control points of a level are cut with twice the digits and rounded (zoom.c); here what rounding left
 * off is added again.  So, of nodes that are a level's whole curves, the points of the frame are known to
 *
 *     1.5 e + 64 u^2 S,    e the sources' fine_error:
 *
 * a difference with x0 errs by 3 u^2 of itself, at most 2 S, a product with ex, ey by 7 u^2, their sum by 3
 * u^2, |e|_1 <= 1.5.  The k-th Taylor coefficient at a parameter is C(n, k) times the value of the k-th
 * differences there: with points of at most M known to d, these are known to 2^k (d + 3 k u^2 M), k <= 5, and
 * a step of de Casteljau's algorithm adds at most 12 u^2 2^k M: in all less than 2^k (d + (12 n + 16) u^2 M).
 *
 * The graph's series belongs to a parameter `as` that is known in reals only, so that its abscissa is h less
 * than X(at).  By Taylor's theorem for the j-th coefficient gamma_j of the graph, over abscissas,
 *
 *     gamma_j(X(at)) = gamma_j + (j + 1) gamma_(j+1) h + C(j+2, 2) r h^2,    r in the range of gamma_(j+2),
 *
 * and for the last, j = 5, it is within 6 |h| |gamma_6| of gamma_5.  G_6 stays as it is (gap_model.c). */
#include "fine.h"
#include "gap_model.h"

struct fine_framed {
    int n;
    struct twofold c[2][DEGREE_MAX + 1];
    real error, most;
};

static struct twofold mean(struct twofold v, struct twofold a, struct twofold t, struct twofold b)
{
    return twofold_add(twofold_multiply(v, a), twofold_multiply(t, b));
}

static struct twofold point(const struct source *c, int i)
{
    struct twofold p = {c->points[i], c->low[i]};
    return p;
}

static void frame(const struct source *c, const struct gap_model *m, struct fine_framed *out)
{
    const real u = REAL_EPSILON / 2, scale = 2;
    struct twofold ex = twofold_of(m->ex), ey = twofold_of(m->ey), back = twofold_of(-m->ey);
    out->n = c->n;
    out->error = (real)1.5 * c->fine_error + 64 * u * u * scale;
    out->most = 0;
    for (int i = 0; i <= c->n; i++) {
        struct twofold x = twofold_add(point(c, i), twofold_of(-m->x0));
        struct twofold y = twofold_add(point(c, c->n + 1 + i), twofold_of(-m->y0));
        out->c[0][i] = mean(ex, x, ey, y);
        out->c[1][i] = mean(ex, y, back, x);
        out->most = real_max(out->most, real_max(real_abs(out->c[0][i].hi), real_abs(out->c[1][i].hi)));
    }
}

/* Taylor coefficients of a component at a parameter in [0, 1]. */
static void component(const struct fine_framed *a, int which, real at, struct fine_series *out)
{
    const real u = REAL_EPSILON / 2, step = (12 * a->n + 16) * (u * u) * a->most;
    const struct twofold share = twofold_of(at), rest = exact_sum(1, -at);
    struct twofold d[DEGREE_MAX + 1], v[DEGREE_MAX + 1];
    real many = 1, power = 1;
    int n = a->n;
    for (int i = 0; i <= n; i++) {
        d[i] = a->c[which][i];
    }
    for (int k = 0; k <= FINE_LAST; k++) {
        out->c[k] = fine_of(0);
        if (k > n) {
            continue;
        }
        for (int i = 0; i <= n - k; i++) {
            v[i] = d[i];
        }
        for (int j = n - k; j > 0; j--) {
            for (int i = 0; i < j; i++) {
                v[i] = mean(rest, v[i], share, v[i + 1]);
            }
        }
        out->c[k] = fine_round(twofold_multiply(v[0], twofold_of(many)), many * power * (a->error + step));
        for (int i = 0; i < n - k; i++) {
            d[i] = twofold_add(d[i + 1], twofold_negate(d[i]));
        }
        many = many * (real)(n - k) / (real)(k + 1);
        power = 2 * power;
    }
}

/* From the abscissa x less h to x. */
static void move(struct fine_series *gamma, struct fine h, const struct series *range)
{
    real off = fine_most(h);
    for (int j = 0; j <= FINE_LAST; j++) {
        if (j == FINE_LAST) {
            gamma->c[j].rad += (j + 1) * ball_most(range->c[j + 1]) * off * (1 + 8 * REAL_EPSILON);
            continue;
        }
        struct fine step = fine_multiply(fine_multiply(gamma->c[j + 1], fine_of(j + 1)), h);
        gamma->c[j] = fine_add(gamma->c[j], step);
        gamma->c[j].rad +=
            (j + 2) * (j + 1) / 2 * ball_most(range->c[j + 2]) * (off * off) * (1 + 16 * REAL_EPSILON);
    }
}

bool gap_model_sharpen(const struct source *free_of, const struct source *graph_of, real at,
                       struct gap_model *c)
{
    struct fine_framed loose, graph;
    struct fine_series x, y, gx, gy, gamma, below;
    if (!free_of->low || !graph_of->low || !gap_model_centre(c, at)) {
        return false;
    }
    frame(free_of, c, &loose);
    frame(graph_of, c, &graph);
    component(&loose, 0, c->at, &x);
    component(&loose, 1, c->at, &y);
    component(&graph, 0, c->as, &gx);
    component(&graph, 1, c->as, &gy);
    fine_series_graph(&gx, &gy, &gamma);
    move(&gamma, fine_subtract(x.c[0], gx.c[0]), &c->range);
    fine_series_compose(&gamma, &x, &below);
    bool finite = true;
    for (int k = 0; k <= FINE_LAST; k++) {
        struct ball g = fine_ball(fine_subtract(y.c[k], k > 0 ? below.c[k] : gamma.c[0]));
        finite = finite && g.rad < REAL_HUGE;
        c->gap.c[k] = g;
    }
    c->noise = c->gap.c[0].rad;
    return finite;
}
