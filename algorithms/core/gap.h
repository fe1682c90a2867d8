/* The gap between two arcs as a function of one parameter, with its remainder.
 *
 * Theorem.  Let a and b be arcs over u, v in [-1, 1], with coordinates X along and Y across a direction.
 * Suppose that polynomials A, B are within d_X and d_Y of them in these coordinates, that sigma is any
 * polynomial, |X_B(sigma(u)) - X_A(u)| <= rho on [-1, 1], and X_B' >= L > 0 and |Y_B'| <= q X_B' on an
 * interval that holds [-1, 1] and the values of sigma.  If the arcs meet at (u, v), then
 *
 *     |v - sigma(u)| <= eta = (rho + d_X) / L,  |Y_A(u) - Y_B(sigma(u))| <= q (rho + d_X) + d_Y.
 *
 * Proof.  |X_B(v) - X_A(u)| <= d_X, so |X_B(v) - X_B(sigma(u))| <= rho + d_X, and the mean value theorem
 * gives eta.  |Y_B(v) - Y_B(sigma(u))| is at most the integral of |Y_B'| between v and sigma(u), so at most q
 * times that of X_B', which is |X_B(v) - X_B(sigma(u))|; and |Y_A(u) - Y_B(v)| <= d_Y.
 *
 * Order.  Take arcs of length h, A and B of degree k with d = O(h^(k+1)), sigma the power series of degree k
 * of X_B^-1(X_A); all that is dropped is O(h^(k+1)), relative to h in units of u.  At a solution of
 * multiplicity mu where b is regular, the gap Y_A - Y_B(sigma) vanishes to order mu in t, whether a is
 * regular there (contact of order mu) or not (cusp): the gap is the composition of the local equation of b's
 * branch with a, which is how the multiplicity is defined.  So what is kept satisfies c |t - t0|^mu <= C
 * h^(k+1), c > 0: the next length is O(h^((k+1)/mu)). Where k + 1 <= mu, halving sets the pace.
 *
 * Relatives.  Fat arcs: bounds of third order on both curves (Sederberg, White, Zundel, Fat arcs, 1989). Best
 * approximation and inversion of a band in one variable (Barton, Juttler, Computing roots of polynomials by
 * quadratic clipping, 2007).  A fat line against a fat conic after preconditioning, order 3 and, measured,
 * 3/2 (Juttler, Moore, A quadratic clipping step with superquadratic convergence for bivariate polynomial
 * systems, 2011).  Reparametrised quadratics about a graph (Chen, Ma, A planar quadratic clipping method for
 * computing a root of a polynomial in an interval, 2015). */
#ifndef FATLINE_GAP_H
#define FATLINE_GAP_H

#include <stdbool.h>

#include "interval.h"
#include "model.h"
#include "nearby.h"

/* For every solution (t, s), local parameters of a and b in [0, 1]: both polynomials with the Bernstein
 * coefficients above and below are >= 0 at t, and |s - sigma(t)| <= eta, sigma[0..k] being Bernstein
 * coefficients too. */
struct gap {
    int k;
    real above[MODEL_MAX + 1], below[MODEL_MAX + 1], sigma[MODEL_MAX + 1], eta;
};

/* The frame along b's chord: coordinate 0 along, 1 across.  Returns how evenly b's control polygon advances
 * along it: least over greatest step, not above 0 where it turns back; at most 1. */
real gap_frame(const struct arc *b, real scale, struct frame *f);

/* Narrows *t and *s, both [0, 1], to where the arcs a and b have their coordinates along f in common; false:
 * nowhere.
 */
bool gap_common_extent(const struct arc *a, const struct arc *b, const struct frame *f, struct interval *t,
                       struct interval *s);

/* The gap over the whole of a and b, 1 <= k <= MODEL_MAX; ra and rb reduce their degrees to k.  False: b
 * cannot be shown to advance along f, or the two do not face each other. */
bool gap_between(const struct arc *a, const struct arc *b, const struct frame *f, const struct reduction *ra,
                 const struct reduction *rb, int k, struct gap *out);

/* Where s lies for t in [lo, hi]. */
struct interval gap_partner(const struct gap *g, real lo, real hi);

#endif
