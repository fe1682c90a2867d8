/* Every algorithm on many pairs, a line each with all that is in the answer: the plain build prints them, the
 * watched one compares. */
#ifndef FATLINE_ANSWERS_H
#define FATLINE_ANSWERS_H

#include <stdio.h>

#include "nasty.h"
#include "solving.h"

enum {
    ANSWERS_PAIRS = REAL_BITS > 113  ? 6
                    : REAL_BITS > 53 ? 30
                                     : 200,
    ANSWERS_STEPS = REAL_BITS > 113 ? 200 : 2000,
    ANSWER_TEXT = 256
};

/* FNV-1a, 64 bits. */
static inline void mix_byte(uint64_t *h, unsigned char byte)
{
    *h = (*h ^ byte) * 0x100000001b3u;
}

static inline void mix_interval(uint64_t *h, const struct interval *a)
{
    const real end[2] = {a->lo, a->hi};
    char text[REAL_TEXT_MAX];
    for (int k = 0; k < 2; k++) {
        real_text(end[k], text, sizeof text);
        for (const char *c = text; *c; c++)
            mix_byte(h, (unsigned char)*c);
        mix_byte(h, ' ');
    }
}

static inline uint64_t answer_hash(const struct crossings *c)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (int i = 0; i < c->count; i++) {
        mix_interval(&h, &c->at[i].t);
        mix_interval(&h, &c->at[i].s);
        mix_byte(&h, (unsigned char)c->at[i].standing);
        mix_byte(&h, (unsigned char)c->at[i].at_most);
        mix_byte(&h, (unsigned char)c->at[i].multiplicity);
    }
    for (int i = 0; i < c->overlaps; i++) {
        mix_interval(&h, &c->overlap[i].t_outer);
        mix_interval(&h, &c->overlap[i].t_inner);
        mix_interval(&h, &c->overlap[i].s_outer);
        mix_interval(&h, &c->overlap[i].s_inner);
    }
    return h;
}

/* Random pairs with a planted solution, every tenth one an overlap, every fifth one at 64 eps. */
static inline void answers_pair(struct planted *p, int i, real *tolerance)
{
    struct random_state r = random_for(1, "answers", (uint64_t)i);
    *tolerance = i % 5 ? (real)1 / 1000000000 : 64 * REAL_EPSILON;
    planted_make(p, &r, nasty_degree(&r, 8), nasty_degree(&r, 8), i % 3);
    planted_domains(p, &r);
    if (i % 10 == 9)
        p->g.curve = p->f.curve;
}

/* Solves pair i by a; z is the caller's to look at, and to clear. */
static inline void answers_solve(struct solver *z, const struct intersector *a, int i,
                                 void (*watch)(void *, enum event, const struct cell *), void *log,
                                 char *text)
{
    struct planted p;
    real tolerance;
    answers_pair(&p, i, &tolerance);
    solver_init(z, a, p.f.curve.degree, p.g.curve.degree, WORKSPACE_ROOM);
    z->workspace.watch = watch;
    z->workspace.log = log;
    struct problem problem = problem_of(&p.f.curve, &p.g.curve, tolerance, ANSWERS_STEPS);
    enum outcome o = solver_run(z, &problem);
    snprintf(text, ANSWER_TEXT, "%s %d %s steps %d records %d %d hash %016llx", a->name, i, outcome_name(o),
             z->workspace.steps, z->answer.crossings.count, z->answer.crossings.overlaps,
             (unsigned long long)answer_hash(&z->answer.crossings));
}

#endif
