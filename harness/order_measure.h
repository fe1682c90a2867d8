/* The order of convergence of an algorithm at one solution of a case.  Compiled for each precision. */
#ifndef FATLINE_ORDER_MEASURE_H
#define FATLINE_ORDER_MEASURE_H

#include "../algorithms/bezier.h"
#include "case.h"
#include "known_solutions.h"
#include "order_estimate.h"
#include "path.h"

/* Memory that measurements share. */
struct order_bench {
    struct workspace workspace;
    struct crossings *crossings;
    struct path path;
};

/* Every algorithm in `a` (NULL-terminated), degrees up to n. */
void order_bench_make(struct order_bench *b, const struct intersector *const *a, int n);
void order_bench_clear(struct order_bench *b);

/* Bits of a width above which rounding may be seen: SLACK less than the precision, divided by the
 * multiplicity mu, for a gap of r^mu is compared with the rounding of coordinates. */
double order_floor(const struct known_solution *z);

/* Protocol (i): successive rounds of one solve to `bits` binary places, or to the floor if that comes first.
 */
struct order_estimate order_by_rounds(struct order_bench *b, const struct problem *p,
                                      const struct intersector *a, const struct known_solution *z,
                                      double bits);

/* Protocol (ii): one round from each of many boxes around the solution, x and y = x^shape wide, the pair
 * restricted to them exactly (close_up.h).  The shape is the one that a round leaves behind: it is sought
 * among a few, then iterated.  A round is a cut of the curve of the wider box and then one of the other, or
 * one cut of both; a box that is halved before gives no point. */
struct order_estimate order_by_boxes(struct order_bench *b, const struct test_case *c,
                                     const struct intersector *a, const struct known_solution *z);

/* One cut of f from a box 2^-bits_x by 2^-bits_y: bits of the width that f keeps, NAN if it was not cut, or
 * below the floor; then *below.  exchanged: of g, which then is the first curve. */
double one_cut(struct order_bench *b, const struct test_case *c, const struct intersector *a,
               const struct known_solution *z, double bits_x, double bits_y, bool exchanged, bool *below);

#endif
