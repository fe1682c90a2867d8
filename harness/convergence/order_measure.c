#include "order_measure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "close_up.h"
#include "../cases/problem.h"
#include "../run/memory.h"

void order_bench_make(struct order_bench *b, const struct intersector *const *a, int n)
{
    workspace_make(&b->workspace, a, n, n, WORKSPACE_ROOM);
    b->crossings = (struct crossings *)memory_new(1, sizeof *b->crossings);
    path_init(&b->path);
}

void order_bench_clear(struct order_bench *b)
{
    path_clear(&b->path);
    free(b->crossings);
    workspace_clear(&b->workspace);
}

/* For curves 2^-extent times as large as the whole pair. */
static double floor_at(const struct known_solution *z, double extent)
{
    /* The bounds of the algorithms are about 50 units in the last place: 2^SLACK is 300 times as much, and
     * changes a width by less than 0.005 bits. */
    enum { SLACK = 14 };
    double floor = (REAL_BITS - SLACK + extent - z->sine_bits) / (z->multiplicity > 1 ? z->multiplicity : 1);
    return fmin(floor, z->bits - 8);
}

/* At contacts, where bounds of the second order come in, a quarter less. */
double order_floor(const struct known_solution *z)
{
    return floor_at(z, 0) * (z->multiplicity == 1 ? 1 : 0.75);
}

struct order_estimate order_by_rounds(struct order_bench *b, const struct problem *p,
                                      const struct intersector *a, const struct known_solution *z,
                                      double bits)
{
    struct problem q = *p;
    double floor = order_floor(z);
    q.tolerance = real_ldexp(1, -(int)fmin(bits, floor)) * (q.f.domain.hi - q.f.domain.lo);
    path_follow(&b->path, &q, a, &b->workspace, z, b->crossings);
    return order_of_widths(b->path.count, b->path.bits_t, b->path.bits_s, floor);
}

/* ---- single rounds ---- */

/* BELOW: under the rounding floor.  BROKEN: halved before the round was over.  UNSEEN: no path, or it ends
 * early. */
enum round_end { WHOLE, BELOW, BROKEN, UNSEEN };

struct round {
    enum round_end end;
    double x, y; /* bits after it, of the same widths as the boxes */
    int clips;
};

/* Follows the solution from a box; *floor: bits, of widths in the parameters of the whole curves. */
static bool follow_from(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                        const struct known_solution *z, double bits_x, double bits_y, bool exchanged,
                        double *floor)
{
    enum { STEPS = 6 };
    struct test_case near;
    struct known_solution at;
    struct owned_problem owned;
    close_up_make(c, z, bits_x, bits_y, exchanged, &near);
    *floor = floor_at(z, extent_bits(&near) - z->extent);
    close_up_solution(z, bits_x, bits_y, exchanged, &at);
    bool made = !owned_problem_make(&near, real_ldexp(1, 3 - REAL_BITS), STEPS, &owned);
    if (made) {
        owned.problem.keep_order = true;
        path_follow(&b->path, &owned.problem, a, &b->workspace, &at, b->crossings);
        owned_problem_clear(&owned);
    }
    close_up_clear(&near);
    mpq_clears(at.t, at.s, NULL);
    return made;
}

static struct round round_from(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                               const struct known_solution *z, double bits_x, double bits_y, bool exchanged)
{
    const struct path *p = &b->path;
    struct round r = {UNSEEN, NAN, NAN, 0};
    double floor;
    bool first = false;
    if (!follow_from(b, c, a, z, bits_x, bits_y, exchanged, &floor))
        return r;
    if (p->splits > 0)
        r.end = BROKEN;
    for (int i = 1; i < p->count && !p->split[i]; i++) {
        bool cut_x = p->bits_t[i] > p->bits_t[i - 1], cut_y = p->bits_s[i] > p->bits_s[i - 1];
        r.x = bits_x + p->bits_t[i];
        r.y = bits_y + p->bits_s[i];
        r.clips = i;
        if (r.x > floor || r.y > floor) {
            r.end = BELOW;
            return r;
        }
        first = first || cut_x;
        if (cut_y) {
            r.end = first ? WHOLE : BROKEN;
            return r;
        }
    }
    return r;
}

double one_cut(struct order_bench *b, const struct test_case *c, const struct intersector *a,
               const struct known_solution *z, double bits_x, double bits_y, bool exchanged, bool *below)
{
    const struct path *p = &b->path;
    double floor;
    *below = false;
    if (!follow_from(b, c, a, z, bits_x, bits_y, exchanged, &floor) || p->count < 2 || p->split[1] ||
        !(p->bits_t[1] > p->bits_t[0]))
        return NAN;
    *below = bits_x + p->bits_t[1] > floor;
    return *below ? NAN : bits_x + p->bits_t[1];
}

/* Rounds from boxes of one shape. */
enum { BOXES_MAX = 16 };

