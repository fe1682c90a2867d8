/* Between our problems and answers and those of adapters. */
#ifndef FATLINE_FOREIGN_ANSWER_H
#define FATLINE_FOREIGN_ANSWER_H

#include "../bezier.h"
#include "peer.h"

/* The two kinds, and their `intersect`. */
extern const struct foreign_kind foreign_shared_object, foreign_program;
enum outcome foreign_intersect(const struct problem *p, struct workspace *w, struct crossings *out);
enum outcome foreign_program_intersect(const struct problem *p, struct workspace *w, struct crossings *out);

/* number: room for 3 (degree + 1), to which `to` will point. */
void foreign_curve(const struct curve *c, double *number, struct peer_curve *to);

/* Roots become points, moved into [0, 1] where they lie outside by at most the tolerance of the problem or
 * FOREIGN_BEYOND; those farther out, or that are no numbers, are left out.  An overlap whose ends are not
 * told is all of both curves, of which nothing is claimed but that they lie in one box. */
enum outcome foreign_answer(const struct problem *p, enum peer_outcome outcome,
                            const struct peer_roots *roots, struct crossings *out);

#endif
