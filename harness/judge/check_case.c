#include "check_case.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "answer.h"
#include "../cases/json_text.h"
#include "../truth/exact.h"
#include "../run/guard.h"
#include "judge_points.h"
#include "judge_strict.h"
#include "../timing/clock.h"
#include "../cases/problem.h"
#include "../truth/referee.h"

/* Finer than any record; Krawczyk's test gives 40. */
enum { TRUTH_DIGITS = 40, STRICT_DIGITS = REAL_BITS > 113 ? 700 : 80 };

const char *checker_open(struct checker *k, const struct check_options *o)
{
    memset((void *)k, 0, sizeof *k);
    k->options = o;
    k->crossings = (struct crossings *)malloc(sizeof *k->crossings);
    if (!k->crossings)
        return "out of memory";
    guard_set_timeout(o->solving.timeout);
    if (!o->solving.external)
        return NULL;
    return external_start(&k->external, o->solving.external, o->solving.timeout, (real)o->tolerance);
}

void checker_close(struct checker *k)
{
    guard_end();
    if (k->options->solving.external)
        external_stop(&k->external);
    fitted_workspace_clear(&k->memory);
    free(k->crossings);
}

__attribute__((format(printf, 2, 3))) static void note(json_t *reply, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    json_array_append_new(json_object_get(reply, "notes"), json_vsprintf(format, arguments));
    va_end(arguments);
}

/* ---- rows ------------------------------------------------------------------------------------------------
 */

/* The largest of the case's condition numbers; NAN: none is known. */
static double worst_condition(const struct test_case *c)
{
    double cond = NAN;
    for (int i = 0; c->expected.known && i < c->expected.count; i++)
        cond = fmax(cond, c->expected.at[i].cond);
    return cond;
}

static json_t *row_of(const struct test_case *c, const struct answer *a, const struct judgement *v,
                      double tol)
{
    json_t *row = json_pack("{s:s,s:s,s:s,s:s,s:o,s:s,s:s}", "id", c->id, "class", c->class_name, "algorithm",
                            a->algorithm, "precision", REAL_NAME, "tolerance", json_number_or_null(tol),
                            "outcome", outcome_name(a->outcome), "verdict", verdict_name(v->verdict));
    const struct {
        const char *name;
        int value;
    } counts[] = {{"expected", v->expected},  {"found", v->found},         {"missed", v->missed},
                  {"extra", v->extra},        {"duplicate", v->duplicate}, {"merged", v->merged},
                  {"undecided", v->undecided}};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        json_object_set_new(row, counts[i].name, json_integer(counts[i].value));
    json_object_set_new(row, "max_error", json_number_or_null(v->max_error));
    json_object_set_new(row, "cond", json_number_or_null(worst_condition(c)));
    json_object_set_new(row, "ambiguous", json_boolean(c->ambiguous));
    json_object_set_new(row, "steps", json_integer(a->steps));
    if (a->points_only)
        json_object_set_new(row, "judged_by", json_string("points"));
    json_object_set_new(row, "file", json_string(c->file ? c->file : ""));
    return row;
}

/* "tan-012 quad hybrid_clipping_3: missed 1 of 2, near t = 0.37" */
static void note_failure(json_t *reply, const struct test_case *c, const struct answer *a,
                         const struct judgement *v)
{
    char missed[64] = "", extra[64] = "", duplicate[48] = "", merged[64] = "";
    if (v->missed)
        snprintf(missed, sizeof missed, ", missed %d of %d, near t = %.6g", v->missed, v->expected,
                 v->missed_t);
    if (v->extra)
        snprintf(extra, sizeof extra, ", %d extra, near t = %.6g", v->extra, v->extra_t);
    if (v->duplicate)
        snprintf(duplicate, sizeof duplicate, ", %d duplicate", v->duplicate);
    if (v->merged)
        snprintf(merged, sizeof merged, ", %d merged (wider than 4 tolerances)", v->merged);
    char all[256];
    snprintf(all, sizeof all, "%s%s%s%s", missed, extra, duplicate, merged);
    note(reply, "%s %s %s: %s%s", c->id, REAL_NAME, a->algorithm, all + 2,
         c->ambiguous ? " (ambiguous)" : "");
}

static void judge_answer(json_t *reply, const struct test_case *c, const struct problem *p,
                         const struct answer *a, double tol, double reach)
{
    struct point_judgement points;
    struct judgement v;
    json_t *row;
    if (reach > 0)
        points = judge_points(c, p, a, reach);
    v = reach > 0 ? points.found : judge(c, p, a, tol);
    row = row_of(c, a, &v, tol);
    if (reach > 0) {
        json_object_set_new(row, "judged_by", json_string("points one to one"));
        json_object_set_new(row, "points", json_integer(points.points));
        if (points.overlap[0])
            json_object_set_new(row, "overlap", json_string(points.overlap));
    }
    json_array_append_new(json_object_get(reply, "rows"), row);
    if (v.verdict == WRONG)
        note_failure(reply, c, a, &v);
}

