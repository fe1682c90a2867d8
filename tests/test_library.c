/* The library says what the algorithm behind it says, whatever its workspace was used for before; what is no
 * problem is called so, with the reason; a safe radius is safe. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <threads.h>

#include "prop.h"

#include "../algorithms/fatline.h"
#include "../algorithms/region.h"

enum { PAIRS = 2000, LENGTH = DEGREE_MAX + 1 };

struct drawn {
    double points[2 * LENGTH], weights[LENGTH];
    struct fatline_curve curve;
};

static void draw(struct drawn *c, struct random_state *r, int degree, bool rational)
{
    for (int i = 0; i <= degree; i++) {
        c->points[2 * i] = prop_dyadic(r, 20);
        c->points[2 * i + 1] = prop_dyadic(r, 20);
        c->weights[i] = 1 + 3 * prop_unit(r, 10);
    }
    c->curve.degree = degree;
    c->curve.points = c->points;
    c->curve.weights = rational ? c->weights : NULL;
}

static struct fatline_workspace *workspace_of(int degree, void **memory)
{
    size_t size = fatline_workspace_size(degree);
    *memory = malloc(size);
    struct fatline_workspace *w = fatline_workspace_init(*memory, size, degree);
    assert_non_null(w);
    return w;
}

/* ---- the same as problem_solve ---- */

static struct crossings found;

static enum outcome solve_directly(const struct drawn *f, const struct drawn *g)
{
    real x[2][LENGTH], y[2][LENGTH];
    struct problem p;
    memset(&p, 0, sizeof p);
    struct curve *to[2] = {&p.f, &p.g};
    const struct drawn *from[2] = {f, g};
    for (int k = 0; k < 2; k++) {
        const struct fatline_curve *c = &from[k]->curve;
        for (int i = 0; i <= c->degree; i++) {
            double w = c->weights ? c->weights[i] : 1;
            x[k][i] = w * c->points[2 * i];
            y[k][i] = w * c->points[2 * i + 1];
        }
        struct curve curve = {c->degree, x[k], y[k], c->weights, {0, 1}};
        *to[k] = curve;
    }
    p.tolerance = 1e-12;
    p.max_steps = STEPS_MAX;
    const struct intersector *a = intersector_find("certified");
    int n = f->curve.degree, m = g->curve.degree;
    size_t scratch = a->scratch(n, m);
    void *memory = malloc(workspace_size(n, m, 1, scratch));
    struct workspace w;
    workspace_init(&w, memory, n, m, 1, scratch);
    enum outcome o = problem_solve(&p, a, &w, &found);
    free(memory);
    return o;
}

static void require_same(const struct fatline_answer *a)
{
    assert_int_equal(a->count, found.count);
    assert_int_equal(a->overlaps, found.overlaps);
    for (int i = 0; i < a->count; i++) {
        const struct fatline_crossing *c = &a->crossing[i];
        const struct crossing *d = &found.at[i];
        assert_true(c->t_lo == d->t.lo && c->t_hi == d->t.hi && c->s_lo == d->s.lo && c->s_hi == d->s.hi);
        assert_string_equal(fatline_standing_text(c->standing), d->standing == UNIQUE    ? "unique"
                                                                : d->standing == END     ? "end"
                                                                : d->standing == CLUSTER ? "cluster"
                                                                                         : "candidate");
        assert_true(c->standing == FATLINE_CANDIDATE ? c->at_most == 0 : c->at_most > 0);
    }
    for (int i = 0; i < a->overlaps; i++) {
        const struct fatline_overlap *c = &a->overlap[i];
        const struct overlap *d = &found.overlap[i];
        assert_true(c->t_outer_lo == d->t_outer.lo && c->s_inner_hi == d->s_inner.hi);
        assert_true(c->distance == d->distance && c->reversed == d->reversed);
    }
}

/* Every degree in one workspace, now and then the same curve, or the same the other way round. */
static void same_as_the_algorithm(void **state)
{
    (void)state;
    struct random_state r = random_for(61, "library", 0);
    void *memory;
    struct fatline_workspace *w = workspace_of(FATLINE_DEGREE_MAX, &memory);
    int crossings = 0, overlaps = 0;
    for (int k = 0; k < PAIRS; k++) {
        struct drawn f, g;
        int n = (int)random_between(&r, 1, k % 8 ? 4 : 32), m = (int)random_between(&r, 1, k % 8 ? 4 : 32);
        draw(&f, &r, n, k % 4 == 1);
        draw(&g, &r, k % 50 ? m : n, k % 4 == 1 || k % 4 == 2);
        for (int i = 0; k % 50 == 0 && i <= n; i++) {
            g.points[2 * i] = f.points[2 * (n - i)];
            g.points[2 * i + 1] = f.points[2 * (n - i) + 1];
        }
        struct fatline_answer a;
        enum fatline_outcome o = fatline_intersect(w, &f.curve, &g.curve, NULL, &a);
        assert_int_equal(o, a.outcome);
        assert_int_equal(o == FATLINE_SOLVED, solve_directly(&f, &g) == SOLVED);
        assert_null(a.error);
        require_same(&a);
        crossings += a.count;
        overlaps += a.overlaps;
    }
    free(memory);
    assert_true(crossings > PAIRS / 2 && overlaps >= PAIRS / 200);
}

