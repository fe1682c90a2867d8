/* See statistics.h. */
#include "statistics.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/random.h"
#include "../run/memory.h"

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static double *sorted_copy(int n, const double *x)
{
    double *copy = memory_new(n, sizeof *copy);

    memcpy(copy, x, n * sizeof *copy);
    qsort(copy, n, sizeof *copy, compare);
    return copy;
}

double statistics_min(int n, const double *x)
{
    double least = x[0];

    for (int i = 1; i < n; i++)
        least = fmin(least, x[i]);
    return least;
}

double statistics_median(int n, const double *x)
{
    double *sorted = sorted_copy(n, x);
    double median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;

    free(sorted);
    return median;
}

double statistics_quantile(int n, const double *x, double q)
{
    double *sorted = sorted_copy(n, x), at = q * (n - 1), value;
    int below = (int)at, above = below < n - 1 ? below + 1 : below;

    value = sorted[below] + (at - below) * (sorted[above] - sorted[below]);
    free(sorted);
    return value;
}

struct outliers statistics_outliers(int n, const double *x)
{
    double lower = statistics_quantile(n, x, 0.25), upper = statistics_quantile(n, x, 0.75),
           spread = upper - lower;
    struct outliers found = {0, 0};

    for (int i = 0; i < n; i++) {
        double beyond = fmax(lower - x[i], x[i] - upper);

        found.severe += beyond > 3 * spread;
        found.mild += beyond > 1.5 * spread && beyond <= 3 * spread;
    }
    return found;
}

double statistics_mad(int n, const double *x)
{
    double median = statistics_median(n, x), *away = memory_new(n, sizeof *away), mad;

    for (int i = 0; i < n; i++)
        away[i] = fabs(x[i] - median);
    mad = statistics_median(n, away);
    free(away);
    return mad;
}

/* Median of n draws from sorted[0..n-1] with replacement; drawn[0..n-1] is scratch.  Counting how often each
 * is drawn sorts the resample in n steps. */
static double resample_median(int n, const double *sorted, int *drawn, struct random_state *random)
{
    int lower = (n - 1) / 2, upper = n / 2, seen = 0, i = 0;
    double median;

    memset(drawn, 0, n * sizeof *drawn);
    for (int k = 0; k < n; k++)
        drawn[random_between(random, 0, n - 1)]++;
    while ((seen += drawn[i]) <= lower)
        i++;
    median = sorted[i];
    while (seen <= upper)
        seen += drawn[++i];
    return (median + sorted[i]) / 2;
}

struct range statistics_bootstrap_median(int n, const double *x, double level, uint64_t seed)
{
    enum { LAST = STATISTICS_RESAMPLES - 1 };
    struct random_state random = random_for(seed, "bootstrap", (uint64_t)n);
    double *sorted = sorted_copy(n, x), *medians = memory_new(STATISTICS_RESAMPLES, sizeof *medians);
    int *drawn = memory_new(n, sizeof *drawn);
    struct range range;

    for (int k = 0; k <= LAST; k++)
        medians[k] = resample_median(n, sorted, drawn, &random);
    qsort(medians, STATISTICS_RESAMPLES, sizeof *medians, compare);
    range.lo = medians[(int)floor((1 - level) / 2 * LAST)];
    range.hi = medians[(int)ceil((1 + level) / 2 * LAST)];
    free(drawn);
    free(medians);
    free(sorted);
    return range;
}
