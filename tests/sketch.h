/* Pairs of curves in rational numbers, with solutions planted, as case lines: for the tests of the referee.
 */
#ifndef FATLINE_TEST_SKETCH_H
#define FATLINE_TEST_SKETCH_H

#include <math.h>
#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/truth/referee_cells.h"
#include "../harness/cases/case.h"
#include "../harness/truth/referee.h"
#include "../harness/truth/referee_pair.h"

enum { TRIALS = 150, LINE_BYTES = 1 << 16 };

struct sketch {
    int degree;
    bool rational;
    mpq_t x[33], y[33], w[33];
};

static inline void sketch_init(struct sketch *k, int degree, bool rational)
{
    k->degree = degree;
    k->rational = rational;
    for (int i = 0; i <= degree; i++) {
        mpq_inits(k->x[i], k->y[i], k->w[i], NULL);
        mpq_set_ui(k->w[i], 1, 1);
    }
}

static inline void sketch_clear(struct sketch *k)
{
    for (int i = 0; i <= k->degree; i++)
        mpq_clears(k->x[i], k->y[i], k->w[i], NULL);
}

static inline void sketch_random(struct sketch *k, struct random_state *r, int degree, bool rational)
{
    sketch_init(k, degree, rational);
    for (int i = 0; i <= degree; i++) {
        mpq_set_si(k->x[i], random_between(r, -(1 << 20), 1 << 20), 1 << 20);
        mpq_set_si(k->y[i], random_between(r, -(1 << 20), 1 << 20), 1 << 20);
        if (rational)
            mpq_set_si(k->w[i], random_between(r, 1 << 8, 1 << 10), 1 << 9);
        mpq_canonicalize(k->x[i]);
        mpq_canonicalize(k->y[i]);
        mpq_canonicalize(k->w[i]);
    }
}

/* The polar form of the coefficients c at a (n - i times) and b (i times). */
static inline void polar(int n, const mpq_t *c, const mpq_t a, const mpq_t b, int i, mpq_t out)
{
    mpq_t p[33], u, v;
    mpq_inits(u, v, NULL);
    for (int j = 0; j <= n; j++) {
        mpq_init(p[j]);
        mpq_set(p[j], c[j]);
    }
    for (int k = 0; k < n; k++)
        for (int j = 0; j < n - k; j++) {
            mpq_sub(u, p[j + 1], p[j]);
            mpq_mul(v, u, k < i ? b : a);
            mpq_add(p[j], p[j], v);
        }
    mpq_set(out, p[0]);
    for (int j = 0; j <= n; j++)
        mpq_clear(p[j]);
    mpq_clears(u, v, NULL);
}

static inline void point(const struct sketch *k, const mpq_t t, mpq_t x, mpq_t y)
{
    mpq_t h[33], w;
    mpq_init(w);
    for (int i = 0; i <= k->degree; i++)
        mpq_init(h[i]);
    polar(k->degree, k->w, t, t, 0, w);
    for (int axis = 0; axis < 2; axis++) {
        for (int i = 0; i <= k->degree; i++)
            mpq_mul(h[i], axis ? k->y[i] : k->x[i], k->w[i]);
        polar(k->degree, h, t, t, 0, axis ? y : x);
        mpq_div(axis ? y : x, axis ? y : x, w);
    }
    for (int i = 0; i <= k->degree; i++)
        mpq_clear(h[i]);
    mpq_clear(w);
}

/* Moves g so that f(t) = g(s). */
static inline void plant(const struct sketch *f, struct sketch *g, const mpq_t t, const mpq_t s)
{
    mpq_t x, y, dx, dy;
    mpq_inits(x, y, dx, dy, NULL);
    point(f, t, dx, dy);
    point(g, s, x, y);
    mpq_sub(dx, dx, x);
    mpq_sub(dy, dy, y);
    for (int i = 0; i <= g->degree; i++) {
        mpq_add(g->x[i], g->x[i], dx);
        mpq_add(g->y[i], g->y[i], dy);
    }
    mpq_clears(x, y, dx, dy, NULL);
}

static inline int print_curve(char *text, const struct sketch *k)
{
    int n = sprintf(text, "{\"points\":[");
    for (int i = 0; i <= k->degree; i++)
        n += gmp_sprintf(text + n, "%s[\"%Qd\",\"%Qd\"]", i ? "," : "", k->x[i], k->y[i]);
    n += sprintf(text + n, "]");
    if (k->rational)
        for (int i = 0; i <= k->degree; i++)
            n += gmp_sprintf(text + n, "%s\"%Qd\"%s", i ? "," : ",\"weights\":[", k->w[i],
                             i == k->degree ? "]" : "");
    return n + sprintf(text + n, "}");
}

static inline void case_make(struct test_case *c, const struct sketch *f, const struct sketch *g)
{
    static char line[LINE_BYTES];
    char error[512];
    int n = sprintf(line, "{\"id\":\"made\",\"f\":");
    n += print_curve(line + n, f);
    n += sprintf(line + n, ",\"g\":");
    n += print_curve(line + n, g);
    sprintf(line + n, "}");
    if (case_parse(line, "made", 1, c, error) != CASE_READ)
        fail_msg("%s", error);
}

/* The two numbers a / 64 of a trial, now and then an end. */
static inline void random_place(struct random_state *r, mpq_t t)
{
    mpq_set_si(t, random_between(r, 0, 64), 64);
    mpq_canonicalize(t);
}

static inline double distance(const mpq_t a, const mpq_t b)
{
    mpq_t d;
    mpq_init(d);
    mpq_sub(d, a, b);
    double v = fabs(mpq_get_d(d));
    mpq_clear(d);
    return v;
}

#endif
