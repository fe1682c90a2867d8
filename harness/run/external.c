#include "external.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../cases/number.h"

enum { LINE_BYTES_MAX = 1 << 24 };
static const double exit_grace = 1, status_grace = 0.2; /* seconds */

static volatile sig_atomic_t interrupted;

void external_interrupt(void)
{
    interrupted = 1;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static const char *complain(struct external *e, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static const char *complain(struct external *e, const char *format, ...)
{
    va_list arguments;
    int n = snprintf(e->error, sizeof e->error, "%s: ", e->name);
    e->failure = GAVE_UP;
    va_start(arguments, format);
    vsnprintf(e->error + n, sizeof e->error - (size_t)n, format, arguments);
    va_end(arguments);
    return e->error;
}

/* In the child: becomes the shell with the two pipes as its standard input and output. */
static void become_shell(const struct external *e, int in, int out)
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGPIPE, SIG_DFL);
    setenv("FATLINE_TOLERANCE", e->tolerance, 1);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    execl("/bin/sh", "sh", "-c", e->command, (char *)NULL);
    _exit(127);
}

static const char *launch(struct external *e)
{
    int in[2], out[2];
    e->used = 0;
    if (pipe2(in, O_CLOEXEC))
        return complain(e, "no pipe: %s", strerror(errno));
    if (pipe2(out, O_CLOEXEC)) {
        close(in[0]);
        close(in[1]);
        return complain(e, "no pipe: %s", strerror(errno));
    }
    pid_t child = fork();
    if (child == 0)
        become_shell(e, in[0], out[1]);
    close(in[0]);
    close(out[1]);
    if (child < 0) {
        close(in[1]);
        close(out[0]);
        return complain(e, "cannot be started: %s", strerror(errno));
    }
    setpgid(child, child); /* whoever comes first; fails harmlessly after the child's exec */
    fcntl(in[1], F_SETFL, O_NONBLOCK);
    fcntl(out[0], F_SETFL, O_NONBLOCK);
    e->pid = child;
    e->to = in[1];
    e->from = out[0];
    return NULL;
}

/* Waits up to `grace` seconds for the end, then kills the group.  The status, or -1 if it was killed. */
static int finish(struct external *e, double grace)
{
    const struct timespec nap = {0, 2000000};
    double deadline = seconds() + grace;
    siginfo_t info;
    int status = -1;
    close(e->to);
    for (;;) {
        memset(&info, 0, sizeof info);
        bool ended = waitid(P_PID, (id_t)e->pid, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
        bool late = !ended && seconds() >= deadline;
        if (ended || late) {
            kill(-e->pid, SIGKILL); /* the leader is not reaped yet, so the group is still ours */
            while (waitpid(e->pid, &status, 0) < 0 && errno == EINTR)
                ;
            if (late)
                status = -1;
            break;
        }
        nanosleep(&nap, NULL);
    }
    close(e->from);
    e->pid = 0;
    e->used = 0;
    return status;
}

static const char *tell_end(struct external *e)
{
    bool overlong = e->used + 4096 > LINE_BYTES_MAX;
    int status = finish(e, status_grace);
    if (status != -1 && WIFSIGNALED(status))
        return complain(e, "killed by signal %d (%s) before it answered", WTERMSIG(status),
                        strsignal(WTERMSIG(status)));
    if (status != -1 && WEXITSTATUS(status) > 128)
        return complain(e, "ended with status %d (%s) before it answered", WEXITSTATUS(status),
                        strsignal(WEXITSTATUS(status) - 128));
    if (status != -1 && WEXITSTATUS(status) == 127)
        return complain(e, "ended with status 127: command not found");
    if (status != -1)
        return complain(e, "ended with status %d before it answered", WEXITSTATUS(status));
    return complain(e, overlong ? "a line without an end" : "closed its output before it answered");
}

static const char *died(struct external *e)
{
    const char *error = tell_end(e);
    e->failure = CRASHED;
    return error;
}

static const char *late(struct external *e)
{
    finish(e, 0);
    complain(e, "no answer within %g s", e->timeout);
    e->failure = TIMED_OUT;
    return e->error;
}

enum transfer { MORE, NO_MORE };

static enum transfer send_some(struct external *e, const char *text, size_t length, size_t *sent)
{
    ssize_t n = write(e->to, text + *sent, length - *sent);
    if (n > 0)
        *sent += (size_t)n;
    return n < 0 && errno != EAGAIN && errno != EINTR ? NO_MORE : MORE;
}

static enum transfer receive_some(struct external *e)
{
    if (e->used + 4096 > e->size) {
        size_t size = e->size ? 2 * e->size : 1 << 16;
        char *buffer = size <= LINE_BYTES_MAX ? (char *)realloc(e->buffer, size) : NULL;
        if (!buffer)
            return NO_MORE;
        e->buffer = buffer;
        e->size = size;
    }
    ssize_t n = read(e->from, e->buffer + e->used, e->size - e->used);
    if (n > 0)
        e->used += (size_t)n;
    return n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR) ? NO_MORE : MORE;
}

