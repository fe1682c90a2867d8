#include "regression.h"

#include <math.h>

/* Quantile 0.975 of Student's distribution; above 30 degrees of freedom by its expansion in 1/df, which is
 * then right to 1e-4. */
static double student(int df)
{
    static const double table[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                   2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                   2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
    const double z = 1.959964;
    if (df < 1)
        return INFINITY;
    return df <= 30 ? table[df - 1] : z + (z * z * z + z) / (4 * df);
}

struct line_fit line_fit(int n, const double *x, const double *y)
{
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0, rest = 0;
    for (int i = 0; i < n; i++) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (int i = 0; i < n; i++) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    struct line_fit fit = {xy / xx, mean_y - xy / xx * mean_x, -INFINITY, INFINITY, 0};
    for (int i = 0; i < n; i++) {
        double d = y[i] - fit.intercept - fit.slope * x[i];
        rest += d * d;
    }
    fit.rms = sqrt(rest / n);
    if (n > 2) {
        double reach = student(n - 2) * sqrt(rest / (n - 2) / xx);
        fit.lo = fit.slope - reach;
        fit.hi = fit.slope + reach;
    }
    return fit;
}
