/* Algorithms as asked for on the command line: `--algorithm LIST`, given any number of times.  Compiled for
 * each precision. */
#ifndef FATLINE_ALGORITHMS_NAMED_H
#define FATLINE_ALGORITHMS_NAMED_H

#include "../../algorithms/bezier.h"

/* Zeroed: none yet.  `at` is NULL-terminated once something was added. */
struct algorithms_named {
    const struct intersector **at;
    int count;
    char *error;
};

/* Adds what `list` names, each once: names, shell globs or `all`, separated by commas.  `all` and globs look
 * in intersectors[]; an exact name is found in controls[] too. NULL, or a message with the known names (owned
 * by a) if a part of the list names nothing. */
const char *algorithms_named_add(struct algorithms_named *a, const char *list);
void algorithms_named_clear(struct algorithms_named *a);

#endif
