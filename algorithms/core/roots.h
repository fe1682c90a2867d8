/* All real roots in [0, 1] of a polynomial in Bernstein form whose coefficients are known to within errors.
 *
 * The roots lie where the hull of the control polygon meets the axis; with multiplicity they are no more than
 * the sign changes of the coefficients, and as many modulo 2 (J. Lane, R. Riesenfeld, Bounds on a polynomial,
 * 1981). */
#ifndef FATLINE_ROOTS_H
#define FATLINE_ROOTS_H

#include <stdbool.h>
#include <stddef.h>

#include "real.h"

/* Roots may lie in [lo, hi].  at_most bounds their number with multiplicity for every polynomial within the
 * error of the given one; single: it is exactly one, inside. */
struct root {
    real lo, hi;
    int at_most;
    bool single;
};

/* Encloses all roots in [0, 1] of all polynomials with |coefficient i - c[i]| <= error[i]: disjoint
 * enclosures in increasing order, no wider than `tolerance` or than the errors allow (where the polynomial
 * stays within a few errors of 0, one enclosure covers all of it).  Returns their number, at most `room` >=
 * 1: the last one grows when there are more.  c and error are left alone; scratch holds roots_scratch(n)
 * numbers. */
int roots_find(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
               struct root *out);
size_t roots_scratch(int n);

#endif
