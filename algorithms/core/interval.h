#ifndef FATLINE_INTERVAL_H
#define FATLINE_INTERVAL_H

#include "real.h"

/* lo <= hi, closed. */
struct interval {
    real lo, hi;
};

#endif
