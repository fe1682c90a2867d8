/* fatline region: where a control point may go. */
#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases/selection.h"
#include "regions/region_answer.h"
#include "regions/region_check.h"
#include "regions/region_options.h"
#include "regions/region_problem.h"
#include "regions/region_random.h"
#include "regions/region_time.h"
#include "run/interrupt.h"
#include "run/row.h"
#include "run/standard_output.h"
#include "timing/clock.h"

enum { OK = 0, WRONG = 1, FAILED = 2, BAD_DATA = 65 };

struct program {
    struct region_options options;
    struct owned_workspace workspace;
    struct region *region;
    struct region_breaks *breaks;
    struct region_checker checker;
    long repeated, lines;
};

static int count_arcs(const struct region *r)
{
    int arcs = 0;
    for (int i = 0; i < r->count; i++)
        arcs += r->edge[i].type == EDGE_ARC;
    return arcs;
}

static int count_spans(const struct region_problem *p)
{
    int spans = 0;
    for (int k = p->family.degree; k < p->family.count; k++)
        spans +=
            real_max(p->family.knots[k], p->interval.lo) < real_min(p->family.knots[k + 1], p->interval.hi);
    return spans;
}

static void write_time(struct program *p, const char *id, const struct region_problem *problem,
                       const struct region_method *method)
{
    double ns = region_time(problem, method, &p->workspace.workspace, p->region);
    row_write(stdout,
              json_pack("{s:s, s:s, s:s, s:i, s:b, s:i, s:s, s:i, s:i, s:b, s:f}", "id", id, "method",
                        method->name, "precision", REAL_NAME, "degree", problem->family.degree, "rational",
                        (int)(problem->family.weight != NULL), "spans", count_spans(problem), "kind",
                        region_kind_name(p->region->kind), "edges", p->region->count, "arcs",
                        count_arcs(p->region), "certified", (int)p->region->certified, "ns", ns));
}

/* With a point, its side is all that is repeated. */
static void repeat(struct program *p, const struct region_problem *problem,
                   const struct region_method *method)
{
    struct region_workspace *w = &p->workspace.workspace;
    if (p->options.at_given)
        region_prepare(problem, w);
    for (long i = 0; i < p->options.repeat; i++) {
        if (p->options.at_given)
            region_contains(problem, w, p->options.at, 0);
        else
            region_solve(problem, method, w, p->region);
        clock_keep(p->region);
    }
    p->repeated++;
}

static void ask_about_point(struct program *p, const struct region_problem *problem, struct region_answer *a)
{
    struct region_workspace *w = &p->workspace.workspace;
    a->at_given = true;
    a->at = p->options.at;
    a->side = region_contains(problem, w, a->at, 0);
    a->distance = region_distance(problem, w, p->region, a->at);
    a->nearest = region_nearest(problem, w, p->region, a->at);
}

static void answer(struct program *p, const char *id, const struct region_problem *problem,
                   const struct region_method *method, const struct region_case *c)
{
    struct region_workspace *w = &p->workspace.workspace;
    struct region_answer a;
    memset((void *)&a, 0, sizeof a);
    a.id = id;
    a.method = method;
    a.outcome = region_solve(problem, method, w, p->region);
    a.sign = problem->sign;
    a.region = p->region;
    a.steps = w->steps;
    if (p->options.check) {
        region_check(&p->checker, c, problem, w, &a);
        return;
    }
    if (a.outcome == SOLVED && p->options.at_given)
        ask_about_point(p, problem, &a);
    if (a.outcome == SOLVED && region_breaks_find(problem, w, p->breaks) == SOLVED)
        a.breaks = p->breaks;
    region_answer_write(stdout, &a);
}

static void serve(struct program *p, const char *id, const struct region_problem *problem,
                  const struct region_method *method, const struct region_case *c)
{
    if (p->options.time)
        write_time(p, id, problem, method);
    else if (p->options.repeat)
        repeat(p, problem, method);
    else
        answer(p, id, problem, method, c);
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
    for (int i = 0; i < p->options.count && !interrupted;
         i++) /* what is expected belongs to the case's own handle */
        serve(p, free_point >= 0 ? id : c->id, &owned.problem, p->options.method[i],
              free_point >= 0 ? NULL : c);
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
        p->lines++;
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

static void write_random(const struct region_options *o)
{
    char line[REGION_LINE_MAX];
    for (long i = 0; i < o->random && !interrupted; i++) {
        region_random_line((uint64_t)o->seed, o->degree_lo, o->degree_hi, (uint64_t)i, line);
        puts(line);
    }
}

static int solve_all(struct program *p)
{
    struct selection all;
    int worst = OK;
    memset((void *)&all, 0, sizeof all);
    all.files = p->options.files;
    all.file_count = p->options.file_count;
    for (int i = 0; i < selection_files(&all) && !interrupted; i++) {
        int status = solve_file(p, selection_file(&all, i));
        worst = status != OK && worst != FAILED ? status : worst;
        if (status != OK && !p->options.keep_going)
            break;
    }
    if (worst == OK && !p->lines && !interrupted)
        worst = selection_complain(&all, "fatline region");
    return worst;
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    static struct program p;
    static struct region exact;
    region_options_read(argc, argv, &p.options);
    p.region = (struct region *)malloc(sizeof *p.region);
    p.breaks = (struct region_breaks *)malloc(sizeof *p.breaks);
    if (!p.region || !p.breaks) {
        fprintf(stderr, "fatline region: out of memory\n");
        return FAILED;
    }
    interrupt_watch(NULL);
    p.checker.rows = p.options.rows;
    if (p.options.check && p.options.count > 1 && p.options.method[0] == region_methods[0])
        p.checker.exact = &exact;
    if ((p.options.check && p.options.rows) || p.options.time)
        row_write(stdout, row_environment(argc, argv, REAL_NAME));
    int status = OK;
    if (p.options.random)
        write_random(&p.options);
    else
        status = solve_all(&p);
    if (p.options.check && !p.options.rows)
        region_check_summary(&p.checker, stdout);
    if (p.options.repeat)
        printf("{\"regions\":%ld,\"passes\":%ld}\n", p.repeated, p.options.repeat);
    owned_workspace_clear(&p.workspace);
    free(p.region);
    free(p.breaks);
    return interrupted ? INTERRUPTED : status != OK ? status : p.checker.wrong ? WRONG : OK;
}
