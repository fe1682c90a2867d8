#include "cost_law.h"

#include <math.h>
#include <stdlib.h>

#include "regression.h"

/* A smaller exponent is no power that these ladders could tell from a logarithm. */
static const double POWER_LEAST = 0.05;

const char *cost_model_name(enum cost_model model)
{
    static const char *const names[] = {"logarithmic", "power", "too_few"};
    return names[model];
}

/* Least squares of (c + b x - y) / y; the rms is of log2 of the ratio, infinite where the model is not
 * positive. */
static void fit_logarithmic(int n, const double *x, const double *y, struct cost_law *law)
{
    double one = 0, a = 0, aa = 0, r = 0, ar = 0, rest = 0;
    for (int i = 0; i < n; i++) {
        double w = 1 / (y[i] * y[i]);
        one += w;
        a += w * x[i];
        aa += w * x[i] * x[i];
        r += w * y[i];
        ar += w * x[i] * y[i];
    }
    law->b = (one * ar - a * r) / (one * aa - a * a);
    law->c = (r - law->b * a) / one;
    for (int i = 0; i < n; i++) {
        double model = law->c + law->b * x[i], d = model > 0 ? log2(model / y[i]) : INFINITY;
        rest += d * d;
    }
    law->rms_logarithmic = sqrt(rest / n);
}

struct cost_law cost_law_fit(int n, const double *bits, const double *steps)
{
    struct cost_law law = {FEW, NAN, NAN, NAN, NAN, NAN, NAN, NAN, n};
    int first = n / 4, count = n - first;
    law.points = count;
    if (count < COST_POINTS_LEAST)
        return law;
    double *y = malloc((size_t)count * sizeof *y);
    if (!y)
        exit(2);
    for (int i = 0; i < count; i++)
        y[i] = log2(steps[first + i]);
    struct line_fit power = line_fit(count, bits + first, y);
    free(y);
    fit_logarithmic(count, bits + first, steps + first, &law);
    law.p = power.slope;
    law.lo = power.lo;
    law.hi = power.hi;
    law.rms_power = power.rms;
    law.model = LOGARITHMIC;
    if (law.rms_power < law.rms_logarithmic && law.lo > POWER_LEAST) {
        law.model = POWER;
        law.c = exp2(power.intercept);
        law.b = NAN;
    }
    return law;
}
