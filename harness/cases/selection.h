/* Which cases a command works on: the files named, and of their cases those that --class, --id and --filter
 * let through.  A command that is left without any says so and ends with status 65.  Precision-independent:
 * compiled once, as C. */
#ifndef FATLINE_SELECTION_H
#define FATLINE_SELECTION_H

#include <argp.h>
#include <regex.h>

#include "case.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Zeroed: everything on standard input. */
struct selection {
    const char *class_name, *id, *filter; /* a glob and an extended regular expression for ids; NULL: all */
    regex_t regex;                        /* compiled, where there is a filter */
    char **files;                         /* count of them, pointers into argv */
    int file_count;
};

/* A child of a command's argp: the three options and files.  Its input is a struct selection, zeroed. */
extern const struct argp selection_argp;

bool selection_is_narrowed(const struct selection *s); /* any of the three options is given */
/* False if the case was not asked for. */
bool selection_takes(const struct selection *s, const struct test_case *c);

/* Files, "-" where none is named. */
int selection_files(const struct selection *s);
const char *selection_file(const struct selection *s, int i);

/* "PROGRAM: no case in a.jsonl, b.jsonl with --id 'x*'": on standard error.  The status 65. */
int selection_complain(const struct selection *s, const char *program);
void selection_clear(struct selection *s);

#ifdef __cplusplus
}
#endif
#endif
