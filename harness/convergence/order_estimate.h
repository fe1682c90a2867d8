/* The order of convergence from widths that were measured.  Precision-independent: compiled once, as C.
 *
 * Everything is in bits: a box of widths t and s has -(log2 t + log2 s) / 2 bits.  Superlinear convergence of
 * order p per round multiplies the bits by p; linear convergence adds to them. */
#ifndef FATLINE_ORDER_ESTIMATE_H
#define FATLINE_ORDER_ESTIMATE_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* SUPERLINEAR: of order per_round.  LINEAR: order 1, bits_per_round on the average.  STALLED: the widths
 * hardly shrink any more.  EXACT: one round leaves nothing but rounding.  TOO_FEW: not enough rounds above
 * rounding to tell. */
enum law { SUPERLINEAR, LINEAR, STALLED, EXACT, TOO_FEW };

struct order_estimate {
    enum law law;
    double per_round, lo, hi; /* NAN: none */
    int points;               /* widths that the estimate rests on */
    int clips;                /* clips in a round; 0: not known */
    double bits_per_round;    /* of LINEAR and STALLED, else NAN */
};

const char *law_name(enum law law); /* "superlinear", ... */

/* Successive rounds: -log2 of the widths of the boxes that hold one solution, none wider than the one before,
 * the first of them [0, 1]^2.  A round ends as soon as both parameters have been narrowed since the last one
 * ended; what has more than `floor` bits in either is left out.
 *
 * The estimate is the difference estimator (B3 - B2)/(B2 - B1) of the last three rounds, which does not
 * depend on the error constant; the interval reaches as far as the estimate before it.  It counts if it is
 * above 1.15 twice in a row, the last round gained a tenth of all bits, and the three rounds were made of the
 * same number of clips: where these become more and more, convergence is linear after all.  Otherwise the
 * estimator is applied to blocks of a third of all narrowings, clips and halvings alike, two of which are
 * counted as a round; the interval is the range over the blocks that end earlier. */
struct order_estimate order_of_widths(int n, const double *bits_t, const double *bits_s, double floor);

/* Single rounds from boxes of different sizes: bits before and after, in increasing order.  The order is the
 * slope over the smaller half of the boxes; the interval is that of the regression, or as far as the slope
 * over all boxes if that is farther; one wider than 15 percent of the order is no estimate.  below: rounds
 * that ended below the rounding floor. */
struct order_estimate order_of_boxes(int n, const double *before, const double *after, int below);

#ifdef __cplusplus
}
#endif
#endif
