/* Cells of the referee: pieces of both curves in doubles, relative to a point nearby (the anchor), each with
 * a bound of its error, so that doubles exclude as surely as binary128 does, only faster.
 *
 * A cell cut from the binary128 coefficients is accurate to about 2^-52 of its own size; halving keeps the
 * bound up; when it has grown too large for the size of the cell, the cell is cut again, with a new anchor.
 */
#ifndef FATLINE_REFEREE_CELLS_H
#define FATLINE_REFEREE_CELLS_H

#include "referee_krawczyk.h"

/* One curve over [lo, lo + width], dyadic: homogeneous coefficients of the curve less the anchor.
 * error: of x and y, absolute; weight_error: of w, relative. */
struct anchored_part {
    quad lo, width;
    double at[3][QUAD_DEGREE_MAX + 1];
    double error, weight_error;
    int halvings; /* of [0, 1] */
};

struct anchored_cell {
    struct anchored_part f, g;
    int since_cut; /* halvings since both parts were cut */
};

/* Cuts the cell over f.lo, f.width, g.lo, g.width; false if a weight is not positive beyond rounding. */
bool anchored_cut(const struct quad_pair *p, struct anchored_cell *c);

/* What excludes and guides, from one look at the cell.
 *   apart: proved that the two pieces do not meet.
 *   promising: a guess that krawczyk_test will decide.
 *   split_f: the piece of f is the larger one.
 *   blurred: the errors are no longer small beside the pieces. */
struct anchored_view {
    bool apart, promising, split_f, blurred;
};
struct anchored_view anchored_look(const struct quad_pair *p, const struct anchored_cell *c);

/* Halves f (or g) of c: c becomes the first half, *second the other. */
void anchored_halve(const struct quad_pair *p, struct anchored_cell *c, bool f, struct anchored_cell *second);

#endif
