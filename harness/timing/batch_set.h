/* The pairs of a family as one batch, its answer, and the memory of both.  Compiled for each precision. */
#ifndef FATLINE_BATCH_SET_H
#define FATLINE_BATCH_SET_H

#include "../../algorithms/batch.h"
#include "../cases/case_set.h"

/* A batch has one tolerance, the least of its pairs, and one step limit. */
struct batch_set {
    struct batch batch;
    struct batch_answer answer;
    int count;
    int *place; /* [count]: number in the batch; -1: not taken (rational, degree above 3, another domain) */
    int *first; /* [batch.pairs + 1]: where the records of a pair begin in `order` */
    int *order; /* numbers of records, pair by pair */
    real *points;
    unsigned char *degree;
    void *workspace, *memory; /* the second as allocated */
};

/* The pairs at[index[0..count-1]]; index NULL: at[0..count-1]. */
void batch_set_make(struct batch_set *b, int count, const struct loaded_case *const *at, const int *index,
                    enum batch_variant variant);
/* Solves all; the arrays of the answer grow until they hold it. */
void batch_set_solve(struct batch_set *b);
/* Solves the pairs first..last-1 of those taken again, into the same arrays. */
void batch_set_run(struct batch_set *b, int first, int last);
/* After batch_set_solve: what it said of pair i, sorted as problem_solve does. */
enum outcome batch_set_answer(const struct batch_set *b, int i, struct crossings *out);
void batch_set_clear(struct batch_set *b);

#endif
