#include "check_estimate.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "check_case.h"
#include "check_worker.h"

enum { SAMPLE = 20 };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Every `stride`th line of the file; how many were checked. */
static int check_some(struct checker *k, const char *path, long stride, long *line)
{
    FILE *stream = check_open_cases(path);
    char *text = NULL, error[512];
    size_t size = 0;
    int checked = 0;
    while (stream && getline(&text, &size, stream) >= 0) {
        struct test_case c;
        if (check_line_is_blank(text) || (*line)++ % stride ||
            case_parse(text, path, 0, &c, error) != CASE_READ)
            continue;
        json_decref(checker_run(k, &c));
        case_clear(&c);
        checked++;
    }
    free(text);
    if (stream)
        fclose(stream);
    return checked;
}

int check_estimate(const struct check_options *o, long lines)
{
    struct checker k;
    const char *error = checker_open(&k, o);
    double start = seconds();
    long stride = (lines + SAMPLE - 1) / SAMPLE, line = 0;
    int checked = 0;
    if (error) {
        fprintf(stderr, "fatline check: %s\n", error);
        return 2;
    }
    for (int i = 0; i < (o->file_count ? o->file_count : 1); i++)
        checked += check_some(&k, o->file_count ? o->files[i] : "-", stride > 0 ? stride : 1, &line);
    double each = checked ? (seconds() - start) / checked : 0;
    printf("%ld cases, %d algorithms: about %.1f s in %d processes (from %d cases)\n", lines,
           o->algorithms.count + (o->external != NULL), each * (double)lines / o->jobs, o->jobs, checked);
    checker_close(&k);
    return 0;
}
