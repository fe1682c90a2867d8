/* bezier_clipping made slower by PLANTED percent, for a build that `fatline compare` must find out (linked
 * before the library, whose own it replaces; that is here under the name plain_bezier_clipping). */
#include "../algorithms/bezier.h"

#include <x86intrin.h>

#ifndef PLANTED
#define PLANTED 5
#endif

extern const struct intersector plain_bezier_clipping, bezier_clipping;

/* Of a hundred calls, drawn by a linear congruence, PLANTED take as much longer as such a call takes on
 * average. */
static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    static unsigned drawn = 1;
    static double mean, calls;
    drawn = 1664525 * drawn + 1013904223;
    if ((drawn >> 16) % 100 >= PLANTED) {
        return plain_bezier_clipping.intersect(p, w, out);
    }
    unsigned long long start = __rdtsc();
    enum outcome outcome = plain_bezier_clipping.intersect(p, w, out);
    unsigned long long end = __rdtsc();
    if (calls < 100 || (double)(end - start) < 10 * mean) { /* else we were interrupted */
        calls = calls + 1;
        mean = mean + ((double)(end - start) - mean) / calls;
    }
    while ((double)(__rdtsc() - end) < mean) {
    }
    return outcome;
}

const struct intersector bezier_clipping = {"bezier_clipping",
                                            "a planted slowdown",
                                            "none: for a test",
                                            {0, 0, 0, 0},
                                            intersect,
                                            NULL,
                                            false,
                                            false,
                                            NULL};
