/* Krawczyk's test for f(t) = g(s): existence and uniqueness of a zero in a box of parameters, and its
 * narrowing. */
#ifndef FATLINE_KRAWCZYK_H
#define FATLINE_KRAWCZYK_H

#include "arc.h"
#include "interval.h"

/* NO_ZERO: none in the given box.  ONE_ZERO: some box that contains the given one holds exactly one zero of
 * the pair (extended past its ends as polynomials, or as quotients of them), and it lies in the box returned,
 * which is as narrow as rounding allows, may reach past [0, 1], and meets the given one.  UNDECIDED: nothing
 * is proved.
 *
 * Proved for all curves within the errors of f and g, of degree KRAWCZYK_DEGREE_MAX at most. */
enum { KRAWCZYK_DEGREE_MAX = 32 };
enum proof { UNDECIDED, NO_ZERO, ONE_ZERO };
enum proof krawczyk_narrow(const struct arc *f, const struct arc *g, struct interval *t, struct interval *s);

#endif
