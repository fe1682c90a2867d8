/* fatline-passes: the timing half of `fatline compare`, one for each build compared.  It reads cases, then
 * requests from standard input, a line each:
 *
 *   judge ALGORITHM            which cases it gets right, a digit 0 or 1 for each
 *   use DIGITS                 "ok": from here on a pass is over the cases marked 1
 *   time ALGORITHM PASSES      CPU nanoseconds of so many passes
 *
 * An algorithm that this build does not have: "none". */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case_set.h"
#include "clock.h"
#include "judge.h"
#include "number.h"

struct passes {
    struct case_set set;
    int used, *use;
    struct workspace workspace;
    struct crossings *crossings;
    double tolerance;
};

static void judge_all(struct passes *p, const struct intersector *a)
{
    for (int i = 0; i < p->set.count; i++) {
        const struct loaded_case *pair = &p->set.at[i];
        struct answer answer;
        bool right = false;

        memset((void *)&answer, 0, sizeof answer);
        answer.id = pair->c.id;
        answer.algorithm = a->name;
        answer.tolerance = pair->owned.problem.tolerance;
        answer.points_only = a->points_only;
        answer.crossings = p->crossings;
        answer.outcome = problem_solve(&pair->owned.problem, a, &p->workspace, p->crossings);
        if (pair->c.expected.known && !pair->c.ambiguous && answer.outcome == SOLVED)
            right = judge(&pair->c, &pair->owned.problem, &answer, case_tolerance(&pair->c, p->tolerance))
                        .verdict == RIGHT;
        putchar('0' + right);
    }
    putchar('\n');
}

static void use(struct passes *p, const char *digits)
{
    p->used = 0;
    for (int i = 0; i < p->set.count && (digits[i] == '0' || digits[i] == '1'); i++)
        if (digits[i] == '1')
            p->use[p->used++] = i;
    puts("ok");
}

static void time_all(struct passes *p, const struct intersector *a, int passes)
{
    double start = clock_now(false);

    for (int k = 0; k < passes; k++) {
        for (int i = 0; i < p->used; i++) {
            problem_solve(&p->set.at[p->use[i]].owned.problem, a, &p->workspace, p->crossings);
            clock_keep(p->crossings);
        }
    }
    printf("%.17g\n", clock_now(false) - start);
}

static void answer(struct passes *p, char *line)
{
    char *command = strtok(line, " \n"), *name = strtok(NULL, " \n"), *count = strtok(NULL, " \n");
    const struct intersector *a = name ? intersector_find(name) : NULL;

    if (command && name && !strcmp(command, "use"))
        use(p, name);
    else if (!a)
        puts("none");
    else if (!strcmp(command, "judge"))
        judge_all(p, a);
    else if (count && !strcmp(command, "time"))
        time_all(p, a, atoi(count));
    else
        puts("none");
    fflush(stdout);
}

int main(int argc, char **argv)
{
    struct passes p;
    char *line = NULL;
    size_t size = 0;
    real tolerance;
    int status;

    if (argc != 4 || !real_parse(argv[1], &tolerance)) {
        fprintf(stderr, "usage: fatline-passes TOLERANCE MAX_STEPS FILE\n");
        return 64;
    }
    memset((void *)&p, 0, sizeof p);
    p.tolerance = real_to_double(tolerance);
    status = case_set_read(&p.set, argv[3], tolerance, atoi(argv[2]));
    for (int i = 0; i < p.set.count && REAL_BITS == 53; i++)
        p.set.at[i].owned.problem.tolerance = (real)case_tolerance(&p.set.at[i].c, p.tolerance);
    p.use = (int *)calloc((size_t)p.set.count + 1, sizeof *p.use);
    p.crossings = (struct crossings *)calloc(1, sizeof *p.crossings);
    if (status || !p.use || !p.crossings)
        return status ? status : 2;
    workspace_make(&p.workspace, intersectors, p.set.degree_f, p.set.degree_g, WORKSPACE_ROOM);
    while (getline(&line, &size, stdin) > 0)
        answer(&p, line);
    free(line);
    workspace_clear(&p.workspace);
    free(p.crossings);
    free(p.use);
    case_set_clear(&p.set);
    return 0;
}
