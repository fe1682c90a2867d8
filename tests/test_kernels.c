/* The kernels in front of the certified algorithm against the engine alone: the same number of records, of
 * the same standings and intersecting, the same bits when the curves are exchanged or scaled, and in every
 * record of one zero a zero of the given curves, by Newton's method in twice the digits. */
#include <quadmath.h>
#include <stdio.h>

#include "prop.h"
#include "solving.h"

enum { PAIRS = 40000 };

struct sample {
    struct prop_curve f, g;
};

/* The kernels of this processor, and those for AVX2 alone. */
enum { VARIANTS = 2 };
static const char *const variant[VARIANTS] = {"certified", "certified_avx2"};
static struct solver kernels[VARIANTS], again[VARIANTS], engine;

/* ---- pairs ---- */

static double unit(struct random_state *r)
{
    return (double)prop_dyadic(r, 53);
}

static void curve_set(struct prop_curve *c, int degree)
{
    c->curve = (struct curve){degree, c->x, c->y, NULL, {0, 1}};
}

static void make_random(struct random_state *r, struct sample *p)
{
    curve_set(&p->f, (int)random_between(r, 1, 3));
    curve_set(&p->g, (int)random_between(r, 1, 3));
    for (int i = 0; i <= 3; i++) {
        p->f.x[i] = unit(r);
        p->f.y[i] = unit(r);
        p->g.x[i] = unit(r);
        p->g.y[i] = unit(r);
    }
}

/* One arc along x, one along y, little bent. */
static void make_nice(struct random_state *r, struct sample *p)
{
    make_random(r, p);
    for (int i = 0; i <= p->f.curve.degree; i++) {
        p->f.x[i] = -1 + 2.0 * i / p->f.curve.degree + unit(r) / 16;
        p->f.y[i] = unit(r) / 4;
    }
    for (int i = 0; i <= p->g.curve.degree; i++) {
        p->g.y[i] = -1 + 2.0 * i / p->g.curve.degree + unit(r) / 16;
        p->g.x[i] = unit(r) / 4;
    }
}

/* y = T3(x) and x = T3(y), disturbed. */
static void make_nine(struct random_state *r, struct sample *p)
{
    static const double slow[] = {-1, -1.0 / 3, 1.0 / 3, 1}, wave[] = {-1, 5, -5, 1};
    make_random(r, p);
    curve_set(&p->f, 3);
    curve_set(&p->g, 3);
    for (int i = 0; i <= 3; i++) {
        p->f.x[i] = slow[i] + p->f.x[i] / 32;
        p->f.y[i] = wave[i] + p->f.y[i] / 32;
        p->g.x[i] = wave[i] + p->g.x[i] / 32;
        p->g.y[i] = slow[i] + p->g.y[i] / 32;
    }
}

/* The same, so much disturbed that some of the crossings are lost, or nearly. */
static void make_crowd(struct random_state *r, struct sample *p)
{
    double by = ldexp(1, -(int)random_between(r, 1, 5)), stretch = 1 + unit(r) / 4;
    struct sample plain = {0};
    make_nine(r, &plain);
    make_random(r, p);
    curve_set(&p->f, 3);
    curve_set(&p->g, 3);
    for (int i = 0; i <= 3; i++) {
        p->f.x[i] = plain.f.x[i] + by * p->f.x[i];
        p->f.y[i] = stretch * plain.f.y[i] + by * p->f.y[i];
        p->g.x[i] = plain.g.x[i] + by * p->g.x[i];
        p->g.y[i] = plain.g.y[i] + by * p->g.y[i];
    }
}

static void make_far(struct random_state *r, struct sample *p)
{
    double away = 2 * unit(r);
    make_random(r, p);
    for (int i = 0; i <= 3; i++) {
        p->g.x[i] += away;
        p->g.y[i] += away;
    }
}

static void make_shared_end(struct random_state *r, struct sample *p)
{
    make_random(r, p);
    int last_f = random_between(r, 0, 1) ? p->f.curve.degree : 0,
        last_g = random_between(r, 0, 1) ? p->g.curve.degree : 0;
    p->g.x[last_g] = p->f.x[last_f];
    p->g.y[last_g] = p->f.y[last_f];
}

