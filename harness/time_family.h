/* One family of `fatline time`: in a process of its own, or only estimated.  Compiled for each precision. */
#ifndef FATLINE_TIME_FAMILY_H
#define FATLINE_TIME_FAMILY_H

#include "time_options.h"
#include "timing_rows.h"

/* What its worker is told; report.timing is filled in there. */
struct family {
    const struct time_settings *settings;
    const struct loaded_case *const *at;
    struct timing_memory *memory;
    struct timing_report report;
};

/* Writes the rows, or the table, of the family at once, so that an interrupted run leaves whole families
 * behind. Returns how many contenders were timed. */
int time_family_run(struct family *f, struct contender *contender, FILE *out);

/* Seconds, from the first few pairs: all are judged once, and then as many timed as the time allowed holds.
 */
double time_family_estimate(const struct family *f);

#endif
