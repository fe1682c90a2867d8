/* The loop of an adapter that is a program of its own: it reads a request a line and answers each with a
 * line.
 *
 *   version                       the library's version
 *   NAME solve PAIR               what the solver NAME says of a pair
 *   NAME collect PAIR             "ok", and keeps the pair
 *   NAME clear                    "ok", and forgets what was kept
 *   NAME time PASSES              nanoseconds of so many passes over what was kept, one pair after the other
 *   NAME each PASSES              the shortest of so many passes for each pair kept
 *
 * PAIR: two curves, each DEGREE RATIONAL and its numbers x y (w).  Answers to `solve`: "solved COINCIDENT N t
 * s ... M t0 t1 s0 s1 ..." with N roots and M overlaps, "refused", "failed".  Any failure else: "error WHY".
 * NAME is the library, or the library_polished, which takes Newton steps on each root. */
#ifndef FATLINE_PEERS_PROGRAM_H
#define FATLINE_PEERS_PROGRAM_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../newton.h"
#include "../peer.h"

struct program_pair {
    struct peer_curve f, g;
    double number[2][3 * PEER_DEGREE + 3];
};

struct program_set {
    int count, room;
    struct program_pair *at;
};

static inline double program_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec * 1e9 + t.tv_nsec;
}

static inline const char *program_read_curve(const char *text, struct peer_curve *c, double *number)
{
    char *end;
    long degree = strtol(text, &end, 10), rational = strtol(end, &end, 10);
    if (degree < 1 || degree > PEER_DEGREE) {
        return NULL;
    }
    double *weight = number + 2 * (degree + 1);
    c->degree = (int)degree;
    c->point = number;
    c->weight = rational ? weight : NULL;
    for (int i = 0; i <= degree; i++) {
        number[2 * i] = strtod(end, &end);
        number[2 * i + 1] = strtod(end, &end);
        if (rational) {
            weight[i] = strtod(end, &end);
        }
    }
    return end;
}

static inline int program_read_pair(const char *text, struct program_pair *p)
{
    text = program_read_curve(text, &p->f, p->number[0]);
    return text && program_read_curve(text, &p->g, p->number[1]);
}

static inline enum peer_outcome program_solve(const struct program_pair *p, int polished,
                                              struct peer_roots *roots)
{
    roots->count = roots->overlaps = roots->coincident = 0;
    enum peer_outcome outcome = peer_intersect(&p->f, &p->g, roots);
    if (polished && outcome == PEER_SOLVED) {
        newton_polish(&p->f, &p->g, roots);
    }
    return outcome;
}

static inline void program_answer(FILE *to, enum peer_outcome outcome, const struct peer_roots *roots)
{
    if (outcome != PEER_SOLVED) {
        fputs(outcome == PEER_REFUSED ? "refused\n" : "failed\n", to);
        return;
    }
    fprintf(to, "solved %d %d", roots->coincident, roots->count);
    for (int i = 0; i < roots->count && i < PEER_ROOTS; i++) {
        fprintf(to, " %.17g %.17g", roots->root[i][0], roots->root[i][1]);
    }
    fprintf(to, " %d", roots->overlaps);
    for (int i = 0; i < roots->overlaps; i++) {
        const double *o = roots->overlap[i];
        fprintf(to, " %.17g %.17g %.17g %.17g", o[0], o[1], o[2], o[3]);
    }
    fputc('\n', to);
}

/* The curves point into the pair itself, so a set that moves is read anew. */
static inline const char *program_collect(struct program_set *set, const char *text)
{
    if (set->count == set->room) {
        int room = set->room ? 2 * set->room : 64;
        struct program_pair *moved = (struct program_pair *)malloc(room * sizeof *moved);
        if (!moved) {
            return "error out of memory";
        }
        for (int i = 0; i < set->count; i++) {
            moved[i] = set->at[i];
            moved[i].f.point = moved[i].number[0];
            moved[i].g.point = moved[i].number[1];
            moved[i].f.weight = moved[i].f.weight ? moved[i].number[0] + 2 * (moved[i].f.degree + 1) : NULL;
            moved[i].g.weight = moved[i].g.weight ? moved[i].number[1] + 2 * (moved[i].g.degree + 1) : NULL;
        }
        free(set->at);
        set->at = moved;
        set->room = room;
    }
    return program_read_pair(text, &set->at[set->count]) ? (set->count++, "ok") : "error not a pair";
}

static inline void program_time(FILE *to, const struct program_set *set, int polished, int passes,
                                struct peer_roots *roots)
{
    double start = program_now();
    for (int k = 0; k < passes; k++) {
        for (int i = 0; i < set->count; i++) {
            program_solve(&set->at[i], polished, roots);
        }
    }
    fprintf(to, "%.17g\n", program_now() - start);
}

static inline void program_each(FILE *to, const struct program_set *set, int polished, int passes,
                                struct peer_roots *roots)
{
    double *least = (double *)malloc((set->count + 1) * sizeof *least);
    for (int k = 0; least && k < passes; k++) {
        for (int i = 0; i < set->count; i++) {
            double start = program_now(), took;
            program_solve(&set->at[i], polished, roots);
            took = program_now() - start;
            least[i] = k == 0 || took < least[i] ? took : least[i];
        }
    }
    for (int i = 0; least && i < set->count; i++) {
        fprintf(to, i ? " %.17g" : "%.17g", least[i]);
    }
    fputc('\n', to);
    free(least);
}

/* The library may print what it likes: its standard output is standard error. */
static inline int program_run(const char *name)
{
    static struct peer_roots roots;
    static struct program_pair pair;
    struct program_set set = {0, 0, NULL};
    FILE *to = fdopen(dup(STDOUT_FILENO), "w");
    char *line = NULL, solver[64], command[16];
    size_t size = 0;
    int used;

    if (!to || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
        return 2;
    }
    while (getline(&line, &size, stdin) > 0) {
        used = 0;
        if (!strcmp(line, "version\n")) {
            fprintf(to, "%s\n", peer_version());
        } else if (sscanf(line, "%63s %15s%n", solver, command, &used) < 2 ||
                   strncmp(solver, name, strlen(name))) {
            fputs("error not a request\n", to);
        } else {
            const int polished = strcmp(solver, name) != 0;
            if (!strcmp(command, "solve") && program_read_pair(line + used, &pair)) {
                program_answer(to, program_solve(&pair, polished, &roots), &roots);
            } else if (!strcmp(command, "collect")) {
                fprintf(to, "%s\n", program_collect(&set, line + used));
            } else if (!strcmp(command, "clear")) {
                set.count = 0;
                fputs("ok\n", to);
            } else if (!strcmp(command, "time")) {
                program_time(to, &set, polished, atoi(line + used), &roots);
            } else if (!strcmp(command, "each")) {
                program_each(to, &set, polished, atoi(line + used), &roots);
            } else {
                fputs("error not a request\n", to);
            }
        }
        fflush(to);
    }
    return 0;
}

#endif
