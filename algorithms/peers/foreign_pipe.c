/* See foreign_pipe.h. */
#include "foreign_pipe.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "foreign_files.h"

enum { PROGRAMS = 8 };

static struct program programs[PROGRAMS];

struct program *program_of(const char *file)
{
    struct program *p = programs;
    while (p->file && strcmp(p->file, file)) {
        p++;
    }
    p->file = file;
    if (p->pid && p->owner != getpid()) {
        close(p->to);
        close(p->from);
        p->pid = 0;
        p->used = 0;
    }
    return p;
}

static void become(const char *path, int in, int out)
{
    const char *ending = strrchr(path, '.');
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGPIPE, SIG_DFL);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    if (ending && !strcmp(ending, ".js")) {
        execlp("node", "node", path, (char *)NULL);
    } else {
        execl(path, path, (char *)NULL);
    }
    _exit(127);
}

static bool start(struct program *p)
{
    char path[PATH_MAX];
    int in[2], out[2];
    if (!foreign_path(p->file, path) || pipe2(in, O_CLOEXEC)) {
        return false;
    }
    if (pipe2(out, O_CLOEXEC)) {
        close(in[0]);
        close(in[1]);
        return false;
    }
    signal(SIGPIPE, SIG_IGN);
    pid_t child = fork();
    if (child == 0) {
        become(path, in[0], out[1]);
    }
    close(in[0]);
    close(out[1]);
    if (child < 0) {
        close(in[1]);
        close(out[0]);
        return false;
    }
    p->to = in[1];
    p->from = out[0];
    p->pid = child;
    p->owner = getpid();
    p->used = 0;
    p->collected = 0;
    return true;
}

static void stop(struct program *p)
{
    close(p->to);
    close(p->from);
    kill(p->pid, SIGKILL);
    while (waitpid(p->pid, NULL, 0) < 0 && errno == EINTR) {
    }
    p->pid = 0;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool make_room(struct program *p)
{
    if (p->used + 1 < p->size) {
        return true;
    }
    size_t size = p->size ? 2 * p->size : 1 << 16;
    char *buffer = realloc(p->buffer, size);
    if (buffer) {
        p->buffer = buffer;
        p->size = size;
    }
    return buffer;
}

/* The whole line of the answer, without its end, or NULL. */
static const char *listen(struct program *p, double timeout)
{
    double deadline = seconds() + timeout;
    for (p->used = 0;;) {
        double left = deadline - seconds();
        struct pollfd wait = {p->from, POLLIN, 0};
        int ready = left > 0 ? poll(&wait, 1, left < 1e6 ? (int)(1000 * left) + 1 : INT_MAX) : 0;
        p->late = ready == 0;
        if (ready < 0 && errno == EINTR) {
            continue;
        }
        if (ready <= 0 || !make_room(p)) {
            return NULL;
        }
        ssize_t n = read(p->from, p->buffer + p->used, p->size - p->used - 1);
        if (n <= 0) {
            return NULL;
        }
        p->used += (size_t)n;
        if (p->buffer[p->used - 1] == '\n') {
            p->buffer[p->used - 1] = '\0';
            return p->buffer;
        }
    }
}

const char *program_ask(struct program *p, const char *request, double timeout)
{
    size_t length = strlen(request), sent = 0;
    if (!p->pid && !start(p)) {
        return NULL;
    }
    while (sent < length) {
        ssize_t n = write(p->to, request + sent, length - sent);
        if (n < 0 && errno != EINTR) {
            break;
        }
        sent += n > 0 ? (size_t)n : 0;
    }
    p->late = false;
    const char *answer = sent == length ? listen(p, timeout) : NULL;
    if (!answer) {
        stop(p);
    }
    return answer;
}
