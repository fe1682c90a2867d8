/* The values of options, and which options go together: what is wrong is said, with what was expected, and
 * the program ends with status 64.  name: as typed, "--seed".  Precision-independent: compiled once, as C. */
#ifndef FATLINE_OPTIONS_H
#define FATLINE_OPTIONS_H

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

int option_integer(struct argp_state *state, const char *name, const char *text, int lo, int hi);
uint64_t option_seed(struct argp_state *state, const char *name, const char *text); /* any 64 bits */
double option_number(struct argp_state *state, const char *name, const char *text, double lo, double hi);
double option_positive(struct argp_state *state, const char *name, const char *text); /* finite */

/* "NAME needs WHAT" where it is given without. */
void option_needs(struct argp_state *state, bool given, const char *name, bool there, const char *what);
/* "NAME does not go with WHAT" where both are given. */
void option_excludes(struct argp_state *state, bool given, const char *name, bool there, const char *what);

#ifdef __cplusplus
}
#endif
#endif
