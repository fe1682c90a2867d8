/* The command line of `fatline check`.  Compiled for each precision. */
#ifndef FATLINE_CHECK_OPTIONS_H
#define FATLINE_CHECK_OPTIONS_H

#include "../cases/selection.h"
#include "../run/resume.h"
#include "../run/solving.h"

enum truth { TRUTH_GIVEN, TRUTH_EXACT, TRUTH_KRAWCZYK, TRUTH_EITHER };

struct check_options {
    struct selection cases;
    struct solving solving;
    double tolerance;
    double points;             /* judge points one to one within this reach; 0: by the judge's own rules */
    int jobs, sample;          /* sample: one case in so many of each class */
    const char *output;        /* or NULL: standard output */
    const struct resume *past; /* what is done already; NULL: nothing */
    enum truth truth;
    bool strict; /* hold every record to its word, and time each solve */
    bool rows, keep_going, quiet, resume, dry_run;
};

/* Ends the program with status 64 where the command line is wrong. */
void check_options_read(int argc, char **argv, struct check_options *o);
void check_options_clear(struct check_options *o);

#endif
