/* The command line of `fatline solve`.  Compiled for each precision. */
#ifndef FATLINE_SOLVE_OPTIONS_H
#define FATLINE_SOLVE_OPTIONS_H

#include "../cases/selection.h"
#include "solving.h"

struct solve_options {
    struct selection cases;
    struct solving solving;
    real tolerance;
    const char *f, *g;
    char *own_line; /* a case line of the curves -f and -g, or NULL */
    const char *output;
    double decide; /* seconds of exact arithmetic for a case; 0: none */
    bool keep_going, human, quiet;
};

/* Ends the program with status 64 where the command line is wrong. */
void solve_options_read(int argc, char **argv, struct solve_options *o);
void solve_options_clear(struct solve_options *o);

#endif
