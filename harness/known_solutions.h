/* The solutions of a case to as many digits as a measurement needs.  Precision-independent: compiled once, as
 * C. */
#ifndef FATLINE_KNOWN_SOLUTIONS_H
#define FATLINE_KNOWN_SOLUTIONS_H

#include "case.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Local parameters in [0, 1], each right to `bits` binary places (INFINITY: exact).  multiplicity: 0, not
 * known. */
struct known_solution {
    mpq_t t, s;
    double bits;
    int multiplicity;
    double alone;     /* a box 2^-alone wide around it holds no other of these solutions */
    double extent;    /* close_up.h: extent_bits of the pair, moved so that it is the origin */
    double sine_bits; /* -log2 of the sine of the angle of the tangents; 0 where a derivative vanishes or at
                         contacts */
};

struct known_solutions {
    int count;
    struct known_solution *at;
};

/* Takes the solutions that the line gives if they are exact fractions, multiplicities given too, and satisfy
 * f(t) = g(s) in exact arithmetic; else computes them to `digits` digits (harness/exact.h) within `seconds`
 * of processor time (0: no limit), and writes them into c.  NULL, or why there are none: then k holds
 * nothing. */
const char *known_solutions_make(struct test_case *c, int digits, double seconds, struct known_solutions *k);
void known_solutions_clear(struct known_solutions *k);

#ifdef __cplusplus
}
#endif
#endif
