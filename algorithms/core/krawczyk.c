#include "krawczyk.h"

#include "bernstein.h"

/* Bounds of one curve: largest second derivatives of the homogeneous coordinates, largest |Euclidean
 * coordinate| and weight. */
struct shape {
    real second[3], extent, weight;
};

/* A curve at a parameter: homogeneous coordinates, slopes, and their errors relative to shape and weight. */
struct jet {
    real value[3], slope[3], error[3], slope_error[3];
};

/* F = x_f w_g - x_g w_f and the same with y, over the box |t - centre[0]| <= radius[0], |s - centre[1]| <=
 * radius[1]: value and Jacobian at the centre with their errors; `change` bounds how far the Jacobian strays
 * from it. */
struct expansion {
    real value[2], error[2], jacobian[2][2], change[2][2];
};

static const real *component(const struct arc *c, int k)
{
    return k == 0 ? c->x : k == 1 ? c->y : c->w;
}

static struct shape shape_of(const struct arc *c)
{
    const int n = c->degree;
    struct shape h = {{0, 0, 0}, 0, 1};
    for (int i = 0; i <= n; i++) {
        real size = real_max(real_abs(c->x[i]), real_abs(c->y[i]));
        h.extent = real_max(h.extent, c->w ? size / c->w[i] : size);
        h.weight = c->w ? real_max(h.weight, c->w[i]) : h.weight;
    }
    h.extent = h.extent > 0 ? h.extent : (real)1;
    for (int k = 0; k < (c->w ? 3 : 2); k++) {
        const real *p = component(c, k);
        for (int i = 0; i + 2 <= n; i++) {
            real bend = real_abs(p[i] - 2 * p[i + 1] + p[i + 2]);
            h.second[k] = real_max(h.second[k], bend);
        }
        /* rounding of the differences, and growth below 4/3 up to 1/(8n) past the ends */
        real rounding = (k < 2 ? h.extent : (real)1) * 8 * REAL_EPSILON;
        real input = k < 2 ? 4 * c->error : 4 * c->error / h.extent;
        h.second[k] = n * (n - 1) * (h.second[k] + h.weight * (rounding + input)) * 4 / 3;
    }
    return h;
}

/* |x_i| <= extent w_i, so |x|(t) <= extent w(t): values err by 3n u extent w(t), and by (error / 2) w(t) of
 * the input (arc.h; all of it for polynomial curves), weights by the same over extent. */
static struct jet jet_at(const struct arc *c, const struct shape *h, real t)
{
    const int n = c->degree;
    const real u = REAL_EPSILON / 2;
    struct jet j = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    real scratch[KRAWCZYK_DEGREE_MAX + 1];
    for (int k = 0; k < (c->w ? 3 : 2); k++) {
        j.value[k] = bernstein_value_slope(n, component(c, k), t, scratch, &j.slope[k]);
    }
    for (int k = 0; k < (c->w ? 3 : 2); k++) {
        real size = k < 2 ? (real)1 : 1 / h->extent;
        real relative = size * ((3 * n + 2) * u * h->extent + c->error);
        j.error[k] = relative * j.value[2];
        j.slope_error[k] = 2 * n * relative * h->weight;
    }
    return j;
}

/* Bounds of value and slope over |t - centre| <= radius. */
static real slope_bound(const struct jet *j, const struct shape *h, int k, real radius)
{
    return real_abs(j->slope[k]) + j->slope_error[k] + radius * h->second[k];
}

static real value_bound(const struct jet *j, const struct shape *h, int k, real radius)
{
    return real_abs(j->value[k]) + j->error[k] + radius * slope_bound(j, h, k, radius);
}

/* Row k of the derivative by the parameter of f (of g with the roles exchanged): x_f' w_g - x_g w_f', up to
 * sign; how far it strays over the box, and its own error. */