/* ---- threads ---- */

struct thread {
    uint64_t seed;
    double sum; /* of all ends of all records: the same bits whoever else is at work */
};

static int work(void *argument)
{
    struct thread *own = (struct thread *)argument;
    struct random_state r = random_for(own->seed, "library", 1);
    size_t size = fatline_workspace_size(5);
    void *memory = malloc(size);
    struct fatline_workspace *w = fatline_workspace_init(memory, size, 5);
    own->sum = 0;
    for (int k = 0; k < PAIRS; k++) {
        struct drawn f, g;
        struct fatline_answer a;
        draw(&f, &r, (int)random_between(&r, 1, 5), k % 3 == 0);
        draw(&g, &r, (int)random_between(&r, 1, 5), k % 4 == 0);
        fatline_intersect(w, &f.curve, &g.curve, NULL, &a);
        for (int i = 0; i < a.count; i++)
            own->sum += a.crossing[i].t_lo + 2 * a.crossing[i].s_hi;
    }
    free(memory);
    return 0;
}

static void threads_do_not_meet(void **state)
{
    (void)state;
    enum { THREADS = 4 };
    struct thread alone[THREADS], together[THREADS];
    thrd_t id[THREADS];
    for (int k = 0; k < THREADS; k++) {
        alone[k].seed = together[k].seed = (uint64_t)k;
        work(&alone[k]);
    }
    for (int k = 0; k < THREADS; k++)
        assert_int_equal(thrd_create(&id[k], work, &together[k]), thrd_success);
    for (int k = 0; k < THREADS; k++) {
        thrd_join(id[k], NULL);
        assert_true(together[k].sum == alone[k].sum && alone[k].sum != 0);
        assert_true(k == 0 || alone[k].sum != alone[0].sum);
    }
}

/* Weights times any power of two, or coordinates of a rational pair, change no parameter. */
static void scaling_changes_nothing(void **state)
{
    (void)state;
    struct random_state r = random_for(62, "library", 0);
    void *memory;
    struct fatline_workspace *w = workspace_of(4, &memory);
    static struct fatline_crossing before[FATLINE_CROSSINGS_MAX];
    for (int k = 0; k < PAIRS; k++) {
        struct drawn f, g;
        struct fatline_answer a;
        draw(&f, &r, (int)random_between(&r, 1, 4), true);
        draw(&g, &r, (int)random_between(&r, 1, 4), k % 2);
        fatline_intersect(w, &f.curve, &g.curve, NULL, &a);
        int count = a.count, weigh = (int)random_between(&r, -900, 900),
            size = (int)random_between(&r, -900, 900);
        memcpy(before, a.crossing, (size_t)count * sizeof *before);
        for (int i = 0; i < 2 * LENGTH; i++) {
            f.points[i] = i < 2 * (f.curve.degree + 1) ? ldexp(f.points[i], size) : 0;
            g.points[i] = i < 2 * (g.curve.degree + 1) ? ldexp(g.points[i], size) : 0;
        }
        for (int i = 0; i <= f.curve.degree; i++)
            f.weights[i] = ldexp(f.weights[i], weigh);
        fatline_intersect(w, &f.curve, &g.curve, NULL, &a);
        assert_int_equal(a.count, count);
        for (int i = 0; i < count; i++)
            assert_true(before[i].t_lo == a.crossing[i].t_lo && before[i].s_hi == a.crossing[i].s_hi &&
                        before[i].standing == a.crossing[i].standing);
        double p[2], q[2], t = prop_unit(&r, 20);
        fatline_point(&f.curve, t, p);
        for (int i = 0; i <= f.curve.degree; i++)
            f.weights[i] = ldexp(f.weights[i], -weigh);
        fatline_point(&f.curve, t, q);
        assert_true(p[0] == q[0] && p[1] == q[1]);
    }
    free(memory);
}

/* ---- what is no problem ---- */

static void expect_error(struct fatline_workspace *w, const struct fatline_curve *f,
                         const struct fatline_curve *g, const struct fatline_options *o, const char *error)
{
    struct fatline_answer a;
    assert_int_equal(fatline_intersect(w, f, g, o, &a), FATLINE_INVALID);
    assert_int_equal(a.outcome, FATLINE_INVALID);
    assert_true(a.count == 0 && a.overlaps == 0);
    assert_non_null(a.error);
    if (!strstr(a.error, error))
        fail_msg("\"%s\" does not say \"%s\"", a.error, error);
}

