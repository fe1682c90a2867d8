/* Compares an answer with the truth.  Compiled for each precision.
 *
 * Let tol = case_tolerance(case, asked).  Records that touch after widening by tol form a group.  A solution is
 * found if a group, widened by tol, contains it and no side of the group exceeds 4 tol; a larger group is
 * `merged`.  A CLUSTER is right only if also at_most lies between the sum of the multiplicities it holds and that
 * sum plus 1.  A group without a solution is `extra` if it holds a UNIQUE, or if the curves are farther apart
 * over it than tol times size; else `undecided`.  A second UNIQUE at one simple solution is a `duplicate`.
 * An outcome other than SOLVED is counted apart, never right. */
#ifndef FATLINE_JUDGE_H
#define FATLINE_JUDGE_H

#include "answer.h"
#include "case.h"

enum verdict {
    RIGHT,       /* SOLVED, all found, nothing else but undecided groups beside */
    WRONG,       /* missed, extra, duplicate or merged is not 0 */
    STOPPED,     /* OUT_OF_STEPS or OUT_OF_ROOM with every solution covered and nothing extra proved */
    NOT_TAKEN,   /* UNSUPPORTED or INVALID */
    UNJUDGED     /* no truth known */
};

struct judgement {
    enum verdict verdict;
    int expected, found, missed, extra, duplicate, merged, undecided;
    double max_error; /* largest distance of a found solution from the middle of its group, in either parameter */
    int *held;        /* scratch of the judge */
};

const char *verdict_name(enum verdict);
struct judgement judge(const struct test_case *c, const struct problem *p, const struct answer *a, double tol);

#endif
