/* The referee's pair over the rationals: moved and scaled exactly, and rounded to binary128. */
#ifndef FATLINE_REFEREE_PAIR_H
#define FATLINE_REFEREE_PAIR_H

#include "case.h"
#include "referee_krawczyk.h"

/* Homogeneous coefficients x, y, w: at[k * (degree + 1) + i]. */
struct referee_curve {
    int degree;
    mpq_t *at;
};

/* The pair moved so that f begins at the origin and scaled by powers of two to magnitude at most 1. */
struct referee_pair {
    bool rational;
    struct referee_curve f, g;
    double size; /* largest |coordinate| of the pair as given */
    double unit; /* of the scaled pair, in coordinates as given */
};

void referee_pair_make(const struct test_case *c, struct referee_pair *p);
void referee_pair_clear(struct referee_pair *p);
/* Every coefficient within 2^-112 of its size; exact if it has at most 113 bits. */
void referee_pair_round(const struct referee_pair *p, struct quad_pair *q);

void rational_from_quad(mpq_t a, __float128 q); /* exact; q is finite */

#endif
