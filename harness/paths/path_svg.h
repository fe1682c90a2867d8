/* The path data of SVG 1.1, attribute `d`: M L H V C S Q T A Z, absolute and relative.  Compiled for each
 * precision.
 *
 * Lines, quadratics and cubics keep the numbers given; relative ones, and the reflected control points of S
 * and T, are sums rounded to `real`. An arc becomes one, two or four rational quadratics of at most a quarter
 * of the ellipse each, with the given ends exactly; its rotation is taken to double accuracy. */
#ifndef FATLINE_PATH_SVG_H
#define FATLINE_PATH_SVG_H

#include "path_set.h"

struct svg_error {
    size_t at; /* byte of the text */
    char what[200];
};

/* Adds the segments of `text` to the draft; false: *error says what is wrong, what was expected, and where.
 */
bool path_svg_read(const char *text, struct path_draft *d, struct svg_error *error);

#endif