/* Coarse coordinates, and f and g meet exactly where both may be cut, or close to it. */
static void make_on_cut(struct random_state *r, struct sample *p)
{
    int k = (int)random_between(r, 0, 3);
    make_random(r, p);
    curve_set(&p->f, 2);
    curve_set(&p->g, 2);
    for (int i = 0; i <= 2; i++) {
        p->f.x[i] = (double)random_between(r, -256, 256);
        p->f.y[i] = (double)random_between(r, -256, 256);
        p->g.x[i] = (double)random_between(r, -256, 256);
        p->g.y[i] = (double)random_between(r, -256, 256);
    }
    double dx = (p->f.x[0] + 2 * p->f.x[1] + p->f.x[2] - p->g.x[0] - 2 * p->g.x[1] - p->g.x[2]) / 4,
           dy = (p->f.y[0] + 2 * p->f.y[1] + p->f.y[2] - p->g.y[0] - 2 * p->g.y[1] - p->g.y[2]) / 4;
    double off = k == 0 ? 0 : ldexp(unit(r), -48 + 4 * k);
    for (int i = 0; i <= 2; i++) {
        p->g.x[i] += dx + off;
        p->g.y[i] += dy;
    }
}

/* y = a x^2 and y = b x^2 + gap over about [-1, 1], turned; the gap is none, or tiny of either sign. */
static void make_tangent(struct random_state *r, struct sample *p)
{
    double gap = random_between(r, 0, 2) ? ldexp(unit(r), -(int)random_between(r, 2, 45)) : 0;
    double a = unit(r), b = unit(r), turn = 3 * unit(r), c = cos(turn), s = sin(turn);
    make_random(r, p);
    for (int k = 0; k < 2; k++) {
        struct prop_curve *to = k ? &p->g : &p->f;
        double from = -1 + unit(r) / 4, end = 1 + unit(r) / 4, bend = k ? b : a, shift = k ? gap : 0;
        double x[3] = {from, (from + end) / 2, end},
               y[3] = {bend * from * from + shift, bend * from * end + shift, bend * end * end + shift};
        curve_set(to, 2);
        for (int i = 0; i < 3; i++) {
            to->x[i] = c * x[i] - s * y[i];
            to->y[i] = s * x[i] + c * y[i];
        }
    }
}

/* Points that coincide, or lie on a line. */
static void make_flat(struct random_state *r, struct sample *p)
{
    make_random(r, p);
    for (int i = 0; i <= 3; i++) {
        p->f.x[i] = (double)random_between(r, -1, 1);
        p->f.y[i] = (double)random_between(r, -1, 1);
        p->g.x[i] = (double)random_between(r, -2, 2);
        p->g.y[i] = random_between(r, 0, 3) ? 0.125 - p->g.x[i] / 4 : unit(r);
    }
}

/* ---- pairs of any degrees ---- */

/* One curve in ten has a degree up to DEGREE_MAX. */
static int some_degree(struct random_state *r)
{
    return (int)random_between(r, 1, random_between(r, 0, 9) ? 9 : DEGREE_MAX);
}

static void make_random_any(struct random_state *r, struct sample *p)
{
    int n = some_degree(r), m = random_between(r, 0, 2) ? some_degree(r) : n;
    curve_set(&p->f, n);
    curve_set(&p->g, m > 3 || n > 3 ? m : 4);
    for (int i = 0; i <= DEGREE_MAX; i++) {
        p->f.x[i] = unit(r);
        p->f.y[i] = unit(r);
        p->g.x[i] = unit(r);
        p->g.y[i] = unit(r);
    }
}

static void make_nice_any(struct random_state *r, struct sample *p)
{
    make_random_any(r, p);
    for (int i = 0; i <= p->f.curve.degree; i++) {
        p->f.x[i] = -1 + 2.0 * i / p->f.curve.degree + p->f.x[i] / 64;
        p->f.y[i] = p->f.y[i] / 4;
    }
    for (int i = 0; i <= p->g.curve.degree; i++) {
        p->g.y[i] = -1 + 2.0 * i / p->g.curve.degree + p->g.y[i] / 64;
        p->g.x[i] = p->g.x[i] / 4;
    }
}

/* Bernstein coefficients of T_n on [-1, 1]: (-1)^(n-i) C(2n, 2i) / C(n, i). */
static double wave_of(int n, int i)
{
    double c = 1;
    for (int k = 1; k <= i; k++) {
        c *= (double)(2 * n - 2 * k + 2) * (2 * n - 2 * k + 1) / ((2 * k) * (2 * k - 1.0));
        c *= (double)k / (n - k + 1);
    }
    return (n - i) % 2 ? -c : c;
}

