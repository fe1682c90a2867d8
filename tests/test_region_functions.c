/* Regions of families that are functions: closed curves of the cyclic trigonometric basis, and polynomial
 * ones, whose regions are known otherwise. */
#include <math.h>

#include "region_family.h"

#include "../algorithms/core/bernstein.h"

static const double pi = 3.14159265358979323846;

enum { ORDER_MAX = 3, CONTROLS_MAX = 2 * ORDER_MAX + 1, SAMPLES = 2000 };

/* ---- the trigonometric family ---- */

/* sum of d_j T(t - 2 pi j / (2n + 1)), T(u) = (1 + 2 sum of C(2n, n-k) / C(2n, n) cos(k u)) / (2n + 1): a
 * closed curve in the convex hull of its points (J. Sanchez-Reyes, Harmonic rational Bezier curves, p-Bezier
 * curves and trigonometric polynomials, 1998).  Column 0 is N, of d_0; columns 1 and 2 are x and y of the
 * rest. */
struct trigonometric {
    int n;
    double x[CONTROLS_MAX], y[CONTROLS_MAX];
    double cosine[3][ORDER_MAX + 1], sine[3][ORDER_MAX + 1]; /* by frequency */
};

static void trigonometric_make(struct trigonometric *c)
{
    int n = c->n, points = 2 * n + 1;
    memset(c->cosine, 0, sizeof c->cosine);
    memset(c->sine, 0, sizeof c->sine);
    for (int k = 0; k <= n; k++) {
        double amplitude = (k ? 2 : 1) * binomial(2 * n, n - k) / binomial(2 * n, n) / points;
        c->cosine[0][k] = amplitude;
        for (int j = 1; j < points; j++) {
            double a = 2 * pi * j * k / points;
            c->cosine[1][k] += amplitude * cos(a) * c->x[j];
            c->sine[1][k] += amplitude * sin(a) * c->x[j];
            c->cosine[2][k] += amplitude * cos(a) * c->y[j];
            c->sine[2][k] += amplitude * sin(a) * c->y[j];
        }
    }
}

/* First and second derivative of a column. */
static void derivatives(const struct trigonometric *c, int column, double t, double *first, double *second)
{
    *first = *second = 0;
    for (int k = 1; k <= c->n; k++) {
        double a = c->cosine[column][k], b = c->sine[column][k], p = cos(k * t), q = sin(k * t);
        *first += k * (b * p - a * q);
        *second -= k * k * (a * p + b * q);
    }
}

static void line(void *data, real t, real *out)
{
    const struct trigonometric *c = (const struct trigonometric *)data;
    double d[3], dd[3];
    for (int i = 0; i < 3; i++)
        derivatives(c, i, t, &d[i], &dd[i]);
    out[0] = d[0] * dd[2] - dd[0] * d[2];
    out[1] = d[1] * dd[0] - dd[1] * d[0];
    out[2] = d[1] * dd[2] - dd[1] * d[2];
}

/* |(P'Q'' - P''Q')''| <= sum of (j + k)^2 (j k^2 + j^2 k) |P_j| |Q_k|, by amplitudes. */
static double bend_of(const struct trigonometric *c, int p, int q)
{
    double sum = 0;
    for (int j = 1; j <= c->n; j++)
        for (int k = 1; k <= c->n; k++)
            sum += (j + k) * (j + k) * j * k * (j + k) * hypot(c->cosine[p][j], c->sine[p][j]) *
                   hypot(c->cosine[q][k], c->sine[q][k]);
    return sum;
}

static void bend(void *data, real lo, real hi, real *out)
{
    const struct trigonometric *c = (const struct trigonometric *)data;
    (void)lo, (void)hi;
    out[0] = bend_of(c, 0, 2);
    out[1] = bend_of(c, 1, 0);
    out[2] = bend_of(c, 1, 2);
}

/* Least det(F', F'') over the closed curve with its free point at d, over the size of its half-plane there.
 */
static double least_turning(struct trigonometric *c, struct point d)
{
    double least = HUGE_VAL;
    for (int i = 0; i < SAMPLES; i++) {
        real l[3];
        line(c, 2 * pi * i / SAMPLES, l);
        least = fmin(least, (l[0] * d.x + l[1] * d.y + l[2]) / hypot(l[0], l[1]));
    }
    return least;
}

static void solve(struct region_functions *f, struct region *out)
{
    struct region_workspace w;
    void *memory = malloc(region_workspace_size(2, 1));
    assert_non_null(memory);
    region_workspace_init(&w, memory, 2, 1);
    assert_int_equal(region_cut_functions(f, &w, out), SOLVED);
    free(memory);
}

/* Ends of edges, and points on both sides of the middle of each that is long enough; returns their number. */
static int check_edges(struct trigonometric *c, const struct region *r)
{
    const double step = 0.01;
    int checked = 0;
    for (int j = 0; j < r->count; j++) {
        const struct region_edge *e = &r->edge[j];
        if (e->from_infinity || e->to_infinity || hypot(e->to.x - e->from.x, e->to.y - e->from.y) < 20 * step)
            continue;
        double far = hypot(e->from.x, e->from.y) / 16;
        struct point in = {(e->from.x + e->to.x) / 2 + step * e->line[0],
                           (e->from.y + e->to.y) / 2 + step * e->line[1]},
                     beyond = {in.x - 2 * step * e->line[0], in.y - 2 * step * e->line[1]};
        assert_true(least_turning(c, e->from) >= -1e-6 * 16 * 4 * (1 + far * far));
        assert_true(least_turning(c, in) > 0);
        assert_true(least_turning(c, beyond) < 0);
        checked++;
    }
    return checked;
}

