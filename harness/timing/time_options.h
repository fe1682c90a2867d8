/* The command line of `fatline time`.  Compiled for each precision. */
#ifndef FATLINE_TIME_OPTIONS_H
#define FATLINE_TIME_OPTIONS_H

#include "../cases/selection.h"
#include "../run/algorithms_named.h"
#include "timing.h"

struct time_settings {
    struct algorithms_named algorithms;
    struct selection cases;
    int externals;
    char **external;      /* commands */
    const char *baseline; /* NULL: none */
    const char *family_by;
    struct timing_plan plan;
    const char *output; /* NULL: standard output */
    int max_steps, cpu; /* cpu -1: none */
    double timeout;
    bool batch;
    enum batch_variant variant;
    char batch_name[32];
    bool human, rows, single, resume, dry_run, count_instructions, no_floor;
};

/* On wrong usage it says so and exits with status 64. */
void time_settings_read(int argc, char **argv, struct time_settings *s);
void time_settings_clear(struct time_settings *s);

#endif
