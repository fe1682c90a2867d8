/* Lines that say what a region is.  Compiled for each precision. */
#ifndef FATLINE_REGION_ANSWER_H
#define FATLINE_REGION_ANSWER_H

#include <stdio.h>

#include "../../algorithms/region.h"

struct region_answer {
    const char *id;
    const struct region_method *method;
    enum outcome outcome;
    int sign;
    long steps;
    const struct region *region;
    const struct region_breaks *breaks; /* NULL: not written */
    bool at_given;                      /* a point was asked about: */
    struct point at, nearest;
    enum side side;
    real distance;
};

/* One line of JSON; reals as in the answers of `solve`: numbers in double, texts at quad and multi. */
void region_answer_write(FILE *stream, const struct region_answer *a);

#endif
