/* One step on two arcs at once: fat curve against fat curve of degree k, preconditioned, with what it proves.
 *
 * Let F = A (f - g), A the inverse of [f'(1/2), -g'(1/2)] to rounding, and p, q polynomials of degree k with
 * |F(z) - (p(t) - q(s))| <= eps on the unit square, z = (t, s).  Let e bound |I - J|, J the Jacobian of p -
 * q, there, by control points of the hodographs, and z* be any point of the square, x its |p - q|. (i) If e r
 * + eps + x < r for some r, then e has spectral radius below 1 and every zero of F in the square lies in the
 * box z* +- r: |z - z*| <= e |z - z*| + |(p - q)(z) - (p - q)(z*)| <= e |z - z*| + eps + x. (ii) If that box
 * lies in the square, it holds a zero: z - F(z) maps it into itself (Brouwer). (iii) If e', the same bound
 * for the Jacobian of F, has spectral radius below 1, F is injective on the square. With (ii) and (iii) the
 * square holds exactly one zero, in the box.  On arcs of length h, eps = O(h^k) in local parameters: order k
 * + 1.  k = 1 compares with Krawczyk's operator, whose line is Taylor's; (i) to (iii) for k = 2 and a conic
 * are in the spirit of Juttler and Moore 2011. */
#ifndef FATLINE_PAIR_H
#define FATLINE_PAIR_H

#include <stdbool.h>

#include "interval.h"
#include "nearby.h"

/* NO_STEP: f and g are too bent, or too parallel.  NOWHERE_MET: no zero.  BOXED: all zeros lie in the box;
 * holds_one: there is exactly one; at_floor: rounding takes up most of the box. */
enum pair_outcome { NO_STEP, NOWHERE_MET, BOXED };

struct pair_box {
    struct interval t, s; /* within [0, 1] */
    bool holds_one, at_floor;
};

/* rf[d - 1] and rg[d - 1] reduce the degrees of f and g to d = 1, ..., k; |coordinates| <= scale.  Where
 * degree k leaves more than a quarter of the square, lower ones are tried too, and the smallest box is taken:
 * on long arcs the slope of a parabola strays farther from 1 than that of a line. */
enum pair_outcome pair_clip(const struct arc *f, const struct arc *g, real scale, const struct reduction *rf,
                            const struct reduction *rg, int k, struct pair_box *out);

#endif
