/* The watched build of the algorithms: the same answers in the same steps as the other, which the program
 * `answers` beside this one prints; its events account for every step and every
 * record; its cells carry the control points that they should. */
#include "answers.h"

static struct solver solver;
static char folder[4096];

struct log {
    int events[ACCEPTED + 1];
    bool outside;
};

static void watch(void *log, enum event e, const struct cell *c)
{
    struct log *l = (struct log *)log;
    l->events[e]++;
    l->outside = l->outside || !(0 <= c->t.lo && c->t.lo <= c->t.hi && c->t.hi <= 1) ||
                 !(0 <= c->s.lo && c->s.lo <= c->s.hi && c->s.hi <= 1);
}

/* ---- control points ---- */

enum { EVERY = REAL_BITS > 113 ? 200 : 20 };

/* Looks at one cell in EVERY. */
struct look {
    struct curve f, g; /* as prepared */
    real bound_f, bound_g;
    int cells;
    const char *mistake;
};

/* The curve of c's degree that problem_solve left at `memory`; its coordinates are at most 2. */
static const real *prepared_curve(const struct curve *c, const real *memory, struct curve *out, real *bound)
{
    int length = c->degree + 1;
    *out = *c;
    out->x = memory;
    out->y = memory + length;
    out->w = c->w ? memory + 2 * length : NULL;
    real most = 0;
    for (int i = 0; i < length; i++) {
        real w = c->w ? out->w[i] : (real)1;
        most = real_max(most, real_max(real_abs(out->x[i]), real_abs(out->y[i])) / w);
    }
    *bound = (12 * c->degree + 1) * (REAL_EPSILON / 2) * most * (c->w ? 2 : 1);
    return memory + (c->w ? 3 : 2) * length;
}

/* Is every Euclidean coordinate of the points within `bound` of the exact one over t? */
static bool are_points_of(const struct curve *c, const struct interval *t, const real *points, real bound)
{
    int length = c->degree + 1;
    mpq_t w[DEGREE_MAX + 1], x[DEGREE_MAX + 1], limit, weight;
    struct dyadics d;
    bool good = true;
    dyadics_init(&d);
    rationals_init(length, w);
    rationals_init(length, x);
    mpq_inits(limit, weight, NULL);
    real_to_rational(bound, limit);
    for (int i = 0; i < length; i++)
        mpq_set_ui(w[i], 1, 1);
    if (c->w) {
        dyadics_set(&d, c->degree, c->w);
        exact_restrict(&d, t->lo, t->hi, w);
    }
    for (int k = 0; k < 2; k++, points += length) {
        dyadics_set(&d, c->degree, k ? c->y : c->x);
        exact_restrict(&d, t->lo, t->hi, x);
        for (int i = 0; i < length; i++) {
            mpq_t own;
            mpq_init(own);
            real_to_rational(points[i], own);
            real_to_rational(c->w ? points[(2 - k) * length + i] : (real)1, weight);
            mpq_div(own, own, weight);
            mpq_div(x[i], x[i], w[i]);
            mpq_sub(x[i], x[i], own);
            good = good && is_within(0, x[i], limit);
            mpq_clear(own);
        }
    }
    rationals_clear(length, w);
    rationals_clear(length, x);
    mpq_clears(limit, weight, NULL);
    dyadics_clear(&d);
    return good;
}

static void look(void *log, enum event e, const struct cell *c)
{
    struct look *l = (struct look *)log;
    (void)e;
    if (l->cells == 0) { /* the cells are laid out, so the prepared curves are too */
        const struct curve f = l->f, g = l->g;
        prepared_curve(&g, prepared_curve(&f, solver.workspace.prepared, &l->f, &l->bound_f), &l->g,
                       &l->bound_g);
    }
    if (l->cells++ % EVERY || l->mistake)
        return;
    if (!are_points_of(&l->f, &c->t, c->f, l->bound_f))
        l->mistake = "of f";
    else if (!are_points_of(&l->g, &c->s, c->g, l->bound_g))
        l->mistake = "of g";
}

