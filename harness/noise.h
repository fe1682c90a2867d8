/* Is this machine quiet enough to time anything, and how small a difference means something on it?
 * Precision-independent: compiled once, as C. */
#ifndef FATLINE_NOISE_H
#define FATLINE_NOISE_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

struct noise {
    double wall, stolen, total; /* seconds; jiffies of all processors */
    long switches;
    double load;
    int cpus;
};

void noise_begin(struct noise *n);
/* What disturbed us since: a line each on `stream`.  Returns how many. */
int noise_warn(const struct noise *n, FILE *stream);

/* The noise floor that `fatline doctor` found with the programs beside this one, as a relative difference
 * below which none is called; NAN: it was not asked yet. */
double noise_floor(void);
bool noise_floor_save(const json_t *row);
/* The same as a member of an environment line: a number, or null. */
void noise_floor_note(json_t *environment);

#ifdef __cplusplus
}
#endif
#endif
