/* Many pairs of parts of one pair of cubics at once.
 *
 * Where two cubics meet often, many parts of them wait to be settled.  With AVX-512 eight such pairs are
 * taken at a time, by the text and with the bounds of batch_kernel.h and batch_newton.h: what in a batch are
 * nodes of many pairs of curves are nodes of one pair here. */
#ifndef FATLINE_CERTIFIED_CROWD_H
#define FATLINE_CERTIFIED_CROWD_H

#include "front.h"

enum {
    CROWD_MAX = 64,  /* pairs that may wait */
    CROWD_FROM = 9,  /* for so many it is worth it */
    CROWD_LEAST = 2, /* that it goes on with */
    CROWD_SLACK = 16
};

/* Nodes as in batch_chunk.h: node 2^d (1 + a) begins at a and is 2^-d long. */
struct crowd {
    double x[2][4], y[2][4]; /* of f and g */
    double unit;             /* u S, S the largest |coordinate| of both */
    int count;
    double f[2 * CROWD_MAX + CROWD_SLACK], g[2 * CROWD_MAX + CROWD_SLACK];
};

static inline struct interval span_of_node(double code)
{
    int exponent;
    double share = 2 * frexp(code, &exponent) - 1; /* exact, as all that follows */
    struct interval r = {share, share + ldexp(1, 1 - exponent)};
    return r;
}

/* Halves the pairs that wait and settles what it can; what is left waits then, at most 2 CROWD_MAX.
 * false: too much is open, and all is left to the engine (front_leave). */
bool crowd_settle_avx512(struct crowd *c, struct front *z, int last_step);

#endif
