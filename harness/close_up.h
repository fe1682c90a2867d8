/* A pair seen from near: restricted, in exact arithmetic, to boxes around one solution and moved to the
 * origin. Precision-independent: compiled once, as C. */
#ifndef FATLINE_CLOSE_UP_H
#define FATLINE_CLOSE_UP_H

#include "case.h"
#include "known_solutions.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Homogeneous point (w X, w Y, w) of c at local parameter t; the weight of a polynomial curve is 1. */
void curve_point_exact(const struct case_curve *c, const mpq_t t, mpq_t out[3]);

/* The curve over local parameters [lo, hi] as a curve over [0, 1], moved by minus `origin` (Euclidean); its
 * memory is freed by curve_clear. */
void curve_restrict(const struct case_curve *c, const mpq_t lo, const mpq_t hi, mpq_t origin[2],
                    struct case_curve *out);
void curve_clear(struct case_curve *c);

/* f over [t - 7x/20, t + 13x/20] and g over [s - 3y/5, s + 2y/5], where (t, s) is the solution; where a box
 * would leave [0, 1], it begins or ends there.  So the solution is neither in the middle nor, but for an end,
 * at an end. x and y are powers of two: x = 2^-bits_x to 20 bits of its significand.  exchanged: the curve
 * called g becomes f. */
void close_up_make(const struct test_case *c, const struct known_solution *z, double bits_x, double bits_y,
                   bool exchanged, struct test_case *out);
/* Where the solution lies in the boxes, in their local parameters. */
void close_up_solution(const struct known_solution *z, double bits_x, double bits_y, bool exchanged,
                       struct known_solution *out);
void close_up_clear(struct test_case *c);

/* -log2 of the largest |coordinate| of the control points of both curves; infinite if all are 0. */
double extent_bits(const struct test_case *c);

#ifdef __cplusplus
}
#endif
#endif
