#include "zeros.h"

#include "band.h"

int zeros_by_reduction(const struct reduction *r, const real *c, real error,
                       struct interval out[ZEROS_PIECES_MAX])
{
    real q[REDUCED_MAX + 1], rest[ZEROS_DEGREE_MAX + 1], most = 0, largest = 0;
    struct band above, below, kept;
    reduction_apply(r, 1, c, q);
    real delta = reduction_residual(r, 1, c, q, rest);
    for (int i = 0; i <= r->n; i++) {
        most = real_max(most, real_abs(rest[i]));
    }
    for (int i = 0; i <= r->k; i++) {
        largest = real_max(largest, real_abs(q[i]));
    }
    delta = delta + most + error;
    delta += 4 * REAL_EPSILON * (delta + largest); /* the sums here and below */
    for (int i = 0; i <= r->k; i++) {
        q[i] = q[i] + delta;
    }
    band_above(r->k, q, &above);
    for (int i = 0; i <= r->k; i++) {
        q[i] = 2 * delta - q[i];
    }
    band_above(r->k, q, &below);
    band_meet(&above, &below, &kept);
    for (int i = 0; i < kept.count; i++) {
        out[i].lo = kept.lo[i];
        out[i].hi = kept.hi[i];
    }
    return kept.count;
}
