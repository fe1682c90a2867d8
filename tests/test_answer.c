/* Solve lines: what is written reads back bit for bit; a bad line is refused by the name of its field. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "prop.h"
#include "../harness/judge/answer.h"

enum { TRIALS = 200 };

static struct crossings written, got;

static struct interval random_interval(struct random_state *r)
{
    real a = prop_bits(r, (int)random_between(r, -70, 0)), b = prop_dyadic(r, 10);
    struct interval i;

    i.lo = real_min(a, b);
    i.hi = real_max(a, b);
    return i;
}

static void random_records(struct random_state *r, struct crossings *c)
{
    c->count = (int)random_between(r, 0, 20);
    c->overlaps = (int)random_between(r, 0, 3);
    for (int i = 0; i < c->count; i++) {
        c->at[i].t = random_interval(r);
        c->at[i].s = random_interval(r);
        c->at[i].standing = (enum standing)(i % 4);
        c->at[i].at_most = (int)random_between(r, 0, 1024);
        c->at[i].multiplicity = (int)random_between(r, 0, 1024);
    }
    for (int i = 0; i < c->overlaps; i++) {
        struct overlap *o = &c->overlap[i];
        o->t_outer = random_interval(r);
        o->t_inner = random_interval(r);
        o->s_outer = random_interval(r);
        o->s_inner = random_interval(r);
        o->reversed = random_bits(r) & 1;
        o->exact = random_bits(r) & 1;
        o->distance = real_abs(prop_bits(r, -40));
    }
}

static void assert_same_interval(struct interval a, struct interval b)
{
    assert_true(a.lo == b.lo && a.hi == b.hi);
}

static void assert_same_records(const struct crossings *a, const struct crossings *b)
{
    assert_int_equal(a->count, b->count);
    assert_int_equal(a->overlaps, b->overlaps);
    for (int i = 0; i < a->count; i++) {
        assert_same_interval(a->at[i].t, b->at[i].t);
        assert_same_interval(a->at[i].s, b->at[i].s);
        assert_int_equal(a->at[i].standing, b->at[i].standing);
        assert_int_equal(a->at[i].at_most, b->at[i].at_most);
        assert_int_equal(a->at[i].multiplicity, b->at[i].multiplicity);
    }
    for (int i = 0; i < a->overlaps; i++) {
        const struct overlap *p = &a->overlap[i], *q = &b->overlap[i];
        assert_same_interval(p->t_outer, q->t_outer);
        assert_same_interval(p->t_inner, q->t_inner);
        assert_same_interval(p->s_outer, q->s_outer);
        assert_same_interval(p->s_inner, q->s_inner);
        assert_true(p->reversed == q->reversed && p->exact == q->exact && p->distance == q->distance);
    }
}

static char *line_of(const struct answer *a, json_t *extra)
{
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);

    answer_write(stream, a, NULL, extra);
    fclose(stream);
    return text;
}

static void test_reads_back_bit_for_bit(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(1, "answer", (uint64_t)i);
        char id[256], algorithm[128];
        struct answer a, b;
        a.id = i % 2 ? "plain" : "quote \" backslash \\ tab \t \xc3\xa9";
        a.algorithm = "bezier_clipping";
        a.tolerance = prop_bits(&r, -30);
        a.outcome = (enum outcome)(i % 5);
        a.steps = (long)random_between(&r, 0, 1000000);
        a.points_only = i % 3 == 0;
        a.crossings = &written;
        random_records(&r, &written);
        json_t *extra = json_pack("{s:s, s:f}", "run", "r\"1", "seconds", 0.1);
        char *line = line_of(&a, i % 4 ? extra : NULL);
        b.crossings = &got;
        const char *wrong = answer_read(line, &b, id, algorithm);
        if (wrong)
            fail_msg("%s\n%s", wrong, line);
        assert_string_equal(b.id, a.id);
        assert_string_equal(b.algorithm, a.algorithm);
        assert_true(b.tolerance == a.tolerance && b.points_only == a.points_only);
        assert_true(b.outcome == a.outcome && b.steps == a.steps);
        assert_same_records(&written, &got);
        json_t *parsed = json_loads(line, 0, NULL);
        assert_string_equal(json_string_value(json_object_get(parsed, "precision")), REAL_NAME);
        assert_true((json_object_get(parsed, "run") != NULL) == (i % 4 != 0));
        assert_true(i % 4 == 0 ||
                    json_equal(json_object_get(parsed, "seconds"), json_object_get(extra, "seconds")));
        json_decref(parsed);
        json_decref(extra);
        free(line);
    }
}

/* What an external program may leave out. */
static void test_least_line(void **state)
{
    (void)state;
    char id[256], algorithm[128];
    struct answer a;
    a.crossings = &got;
    assert_null(answer_read("{\"id\":\"x\",\"outcome\":\"UNSUPPORTED\"}", &a, id, algorithm));
    assert_true(a.outcome == UNSUPPORTED && got.count == 0 && got.overlaps == 0 && a.steps == 0);
    assert_null(answer_read("{\"id\":\"x\",\"outcome\":\"SOLVED\",\"crossings\":[{\"t\":[0,0.5],"
                            "\"s\":[\"1/4\",\"0x1p-1\"]}]}\n",
                            &a, id, algorithm));
    assert_string_equal(algorithm, "");
    assert_int_equal(got.count, 1);
    assert_true(got.at[0].t.hi == 0.5 && got.at[0].s.lo == 0.25 && got.at[0].s.hi == 0.5);
    assert_true(got.at[0].standing == CANDIDATE && got.at[0].at_most == 0 && got.at[0].multiplicity == 0);
}

