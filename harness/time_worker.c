#include "time_worker.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "progress.h"

enum { LOOK_MS = 200 };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The first line is the number of contenders timed. */
static void be_child(const struct family_work *w, int to, struct heartbeat *heartbeat)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory, *stream = fdopen(to, "w");
    int timed;
    signal(SIGINT, SIG_IGN); /* the parent's affair: it ends us */
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    memory = open_memstream(&text, &size);
    if (!stream || !memory)
        _exit(2);
    timed = w->work(w->context, memory, heartbeat);
    fclose(memory);
    fprintf(stream, "%d\n", timed);
    fwrite(text, 1, size, stream);
    _exit(fclose(stream) ? 2 : 0);
}

/* Everything until the end of the pipe; false if the child had to be ended. */
static bool gather(const struct family_work *w, pid_t child, int from, const struct heartbeat *heartbeat,
                   FILE *memory)
{
    char buffer[1 << 16];
    double last = seconds();
    long beats = heartbeat->beats;
    for (;;) {
        struct pollfd wait = {from, POLLIN, 0};
        int ready = poll(&wait, 1, LOOK_MS);
        ssize_t n = ready > 0 ? read(from, buffer, sizeof buffer) : 0;
        if (ready > 0 && n <= 0)
            return true;
        if (n > 0)
            fwrite(buffer, 1, (size_t)n, memory);
        if (heartbeat->beats != beats || n > 0) {
            beats = heartbeat->beats;
            last = seconds();
        } else if (seconds() - last > w->patience) {
            kill(child, SIGKILL);
            return false;
        }
    }
}

/* NULL if it did not end well; *why then says how. */
static char *run_once(const struct family_work *w, struct heartbeat *heartbeat, char why[100])
{
    int ends[2], status = 0;
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    if (!memory || pipe(ends))
        exit(2);
    heartbeat->contender = -1;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        be_child(w, ends[1], heartbeat);
    }
    close(ends[1]);
    bool alive = child > 0 && gather(w, child, ends[0], heartbeat, memory);
    close(ends[0]);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    fclose(memory);
    if (alive && WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return text;
    if (alive && WIFSIGNALED(status))
        snprintf(why, 100, "crashed while timed: signal %d (%s)", WTERMSIG(status),
                 strsignal(WTERMSIG(status)));
    else if (alive)
        snprintf(why, 100, "ended the process while timed: status %d", WEXITSTATUS(status));
    else
        snprintf(why, 100, "no sign of life for %g s while timed", w->patience);
    free(text);
    return NULL;
}

char *time_worker_run(struct family_work *w, int *timed)
{
    void *shared =
        mmap(NULL, sizeof(struct heartbeat), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    struct heartbeat *heartbeat = (struct heartbeat *)shared;
    char *text = NULL, why[100];
    if (shared == MAP_FAILED)
        exit(2);
    for (int tries = 0; !text && tries <= w->contenders; tries++) {
        int culprit;
        text = run_once(w, heartbeat, why);
        culprit = heartbeat->contender;
        if (text || culprit < 0 || culprit >= w->contenders || w->contender[culprit].left_out)
            break;
        w->contender[culprit].left_out = strdup(why);
        progress_note("%s: %s", w->contender[culprit].name, why);
    }
    munmap(shared, sizeof *heartbeat);
    if (text) {
        char *rest = strchr(text, '\n');
        *timed = atoi(text);
        memmove(text, rest + 1, strlen(rest + 1) + 1);
    }
    return text;
}
