/* `fatline compare`: is one build, or one run, slower than another?  Compiled for each precision. */
#ifndef FATLINE_COMPARE_H
#define FATLINE_COMPARE_H

#include <stdbool.h>
#include <stdint.h>

#include "../run/algorithms_named.h"

struct compare_settings {
    struct algorithms_named algorithms;
    const char *build[2]; /* folders; NULL: rows are compared */
    char **file;          /* cases, or two files of rows */
    int files;
    const char *tolerance, *max_steps;
    const char *reference; /* of rows: whose times divide all others of the same run; NULL: floor */
    int generations, rounds;
    uint64_t seed;
    double floor; /* below which no difference is called; NAN: the noise floor that is known */
    bool instructions, json;
};

/* ratio: the second to the first.  SAME: within the floor, or not to be told from it. */
enum change { SAME, SLOWER, FASTER };
struct comparison {
    const char *family, *algorithm;
    double ratio, lo, hi, floor;
    int pairs;
    const char *what; /* "cpu", "reference" or "instructions" */
};

enum change comparison_change(const struct comparison *c);
/* A line of the table, or a row. */
void comparison_write(const struct compare_settings *s, const struct comparison *c);

/* Each returns the exit status, and adds up what was compared and what is slower.  compare_files says whom it
 * divides by in s->reference. */
int compare_builds(const struct compare_settings *s, int *compared, int *slower);
int compare_files(struct compare_settings *s, int *compared, int *slower);

#endif
