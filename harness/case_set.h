/* Whole files of cases in memory, ready to be solved: for programs that measure.  Compiled for each
 * precision. */
#ifndef FATLINE_CASE_SET_H
#define FATLINE_CASE_SET_H

#include "../algorithms/bezier.h"
#include "case.h"
#include "problem.h"

struct loaded_case {
    struct test_case c;
    struct owned_problem owned;
    const char *file; /* owned by the set */
    char *line;       /* the case as one line of JSON, for external programs */
};

/* Zeroed: empty. */
struct case_set {
    int count, room;
    struct loaded_case *at;
    int files;
    char **file;
    int degree_f, degree_g; /* the largest */
};

/* Adds the cases of `path` ("-": standard input).  0, or an exit status: 2 if the file cannot be read, 65 if
 * a line is bad; what is wrong was then said on stderr, once for each bad line, and the good lines are added.
 */
int case_set_read(struct case_set *set, const char *path, real tolerance, int max_steps);
/* Keeps the first `count` cases. */
void case_set_shorten(struct case_set *set, int count);
void case_set_clear(struct case_set *set);

#endif