/* Adds to the last row whether the records hold, and the time. */
static void judge_words(json_t *reply, const struct test_case *c, const struct answer *a, double ns,
                        int digits)
{
    json_t *rows = json_object_get(reply, "rows"), *row = json_array_get(rows, json_array_size(rows) - 1);
    char why[256];
    bool judged = verdict_without(a->outcome) == UNJUDGED && !a->points_only;
    int violated = judged ? judge_strict(c, a->crossings, digits, why) : 0;
    int standing[CLUSTER + 1] = {0};
    for (int i = 0; i < a->crossings->count; i++)
        standing[a->crossings->at[i].standing]++;
    json_object_set_new(row, "violated", json_integer(violated));
    json_object_set_new(row, "ns", json_real(ns));
    json_object_set_new(row, "standings",
                        json_pack("[i,i,i,i,i]", standing[UNIQUE], standing[END], standing[CLUSTER],
                                  standing[CANDIDATE], a->crossings->overlaps));
    if (violated)
        note(reply, "%s %s %s: %s", c->id, REAL_NAME, a->algorithm, why);
}

/* ---- solving ---------------------------------------------------------------------------------------------
 */

/* How long it took; what takes longer than all before is solved again, for the machine may have been slow.
 */
static double solve(struct checker *k, const struct problem *p, struct answer *a,
                    const struct intersector *algorithm)
{
    double best = HUGE_VAL;
    for (int i = 0; i < (k->options->strict ? 3 : 1) && best > k->slowest; i++) {
        double from = clock_now(false);
        a->outcome = guard_solve(p, algorithm, &k->memory.workspace, k->crossings);
        best = fmin(best, clock_now(false) - from);
    }
    k->slowest = k->options->strict ? fmax(k->slowest, best) : 0;
    a->steps = k->memory.workspace.steps;
    return best;
}

static void run_algorithms(struct checker *k, const struct test_case *c, const struct problem *p, double tol,
                           json_t *reply)
{
    workspace_fit(&k->memory, k->options->solving.algorithms.at, p->f.degree, p->g.degree,
                  k->options->solving.room);
    for (int i = 0; i < k->options->solving.algorithms.count; i++) {
        const struct intersector *algorithm = k->options->solving.algorithms.at[i];
        struct answer a = {c->id, algorithm->name,        (real)tol,   INVALID,
                           0,     algorithm->points_only, k->crossings};
        double ns = solve(k, p, &a, algorithm);
        judge_answer(reply, c, p, &a, tol, k->options->points);
        if (k->options->strict && c->expected.known)
            judge_words(reply, c, &a, ns, k->options->truth == TRUTH_EXACT ? STRICT_DIGITS : TRUTH_DIGITS);
    }
}

static void run_external(struct checker *k, const struct test_case *c, const struct problem *p, double tol,
                         json_t *reply)
{
    struct answer a = {c->id, NULL, (real)k->options->tolerance, INVALID, 0, false, k->crossings};
    char *line = json_dumps(c->line, JSON_COMPACT);
    const char *message = external_ask(&k->external, c->id, line ? line : "", &a);
    free(line);
    if (message)
        note(reply, "%s %s %s: %s", c->id, REAL_NAME, k->external.name, message);
    judge_answer(reply, c, p, &a, tol, k->options->points);
}

static void find_truth(const struct check_options *o, struct test_case *c, json_t *reply)
{
    enum { SECONDS = 120 };
    struct exact_limits limits = {o->strict ? (int)STRICT_DIGITS : 50, SECONDS};
    const char *why = NULL;
    if (o->truth == TRUTH_KRAWCZYK || o->truth == TRUTH_EITHER)
        why = referee_solve(c);
    if (o->truth == TRUTH_EXACT || (o->truth == TRUTH_EITHER && why))
        why = exact_solve(c, &limits);
    if (!why)
        return;
    case_expected_clear(&c->expected);
    note(reply, "%s: no truth: %s", c->id, why);
}

json_t *checker_run(struct checker *k, struct test_case *c)
{
    json_t *reply = json_pack("{s:[],s:[]}", "rows", "notes");
    struct owned_problem owned;

    find_truth(k->options, c, reply);
    double tol = case_tolerance(c, k->options->tolerance);
    double asked = REAL_BITS == 53 ? tol : k->options->tolerance;
    const char *why_not = owned_problem_make(c, (real)asked, k->options->solving.max_steps, &owned);
    if (why_not) {
        note(reply, "%s:%d: %s", c->file, c->line_number, why_not);
        json_object_set_new(reply, "bad", json_true());
        return reply;
    }
    run_algorithms(k, c, &owned.problem, tol, reply);
    if (k->options->solving.external)
        run_external(k, c, &owned.problem, tol, reply);
    owned_problem_clear(&owned);
    return reply;
}
