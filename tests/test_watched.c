/* The watched build of the algorithms: the same answers in the same steps as the other, which the program
 * `answers` beside this one prints; and its events account for every step and every record. */
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
    };
    const char *slash = strrchr(argv[0], '/');
    (void)argc;
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - argv[0]) : 1, slash ? argv[0] : ".");
    return cmocka_run_group_tests_name("watched", tests, NULL, NULL);
}
