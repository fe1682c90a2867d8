/* A straight line through points, by least squares.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_REGRESSION_H
#define FATLINE_REGRESSION_H

#ifdef __cplusplus
extern "C" {
#endif

/* y = intercept + slope x; lo and hi bound the 95 percent interval of the slope (Student, n - 2 degrees of
 * freedom), infinite for n = 2; rms: of the residuals. */
struct line_fit {
    double slope, intercept, lo, hi, rms;
};

/* n >= 2, not all x equal. */
struct line_fit line_fit(int n, const double *x, const double *y);

#ifdef __cplusplus
}
#endif
#endif
