/* What loops.c has from loop_cubic.c. */
#ifndef FATLINE_CERTIFIED_LOOPS_H
#define FATLINE_CERTIFIED_LOOPS_H

#include "../../crossings.h"

/* LOOP_NONE: f(t) = f(s) has no solution with 0 <= t < s <= 1.  LOOP_FOUND: none outside of *c, which is
 * UNIQUE, END, or, where rounding hides whether there is a loop or a cusp, a CANDIDATE.  LOOP_UNKNOWN: f is
 * not a polynomial cubic, or nearly one of degree 2 or a line. */
enum cubic_loop { LOOP_UNKNOWN, LOOP_NONE, LOOP_FOUND };

/* f over [0, 1], of a prepared problem. */
enum cubic_loop cubic_loop_find(const struct curve *f, struct crossing *c);

/* Candidates that touch become one, which holds them; the order is lost. */
void candidates_unite(struct crossings *out);

#endif
