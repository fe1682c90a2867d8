/* Adapters that are programs of their own, for their licences or their language: requests and answers over a
 * pipe (adapters/program.h). */
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "foreign.h"
#include "foreign_answer.h"
#include "foreign_files.h"
#include "foreign_pipe.h"

enum { VERSIONS = 16, REQUEST = 1 << 13 };

static double foreign_timeout = 10;

__attribute__((format(printf, 3, 4))) static const char *ask_for(struct program *p, double timeout,
                                                                 const char *format, ...)
{
    char request[128];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(request, sizeof request, format, arguments);
    va_end(arguments);
    return program_ask(p, request, timeout);
}

/* ---- what there is ---- */

static struct {
    const struct foreign *x;
    char version[64], absent[256];
} versions[VERSIONS];

static void find_version(const struct foreign *x, int i)
{
    char path[PATH_MAX];
    const char *end = strrchr(x->file, '.'), *answer;
    bool script = end && !strcmp(end, ".js");
    versions[i].x = x;
    if (!foreign_path(x->file, path)) {
        snprintf(versions[i].absent, sizeof versions[i].absent, "not built; it needs %s", x->needs);
        return;
    }
    answer = script ? ask_for(program_of(x->file), foreign_timeout, "%s version\n", x->solver)
                    : ask_for(program_of(x->file), foreign_timeout, "version\n");
    if (answer && strncmp(answer, "error", 5)) {
        snprintf(versions[i].version, sizeof versions[i].version, "%.60s", answer);
    } else {
        snprintf(versions[i].absent, sizeof versions[i].absent, "%s: %s", x->file,
                 answer ? answer : "does not answer");
    }
}

static int version_index(const struct foreign *x)
{
    int i = 0;
    while (i < VERSIONS - 1 && versions[i].x && versions[i].x != x) {
        i++;
    }
    if (versions[i].x != x) {
        find_version(x, i);
    }
    return i;
}

static const char *version(const struct foreign *x)
{
    int i = version_index(x);
    return versions[i].version[0] ? versions[i].version : NULL;
}

static const char *absent(const struct foreign *x)
{
    int i = version_index(x);
    return versions[i].absent[0] ? versions[i].absent : NULL;
}

/* ---- pairs ---- */

struct text {
    char at[REQUEST];
    int used;
};

__attribute__((format(printf, 2, 3))) static void append(struct text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(t->at + t->used, sizeof t->at - (size_t)t->used, format, arguments);
    va_end(arguments);
    t->used = t->used + n < REQUEST ? t->used + n : REQUEST - 1;
}

static void append_curve(struct text *t, const struct curve *c)
{
    double number[3 * DEGREE_MAX + 3];
    struct peer_curve to;
    foreign_curve(c, number, &to);
    append(t, " %d %d", to.degree, to.weight != NULL);
    for (int i = 0; i <= to.degree; i++) {
        append(t, " %.17g %.17g", to.point[2 * i], to.point[2 * i + 1]);
        if (to.weight) {
            append(t, " %.17g", to.weight[i]);
        }
    }
}

/* "solved COINCIDENT N t s ... M t0 t1 s0 s1 ..." */
static enum peer_outcome read_answer(const char *text, struct peer_roots *roots)
{
    char *end;
    roots->count = roots->overlaps = roots->coincident = 0;
    if (!strncmp(text, "refused", 7)) {
        return PEER_REFUSED;
    }
    if (strncmp(text, "solved ", 7)) {
        return PEER_FAILED;
    }
    roots->coincident = (int)strtol(text + 7, &end, 10);
    roots->count = (int)strtol(end, &end, 10);
    for (int i = 0; i < roots->count && i < PEER_ROOTS; i++) {
        roots->root[i][0] = strtod(end, &end);
        roots->root[i][1] = strtod(end, &end);
    }
    int overlaps = (int)strtol(end, &end, 10);
    for (int i = 0; i < overlaps && i < PEER_OVERLAPS; i++) {
        for (int k = 0; k < 4; k++) {
            roots->overlap[i][k] = strtod(end, &end);
        }
        roots->overlaps++;
    }
    return PEER_SOLVED;
}

enum outcome foreign_program_intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    const struct foreign *x = w->plan->foreign;
    struct program *program = program_of(x->file);
    struct text request = {"", 0};
    struct peer_roots roots;
    if (absent(x)) {
        return UNSUPPORTED;
    }
    append(&request, "%s %s", x->solver, program->collecting ? "collect" : "solve");
    append_curve(&request, &p->f);
    append_curve(&request, &p->g);
    append(&request, "\n");
    const char *answer = program_ask(program, request.at, foreign_timeout);
    if (!answer) {
        return program->late ? TIMED_OUT : CRASHED;
    }
    if (program->collecting) {
        program->collected += !strcmp(answer, "ok");
        return SOLVED;
    }
    enum peer_outcome outcome = read_answer(answer, &roots);
    return foreign_answer(p, outcome, &roots, out);
}

/* ---- time ---- */

static void collect(const struct foreign *x)
{
    struct program *p = program_of(x->file);
    const char *answer = ask_for(p, foreign_timeout, "%s clear\n", x->solver);
    p->collecting = answer && !strcmp(answer, "ok");
    p->collected = 0;
}

static int collected(const struct foreign *x)
{
    struct program *p = program_of(x->file);
    p->collecting = false;
    return p->pid ? p->collected : 0;
}

/* A pass may take as long as all its pairs may. */
static const char *ask_passes(const struct foreign *x, const char *what, int passes)
{
    struct program *p = program_of(x->file);
    if (!p->pid || p->collected == 0) {
        return NULL;
    }
    return ask_for(p, foreign_timeout * (p->collected + 1.0) * passes, "%s %s %d\n", x->solver, what, passes);
}

static bool time_passes(const struct foreign *x, int passes, double *ns)
{
    const char *answer = ask_passes(x, "time", passes);
    char *end;
    *ns = answer ? strtod(answer, &end) : 0;
    return answer && end != answer && *ns > 0;
}

static bool time_each(const struct foreign *x, int passes, int count, double *ns)
{
    const char *answer = ask_passes(x, "each", passes);
    for (int i = 0; i < count && answer; i++) {
        char *end;
        ns[i] = strtod(answer, &end);
        answer = end == answer ? NULL : end;
    }
    return answer;
}

static void set_timeout(double s)
{
    foreign_timeout = s;
}

const struct foreign_kind foreign_program = {false,     version,     absent,    collect,
                                             collected, time_passes, time_each, set_timeout};
