#include "region_time.h"

#include "../timing/clock.h"

enum { ROUNDS = 5 };

static double batch(const struct region_problem *p, const struct region_method *m, struct region_workspace *w,
                    struct region *out, long times)
{
    double start = clock_now(false);
    for (long i = 0; i < times; i++) {
        region_solve(p, m, w, out);
        clock_keep(out);
    }
    return clock_now(false) - start;
}

double region_time(const struct region_problem *p, const struct region_method *m, struct region_workspace *w,
                   struct region *out)
{
    const double enough = 1e6 + (double)CLOCK_TICKS * clock_tick(false);
    double best = 0;
    long times = 1;
    while (batch(p, m, w, out, times) < enough)
        times *= 2;
    for (int i = 0; i < ROUNDS; i++) {
        double ns = batch(p, m, w, out, times) / (double)times;
        best = i == 0 || ns < best ? ns : best;
    }
    return best;
}