/* y = T_n(x) and x = T_m(y), disturbed: about n m zeros. */
static void make_board(struct random_state *r, struct sample *p)
{
    make_random_any(r, p);
    int n = (int)random_between(r, 4, 8), m = (int)random_between(r, 3, 8);
    curve_set(&p->f, n);
    curve_set(&p->g, m);
    for (int i = 0; i <= n; i++) {
        p->f.x[i] = -1 + 2.0 * i / n + p->f.x[i] / 256;
        p->f.y[i] = wave_of(n, i) * (1 + p->f.y[i] / 64);
    }
    for (int i = 0; i <= m; i++) {
        p->g.y[i] = -1 + 2.0 * i / m + p->g.y[i] / 256;
        p->g.x[i] = wave_of(m, i) * (1 + p->g.x[i] / 64);
    }
}

static void make_shared_end_any(struct random_state *r, struct sample *p)
{
    make_random_any(r, p);
    int last_f = random_between(r, 0, 1) ? p->f.curve.degree : 0,
        last_g = random_between(r, 0, 1) ? p->g.curve.degree : 0;
    p->g.x[last_g] = p->f.x[last_f];
    p->g.y[last_g] = p->f.y[last_f];
}

/* The parabolas of make_tangent, raised: rounded, so there is a gap. */
static void make_tangent_any(struct random_state *r, struct sample *p)
{
    double gap = ldexp(unit(r), -(int)random_between(r, 2, 36));
    make_random_any(r, p);
    for (int k = 0; k < 2; k++) {
        struct prop_curve *to = k ? &p->g : &p->f;
        int n = (int)random_between(r, 4, 9);
        double from = -1 + unit(r) / 4, end = 1 + unit(r) / 4, bend = unit(r);
        curve_set(to, n);
        for (int i = 0; i <= n; i++) {
            double a = (double)(n - i) * (n - i - 1), b = 2.0 * i * (n - i), c = (double)i * (i - 1);
            double square = (a * from * from + b * from * end + c * end * end) / (n * (n - 1.0));
            to->x[i] = from + (end - from) * i / n;
            to->y[i] = bend * square + to->x[i] / 8 + (k ? gap : 0);
        }
    }
}

struct kind {
    const char *name;
    void (*make)(struct random_state *, struct sample *);
};
static const struct kind kinds[] = {
    {"random", make_random},   {"nice", make_nice},       {"nine", make_nine},
    {"crowd", make_crowd},     {"far", make_far},         {"shared end", make_shared_end},
    {"on a cut", make_on_cut}, {"tangent", make_tangent}, {"flat", make_flat},
};
static const struct kind kinds_any[] = {
    {"random, any degree", make_random_any},
    {"nice, any degree", make_nice_any},
    {"board", make_board},
    {"shared end, any degree", make_shared_end_any},
    {"tangent, any degree", make_tangent_any},
};
enum {
    KINDS = sizeof kinds / sizeof *kinds,
    KINDS_ANY = sizeof kinds_any / sizeof *kinds_any,
    PAIRS_ANY = 20000
};

static void scale(struct sample *p, int e)
{
    for (int i = 0; i <= DEGREE_MAX; i++) {
        p->f.x[i] = ldexp(p->f.x[i], e);
        p->f.y[i] = ldexp(p->f.y[i], e);
        p->g.x[i] = ldexp(p->g.x[i], e);
        p->g.y[i] = ldexp(p->g.y[i], e);
    }
}

/* ---- what is claimed ---- */

