#include "noise.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static const double stolen_most = 0.01, switches_most = 200; /* share of the time; a second */

static void read_jiffies(double *stolen, double *total)
{
    double field[8] = {0};
    FILE *stream = fopen("/proc/stat", "r");
    *stolen = *total = 0;
    if (stream && fscanf(stream, "cpu %lf %lf %lf %lf %lf %lf %lf %lf", &field[0], &field[1], &field[2],
                         &field[3], &field[4], &field[5], &field[6], &field[7]) == 8) {
        *stolen = field[7];
        for (int i = 0; i < 8; i++)
            *total += field[i];
    }
    if (stream)
        fclose(stream);
}

static long switches(void)
{
    struct rusage own, children;
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &children);
    return own.ru_nivcsw + children.ru_nivcsw;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void noise_begin(struct noise *n)
{
    double load[1];
    n->wall = seconds();
    n->switches = switches();
    n->cpus = (int)sysconf(_SC_NPROCESSORS_ONLN);
    n->load = getloadavg(load, 1) == 1 ? load[0] : 0;
    read_jiffies(&n->stolen, &n->total);
}

/* 1 if the frequency is readable and not held. */
static int warn_of_governor(FILE *stream)
{
    char line[64] = "";
    FILE *file = fopen("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "r");
    if (file && fgets(line, sizeof line, file))
        line[strcspn(line, "\n")] = 0;
    if (file)
        fclose(file);
    if (!line[0] || !strcmp(line, "performance"))
        return 0;
    fprintf(stream,
            "warning: the frequency governor is `%s`, not `performance`: times wander with the frequency\n",
            line);
    return 1;
}

int noise_warn(const struct noise *n, FILE *stream)
{
    double took = seconds() - n->wall, stolen, total,
           rate = (double)(switches() - n->switches) / fmax(took, 1e-9);
    int warnings = warn_of_governor(stream);
    read_jiffies(&stolen, &total);
    if (n->load > 0.5 * n->cpus) {
        fprintf(
            stream,
            "warning: %.1f processes ran on %d processors when this began: other work shares the caches\n",
            n->load, n->cpus);
        warnings++;
    }
    if (total > n->total && (stolen - n->stolen) / (total - n->total) > stolen_most) {
        fprintf(stream, "warning: %.1f%% of the time went to other guests of this host\n",
                100 * (stolen - n->stolen) / (total - n->total));
        warnings++;
    }
    if (took > 1 && rate > switches_most) {
        fprintf(stream, "warning: interrupted %.0f times a second by other processes\n", rate);
        warnings++;
    }
    if (warnings)
        fputs("warning: trust ratios of the same rounds, not the times themselves\n", stream);
    return warnings;
}

static bool floor_path(char path[PATH_MAX])
{
    ssize_t n = readlink("/proc/self/exe", path, PATH_MAX - 32);
    char *end;
    path[n > 0 ? n : 0] = 0;
    end = strrchr(path, '/');
    if (end)
        strcpy(end, "/noise-floor.json");
    return end;
}

double noise_floor(void)
{
    char path[PATH_MAX];
    json_t *row = floor_path(path) ? json_load_file(path, 0, NULL) : NULL;
    const json_t *floor = json_object_get(row, "noise_floor");
    double value = json_is_number(floor) ? json_number_value(floor) : NAN;
    json_decref(row);
    return value;
}

bool noise_floor_save(const json_t *row)
{
    char path[PATH_MAX];
    return floor_path(path) && !json_dump_file(row, path, JSON_COMPACT);
}

void noise_floor_note(json_t *environment)
{
    double floor = noise_floor();
    json_object_set_new(json_object_get(environment, "environment"), "noise_floor",
                        isnan(floor) ? json_null() : json_real(floor));
}
