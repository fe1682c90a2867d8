/* An algorithm that is a program of its own: it reads case lines on standard input and writes one line of
 * `fatline solve` for each, in order, flushed (answer.h).  Compiled for each precision.
 *
 * The program finds the tolerance asked for in the environment variable FATLINE_TOLERANCE. */
#ifndef FATLINE_EXTERNAL_H
#define FATLINE_EXTERNAL_H

#include <sys/types.h>

#include "../judge/answer.h"

struct external {
    char name[128]; /* in rows: the last part of the command's first word */
    char *command;
    double timeout; /* seconds a line may take */
    char tolerance[700];
    pid_t pid; /* of the shell, leader of its own process group; 0: not running */
    int to, from;
    char *buffer; /* what was read and not yet taken */
    size_t used, size;
    enum outcome failure; /* of what `error` tells */
    char id[256], algorithm[128], error[512];
};

/* Starts `command` through the shell.  NULL, or why it could not be started.  SIGPIPE is ignored from here
 * on. */
const char *external_start(struct external *e, const char *command, double timeout, real tolerance);

/* Sends one case line (without a newline) and reads the answer into a; a->crossings is the caller's,
 * a->algorithm is e->name.  NULL on success.  Else a message, owned by e: the answer then has no records, its
 * outcome is TIMED_OUT (late), CRASHED (it ended, or closed its output) or GAVE_UP (a line that is no answer,
 * or one to another case; or it cannot be asked), and the program is started anew for the next case. */
const char *external_ask(struct external *e, const char *id, const char *case_line, struct answer *a);

/* Closes its input, waits up to a second, then kills it. */
void external_stop(struct external *e);

/* For a signal handler: whoever waits for an answer stops waiting, and every later question is refused. */
void external_interrupt(void);

#endif
