/* The true answer, in exact arithmetic (FLINT and Arb).  Precision-independent: compiled once, as C. */
#ifndef FATLINE_EXACT_H
#define FATLINE_EXACT_H

#include "../cases/case.h"

#ifdef __cplusplus
extern "C" {
#endif

struct exact_limits {
    int digits;     /* of the parameters; at least 40 */
    double seconds; /* give up after so long; 0: never */
};

/* Fills in c->expected (freeing what was there), c->class_name and the JSON of both ("expected", "class",
 * "flags") with the certified solutions in the closed domains.  NULL, or why there is no answer. */
const char *exact_solve(struct test_case *c, const struct exact_limits *limits);

#ifdef __cplusplus
}
#endif
#endif
