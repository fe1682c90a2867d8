/* Lemmas 3.2 and 3.3. */
#include <math.h>
#include <stdlib.h>

#include "../../algorithms/core/bernstein.h"
#include "../../algorithms/core/curve.h"
#include "../../algorithms/core/reduce.h"
#include "close_up.h"
#include "lemma_measure.h"
#include "../cases/number.h"
#include "../cases/problem.h"

enum { POINTS = 12 };

/* Norm of the j-th derivative of the residual over a box, -log2. */
static double residual_bits(const struct owned_problem *owned, int k, int j)
{
    const struct curve *f = &owned->problem.f;
    real memory[2 * (DEGREE_MAX + 1) * (REDUCED_MAX + 1)], q[2 * (REDUCED_MAX + 1)],
        rest[2 * (DEGREE_MAX + 1)];
    int n = f->degree;
    real *x = rest, *y = rest + n + 1;
    struct reduction r;
    reduction_init(&r, n, k, memory);
    reduction_apply(&r, 2, f->x, q);
    reduction_residual(&r, 2, f->x, q, rest);
    if (j < 0) {
        real most = 0;
        for (int i = 0; i <= n; i++)
            most = real_max(most, x[i] * x[i] + y[i] * y[i]);
        return real_bits(most) / 2;
    }
    for (int i = 0; i < j; i++) {
        bernstein_derivative(n - i, x, x);
        bernstein_derivative(n - i, y, y);
    }
    return real_bits(norm_infinity(n - j, x, y, 12).hi);
}

struct power_law reduction_law(const struct test_case *c, const struct known_solution *z, bool of_g, int k,
                               int j)
{
    struct power_law law = {NAN, NAN, NAN, NAN, 0};
    double bits[POINTS], value[POINTS];
    /* Coordinates are of size h, residuals of size h^(k+1): the smallest keep 16 bits in double, 48 in multi.
     */
    double most = (REAL_BITS - 16.0 - REAL_BITS / 64) / k, least = fmin(most / 2, 6);
    int count = 0;
    for (int i = 0; i < POINTS; i++) {
        struct test_case near;
        struct owned_problem owned;
        double h = least + (most - least) * i / (POINTS - 1);
        close_up_make(c, z, h, h, of_g, &near);
        if (!owned_problem_make(&near, (real)1, 1, &owned)) {
            double norm = residual_bits(&owned, k, j);
            if (isfinite(norm)) {
                bits[count] = h;
                value[count++] = norm - (j > 0 ? j * h : 0); /* derivatives in the parameter of the curve */
            }
            owned_problem_clear(&owned);
        }
        close_up_clear(&near);
    }
    if (count < POINTS)
        return law;
    int half = count / 2;
    struct line_fit fit = line_fit(count - half, bits + half, value + half);
    law.exponent = fit.slope;
    law.lo = fit.lo;
    law.hi = fit.hi;
    law.points = count - half;
    law.constant = exp2((k + 1 - (j > 0 ? j : 0)) * bits[count - 1] - value[count - 1]);
    return law;
}

static double factorial(int n)
{
    return n < 2 ? 1 : n * factorial(n - 1);
}

/* Least and greatest Bernstein coefficient in degree n of the monic Legendre polynomial of degree m shifted
 * to [0, 1]: those in degree m are (-1)^(m-i) C(m,i) / C(2m,m). */
static void legendre_range(int m, int n, double *least, double *most)
{
    real c[DEGREE_MAX + 1];
    for (int i = 0; i <= m; i++)
        c[i] = (m - i) % 2 ? -binomial(m, i) : binomial(m, i);
    bernstein_elevate(m, c, n - m, c);
    *least = *most = real_to_double(c[0]);
    for (int i = 1; i <= n; i++) {
        *least = fmin(*least, real_to_double(c[i]));
        *most = fmax(*most, real_to_double(c[i]));
    }
    *least /= real_to_double(binomial(2 * m, m));
    *most /= real_to_double(binomial(2 * m, m));
}

double legendre_norm(int m, int n)
{
    double least, most;
    legendre_range(m, n, &least, &most);
    return fmax(most, -least);
}

double legendre_span(int m, int n)
{
    double least, most;
    legendre_range(m, n, &least, &most);
    return most - least;
}

double reduction_constant(const struct test_case *c, const struct known_solution *z, bool of_g, int k, int j)
{
    struct point d[REDUCED_MAX + 2];
    struct owned_problem owned;
    const int m = k + 1;
    if (owned_problem_make(c, (real)1, 1, &owned))
        return NAN;
    const struct curve *f = of_g ? &owned.problem.g : &owned.problem.f;
    int n = f->degree;
    curve_derivatives(n, f->x, f->y, f->w, real_from_rational(of_g ? z->s : z->t), m, d);
    double norm = hypot(real_to_double(d[m].x), real_to_double(d[m].y)) / factorial(m);
    owned_problem_clear(&owned);
    if (j < 0)
        return norm * legendre_norm(m, n);
    /* The j-th derivative is largest at the ends: (m + j)! / (j! (m - j)!) for the polynomial that is 1
     * there. */
    return norm * factorial(m + j) / (factorial(j) * factorial(m - j)) / real_to_double(binomial(2 * m, m));
}
