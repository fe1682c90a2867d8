/* One case, solved by every algorithm asked for and judged.  Compiled for each precision. */
#ifndef FATLINE_CHECK_CASE_H
#define FATLINE_CHECK_CASE_H

#include <jansson.h>

#include "../cases/problem.h"
#include "check_options.h"
#include "../run/external.h"

struct checker {
    const struct check_options *options;
    struct fitted_workspace memory;
    struct crossings *crossings;
    struct external external;
    double slowest; /* of the pairs so far, ns; with --strict */
};

/* NULL, or why the external program could not be started. */
const char *checker_open(struct checker *k, const struct check_options *o);
void checker_close(struct checker *k);

/* {"rows":[...],"notes":[...]}; with "bad":true if the case is no problem in this precision.  The fields of a
 * row: harness/check.c. */
json_t *checker_run(struct checker *k, struct test_case *c);

#endif
