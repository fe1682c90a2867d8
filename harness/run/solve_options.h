/* The command line of `fatline solve`.  Compiled for each precision. */
#ifndef FATLINE_SOLVE_OPTIONS_H
#define FATLINE_SOLVE_OPTIONS_H

#include "algorithms_named.h"

struct solve_options {
    struct algorithms_named algorithms;
    const char *external; /* a command, or NULL */
    double timeout;
    real tolerance;
    int max_steps, room;
    const char *id; /* glob of the cases to be solved, or NULL: all */
    const char *f, *g;
    char *own_line; /* a case line of the curves -f and -g, or NULL */
    const char *output;
    double decide; /* seconds of exact arithmetic for a case; 0: none */
    bool keep_going, human, quiet;
    char **files; /* count of them, pointers into argv */
    int file_count;
};

/* Ends the program with status 64 where the command line is wrong. */
void solve_options_read(int argc, char **argv, struct solve_options *o);
void solve_options_clear(struct solve_options *o);

#endif
