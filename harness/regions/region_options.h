/* The command line of `fatline region`. */
#ifndef FATLINE_REGION_OPTIONS_H
#define FATLINE_REGION_OPTIONS_H

#include "../../algorithms/region.h"

enum { REGION_METHODS_MAX = 16 };

/* Options that say nothing of others without them. */
struct region_options_given {
    bool tolerance, max_steps, seed, degree;
};

struct region_options {
    const struct region_method *method[REGION_METHODS_MAX];
    int count;
    real tolerance;
    int max_steps;
    bool check, rows, all_points, keep_going, time;
    bool at_given;
    struct point at;
    long repeat, random; /* 0: not asked for */
    long seed;
    int degree_lo, degree_hi;
    char **files;
    int file_count;
    struct region_options_given given;
};

/* Ends the program with status 64 on wrong usage. */
void region_options_read(int argc, char **argv, struct region_options *o);

#endif
