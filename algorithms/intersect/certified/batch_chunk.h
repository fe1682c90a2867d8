/* What the lanes work on: a few hundred pairs, and the lists between one step and the next. */
#ifndef FATLINE_BATCH_CHUNK_H
#define FATLINE_BATCH_CHUNK_H

#include "../../batch.h"

enum {
    CHUNK = 512,
    ITEMS = 4096,
    SOLVES = 512,
    SLACK = 16, /* numbers beyond the end of a list */
    ROUNDS = 14 /* halvings beyond the first cut in four */
};

/* Pairs of nodes that may meet.  Pairs are numbered from the chunk's first.  Node 1 is the whole curve, the
 * halves of node k are 2k and 2k + 1: so node 2^d (1 + a) begins at a and is 2^-d long. */
struct batch_items {
    int count;
    int pair[ITEMS + SLACK];
    double f[ITEMS + SLACK], g[ITEMS + SLACK];
};

/* Nodes whose directions all cross the same way: the start of Newton's method, and what cone.c proves of
 * them: reach and bend as in solve_one.c. */
struct batch_solves {
    int count;
    int pair[SOLVES + SLACK];
    double f[SOLVES + SLACK], g[SOLVES + SLACK];
    double t[SOLVES + SLACK], s[SOLVES + SLACK];
    double reach_t[SOLVES + SLACK], reach_s[SOLVES + SLACK];
    double bend_f[SOLVES + SLACK], bend_g[SOLVES + SLACK];
};

struct batch_chunk {
    const struct batch *batch;
    double tolerance; /* within the bounds of problem_solve */
    int first, count; /* count <= CHUNK */
    struct batch_record *record;
    int records, room;
    bool full;                  /* there was no room for a record */
    unsigned char alone[CHUNK]; /* to be solved by itself, whatever was found; its records say nothing */
    int alone_count;
    double unit[CHUNK + SLACK]; /* (REAL_EPSILON / 2) times the largest |coordinate| of a pair */
    int all[CHUNK + SLACK];     /* 0 to count - 1, and the last again */
    int crossed;                /* pairs to be cut in four */
    int crossed_pair[CHUNK + SLACK];
    struct batch_items items[2];
    struct batch_solves solves;
};

/* Finds and proves all crossings of the chunk's pairs but of those it leaves `alone`. */
void batch_chunk_avx512(struct batch_chunk *z);
void batch_chunk_avx2(struct batch_chunk *z);

#endif
