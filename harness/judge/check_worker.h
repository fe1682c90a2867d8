/* One of the processes that share the work of `fatline check`.  Compiled for each precision.
 *
 * Worker k of n takes the lines k, k + n, ... of all files, counted together and blank ones left out, and
 * replies to each with a line of JSON: what checker_run says, {} for a case that was not asked for,
 * {"bad":true,"notes":[...]} for a line that is no case, {"failed":true,"notes":[...]} for a file that cannot
 * be read (which counts as a line). */
#ifndef FATLINE_CHECK_WORKER_H
#define FATLINE_CHECK_WORKER_H

#include <stdbool.h>
#include <stdio.h>

#include "../cases/case.h"
#include "check_options.h"

/* Which cases are asked for: of those that the options let through one in so many of each class, in the order
 * of the lines. */
struct sampler {
    const struct check_options *options;
    json_t *seen; /* cases of each class so far */
};

void sampler_begin(struct sampler *s, const struct check_options *o);
bool sampler_takes(struct sampler *s, const struct test_case *c);
void sampler_end(struct sampler *s);

/* Standard input is read once, before there are workers. */
void check_load_standard_input(void);
/* The lines of a file; "-": of standard input.  NULL: errno says why. */
FILE *check_open_cases(const char *path);
bool check_line_is_blank(const char *text);

/* The group that the rows of a case form in a file that is resumed, a malloc'd text. */
char *check_group(const char *file, const char *id);

/* Returns an exit status. */
int check_work(const struct check_options *o, int number, FILE *to);

#endif
