/* fatline paths: where paths of many curves cross each other, or themselves. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <argp.h>

#include "paths/path_job.h"
#include "paths/path_options.h"
#include "paths/path_read.h"
#include "paths/path_rows.h"
#include "paths/path_timing.h"
#include "run/interrupt.h"
#include "run/progress.h"
#include "run/row.h"
#include "run/standard_output.h"

enum { OK = 0, FAILED = 2, BAD_DATA = 65 };

/* a with b, or with itself if b is NULL. */
static int run_one(FILE *out, const struct path_options *o, const struct loaded_path *a,
                   const struct loaded_path *b)
{
    struct path_job job;
    int result = OK;
    path_job_make(&job, a, b, o->tolerance, o->max_steps);
    if (o->time) {
        result = path_timing_write(out, &job, o, &interrupted) ? OK : FAILED;
    } else if (path_job_run(&job, &interrupted)) {
        path_rows_write(out, &job);
        if (!o->quiet)
            path_summary_write(&job);
    }
    path_job_clear(&job);
    return result;
}

static int run_all(FILE *out, const struct path_options *o, const struct path_set *a,
                   const struct path_set *b)
{
    int worst = OK;
    for (int i = 0; i < a->count && !interrupted && worst == OK; i++) {
        if (o->print)
            path_write(out, &a->at[i]);
        else if (!b)
            worst = run_one(out, o, &a->at[i], NULL);
        for (int k = 0; b && !o->print && k < b->count && !interrupted && worst == OK; k++)
            worst = run_one(out, o, &a->at[i], &b->at[k]);
    }
    for (int k = 0; b && o->print && k < b->count && !interrupted; k++)
        path_write(out, &b->at[k]);
    return worst;
}

/* 0 or an exit status: a file without a path is one. */
static int read_file(struct path_set *set, const char *file)
{
    int status = path_set_read(set, file);
    if (status == OK && set->count == 0) {
        progress_note("fatline paths: no path in %s", strcmp(file, "-") ? file : "standard input");
        status = BAD_DATA;
    }
    return status;
}

static void make_random(const struct path_options *o, struct path_set *a, struct path_set *b)
{
    char id[2][64];
    for (int k = 0; k < 2; k++)
        snprintf(id[k], sizeof id[k], "random-%d-%llu-%d", o->random, (unsigned long long)o->seed, k);
    path_random(a, id[0], o->random, o->seed, 0);
    if (!o->alone)
        path_random(b, id[1], o->random, o->seed, 1);
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    struct path_options options;
    struct path_set a = {0, 0, NULL}, b = {0, 0, NULL};
    int read = OK, result = OK;
    path_options_read(argc, argv, &options);
    interrupt_watch(NULL);
    FILE *out = options.output ? fopen(options.output, "w") : stdout;
    if (!out) {
        fprintf(stderr, "%s: %s\n", options.output, strerror(errno));
        return FAILED;
    }
    for (int k = 0; k < 2 && options.files[k] && read != FAILED; k++) {
        int status = read_file(k ? &b : &a, options.files[k]);
        read = status ? status : read;
    }
    if (options.random)
        make_random(&options, &a, &b);
    if (options.time && read == OK)
        row_write(out, row_environment(argc, argv, REAL_NAME));
    if (read == OK)
        result = run_all(out, &options, &a, b.count > 0 || options.files[1] ? &b : NULL);
    path_set_clear(&a);
    path_set_clear(&b);
    bool bad = out != stdout && ferror(out);
    if (out != stdout)
        bad = fclose(out) || bad;
    if (bad)
        fprintf(stderr, "%s: cannot be written\n", options.output);
    return interrupted ? INTERRUPTED : bad ? FAILED : read != OK ? read : result;
}
