/* The command line of `fatline paths`.  Compiled for each precision. */
#ifndef FATLINE_PATH_OPTIONS_H
#define FATLINE_PATH_OPTIONS_H

#include <stdint.h>

#include "../../algorithms/bezier.h"

/* Options that say nothing of others without them. */
struct path_options_given {
    bool tolerance, max_steps, seed, rounds;
};

struct path_options {
    char *files[2]; /* NULL: none */
    const char *output;
    real tolerance;
    int max_steps;
    int random; /* segments of random paths instead of files; 0: none */
    uint64_t seed;
    bool alone, print, time, quiet;
    int rounds;
    const char *beside; /* name of another algorithm, or NULL */
    struct path_options_given given;
};

/* Ends the program with status 64 where the command line is wrong. */
void path_options_read(int argc, char **argv, struct path_options *o);

#endif
