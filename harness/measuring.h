/* What the commands that measure convergence have in common: which algorithms on which cases.  Compiled for
 * each precision. */
#ifndef FATLINE_MEASURING_H
#define FATLINE_MEASURING_H

#include <argp.h>

#include "algorithms_named.h"
#include "case.h"

/* `children` of the commands' argp: --algorithm, --id, --rows, --quiet and files.  Its input is a struct
 * measuring, zeroed. */
struct measuring {
    struct algorithms_named algorithms; /* all, if none was named */
    const char *id;                     /* glob of the cases to be measured, or NULL */
    bool rows, quiet;
    char **files;
    int file_count;
};
extern const struct argp measuring_argp;

/* Reads the cases one after the other and calls `measure` for each whose id matches; writes the environment
 * first if there are to be rows.  measure returns false if it could not measure and has said so.  The exit
 * status. */
int measuring_run(const struct measuring *m, int argc, char **argv,
                  bool (*measure)(void *data, struct test_case *c), void *data);
bool measuring_is_interrupted(void);
void measuring_clear(struct measuring *m);

/* Whole numbers and numbers > 0 of options; ends the program with status 64 where they are none. */
int measuring_count(struct argp_state *state, const char *name, const char *text, int lo, int hi);

#endif
