/* Holds every record to its word, without any tolerance.  Compiled for each precision.
 *
 * Every solution lies in a record or an overlap; in one that proves something, or else in candidates only.  A
 * UNIQUE holds exactly one solution, of the multiplicity it says (simple, if it says none); an END at most
 * one, a simple one; a CLUSTER no more than it says.  An overlap that is there lies within the outer ranges
 * of a record, or of crossings; an overlap called exact is one of those that are there.  Solutions known to
 * `digits` digits are let move by two units of the last. */
#ifndef FATLINE_JUDGE_STRICT_H
#define FATLINE_JUDGE_STRICT_H

#include "../../algorithms/bezier.h"
#include "../cases/case.h"

/* How many words are broken; `why` (256 bytes): the first one, with the place. */
int judge_strict(const struct test_case *c, const struct crossings *x, int digits, char why[256]);

/* a->lo - pad <= q <= a->hi + pad? */
bool interval_holds(const struct interval *a, const mpq_t q, const mpq_t pad);

#endif
