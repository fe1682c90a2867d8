/* Solving where a crash, a hang or a lost stack must be an answer and not our own end.  Compiled for each
 * precision.
 *
 * Other people's code in this process is called in a servant: a child that is forked when first needed, gets
 * the problem and gives the answer through shared memory, and is replaced when it dies or is late. Everything
 * else is called directly. */
#ifndef FATLINE_GUARD_H
#define FATLINE_GUARD_H

#include "../algorithms/bezier.h"

/* As problem_solve; CRASHED or TIMED_OUT without records if it had to be ended. */
enum outcome guard_solve(const struct problem *p, const struct intersector *a, struct workspace *w,
                         struct crossings *out);
/* Seconds that other people's code may take for a pair (10). */
void guard_set_timeout(double seconds);
/* Ends the servant, if there is one. */
void guard_end(void);

/* Other people's code whose servant, or program, is not to be had: why; NULL for everything else. */
const char *guard_absent(const struct intersector *a);

#endif
