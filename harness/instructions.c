#include "instructions.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "number.h"

static bool repeat_path(char path[PATH_MAX])
{
    ssize_t n = readlink("/proc/self/exe", path, PATH_MAX - 32);
    char *end;
    path[n > 0 ? n : 0] = 0;
    end = strrchr(path, '/');
    if (end)
        strcpy(end, "/fatline-repeat");
    return end && !access(path, X_OK);
}

const char *instructions_missing(void)
{
    char path[PATH_MAX];
    if (system("command -v valgrind >/dev/null 2>&1"))
        return "valgrind is not installed";
    return repeat_path(path) ? NULL : "fatline-repeat is not built";
}

/* Instructions within problem_solve, of one pass; 0: it failed. */
static double count_run(const char *program, const char *algorithm, const char *file, int max_steps)
{
    char command[3 * PATH_MAX], line[512];
    double count = 0;
    FILE *stream;
    snprintf(command, sizeof command,
             "valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=problem_solve '%s' "
             "--algorithm"
             " '%s' --own-tolerance --max-steps %d '%s' 2>&1",
             program, algorithm, max_steps, file);
    stream = popen(command, "r");
    while (stream && fgets(line, sizeof line, stream)) {
        const char *at = strstr(line, "Collected : ");
        if (at)
            count = strtod(at + strlen("Collected : "), NULL);
    }
    return stream && pclose(stream) == 0 ? count : 0;
}

/* The lines of the chosen pairs, each with the tolerance that it is solved at. */
static int write_pairs(FILE *stream, const struct loaded_case *const *at, const int *index, int pairs)
{
    int stride = (pairs + INSTRUCTIONS_PAIRS - 1) / INSTRUCTIONS_PAIRS, written = 0;
    for (int i = 0; i < pairs; i += stride, written++) {
        json_t *line = json_deep_copy(at[index[i]]->c.line);
        json_object_set_new(line, "tolerance",
                            json_real(real_to_double(at[index[i]]->owned.problem.tolerance)));
        json_dumpf(line, stream, JSON_COMPACT);
        fputc('\n', stream);
        json_decref(line);
    }
    return written;
}

double instructions_count(const struct intersector *a, const struct loaded_case *const *at, const int *index,
                          int pairs, int max_steps)
{
    char program[PATH_MAX], file[] = "/tmp/fatline-pairs-XXXXXX";
    int descriptor = mkstemp(file), written = 0;
    FILE *stream = descriptor >= 0 ? fdopen(descriptor, "w") : NULL;
    double count = 0;
    if (stream) {
        written = write_pairs(stream, at, index, pairs);
        fclose(stream);
    }
    if (written && repeat_path(program))
        count = count_run(program, a->name, file, max_steps);
    if (descriptor >= 0)
        remove(file);
    return count > 0 ? count / written : NAN;
}
