/* The referee: its verdicts against pairs whose solutions are known. */
#include "sketch.h"

static void assert_is_solution(const struct sketch *f, const struct sketch *g, const struct case_solution *a)
{
    mpq_t x[2], y[2];
    mpq_inits(x[0], x[1], y[0], y[1], NULL);
    point(f, a->t, x[0], y[0]);
    point(g, a->s, x[1], y[1]);
    assert_true(distance(x[0], x[1]) < 1e-36 && distance(y[0], y[1]) < 1e-36);
    assert_true(!a->exact || (mpq_equal(x[0], x[1]) && mpq_equal(y[0], y[1])));
    mpq_clears(x[0], x[1], y[0], y[1], NULL);
}

static void test_planted_solutions_are_found(void **state)
{
    (void)state;
    int decided = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        struct random_state r = random_for(3, "planted", (uint64_t)trial);
        struct sketch f, g;
        struct test_case c;
        int here = 0;
        mpq_t t, s;
        mpq_inits(t, s, NULL);
        sketch_random(&f, &r, (int)random_between(&r, 1, 9), trial % 3 == 0);
        sketch_random(&g, &r, (int)random_between(&r, 1, 9), trial % 3 == 0);
        random_place(&r, t);
        random_place(&r, s);
        plant(&f, &g, t, s);
        case_make(&c, &f, &g);
        if (!referee_solve(&c)) {
            decided++;
            for (int i = 0; i < c.expected.count; i++) {
                const struct case_solution *a = &c.expected.at[i];
                here += a->exact && mpq_equal(a->t, t) && mpq_equal(a->s, s);
                assert_is_solution(&f, &g, a);
                assert_true(a->cond > 0 && fabs(a->sine) <= 1);
            }
            assert_int_equal(here, 1);
        }
        case_clear(&c);
        sketch_clear(&f);
        sketch_clear(&g);
        mpq_clears(t, s, NULL);
    }
    assert_true(decided >= TRIALS - TRIALS / 50);
}

/* y = (T_n(2 x - 1) + 1) / 2 against its mirror image x = (T_n(2 y - 1) + 1) / 2: n^2 crossings, as many as
 * there can be.  T_n(T_n(u)) = u is cos(n^2 a) = cos(a): a = 2 pi k / (n^2 - 1) or 2 pi k / (n^2 + 1) in [0,
 * pi]. */
static void chebyshev(struct sketch *k, int n, bool mirrored)
{
    mpz_t above, below;
    mpz_inits(above, below, NULL);
    sketch_init(k, n, false);
    for (int i = 0; i <= n; i++) {
        mpq_ptr graph = mirrored ? k->x[i] : k->y[i];
        mpq_set_si(mirrored ? k->y[i] : k->x[i], i, (unsigned long)n);
        mpq_canonicalize(mirrored ? k->y[i] : k->x[i]);
        mpz_bin_uiui(above, 2 * (unsigned long)n, 2 * (unsigned long)i);
        mpz_bin_uiui(below, (unsigned long)n, (unsigned long)i);
        if ((n - i) % 2)
            mpz_neg(above, above);
        mpz_add(mpq_numref(graph), above, below);
        mpz_mul_ui(mpq_denref(graph), below, 2);
        mpq_canonicalize(graph);
    }
    mpz_clears(above, below, NULL);
}

static int compare_doubles(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

static void test_as_many_crossings_as_there_can_be(void **state)
{
    (void)state;
    for (int n = 2; n <= 9; n++) {
        struct sketch f, g;
        struct test_case c;
        double root[100];
        int count = 0;
        for (int side = -1; side <= 1; side += 2)
            for (int k = side < 0 ? 0 : 1; side < 0 ? 2 * k <= n * n + side : 2 * k < n * n + side; k++)
                root[count++] = (cos(2 * M_PI * k / (n * n + side)) + 1) / 2;
        qsort(root, (size_t)count, sizeof *root, compare_doubles);
        chebyshev(&f, n, false);
        chebyshev(&g, n, true);
        case_make(&c, &f, &g);
        const char *why = referee_solve(&c);
        if (why)
            fail_msg("degree %d: %s", n, why);
        assert_int_equal(count, n * n);
        assert_int_equal(c.expected.count, n * n);
        assert_string_equal(c.class_name, "endpoint");
        for (int i = 0; i < count; i++) {
            assert_true(fabs(mpq_get_d(c.expected.at[i].t) - root[i]) < 1e-14);
            assert_is_solution(&f, &g, &c.expected.at[i]);
        }
        case_clear(&c);
        sketch_clear(&f);
        sketch_clear(&g);
    }
}

/* The parabola y = 4 x (1 - x) and the line y = 1 + e through its top: two crossings, a contact, nothing. */
static const char *parabola_and_line(const char *height, struct test_case *c)
{
    char line[1024], error[512];
    sprintf(line,
            "{\"id\":\"top\",\"f\":{\"points\":[[0,0],[\"1/2\",2],[1,0]]},"
            "\"g\":{\"points\":[[0,\"%s\"],[1,\"%s\"]]}}",
            height, height);
    if (case_parse(line, "made", 1, c, error) != CASE_READ)
        fail_msg("%s", error);
    return referee_solve(c);
}

static void test_contacts_get_no_verdict(void **state)
{
    (void)state;
    struct test_case c;
    assert_non_null(parabola_and_line("1", &c));
    assert_false(c.expected.known);
    case_clear(&c);
    for (int k = 4; k <= 60; k += 4) {
        char height[64];
        mpq_t h;
        mpq_init(h);
        mpq_set_ui(h, 1, 1);
        mpq_div_2exp(h, h, (mp_bitcnt_t)k);
        for (int above = 0; above < 2; above++) {
            mpq_t one;
            mpq_init(one);
            mpq_set_ui(one, 1, 1);
            (above ? mpq_add : mpq_sub)(one, one, h);
            gmp_sprintf(height, "%Qd", one);
            mpq_clear(one);
            assert_null(parabola_and_line(height, &c));
            assert_int_equal(c.expected.count, above ? 0 : 2);
            if (!above) /* at 1/2 -+ sqrt(2^-k) / 2 */
                assert_true(fabs(mpq_get_d(c.expected.at[0].t) - (0.5 - ldexp(0.5, -k / 2))) < 1e-15);
            case_clear(&c);
        }
        mpq_clear(h);
    }
}

/* A diagonal that begins, or would have begun, on f at s = `offset` beyond its end. */
static void test_which_side_of_an_end(void **state)
{
    (void)state;
    static const struct {
        const char *y;
        int count;
    } ends[] = {{"0", 1}, {"0x1p-100", 0}, {"-0x1p-100", 1}, {"0x1p-300", -1}, {"1/3", 0}, {"-1/3", 1}};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        char line[512], error[512];
        struct test_case c;
        sprintf(line,
                "{\"id\":\"end\",\"f\":{\"points\":[[0,0],[1,0]]},\"g\":{\"points\":[[\"1/3\",\"%s\"],"
                "[\"2/3\",1]],\"domain\":[5,7]}}",
                ends[i].y);
        if (case_parse(line, "made", 1, &c, error) != CASE_READ)
            fail_msg("%s", error);
        const char *why = referee_solve(&c);
        assert_true((why != NULL) == (ends[i].count < 0));
        if (!why)
            assert_int_equal(c.expected.count, ends[i].count);
        if (i == 0)
            assert_true(c.expected.at[0].exact && !mpq_cmp_ui(c.expected.at[0].s, 5, 1) &&
                        !mpq_cmp_ui(c.expected.at[0].t, 1, 3) && !strcmp(c.class_name, "endpoint"));
        case_clear(&c);
    }
}

