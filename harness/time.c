/* `fatline time`: how long each algorithm takes on the pairs that all of them get right. */
#include <argp.h>
#include <errno.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "run/guard.h"
#include "timing/instructions.h"
#include "timing/noise.h"
#include "run/progress.h"
#include "run/resume.h"
#include "run/row.h"
#include "run/standard_output.h"
#include "timing/time_family.h"

const char *argp_program_version = "fatline 0.1";

/* Name of the family of a case: its file without folder and ending, its class, or a field of its line. */
static char *family_name(const struct loaded_case *pair, const char *by)
{
    const char *name = json_string_value(json_object_get(pair->c.line, by)), *base;
    char *copy;

    if (!strcmp(by, "file")) {
        base = strrchr(pair->file, '/');
        copy = strdup(base ? base + 1 : pair->file);
        if (copy && strlen(copy) > 6 && !strcmp(copy + strlen(copy) - 6, ".jsonl"))
            copy[strlen(copy) - 6] = '\0';
    } else {
        if (!strcmp(by, "class"))
            name = pair->c.class_name;
        copy = strdup(name && *name ? name : "none given");
    }
    if (!copy)
        exit(2);
    return copy;
}

static int gather(const struct case_set *set, char *const *name, int first, const struct loaded_case **at)
{
    int count = 0;

    for (int i = first; i < set->count; i++)
        if (!strcmp(name[i], name[first]))
            at[count++] = &set->at[i];
    return count;
}

static bool seen_before(char *const *name, int i)
{
    for (int j = 0; j < i; j++)
        if (!strcmp(name[j], name[i]))
            return true;
    return false;
}

static struct family family_of(const struct time_settings *s, const char *name, int pairs,
                               const struct loaded_case **at, struct timing_memory *memory, int n,
                               const struct contender *contender, int baseline)
{
    struct family f;

    memset((void *)&f, 0, sizeof f);
    f.settings = s;
    f.at = at;
    f.memory = memory;
    f.report.family = name;
    f.report.pairs = pairs;
    f.report.contenders = n;
    f.report.contender = contender;
    f.report.baseline = baseline;
    f.report.limit = s->no_floor ? -1 : n - 1;
    f.report.single = s->single;
    return f;
}

static int time_families(const struct case_set *set, int n, struct contender *contender,
                         const struct time_settings *s, struct timing_memory *memory, int baseline,
                         const struct resume *resume)
{
    const struct loaded_case **at = (const struct loaded_case **)calloc(set->count + 1, sizeof *at);
    char **name = (char **)calloc(set->count + 1, sizeof *name);
    int families = 0, timed = resume->done;
    double seconds = 0;

    if (!at || !name)
        exit(2);
    for (int i = 0; i < set->count; i++) {
        name[i] = family_name(&set->at[i], s->family_by);
        families += !seen_before(name, i);
    }
    if (resume->done)
        progress_note("resumed: %d families are done, %d left", resume->done, families - resume->done);
    if (!s->dry_run)
        progress_begin("time", families - resume->done);
    for (int i = 0; i < set->count; i++) {
        struct family f;

        if (seen_before(name, i) || resume_has(resume, name[i]))
            continue;
        f = family_of(s, name[i], gather(set, name, i, at), at, memory, n, contender, baseline);
        if (s->dry_run) {
            double cost = time_family_estimate(&f);

            printf("%-32s %6d pairs %8.1f s\n", name[i], f.report.pairs, cost);
            seconds += cost;
            timed = 1;
            continue;
        }
        timed += time_family_run(&f, contender, resume->out);
        progress_step();
    }
    if (s->dry_run)
        printf("%d families, %d algorithms: about %.0f s\n", families - resume->done, n, seconds);
    else
        progress_end();
    for (int i = 0; i < set->count; i++)
        free(name[i]);
    free(name);
    free(at);
    return timed;
}

static void pin(int cpu)
{
    cpu_set_t cpus;

    CPU_ZERO(&cpus);
    CPU_SET(cpu, &cpus);
    if (sched_setaffinity(0, sizeof cpus, &cpus)) {
        fprintf(stderr, "fatline: --pin %d: %s\n", cpu, strerror(errno));
        exit(2);
    }
}

static int contenders(const struct time_settings *s)
{
    return s->algorithms.count + s->batch + s->externals + !s->no_floor;
}

/* Starts the external programs; the contenders are the algorithms in order, the batch, then these. */
static void line_up(const struct time_settings *s, struct external *external, struct contender *contender)
{
    int n = 0;

    for (int i = 0; i < s->algorithms.count; i++, n++) {
        contender[n].name = s->algorithms.at[i]->name;
        contender[n].algorithm = s->algorithms.at[i];
    }
    if (s->batch) {
        contender[n].name = s->batch_name;
        contender[n].algorithm = batch_algorithm;
        contender[n].variant = s->variant;
        contender[n++].batch = true;
    }
    for (int i = 0; i < s->externals; i++, n++) {
        const char *error = external_start(&external[i], s->external[i], s->timeout, s->plan.tolerance);

        if (error) {
            fprintf(stderr, "fatline time: %s\n", error);
            exit(2);
        }
        contender[n].name = external[i].name;
        contender[n].external = &external[i];
    }
    if (!s->no_floor) {
        contender[n].name = intersector_floor->name;
        contender[n].algorithm = intersector_floor;
        contender[n].limit = true;
    }
}