static real derivative(int k, const struct jet *f, const struct shape *hf, real rf, const struct jet *g,
                       const struct shape *hg, real rg, real *change)
{
    real weight = value_bound(g, hg, 2, rg), place = value_bound(g, hg, k, rg);
    real mixed = slope_bound(f, hf, k, rf) * slope_bound(g, hg, 2, rg) +
                 slope_bound(f, hf, 2, rf) * slope_bound(g, hg, k, rg);
    real first = f->slope[k] * g->value[2], second = g->value[k] * f->slope[2];
    *change = (hf->second[k] * weight + hf->second[2] * place) * rf + mixed * rg;
    *change += f->slope_error[k] * weight + real_abs(f->slope[k]) * g->error[2] + f->slope_error[2] * place +
               real_abs(f->slope[2]) * g->error[k] + 2 * REAL_EPSILON * (real_abs(first) + real_abs(second));
    *change += *change / 64;
    return first - second;
}

static void expand(const struct arc *f, const struct arc *g, const struct shape h[2], const real centre[2],
                   const real radius[2], struct expansion *e)
{
    struct jet a = jet_at(f, &h[0], centre[0]), b = jet_at(g, &h[1], centre[1]);
    for (int k = 0; k < 2; k++) {
        real first = a.value[k] * b.value[2], second = b.value[k] * a.value[2];
        e->value[k] = first - second;
        e->error[k] = a.error[k] * b.value[2] + real_abs(a.value[k]) * b.error[2] + b.error[k] * a.value[2] +
                      real_abs(b.value[k]) * a.error[2] + REAL_EPSILON * (real_abs(first) + real_abs(second));
        e->error[k] += e->error[k] / 64;
        e->jacobian[k][0] = derivative(k, &a, &h[0], radius[0], &b, &h[1], radius[1], &e->change[k][0]);
        e->jacobian[k][1] = -derivative(k, &b, &h[1], radius[1], &a, &h[0], radius[0], &e->change[k][1]);
    }
}

/* Approximate inverse; false if there is none. */
static bool invert(const real j[2][2], real y[2][2])
{
    real d = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    if (d == 0 || !real_is_finite(1 / d)) {
        return false;
    }
    y[0][0] = j[1][1] / d;
    y[0][1] = -j[0][1] / d;
    y[1][0] = -j[1][0] / d;
    y[1][1] = j[0][0] / d;
    return true;
}

/* The operator K = centre + shift +- radius of the box, with the bound `noise` of what no box can get below.
 * Any real matrix y will do: |I - y J| <= |I - y J(centre)| + |y| change. */
static bool operate(const struct expansion *e, const real radius[2], real shift[2], real spread[2],
                    real noise[2])
{
    real y[2][2];
    if (!invert(e->jacobian, y)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        shift[i] = -(y[i][0] * e->value[0] + y[i][1] * e->value[1]);
        noise[i] = real_abs(y[i][0]) * e->error[0] + real_abs(y[i][1]) * e->error[1];
        noise[i] +=
            2 * REAL_EPSILON * (1 + real_abs(y[i][0] * e->value[0]) + real_abs(y[i][1] * e->value[1]));
        spread[i] = noise[i];
        for (int j = 0; j < 2; j++) {
            real p = y[i][0] * e->jacobian[0][j], q = y[i][1] * e->jacobian[1][j];
            real off =
                real_abs((i == j ? 1 : 0) - (p + q)) + 2 * REAL_EPSILON * (1 + real_abs(p) + real_abs(q));
            off += real_abs(y[i][0]) * e->change[0][j] + real_abs(y[i][1]) * e->change[1][j];
            spread[i] += off * radius[j];
        }
        spread[i] += spread[i] / 64;
    }
    return true;
}

