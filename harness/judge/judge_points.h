/* Compares points with the truth, one to one: for algorithms that report roots as numbers, without intervals.
 * Compiled for each precision.
 *
 * What an algorithm says of one place is a point, the middle: each record that proves exactly one solution,
 * or, where there is none, records that touch after widening by its tolerance; if it reports only points,
 * each. Points and solutions within `reach` of each other in both parameters are paired, the nearest first,
 * each once.  A solution without a point is missed; a point without a solution is a duplicate where it is
 * within reach of one, else extra, unless it lies on an expected overlap.
 *
 * An expected overlap is found if the answer says so in any way, and `overlap` tells how:
 *   ends        an overlap with its ends, within reach of the true ones
 *   end points  two points, the true ends within reach, and none between
 *   said        an overlap without ends, or with others
 *   points N    not said: N points along it
 *   nothing     not said
 *   stopped     the answer is none: it ran out of steps or room
 * An overlap claimed where there is none is extra.  What is not SOLVED claims no points, and is judged by the
 * rules of judge.h. */
#ifndef FATLINE_JUDGE_POINTS_H
#define FATLINE_JUDGE_POINTS_H

#include "judge.h"

struct point_judgement {
    struct judgement found;
    int points;
    char overlap[24]; /* "": none is expected, or the answer is none */
};

struct point_judgement judge_points(const struct test_case *c, const struct problem *p,
                                    const struct answer *a, double reach);

#endif
