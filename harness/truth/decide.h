/* Settles an answer by exact arithmetic over the rationals.  Compiled for each precision.
 *
 * A UNIQUE as narrow as asked that holds just one solution, a simple one, stays as it is.  Every other
 * solution of the case's curves gets a record of its own, as narrow as the precision allows (of no width if
 * the parameter is a number of it): UNIQUE with its multiplicity (0: not defined, it lies on a common
 * component), also where it was within a CLUSTER, a CANDIDATE or at an END.  Solutions that no two rectangles
 * tell apart share a CLUSTER of the sum of their multiplicities.  Shared arcs become overlaps, exact.  What
 * holds no solution is dropped.
 *
 * The curves are those of the case, as it states them: where this precision only has them rounded, all
 * records are made anew. */
#ifndef FATLINE_DECIDE_H
#define FATLINE_DECIDE_H

#include "../../algorithms/bezier.h"
#include "../cases/case.h"

/* At most so many seconds of processor time, in a process of its own.  NULL: x is settled (it may have been
 * before), and *outcome SOLVED; else why not, and both are as they were. */
const char *decide(const struct test_case *c, const struct problem *p, double seconds, enum outcome *outcome,
                   struct crossings *x);

#endif
