/* `fatline time`: how long each algorithm takes on the pairs that all of them get right. */
#include <argp.h>
#include <errno.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"
#include "row.h"
#include "time_options.h"
#include "timing_rows.h"

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

/* Number of contenders timed on the family. */
static int time_family(const char *family, int pairs, const struct loaded_case **at, int n,
                       const struct contender *contender, const struct time_settings *s,
                       struct timing_memory *memory, int baseline)
{
    struct timing *timing = (struct timing *)calloc(n, sizeof *timing);
    int left_out, timed = 0;

    if (!timing)
        exit(2);
    timing_run(pairs, at, n, contender, &s->plan, memory, timing, &left_out);
    for (int k = 0; k < n; k++) {
        timed += timing[k].pairs > 0;
        if (!timing[k].pairs && left_out < pairs && !s->human)
            progress_note("%s: %s %s: not timed: %s", family, contender[k].name, REAL_NAME,
                          timing[k].why_not);
    }
    if (left_out == pairs)
        progress_note("%s: not timed: no pair has a known answer (see `fatline truth`, or --unchecked)",
                      family);
    else if (s->human)
        timing_table_write(stdout, family, pairs, left_out, n, contender, timing, &s->plan, baseline);
    else
        timing_rows_write(stdout, family, pairs, left_out, n, contender, timing, &s->plan, baseline);
    for (int k = 0; k < n; k++)
        timing_clear(&timing[k]);
    free(timing);
    return timed;
}

static int time_families(const struct case_set *set, int n, const struct contender *contender,
                         const struct time_settings *s, struct timing_memory *memory, int baseline)
{
    const struct loaded_case **at = (const struct loaded_case **)calloc(set->count + 1, sizeof *at);
    char **name = (char **)calloc(set->count + 1, sizeof *name);
    int families = 0, timed = 0;

    if (!at || !name)
        exit(2);
    for (int i = 0; i < set->count; i++) {
        name[i] = family_name(&set->at[i], s->family_by);
        families += !seen_before(name, i);
    }
    progress_begin("time", families);
    for (int i = 0; i < set->count; i++) {
        if (seen_before(name, i))
            continue;
        timed += time_family(name[i], gather(set, name, i, at), at, n, contender, s, memory, baseline);
        progress_step();
    }
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

/* Starts the external programs; the contenders are the algorithms in order, then these. */
static void line_up(const struct time_settings *s, struct external *external, struct contender *contender)
{
    int n = 0;

    for (int i = 0; i < s->algorithms.count; i++, n++) {
        contender[n].name = s->algorithms.at[i]->name;
        contender[n].algorithm = s->algorithms.at[i];
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

static int run(const struct time_settings *s, const struct case_set *set)
{
    int n = s->algorithms.count + s->externals, baseline = -1, timed;
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
    workspace_make(&memory.workspace, s->algorithms.count ? s->algorithms.at : nobody, set->degree_f,
                   set->degree_g, WORKSPACE_ROOM);
    timed = time_families(set, n, contender, s, &memory, baseline);
    workspace_clear(&memory.workspace);
    for (int i = 0; i < s->externals; i++)
        external_stop(&external[i]);
    free(memory.crossings);
    free(contender);
    free(external);
    return timed > 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    struct case_set set = {0, 0, NULL, 0, NULL, 0, 0};
    struct time_settings s;
    int status = 0;

    time_settings_read(argc, argv, &s);
    if (s.cpu >= 0)
        pin(s.cpu);
    for (int i = 0; i < s.files && status != 2; i++) {
        int wrong = case_set_read(&set, s.file[i], s.plan.tolerance, s.max_steps);

        status = wrong ? wrong : status;
    }
    if (!status && !set.count) {
        fprintf(stderr, "fatline time: no cases\n");
        status = 65;
    }
    if (!status) {
        relax(&set);
        if (!s.human)
            row_write(stdout, row_environment(argc, argv, REAL_NAME));
        status = run(&s, &set);
    }
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "fatline time: writing the rows: %s\n", strerror(errno));
        status = 2;
    }
    case_set_clear(&set);
    time_settings_clear(&s);
    return status;
}
