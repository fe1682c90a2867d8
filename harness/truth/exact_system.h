/* Common zeros of two polynomials in two variables in the closed unit square, with proof. */
#ifndef FATLINE_EXACT_SYSTEM_H
#define FATLINE_EXACT_SYSTEM_H

#include "exact_roots.h"

/* A curve over [0, 1]: (x : y : w) as integer polynomials of true degree n without common factor.  Both
 * curves of a pair live in one plane, so x / w and y / w are the points up to one scaling of each axis. */
struct exact_curve {
    int n;
    fmpz_poly_t x, y, w;
    fmpz_poly_t stationary; /* its zeros: where the derivative of the point vanishes */
};

struct exact_pair {
    struct exact_curve f, g;
    double deadline; /* of exact_clock; 0: none */
};

struct exact_point {
    struct real_root t, s;
    int multiplicity;     /* 0: not defined, the point lies on a common component */
    int order_f, order_g; /* of the zero of the derivative there */
};

struct point_list {
    int count;
    struct exact_point *at;
};

struct exact_point *point_list_append(struct point_list *l, const struct real_root *t,
                                      const struct real_root *s);
void point_list_clear(struct point_list *l);

/* Two coprime polynomials; all their common zeros in the square are sought.
 * whole: p, q are the coordinate equations of `pair`; else these divided by their common component. */
struct exact_system {
    struct biv p, q;
    const struct exact_pair *pair;
    bool whole;
};

/* Why there is no list of points: p and q are not coprime. */
extern const char EXACT_COMMON_COMPONENT[];

/* Finds them all, with their multiplicities if the system is whole.  NULL, or why not. */
const char *exact_system_solve(const struct exact_system *e, struct point_list *l);

/* The multiplicity of a common zero, by a pencil of parallel lines one of which meets it and no other common
 * zero (complex ones and infinity included): there the multiplicity of the root of the pencil's resultant is
 * that of the zero.  0 if it could not be settled.  exact_multiplicity.c */
int exact_multiplicity(const struct exact_system *e, struct exact_point *c);

#endif