static void mistakes_are_told(void **state)
{
    (void)state;
    struct random_state r = random_for(63, "library", 0);
    void *memory;
    struct fatline_workspace *w = workspace_of(5, &memory);
    struct drawn f, g;
    draw(&f, &r, 3, true);
    draw(&g, &r, 3, false);
    struct fatline_curve c = g.curve;
    expect_error(w, &f.curve, NULL, NULL, "g or its points are missing");
    c.points = NULL;
    expect_error(w, &c, &g.curve, NULL, "f or its points are missing");
    c = g.curve;
    c.degree = 0;
    expect_error(w, &f.curve, &c, NULL, "degree of g is not 1 to 32");
    c.degree = 6;
    expect_error(w, &f.curve, &c, NULL, "degree of g is higher than the workspace");
    static const double bad[] = {INFINITY, -INFINITY, NAN};
    for (int k = 0; k < 3; k++) {
        double kept = g.points[5];
        g.points[5] = bad[k];
        expect_error(w, &f.curve, &g.curve, NULL, "coordinate of g is not finite");
        expect_error(w, &g.curve, &f.curve, NULL, "coordinate of f is not finite");
        g.points[5] = kept;
        struct fatline_options o = {bad[k], 0};
        expect_error(w, &f.curve, &g.curve, &o, "tolerance");
    }
    double kept = f.weights[2];
    f.weights[2] = 0;
    expect_error(w, &f.curve, &g.curve, NULL, "weight of f is not positive");
    f.weights[2] = ldexp(1, -300);
    expect_error(w, &f.curve, &g.curve, NULL, "weights of f differ");
    f.weights[2] = kept;
    struct fatline_options o = {-1, 0}, steps = {0, -1}, few = {0, 1};
    expect_error(w, &f.curve, &g.curve, &o, "tolerance");
    expect_error(w, &f.curve, &g.curve, &steps, "max_steps");
    struct fatline_answer a;
    assert_true(fatline_intersect(w, &f.curve, &f.curve, &few, &a) == FATLINE_OUT_OF_STEPS && a.steps == 1);
    const double along[] = {1e-16, 0, 0, 0}, back[] = {0, 0, 1e-16, 0}, point[] = {0, 0, 0, 0, 0, 0};
    const struct fatline_curve line = {1, along, NULL}, other = {1, back, NULL}, still = {2, point, NULL};
    for (few.max_steps = 1; few.max_steps < 10; few.max_steps++) {
        fatline_intersect(w, &line, &other, &few, &a);
        assert_true(a.steps <= few.max_steps);
        fatline_intersect(w, &still, &line, &few, &a);
        assert_true(a.steps <= few.max_steps);
    }
    free(memory);
}

static void memory_is_checked(void **state)
{
    (void)state;
    size_t size = fatline_workspace_size(3), larger = fatline_region_workspace_size(3, 4);
    char *memory = malloc(larger);
    assert_true(size > 0 && size < 500000 && fatline_workspace_size(32) < 2000000);
    assert_true(fatline_region_workspace_size(3, 100) < 2000000 &&
                fatline_region_workspace_size(32, 33) < 4000000);
    assert_true(fatline_workspace_size(0) == 0 && fatline_workspace_size(33) == 0);
    assert_true(fatline_region_workspace_size(1, 4) == 0 && fatline_region_workspace_size(3, 3) == 0);
    assert_null(fatline_workspace_init(NULL, size, 3));
    assert_null(fatline_workspace_init(memory, size - 1, 3));
    assert_null(fatline_workspace_init(memory + 1, size, 3));
    assert_null(fatline_workspace_init(memory, size, 0));
    assert_null(fatline_region_workspace_init(memory, larger - 1, 3, 4));
    assert_non_null(fatline_region_workspace_init(memory, larger, 3, 4));
    free(memory);
    assert_string_equal(fatline_version(), FATLINE_VERSION);
    assert_string_equal(fatline_outcome_text(FATLINE_OUT_OF_ROOM), "out of room");
    assert_string_equal(fatline_outcome_text((enum fatline_outcome)99), "no outcome");
}

/* ---- regions ---- */

