/* A path as fatline.h has it, made one as path.h has it. */
#ifndef FATLINE_LIBRARY_PATHS_H
#define FATLINE_LIBRARY_PATHS_H

#include "../path.h"
#include "library.h"

/* Its arrays lie in memory that path_take was given. */
struct taken_path {
    struct path path;
    int degree; /* the largest, at least 1 */
};

/* Bytes, a multiple of 64, for what path_take makes; 0: there is no such path. */
size_t path_taken_size(const struct fatline_path *p);

/* NULL, or what is wrong with p, the first path or the second, and with which segment (-1: with none). */
const char *path_error(const struct fatline_path *p, bool second, int *segment);

/* memory: path_taken_size bytes at an address that 64 divides; p: without error. */
void path_take(const struct fatline_path *p, void *memory, struct taken_path *out);

#endif
