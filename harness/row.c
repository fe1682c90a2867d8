#include "row.h"

#include "json_text.h"

#include <gmp.h>
#include <gnu/libc-version.h>
#include <mpfr.h>
#include <link.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <arb.h>
#include <flint.h>

#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

static const char unknown[] = "unknown";

/* What follows "key :" on the first such line of a file of /proc or, with key NULL, the file's first line. */
static json_t *file_value(const char *path, const char *key)
{
    char line[512];
    const char *value = NULL;
    FILE *stream = fopen(path, "r");
    while (stream && !value && fgets(line, sizeof line, stream)) {
        line[strcspn(line, "\n")] = 0;
        if (!key)
            value = line;
        else if (!strncmp(line, key, strlen(key)) && strchr(line, ':'))
            value = strchr(line, ':') + 1;
    }
    if (stream)
        fclose(stream);
    json_t *text = json_string(value ? value + strspn(value, " \t") : unknown);
    return text ? text : json_string(unknown);
}

/* Runs argv in `directory` and takes the first line it prints; false if it failed. */
static bool command_line(const char *directory, char *const argv[], char *line, size_t size)
{
    int out[2], status;
    if (pipe(out))
        return false;
    pid_t child = fork();
    if (child == 0) {
        dup2(out[1], STDOUT_FILENO);
        close(out[0]);
        close(out[1]);
        if (!freopen("/dev/null", "w", stderr) || chdir(directory))
            _exit(127);
        execvp(argv[0], argv);
        _exit(127);
    }
    close(out[1]);
    FILE *stream = fdopen(out[0], "r");
    line[0] = 0;
    if (stream && fgets(line, (int)size, stream))
        line[strcspn(line, "\n")] = 0;
    while (stream && fgetc(stream) != EOF)
        ;
    if (stream)
        fclose(stream);
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* commit and whether anything but results differs from it, of the tree that holds this program. */
static void add_commit(json_t *object)
{
    char directory[PATH_MAX] = "", commit[128], change[512];
    char *const head[] = {"git", "rev-parse", "HEAD", NULL};
    char *const changes[] = {"git", "--no-optional-locks",   "status", "--porcelain", "--",
                             ":/",  ":(top,exclude)results", NULL};
    ssize_t n = readlink("/proc/self/exe", directory, sizeof directory - 1);
    directory[n > 0 ? n : 0] = 0;
    char *end = strrchr(directory, '/');
    if (end)
        *end = 0;
    if (!command_line(directory, head, commit, sizeof commit)) {
        json_object_set_new(object, "commit", json_string(unknown));
        json_object_set_new(object, "dirty", json_null());
        return;
    }
    json_object_set_new(object, "commit", json_string(commit));
    bool known = command_line(directory, changes, change, sizeof change);
    json_object_set_new(object, "dirty", known ? json_boolean(change[0] != 0) : json_null());
}

static int add_library(struct dl_phdr_info *info, size_t size, void *list)
{
    char path[PATH_MAX];
    (void)size;
    if (info->dlpi_name && strchr(info->dlpi_name, '/'))
        json_array_append_new(list, json_string(realpath(info->dlpi_name, path) ? path : info->dlpi_name));
    return 0;
}

static json_t *libraries(void)
{
    json_t *list = json_array();
    dl_iterate_phdr(add_library, list);
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:o}", "libc", gnu_get_libc_version(), "gmp",
                     gmp_version, "mpfr", mpfr_get_version(), "flint", flint_version, "arb", arb_version,
                     "jansson", jansson_version_str(), "files", list);
}

static json_t *load_average(void)
{
    double load[3];
    if (getloadavg(load, 3) != 3)
        return json_string(unknown);
    return json_pack("[f, f, f]", load[0], load[1], load[2]);
}

static json_t *arguments(int argc, char **argv)
{
    json_t *list = json_array();
    for (int i = 0; i < argc; i++) {
        json_t *text = json_string(argv[i]);
        json_array_append_new(list, text ? text : json_string("(not UTF-8)"));
    }
    return list;
}

/* How the algorithms of this precision were compiled. */
static const char *flags(const char *precision)
{
    if (!strcmp(precision, "multi"))
        return BUILD_FLAGS_MULTI " -DFATLINE_MULTI";
    return strcmp(precision, "quad") ? BUILD_FLAGS : BUILD_FLAGS " -DFATLINE_QUAD";
}

json_t *row_environment(int argc, char **argv, const char *precision)
{
    struct utsname system;
    char date[32], kernel[256] = "unknown";
    time_t now = time(NULL);
    struct tm utc;
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&now, &utc));
    if (!uname(&system))
        snprintf(kernel, sizeof kernel, "%.80s %.80s %.80s", system.sysname, system.release, system.machine);
    const char *program = argc > 0 && strrchr(argv[0], '/') ? strrchr(argv[0], '/') + 1
                          : argc > 0                        ? argv[0]
                                                            : "";
    json_t *e = json_pack(
        "{s:i, s:s, s:s, s:s, s:o, s:s, s:o, s:i, s:s, s:s, s:s, s:o, s:o, s:o}", "schema", (int)ROW_SCHEMA,
        "run", row_run_id(), "date", date, "program", program, "arguments", arguments(argc, argv),
        "precision", precision, "cpu", file_value("/proc/cpuinfo", "model name"), "cpus",
        (int)sysconf(_SC_NPROCESSORS_ONLN), "kernel", kernel, "compiler", COMPILER, "flags", flags(precision),
        "libraries", libraries(), "governor",
        file_value("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", NULL), "load", load_average());
    add_commit(e);
    json_t *row = json_object();
    json_object_set_new(row, "environment", e);
    return row;
}

static char id[64];

void row_continue_run(const char *other)
{
    snprintf(id, sizeof id, "%s", other ? other : "");
}

const char *row_run_id(void)
{
    if (!id[0]) {
        unsigned bits = 0;
        time_t now = time(NULL);
        struct tm utc;
        if (getrandom(&bits, sizeof bits, 0) != (ssize_t)sizeof bits)
            bits = (unsigned)getpid();
        size_t n = strftime(id, sizeof id, "%Y%m%dT%H%M%SZ-", gmtime_r(&now, &utc));
        snprintf(id + n, sizeof id - n, "%08x", bits);
    }
    return id;
}

void row_write(FILE *stream, json_t *row)
{
    json_object_set_new(row, "run", json_string(row_run_id()));
    json_text_write(stream, row);
    fputc('\n', stream);
    json_decref(row);
}
