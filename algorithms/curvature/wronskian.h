/* The three forms that govern a family on one knot span: the envelope w, the half-planes L, and M.
 *
 * For F = (S + d eta) / W let w = (-(S1'W - S1 W'), -(S2'W - S2 W'), eta'W - eta W'): the envelope in
 * homogeneous coordinates.  det(F', F'') has the sign of L . (d, 1) with L = w x w' / W, the tangent of the
 * envelope, and L x L' = M w / W with M = Wr(W, eta, S1, S2), all up to positive constants.  Polynomial
 * families have W = 1 and lower degrees. */
#ifndef FATLINE_WRONSKIAN_H
#define FATLINE_WRONSKIAN_H

#include <stdbool.h>

#include "../core/real.h"

/* Bernstein coefficients 0..n of one span; wt == NULL: 1.  Coefficients err by at most 4 n REAL_EPSILON times
 * their own size. */
struct span_input {
    int n;
    const real *s1, *s2, *eta, *wt;
};

/* Unscaled Bernstein forms on [0, 1], without the common factors of t and of 1 - t of their components.
 * e: degree of w; w holds its 3 components.  l: degree of L; L holds A, B, C and a bound of the error of each
 * coefficient of these in units of REAL_EPSILON.  m: degree of M (< 0: M vanishes identically, to rounding);
 * M holds its coefficients and bounds of their errors, absolute. */
struct span_forms {
    int e, l, m;
    bool bare_start, bare_end; /* L had a common factor t (1 - t): h vanishes there for every d */
    bool fixed;                /* A = B = 0 */
    bool still;                /* w = 0: the curve does not move at all on this span */
    real *w, *L, *M;
};

/* Degrees before factors are taken out. */
int envelope_degree(int n, bool rational);
int planes_degree(int n, bool rational);
int torsion_degree(int n, bool rational);

/* Fills f, whose arrays hold 3 (e + 1), 4 (l + 1) and 2 (m + 1) for the degrees above. */
void span_forms_make(const struct span_input *s, const real *pascal, struct span_forms *f);

#endif
