/* A parameter of the answer as a rational, a text and a double. */
#ifndef FATLINE_EXACT_PARAMETER_H
#define FATLINE_EXACT_PARAMETER_H

#include "../cases/case.h"
#include "exact_roots.h"

/* A parameter of the answer: in the curve's own domain, as rational, text and nearest double. */
struct parameter {
    mpq_t q;
    char *text;
    double nearest;
    bool exact;
};

/* Bits that a parameter of so many decimal digits is known to. */
slong parameter_bits(int digits);

/* p is initialised here.  refine: r may be made more precise; else its ball is what there is.  False if that
 * is too coarse to round. */
bool parameter_set(struct parameter *p, struct real_root *r, const struct case_curve *c, int digits,
                   bool refine);
void parameter_clear(struct parameter *p);

#endif
