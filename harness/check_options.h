/* The command line of `fatline check`.  Compiled for each precision. */
#ifndef FATLINE_CHECK_OPTIONS_H
#define FATLINE_CHECK_OPTIONS_H

#include "algorithms_named.h"

enum truth { TRUTH_GIVEN, TRUTH_EXACT, TRUTH_KRAWCZYK };

struct check_options {
    struct algorithms_named algorithms;
    const char *external; /* a command, or NULL */
    double timeout;
    double tolerance;
    int max_steps, room, jobs;
    int sample;             /* one case in so many of each class */
    const char *class_name; /* or NULL: all */
    const char *id;         /* glob, or NULL: all */
    enum truth truth;
    bool rows, keep_going, quiet;
    char **files; /* count of them, pointers into argv */
    int file_count;
};

/* Ends the program with status 64 where the command line is wrong. */
void check_options_read(int argc, char **argv, struct check_options *o);
void check_options_clear(struct check_options *o);

#endif
