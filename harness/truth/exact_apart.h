/* exact_solve in a process of its own, which is ended when its time is over.  Compiled once, as C. */
#ifndef FATLINE_EXACT_APART_H
#define FATLINE_EXACT_APART_H

#include "exact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* As exact_solve, but that *e gets what is expected, and the case stays as it is. */
const char *exact_solve_apart(const struct test_case *c, const struct exact_limits *limits,
                              struct case_expected *e);

#ifdef __cplusplus
}
#endif
#endif
