/* From a case to the build's problem: exact rationals rounded to nearest real.  Compiled for each precision.
 */
#ifndef FATLINE_PROBLEM_H
#define FATLINE_PROBLEM_H

#include "../../algorithms/bezier.h"
#include "case.h"

/* A problem and the memory of its coefficients, and of what the yardstick is told of the roots, if they are
 * known. */
struct owned_problem {
    struct problem problem;
    real *memory;
    struct known *known;
};

/* NULL, or why the case is not a problem in this precision (p then holds no memory): every coefficient x, y,
 * or w, w X, w Y if the curve is rational, is the exact one rounded once. */
const char *owned_problem_make(const struct test_case *c, real tolerance, int max_steps,
                               struct owned_problem *p);
void owned_problem_clear(struct owned_problem *p);

/* A workspace large enough for every algorithm in `a` (NULL-terminated; NULL: none) up to degrees n, m;
 * malloc.  Room: the workspace's own (WORKSPACE_ROOM if in doubt).  Without memory the program ends with
 * status 2. */
void workspace_make(struct workspace *w, const struct intersector *const *a, int n, int m, int room);
void workspace_clear(struct workspace *w);

/* One that grows with what it is asked for.  Zeroed: there is none yet. */
struct fitted_workspace {
    struct workspace workspace;
    int n, m; /* it takes curves of these degrees */
};

/* The workspace, at least as large as workspace_make makes it. */
struct workspace *workspace_fit(struct fitted_workspace *f, const struct intersector *const *a, int n, int m,
                                int room);
void fitted_workspace_clear(struct fitted_workspace *f);

#endif
