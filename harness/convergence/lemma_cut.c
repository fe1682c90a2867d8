/* Proposition 3.5: one cut. */
#include <math.h>

#include "../../algorithms/core/curve.h"
#include "../../algorithms/core/reduce.h"
#include "lemma_measure.h"
#include "../cases/number.h"
#include "../cases/problem.h"

enum { POINTS = 16 };

/* The largest bits of the wider side for which the cut does not end below the floor. */
static double most_bits(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                        const struct known_solution *z, bool of_g, double shape_x, double shape_y)
{
    double lo = 1, hi = fmin(REAL_BITS, z->bits / 2) / fmax(shape_x, shape_y);
    while (hi - lo > 0.5 + lo / 64) {
        double middle = (lo + hi) / 2;
        bool below;
        double kept = one_cut(b, c, a, z, shape_x * middle, shape_y * middle, of_g, &below);
        if (below || (isnan(kept) && middle > REAL_BITS / 2))
            hi = middle;
        else
            lo = middle;
    }
    return lo;
}

struct power_law cut_law(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                         const struct known_solution *z, bool of_g, bool own)
{
    struct power_law law = {NAN, NAN, NAN, NAN, 0};
    const double shape_x = own ? 1 : 1.6, shape_y = own ? 6 : 1, vanished = 9;
    double most = most_bits(b, c, a, z, of_g, shape_x, shape_y), least = fmax(most / 3, 2);
    double bits[POINTS], value[POINTS];
    int count = 0;
    for (int i = 0; i < POINTS; i++) {
        double size = least + (most - least) * i / (POINTS - 1);
        bool below;
        double kept = one_cut(b, c, a, z, shape_x * size, shape_y * size, of_g, &below);
        if (isfinite(kept)) {
            bits[count] = size;
            value[count++] = kept;
        }
    }
    if (count < POINTS / 2)
        return law;
    int half = count / 2;
    struct line_fit fit = line_fit(count - half, bits + half, value + half);
    if (own && fit.slope > vanished)
        return law; /* of y^2 = x^12: there is no term in x */
    law.exponent = fit.slope;
    law.lo = fit.lo;
    law.hi = fit.hi;
    law.points = count - half;
    law.constant = exp2(nearbyint(fit.slope) * bits[count - 1] - value[count - 1]);
    return law;
}

struct order_estimate jacobi_order(struct order_bench *b, const struct test_case *c,
                                   const struct intersector *a, const struct known_solution *z)
{
    double most = fmin(most_bits(b, c, a, z, false, 1, 1), most_bits(b, c, a, z, true, 1, 1));
    double least = fmax(most / 4, 2), before[POINTS], after[POINTS];
    int count = 0;
    for (int i = 0; i < POINTS; i++) {
        double h = least + (most - least) * i / (POINTS - 1);
        bool below;
        double x = one_cut(b, c, a, z, h, h, false, &below), y = one_cut(b, c, a, z, h, h, true, &below);
        if (isfinite(x) && isfinite(y)) {
            before[count] = h;
            after[count++] = (x + y) / 2;
        }
    }
    return order_of_boxes(count, before, after, 0);
}

struct cut_constants cut_constants(const struct test_case *c, const struct known_solution *z, bool of_g,
                                   int k)
{
    struct cut_constants none = {NAN, NAN, NAN}, found = {0, 0, 0};
    struct point df[REDUCED_MAX + 2], dg[3];
    struct owned_problem owned;
    if (owned_problem_make(c, (real)1, 1, &owned))
        return none;
    const struct curve *f = of_g ? &owned.problem.g : &owned.problem.f;
    const struct curve *g = of_g ? &owned.problem.f : &owned.problem.g;
    int n = f->degree, m = g->degree;
    curve_derivatives(n, f->x, f->y, f->w, real_from_rational(of_g ? z->s : z->t), k + 1, df);
    curve_derivatives(m, g->x, g->y, g->w, real_from_rational(of_g ? z->t : z->s), 2, dg);
    double gx = real_to_double(dg[1].x), gy = real_to_double(dg[1].y), length = hypot(gx, gy);
    double nx = -gy / length, ny = gx / length;
    double omega = fabs(nx * real_to_double(df[1].x) + ny * real_to_double(df[1].y)), factorial = 1;
    double x = real_to_double(df[k + 1].x), y = real_to_double(df[k + 1].y);
    for (int i = 2; i <= k + 1; i++)
        factorial *= i;
    if (k < n) {
        double factor = 1 / (factorial * omega);
        found.own_vector = 2 * legendre_norm(k + 1, n) * factor * hypot(x, y);
        found.own_scalar = legendre_span(k + 1, n) * factor * fabs(nx * x + ny * y);
    }
    if (m > 1) {
        double c_m = (double)(m / 2) * ((m + 1) / 2) / (m * (m - 1));
        found.other = c_m * fabs(nx * real_to_double(dg[2].x) + ny * real_to_double(dg[2].y)) / (2 * omega);
    }
    owned_problem_clear(&owned);
    return found;
}

struct sharpness cut_sharpness(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                               const struct known_solution *z, bool of_g, int k, double c_f, double c_g)
{
    enum { SIZES = 4 };
    static const double shapes[] = {0.7, 0.85, 1, 1.2, 1.5, 1.75, 2, 2.5};
    struct sharpness s = {INFINITY, 0, 0};
    double most = most_bits(b, c, a, z, of_g, 1, 2);
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        for (int j = 0; j < SIZES; j++) {
            double x = most * (0.6 + 0.1 * j), y = shapes[i] * x;
            bool below;
            double kept = one_cut(b, c, a, z, x, y, of_g, &below);
            if (isfinite(kept)) {
                double bound = log2(c_f * exp2((kept - (k + 1) * x)) + c_g * exp2(kept - 2 * y));
                s.least = fmin(s.least, exp2(-bound));
                s.most = fmax(s.most, exp2(-bound));
                s.points++;
            }
        }
    return s;
}
