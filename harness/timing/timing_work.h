/* One contender at work: asked for an answer, or as a task for the clock.  Compiled for each precision. */
#ifndef FATLINE_TIMING_WORK_H
#define FATLINE_TIMING_WORK_H

#include "timing.h"

/* One contender at work on pairs at[index[0..]]. */
struct work {
    const struct contender *contender;
    const struct loaded_case *const *at;
    const int *index;
    struct timing_memory *memory;
    struct heartbeat *heartbeat; /* or NULL */
    int number;                  /* of the contender */
    int failures;                /* of an external program */
    char failure[100];
    struct batch_set judged, timed; /* of a batch: the whole family, and the pairs to be timed */
};

/* Other people's code in a program of its own, which times itself. */
bool work_is_program(const struct contender *c);

/* Pairs at[0..count-1] are about to be asked for. */
void work_begin(struct work *w, int count);
void work_end(struct work *w);

/* The answer to pair at[i], other people's code behind its guard. */
struct answer work_ask(struct work *w, int i);

/* Hands the pairs to a program that times itself; false if it did not get them all. */
bool work_hand_over(struct work *w, int pairs);
struct clock_task work_task(struct work *w, int pairs);

#endif
