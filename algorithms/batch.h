/* Many pairs of curves in one call: polynomial curves of degree 1 to 3 over [0, 1], eight pairs at a time
 * where the machine can.
 *
 * Every pair gets what problem_solve says of it with `certified`: the same records with the same standings,
 * whose intervals hold the same solutions and so meet; their bits differ.  Only where rounding is not small
 * against the curves (far from the origin, and tiny) one of the two may prove that nothing is there while the
 * other reports an END, whose zero is beyond the end, or a CANDIDATE.  No allocation, no static state:
 * thread-safe if workspace and answer are not shared. */
#ifndef FATLINE_BATCH_H
#define FATLINE_BATCH_H

#include "bezier.h"

enum { BATCH_NUMBERS = 8 }; /* of a curve: x[0..3], then y[0..3] */

/* Curve i has its control points in points[8 i ..]: x at 0..degree[i], y at 4..4 + degree[i]; the rest of the
 * eight is not looked at.  degree NULL: all are cubics.  Fastest where points is aligned to 64 bytes. */
struct batch_curves {
    const real *points;
    const unsigned char *degree;
};

/* BATCH_BEST: whatever is fastest on this machine. */
enum batch_variant { BATCH_BEST, BATCH_PORTABLE, BATCH_AVX2, BATCH_AVX512 };

/* Pair k is f's curve f_index[k] with g's g_index[k]; NULL: k.  f and g may be one table, and a curve may be
 * in many pairs; indices are not checked. */
struct batch {
    struct batch_curves f, g;
    const int *f_index, *g_index;
    int pairs;
    real tolerance; /* width asked for, as in struct problem */
    int max_steps;  /* of each pair that is solved by itself, as in struct problem */
    enum batch_variant variant;
};

struct batch_record {
    struct crossing at;
    int pair;
};

struct batch_overlap {
    struct overlap at;
    int pair;
};

/* The arrays are the caller's.  outcome[k], an enum outcome, for every pair; records of one pair need not be
 * next to each other, nor pairs in order. */
struct batch_answer {
    struct batch_record *record;
    struct batch_overlap *overlap;
    unsigned char *outcome;
    int record_room, overlap_room;
    int records, overlaps;
    int done;  /* pairs 0..done-1 are settled */
    int alone; /* of these so many were solved by themselves */
};

size_t batch_workspace_size(void);

/* Settles the pairs first..pairs-1; records and overlaps are written from 0 on.  SOLVED: all have been, each
 * with its own outcome.  OUT_OF_ROOM: an array was full; records and overlaps are those of the pairs
 * first..done-1, all of them, and a call with first = done goes on.  INVALID: tolerance, max_steps, pairs or
 * first are none, or this machine (or precision) has no such variant; done = first.
 * `workspace` has batch_workspace_size() bytes, aligned as malloc aligns. */
enum outcome batch_solve(const struct batch *b, int first, void *workspace, struct batch_answer *out);

extern const struct intersector *const batch_algorithm; /* whose answers a batch gives: `certified` */
bool batch_has(enum batch_variant variant);             /* on this machine, at this precision */

#endif