/* As `fatline check` solves them: expected.tol is what a sound program in doubles can be held to. */
static void relax(struct case_set *set)
{
    for (int i = 0; i < set->count && REAL_BITS == 53; i++) {
        struct problem *p = &set->at[i].owned.problem;
        p->tolerance = case_tolerance(&set->at[i].c, real_to_double(p->tolerance));
    }
}

static const struct intersector *const nobody[] = {NULL};

static int run(const struct time_settings *s, const struct case_set *set, const struct resume *resume)
{
    int n = contenders(s), baseline = -1, timed;
    struct external *external = (struct external *)calloc(s->externals + 1, sizeof *external);
    struct contender *contender = (struct contender *)calloc(n, sizeof *contender);
    struct timing_memory memory;

    memory.crossings = (struct crossings *)calloc(1, sizeof *memory.crossings);
    if (!external || !contender || !memory.crossings)
        exit(2);
    line_up(s, external, contender);
    for (int k = 0; s->baseline && k < n; k++)
        if (!strcmp(contender[k].name, s->baseline))
            baseline = k;
    if (s->baseline && baseline < 0) {
        fprintf(stderr, "fatline time: --baseline: neither an algorithm nor a program is called %s\n",
                s->baseline);
        exit(64);
    }
    workspace_make(&memory.workspace, s->algorithms.count ? s->algorithms.at : nobody, set->degree_f,
                   set->degree_g, WORKSPACE_ROOM);
    timed = time_families(set, n, contender, s, &memory, baseline, resume);
    workspace_clear(&memory.workspace);
    for (int i = 0; i < s->externals; i++)
        external_stop(&external[i]);
    free(memory.crossings);
    free(contender);
    free(external);
    return timed > 0 ? 0 : 1;
}

/* Drops the cases that were not asked for. */
static void keep_selected(struct case_set *set, const struct selection *cases)
{
    int kept = 0;

    for (int i = 0; i < set->count; i++) {
        struct loaded_case drop = set->at[i];

        if (selection_takes(cases, &drop.c)) {
            set->at[i] = set->at[kept];
            set->at[kept++] = drop;
        }
    }
    case_set_shorten(set, kept);
}

/* Of rows as they come: the family. */
static char *group_of(const json_t *row)
{
    const char *family = json_string_value(json_object_get(row, "family"));

    return family ? strdup(family) : NULL;
}

/* Rows, or a table; what disturbed the clock is said at the end. */
static int measure(int argc, char **argv, const struct time_settings *s, const struct case_set *set)
{
    struct resume_rule rule = {group_of, contenders(s), NULL};
    struct resume resume;
    struct noise noise;
    int status = 0;

    memset((void *)&resume, 0, sizeof resume);
    resume.out = stdout;
    noise_begin(&noise);
    if (!s->human && !s->dry_run) {
        json_t *environment = row_environment(argc, argv, REAL_NAME);

        json_object_set_new(json_object_get(environment, "environment"), "seed",
                            json_integer((json_int_t)s->plan.clock.seed));
        noise_floor_note(environment);
        status = resume_open(&resume, s->output, s->resume, &rule, environment);
        if (status)
            fprintf(stderr, "fatline time: %s\n", resume.error);
    }
    if (!status)
        status = run(s, set, &resume);
    if (!resume_close(&resume)) {
        fprintf(stderr, "fatline time: %s: %s\n", s->output, strerror(errno));
        status = 2;
    }
    if (!s->dry_run)
        noise_warn(&noise, stderr);
    return status;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    struct case_set set = {0, 0, NULL, 0, NULL, 0, 0};
    struct time_settings s;
    int status = 0;

    time_settings_read(argc, argv, &s);
    guard_set_timeout(s.timeout);
    if (s.cpu >= 0)
        pin(s.cpu);
    if (s.count_instructions && instructions_missing()) {
        fprintf(stderr, "fatline time: --count instructions: %s\n", instructions_missing());
        status = 2;
    }
    for (int i = 0; i < selection_files(&s.cases) && status != 2; i++) {
        int wrong = case_set_read(&set, selection_file(&s.cases, i), s.plan.tolerance, s.max_steps);

        status = wrong ? wrong : status;
    }
    keep_selected(&set, &s.cases);
    if (!status && !set.count)
        status = selection_complain(&s.cases, "fatline time");
    if (!status) {
        relax(&set);
        status = measure(argc, argv, &s, &set);
    }
    case_set_clear(&set);
    time_settings_clear(&s);
    return status;
}
