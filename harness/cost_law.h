/* How the steps of a solve grow as the tolerance falls.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_COST_LAW_H
#define FATLINE_COST_LAW_H

#ifdef __cplusplus
extern "C" {
#endif

/* LOGARITHMIC: steps = c + b log2(1/eps).  POWER: steps = c eps^-p.  FEW: not enough tolerances to tell. */
enum cost_model { LOGARITHMIC, POWER, FEW };

struct cost_law {
    enum cost_model model;
    double c, b;      /* of the better model; b NAN for POWER */
    double p, lo, hi; /* exponent of POWER with its 95 percent interval, whichever is better */
    double rms_logarithmic, rms_power; /* of log2 steps from each model */
    int points;
};

enum { COST_POINTS_LEAST = 6 };

/* bits[i] = log2(1/eps), increasing, steps[i] > 0.  Both models have two parameters and are fitted by least
 * squares of the relative error; the first quarter of the tolerances, where neither need hold yet, is left
 * out. */
struct cost_law cost_law_fit(int n, const double *bits, const double *steps);
const char *cost_model_name(enum cost_model model); /* "logarithmic", ... */

#ifdef __cplusplus
}
#endif
#endif
