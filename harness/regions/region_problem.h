/* From a line to a problem for the methods, in this build's numbers. */
#ifndef FATLINE_REGION_PROBLEM_H
#define FATLINE_REGION_PROBLEM_H

#include "../../algorithms/region.h"
#include "region_case.h"

struct owned_region {
    struct region_problem problem;
    real *memory;
};

/* The case's handle or, with free >= 0, control point `free` of its curve alone.  NULL, or what is wrong
 * ("field: ..."), nothing then being owned. */
const char *owned_region_make(const struct region_case *c, int free_point, real tolerance, int max_steps,
                              struct owned_region *p);
void owned_region_clear(struct owned_region *p);

/* A workspace that fits p, made anew where w is too small; begins zeroed. */
struct owned_workspace {
    struct region_workspace workspace;
    void *memory;
};
void owned_workspace_fit(struct owned_workspace *w, const struct region_problem *p);
void owned_workspace_clear(struct owned_workspace *w);

#endif