/* Curves come in the order of their degrees, polynomial before rational. */
static bool comes_first(const struct curve *a, const struct curve *b)
{
    return a->degree != b->degree ? a->degree < b->degree : !a->w || b->w;
}

/* Control points that a cell carries are those of its curve, to within the bounds of problem.c:
 * (12 n + 1) u scale, twice that for rational curves. */
static void test_control_points(void **state)
{
    (void)state;
    int looked = 0;
    for (int k = 0; intersectors[k]; k++)
        for (int i = 0; i < ANSWERS_PAIRS / 2; i++) {
            struct planted p;
            real tolerance;
            char text[ANSWER_TEXT];
            answers_pair(&p, i, &tolerance);
            bool as_given = comes_first(&p.f.curve, &p.g.curve);
            struct look l = {
                as_given ? p.f.curve : p.g.curve, as_given ? p.g.curve : p.f.curve, 0, 0, 0, NULL};
            answers_solve(&solver, intersectors[k], i, look, &l, text);
            solver_clear(&solver);
            looked += l.cells;
            if (l.mistake)
                fail_msg("%s: cell %d: control points %s are off", text, l.cells, l.mistake);
        }
    assert_true(looked > 0);
}

/* ---- the same answers ---- */

static void test_same_answers(void **state)
{
    (void)state;
    char command[4200], text[ANSWER_TEXT], line[ANSWER_TEXT];
    snprintf(command, sizeof command, "%s/answers", folder);
    FILE *plain = popen(command, "r");
    assert_non_null(plain);
    for (int k = 0; intersectors[k]; k++)
        for (int i = 0; i < ANSWERS_PAIRS; i++) {
            struct log log = {{0, 0, 0, 0}, false};
            answers_solve(&solver, intersectors[k], i, watch, &log, text);
            solver_clear(&solver);
            assert_non_null(fgets(line, sizeof line, plain));
            line[strcspn(line, "\n")] = '\0';
            assert_string_equal(text, line);
        }
    assert_null(fgets(line, sizeof line, plain));
    assert_int_equal(pclose(plain), 0);
}

/* Of the cell algorithms, which are those that report events.  A step ends as one of discarded, accepted,
 * split, or at least one shrunk cell; cells left over when steps run out are accepted. */
static void test_events(void **state)
{
    (void)state;
    int watched = 0;
    for (int k = 0; intersectors[k]; k++)
        for (int i = 0; i < ANSWERS_PAIRS; i++) {
            struct log log = {{0, 0, 0, 0}, false};
            char text[ANSWER_TEXT];
            answers_solve(&solver, intersectors[k], i, watch, &log, text);
            const struct crossings *c = &solver.answer.crossings;
            int steps = solver.workspace.steps, left = 0;
            int ended = log.events[DISCARDED] + log.events[ACCEPTED] + log.events[SPLIT];
            assert_false(log.outside);
            if (ended + log.events[SHRUNK] > 0) {
                watched++;
                left = strstr(text, "OUT_OF_STEPS") ? WORKSPACE_ROOM : 0;
                if (!(ended - left <= steps && steps <= ended + log.events[SHRUNK]))
                    fail_msg("%s: %d split, %d shrunk, %d discarded, %d accepted", text, log.events[SPLIT],
                             log.events[SHRUNK], log.events[DISCARDED], log.events[ACCEPTED]);
                if (!(c->merged ? log.events[ACCEPTED] > c->count : log.events[ACCEPTED] == c->count))
                    fail_msg("%s: %d accepted", text, log.events[ACCEPTED]);
            }
            solver_clear(&solver);
        }
    assert_true(watched > 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_answers),
        cmocka_unit_test(test_events),
        cmocka_unit_test(test_control_points),
    };
    const char *slash = strrchr(argv[0], '/');
    (void)argc;
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - argv[0]) : 1, slash ? argv[0] : ".");
    return cmocka_run_group_tests_name("watched", tests, NULL, NULL);
}
