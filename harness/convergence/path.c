#include "path.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"
#include "../run/memory.h"

double real_bits(real a)
{
    if (!(a > 0))
        return INFINITY;
    int e = real_exponent(a);
    return -(e + log2(real_to_double(real_ldexp(a, -e))));
}

void path_init(struct path *p)
{
    memset((void *)p, 0, sizeof *p);
}

void path_clear(struct path *p)
{
    free(p->bits_t);
    free(p->bits_s);
    free(p->split);
    path_init(p);
}

static void add(struct path *p, double bits_t, double bits_s, bool split)
{
    if (p->count == p->room) {
        p->room = p->room ? 2 * p->room : 64;
        p->bits_t = (double *)memory_resized(p->bits_t, (size_t)p->room * sizeof *p->bits_t);
        p->bits_s = (double *)memory_resized(p->bits_s, (size_t)p->room * sizeof *p->bits_s);
        p->split = (bool *)memory_resized(p->split, (size_t)p->room * sizeof *p->split);
    }
    p->bits_t[p->count] = bits_t;
    p->bits_s[p->count] = bits_s;
    p->split[p->count++] = split;
}

static bool meet(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

static bool ignore(void *log, const struct cell *c)
{
    struct path *p = (struct path *)log;
    bool swapped = p->workspace->swapped;
    const struct interval *t = swapped ? &c->s : &c->t, *s = swapped ? &c->t : &c->s;
    if (p->ended || !meet(t, &p->t) || !meet(s, &p->s))
        return true;
    double bits_t = real_bits(t->hi - t->lo), bits_s = real_bits(s->hi - s->lo);
    int last = p->count - 1;
    if (last < 0 || bits_t > p->bits_t[last] || bits_s > p->bits_s[last])
        add(p, bits_t, bits_s, p->halved);
    return false;
}

/* Everything else is dropped, so each event is about the cell on the path or its pieces. */
static void watch(void *log, enum event e, const struct cell *c)
{
    struct path *p = (struct path *)log;
    (void)c;
    p->halved = e == SPLIT;
    p->splits += e == SPLIT;
    p->clips += e == SHRUNK;
    p->kept = p->kept || e == ACCEPTED;
    p->ended = p->ended || e == ACCEPTED;
}

/* The solution as this precision sees it: within its error and the rounding of the parameter. */
static struct interval enclose(const mpq_t t, double bits)
{
    real middle = real_from_rational(t), pad = REAL_EPSILON * real_abs(middle);
    if (bits < 2 * REAL_BITS)
        pad = pad + real_ldexp(1, -(int)bits);
    struct interval a = {middle - pad, middle + pad};
    return a;
}

void path_follow(struct path *p, const struct problem *problem, const struct intersector *a,
                 struct workspace *w, const struct known_solution *z, struct crossings *out)
{
    p->count = p->clips = p->splits = 0;
    p->kept = p->halved = p->ended = false;
    p->workspace = w;
    p->t = enclose(z->t, z->bits);
    p->s = enclose(z->s, z->bits);
    w->watch = watch;
    w->ignore = ignore;
    w->log = p;
    problem_solve(problem, a, w, out);
    w->watch = NULL;
    w->ignore = NULL;
    w->log = NULL;
}
