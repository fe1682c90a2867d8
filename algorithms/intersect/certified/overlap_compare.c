/* Are two arcs one?
 *
 * If two arcs of algebraic curves are the same set, there is a monotone map s = q(t) with f(t) = g(q(t)).
 * Here q is guessed, the composition is written out in Bernstein form, and its control points are compared
 * with f's: the curves are nowhere farther apart than those.  Guesses: the projective map (of the arcs' own
 * parameters; affine for polynomial curves) that makes the weights agree, after elevation to a common degree;
 * a polynomial of degree 2 or 3 through points that agree, either way; and for arcs on one line any monotone
 * map.
 *
 * Rounding: arcs are cut with node_error; elevation, products and sums of weights that sum to 1 add fewer
 * than 128 N u S, N the common degree. */
#include "../../core/bernstein.h"
#include "overlap.h"

enum { POINTS_MAX = 2 * DEGREE_MAX + 1 };

/* Homogeneous control points. */
struct arc_points {
    int n;
    bool rational;
    real c[3][POINTS_MAX];
};

static void turn_round(struct arc_points *a)
{
    for (int k = 0; k < 3; k++) {
        for (int i = 0; 2 * i < a->n; i++) {
            real swap = a->c[k][i];
            a->c[k][i] = a->c[k][a->n - i];
            a->c[k][a->n - i] = swap;
        }
    }
}

static void arc_cut(const struct source *c, real first, real last, struct arc_points *out)
{
    out->n = c->n;
    out->rational = c->rational;
    real lo = real_min(first, last), hi = real_max(first, last);
    for (int i = 0; i <= c->n; i++) {
        out->c[2][i] = 1;
    }
    for (int k = 0; k < (c->rational ? 3 : 2); k++) {
        bernstein_restrict(c->n, 1, c->points + k * (c->n + 1), lo, hi, out->c[k]);
    }
    if (first > last) {
        turn_round(out);
    }
}

static void arc_elevate(struct arc_points *a, int n)
{
    for (int k = 0; k < 3; k++) {
        bernstein_elevate(a->n, a->c[k], n - a->n, a->c[k]);
    }
    a->n = n;
}

/* Multiplies the homogeneous points of a by lambda mu^i so that the first two weights are those of b: a
 * projective change of the parameter. */
static void arc_project(struct arc_points *a, const struct arc_points *b)
{
    const real *w = a->c[2], *v = b->c[2];
    real times = v[0] / w[0], mu = a->n > 0 ? (v[1] * w[0]) / (v[0] * w[1]) : (real)1;
    for (int i = 0; i <= a->n; i++) {
        for (int k = 0; k < 3; k++) {
            a->c[k][i] = a->c[k][i] * times;
        }
        times = times * mu;
    }
}

/* Of curves of one degree.  Weights that differ by a factor 1 + d move a point by at most 2 d times the
 * diameter, 4 d S. */
static real control_distance(const struct arc_points *a, const struct arc_points *b, real scale)
{
    real most = 0, change = 0;
    for (int i = 0; i <= a->n; i++) {
        real w = a->c[2][i], v = b->c[2][i];
        real dx = a->c[0][i] / w - b->c[0][i] / v, dy = a->c[1][i] / w - b->c[1][i] / v;
        most = real_max(most, real_max(real_abs(dx), real_abs(dy)));
        change = real_max(change, real_abs(w / v - 1));
    }
    return 2 * (most + 4 * change * scale) *
           (1 + 64 * REAL_EPSILON); /* 2: from the maximum norm to the distance */
}

/* ---- polynomial maps ---- */

enum { MAP_MAX = 3 };

/* Bernstein coefficients of the polynomial of degree k with p(j / k) = value[j]. */
static void interpolate(int k, const real *value, real *c)
{
    c[0] = value[0];
    c[k] = value[k];
    if (k == 2) {
        c[1] = (4 * value[1] - value[0] - value[2]) / 2;
    } else {
        c[1] = (-5 * value[0] + 18 * value[1] - 9 * value[2] + 2 * value[3]) / 6;
        c[2] = (2 * value[0] - 9 * value[1] + 18 * value[2] - 5 * value[3]) / 6;
    }
}

