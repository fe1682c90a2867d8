/* The implicit equation of a plane Bezier curve as the determinant of its Bezout matrix, and the resultant of
 * two curves in Bernstein form, with proved error bounds.
 *
 * For a of degree d and a point P, let L(i, j) = C(d,i) C(d,j) w_i w_j det(a_i - P, a_j - P).  The Bezout
 * matrix M(P), d x d and symmetric, has the entries M(k, l) = sum over i <= min(k, l), j = k + l + 1 - i <= d
 * of L(j, i). If a(u) = P, then M(P) z = 0 with z_k = (1-u)^(d-1-k) u^k; det M(P) = 0 if and only if a passes
 * through P at some complex or infinite parameter, or is written in too high a degree (then det M vanishes
 * for every P). (E. Bezout 1764; T. Sederberg, D. Anderson, R. Goldman, Implicit representation of parametric
 * curves, 1984; D. Bini, L. Gemignani, Bernstein-Bezoutian matrices, 2004.) */
#ifndef FATLINE_IMPLICIT_H
#define FATLINE_IMPLICIT_H

#include <stdbool.h>
#include <stddef.h>

#include "real.h"

/* Euclidean control points with weights (exact, in (0, 2]; NULL: all 1).  What is meant is any curve within
 * `error` of this one in each coordinate, as control points or as points. */
struct polygon {
    int degree;
    const real *x, *y, *w;
    real error;
};

/* Greatest degree of the curve that is made implicit; the other may have any.  Double 8, quad 10: minors are
 * expanded without division, 2^d d products of polynomials, and a resultant of higher degree has more digits
 * than the number type.  Multi 32: above 4 the determinant is interpolated, which loses a bit or two for each
 * of its d e degrees. */
int implicit_degree_max(void);

/* Coefficients c[0..N], N = a.degree b.degree, of det M(b(v)), times the positive weight of b to the power
 * a.degree, in Bernstein form over v in [0, 1].  error[k] bounds the error of c[k].  It covers rounding and
 * the errors of both polygons: for any true curves within them, the true polynomial has its coefficients
 * within the bounds if they err as control points; if they err as points, then so has, for each u, the
 * polynomial of b moved by their difference at u. In both cases v is among its roots if a(u) = b(v). a.degree
 * <= implicit_degree_max(). */
void implicit_resultant(const struct polygon *a, const struct polygon *b, real *scratch, real *c,
                        real *error);
size_t implicit_scratch(int d, int e); /* also for all lower degrees, and for implicit_invert */

/* Every coefficient drowns in its error: the curves overlap, or one is written in too high a degree. */
bool implicit_vanishes(int n, const real *c, const real *error);

/* All u in [0, 1] for which a may pass within `radius` of (x, y) in each coordinate lie in [*lo, *hi] if
 * INVERTED; NOWHERE: there is none.  AMBIGUOUS: M may have a null space of dimension 2 there, as at a double
 * point of a. */
enum inversion { NOWHERE, INVERTED, AMBIGUOUS };
enum inversion implicit_invert(const struct polygon *a, real x, real y, real radius, real *scratch, real *lo,
                               real *hi);

/* What the two files of this module share.  A ball polynomial of degree n is n + 1 coefficients followed by n
 * + 1 bounds of their errors.  The entry (k, l), k <= l, of M(b(v)) is m + (k d + l) 2 (e + 1), in scaled
 * Bernstein form: coefficients times C(e, q). */
void implicit_matrix(const struct polygon *a, const struct polygon *b, real *m);
void implicit_by_nodes(const struct polygon *a, const struct polygon *b, real *scratch, real *c, real *error);
size_t implicit_by_nodes_scratch(int d, int e);
/* From scaled form to Bernstein coefficients. */
void implicit_unscale(int n, const real *scaled, real *c, real *error);

#endif
