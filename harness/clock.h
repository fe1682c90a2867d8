/* Batches doubled until they are long enough; samples of several tasks interleaved in an order drawn anew
 * each round, so that a slow spell of the machine meets all of them.
 *
 * A pass does every item of a task once: an item repeated in a row would train the branch predictor on
 * itself. Compiled for each precision; knows nothing of curves. */
#ifndef FATLINE_CLOCK_H
#define FATLINE_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

enum {
    CLOCK_TICKS = 100,     /* a sample lasts at least so many ticks of its clock */
    CLOCK_ROUNDS_LEAST = 5 /* rounds done whatever the time allowed, if as many are asked for */
};

/* Items 0..items-1; run does first..last-1, each once, in order.  Its results must end in clock_keep. */
struct clock_task {
    int items;
    void (*run)(void *context, int first, int last);
    void *context;
    bool wall; /* wall-clock time, for work that another process does; else CPU time of this thread */
    /* For work that is timed where it is done, not here (else NULL): nanoseconds of so many passes over all
     * items; the shortest of so many passes for each item.  NAN: it failed. */
    double (*timed)(void *context, int passes);
    void (*timed_each)(void *context, int passes, int items, double *ns);
};

struct clock_plan {
    int rounds;       /* samples of each task; > 0 */
    double seconds;   /* no new round starts after so long; 0: no limit */
    double sample_ns; /* shortest sample worth taking, beside CLOCK_TICKS ticks */
    uint64_t seed;    /* of the order within the rounds */
};

/* Sample r of one task and sample r of another were taken in the same round. */
struct clock_samples {
    int count;  /* the same for all tasks of one call */
    int passes; /* passes over all items in a sample */
    double *ns; /* [count], per item; clock_samples_clear frees it */
};

/* The compiler must assume that somebody reads what p points to. */
static inline void clock_keep(const void *p)
{
    __asm__ volatile("" : : "g"(p) : "memory");
}

double clock_now(bool wall);  /* ns */
double clock_tick(bool wall); /* smallest time that passes between two readings, ns */

/* Fills samples[0..n-1].  Warm-up and calibration are not among them. */
void clock_interleave(int n, const struct clock_task *task, const struct clock_plan *plan,
                      struct clock_samples *samples);
void clock_samples_clear(struct clock_samples *samples);

/* Shortest time of each single item, ns[0..items-1]: the minimum over `passes` passes, the clock read around
 * every item (wall-clock time, whose reading is cheap), the cost of the reading taken off. */
void clock_each(const struct clock_task *task, int passes, double *ns);

#endif
