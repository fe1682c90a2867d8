/* Paths: many curves end to end, where two of them meet, and where one meets itself.
 *
 * path_tree: octagons around 8 segments, 64, 512, ...; path_walk: the pairs of segments whose octagons meet,
 * block by block; path_solver: a block of pairs into records; path_records_join: records of one solution at a
 * joint made one.  All memory is the caller's; none of it is kept between calls but what the structs point
 * to. */
#ifndef FATLINE_PATH_H
#define FATLINE_PATH_H

#include <stdint.h>

#include "batch.h"
#include "bezier.h"

/* ---- a path ---- */

enum {
    PATH_END = -1,  /* nothing begins where the segment ends */
    PATH_POINT = -2 /* the segment is one point, that where a neighbour ends or begins: it is passed over */
};

/* `count` curves over [0, 1].  points and degree: the same as a table of batch.h, where degree[i] is 0 if
 * curve i is rational, of a degree above 3 or passed over (its eight numbers are not looked at); both NULL if
 * there is no table, and all takes longer.  next[i]: the segment that begins where i ends, or one of the
 * above; before[i]: the segment whose next is i, or PATH_END.  Both as path_link makes them. */
struct path {
    int count;
    const struct curve *segment;
    const real *points;
    unsigned char *degree;
    int *next, *before;
};

/* Is c, of degree 1..DEGREE_MAX, what problem_solve takes: finite, with weights that are positive and not too
 * different? */
bool path_takes(const struct curve *c);

/* Links the segments first..last-1, which follow each other in this order: neighbours whose ends are the same
 * point exactly, and the last with the first likewise. */
void path_link(struct path *path, int first, int last);

/* ---- the tree ---- */

enum { PATH_FAN = 8, PATH_LEVELS = 11 };

/* Eight boxes of x, y, x + y, x - y. */
struct path_node {
    double low[4][PATH_FAN], high[4][PATH_FAN];
};

/* level[0]: the octagons of the segments, eight a node; level[k]: those of the nodes of level k - 1. */
struct path_tree {
    const struct path *path;
    int levels;
    int count[PATH_LEVELS]; /* boxes of each level, less than eight of them on the last one */
    struct path_node *level[PATH_LEVELS];
};

size_t path_tree_size(int count); /* bytes, aligned as malloc aligns */
void path_tree_make(struct path_tree *tree, const struct path *path, void *memory);

/* ---- the walk ---- */

struct path_pair {
    int i, j; /* segments of the first and of the second path; of one path i < j */
};

/* Two nodes whose boxes meet. */
struct path_place {
    int level_a, a, level_b, b;
};

enum { PATH_WAIT = 2 * PATH_LEVELS * PATH_FAN * PATH_FAN, PATH_BLOCK_LEAST = PATH_FAN * PATH_FAN };

/* Bit 8 i + k, for the i that are bits of `which`: box i of `from` meets box k of `to`. */
typedef uint64_t path_boxes(const struct path_node *from, unsigned which, const struct path_node *to);

struct path_walk {
    const struct path_tree *a, *b;
    bool self; /* a path against itself */
    path_boxes *boxes;
    long tests; /* so many boxes were held against eight others */
    int waiting;
    struct path_place place[PATH_WAIT];
};

void path_walk_begin(struct path_walk *walk, const struct path_tree *a, const struct path_tree *b);

/* The next pairs whose octagons meet, at most `room` (at least PATH_BLOCK_LEAST); 0: there are no more. Every
 * pair of segments (two different ones of one path) that have a point in common is among those of all calls,
 * and none twice. */
int path_walk_next(struct path_walk *walk, struct path_pair *out, int room);

/* ---- records ---- */

/* From parameter lo of segment `first` along the path to parameter hi of segment `last`: mostly one and the
 * same; else `last` follows `first`, with or without others between them. */
struct path_span {
    int first, last;
    real lo, hi;
};

/* What problem_solve says of two segments, or, where several solutions at a joint are one, of some.
 *
 * UNIQUE holds exactly one solution, END at most one: the one zero of segments extended past their ends.
 * CLUSTER at most at_most (0: not known), CANDIDATE may hold none.  overlap: the outer ranges are a and b;
 * standing and at_most mean nothing.
 * joint: of neighbours in one path, it holds the point where they join, which is not a crossing, and counts
 * in at_most. chain > 0: of those with the same number, overlaps that go on from one segment to the next, and
 * crossings that touch them there: their solution may be the overlap's own end. */
struct path_record {
    struct path_span a, b;
    enum standing standing;
    int at_most;
    bool joint;
    bool proved; /* beside a joint (joint.c) */
    int chain;
    int overlap; /* its number among the overlaps, or -1 */
    int link;    /* of path_records_join */
};

/* Over a_inner and b_inner, of the segments of the record, the curves stay within distance. */
struct path_overlap {
    struct interval a_inner, b_inner;
    bool reversed;
    real distance;
};

/* The arrays are the caller's. */
struct path_records {
    struct path_record *at;
    struct path_overlap *overlap;
    int count, room, overlaps, overlap_room;
    const int *order; /* at[order[0]], at[order[1]], ...: of path_records_join */
};

struct path_memory; /* of a solver */

struct path_solver {
    const struct path *a, *b;
    bool self;
    real tolerance;
    int max_steps;
    struct path_memory *memory;
    const struct intersector *pairs, *joints, *loops;
    /* what became of all so far */
    long solved, passed; /* pairs of segments intersected; neighbours proved to share their joint only */
    long looped;         /* single segments */
    long unsolved;       /* of all these, not SOLVED */
    enum outcome worst;  /* the first outcome of one that was not */
};

/* So many pairs are taken together, with room for so many records of theirs, and so many that batch.h does
 * not take; room that they, or one segment, may need. */
enum {
    PATH_BATCH = 4096,
    PATH_BATCH_RECORDS = 4096 + (int)CROSSINGS_MAX,
    PATH_BATCH_OVERLAPS = 256,
    PATH_ALONE = 2,
    PATH_RECORDS_LEAST = 4096 + 3 * (int)CROSSINGS_MAX,
    PATH_OVERLAPS_LEAST = 256 + 2 * (int)OVERLAPS_MAX
};

/* Bytes for segments of at most this degree, aligned as malloc aligns. */
size_t path_solver_size(int degree);
/* b: NULL for a path against itself.  tolerance and max_steps as in struct problem. */
void path_solver_init(struct path_solver *z, const struct path *a, const struct path *b, int degree,
                      real tolerance, int max_steps, void *memory);

/* Solves pair[0..count-1] until they are done or there is less room left than PATH_RECORDS_LEAST or
 * PATH_OVERLAPS_LEAST; what is found is added to `out`.  Returns the pairs done. */
int path_solve(struct path_solver *z, const struct path_pair *pair, int count, struct path_records *out);

/* The same for the segments first..last-1 of a path against itself, each alone: where it crosses itself. */
int path_solve_loops(struct path_solver *z, int first, int last, struct path_records *out);

/* Of all records, those at joints that may hold the same solution become one; all->order has all that are
 * left, sorted by the place on the first path, then on the second.  numbers: path_join_size bytes, where that
 * order stays; count_b = 0 for a path against itself. */
size_t path_join_size(int count_a, int count_b, int records);
void path_records_join(const struct path_solver *z, struct path_records *all, void *numbers);

#endif