/* a(q) by de Casteljau's algorithm with polynomials; q of degree k with coefficients in [0, 1]. */
static void compose(const struct arc_points *a, int k, const real *q, struct arc_points *out)
{
    int n = a->n;
    real row[DEGREE_MAX + 1][POINTS_MAX], rest[MAP_MAX + 1], left[POINTS_MAX], right[POINTS_MAX];
    for (int i = 0; i <= k; i++) {
        rest[i] = 1 - q[i];
    }
    out->n = n * k;
    out->rational = false;
    for (int component = 0; component < 2; component++) {
        for (int i = 0; i <= n; i++) {
            row[i][0] = a->c[component][i];
        }
        for (int step = 1; step <= n; step++) {
            int degree = (step - 1) * k;
            for (int i = 0; i <= n - step; i++) {
                bernstein_multiply(k, rest, degree, row[i], left);
                bernstein_multiply(k, q, degree, row[i + 1], right);
                for (int j = 0; j <= degree + k; j++) {
                    row[i][j] = left[j] + right[j];
                }
            }
        }
        for (int j = 0; j <= n * k; j++) {
            out->c[component][j] = row[0][j];
        }
    }
    for (int j = 0; j <= n * k; j++) {
        out->c[2][j] = 1;
    }
}

/* The arc of `low` from a0 to a1 against that of `high` from b0 to b1: low(q) = high? */
static real mapped_distance(const struct source *low, real a0, real a1, const struct source *high, real b0,
                            real b1, int k, real scale)
{
    struct arc_points a, b, composed;
    real value[MAP_MAX + 1], q[MAP_MAX + 1];
    arc_cut(low, a0, a1, &a);
    arc_cut(high, b0, b1, &b);
    for (int j = 0; j <= k; j++) {
        struct spot p;
        real share = (real)j / (real)k, at = a0 + (a1 - a0) * share;
        source_at(high, b0 + (b1 - b0) * share, &p);
        if (j > 0 && j < k) {
            source_match(low, p.x, p.y, real_min(a0, a1), real_max(a0, a1), &at);
        }
        value[j] = (at - a0) / (a1 - a0);
    }
    interpolate(k, value, q);
    for (int j = 0; j <= k; j++) {
        if (!(q[j] >= 0 && q[j] <= 1)) {
            return -1;
        }
    }
    compose(&a, k, q, &composed);
    int n = composed.n > b.n ? composed.n : b.n;
    arc_elevate(&composed, n);
    arc_elevate(&b, n);
    return control_distance(&composed, &b, scale);
}

/* ---- arcs on a line ---- */

/* How far the control points are from the chord of a; negative if they do not run along it one way. */
static real straightness(const struct arc_points *a, real ux, real uy, real x0, real y0)
{
    real length = real_sqrt(ux * ux + uy * uy), most = 0, last = 0;
    for (int i = 0; i <= a->n; i++) {
        real dx = a->c[0][i] / a->c[2][i] - x0, dy = a->c[1][i] / a->c[2][i] - y0;
        real along = (ux * dx + uy * dy) / length;
        if (i > 0 && along < last) {
            return -1;
        }
        last = along;
        most = real_max(most, real_abs(cross(ux, uy, dx, dy)) / length);
    }
    return most;
}

static real line_distance(const struct arc_points *a, const struct arc_points *b)
{
    real x0 = a->c[0][0] / a->c[2][0], y0 = a->c[1][0] / a->c[2][0];
    real ux = a->c[0][a->n] / a->c[2][a->n] - x0, uy = a->c[1][a->n] / a->c[2][a->n] - y0;
    real of_a = straightness(a, ux, uy, x0, y0), of_b = straightness(b, ux, uy, x0, y0);
    real x1 = b->c[0][0] / b->c[2][0], y1 = b->c[1][0] / b->c[2][0];
    real x2 = b->c[0][b->n] / b->c[2][b->n], y2 = b->c[1][b->n] / b->c[2][b->n];
    if (!(of_a >= 0) || !(of_b >= 0)) {
        return -1;
    }
    real ends = real_max(real_max(real_abs(x1 - x0), real_abs(y1 - y0)),
                         real_max(real_abs(x2 - x0 - ux), real_abs(y2 - y0 - uy)));
    return 2 * (of_a + of_b + ends);
}

