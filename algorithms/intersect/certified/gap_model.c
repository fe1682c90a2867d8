/* The gap between two arcs as a polynomial of one parameter with a remainder.
 *
 * One node, the graph, is y = gamma(x) over its chord's direction.  The other, the free one, may be anything,
 * a cusp too. With its points (X(t), Y(t)) in that frame, solutions are zeros of G(t) = Y(t) - gamma(X(t)).
 * Past its ends gamma is continued by its Taylor polynomials of degree SERIES there; so G is defined, and has
 * SERIES derivatives, on the whole free node.  With d = t - 1/2 in the free node's own parameter, by Taylor's
 * theorem for G and for its derivatives,
 *
 *     G(t) = G_0 + G_1 d + ... + G_5 d^5 + G_6 d^6,    G^(p)(t) / p! = sum over k >= p of C(k, p) G_k
 * d^(k-p),
 *
 * G_0 to G_5 its Taylor coefficients at 1/2 and G_6 one at some place of the node, another at each t: all
 * enclosed in balls.  Of the derivatives of the points: over the whole node by the range of the control
 * points' differences, at 1/2 by de Casteljau's algorithm; the rest is composition of power series.  What two
 * arcs have in common cancels in G_0 to G_5; their remainder falls with the sixth power of the width. */
#include "gap_model.h"

#include "../../core/bernstein.h"

/* ---- enclosures of Taylor coefficients by the own parameter ---- */

/* Of the points of a frame: |e|_1 <= 1.5 times their own, and 10 u S of rounding, u S <= E / (12 n + 1).  A
 * node that is the whole source has the source's points, which are not cut. */
static real frame_error(const struct source *c, const struct node *a)
{
    bool whole = a->lo == 0 && a->hi == 1;
    return whole ? 2 * c->error + 12 * c->node_error / (12 * c->n + 1) : 3 * c->node_error;
}

/* Polynomial: the k-th Taylor coefficient of the node is (hi - lo)^k times that of the whole source at the
 * same place, so no larger than C(n, k) (hi - lo)^k times the source's largest k-th difference, 1-norms of
 * both coordinates.  These differences are known to 2^k (3 e + 2 k u S) < 2^k (3 e + node_error).  Of narrow
 * nodes of high degree this is far less than what rounding leaves of their own differences. */
static void bound_terms(const struct source *c, const struct node *a, struct framed *out)
{
    real dx[DEGREE_MAX + 1], dy[DEGREE_MAX + 1], many = 1, power = 1, wide = a->hi - a->lo;
    real error = 3 * c->error + c->node_error;
    const int worth = c->rational ? (int)DEGREE_MAX + 1 : 5; /* of lower degree rounding is small */
    for (int i = 0; i <= c->n; i++) {
        dx[i] = c->points[i];
        dy[i] = c->points[c->n + 1 + i];
    }
    for (int k = 0; k <= SERIES; k++) {
        out->most[k] = REAL_HUGE;
    }
    for (int k = 0; k <= SERIES && k <= c->n && c->n >= worth; k++) {
        real most = 0;
        for (int i = 0; i <= c->n - k; i++) {
            most = real_max(most, real_abs(dx[i]) + real_abs(dy[i]));
        }
        if (k > 1) {
            out->most[k] = many * power * (most + real_ldexp(error, k)) * (1 + 64 * REAL_EPSILON);
        }
        for (int i = 0; i < c->n - k; i++) {
            dx[i] = dx[i + 1] - dx[i];
            dy[i] = dy[i + 1] - dy[i];
        }
        many = many * (real)(c->n - k) / (real)(k + 1);
        power = power * wide;
    }
}