/* Sends the line and waits for a whole line in the buffer; *end is its newline. */
static const char *exchange(struct external *e, const char *text, size_t length, char **end)
{
    double deadline = seconds() + e->timeout;
    size_t sent = 0;
    for (*end = NULL; sent < length || !*end;) {
        double left = deadline - seconds();
        struct pollfd wait[2] = {{e->from, POLLIN, 0}, {sent < length ? e->to : -1, POLLOUT, 0}};
        enum transfer state = MORE;
        int ready = left > 0 ? poll(wait, 2, left < 1000 ? (int)(left * 1000) + 1 : 1000000) : 0;
        if (interrupted) {
            finish(e, 0);
            return complain(e, "interrupted");
        }
        if (ready == 0)
            return late(e);
        if (ready < 0)
            continue;
        if (wait[0].revents)
            state = receive_some(e);
        *end = e->used ? (char *)memchr(e->buffer, '\n', e->used) : NULL;
        if (state == MORE && wait[1].revents)
            state = send_some(e, text, length, &sent);
        if (state == NO_MORE && !(*end && sent == length))
            return died(e);
    }
    return NULL;
}

/* Takes the line that ends at `end` out of the buffer. */
static const char *take_answer(struct external *e, const char *id, char *end, struct answer *a)
{
    size_t taken = (size_t)(end + 1 - e->buffer);
    *end = 0;
    const char *error = answer_read(e->buffer, a, e->id, e->algorithm);
    if (error)
        complain(e, "%s", error);
    else if (strcmp(e->id, id))
        complain(e, "id: \"%.80s\", expected \"%.80s\"", e->id, id);
    if (error || strcmp(e->id, id)) {
        finish(e, 0);
        return e->error;
    }
    e->used -= taken;
    memmove(e->buffer, e->buffer + taken, e->used);
    return NULL;
}

static const char *ask(struct external *e, const char *id, const char *case_line, struct answer *a)
{
    size_t length = strlen(case_line) + 1;
    char *text, *end;
    const char *error = interrupted ? complain(e, "interrupted") : e->pid ? NULL : launch(e);
    if (error)
        return error;
    text = (char *)malloc(length + 1);
    if (!text)
        return complain(e, "out of memory");
    memcpy(text, case_line, length - 1);
    text[length - 1] = '\n';
    error = exchange(e, text, length, &end);
    free(text);
    return error ? error : take_answer(e, id, end, a);
}

const char *external_ask(struct external *e, const char *id, const char *case_line, struct answer *a)
{
    const char *error = ask(e, id, case_line, a);
    if (error) {
        a->outcome = e->failure;
        a->steps = 0;
        a->crossings->count = a->crossings->overlaps = 0;
        snprintf(e->id, sizeof e->id, "%s", id);
    }
    if (error || !(a->tolerance > 0))
        real_parse(e->tolerance, &a->tolerance);
    a->id = e->id;
    a->algorithm = e->name;
    return error;
}

/* The last part of the path that is the first word. */
static void name_from(const char *command, char *name, size_t size)
{
    const char *start = command + strspn(command, " \t"), *end = start;
    for (; *end && !strchr(" \t;|&<>", *end); end++)
        if (*end == '/')
            start = end + 1;
    snprintf(name, size, "%.*s", (int)(end - start), start);
}

/* One program and its arguments, nothing else for the shell to do. */
static bool is_simple(const char *command)
{
    const char *start = command + strspn(command, " \t");
    size_t word = strcspn(start, " \t");
    return word > 0 && !memchr(start, '=', word) && !strpbrk(command, ";|&<>(){}`\n");
}

/* Whether the shell finds the first word of a simple command.  Words it would expand are not looked up. */
static bool is_found(const char *command)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";
    char ask[600];
    const char *start = command + strspn(command, " \t");
    size_t word = strcspn(start, " \t");
    if (word != strspn(start, plain) || word > 500)
        return true;
    snprintf(ask, sizeof ask, "command -v %.*s >/dev/null 2>&1", (int)word, start);
    return system(ask) == 0;
}

/* A simple command takes the shell's place, so that its end is seen as it is. */
static char *shell_text(const char *command)
{
    size_t size = strlen(command) + sizeof "exec ";
    char *text = (char *)malloc(size);
    if (text)
        snprintf(text, size, "%s%s", is_simple(command) ? "exec " : "", command);
    return text;
}

const char *external_start(struct external *e, const char *command, double timeout, real tolerance)
{
    memset(e, 0, sizeof *e);
    name_from(command, e->name, sizeof e->name);
    if (is_simple(command) && !is_found(command))
        return complain(e, "no program of this name can be run: %s", command);
    e->command = shell_text(command);
    if (!e->command)
        return complain(e, "out of memory");
    e->timeout = timeout;
    real_text(tolerance, e->tolerance, sizeof e->tolerance);
    signal(SIGPIPE, SIG_IGN);
    return launch(e);
}

void external_stop(struct external *e)
{
    if (e->pid)
        finish(e, exit_grace);
    free(e->command);
    free(e->buffer);
    memset(e, 0, sizeof *e);
}
