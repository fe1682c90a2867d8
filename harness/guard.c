#include "guard.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../algorithms/peers/foreign.h"
#include "problem.h"

static const rlim_t memory_limit = (rlim_t)8 << 30; /* of a servant */

/* What both sides see.  The crossings come last: most of them are never touched. */
struct desk {
    const struct intersector *algorithm; /* at the same place in both processes */
    struct problem problem;
    real number[2][3][DEGREE_MAX + 1];
    enum outcome outcome;
    int steps;
    struct crossings crossings;
};

static struct {
    pid_t pid, owner; /* a servant of the process that forked us is not ours */
    int to, from;
    struct desk *desk;
    double timeout;
} servant = {0, 0, 0, 0, NULL, 10};

void guard_set_timeout(double seconds)
{
    servant.timeout = seconds;
    for (int i = 0; peers[i]; i++)
        if (peers[i]->foreign->kind->set_timeout)
            peers[i]->foreign->kind->set_timeout(seconds);
}

const char *guard_absent(const struct intersector *a)
{
    return a->foreign ? a->foreign->kind->absent(a->foreign) : NULL;
}

static void put_curve(struct curve *c, real number[3][DEGREE_MAX + 1])
{
    const real *from[3] = {c->x, c->y, c->w};
    for (int k = 0; k < (c->w ? 3 : 2); k++)
        for (int i = 0; i <= c->degree; i++)
            number[k][i] = from[k][i];
    c->x = number[0];
    c->y = number[1];
    c->w = c->w ? number[2] : NULL;
}

static void serve(int from, int to)
{
    static const struct intersector *const nobody[] = {NULL};
    struct desk *d = servant.desk;
    struct rlimit memory = {memory_limit, memory_limit};
    struct workspace w;
    char byte;

    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setrlimit(RLIMIT_AS, &memory);
    workspace_make(&w, nobody, DEGREE_MAX, DEGREE_MAX, 1);
    while (read(from, &byte, 1) == 1) {
        d->outcome = problem_solve(&d->problem, d->algorithm, &w, &d->crossings);
        d->steps = w.steps;
        if (write(to, &byte, 1) != 1)
            break;
    }
    _exit(0);
}

static bool hire(void)
{
    int in[2], out[2];
    if (!servant.desk) {
        void *memory =
            mmap(NULL, sizeof *servant.desk, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        servant.desk = memory == MAP_FAILED ? NULL : (struct desk *)memory;
    }
    if (!servant.desk || pipe(in))
        return false;
    if (pipe(out)) {
        close(in[0]);
        close(in[1]);
        return false;
    }
    fflush(NULL);
    signal(SIGPIPE, SIG_IGN);
    servant.owner = getpid();
    servant.pid = fork();
    if (servant.pid == 0) {
        close(in[1]);
        close(out[0]);
        serve(in[0], out[1]);
    }
    close(in[0]);
    close(out[1]);
    servant.to = in[1];
    servant.from = out[0];
    if (servant.pid < 0)
        servant.pid = 0;
    return servant.pid > 0;
}

void guard_end(void)
{
    if (!servant.pid)
        return;
    close(servant.to);
    close(servant.from);
    if (servant.owner == getpid()) {
        kill(servant.pid, SIGKILL);
        while (waitpid(servant.pid, NULL, 0) < 0 && errno == EINTR)
            ;
    } else {
        servant.desk = NULL; /* theirs; a desk of our own is made when needed */
    }
    servant.pid = 0;
}

static void take_records(const struct crossings *from, struct crossings *to)
{
    to->count = from->count;
    to->overlaps = from->overlaps;
    to->merged = from->merged;
    for (int i = 0; i < from->count; i++)
        to->at[i] = from->at[i];
    for (int i = 0; i < from->overlaps; i++)
        to->overlap[i] = from->overlap[i];
}

static enum outcome ask(const struct problem *p, const struct intersector *a, struct workspace *w,
                        struct crossings *out)
{
    struct desk *d = servant.desk;
    struct pollfd wait = {servant.from, POLLIN, 0};
    char byte = 0;
    int ready;

    d->algorithm = a;
    d->problem = *p;
    put_curve(&d->problem.f, d->number[0]);
    put_curve(&d->problem.g, d->number[1]);
    if (write(servant.to, &byte, 1) != 1)
        return CRASHED;
    do {
        ready = poll(&wait, 1, (int)(1000 * servant.timeout) + 1);
    } while (ready < 0 && errno == EINTR);
    if (ready <= 0)
        return TIMED_OUT;
    if (read(servant.from, &byte, 1) != 1)
        return CRASHED;
    take_records(&d->crossings, out);
    w->steps = d->steps;
    return d->outcome;
}

enum outcome guard_solve(const struct problem *p, const struct intersector *a, struct workspace *w,
                         struct crossings *out)
{
    enum outcome outcome;
    if (!a->foreign || !a->foreign->kind->in_process)
        return problem_solve(p, a, w, out);
    out->count = out->overlaps = w->steps = 0;
    if (servant.pid && servant.owner != getpid())
        guard_end();
    /* What is absent is asked here, so that a library is loaded once and a servant inherits it. */
    if (guard_absent(a))
        return UNSUPPORTED;
    if (p->f.degree > DEGREE_MAX || p->g.degree > DEGREE_MAX)
        return INVALID;
    if (!servant.pid && !hire())
        return GAVE_UP;
    outcome = ask(p, a, w, out);
    if (outcome == CRASHED || outcome == TIMED_OUT) {
        out->count = out->overlaps = 0;
        guard_end();
    }
    return outcome;
}
