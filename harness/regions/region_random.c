#include "region_random.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "../cases/random.h"

enum { POINTS_MAX = 24, KNOT_PARTS = 8 };

struct text {
    char *at;
    size_t used;
};

__attribute__((format(printf, 2, 3))) static void put(struct text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(t->at + t->used, REGION_LINE_MAX - t->used, format, arguments);
    va_end(arguments);
    t->used += n > 0 && t->used + (size_t)n < REGION_LINE_MAX ? (size_t)n : 0;
}

static int between(struct random_state *r, int lo, int hi)
{
    return (int)random_between(r, lo, hi);
}

/* Inner knots, in eighths, in increasing order; returns their number. */
static int draw_knots(struct random_state *r, int degree, int *knot)
{
    int count = 0, wanted = between(r, 1, 4), times[KNOT_PARTS] = {0};
    for (int i = 0; i < wanted; i++)
        times[between(r, 1, KNOT_PARTS - 1)]++;
    for (int v = 1; v < KNOT_PARTS; v++)
        for (int i = 0; i < times[v] && i < degree - 1; i++)
            knot[count++] = v;
    return count;
}

static void put_knots(struct text *t, int degree, int inner, const int *knot)
{
    put(t, ",\"knots\":[");
    for (int i = 0; i <= degree; i++)
        put(t, "0,");
    for (int i = 0; i < inner; i++)
        put(t, "\"%d/%d\",", knot[i], KNOT_PARTS);
    for (int i = 0; i <= degree; i++)
        put(t, "1%s", i < degree ? "," : "]");
}

/* (10 (1 - u^2) / (1 + u^2), 20 u / (1 + u^2)) goes round a circle; a unit or two off it. */
static void put_points(struct text *t, struct random_state *r, int count)
{
    bool round = random_bits(r) & 1;
    double from = -1 - 2 * random_unit(r), to = 1 + 2 * random_unit(r);
    put(t, ",\"points\":[");
    for (int i = 0; i < count; i++) {
        double u = from + (to - from) * i / (count - 1), q = 1 + u * u;
        int x = between(r, -2, 2), y = between(r, -2, 2);
        if (round)
            put(t, "[%d,%d]", x + (int)floor(10 * (1 - u * u) / q), y + (int)floor(20 * u / q));
        else
            put(t, "[%d,%d]", between(r, -12, 12), between(r, -12, 12));
        put(t, i + 1 < count ? "," : "]");
    }
}

static void put_weights(struct text *t, struct random_state *r, int count)
{
    static const char *const weights[] = {"1", "1", "2", "\"1/2\"", "3"};
    put(t, ",\"weights\":[");
    for (int i = 0; i < count; i++)
        put(t, "%s%s", weights[between(r, 0, 4)], i + 1 < count ? "," : "]");
}

void region_random_line(uint64_t seed, int lo, int hi, uint64_t index, char line[REGION_LINE_MAX])
{
    struct random_state r = random_for(seed, "region", index);
    struct text t = {line, 0};
    int degree = between(&r, lo, hi), inner = 0, knot[POINTS_MAX];
    bool spline = random_bits(&r) & 1, rational = random_bits(&r) & 1;
    if (spline)
        inner = draw_knots(&r, degree, knot);
    int count = degree + 1 + inner;
    put(&t, "{\"id\":\"region-%llu-%llu\",\"degree\":%d", (unsigned long long)seed, (unsigned long long)index,
        degree);
    if (spline)
        put_knots(&t, degree, inner, knot);
    put_points(&t, &r, count);
    if (rational)
        put_weights(&t, &r, count);
    put(&t, ",\"free\":%d,\"sign\":%d", between(&r, 0, count - 1), between(&r, 0, 2) ? 1 : -1);
    if (between(&r, 0, 2) == 0) {
        int a = between(&r, 0, 6), b = between(&r, a + 2, 10);
        put(&t, ",\"interval\":[\"%d/10\",\"%d/10\"]", a, b);
    }
    put(&t, "}");
}
