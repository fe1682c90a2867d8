/* A program that answers a line with a line: started when it is first asked, once a process; one that is late
 * or dies is started anew for the next request. */
#ifndef FATLINE_FOREIGN_PIPE_H
#define FATLINE_FOREIGN_PIPE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

struct program {
    const char *file;
    pid_t pid, owner; /* a child that was forked off us has no program yet; pid 0: not running */
    int to, from;
    char *buffer;
    size_t used, size;
    bool late; /* the last failure was one of time */
    int collected;
    bool collecting;
};

/* file: in build/peers (foreign_files.h).  A child that was forked off us gets a program of its own. */
struct program *program_of(const char *file);

/* The answer to a request (which ends its line), without its end, or NULL: late or dead, and not running
 * then. */
const char *program_ask(struct program *p, const char *request, double timeout);

#endif