static bool touch(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

static struct problem question(const struct sample *p)
{
    return problem_of(&p->f.curve, &p->g.curve, 1e-12, 20000);
}

static bool is_single(const struct crossing *c)
{
    return c->standing == UNIQUE || c->standing == END;
}

/* Every solution that one knows lies in some record of the other; true: in one of its own kind. */
static bool includes(const struct crossings *a, const struct crossings *b, bool *all)
{
    bool same = true;
    for (int i = 0; i < b->count; i++) {
        bool found = false, alike = false;
        for (int k = 0; k < a->count; k++) {
            bool here = touch(&a->at[k].t, &b->at[i].t) && touch(&a->at[k].s, &b->at[i].s);
            found |= here;
            alike |= here && a->at[k].standing == b->at[i].standing && a->at[k].at_most == b->at[i].at_most;
        }
        *all &= found || !is_single(&b->at[i]);
        same &= alike;
    }
    return same;
}

static const char *difference(const struct crossings *a, const struct crossings *b)
{
    bool all = true;
    bool same = includes(a, b, &all) & includes(b, a, &all) && a->count == b->count;
    if (!all || a->overlaps != b->overlaps) {
        return "a solution lies in no record of the other";
    }
    return same ? NULL : "other records";
}

/* Value and derivative, de Casteljau. */
static void at(const struct curve *c, const double *x, __float128 t, __float128 *value, __float128 *slope)
{
    __float128 b[DEGREE_MAX + 1];
    for (int i = 0; i <= c->degree; i++) {
        b[i] = x[i];
    }
    for (int k = c->degree; k > 1; k--) {
        for (int i = 0; i < k; i++) {
            b[i] += t * (b[i + 1] - b[i]);
        }
    }
    *slope = c->degree * (b[1] - b[0]);
    *value = b[0] + t * (b[1] - b[0]);
}

/* Does Newton's method from the middle of the record stay there?  END may stand for a zero just outside. */
static bool holds_zero(const struct sample *p, const struct crossing *c)
{
    __float128 t = ((__float128)c->t.lo + c->t.hi) / 2, s = ((__float128)c->s.lo + c->s.hi) / 2;
    for (int k = 0; k < 8; k++) {
        __float128 fx, fy, gx, gy, ax, ay, bx, by;
        at(&p->f.curve, p->f.x, t, &fx, &ax);
        at(&p->f.curve, p->f.y, t, &fy, &ay);
        at(&p->g.curve, p->g.x, s, &gx, &bx);
        at(&p->g.curve, p->g.y, s, &gy, &by);
        __float128 x = fx - gx, y = fy - gy, det = ax * by - ay * bx;
        t -= (x * by - y * bx) / det;
        s -= (x * ay - y * ax) / det;
    }
    const __float128 pad = c->standing == END ? (__float128)1e-9 : (__float128)1e-28;
    return c->t.lo - pad <= t && t <= c->t.hi + pad && c->s.lo - pad <= s && s <= c->s.hi + pad;
}

static void fail_sample(const struct sample *p, const char *kind, int i, const char *why)
{
    fprintf(stderr, "{\"id\":\"%s %d\"", kind, i);
    for (int k = 0; k < 2; k++) {
        const struct prop_curve *c = k ? &p->g : &p->f;
        fprintf(stderr, ",\"%s\":{\"points\":[", k ? "g" : "f");
        for (int j = 0; j <= c->curve.degree; j++) {
            fprintf(stderr, "%s[\"%a\",\"%a\"]", j ? "," : "", c->x[j], c->y[j]);
        }
        fprintf(stderr, "]}");
    }
    fprintf(stderr, "}\n");
    fail_msg("%s %d: %s", kind, i, why);
}

static void judge_variant(struct solver *kernel, enum outcome alone, const struct sample *p, const char *kind,
                          int i)
{
    const struct crossings *c = &kernel->answer.crossings;
    struct problem problem = question(p);
    enum outcome o = solver_run(kernel, &problem);
    if (o != alone && alone == SOLVED) {
        fail_sample(p, kind, i, "another outcome");
    }
    /* what takes too long is cut off elsewhere: straight arcs that run back over each other */
    const char *why = o == SOLVED && alone == SOLVED ? difference(c, &engine.answer.crossings) : NULL;
    if (why) {
        fail_sample(p, kind, i, why);
    }
    for (int k = 0; k < c->count; k++) {
        if ((c->at[k].standing == UNIQUE || c->at[k].standing == END) && !holds_zero(p, &c->at[k])) {
            fail_sample(p, kind, i, "no zero in a record");
        }
    }
}

static void judge(const struct sample *p, const char *kind, int i)
{
    struct problem problem = question(p);
    enum outcome alone = solver_run(&engine, &problem);
    for (int v = 0; v < VARIANTS; v++) {
        judge_variant(&kernels[v], alone, p, kind, i);
    }
}

static bool is_same(const struct crossings *a, const struct crossings *b, bool exchanged)
{
    bool same = a->count == b->count && a->overlaps == b->overlaps;
    for (int i = 0; same && i < a->count; i++) {
        const struct crossing *x = &a->at[i];
        bool found = false;
        for (int k = 0; !found && k < b->count; k++) {
            const struct crossing *y = &b->at[k];
            const struct interval *t = exchanged ? &y->s : &y->t, *s = exchanged ? &y->t : &y->s;
            found = x->t.lo == t->lo && x->t.hi == t->hi && x->s.lo == s->lo && x->s.hi == s->hi &&
                    x->standing == y->standing && x->at_most == y->at_most;
        }
        same = found;
    }
    return same;
}

/* ---- the tests ---- */

static void test_same_records(void **state)
{
    (void)state;
    struct random_state r = {51};
    struct sample p;
    for (int i = 0; i < PAIRS; i++) {
        const struct kind *kind = &kinds[i % KINDS];
        kind->make(&r, &p);
        judge(&p, kind->name, i);
    }
}

static void test_same_records_any(void **state)
{
    (void)state;
    struct random_state r = {55};
    static struct sample p;
    for (int i = 0; i < PAIRS_ANY; i++) {
        const struct kind *kind = &kinds_any[i % KINDS_ANY];
        kind->make(&r, &p);
        judge(&p, kind->name, i);
    }
}

/* Also where the kernel only takes the scaled copies. */
static void test_same_bits(void **state)
{
    (void)state;
    struct random_state r = {52};
    static struct sample p;
    for (int i = 0; i < PAIRS + PAIRS_ANY; i++) {
        const struct kind *kind = i < PAIRS ? &kinds[i % KINDS] : &kinds_any[i % KINDS_ANY];
        kind->make(&r, &p);
        struct problem problem = question(&p), exchanged = problem;
        exchanged.f = problem.g;
        exchanged.g = problem.f;
        for (int v = 0; v < VARIANTS; v++) {
            solver_run(&kernels[v], &problem);
            solver_run(&again[v], &exchanged);
            if (!is_same(&kernels[v].answer.crossings, &again[v].answer.crossings, true)) {
                fail_sample(&p, kind->name, i, "other bits when exchanged");
            }
        }
        scale(&p, (int)random_between(&r, -300, 300));
        for (int v = 0; v < VARIANTS; v++) {
            solver_run(&again[v], &problem);
            if (!is_same(&kernels[v].answer.crossings, &again[v].answer.crossings, false)) {
                fail_sample(&p, kind->name, i, "other bits when scaled");
            }
        }
    }
}

/* On this processor there is a kernel for these degrees: pairs take as many steps as it counts, not as the
 * engine does; or there is one more than for AVX2: some intervals are others. */
static void test_is_used(void **state)
{
    (void)state;
    struct random_state r = {53};
    struct sample p;
    int differ = 0, wider = 0;
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
        skip();
    }
    for (int i = 0; i < 200; i++) {
        make_nine(&r, &p);
        struct problem problem = question(&p);
        solver_run(&kernels[0], &problem);
        solver_run(&kernels[1], &problem);
        solver_run(&engine, &problem);
        differ += kernels[1].workspace.steps != engine.workspace.steps;
        wider += !is_same(&kernels[0].answer.crossings, &kernels[1].answer.crossings, false);
    }
    assert_true(differ > 0);
    bool has_wider = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                     __builtin_cpu_supports("avx512vl");
    assert_true(has_wider == (wider > 0));
}

