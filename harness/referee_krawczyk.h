/* Existence and uniqueness of a crossing by Krawczyk's test in binary128.  Part of the referee.
 *
 * The curves are given by homogeneous Bernstein coefficients of magnitude at most 1, each within 2 U of the
 * exact one, on [0, 1]; the zeros looked for are those of H(t, s) = (f_x w_g - g_x w_f, f_y w_g - g_y w_f)
 * (f_x - g_x, f_y - g_y for polynomial pairs), which on [0, 1]^2, where weights are positive, are the
 * solutions of f(t) = g(s). Rounding is accounted for by the bounds of referee_krawczyk.c; no directed
 * rounding is used. */
#ifndef FATLINE_REFEREE_KRAWCZYK_H
#define FATLINE_REFEREE_KRAWCZYK_H

#include <stdbool.h>

typedef __float128 quad;

enum { QUAD_DEGREE_MAX = 32 };

/* Parameters may leave [0, 1] by this much, so that a root at an end has a neighbourhood. */
#define QUAD_OVERHANG 0x1p-6

/* A root is at least this part of the domain's half width away from the domain's border. */
#define QUAD_ROOT_MARGIN 0x1p-20

struct quad_interval {
    quad lo, hi;
};

/* x, y, w in this order; w[i] == 1 for a polynomial curve of a rational pair, unused in a polynomial pair. */
struct quad_curve {
    int degree;
    quad at[3][QUAD_DEGREE_MAX + 1];
};

struct quad_pair {
    bool rational;
    struct quad_curve f, g;
};

/* Bernstein coefficients of c (degree n) over [a, b], -QUAD_OVERHANG <= a < b <= 1 + QUAD_OVERHANG, each
 * within quad_restrict_error(n) of the exact ones. */
void quad_restrict(int n, const quad *c, quad a, quad b, quad *out);
double quad_restrict_error(int n);

/* One root, simple, the only one in t x s (which may overhang [0, 1]^2); near (at[0], at[1]). */
struct quad_root {
    struct quad_interval domain[2];
    quad at[2];
    quad radius[2];     /* the root is within radius[i] of at[i], proved */
    quad inverse[2][2]; /* approximates the inverse of the Jacobian of H at the root */
    double proof[2][2]; /* the Y of the proof: for z, z* in the domain and H(z*) = 0, */
    double contraction; /* max |z - z*|_i / scale[i] <= max |Y H(z)|_i / scale[i] / (1 - contraction) */
    double scale[2];
    double tangent[2][2]; /* f'(t) and g'(s), Euclidean */
};

enum proof { UNDECIDED, ONE_ROOT, NO_ROOT };

/* What is proved of the cell t x s in [0, 1]^2: one root in the cell widened by a quarter of its width on
 * each side (within the overhang), none in the cell, or nothing. */
enum proof krawczyk_test(const struct quad_pair *p, struct quad_interval t, struct quad_interval s,
                         struct quad_root *root);

#endif