/* Control points near a regular polygon; on the inner side of every edge the curvature is positive, beyond
 * it is not. */
static void test_closed_curves(void **state)
{
    (void)state;
    struct region *r = region_new();
    int checked = 0;
    for (int i = 0; i < trials(60); i++) {
        struct random_state random = random_for(41, "trigonometric", (uint64_t)i);
        struct trigonometric c;
        c.n = (int)random_between(&random, 1, ORDER_MAX);
        for (int j = 0; j <= 2 * c.n; j++) {
            double a = 2 * pi * j / (2 * c.n + 1);
            c.x[j] = 10 * cos(a) + prop_dyadic(&random, 8);
            c.y[j] = 10 * sin(a) + prop_dyadic(&random, 8);
        }
        trigonometric_make(&c);
        struct region_functions f = {&c, line, bend, {0, 0}, 16, {0, 2 * pi}, 1e-6, 10000000};
        solve(&f, r);
        assert_true(r->certified && r->kind != REGION_EMPTY);
        checked += check_edges(&c, r);
    }
    assert_true(checked > 0);
    free(r);
}

/* ---- the polynomial family ---- */

struct polynomial {
    int n; /* of the half-planes */
    real c[3][9], bend[3];
};

static void polynomial_line(void *data, real t, real *out)
{
    const struct polynomial *p = (const struct polynomial *)data;
    for (int i = 0; i < 3; i++)
        out[i] = bernstein_value(p->n, p->c[i], t);
}

static void polynomial_bend(void *data, real lo, real hi, real *out)
{
    (void)lo, (void)hi;
    for (int i = 0; i < 3; i++)
        out[i] = ((const struct polynomial *)data)->bend[i];
}

/* p'q'' - p''q' of two polynomials of degree n, and a bound of its second derivative. */
static void minor(int n, const real *p, const real *q, struct polynomial *out, int column)
{
    real dp[9], dq[9], ddp[9], ddq[9], a[9], b[9], first[9], second[9];
    bernstein_derivative(n, p, dp);
    bernstein_derivative(n, q, dq);
    bernstein_derivative(n - 1, dp, ddp);
    bernstein_derivative(n - 1, dq, ddq);
    bernstein_multiply(n - 1, dp, n - 2, ddq, a);
    bernstein_multiply(n - 2, ddp, n - 1, dq, b);
    out->n = 2 * n - 3;
    for (int i = 0; i <= out->n; i++)
        out->c[column][i] = a[i] - b[i];
    bernstein_derivative(out->n, out->c[column], first);
    bernstein_derivative(out->n - 1, first, second);
    out->bend[column] = 0;
    for (int i = 0; i <= out->n - 2; i++)
        out->bend[column] = real_max(out->bend[column], real_abs(second[i]));
}

/* What is found without Bernstein coefficients is what is found with them. */
static void test_polynomials(void **state)
{
    (void)state;
    struct region *r = region_new();
    int compared = 0;
    for (int i = 0; i < trials(600); i++) {
        struct family family;
        family_open(&family, 42, 3, 5, (uint64_t)i);
        const struct control_family *f = &family.owned.problem.family;
        assert_int_equal(find(&family, "region_carriers", family.region), SOLVED);
        if (!f->weight && f->count == f->degree + 1 && is_compact(&family) &&
            family.region->disc_radius > size_of(&family) / 100) {
            real n[9], x[9], y[9];
            struct polynomial p;
            for (int j = 0; j < f->count; j++) {
                n[j] = f->share[j];
                x[j] = f->x[j] - f->share[j] * f->at.x;
                y[j] = f->y[j] - f->share[j] * f->at.y;
            }
            minor(f->degree, n, y, &p, 0);
            minor(f->degree, x, n, &p, 1);
            minor(f->degree, x, y, &p, 2);
            for (int c = 0; family.owned.problem.sign < 0 && c < 3; c++)
                for (int j = 0; j <= p.n; j++)
                    p.c[c][j] = -p.c[c][j];
            struct region_functions g = {&p,     polynomial_line,  polynomial_bend,
                                         {0, 0}, size_of(&family), family.owned.problem.interval,
                                         1e-6,   10000000};
            solve(&g, r);
            assert_int_equal(r->kind, REGION_BOUNDED);
            if (real_abs(r->area - family.region->area) > family.region->area / 1000)
                fail_msg("%s: areas %g and %g", family.c.id, r->area, family.region->area);
            compared++;
        }
        family_close(&family);
    }
    assert_true(compared > 3);
    free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_curves),
        cmocka_unit_test(test_polynomials),
    };
    return cmocka_run_group_tests_name("region_functions", tests, NULL, NULL);
}