/* One test of a box.  ONE_ZERO: the box is replaced by a narrower one. */
static enum proof test_box(const struct arc *f, const struct arc *g, const struct shape h[2], real centre[2],
                           real radius[2])
{
    struct expansion e;
    real shift[2], spread[2], noise[2];
    expand(f, g, h, centre, radius, &e);
    if (!operate(&e, radius, shift, spread, noise)) {
        return UNDECIDED;
    }
    bool inside = true;
    for (int i = 0; i < 2; i++) {
        if (real_abs(shift[i]) - spread[i] > radius[i]) {
            return NO_ZERO;
        }
        inside = inside && real_abs(shift[i]) + spread[i] < radius[i];
    }
    if (!inside) {
        return UNDECIDED;
    }
    for (int i = 0; i < 2; i++) {
        real moved = real_max(0, real_min(1, centre[i] + shift[i]));
        radius[i] = spread[i] + real_abs(centre[i] + shift[i] - moved) + REAL_EPSILON;
        centre[i] = moved;
    }
    return ONE_ZERO;
}

/* Centre after two steps of Newton's method, unless they lead away; radius to cover the box, and some more.
 */
static void choose_box(const struct arc *f, const struct arc *g, const struct shape h[2],
                       const struct interval *box[2], real centre[2], real radius[2])
{
    real near[2], nowhere[2] = {0, 0}, noise[2] = {0, 0};
    for (int i = 0; i < 2; i++) {
        near[i] = centre[i] = (box[i]->lo + box[i]->hi) / 2;
    }
    for (int step = 0; step < 2; step++) {
        struct expansion e;
        real shift[2], spread[2];
        expand(f, g, h, near, nowhere, &e);
        if (!operate(&e, nowhere, shift, spread, noise)) {
            break;
        }
        for (int i = 0; i < 2; i++) {
            near[i] = real_max(0, real_min(1, near[i] + shift[i]));
        }
    }
    bool good = true;
    for (int i = 0; i < 2; i++) {
        real reach = box[i]->hi - box[i]->lo + 8 * noise[i];
        good = good && near[i] >= box[i]->lo - reach && near[i] <= box[i]->hi + reach;
    }
    for (int i = 0; i < 2; i++) {
        centre[i] = good ? near[i] : centre[i];
        radius[i] = real_max(box[i]->hi - centre[i], centre[i] - box[i]->lo);
        radius[i] += radius[i] / 8 + 4 * noise[i] + 4 * REAL_EPSILON;
    }
}

enum proof krawczyk_narrow(const struct arc *f, const struct arc *g, struct interval *t, struct interval *s)
{
    const struct shape h[2] = {shape_of(f), shape_of(g)};
    const struct interval *box[2] = {t, s};
    const int degree[2] = {f->degree, g->degree};
    real centre[2], radius[2];
    choose_box(f, g, h, box, centre, radius);
    for (int i = 0; i < 2; i++) {
        real past = real_max(centre[i] + radius[i] - 1, radius[i] - centre[i]);
        if (8 * degree[i] * past > 1) {
            return UNDECIDED;
        }
    }
    enum proof proof = test_box(f, g, h, centre, radius);
    if (proof != ONE_ZERO) {
        return proof;
    }
    for (int round = 0; round < 16; round++) {
        real c[2] = {centre[0], centre[1]}, r[2] = {radius[0], radius[1]};
        test_box(f, g, h, c, r);
        if (!(r[0] < radius[0] / 2) && !(r[1] < radius[1] / 2)) {
            break;
        }
        for (int i = 0; i < 2; i++) {
            centre[i] = c[i];
            radius[i] = r[i];
        }
    }
    if (centre[0] - radius[0] > t->hi || centre[0] + radius[0] < t->lo || centre[1] - radius[1] > s->hi ||
        centre[1] + radius[1] < s->lo) {
        return NO_ZERO;
    }
    t->lo = centre[0] - radius[0];
    t->hi = centre[0] + radius[0];
    s->lo = centre[1] - radius[1];
    s->hi = centre[1] + radius[1];
    return ONE_ZERO;
}
