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
 * numbers.  By the hull of the control polygon, root_finders[0]. */
int roots_find(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
               struct root *out);
size_t roots_scratch(int n);

/* What a search did: one clip for each interval it looked at, which `watch` is told, if it is not NULL. */
struct root_search {
    int clips;
    void (*watch)(void *log, real lo, real hi);
    void *log;
};

/* The same by one of several clips.  hull: where the hull of the control polygon meets the axis; order 2 per
 * clip at simple roots, linear at others.  quadratic, cubic: where the best approximation of degree k = 2, 3
 * is within its residual of 0 (core/zeros.h); order (k + 1) / m at a root of multiplicity m.  Above degree
 * ZEROS_DEGREE_MAX these take the hull too. */
struct root_finder {
    const char *name, *reference;
    int (*find)(int n, const real *c, const real *error, real tolerance, real *scratch, int room,
                struct root *out, struct root_search *search);
};
extern const struct root_finder *const root_finders[]; /* NULL-terminated */

#endif