static void frame_node(const struct source *c, const struct node *a, real ex, real ey, real x0, real y0,
                       struct framed *out)
{
    const real *x = a->points, *y = x + c->n + 1, *w = y + c->n + 1;
    out->n = c->n;
    out->rational = c->rational;
    out->error = frame_error(c, a);
    bound_terms(c, a, out);
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

/* Range of the k-th Taylor coefficient C(n, k) (k-th differences) over the node if at < 0, else its value at
 * `at`. */
static void component_series(const struct framed *a, int component, real at, real error, struct series *out)
{
    real d[DEGREE_MAX + 1], v[DEGREE_MAX + 1], times = 1, power = 1;
    int n = a->n;
    for (int i = 0; i <= n; i++) {
        d[i] = a->c[component][i];
    }
    for (int k = 0; k <= SERIES; k++) {
        if (k > n) {
            out->c[k] = ball_of(0, 0);
            continue;
        }
        real lo = d[0], hi = d[0], spread = times * power * error; /* times = C(n, k), power = 2^k */
        for (int i = 0; i <= n - k; i++) {
            lo = real_min(lo, d[i]);
            hi = real_max(hi, d[i]);
        }
        if (at < 0) {
            out->c[k] = ball_round((lo + hi) / 2 * times, (hi - lo) / 2 * times + spread);
        } else {
            for (int i = 0; i <= n - k; i++) {
                v[i] = d[i];
            }
            for (int j = n - k; j > 0; j--) {
                for (int i = 0; i < j; i++) {
                    v[i] = (1 - at) * v[i] + at * v[i + 1];
                }
            }
            real size = real_max(real_abs(lo), real_abs(hi));
            out->c[k] = ball_round(v[0] * times, spread + 2 * n * REAL_EPSILON * size * times);
        }
        if (component < 2 && a->most[k] < out->c[k].rad) {
            out->c[k] = ball_of(0, a->most[k]);
        }
        for (int i = 0; i < n - k; i++) {
            d[i] = d[i + 1] - d[i];
        }
        times = times * (real)(n - k) / (real)(k + 1);
        power = 2 * power;
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
    series_invert(&w, SERIES, &one);
    series_multiply(x, 0, &one, SERIES, x);
    series_multiply(y, 0, &one, SERIES, y);
}

/* x and its derivative at a parameter. */
static void component_at(const struct framed *a, real at, struct ball *value, struct ball *slope)
{
    struct series x, y;
    if (a->rational) {
        node_series(a, at, &x, &y);
    } else {
        component_series(a, 0, at, a->error, &x);
    }
    *value = x.c[0];
    *slope = x.c[1];
}

/* ---- the gap ---- */

/* gamma as a series in x - X(s), for s in the graph's node or at one s; run: the least |X'|. */
static bool graph_series(const struct framed *graph, real at, struct series *gamma, real *run)
{
    struct series x, y;
    node_series(graph, at, &x, &y);
    *run = ball_least(x.c[1]);
    if (!(*run > 0)) {
        return false;
    }
    series_graph(&x, &y, gamma);
    return true;
}

/* Past the ends, up to `beyond`, by Taylor polynomials: the j-th coefficient changes by sum over i > j of
 * C(i, j) gamma_i beyond^(i-j). */
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
static void subtract_graph(const struct series *x, const struct series *y, const struct series *gamma,
                           struct series *out)
{
    struct series below;
    series_compose(gamma, x, &below);
    for (int k = 1; k <= SERIES; k++) {
        out->c[k] = ball_subtract(y->c[k], below.c[k]);
    }
}

/* How far the free node may go past the graph's ends. */
static real reach_beyond(const struct framed *a, const struct framed *g)
{
    real lo = g->c[0][0] / g->c[2][0], hi = g->c[0][g->n] / g->c[2][g->n], beyond = 0;
    for (int i = 0; i <= a->n; i++) {
        real x = a->c[0][i] / a->c[2][i];
        beyond = real_max(beyond, real_max(lo - x, x - hi));
    }
    return beyond + 2 * (a->error + g->error);
}

/* The graph's own parameter with abscissa x, roughly; from `as`. */
static real graph_parameter(const struct framed *g, real x, real as)
{
    real scratch[DEGREE_MAX + 1], slope, weight, change;
    for (int k = 0; k < 6; k++) {
        real value = bernstein_value_slope(g->n, g->c[0], as, scratch, &slope);
        if (g->rational) {
            weight = bernstein_value_slope(g->n, g->c[2], as, scratch, &change);
            value = value / weight;
            slope = (slope - value * change) / weight;
        }
        real next = clamp(as + (x - value) / slope, 0, 1);
        bool there = real_abs(next - as) <= 16 * REAL_EPSILON;
        as = next;
        if (there) {
            break;
        }
    }
    return as;
}

/* How far the graph is in x from the free node at `at`, about. */
static real distance_at(const struct gap_model *c, real at)
{
    struct ball x, gx, slope;
    component_at(&c->loose, at, &x, &slope);
    component_at(&c->graph, graph_parameter(&c->graph, x.mid, (real)0.5), &gx, &slope);
    return real_abs(x.mid - gx.mid);
}

/* The middle; or, where the graph does not reach so far, an end: then little of the two is side by side. */
static real choose_centre(const struct gap_model *c)
{
    const real small = (real)1 / 16;
    real least = distance_at(c, (real)0.5) * small, at = (real)0.5;
    for (int end = 0; end <= 1 && least > c->noise; end++) {
        real distance = distance_at(c, end);
        if (distance < least) {
            least = distance;
            at = end;
        }
    }
    return at;
}

/* The Taylor coefficients of G at `at`.  gamma's series belongs to the abscissa of `as`, which is h less than
 * X(at): its coefficients at X(at) differ by less than |h| (j + 1) gamma_(j+1) over the node, and G_0 by
 * gamma_1 h + gamma_2 h^2. */
bool gap_model_centre(struct gap_model *c, real at)
{
    const struct series *range = &c->range;
    struct series y, gamma;
    struct ball gx, slope;
    real run;
    c->at = at;
    node_series(&c->loose, c->at, &c->x, &y);
    c->as = graph_parameter(&c->graph, c->x.c[0].mid, (real)0.5);
    component_at(&c->graph, c->as, &gx, &slope);
    if (!graph_series(&c->graph, c->as, &gamma, &run)) {
        return false;
    }
    struct ball h = ball_subtract(c->x.c[0], gx);
    real off = ball_most(h);
    c->ahead = h.mid;
    c->far = 64 * h.rad;
    struct ball constant = ball_subtract(ball_subtract(y.c[0], gamma.c[0]), ball_multiply(gamma.c[1], h));
    constant.rad += ball_most(range->c[2]) * off * off;
    for (int j = 1; j < SERIES; j++) {
        gamma.c[j].rad += off * (j + 1) * ball_most(range->c[j + 1]) * (1 + 8 * REAL_EPSILON);
    }
    struct ball last = c->gap.c[SERIES];
    subtract_graph(&c->x, &y, &gamma, &c->gap);
    c->gap.c[0] = constant;
    c->gap.c[SERIES] = last;
    return true;
}

bool gap_model_init(const struct source *free_of, const struct node *free_node, const struct source *graph_of,
                    const struct node *graph, struct gap_model *out)
{
    int n = graph_of->n;
    const real *x = graph->points, *y = x + n + 1;
    real first = graph_of->rational ? y[n + 1] : (real)1, last = graph_of->rational ? y[2 * n + 1] : (real)1;
    real x0 = x[0] / first, y0 = y[0] / first, ex = x[n] / last - x0, ey = y[n] / last - y0;
    real length = real_sqrt(ex * ex + ey * ey);
    struct series px, py;
    if (graph->wide || !(length > 0)) {
        return false;
    }
    out->ex = ex / length;
    out->ey = ey / length;
    out->x0 = x0;
    out->y0 = y0;
    frame_node(graph_of, graph, out->ex, out->ey, x0, y0, &out->graph);
    frame_node(free_of, free_node, out->ex, out->ey, x0, y0, &out->loose);
    if (!graph_series(&out->graph, -1, &out->range, &out->run)) {
        return false;
    }
    graph_continue(&out->range, reach_beyond(&out->loose, &out->graph));
    node_series(&out->loose, -1, &px, &py);
    subtract_graph(&px, &py, &out->range, &out->gap);
    out->swing = ball_most(px.c[SERIES]);
    out->noise = 3 * (free_of->node_error + graph_of->node_error);
    if (!gap_model_centre(out, choose_centre(out))) {
        return false;
    }
    bool finite = true;
    for (int k = 0; k <= SERIES; k++) {
        finite = finite && out->gap.c[k].rad < REAL_HUGE && out->x.c[k].rad < REAL_HUGE;
    }
    return finite;
}

static int choose(int n, int k)
{
    static const int pascal[SERIES + 1][SERIES + 1] = {{1},
                                                       {1, 1},
                                                       {1, 2, 1},
                                                       {1, 3, 3, 1},
                                                       {1, 4, 6, 4, 1},
                                                       {1, 5, 10, 10, 5, 1},
                                                       {1, 6, 15, 20, 15, 6, 1}};
    return k < 0 || k > n ? 0 : pascal[n][k];
}

/* A polynomial in powers of d, about the middle of [lo, hi], by Horner's rule in Bernstein form: the product
 * with d, whose coefficients are -half and half, has coefficient i of degree k + 1 the mean of half c[i-1]
 * and -half c[i] with weights i / (k + 1) and 1 - i / (k + 1).  So no power of d counts for more than its
 * largest value.  The middle, its distance from `at` and half err by u of themselves each, which counts where
 * [lo, hi] is narrow: the shift by less than eps (|middle| + |shift|), half times a quotient by 1.5 eps. */
void gap_model_bernstein(const struct gap_model *c, int p, real lo, real hi, struct ball *out)
{
    int n = SERIES - p;
    struct ball a[SERIES + 1] = {{0, 0}};
    real middle = (lo + hi) / 2, half = (hi - lo) / 2, away = middle - c->at;
    struct ball shift = ball_of(away, REAL_EPSILON * (middle + real_abs(away)));
    for (int k = 0; k <= n; k++) {
        a[k] = ball_multiply(c->gap.c[k + p], ball_of(choose(k + p, p), 0));
    }
    for (int k = 0; k < n && (away != 0 || lo > 0); k++) { /* to powers about the middle */
        for (int j = n - 1; j >= k; j--) {
            a[j] = ball_add(a[j], ball_multiply(a[j + 1], shift));
        }
    }
    out[0] = a[n];
    for (int k = 0; k < n; k++) {
        out[k + 1] = ball_of(0, 0);
        for (int i = k + 1; i >= 0; i--) {
            real up = half * ((real)i / (real)(k + 1)), down = -half * ((real)(k + 1 - i) / (real)(k + 1));
            struct ball left =
                i > 0 ? ball_multiply(out[i - 1], ball_of(up, 2 * REAL_EPSILON * up)) : ball_of(0, 0);
            struct ball right = ball_multiply(out[i], ball_of(down, -2 * REAL_EPSILON * down));
            out[i] = ball_add(ball_add(left, right), a[n - 1 - k]);
        }
    }
}

/* X over [lo, hi] is within `more` of x.  With c the middle of [lo, hi], r half its width and D the largest
 * |d| in it: |X(t) - X(c)| <= sum of k |X_k| D^(k-1) r, k < SERIES, and the last terms of both.  c rounds to
 * 2 eps; the sum to less than 16 eps of its terms' sizes. */
static real abscissas(const struct gap_model *c, real lo, real hi, real *more)
{
    real middle = (lo + hi) / 2, r = (hi - lo) / 2 + 2 * REAL_EPSILON * middle;
    real step = middle - c->at, most = real_abs(step) + r;
    real x = c->x.c[0].mid, power = step, rad = c->x.c[0].rad, high = 1, size = real_abs(x);
    for (int k = 1; k < SERIES; k++) {
        x += c->x.c[k].mid * power;
        size += real_abs(c->x.c[k].mid * power);
        power = power * step;
        rad += k * ball_most(c->x.c[k]) * high * r;
        high = high * most;
        rad += c->x.c[k].rad * high;
    }
    *more = (rad + 2 * c->swing * high * most + 16 * REAL_EPSILON * size) * (1 + 64 * REAL_EPSILON);
    return x;
}

void gap_model_place(const struct gap_model *c, real lo, real hi, real *as, real *rs)
{
    real more, x = abscissas(c, lo, hi, &more);
    *as = graph_parameter(&c->graph, x, c->as);
    struct ball gx, slope;
    component_at(&c->graph, *as, &gx, &slope);
    *rs = (more + real_abs(x - gx.mid) + gx.rad) / c->run * (1 + 64 * REAL_EPSILON);
}

enum reach gap_model_reach(const struct gap_model *c, real lo, real hi)
{
    const struct framed *g = &c->graph;
    real more, x = abscissas(c, lo, hi, &more), error = 2 * g->error;
    real first = g->c[0][0] / g->c[2][0], last = g->c[0][g->n] / g->c[2][g->n];
    more += error + 4 * REAL_EPSILON * (real_abs(x) + more + real_abs(first) + real_abs(last));
    return x + more < first || x - more > last   ? BEYOND
           : x - more > first && x + more < last ? INSIDE
                                                 : ACROSS;
}