/* However few steps are allowed, every zero is in some record. */
static void test_few_steps(void **state)
{
    (void)state;
    struct random_state r = {54};
    struct sample p;
    for (int i = 0; i < 400; i++) {
        make_nine(&r, &p);
        struct problem problem = question(&p);
        solver_run(&engine, &problem);
        problem.max_steps = 1 + i / VARIANTS % 40;
        solver_run(&kernels[i % VARIANTS], &problem);
        const struct crossings *all = &engine.answer.crossings,
                               *some = &kernels[i % VARIANTS].answer.crossings;
        for (int k = 0; k < all->count; k++) {
            bool found = false;
            for (int j = 0; j < some->count; j++) {
                found |= touch(&all->at[k].t, &some->at[j].t) && touch(&all->at[k].s, &some->at[j].s);
            }
            if (!found) {
                fail_sample(&p, "nine", i, "a zero in no record");
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_records), cmocka_unit_test(test_same_records_any),
        cmocka_unit_test(test_same_bits), cmocka_unit_test(test_is_used), cmocka_unit_test(test_few_steps)};
    solver_init(&engine, intersector_find("certified_scalar"), DEGREE_MAX, DEGREE_MAX, WORKSPACE_ROOM);
    for (int v = 0; v < VARIANTS; v++) {
        solver_init(&kernels[v], intersector_find(variant[v]), DEGREE_MAX, DEGREE_MAX, WORKSPACE_ROOM);
        solver_init(&again[v], intersector_find(variant[v]), DEGREE_MAX, DEGREE_MAX, WORKSPACE_ROOM);
    }
    int failed = cmocka_run_group_tests_name("kernels", tests, NULL, NULL);
    solver_clear(&engine);
    for (int v = 0; v < VARIANTS; v++) {
        solver_clear(&kernels[v]);
        solver_clear(&again[v]);
    }
    return failed;
}
