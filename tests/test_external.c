/* A program over a pipe: whatever it does, each question gets a result, and the next one a fresh start. */
#include "prop.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../harness/run/external.h"

/* The case lines are ids alone here: what is asked is the program's business, not the pipe's. */
#define ANSWER                                                                                               \
    "echo '{\"id\":\"'$id'\",\"outcome\":\"SOLVED\",\"crossings\":[{\"t\":[0.25,0.5],\"s\":[\"1/4\",1]}]}'"
#define LOOP(body) "while read id; do " body "; done"

static struct crossings crossings;

static const char *ask(struct external *e, const char *id, struct answer *a)
{
    memset((void *)a, 0, sizeof *a);
    a->crossings = &crossings;
    const char *error = external_ask(e, id, id, a);
    assert_string_equal(a->id, id);
    assert_string_equal(a->algorithm, e->name);
    assert_true(a->tolerance == real_ldexp((real)1, -20));
    if (error)
        assert_true((a->outcome == CRASHED || a->outcome == TIMED_OUT || a->outcome == GAVE_UP) &&
                    crossings.count == 0 && crossings.overlaps == 0);
    return error;
}

static void start(struct external *e, const char *command, double timeout)
{
    assert_null(external_start(e, command, timeout, real_ldexp((real)1, -20)));
}

static void test_answers_in_order(void **state)
{
    struct external e;
    struct answer a;
    char id[16];
    (void)state;
    start(&e, LOOP(ANSWER), 10);
    pid_t pid = e.pid;
    for (int i = 0; i < 100; i++) {
        snprintf(id, sizeof id, "case-%d", i);
        assert_null(ask(&e, id, &a));
        assert_true(a.outcome == SOLVED && crossings.count == 1);
        assert_true(crossings.at[0].t.hi * 2 == 1 && crossings.at[0].s.lo * 4 == 1);
    }
    assert_true(e.pid == pid);
    external_stop(&e);
    assert_true(e.pid == 0 && kill(pid, 0) != 0);
}

static void test_name_is_the_first_word(void **state)
{
    static const char *const command[][2] = {{"cat", "cat"},
                                             {" /bin/cat -u", "cat"},
                                             {"/usr/bin/../bin/env --x=/y/z", "env"},
                                             {"true|cat", "true"}};
    struct external e;
    (void)state;
    for (size_t i = 0; i < sizeof command / sizeof *command; i++) {
        start(&e, command[i][0], 1);
        assert_string_equal(e.name, command[i][1]);
        external_stop(&e);
    }
}

/* A program that fails at the second case of its life, and what the message must contain. */
static const struct {
    const char *command, *message;
    enum outcome outcome;
} failures[] = {
    {LOOP("[ $id = b ] && exit 3; " ANSWER), "status 3", CRASHED},
    {LOOP("[ $id = b ] && kill -9 $$; " ANSWER), "signal 9", CRASHED},
    {LOOP("[ $id = b ] && sleep 20; " ANSWER), "no answer within 0.3 s", TIMED_OUT},
    {LOOP("[ $id = b ] && id=x; " ANSWER), "id: \"x\", expected \"b\"", GAVE_UP},
    {LOOP("[ $id = b ] && echo junk; " ANSWER), "line: ", GAVE_UP},
    {LOOP("[ $id = b ] && echo; " ANSWER), "line: ", GAVE_UP},
    {LOOP(ANSWER "; [ $id = a ] && " ANSWER), "id: \"a\", expected \"b\"", GAVE_UP},
    {LOOP("[ $id = b ] && exec >&-; " ANSWER), "before it answered", CRASHED},
};

static void test_failures_are_results(void **state)
{
    struct answer a;
    (void)state;
    for (size_t i = 0; i < sizeof failures / sizeof *failures; i++) {
        struct external e;
        start(&e, failures[i].command, 0.3);
        assert_null(ask(&e, "a", &a));
        const char *error = ask(&e, "b", &a);
        if (!error || !strstr(error, failures[i].message))
            fail_msg("%s\n  says %s\n  expected %s", failures[i].command, error ? error : "nothing",
                     failures[i].message);
        assert_int_equal(a.outcome, failures[i].outcome);
        assert_null(ask(&e, "c", &a));
        assert_true(a.outcome == SOLVED && crossings.count == 1);
        external_stop(&e);
    }
}

/* Refused at once where the shell's own search can tell, else with every answer. */
static void test_missing_program(void **state)
{
    static const char *const missing[] = {"./no-such-program", "no-such-program --x", "  /no/such/program"};
    struct external e;
    struct answer a;
    (void)state;
    for (size_t i = 0; i < sizeof missing / sizeof *missing; i++) {
        const char *error = external_start(&e, missing[i], 5, (real)1e-9);
        assert_non_null(error);
        assert_non_null(strstr(error, "no program of this name"));
        external_stop(&e);
    }
    start(&e, "./no-such-program 2>/dev/null", 5);
    for (int i = 0; i < 3; i++) {
        const char *error = ask(&e, "a", &a);
        assert_non_null(error);
        assert_non_null(strstr(error, "command not found"));
    }
    external_stop(&e);
}

/* Lines longer than a pipe holds, in both directions. */
static void test_long_lines(void **state)
{
    enum { LENGTH = 1 << 20 };
    struct external e;
    struct answer a;
    char *line = (char *)malloc(LENGTH);
    (void)state;
    memset(line, ' ', LENGTH);
    int n = snprintf(line, LENGTH, "{\"id\":\"a\",\"outcome\":\"SOLVED\",\"crossings\":[]");
    line[n] = ' ';
    line[LENGTH - 2] = '}';
    line[LENGTH - 1] = 0;
    start(&e, "cat", 10);
    memset((void *)&a, 0, sizeof a);
    a.crossings = &crossings;
    assert_null(external_ask(&e, "a", line, &a));
    assert_true(a.outcome == SOLVED);
    external_stop(&e);
    free(line);
}

static void test_tolerance_in_the_environment(void **state)
{
    struct external e;
    struct answer a;
    (void)state;
    start(&e,
          LOOP("echo '{\"id\":\"'$id'\",\"outcome\":\"SOLVED\",\"crossings\":[],\"tolerance\":\"'"
               "$FATLINE_TOLERANCE'\"}'"),
          10);
    assert_null(ask(&e, "a", &a));
    external_stop(&e);
}

/* A hung program is gone after the stop, children included. */
static void test_stop_ends_everything(void **state)
{
    struct external e;
    struct timespec begin, end;
    (void)state;
    start(&e, "sleep 30 | sleep 30", 10);
    pid_t group = e.pid;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    external_stop(&e);
    clock_gettime(CLOCK_MONOTONIC, &end);
    assert_true(end.tv_sec - begin.tv_sec <= 3);
    assert_true(kill(group, 0) != 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_answers_in_order),     cmocka_unit_test(test_name_is_the_first_word),
        cmocka_unit_test(test_failures_are_results), cmocka_unit_test(test_missing_program),
        cmocka_unit_test(test_long_lines),           cmocka_unit_test(test_tolerance_in_the_environment),
        cmocka_unit_test(test_stop_ends_everything),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
