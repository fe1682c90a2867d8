/* Families of generated cases: one function each, in a table.  Compiled once, as C.
 *
 * A family's formula, purpose and parameters are in datasets/README.md under its name. */
#ifndef FATLINE_FAMILY_H
#define FATLINE_FAMILY_H

#include <stdint.h>

#include "draft.h"
#include "../cases/random.h"

/* What is asked of a family: case `index` of degrees n, m. */
struct request {
    int n, m;
    bool weights; /* make both curves rational */
    uint64_t index;
    int gap,
        gaps; /* near_tangent: case i has the gap 2^-(gap + (i div 2) mod gaps); 0: the family's choice */
    struct random_state random;
};

struct family {
    const char *name, *summary;
    /* False if these random numbers gave no pair with the properties claimed, or none that fits in doubles:
     * it is then called again, the random numbers going on. */
    bool (*generate)(struct draft *d, struct request *r);
    int low, high;          /* the lower degree is at least low, the higher at least high */
    int max, max_rational;  /* the higher is at most so; max_rational 0: no rational variant */
    int low_rational;       /* the lower of a rational pair is at least so; 0: as low */
    bool own_weights;       /* always rational */
    bool same_degrees;      /* a rational pair has n = m */
    bool any_degree_stream; /* the random numbers do not depend on the degrees */
};

extern const struct family families[]; /* ends with name NULL */

/* NULL, or why the family has no pair of these degrees (in `why`). */
const char *family_refuses(const struct family *a, int n, int m, bool weights, char why[160]);
/* Makes case `index` of (family, degrees, seed); `name` is the family's with its suffix.  False if no pair
 * was found in 2000 trials. */
bool family_make(const struct family *a, const char *name, uint64_t seed, struct request *r, struct draft *d);
/* The line of a case. */
void family_write(FILE *stream, const struct draft *d, const char *family, uint64_t seed, uint64_t index);

/* ---- for the families ---------------------------------------------------------------------------------- */

/* A parameter k/c, 1/5 <= k/c <= 4/5, whose powers up to `degree` stay below 2^(budget): c is a power of two
 * in every second case, else any number. */
void random_parameter(fmpq_t t, struct request *r, int degree, int budget);
/* One on each curve; both are initialised here. */
void random_places(fmpq_t t, fmpq_t s, struct request *r, int budget);
/* k 2^-bits, |k| <= 2^bits size, k != 0. */
void random_dyadic(fmpq_t a, struct request *r, int size, int bits);
bool random_coin(struct request *r);
/* Weights 1/2, 1, 2 or 4 for all points but the first, which keeps 1. */
void random_weights(struct points *p, struct request *r);
/* Legs within 45 degrees of the x axis, dx in 8..31 (y axis if `upright`), from the origin. */
void random_slope(struct points *p, struct request *r, bool upright);
/* Turns both curves by one random integer similarity, reverses g in half of the cases, moves both by up to
 * their size, and scales. */
bool finish(struct draft *d, struct request *r);
/* A curve in local parameter u = t - t0: x = sum of a[j] u^j for j >= x_from, y likewise, the first
 * coefficients not 0; rational curves get random weights, and the sums are the homogeneous coordinates. */
void random_local(struct points *p, struct request *r, const fmpq_t t0, int x_from, int y_from);
/* The weights of p as a polynomial in u, drawn if p is rational, else 1. */
void random_local_weights(fmpq_poly_t w, struct points *p, struct request *r, const fmpq_t t0);
/* From homogeneous coordinates in u to control points. */
void points_from_local(struct points *p, struct shape *local, const fmpq_t t0);

#define FAMILY(name) bool family_##name(struct draft *d, struct request *r)
FAMILY(random);
FAMILY(far);
FAMILY(near_disjoint);
FAMILY(nice);
FAMILY(endpoint);
FAMILY(shared_end);
FAMILY(smooth_join);
FAMILY(size_mismatch);
FAMILY(degree_sweep);
FAMILY(nine);
FAMILY(many);
FAMILY(tangent_same);
FAMILY(tangent_opposite);
FAMILY(contact_3);
FAMILY(contact_4);
FAMILY(endpoint_tangent);
FAMILY(near_tangent);
FAMILY(cusp_crossed);
FAMILY(cusp_along);
FAMILY(two_cusps);
FAMILY(zero_end);
FAMILY(overlap);
FAMILY(circle_crossing);
FAMILY(circle_tangent);
FAMILY(on_cut);
FAMILY(sliver);
FAMILY(scaled);
FAMILY(overlap_beside);
FAMILY(near_overlap);
FAMILY(point_curve);
FAMILY(sizes);

#endif
