#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../timing/clock.h"
#include "path_job.h"
#include "../run/memory.h"

enum { BLOCK = 8192, SINGLES = 65536 };

static size_t bytes_of(const struct loaded_path *p)
{
    size_t segments = (size_t)p->path.count;

    return segments * (sizeof(struct curve) + 1 + 2 * sizeof(int) + BATCH_NUMBERS * sizeof(real)) +
           p->coefficients * sizeof(real) + path_tree_size(p->path.count);
}

void path_job_make(struct path_job *job, const struct loaded_path *a, const struct loaded_path *b,
                   real tolerance, int max_steps)
{
    int degree = b && b->degree > a->degree ? b->degree : a->degree;

    memset((void *)job, 0, sizeof *job);
    job->a = a;
    job->b = b;
    job->solver_bytes = path_solver_size(degree);
    job->solver_memory = path_aligned(job->solver_bytes);
    path_solver_init(&job->solver, &a->path, b ? &b->path : NULL, degree, tolerance, max_steps,
                     job->solver_memory);
    job->memory_a = path_aligned(path_tree_size(a->path.count));
    job->memory_b = b ? path_aligned(path_tree_size(b->path.count)) : NULL;
    job->walk = (struct path_walk *)memory_resized(NULL, sizeof *job->walk);
    job->block = (struct path_pair *)memory_resized(NULL, BLOCK * sizeof *job->block);
}

void path_job_clear(struct path_job *job)
{
    free(job->solver_memory);
    free(job->memory_a);
    free(job->memory_b);
    free(job->numbers);
    free(job->walk);
    free(job->block);
    free((void *)job->records.at);
    free((void *)job->records.overlap);
}

/* Adds to *sum what went by since *from. */
static void lap(double *from, double *sum)
{
    double now = clock_now(false);

    *sum += now - *from;
    *from = now;
}

/* Room for one more pair at least. */
static void grow(struct path_records *r)
{
    if (r->room - r->count < PATH_RECORDS_LEAST) {
        r->room += r->room / 2 + PATH_RECORDS_LEAST;
        r->at = (struct path_record *)memory_resized(r->at, (size_t)r->room * sizeof *r->at);
    }
    if (r->overlap_room - r->overlaps < PATH_OVERLAPS_LEAST) {
        r->overlap_room += r->overlap_room / 2 + PATH_OVERLAPS_LEAST;
        r->overlap =
            (struct path_overlap *)memory_resized(r->overlap, (size_t)r->overlap_room * sizeof *r->overlap);
    }
}

static void begin(struct path_job *job)
{
    struct path_solver *z = &job->solver;

    z->solved = z->passed = z->looped = z->unsolved = 0;
    z->worst = SOLVED;
    job->records.count = job->records.overlaps = 0;
    job->candidates = 0;
    memset(&job->times, 0, sizeof job->times);
    path_tree_make(&job->tree_a, &job->a->path, job->memory_a);
    if (job->b)
        path_tree_make(&job->tree_b, &job->b->path, job->memory_b);
    path_walk_begin(job->walk, &job->tree_a, job->b ? &job->tree_b : &job->tree_a);
}

static bool solve_pairs(struct path_job *job, double *clock, const volatile int *stop)
{
    int count;

    while ((count = path_walk_next(job->walk, job->block, BLOCK)) > 0) {
        lap(clock, &job->times.walk);
        job->candidates += count;
        for (int done = 0; done < count;) {
            if (*stop)
                return false;
            grow(&job->records);
            done += path_solve(&job->solver, job->block + done, count - done, &job->records);
        }
        lap(clock, &job->times.solve);
    }
    lap(clock, &job->times.walk);
    return true;
}

static bool solve_singles(struct path_job *job, double *clock, const volatile int *stop)
{
    for (int i = 0, count = job->b ? 0 : job->a->path.count; i < count;) {
        if (*stop)
            return false;
        grow(&job->records);
        i += path_solve_loops(&job->solver, i, count - i > SINGLES ? i + SINGLES : count, &job->records);
    }
    lap(clock, &job->times.solve);
    return true;
}

bool path_job_run(struct path_job *job, const volatile int *stop)
{
    double clock = clock_now(false);
    int count_b = job->b ? job->b->path.count : 0;

    begin(job);
    lap(&clock, &job->times.build);
    if (!solve_pairs(job, &clock, stop) || !solve_singles(job, &clock, stop))
        return false;
    size_t numbers = path_join_size(job->a->path.count, count_b, job->records.count);
    if (numbers > job->numbers_room)
        job->numbers = memory_resized(job->numbers, job->numbers_room = numbers);
    job->found = job->records.count;
    job->bytes = bytes_of(job->a) + (job->b ? bytes_of(job->b) : 0) + BLOCK * sizeof *job->block +
                 sizeof *job->walk + job->solver_bytes + (size_t)job->records.room * sizeof *job->records.at +
                 (size_t)job->records.overlap_room * sizeof *job->records.overlap + job->numbers_room;
    path_records_join(&job->solver, &job->records, job->numbers);
    lap(&clock, &job->times.join);
    return true;
}
