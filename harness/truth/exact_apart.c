#include "exact_apart.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../cases/case_fields.h"
#include "../run/memory.h"

/* ---- the child ---- */

static void put(FILE *to, const mpq_t q)
{
    mpq_out_str(to, 16, q);
    fputc('\n', to);
}

static void send_answer(FILE *to, const struct case_expected *e)
{
    fprintf(to, "%d %d\n", e->count, e->overlaps);
    for (int i = 0; i < e->count; i++) {
        fprintf(to, "%d %d\n", e->at[i].exact, e->at[i].multiplicity);
        put(to, e->at[i].t);
        put(to, e->at[i].s);
    }
    for (int i = 0; i < e->overlaps; i++) {
        const struct case_overlap *o = &e->overlap[i];
        fprintf(to, "%d\n", o->exact);
        put(to, o->t0);
        put(to, o->t1);
        put(to, o->s0);
        put(to, o->s1);
    }
    fprintf(to, "end\n");
}

/* The signal of the timer ends the process. */
static void limit_time(double seconds)
{
    struct itimerval timer;
    memset(&timer, 0, sizeof timer);
    timer.it_value.tv_sec = (time_t)seconds;
    timer.it_value.tv_usec = (suseconds_t)(1e6 * (seconds - floor(seconds)));
    signal(SIGPROF, SIG_DFL);
    if (seconds > 0)
        setitimer(ITIMER_PROF, &timer, NULL);
}

static void work(struct test_case *c, const struct exact_limits *limits, int to)
{
    FILE *stream = fdopen(to, "w");
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    limit_time(limits->seconds);
    const char *trouble = exact_solve(c, limits);
    if (trouble)
        fprintf(stream, "-1 0\n%s\n", trouble);
    else
        send_answer(stream, &c->expected);
    fflush(stream);
    _exit(0);
}

/* ---- the parent ---- */

static bool get(FILE *from, mpq_t q)
{
    mpq_init(q);
    return mpq_inp_str(q, from, 16) > 0;
}

static bool get_solution(FILE *from, struct case_solution *x)
{
    int exact;
    bool good = fscanf(from, "%d %d", &exact, &x->multiplicity) == 2;
    x->exact = good && exact;
    x->cond = x->sine = NAN;
    return get(from, x->t) & get(from, x->s) & good;
}

static bool get_overlap(FILE *from, struct case_overlap *o)
{
    int exact;
    bool good = fscanf(from, "%d", &exact) == 1;
    o->exact = good && exact;
    return get(from, o->t0) & get(from, o->t1) & get(from, o->s0) & get(from, o->s1) & good;
}

static const char *receive(FILE *from, struct case_expected *e)
{
    static char why[256];
    char word[8];
    int count, overlaps;
    bool good = fscanf(from, "%d %d\n", &count, &overlaps) == 2;
    if (good && count < 0) {
        if (!fgets(why, sizeof why, from))
            return "no answer";
        why[strcspn(why, "\n")] = 0;
        return why;
    }
    if (!good)
        return "time limit";
    e->known = true;
    e->tol = NAN;
    e->at = memory_new((size_t)count, sizeof *e->at);
    e->overlap = memory_new((size_t)overlaps, sizeof *e->overlap);
    for (; good && e->count < count; e->count++)
        good = get_solution(from, &e->at[e->count]);
    for (; good && e->overlaps < overlaps; e->overlaps++)
        good = get_overlap(from, &e->overlap[e->overlaps]);
    good = good && fscanf(from, "%7s", word) == 1 && !strcmp(word, "end");
    if (!good)
        case_expected_clear(e);
    return good ? NULL : "no answer";
}

const char *exact_solve_apart(const struct test_case *c, const struct exact_limits *limits,
                              struct case_expected *e)
{
    int ends[2], status;
    memset(e, 0, sizeof *e);
    if (pipe(ends))
        return "no pipe";
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        struct test_case own = *c; /* the process ends: what exact_solve frees is its own copy */
        close(ends[0]);
        work(&own, limits, ends[1]);
    }
    close(ends[1]);
    FILE *from = child > 0 ? fdopen(ends[0], "r") : NULL;
    const char *trouble = from ? receive(from, e) : "no process";
    if (from)
        fclose(from);
    else
        close(ends[0]);
    if (child > 0) {
        if (trouble)
            kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    return trouble;
}