/* ---- all of them ---- */

static real better(real a, real b)
{
    return a < 0 ? b : b < 0 ? a : real_min(a, b);
}

real shared_distance(const struct level *v, const struct shared *x, real limit)
{
    struct arc_points a, b;
    int n = v->f.n > v->g.n ? v->f.n : v->g.n;
    arc_cut(&v->f, x->t0, x->t1, &a);
    arc_cut(&v->g, x->s0, x->s1, &b);
    real distance = line_distance(&a, &b);
    arc_elevate(&a, n);
    arc_elevate(&b, n);
    arc_project(&b, &a);
    distance = better(distance, control_distance(&a, &b, v->scale));
    bool polynomial = !v->f.rational && !v->g.rational;
    for (int k = 2; k <= MAP_MAX && polynomial && !(distance >= 0 && distance <= limit); k++) {
        if (v->g.n * k >= v->f.n && v->g.n * k < POINTS_MAX) {
            distance =
                better(distance, mapped_distance(&v->g, x->s0, x->s1, &v->f, x->t0, x->t1, k, v->scale));
            n = v->g.n * k > n ? v->g.n * k : n;
        }
        if (v->f.n * k >= v->g.n && v->f.n * k < POINTS_MAX) {
            distance =
                better(distance, mapped_distance(&v->f, x->t0, x->t1, &v->g, x->s0, x->s1, k, v->scale));
            n = v->f.n * k > n ? v->f.n * k : n;
        }
    }
    return distance < 0
               ? distance
               : distance + 2 * (v->f.node_error + v->g.node_error) + 64 * n * REAL_EPSILON * v->scale;
}

real source_match(const struct source *c, real x, real y, real lo, real hi, real *t)
{
    struct spot p;
    for (int k = 0; k < 12; k++) {
        source_at(c, *t, &p);
        real square = p.dx * p.dx + p.dy * p.dy;
        if (!(square > 0)) {
            break;
        }
        real next = clamp(*t - ((p.x - x) * p.dx + (p.y - y) * p.dy) / square, lo, hi);
        bool there = real_abs(next - *t) <= REAL_EPSILON;
        *t = next;
        if (there) {
            break;
        }
    }
    source_at(c, *t, &p);
    return real_max(real_abs(p.x - x), real_abs(p.y - y));
}

void source_second(const struct source *c, real t, real h, real *ddx, real *ddy)
{
    struct spot p, q;
    real next = t + h <= 1 ? t + h : t - h;
    source_at(c, t, &p);
    source_at(c, next, &q);
    *ddx = (q.dx - p.dx) / (next - t);
    *ddy = (q.dy - p.dy) / (next - t);
}

bool source_cusp(const struct source *c, real *t)
{
    const real many = 64, first = real_ldexp(1, -12), least = real_ldexp(1, -REAL_BITS / 2);
    struct spot p;
    real h = first;
    for (int k = 0; k < 16; k++) {
        real ddx, ddy;
        source_at(c, *t, &p);
        source_second(c, *t, h, &ddx, &ddy);
        real square = ddx * ddx + ddy * ddy;
        if (!(square > 0)) {
            return false;
        }
        real next = clamp(*t - (p.dx * ddx + p.dy * ddy) / square, 0, 1), step = real_abs(next - *t);
        *t = next;
        if (step <= REAL_EPSILON) {
            break;
        }
        h = clamp(step, least, first);
    }
    source_at(c, *t, &p);
    return real_max(real_abs(p.dx), real_abs(p.dy)) <= many * c->slope_noise;
}
