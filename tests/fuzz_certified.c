/* libFuzzer on the certified algorithm: bit patterns as control points.  `make fuzz` builds and runs it.
 *
 * Whatever the numbers are, the call ends within its steps, writes nowhere else, calls what is not finite
 * INVALID, and gives records within the domains whose curves do come near each other. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../algorithms/bezier.h"
#include "../algorithms/core/curve.h"

enum { MOST_STEPS = 2000 };

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

/* A double of any bits, a small dyadic, or one of the numbers that make trouble. */
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
    double x[DEGREE_MAX + 2], y[DEGREE_MAX + 2], w[DEGREE_MAX + 2];
    struct curve curve;
};

static void draw(struct input *in, struct drawn *c, int degree, bool rational)
{
    for (int i = 0; i <= DEGREE_MAX + 1; i++) {
        c->w[i] = rational ? number(in) : 1;
        c->x[i] = i <= degree ? number(in) : 0;
        c->y[i] = i <= degree ? number(in) : 0;
    }
    c->curve.degree = degree;
    c->curve.x = c->x;
    c->curve.y = c->y;
    c->curve.w = rational ? c->w : NULL;
    c->curve.domain.lo = 0;
    c->curve.domain.hi = 1;
}

static bool is_finite(const struct curve *c, double *size)
{
    for (int i = 0; i <= c->degree; i++) {
        double w = c->w ? c->w[i] : 1, x = c->x[i] / w, y = c->y[i] / w;
        if (!(w > 0) || !isfinite(w) || !isfinite(c->x[i]) || !isfinite(c->y[i]) || !isfinite(x) ||
            !isfinite(y))
            return false;
        *size = fmax(*size, fmax(fabs(x), fabs(y)));
    }
    return true;
}

static void require(bool holds)
{
    if (!holds)
        abort();
}

/* The middle of a UNIQUE is no farther from a common point than its width allows: |f'| <= 2 n size max w /
 * min w. */
static void check_unique(const struct problem *p, const struct crossing *c, double size)
{
    double t = (c->t.lo + c->t.hi) / 2, s = (c->s.lo + c->s.hi) / 2;
    const struct curve *f = &p->f, *g = &p->g;
    if (f->w || g->w || !(size > 1e-200) || !(size < 1e200))
        return;
    struct point a = curve_point(f->degree, f->x, f->y, NULL, t),
                 b = curve_point(g->degree, g->x, g->y, NULL, s);
    double width = (c->t.hi - c->t.lo) * f->degree + (c->s.hi - c->s.lo) * g->degree + 400 * REAL_EPSILON;
    require(fabs(a.x - b.x) <= 2 * size * width && fabs(a.y - b.y) <= 2 * size * width);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    static struct crossings out;
    struct input in = {data, length};
    struct drawn f, g;
    int n = take(&in) % (DEGREE_MAX + 2), m = take(&in) % (DEGREE_MAX + 2);
    if (take(&in) < 200) {
        n = n % 5;
        m = m % 5;
    }
    uint8_t kinds = take(&in);
    draw(&in, &f, n, kinds % 4 == 3);
    draw(&in, &g, m, kinds / 4 % 4 == 3);
    if (kinds / 16 % 4 == 3) {
        g = f;
        m = n;
    }
    g.curve.x = g.x;
    g.curve.y = g.y;
    g.curve.w = g.curve.w ? g.w : NULL;
    struct problem p;
    memset(&p, 0, sizeof p);
    p.f = f.curve;
    p.g = g.curve;
    p.tolerance = ldexp(1, -(int)(take(&in) % 56));
    p.max_steps = take(&in) < 64 ? 1 + take(&in) : (int)MOST_STEPS;
    const struct intersector *a = intersector_find("certified");
    int most_n = n > 0 && n <= DEGREE_MAX ? n : 1, most_m = m > 0 && m <= DEGREE_MAX ? m : 1;
    most_n = most_m = most_n > most_m ? most_n : most_m;
    size_t scratch = a->scratch(most_n, most_m);
    void *memory = malloc(workspace_size(most_n, most_m, 1, scratch));
    struct workspace w;
    workspace_init(&w, memory, most_n, most_m, 1, scratch);
    enum outcome o = problem_solve(&p, a, &w, &out);
    double size = 0;
    bool valid = n > 0 && m > 0 && n <= DEGREE_MAX && m <= DEGREE_MAX && is_finite(&p.f, &size) &&
                 is_finite(&p.g, &size);
    require((o == INVALID) == !valid);
    require(w.steps <= p.max_steps);
    for (int i = 0; i < out.count; i++) {
        const struct crossing *c = &out.at[i];
        require(0 <= c->t.lo && c->t.lo <= c->t.hi && c->t.hi <= 1 && 0 <= c->s.lo && c->s.lo <= c->s.hi &&
                c->s.hi <= 1);
        if (c->standing == UNIQUE)
            check_unique(&p, c, size);
    }
    free(memory);
    return 0;
}
