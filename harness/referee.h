/* The second judge, for masses of pairs: subdivision with Krawczyk's test at binary128.  It shares no code
 * with any algorithm under test nor with exact.c.  Compiled once, as C. */
#ifndef FATLINE_REFEREE_H
#define FATLINE_REFEREE_H

#include "case.h"

#ifdef __cplusplus
extern "C" {
#endif

/* As exact_solve, for pairs whose solutions are all simple: fills in c->expected with parameters good to 40
 * digits.  NULL, or why it gives no verdict (a cell stayed undecided: contact, overlap, degenerate; or a root
 * so near to an end of a domain that it cannot be told on which side it lies); c is then as it was. */
const char *referee_solve(struct test_case *c);

#ifdef __cplusplus
}
#endif
#endif
