/* fatline region: where a control point may go. */
#include <argp.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "regions/region_answer.h"
#include "regions/region_check.h"
#include "regions/region_options.h"
#include "regions/region_problem.h"
#include "run/row.h"

enum { OK = 0, WRONG = 1, FAILED = 2, BAD_DATA = 65, INTERRUPTED = 130 };

struct program {
    struct region_options options;
    struct owned_workspace workspace;
    struct region *region;
    struct region_breaks *breaks;
    struct region_checker checker;
};

static volatile sig_atomic_t interrupted;

static void interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

static void answer(struct program *p, const char *id, const struct region_problem *problem,
                   const struct region_method *method, const struct region_case *c)
{
    struct region_workspace *w = &p->workspace.workspace;
    struct region_answer a = {
        id, method, region_solve(problem, method, w, p->region), problem->sign, 0, p->region, NULL};
    a.steps = w->steps;
    if (p->options.check) {
        region_check(&p->checker, c, problem, w, &a);
        return;
    }
    if (region_breaks_find(problem, w, p->breaks) == SOLVED)
        a.breaks = p->breaks;
    region_answer_write(stdout, &a);
}

/* All methods on one handle of the case's curve: its own, or control point free_point. */
static int solve_handle(struct program *p, const struct region_case *c, int free_point, const char *where)
{
    struct owned_region owned;
    char id[300];
    const char *wrong = owned_region_make(c, free_point, p->options.tolerance, p->options.max_steps, &owned);
    if (wrong) {
        fprintf(stderr, "%s: %s\n", where, wrong);
        return BAD_DATA;
    }
    owned_workspace_fit(&p->workspace, &owned.problem);
    if (free_point >= 0)
        snprintf(id, sizeof id, "%.250s#%d", c->id, free_point);
    for (int i = 0; i < p->options.count; i++)
        answer(p, free_point >= 0 ? id : c->id, &owned.problem, p->options.method[i], c);
    owned_region_clear(&owned);
    return OK;
}

static int solve_line(struct program *p, const char *text, const char *file, int number)
{
    struct region_case c;
    char error[512], where[300];
    int status = OK;
    if (region_case_parse(text, file, number, &c, error) == REGION_CASE_BAD) {
        fprintf(stderr, "%s\n", error);
        return BAD_DATA;
    }
    snprintf(where, sizeof where, "%.250s:%d", file, number);
    if (p->options.all_points)
        for (int i = 0; i < c.count && status == OK; i++)
            status = solve_handle(p, &c, i, where);
    else
        status = solve_handle(p, &c, -1, where);
    region_case_clear(&c);
    return status;
}

static int solve_file(struct program *p, const char *path)
{
    bool standard = !strcmp(path, "-");
    FILE *stream = standard ? stdin : fopen(path, "r");
    char *text = NULL;
    size_t size = 0;
    int number = 0, worst = OK;
    if (!stream) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        return FAILED;
    }
    while (!interrupted && getline(&text, &size, stream) >= 0) {
        number++;
        if (!text[strspn(text, " \t\r\n")])
            continue;
        int status = solve_line(p, text, standard ? "stdin" : path, number);
        worst = status != OK ? status : worst;
        if (status != OK && !p->options.keep_going)
            break;
    }
    free(text);
    if (!standard)
        fclose(stream);
    return worst;
}

static int solve_all(struct program *p)
{
    int worst = OK;
    if (p->options.file_count == 0)
        return solve_file(p, "-");
    for (int i = 0; i < p->options.file_count && !interrupted; i++) {
        int status = solve_file(p, p->options.files[i]);
        worst = status != OK && worst != FAILED ? status : worst;
        if (status != OK && !p->options.keep_going)
            break;
    }
    return worst;
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    static struct program p;
    struct sigaction action;
    region_options_read(argc, argv, &p.options);
    p.region = (struct region *)malloc(sizeof *p.region);
    p.breaks = (struct region_breaks *)malloc(sizeof *p.breaks);
    if (!p.region || !p.breaks) {
        fprintf(stderr, "fatline region: out of memory\n");
        return FAILED;
    }
    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESETHAND; /* the second signal ends the program at once */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    p.checker.rows = p.options.rows;
    if (p.options.check && p.options.rows)
        row_write(stdout, row_environment(argc, argv, REAL_NAME));
    int status = solve_all(&p);
    if (p.options.check && !p.options.rows)
        region_check_summary(&p.checker, stdout);
    bool lost = fflush(stdout) || ferror(stdout);
    if (lost)
        fprintf(stderr, "fatline region: standard output cannot be written\n");
    owned_workspace_clear(&p.workspace);
    free(p.region);
    free(p.breaks);
    return interrupted ? INTERRUPTED : lost ? FAILED : status != OK ? status : p.checker.wrong ? WRONG : OK;
}
