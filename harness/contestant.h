/* A fatline-passes of some build, at work for `fatline compare`.  Compiled for each precision. */
#ifndef FATLINE_CONTESTANT_H
#define FATLINE_CONTESTANT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>

struct contestant {
    pid_t pid;
    FILE *to, *from;
    char *line;
    size_t size;
};

/* folder: of the build, that holds the folder of this precision.  The environment gets `padding` more bytes,
 * so that the stack does not lie at the same place each time.  NULL, or why it could not be started. */
const char *contestant_start(struct contestant *c, const char *folder, const char *tolerance,
                             const char *max_steps, const char *file, int padding);
/* The answer to a request, without its end; NULL: it died. */
const char *contestant_ask(struct contestant *c, const char *request);
void contestant_stop(struct contestant *c);

#endif
