/* Who is timed, and on which pairs: algorithms that err in known ways on segments that cross in their
 * middles, written with degrees 1, 2 and 3. */
#include "prop.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../harness/timing.h"
#include "../harness/timing_rows.h"

enum { PAIRS = 12, CASES = PAIRS + 2 }; /* the last two: ambiguous, and without a known answer */

static enum outcome answer_box(struct crossings *out, struct workspace *w, real radius, enum outcome outcome)
{
    struct crossing *c = &out->at[0];

    memset(c, 0, sizeof *c);
    c->t.lo = c->s.lo = (real)1 / 2 - radius;
    c->t.hi = c->s.hi = (real)1 / 2 + radius;
    c->standing = CANDIDATE;
    out->count = 1;
    out->overlaps = 0;
    w->steps = 3;
    return outcome;
}

static enum outcome right_always(const struct problem *p, struct workspace *w, struct crossings *out)
{
    return answer_box(out, w, p->bounds.tolerance_t / 4, SOLVED);
}

static enum outcome misses_at_degree_3(const struct problem *p, struct workspace *w, struct crossings *out)
{
    answer_box(out, w, p->bounds.tolerance_t / 4, SOLVED);
    out->count = p->f.degree < 3;
    return SOLVED;
}

static enum outcome stops_at_degree_3(const struct problem *p, struct workspace *w, struct crossings *out)
{
    if (p->f.degree < 3)
        return answer_box(out, w, p->bounds.tolerance_t / 4, SOLVED);
    return answer_box(out, w, (real)1 / 2, OUT_OF_STEPS);
}

static enum outcome takes_degree_1(const struct problem *p, struct workspace *w, struct crossings *out)
{
    if (p->f.degree == 1)
        return answer_box(out, w, p->bounds.tolerance_t / 4, SOLVED);
    out->count = out->overlaps = 0;
    return UNSUPPORTED;
}

#define FAKE(name)                                                                                           \
    {                                                                                                        \
#name, "a fake", "none", {0, 0, 0, 0 }, name                                                         \
    }
static const struct intersector fakes[] = {FAKE(right_always), FAKE(misses_at_degree_3),
                                           FAKE(stops_at_degree_3), FAKE(takes_degree_1)};
enum { RIGHT_ALWAYS, MISSES, STOPS, TAKES_LITTLE, FAKES };

/* Control points evenly along the segment. */
static void write_segment(FILE *stream, const char *name, int degree, int y0, int y1)
{
    fprintf(stream, "\"%s\":{\"degree\":%d,\"points\":[", name, degree);
    for (int i = 0; i <= degree; i++)
        fprintf(stream, "%s[\"%d/%d\",\"%d/%d\"]", i ? "," : "", i, degree, y0 * (degree - i) + y1 * i,
                degree);
    fprintf(stream, "]}");
}

static void write_cases(const char *path)
{
    FILE *stream = fopen(path, "w");

    assert_non_null(stream);
    for (int i = 0; i < CASES; i++) {
        int degree = 1 + i % 3;

        fprintf(stream, "{\"id\":\"cross-%d\",\"class\":\"transversal\",", i);
        write_segment(stream, "f", degree, 0, 1);
        fprintf(stream, ",");
        write_segment(stream, "g", degree, 1, 0);
        if (i != PAIRS + 1)
            fprintf(stream, ",\"expected\":{\"count\":1,\"params\":[[0.5,0.5]],\"exact\":[[\"1/2\",\"1/2\"]],"
                            "\"mult\":[1],\"sin\":[1],\"cond\":[1]}");
        fprintf(stream, "%s}\n", i == PAIRS ? ",\"near\":{\"ambiguous\":[\"for the test\"]}" : "");
    }
    assert_int_equal(fclose(stream), 0);
}

struct trial {
    struct case_set set;
    const struct loaded_case *at[CASES];
    struct contender contender[FAKES];
    struct timing timing[FAKES];
    struct timing_plan plan;
    int left_out;
};

static void run_trial(struct trial *trial, bool unchecked, double seconds)
{
    static const struct intersector *const nobody[] = {NULL};
    char path[] = "/tmp/fatline-timing-XXXXXX";
    struct timing_memory memory;
    int file = mkstemp(path), *timed;

    assert_true(file >= 0);
    write_cases(path);
    memset(trial, 0, sizeof *trial);
    trial->plan.tolerance = (real)1 / 1000000000;
    trial->plan.unchecked = unchecked;
    trial->plan.clock.seconds = seconds;
    trial->plan.clock.rounds = 7;
    trial->plan.clock.sample_ns = 1e4;
    assert_int_equal(case_set_read(&trial->set, path, trial->plan.tolerance, 10), 0);
    remove(path);
    assert_int_equal(trial->set.count, CASES);
    for (int i = 0; i < CASES; i++)
        trial->at[i] = &trial->set.at[i];
    for (int k = 0; k < FAKES; k++) {
        trial->contender[k].name = fakes[k].name;
        trial->contender[k].algorithm = &fakes[k];
    }
    workspace_make(&memory.workspace, nobody, 3, 3, WORKSPACE_ROOM);
    memory.crossings = (struct crossings *)calloc(1, sizeof *memory.crossings);
    timing_run(CASES, trial->at, FAKES, trial->contender, &trial->plan, &memory, trial->timing,
               &trial->left_out, &timed);
    free(timed);
    free(memory.crossings);
    workspace_clear(&memory.workspace);
}

