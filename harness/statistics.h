/* Order statistics of small samples and bootstrap intervals.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_STATISTICS_H
#define FATLINE_STATISTICS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { STATISTICS_RESAMPLES = 2000 };

struct range {
    double lo, hi;
};

/* Of x[0..n-1], n >= 1, finite, in any order; x is left alone.  An even n takes the mean of the two middle
 * ones. */
double statistics_min(int n, const double *x);
double statistics_median(int n, const double *x);
/* Median of |x[i] - median|, unscaled (times 1.4826 it estimates the standard deviation of normal data). */
double statistics_mad(int n, const double *x);

/* Quantile q in [0, 1], linear between the order statistics. */
double statistics_quantile(int n, const double *x, double q);

/* Beyond the quartiles by more than 1.5 (mild) or 3 (severe) times their distance (Tukey, Exploratory Data
 * Analysis, 1977); a severe one is not mild. */
struct outliers {
    int mild, severe;
};
struct outliers statistics_outliers(int n, const double *x);

/* Percentile bootstrap interval of the median at `level` (0.95) from STATISTICS_RESAMPLES resamples with
 * replacement (Efron and Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13).  It never reaches
 * beyond the smallest and largest sample; the same seed gives the same interval. */
struct range statistics_bootstrap_median(int n, const double *x, double level, uint64_t seed);

#ifdef __cplusplus
}
#endif
#endif
