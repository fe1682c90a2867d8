#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/problem.h"
#include "../timing/clock.h"
#include "path_job.h"

enum { BLOCK = 8192, SINGLES = 65536 };

static size_t bytes_of(const struct loaded_path *p)
{
    size_t segments = (size_t)p->path.count;

    return segments * (sizeof(struct curve) + 2 * sizeof(int)) + p->coefficients * sizeof(real) +
           path_tree_size(p->path.count);
}

void path_job_make(struct path_job *job, const struct loaded_path *a, const struct loaded_path *b,
                   real tolerance, int max_steps)
{
    const struct intersector *used[] = {path_pairs, path_loops, NULL};
    int degree = b && b->degree > a->degree ? b->degree : a->degree;

    memset((void *)job, 0, sizeof *job);
    job->a = a;
    job->b = b;
    workspace_make(&job->workspace, used, degree, degree, 1);
    path_solver_init(&job->solver, &a->path, b ? &b->path : NULL, &job->workspace,
                     (struct crossings *)path_memory(NULL, sizeof(struct crossings)));
    job->solver.tolerance = tolerance;
    job->solver.max_steps = max_steps;
    job->memory_a = path_memory(NULL, path_tree_size(a->path.count));
    job->memory_b = b ? path_memory(NULL, path_tree_size(b->path.count)) : NULL;
    job->walk = (struct path_walk *)path_memory(NULL, sizeof *job->walk);
    job->block = (struct path_pair *)path_memory(NULL, BLOCK * sizeof *job->block);
    job->room = 4 * PATH_RECORDS_LEAST;
    job->record = (struct path_record *)path_memory(NULL, (size_t)job->room * sizeof *job->record);
}

void path_job_clear(struct path_job *job)
{
    workspace_clear(&job->workspace);
    free((void *)job->solver.crossings);
    free(job->memory_a);
    free(job->memory_b);
    free(job->numbers);
    free(job->walk);
    free(job->block);
    free((void *)job->record);
}

/* Adds to *sum what went by since *from. */
static void lap(double *from, double *sum)
{
    double now = clock_now(false);

    *sum += now - *from;
    *from = now;
}

/* Room for the records of one more pair at least. */
static void grow(struct path_job *job)
{
    if (job->room - job->records >= PATH_RECORDS_LEAST)
        return;
    job->room += job->room / 2;
    job->record = (struct path_record *)path_memory(job->record, (size_t)job->room * sizeof *job->record);
}

static void begin(struct path_job *job)
{
    struct path_solver *z = &job->solver;

    z->solved = z->passed = z->looped = z->unsolved = 0;
    z->worst = SOLVED;
    job->records = 0;
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
            grow(job);
            done += path_solve(&job->solver, job->block + done, count - done, job->record, &job->records,
                               job->room);
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
        grow(job);
        i += path_solve_loops(&job->solver, i, count - i > SINGLES ? i + SINGLES : count, job->record,
                              &job->records, job->room);
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
    size_t numbers = path_join_size(job->a->path.count, count_b, job->records);
    if (numbers > job->numbers_room)
        job->numbers = path_memory(job->numbers, job->numbers_room = numbers);
    job->found = job->records;
    job->bytes = bytes_of(job->a) + (job->b ? bytes_of(job->b) : 0) + BLOCK * sizeof *job->block +
                 sizeof *job->walk + (size_t)job->room * sizeof *job->record + job->numbers_room;
    job->records = path_records_join(&job->solver, job->record, job->records, job->numbers);
    lap(&clock, &job->times.join);
    return true;
}
