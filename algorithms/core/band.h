/* Where a polynomial of degree at most 5 may be >= 0: the inversion of a band. */
#ifndef FATLINE_BAND_H
#define FATLINE_BAND_H

#include "real.h"

enum { BAND_DEGREE_MAX = 5, BAND_PIECES_MAX = 4 };

/* Disjoint closed intervals in [0, 1], in order. */
struct band {
    int count;
    real lo[BAND_PIECES_MAX], hi[BAND_PIECES_MAX];
};

/* A superset of {t in [0, 1] : c(t) >= 0}, k = 1, ..., 5, for the polynomial with exactly these Bernstein
 * coefficients.  Roots are only guessed; a gap between guesses is left out when its Bernstein coefficients,
 * with the rounding bound of bernstein_restrict, prove the polynomial negative there. */
void band_above(int k, const real *c, struct band *out);

/* The union. */
void band_join(const struct band *a, const struct band *b, struct band *out);

/* The common part; at most BAND_PIECES_MAX pieces, the last two joined if there were more. */
void band_meet(const struct band *a, const struct band *b, struct band *out);

#endif
