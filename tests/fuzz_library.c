/* libFuzzer on the library's entry: bit patterns as control points, weights, degrees.  `make fuzz` runs it.
 *
 * Whatever the numbers are: the call ends within its steps and writes nowhere else; what is no problem is
 * INVALID and nothing else is; records are sorted and within [0, 1]; exchanging the curves exchanges the
 * records bit for bit.  And the records are true of the curves of the given doubles, evaluated with 113 bits
 * (fuzz_referee.h): a UNIQUE holds the solution that Newton's method finds from its middle, and no other;
 * every solution found from anywhere is in some record, and in no two that claim one; a CLUSTER holds no more
 * than it says. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz_referee.h"

/* A mistake that has to be found: the same program with -DPLANTED=1. */
#ifndef PLANTED
#define PLANTED 0
#endif

enum { MOST_STEPS = 2000, LENGTH = FATLINE_DEGREE_MAX + 2, SEEN = 64 };

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

static void fail(int line)
{
    fprintf(stderr, "fuzz_library.c:%d: does not hold\n", line);
    abort();
}

#define require(holds) ((holds) ? (void)0 : fail(__LINE__))

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
    size_t size = fatline_workspace_size(degree);
    void *memory = malloc(size);
    struct fatline_workspace *w = fatline_workspace_init(memory, size, degree);
    struct fatline_answer *a = &out->answer;
    require(w != NULL);
    require(fatline_intersect(w, f, g, o, a) == a->outcome);
    require((a->error != NULL) == (a->outcome == FATLINE_INVALID));
    require(a->steps <= (o->max_steps > 0 ? o->max_steps : 100000));
    memcpy(out->crossing, a->crossing, (size_t)a->count * sizeof *a->crossing);
    memcpy(out->overlap, a->overlap, (size_t)a->overlaps * sizeof *a->overlap);
    a->crossing = out->crossing;
    a->overlap = out->overlap;
    free(memory);
    for (int i = 0; PLANTED && i < a->count; i++)
        if (out->crossing[i].standing == FATLINE_UNIQUE)
            out->crossing[i].t_lo = out->crossing[i].t_hi;
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

/* The same control points and, up to a factor, weights: then there is nothing to exchange. */
static bool is_same_curve(const struct fatline_curve *f, const struct fatline_curve *g)
{
    bool same = f->degree == g->degree && !f->weights == !g->weights;
    for (int i = 0; same && i <= f->degree; i++) {
        same = f->points[2 * i] == g->points[2 * i] && f->points[2 * i + 1] == g->points[2 * i + 1];
        same = same &&
               (!f->weights || (quad)f->weights[i] * g->weights[0] == (quad)g->weights[i] * f->weights[0]);
    }
    return same;
}

static void check_exchanged(const struct fatline_answer *a, const struct fatline_answer *b)
{
    require(a->outcome == b->outcome && a->count == b->count && a->overlaps == b->overlaps);
    for (int i = 0; i < a->count && i < SEEN; i++) {
        const struct fatline_crossing *c = &a->crossing[i];
        bool found = false;
        for (int j = 0; j < b->count && !found; j++) {
            const struct fatline_crossing *d = &b->crossing[j];
            found = c->t_lo == d->s_lo && c->t_hi == d->s_hi && c->s_lo == d->t_lo && c->s_hi == d->t_hi &&
                    c->standing == d->standing && c->at_most == d->at_most;
        }
        require(found);
    }
}

/* ---- the entry ---- */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    static struct kept one, other;
    struct input in = {data, length};
    struct drawn f, g;
    int n = take(&in) % LENGTH, m = take(&in) % LENGTH;
    if (take(&in) < 200) {
        n = n % 5;
        m = m % 5;
    }
    uint8_t kinds = take(&in), like = take(&in);
    draw(&in, &f, n, kinds % 4 == 3, kinds >= 240);
    if (like < 192)
        draw(&in, &g, m, kinds / 4 % 4 == 3, false);
    else
        draw_like(&in, &f, like & 1, like & 2, &g);
    struct fatline_options o = {ldexp(1, -(int)(take(&in) % 56)),
                                take(&in) < 64 ? 1 + take(&in) : (int)MOST_STEPS};
    int degree = n > g.curve.degree ? n : g.curve.degree, most = degree < 1 ? 1 : degree > 32 ? 32 : degree;
    solve(most, &f.curve, &g.curve, &o, &one);
    solve(most, &g.curve, &f.curve, &o, &other);
    bool valid = is_valid(&f.curve, most) && is_valid(&g.curve, most);
    require(valid == (one.answer.outcome != FATLINE_INVALID));
    check_form(&one.answer);
    if (!PLANTED && !is_same_curve(&f.curve, &g.curve))
        check_exchanged(&one.answer, &other.answer);
    if (valid)
        require(referee_agrees(&f.curve, &g.curve, &one.answer, data, length));
    return 0;
}
