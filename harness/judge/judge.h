/* Compares an answer with the truth.  Compiled for each precision.
 *
 * Let tol = case_tolerance(case, asked).  Records that touch after widening by tol form a group.  A solution
 * is found if a group, widened by tol, contains it and no side of the group exceeds 4 tol; a larger group is
 * `merged`.  A CLUSTER whose at_most is less than the sum of the multiplicities it holds is not right: what
 * it holds is missed.  at_most is an upper bound: where it exceeds that sum by more than 1, the group counts
 * as undecided beside.  A group without a solution is `extra` if it holds a UNIQUE, or if the curves are
 * farther apart over it than tol times size (the largest extent of the pair's control points), proved; else
 * `undecided`, also if it holds a CLUSTER, which promises no solution.  A second UNIQUE at one simple
 * solution is a `duplicate`.
 *
 * OUT_OF_STEPS and OUT_OF_ROOM are counted apart, never right: there a solution is missed only if no record
 * widened by tol contains it; large records and those far from a solution are merely undecided; a UNIQUE
 * without a solution is still extra.
 *
 * Overlaps.  An expected overlap counts as one more that is expected.  It is found if records (of either
 * kind) widened by tol cover it at TRACE_MAX pairs (t, s), else missed: a run of candidates along it
 * has lost nothing, and counts as undecided beside.  A group that meets an expected overlap is neither merged
 * nor extra; a solution beside the overlap is then found in a record by itself, not in the group.  A UNIQUE
 * inside an overlap is extra, and so is an overlap record that claims what is not so: `exact` outside the
 * expected overlaps, or curves farther apart over t_inner than its distance.
 *
 * Points.  An answer of points_only counts as its records' mid points, as candidates. */
#ifndef FATLINE_JUDGE_H
#define FATLINE_JUDGE_H

#include "answer.h"
#include "../cases/case.h"

enum verdict {
    RIGHT,     /* SOLVED, all found, nothing else but undecided groups beside */
    WRONG,     /* missed, extra, duplicate or merged is not 0 */
    STOPPED,   /* OUT_OF_STEPS or OUT_OF_ROOM with every solution covered and nothing extra proved */
    NOT_TAKEN, /* UNSUPPORTED or INVALID */
    UNJUDGED,  /* no truth known */
    BROKEN     /* GAVE_UP, CRASHED or TIMED_OUT */
};

struct judgement {
    enum verdict verdict;
    int expected, found, missed, extra, duplicate, merged, undecided;
    /* Largest distance of a found solution from the middle of its group, in either parameter; NAN: none
     * found. */
    double max_error;
    double missed_t, extra_t; /* where the first was missed, and one too many; NAN: none */
};

const char *verdict_name(enum verdict verdict); /* "RIGHT", ... */
/* The verdict on an answer that has no records to judge, or UNJUDGED. */
enum verdict verdict_without(enum outcome outcome);

/* p: the problem as the case states it, a: its answer in the same parameters. */
struct judgement judge(const struct test_case *c, const struct problem *p, const struct answer *a,
                       double tol);

#endif
