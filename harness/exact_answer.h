/* What is known of a pair: of which points and arcs an answer is made, and how it enters the case. */
#ifndef FATLINE_EXACT_ANSWER_H
#define FATLINE_EXACT_ANSWER_H

#include "case.h"
#include "exact_overlap.h"

struct exact_answer {
    struct exact_pair pair;
    fmpz_t scale[2]; /* coordinates of the pair's plane per unit of the case's, in x and in y */
    struct point_list points;
    struct range_list ranges;
    bool same_carrier, point_curve;
};

/* Replaces c->expected and c->class_name, and "expected", "class", "flags" of c->line.  Parameters get
 * `digits` significant decimal digits.  NULL, or why not. */
const char *exact_answer_write(struct exact_answer *a, struct test_case *c, int digits);

/* Evaluates a curve at a parameter in [0, 1] (exact_facts.c): its point and derivative, in the case's plane.
 */
struct exact_facts {
    double x, y;
    double sine; /* 0: exactly parallel; NAN: a derivative vanishes, or parts of one algebraic curve */
    double cond; /* NAN unless the crossing is simple */
};
/* Balls of the two points touch: equal, or nearer than 2^-128 of their size. */
bool exact_same_place(const struct exact_answer *a, const struct exact_point *p, const struct exact_point *q);
struct exact_facts exact_facts_of(const struct exact_answer *a, const struct test_case *c,
                                  struct exact_point *p);

#endif