static void end_trial(struct trial *trial)
{
    for (int k = 0; k < FAKES; k++)
        timing_clear(&trial->timing[k]);
    case_set_clear(&trial->set);
}

/* A miss ends it; stopping early only leaves those pairs out, for all; who takes few pairs leaves. */
static void test_only_the_right_is_timed(void **state)
{
    struct trial trial;
    struct timing *t = trial.timing;

    (void)state;
    run_trial(&trial, false, 0);
    assert_int_equal(trial.left_out, 2);
    for (int k = 0; k < FAKES; k++)
        assert_int_equal(t[k].judged, PAIRS);
    assert_int_equal(t[RIGHT_ALWAYS].right, PAIRS);
    assert_int_equal(t[RIGHT_ALWAYS].pairs, 2 * PAIRS / 3);
    assert_int_equal(t[STOPS].stopped, PAIRS / 3);
    assert_int_equal(t[STOPS].pairs, 2 * PAIRS / 3);
    assert_int_equal(t[MISSES].missing, PAIRS / 3);
    assert_int_equal(t[MISSES].pairs, 0);
    assert_string_equal(t[MISSES].first_missing, "cross-2");
    assert_non_null(strstr(t[MISSES].why_not, "missed"));
    assert_int_equal(t[TAKES_LITTLE].not_taken, 2 * PAIRS / 3);
    assert_int_equal(t[TAKES_LITTLE].pairs, 0);
    assert_int_equal(t[RIGHT_ALWAYS].samples.count, 7);
    assert_int_equal(t[STOPS].samples.count, 7);
    assert_true(t[RIGHT_ALWAYS].steps == 3);
    assert_true(t[RIGHT_ALWAYS].ns_max > 0 && t[RIGHT_ALWAYS].samples.ns[0] > 0);
    end_trial(&trial);
}

/* Unchecked, a miss is not seen: SOLVED is enough, on every case. */
static void test_unchecked_believes(void **state)
{
    struct trial trial;

    (void)state;
    run_trial(&trial, true, 0);
    assert_int_equal(trial.left_out, 0);
    assert_int_equal(trial.timing[MISSES].missing, 0);
    assert_true(trial.timing[MISSES].pairs > 0);
    end_trial(&trial);
}

/* With no time to speak of, the least number of rounds on one pair is still done. */
static void test_time_allowed_thins_the_pairs(void **state)
{
    struct trial trial;

    (void)state;
    run_trial(&trial, false, 1e-9);
    assert_int_equal(trial.timing[RIGHT_ALWAYS].right, PAIRS);
    assert_int_equal(trial.timing[RIGHT_ALWAYS].pairs, 1);
    assert_int_equal(trial.timing[RIGHT_ALWAYS].samples.count, CLOCK_ROUNDS_LEAST);
    end_trial(&trial);
}

/* Every contender has its row; those that were timed carry a ratio to the baseline, whose own is 1. */
static void test_rows(void **state)
{
    struct trial trial;
    char *text = NULL, *line;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    int rows = 0;

    (void)state;
    run_trial(&trial, false, 0);
    struct timing_report report = {"crossings",  CASES,       trial.left_out, FAKES, trial.contender,
                                   trial.timing, &trial.plan, RIGHT_ALWAYS,   -1,    false,
                                   NULL};
    timing_rows_write(stream, &report);
    fclose(stream);
    for (line = strtok(text, "\n"); line; line = strtok(NULL, "\n"), rows++) {
        json_t *row = json_loads(line, 0, NULL);
        const struct timing *t = &trial.timing[rows];

        assert_non_null(row);
        assert_string_equal(json_string_value(json_object_get(row, "algorithm")), fakes[rows].name);
        assert_int_equal(json_integer_value(json_object_get(row, "pairs")), t->pairs);
        assert_true(!json_object_get(row, "ns_median") == !t->pairs);
        assert_true(!json_object_get(row, "ratio") == !t->pairs);
        assert_true(!json_object_get(row, "not_timed") == (t->pairs > 0));
        assert_int_equal(json_array_size(json_object_get(row, "samples")), t->samples.count);
        if (rows == RIGHT_ALWAYS)
            assert_true(json_real_value(json_object_get(row, "ratio")) == 1);
        json_decref(row);
    }
    assert_int_equal(rows, FAKES);
    free(text);
    end_trial(&trial);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_only_the_right_is_timed),
        cmocka_unit_test(test_unchecked_believes),
        cmocka_unit_test(test_time_allowed_thins_the_pairs),
        cmocka_unit_test(test_rows),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
