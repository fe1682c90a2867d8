/* One family, timed in a process of its own, so that a crash or a hang there is a result here.  Compiled for
 * each precision. */
#ifndef FATLINE_TIME_WORKER_H
#define FATLINE_TIME_WORKER_H

#include "timing_rows.h"

/* What the child does: writes its rows, or its table, to `to` and returns how many contenders were timed. */
struct family_work {
    int (*work)(void *context, FILE *to, struct heartbeat *heartbeat);
    void *context;
    struct contender *contender;
    int contenders;
    double patience; /* seconds without a sign of life before it is ended */
};

/* Runs the work until it ends well: whoever was at it when the child crashed, or fell silent, is left out of
 * the next try (contender[k].left_out, a malloc'd text).  The text that the child wrote, malloc'd, with
 * *timed; NULL if that is not to be had. */
char *time_worker_run(struct family_work *w, int *timed);

#endif
