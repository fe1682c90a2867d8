/* Curves from bytes, and one call of fatline_intersect: what the parts of fuzz_library.c share. */
#ifndef FATLINE_FUZZ_INPUT_H
#define FATLINE_FUZZ_INPUT_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sanitizer/asan_interface.h>

#include "fuzz_referee.h"

/* A mistake that has to be found: the same program with -DPLANTED=1. */
#ifndef PLANTED
#define PLANTED 0
#endif

enum { MOST_STEPS = 2000, STEPS_OF_MANY = 300, LENGTH = FATLINE_DEGREE_MAX + 2, SEEN = 64 };

struct input {
    const uint8_t *at;
    size_t left;
};

static uint8_t take(struct input *in)
{
    if (in->left == 0)
        return 0;
    in->left--;
    return *in->at++;
}

static void fail(const char *file, int line)
{
    fprintf(stderr, "%s:%d: does not hold\n", file, line);
    abort();
}

#define require(holds) ((holds) ? (void)0 : fail(__FILE__, __LINE__))

/* ---- two curves from bytes ---- */

/* A small dyadic, one of the numbers that make trouble, or a double of any bits. */
static double number(struct input *in)
{
    static const double nasty[] = {0,      -0.0,   1,     -1,     0.5,  1e-300, 1e300, 1.7976931348623157e308,
                                   5e-324, 1e-310, 1e150, 1e-150, 1e16, 3,      1e-16, 0.1};
    uint8_t kind = take(in);
    if (kind < 160)
        return (double)(int8_t)take(in) / 16;
    if (kind < 200)
        return nasty[take(in) % 16];
    uint64_t bits = 0;
    double a;
    for (int i = 0; i < 8; i++)
        bits = bits << 8 | take(in);
    memcpy(&a, &bits, sizeof a);
    return a;
}

struct drawn {
    double points[2 * LENGTH], weights[LENGTH];
    struct fatline_curve curve;
};

static void draw(struct input *in, struct drawn *c, int degree, bool rational, bool one_point)
{
    for (int i = 0; i < LENGTH; i++) {
        bool given = i <= degree && !(one_point && i > 0);
        c->weights[i] = rational && i <= degree ? number(in) : 1;
        c->points[2 * i] = given ? number(in) : c->points[0];
        c->points[2 * i + 1] = given ? number(in) : c->points[1];
    }
    c->curve.degree = degree;
    c->curve.points = c->points;
    c->curve.weights = rational ? c->weights : NULL;
}

/* f again, run through the other way or not, one number changed or not. */
static void draw_like(struct input *in, const struct drawn *f, bool reversed, bool changed, struct drawn *g)
{
    *g = *f;
    int n = f->curve.degree;
    for (int i = 0; reversed && i <= n && n < LENGTH; i++) {
        g->points[2 * i] = f->points[2 * (n - i)];
        g->points[2 * i + 1] = f->points[2 * (n - i) + 1];
        g->weights[i] = f->weights[n - i];
    }
    if (changed)
        g->points[take(in) % (2 * LENGTH)] = number(in);
    g->curve.points = g->points;
    g->curve.weights = f->curve.weights ? g->weights : NULL;
}

static struct fatline_options draw_options(struct input *in)
{
    struct fatline_options o = {ldexp(1, -(int)(take(in) % 56)), MOST_STEPS};
    if (take(in) < 64)
        o.max_steps = 1 + take(in);
    return o;
}

/* Nothing else is a problem. */
static bool is_valid(const struct fatline_curve *c, int most)
{
    double least = INFINITY, heavy = 0;
    if (c->degree < 1 || c->degree > most)
        return false;
    for (int i = 0; i <= c->degree; i++) {
        double w = c->weights ? c->weights[i] : 1;
        if (!isfinite(c->points[2 * i]) || !isfinite(c->points[2 * i + 1]) || !isfinite(w) || !(w > 0))
            return false;
        least = fmin(least, w);
        heavy = fmax(heavy, w);
    }
    return ldexp(heavy, -256) <= least;
}

/* ---- memory ---- */

/* Bytes that stay from one input to the next; those beyond the size asked for may not be touched. */
struct arena {
    char *bytes;
    size_t size, room;
};

/* What was there remains. */
static void *exactly(struct arena *a, size_t size)
{
    if (a->bytes && size == a->size)
        return a->bytes;
    if (a->bytes)
        ASAN_UNPOISON_MEMORY_REGION(a->bytes, a->room);
    if (size > a->room) {
        a->room = 2 * size;
        a->bytes = realloc(a->bytes, a->room);
    }
    a->size = size;
    ASAN_POISON_MEMORY_REGION(a->bytes + size, a->room - size);
    return a->bytes;
}

/* ---- one call ---- */

struct kept {
    struct fatline_answer answer;
    struct fatline_crossing crossing[FATLINE_CROSSINGS_MAX];
    struct fatline_overlap overlap[FATLINE_OVERLAPS_MAX];
};

/* In memory of just the size asked for. */
static void solve(int degree, const struct fatline_curve *f, const struct fatline_curve *g,
                  const struct fatline_options *o, struct kept *out)
{
    static struct arena arena;
    size_t size = fatline_workspace_size(degree);
    struct fatline_workspace *w = fatline_workspace_init(exactly(&arena, size), size, degree);
    struct fatline_answer *a = &out->answer;
    require(w != NULL);
    require(fatline_intersect(w, f, g, o, a) == a->outcome);
    require((a->error != NULL) == (a->outcome == FATLINE_INVALID));
    require(a->steps <= (o->max_steps > 0 ? o->max_steps : 100000));
    memcpy(out->crossing, a->crossing, (size_t)a->count * sizeof *a->crossing);
    memcpy(out->overlap, a->overlap, (size_t)a->overlaps * sizeof *a->overlap);
    a->crossing = out->crossing;
    a->overlap = out->overlap;
    for (int i = 0; PLANTED && i < a->count; i++)
        if (out->crossing[i].standing == FATLINE_UNIQUE)
            out->crossing[i].t_lo = out->crossing[i].t_hi;
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

static bool is_range(double lo, double hi)
{
    return 0 <= lo && lo <= hi && hi <= 1;
}

static void check_form(const struct fatline_answer *a)
{
    for (int i = 0; i < a->count; i++) {
        const struct fatline_crossing *c = &a->crossing[i];
        require(is_range(c->t_lo, c->t_hi) && is_range(c->s_lo, c->s_hi));
        require(c->standing == FATLINE_CANDIDATE ? c->at_most == 0 : c->at_most >= 1);
        require(i == 0 || c[-1].t_lo < c->t_lo || (c[-1].t_lo == c->t_lo && c[-1].s_lo <= c->s_lo));
    }
    for (int i = 0; i < a->overlaps; i++) {
        const struct fatline_overlap *o = &a->overlap[i];
        require(is_range(o->t_outer_lo, o->t_outer_hi) && is_range(o->s_outer_lo, o->s_outer_hi));
        require(o->t_outer_lo <= o->t_inner_lo && o->t_inner_hi <= o->t_outer_hi && o->distance >= 0);
    }
}

#endif
