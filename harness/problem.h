/* From a case to the build's problem: exact rationals rounded to nearest real.  Compiled for each precision. */
#ifndef FATLINE_PROBLEM_H
#define FATLINE_PROBLEM_H

#include "../algorithms/bezier.h"
#include "case.h"

/* A problem and the memory of its coefficients. */
struct owned_problem {
    struct problem problem;
    real *memory;
};

/* NULL, or why the case is not a problem (degree above DEGREE_MAX, ...).  bits: 53 in double. */
const char *owned_problem_make(const struct test_case *c, real tolerance, int max_steps, struct owned_problem *p);
void owned_problem_clear(struct owned_problem *p);

/* A workspace large enough for every algorithm in `a` (NULL-terminated) up to degrees n, m; malloc. */
void workspace_make(struct workspace *w, const struct intersector *const *a, int n, int m, int room);
void workspace_clear(struct workspace *w);

#endif
