/* See foreign_files.h. */
#include "foreign_files.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LEVELS = 3 }; /* build/double/tests/test_X is the deepest program */

bool foreign_path(const char *file, char *path)
{
    const char *given = getenv("FATLINE_PEERS");
    char folder[PATH_MAX];
    ssize_t n;

    if (given) {
        return snprintf(path, PATH_MAX, "%s/%s", given, file) < PATH_MAX && !access(path, R_OK);
    }
    n = readlink("/proc/self/exe", folder, sizeof folder - 1);
    folder[n > 0 ? n : 0] = '\0';
    for (int i = 0; i < LEVELS; i++) {
        char *end = strrchr(folder, '/');
        if (!end) {
            return false;
        }
        *end = '\0';
        if (snprintf(path, PATH_MAX, "%s/peers/%s", folder, file) < PATH_MAX && !access(path, R_OK)) {
            return true;
        }
    }
    return false;
}
