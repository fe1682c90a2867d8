/* Signs and roots of forms on [0, 1]. */
#ifndef FATLINE_SIGNS_H
#define FATLINE_SIGNS_H

#include "work.h"

/* HOLDS: the form is >= -bound everywhere, bound a form as well.  FAILS: at `where` it is less.  UNSURE: out
 * of steps, or nearer to -bound than the arithmetic tells. */
enum verdict { HOLDS, FAILS, UNSURE };
enum verdict form_holds(struct region_work *k, int n, const real *c, const real *bound, real *where);

/* Roots in [0, 1] at which a form changes its sign, in increasing order, each as good as the arithmetic
 * allows; coefficients err by at most error[i].  At most `room`; returns their number, -1 if there are more.
 */
int form_crossings(struct region_work *k, int n, const real *c, const real *error, int room, real *out);

#endif
