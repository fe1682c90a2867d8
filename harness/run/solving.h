/* Who solves, and within which limits, as asked for on the command line.  Compiled for each precision. */
#ifndef FATLINE_SOLVING_H
#define FATLINE_SOLVING_H

#include <argp.h>

#include "algorithms_named.h"

/* Zeroed: nothing is given yet; what is not given is what `solving_argp` says. */
struct solving {
    struct algorithms_named algorithms; /* none unless named, or the command's own default */
    const char *external;               /* a command, or NULL */
    double timeout;
    int max_steps, room;
};

/* A child of a command's argp: --algorithm, --external, --timeout, --max-steps, --room.  Its input is a
 * struct solving, zeroed. */
extern const struct argp solving_argp;

/* Adds what the text of --algorithm names; ends the program with status 64 if that is nothing. */
void solving_add(struct argp_state *state, struct algorithms_named *algorithms, const char *list);
/* A number > 0; else the program ends with status 64. */
real option_tolerance(struct argp_state *state, const char *text);
/* Another library among them? */
bool has_foreign(const struct algorithms_named *algorithms);

#endif
