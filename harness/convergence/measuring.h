/* What the commands that measure convergence have in common: which algorithms on which cases.  Compiled for
 * each precision. */
#ifndef FATLINE_MEASURING_H
#define FATLINE_MEASURING_H

#include <argp.h>

#include "../run/algorithms_named.h"
#include "../cases/problem.h"
#include "../cases/selection.h"
#include "../truth/known_solutions.h"

/* Options that they all have: --algorithm, --class, --id, --filter, --rows, --quiet, and files.  Zeroed at
 * first. */
struct measuring {
    struct algorithms_named algorithms; /* all, if none was named */
    struct selection cases;
    bool rows, quiet;
};

/* Reads the command line; own: the further options, whose input is m too, the first member of what the
 * command keeps.  Ends the program with status 64 where it is wrong. */
void measuring_read(int argc, char **argv, const struct argp *own, const char *documentation,
                    struct measuring *m);

/* Reads the cases one after the other and calls `measure` for each that is asked for; writes the environment
 * first if there are to be rows.  measure returns false if it could not measure and has said so.  The exit
 * status. */
int measuring_run(const struct measuring *m, int argc, char **argv,
                  bool (*measure)(void *data, struct test_case *c), void *data);
void measuring_clear(struct measuring *m);

/* What the commands ask of a case; false if it cannot be had, which was then said. */
bool measuring_problem(const struct test_case *c, real tolerance, int max_steps, struct owned_problem *p);
bool measuring_solutions(struct test_case *c, int digits, double seconds, struct known_solutions *known);

#endif
