#include "standard_output.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FAILED = 2 };

/* Why an earlier write failed; 0 if that cannot be found out now. */
static int earlier_reason(void)
{
    struct pollfd output = {STDOUT_FILENO, POLLOUT, 0};
    if (poll(&output, 1, 0) == 1 && output.revents & POLLERR)
        return EPIPE;
    return write(STDOUT_FILENO, "", 0) < 0 ? errno : 0;
}

static void end_by_broken_pipe(void)
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGPIPE);
    signal(SIGPIPE, SIG_DFL);
    sigprocmask(SIG_UNBLOCK, &set, NULL);
    raise(SIGPIPE);
}

/* One that was closed from the start is no loss if nothing was to be written. */
static void close_standard_output(void)
{
    const bool failed = ferror(stdout), pending = __fpending(stdout) > 0;
    int reason = failed ? earlier_reason() : 0;
    errno = 0;
    const bool lost = fclose(stdout) != 0 && (errno != EBADF || pending);
    if (!lost && !failed)
        return;
    if (lost && errno)
        reason = errno;
    if (reason == EPIPE)
        end_by_broken_pipe();
    fprintf(stderr, "%s: standard output: %s\n", program_invocation_short_name,
            reason ? strerror(reason) : "some of it could not be written");
    _exit(FAILED);
}

void standard_output_watch(void)
{
    atexit(close_standard_output);
}