static const char good_head[] = "{\"id\":\"x\",\"outcome\":\"SOLVED\",\"crossings\":[";
static const char good_crossing[] = "{\"t\":[0,1],\"s\":[0,1]}";

static void assert_refused(const char *line, const char *field)
{
    char id[256], algorithm[128];
    struct answer a;

    a.crossings = &got;
    const char *wrong = answer_read(line, &a, id, algorithm);
    if (!wrong || strncmp(wrong, field, strlen(field)) != 0)
        fail_msg("%s: %s", line, wrong ? wrong : "was taken for an answer");
}

static void refuse_crossing(const char *crossing, const char *field)
{
    char line[1024];

    sprintf(line, "%s%s]}", good_head, crossing);
    assert_refused(line, field);
}

static void refuse_more(const char *more, const char *field)
{
    char line[1024];

    sprintf(line, "%s%s],%s}", good_head, good_crossing, more);
    assert_refused(line, field);
}

static void test_refuses(void **state)
{
    (void)state;
    assert_refused("", "line:");
    assert_refused("[1]", "line:");
    assert_refused("{\"id\":\"x\"", "line:");
    assert_refused("{\"outcome\":\"SOLVED\",\"crossings\":[]}", "id:");
    assert_refused("{\"id\":7,\"outcome\":\"SOLVED\",\"crossings\":[]}", "id:");
    assert_refused("{\"id\":\"x\",\"outcome\":\"solved\",\"crossings\":[]}", "outcome:");
    assert_refused("{\"id\":\"x\",\"crossings\":[]}", "outcome:");
    assert_refused("{\"id\":\"x\",\"outcome\":\"SOLVED\"}", "crossings:");
    assert_refused("{\"id\":\"x\",\"outcome\":\"SOLVED\",\"crossings\":{}}", "crossings:");
    refuse_crossing("[0,1]", "crossings:");
    refuse_crossing("{\"s\":[0,1]}", "crossings.t:");
    refuse_crossing("{\"t\":[1,0],\"s\":[0,1]}", "crossings.t:");
    refuse_crossing("{\"t\":[0,1,2],\"s\":[0,1]}", "crossings.t:");
    refuse_crossing("{\"t\":[0,1],\"s\":[null,1]}", "crossings.s:");
    refuse_crossing("{\"t\":[0,1],\"s\":[\"nan\",1]}", "crossings.s:");
    refuse_crossing("{\"t\":[0,1],\"s\":[0,1],\"standing\":\"SURE\"}", "crossings.standing:");
    refuse_crossing("{\"t\":[0,1],\"s\":[0,1],\"at_most\":-1}", "crossings.at_most:");
    refuse_crossing("{\"t\":[0,1],\"s\":[0,1],\"multiplicity\":1.5}", "crossings.multiplicity:");
    refuse_more("\"steps\":-1", "steps:");
    refuse_more("\"tolerance\":\"wide\"", "tolerance:");
    refuse_more("\"algorithm\":[]", "algorithm:");
    refuse_more("\"points_only\":1", "points_only:");
    refuse_more("\"overlaps\":[{\"t_outer\":[0,1]}]", "overlaps.t_inner:");
    refuse_more("\"overlaps\":7", "overlaps:");
}

static void test_refuses_too_many(void **state)
{
    (void)state;
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    fputs(good_head, stream);
    for (int i = 0; i <= CROSSINGS_MAX; i++)
        fprintf(stream, "%s%s", i ? "," : "", good_crossing);
    fputs("]}", stream);
    fclose(stream);
    assert_refused(text, "crossings:");
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reads_back_bit_for_bit),
        cmocka_unit_test(test_least_line),
        cmocka_unit_test(test_refuses),
        cmocka_unit_test(test_refuses_too_many),
    };
    return cmocka_run_group_tests_name("answer", tests, NULL, NULL);
}
