#include "check_estimate.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "check_case.h"
#include "check_worker.h"

enum { SAMPLE = 20, FAILED = 2 };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Calls `take` with every case of the files that is asked for; bad lines are passed over.  0 or an exit
 * status. */
static int each_case(const struct check_options *o, void (*take)(void *data, struct test_case *c), void *data)
{
    struct sampler sampler;
    char *text = NULL, error[512];
    size_t size = 0;
    int status = 0;
    sampler_begin(&sampler, o);
    for (int i = 0; i < selection_files(&o->cases); i++) {
        const char *path = selection_file(&o->cases, i);
        FILE *stream = check_open_cases(path);
        if (!stream) {
            fprintf(stderr, "%s: %s\n", path, strerror(errno));
            status = FAILED;
        }
        while (stream && getline(&text, &size, stream) >= 0) {
            struct test_case c;
            if (check_line_is_blank(text) || case_parse(text, path, 0, &c, error) != CASE_READ)
                continue;
            if (sampler_takes(&sampler, &c))
                take(data, &c);
            case_clear(&c);
        }
        if (stream)
            fclose(stream);
    }
    sampler_end(&sampler);
    free(text);
    return status;
}

static void count(void *data, struct test_case *c)
{
    (void)c;
    ++*(long *)data;
}

/* Every `stride`th case is checked. */
struct trial {
    struct checker checker;
    long stride, seen;
    int checked;
};

static void try_case(void *data, struct test_case *c)
{
    struct trial *t = (struct trial *)data;
    if (t->seen++ % t->stride)
        return;
    json_decref(checker_run(&t->checker, c));
    t->checked++;
}

int check_estimate(const struct check_options *o)
{
    struct trial t;
    long cases = 0;
    int status = each_case(o, count, &cases);
    if (status)
        return status;
    if (!cases)
        return selection_complain(&o->cases, "fatline check");
    memset((void *)&t, 0, sizeof t);
    t.stride = (cases + SAMPLE - 1) / SAMPLE;
    const char *error = checker_open(&t.checker, o);
    double start = seconds();
    if (error) {
        fprintf(stderr, "fatline check: %s\n", error);
        return FAILED;
    }
    each_case(o, try_case, &t);
    double each = t.checked ? (seconds() - start) / t.checked : 0;
    printf("%ld cases, %d algorithms: about %.1f s in %d processes (from %d cases)\n", cases,
           o->solving.algorithms.count + (o->solving.external != NULL), each * (double)cases / o->jobs,
           o->jobs, t.checked);
    checker_close(&t.checker);
    return 0;
}
