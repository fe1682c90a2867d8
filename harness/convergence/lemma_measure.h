/* The exponents and constants of the first paper's section 3, measured.  Compiled for each precision.
 *
 * Lemma 3.2: ||f - p||_BB <= C h^(k+1) for the best L2 approximation p of degree k on an interval of length
 * h. Lemma 3.3: ||f^(j) - p^(j)||_inf <= C_j h^(k+1-j), j = 0..k. Inequality (3): after one cut of f, x' <=
 * C_f x^(k+1) + C_g y^2.  (4) is the same for g, with the box of f that this cut has left; the paper prints
 * the one before. */
#ifndef FATLINE_LEMMA_MEASURE_H
#define FATLINE_LEMMA_MEASURE_H

#include "order_measure.h"
#include "regression.h"

/* value = constant size^exponent, over `points` sizes; exponent NAN: there is no such law, the value is
 * rounding. */
struct power_law {
    double exponent, lo, hi, constant;
    int points;
};

/* Of the curve called f, or g: 3.2 for j < 0, else 3.3.  k <= REDUCED_MAX, and less than the degree;
 * polynomial. */
struct power_law reduction_law(const struct test_case *c, const struct known_solution *z, bool of_g, int k,
                               int j);
/* The constant that Taylor's theorem gives: f - p is f^(k+1)(t0) / (k+1)! h^(k+1) times the monic Legendre
 * polynomial of degree k + 1 shifted to the interval, up to higher terms. */
double reduction_constant(const struct test_case *c, const struct known_solution *z, bool of_g, int k, int j);

/* Largest |Bernstein coefficient| in degree n >= m of the monic Legendre polynomial of degree m shifted to
 * [0, 1]. */
double legendre_norm(int m, int n);
/* The largest less the least: twice the norm if m is odd, less if it is even. */
double legendre_span(int m, int n);

/* One cut of f against the fat line of g (of_g: the other way round).  own: y = x^6, so that x^(k+1) is what
 * is left; other: x = y^1.6, so that it is y^2. */
struct power_law cut_law(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                         const struct known_solution *z, bool of_g, bool own);
/* Both curves cut from the same squares: the sweep of (4) as printed, in bits after against bits before. */
struct order_estimate jacobi_order(struct order_bench *b, const struct test_case *c,
                                   const struct intersector *a, const struct known_solution *z);

/* C_f for delta taken as the length of the residual (vector) or as the range of its component across the
 * fat line (scalar), and C_g, for a fat line along the chord that holds all control points. */
struct cut_constants {
    double own_vector, own_scalar, other;
};
struct cut_constants cut_constants(const struct test_case *c, const struct known_solution *z, bool of_g,
                                   int k);

/* Least and largest x' / (C_f x^(k+1) + C_g y^2) over boxes of many shapes. */
struct sharpness {
    double least, most;
    int points;
};
struct sharpness cut_sharpness(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                               const struct known_solution *z, bool of_g, int k, double c_f, double c_g);

#endif
