/* Watching a solve (the watched build of the algorithms): widths in bits, and the cells that hold one
 * solution. Compiled for each precision. */
#ifndef FATLINE_PATH_H
#define FATLINE_PATH_H

#include "../algorithms/bezier.h"
#include "known_solutions.h"

/* -log2 a, to double accuracy; infinite for 0. */
double real_bits(real a);

/* The cells taken from the stack that hold the solution, from [0, 1]^2 on; where several do, the one that is
 * taken first.  All other cells are dropped unseen, so that a path to 2,000 bits takes a few steps a round
 * even where the whole solve would never end.  Algorithms that do not use core/cells.h leave none. */
struct path {
    int count, room;
    double *bits_t, *bits_s; /* widths of the cells in the problem's order of f and g */
    bool *split;             /* the cell is a half of the one before, not a clip of it */
    bool kept;               /* the last cell was a record: the solution was not lost */
    int clips, splits;
    /* of the solve being watched */
    const struct workspace *workspace;
    struct interval t, s;
    bool halved, ended;
};

void path_init(struct path *p);
void path_clear(struct path *p);
/* Solves the problem by a with the path of z; overwrites the watchers of w.  What the solve says otherwise is
 * of no meaning. */
void path_follow(struct path *p, const struct problem *problem, const struct intersector *a,
                 struct workspace *w, const struct known_solution *z, struct crossings *out);

#endif