/* The parabola with its middle point free: a half-plane. */
static void region_of_a_parabola(void **state)
{
    (void)state;
    double points[] = {0, 0, 1, 2, 2, 0}, nearest[2];
    struct fatline_region_problem p = {.curve = {2, 3, NULL, points, NULL}, .free = 1, .sign = -1};
    size_t size = fatline_region_workspace_size(3, 8);
    void *memory = malloc(size);
    struct fatline_region_workspace *w = fatline_region_workspace_init(memory, size, 3, 8);
    struct fatline_region r;
    assert_int_equal(fatline_region_contains(w, 1, 2, 0), FATLINE_OUTSIDE);
    assert_int_equal(fatline_region_solve(w, &p, &r), FATLINE_SOLVED);
    assert_string_equal(fatline_kind_text(r.kind), "unbounded");
    assert_true(r.certified && r.count >= 1);
    points[3] = 77; /* the region is that of the call */
    assert_int_equal(fatline_region_contains(w, 1, 2, 1.99), FATLINE_INSIDE);
    assert_int_equal(fatline_region_contains(w, 1, 2, 2.01), FATLINE_OUTSIDE);
    double safe = fatline_region_safe_radius(w, 1, 2);
    assert_true(safe <= 2 && safe > 2 - 1e-9);
    assert_true(fatline_region_safe_radius(w, 1, -1) == 0);
    fatline_region_nearest(w, 1, -1, nearest);
    assert_true(fabs(nearest[0] - 1) < 1e-12 && fabs(nearest[1]) < 1e-12);
    p.sign = 0;
    assert_int_equal(fatline_region_solve(w, &p, &r), FATLINE_INVALID);
    assert_non_null(strstr(r.error, "sign"));
    assert_int_equal(fatline_region_contains(w, 1, 2, 0), FATLINE_OUTSIDE);
    free(memory);
}

/* curvature at t of the curve with its free point moved, times the sign */
static double turning(const double *points, int degree, double t)
{
    double first[2] = {0}, second[2] = {0}, b[LENGTH];
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i <= degree; i++)
            b[i] = points[2 * i + k];
        for (int j = degree; j > 2; j--)
            for (int i = 0; i < j; i++)
                b[i] = (1 - t) * b[i] + t * b[i + 1];
        second[k] = b[2] - 2 * b[1] + b[0];
        first[k] = (1 - t) * (b[1] - b[0]) + t * (b[2] - b[1]);
    }
    return first[0] * second[1] - first[1] * second[0];
}

/* Random curves of one turn: wherever `contains` says inside, the curve has the sign asked for at every
 * sampled parameter, and all the disc of the safe radius is so; where it says outside, the nearest point is
 * not. */
static void safe_radius_is_safe(void **state)
{
    (void)state;
    struct random_state r = random_for(64, "library", 0);
    size_t size = fatline_region_workspace_size(6, 7);
    void *memory = malloc(size);
    struct fatline_region_workspace *w = fatline_region_workspace_init(memory, size, 6, 7);
    int safe = 0, outside = 0;
    for (int k = 0; k < 200; k++) {
        int degree = (int)random_between(&r, 2, 6);
        double points[2 * LENGTH];
        for (int i = 0; i <= degree; i++) {
            points[2 * i] = (double)i / degree + prop_dyadic(&r, 20) / 8;
            points[2 * i + 1] = points[2 * i] * points[2 * i] + prop_dyadic(&r, 20) / 16;
        }
        int free_point = (int)random_between(&r, 0, degree);
        struct fatline_region_problem p = {
            .curve = {degree, degree + 1, NULL, points, NULL}, .free = free_point, .sign = 1};
        struct fatline_region out;
        assert_int_equal(fatline_region_solve(w, &p, &out), FATLINE_SOLVED);
        for (int i = 0; i < 20; i++) {
            double x = points[2 * free_point] + prop_dyadic(&r, 20) / 4;
            double y = points[2 * free_point + 1] + prop_dyadic(&r, 20) / 4;
            double radius = fatline_region_safe_radius(w, x, y), moved[2 * LENGTH], nearest[2];
            fatline_region_nearest(w, x, y, nearest);
            if (radius > 0) {
                assert_true(nearest[0] == x && nearest[1] == y);
                double angle = 6.3 * prop_unit(&r, 20), by = radius < 1e3 ? radius * (1 - 1e-9) : 1e3;
                memcpy(moved, points, sizeof moved);
                moved[2 * free_point] = x + by * cos(angle);
                moved[2 * free_point + 1] = y + by * sin(angle);
                for (int j = 0; j <= 64; j++)
                    assert_true(turning(moved, degree, j / 64.0) > -1e-12);
                safe++;
            } else if (fatline_region_contains(w, x, y, 0) == FATLINE_OUTSIDE && out.count > 0) {
                double far = hypot(nearest[0] - x, nearest[1] - y);
                assert_true(far > 0);
                outside++;
            }
        }
    }
    free(memory);
    assert_true(safe > 200 && outside > 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_as_the_algorithm),   cmocka_unit_test(threads_do_not_meet),
        cmocka_unit_test(scaling_changes_nothing), cmocka_unit_test(mistakes_are_told),
        cmocka_unit_test(memory_is_checked),       cmocka_unit_test(region_of_a_parabola),
        cmocka_unit_test(safe_radius_is_safe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
