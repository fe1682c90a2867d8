/* Two paths, or one, from trees to joined records, with the time of each stage.  Compiled for each precision.
 */
#ifndef FATLINE_PATH_JOB_H
#define FATLINE_PATH_JOB_H

#include "path_set.h"

/* CPU nanoseconds. */
struct path_times {
    double build, walk, solve, join;
};

struct path_job {
    const struct loaded_path *a, *b; /* b: NULL for a against itself */
    struct path_solver solver;
    void *solver_memory;
    size_t solver_bytes;
    struct path_tree tree_a, tree_b;
    void *memory_a, *memory_b, *numbers;
    size_t numbers_room;
    struct path_walk *walk;
    struct path_pair *block;
    struct path_records records;
    long candidates, found; /* pairs of segments; records before they were joined */
    struct path_times times;
    size_t bytes; /* most that was allocated at once for the paths, trees, pairs and records */
};

void path_job_make(struct path_job *job, const struct loaded_path *a, const struct loaded_path *b,
                   real tolerance, int max_steps);
/* Everything anew, in memory kept from the run before.  stop: looked at between blocks; false: it was set,
 * and there are no records. */
bool path_job_run(struct path_job *job, const volatile int *stop);
void path_job_clear(struct path_job *job);

#endif
