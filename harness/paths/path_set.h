/* Paths in memory: made segment by segment, linked, freed.  Compiled for each precision. */
#ifndef FATLINE_PATH_SET_H
#define FATLINE_PATH_SET_H

#include "../../algorithms/path.h"

struct loaded_path {
    char *id;
    struct path path;
    struct curve *segment;
    unsigned char *plain; /* path.degree */
    real *points;         /* path.points, 64 bytes a segment on addresses that they divide */
    real *coefficient;    /* of all other segments */
    size_t coefficients;
    int degree; /* the largest */
};

/* Zeroed: empty. */
struct path_set {
    int count, room;
    struct loaded_path *at;
};

/* A path in the making. */
struct path_draft {
    char *id;
    int segments, segments_room, subpaths, subpaths_room;
    struct curve *segment; /* without their arrays until the path is done */
    int *begin;            /* first segment of each subpath */
    size_t coefficients, coefficients_room;
    real *coefficient;
};

void path_draft_begin(struct path_draft *d, const char *id);
/* From here on segments belong to another subpath; nothing of it is linked to what came before. */
void path_draft_break(struct path_draft *d);
/* Homogeneous coefficients; w may be NULL.  false: this precision does not hold them (path_takes). */
bool path_draft_add(struct path_draft *d, int degree, const real *x, const real *y, const real *w);
/* Adds the path to the set, linked, and empties the draft. */
void path_draft_end(struct path_draft *d, struct path_set *set);
void path_draft_clear(struct path_draft *d);

void path_set_clear(struct path_set *set);

/* Memory on an address that 64 divides, so that no vector straddles two cache lines. */
void *path_aligned(size_t bytes);

/* Appends a smooth random walk of `count` cubics in the unit square, steps of about 1/sqrt(count); the same
 * for the same seed and index everywhere. */
void path_random(struct path_set *set, const char *id, int count, uint64_t seed, uint64_t index);

#endif