/* Swapping the curves swaps the parameters; equal weights are no weights. */
static void test_invariance(void **state)
{
    (void)state;
    for (int trial = 0; trial < TRIALS / 3; trial++) {
        struct random_state r = random_for(4, "invariance", (uint64_t)trial);
        struct sketch f, g;
        struct test_case c, d;
        sketch_random(&f, &r, (int)random_between(&r, 1, 7), false);
        sketch_random(&g, &r, (int)random_between(&r, 1, 7), false);
        case_make(&c, &f, &g);
        f.rational = true;
        for (int i = 0; i <= f.degree; i++)
            mpq_set_ui(f.w[i], 3, 7);
        case_make(&d, &g, &f);
        assert_null(referee_solve(&c));
        assert_null(referee_solve(&d));
        assert_int_equal(c.expected.count, d.expected.count);
        for (int i = 0; i < c.expected.count; i++) {
            int same = 0;
            for (int j = 0; j < c.expected.count; j++)
                same += distance(c.expected.at[i].t, d.expected.at[j].s) < 1e-39 &&
                        distance(c.expected.at[i].s, d.expected.at[j].t) < 1e-39;
            assert_int_equal(same, 1);
        }
        case_clear(&c);
        case_clear(&d);
        sketch_clear(&f);
        sketch_clear(&g);
    }
}

/* ---- verified cases --------------------------------------------------------------------------------------
 */

static void compare_case(struct test_case *c, int *judged, int *undecided)
{
    char class_name[32];
    struct case_expected known = c->expected;
    snprintf(class_name, sizeof class_name, "%s", c->class_name);
    memset(&c->expected, 0, sizeof c->expected);
    const char *why = referee_solve(c);
    if (why) {
        *undecided += !strcmp(class_name, "transversal") && !c->ambiguous;
    } else {
        ++*judged;
        if (c->expected.count != known.count || known.overlaps)
            fail_msg("%s: %d solutions, known %d", c->id, c->expected.count, known.count);
        for (int i = 0; i < known.count; i++)
            if (distance(c->expected.at[i].t, known.at[i].t) > 1e-15 ||
                distance(c->expected.at[i].s, known.at[i].s) > 1e-15)
                fail_msg("%s: another solution %d", c->id, i);
    }
    case_expected_clear(&known);
}

static void test_verified_cases(void **state)
{
    (void)state;
    static const char *const files[] = {"peers/bezier.jsonl", "peers/skia.jsonl",   "peers/paper.jsonl",
                                        "peers/small.jsonl",  "peers/issues.jsonl", "glyphs.jsonl"};
    int judged = 0, undecided = 0; /* transversal ones that are not ambiguous */
    const char *folder = getenv("CASES") ? getenv("CASES") : "../shared/cases";
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char path[4096];
        struct case_reader reader;
        struct test_case c;
        enum case_status status;
        snprintf(path, sizeof path, "%s/%s", folder, files[i]);
        FILE *stream = fopen(path, "r");
        if (!stream) {
            print_message("skipped: no verified cases at %s (CASES=folder)\n", path);
            skip();
        }
        case_reader_init(&reader, stream, path);
        while ((status = case_read(&reader, &c)) != CASE_END) {
            assert_int_equal(status, CASE_READ);
            compare_case(&c, &judged, &undecided);
            case_clear(&c);
        }
        case_reader_clear(&reader);
        fclose(stream);
    }
    assert_true(judged > 700);
    assert_int_equal(undecided, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_planted_solutions_are_found),
        cmocka_unit_test(test_as_many_crossings_as_there_can_be),
        cmocka_unit_test(test_contacts_get_no_verdict),
        cmocka_unit_test(test_which_side_of_an_end),
        cmocka_unit_test(test_invariance),
        cmocka_unit_test(test_verified_cases),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
