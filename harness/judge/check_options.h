/* The command line of `fatline check`.  Compiled for each precision. */
#ifndef FATLINE_CHECK_OPTIONS_H
#define FATLINE_CHECK_OPTIONS_H

#include <regex.h>

#include "../run/algorithms_named.h"
#include "../run/resume.h"

enum truth { TRUTH_GIVEN, TRUTH_EXACT, TRUTH_KRAWCZYK, TRUTH_EITHER };

struct check_options {
    struct algorithms_named algorithms;
    const char *external; /* a command, or NULL */
    double timeout;
    double tolerance;
    double points; /* judge points one to one within this reach; 0: by the judge's own rules */
    int max_steps, room, jobs;
    int sample;                /* one case in so many of each class */
    const char *class_name;    /* or NULL: all */
    const char *id;            /* glob, or NULL: all */
    const char *filter;        /* extended regular expression for ids, or NULL: all */
    regex_t regex;             /* compiled, where there is a filter */
    const char *output;        /* or NULL: standard output */
    const struct resume *past; /* what is done already; NULL: nothing */
    enum truth truth;
    bool strict; /* hold every record to its word, and time each solve */
    bool rows, keep_going, quiet, resume, dry_run;
    char **files; /* count of them, pointers into argv */
    int file_count;
};

/* Ends the program with status 64 where the command line is wrong. */
void check_options_read(int argc, char **argv, struct check_options *o);
void check_options_clear(struct check_options *o);

#endif