struct rounds {
    int count, below, broken, clips;
    double before_x[BOXES_MAX], x[BOXES_MAX], y[BOXES_MAX];
};

struct shape {
    double power; /* y = x^power */
    bool exchanged;
};

/* The largest number of bits of x for which a round does not end below the floor: all those above do. */
static double most_bits(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                        const struct known_solution *z, struct shape shape)
{
    double lo = 1, hi = fmin(REAL_BITS, z->bits) / shape.power;
    while (hi - lo > 0.5 + lo / 64) {
        double middle = (lo + hi) / 2;
        struct round r = round_from(b, c, a, z, middle, shape.power * middle, shape.exchanged);
        if (r.end == BELOW)
            hi = middle;
        else
            lo = middle;
    }
    return lo;
}

/* From the widest boxes worth it, a quarter of the bits of the narrowest but at least `widest`, to these.
 * Where there is no room for that there are no rounds; where even a round from a quarter of both curves ends
 * below the floor, all do. */
static void measure_shape(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                          const struct known_solution *z, struct shape shape, struct rounds *m)
{
    const double widest = fmax(1.5, fmax(z->alone + 1, z->sine_bits + 1)), room = 1.5;
    double most = most_bits(b, c, a, z, shape), least = fmax(most / 4, widest);
    m->count = m->below = m->broken = m->clips = 0;
    if (most < least + room) {
        m->below = most < 2 ? BOXES_MAX : 0;
        return;
    }
    for (int i = 0; i < BOXES_MAX; i++) {
        double bits = least + (most - least) * i / (BOXES_MAX - 1);
        struct round r = round_from(b, c, a, z, bits, shape.power * bits, shape.exchanged);
        m->below += r.end == BELOW;
        m->broken += r.end == BROKEN;
        if (r.end == WHOLE) {
            m->before_x[m->count] = bits;
            m->x[m->count] = r.x;
            m->clips = r.clips;
            m->y[m->count++] = r.y;
        }
    }
}

/* The shape that rounds from these boxes leave: bits of y over bits of x, by their slopes. */
static double shape_left(const struct rounds *m)
{
    int half = m->count / 2;
    double dx = m->x[m->count - 1] - m->x[half], dy = m->y[m->count - 1] - m->y[half];
    return dx > 0 && dy > 0 ? fmin(fmax(dy / dx, 0.25), 4) : 1;
}

static struct order_estimate estimate(const struct rounds *m, double power)
{
    double before[BOXES_MAX], after[BOXES_MAX];
    for (int i = 0; i < m->count; i++) {
        before[i] = m->before_x[i] * (1 + power) / 2;
        after[i] = (m->x[i] + m->y[i]) / 2;
    }
    struct order_estimate e = order_of_boxes(m->count, before, after, m->below);
    if (e.law == SUPERLINEAR)
        e.clips = m->clips;
    if (e.law == TOO_FEW && m->broken > BOXES_MAX / 2) {
        e.law = STALLED;
        e.points = m->broken;
    }
    return e;
}

/* The first shape in which most rounds are whole, or end below the floor; else the square. */
static struct shape find_shape(struct order_bench *b, const struct test_case *c, const struct intersector *a,
                               const struct known_solution *z, struct rounds *m)
{
    static const struct shape shapes[] = {{1, false}, {1, true},  {2, false},
                                          {2, true},  {3, false}, {3, true}};
    enum { SHAPES = sizeof shapes / sizeof *shapes };
    for (int i = 0; i < SHAPES; i++) {
        measure_shape(b, c, a, z, shapes[i], m);
        if (m->count + m->below > BOXES_MAX / 2)
            return shapes[i];
    }
    measure_shape(b, c, a, z, shapes[0], m);
    return shapes[0];
}

static bool is_near(double a, double b, double part)
{
    return fabs(a - b) <= part * b;
}

struct order_estimate order_by_boxes(struct order_bench *b, const struct test_case *c,
                                     const struct intersector *a, const struct known_solution *z)
{
    enum { ITERATIONS = 3, ENOUGH = BOXES_MAX / 2 };
    struct rounds m;
    struct shape shape = find_shape(b, c, a, z, &m);
    for (int i = 0; i < ITERATIONS && m.count >= ENOUGH && !is_near(shape_left(&m), shape.power, 0.02); i++) {
        struct shape next = {shape_left(&m), shape.exchanged};
        struct rounds again;
        measure_shape(b, c, a, z, next, &again);
        if (again.count < ENOUGH)
            break;
        shape = next;
        m = again;
    }
    struct order_estimate e = estimate(&m, shape.power);
    if (e.law == SUPERLINEAR && !is_near(shape_left(&m), shape.power, 0.15)) {
        e.law = TOO_FEW;
        e.per_round = e.lo = e.hi = NAN;
        e.clips = 0;
    }
    return e;
}
