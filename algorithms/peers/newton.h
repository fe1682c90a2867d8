/* Two Newton steps on each root of an answer whose own accuracy stops early.  In a header: the programs over
 * a pipe are built without the rest. */
#ifndef FATLINE_PEERS_NEWTON_H
#define FATLINE_PEERS_NEWTON_H

#include <math.h>

#include "peer.h"

enum { NEWTON_STEPS = 2 };
/* A longer step is none from a root's neighbourhood: at a contact, say, where the matrix is all but singular.
 */
#define NEWTON_LONGEST (1.0 / 256)

/* The point and the derivative by de Casteljau's algorithm; rational curves by the quotient rule. */
static inline void newton_point(const struct peer_curve *c, double t, double point[2], double derivative[2])
{
    double p[3][PEER_DEGREE + 1];
    const int n = c->degree;
    for (int i = 0; i <= n; i++) {
        double w = c->weight ? c->weight[i] : 1;
        p[0][i] = w * c->point[2 * i];
        p[1][i] = w * c->point[2 * i + 1];
        p[2][i] = w;
    }
    const int components = c->weight ? 3 : 2;
    for (int k = 0; k < components; k++) {
        for (int r = n; r > 1; r--) {
            for (int i = 0; i < r; i++) {
                p[k][i] += t * (p[k][i + 1] - p[k][i]);
            }
        }
    }
    double w = c->weight ? p[2][0] + t * (p[2][1] - p[2][0]) : 1,
           dw = c->weight ? n * (p[2][1] - p[2][0]) : 0;
    for (int k = 0; k < 2; k++) {
        point[k] = (p[k][0] + t * (p[k][1] - p[k][0])) / w;
        derivative[k] = (n * (p[k][1] - p[k][0]) - point[k] * dw) / w;
    }
}

/* One step on f(t) = g(s), unless it is longer than `longest` in either parameter: then false. */
static inline int newton_step(const struct peer_curve *f, const struct peer_curve *g, double longest,
                              double root[2])
{
    double p[2], q[2], df[2], dg[2];
    newton_point(f, root[0], p, df);
    newton_point(g, root[1], q, dg);
    double x = q[0] - p[0], y = q[1] - p[1], determinant = dg[0] * df[1] - df[0] * dg[1];
    double dt = (dg[0] * y - dg[1] * x) / determinant, ds = (df[0] * y - df[1] * x) / determinant;
    if (!(fabs(dt) <= longest && fabs(ds) <= longest)) {
        return 0;
    }
    root[0] += dt;
    root[1] += ds;
    return 1;
}

static inline void newton_polish(const struct peer_curve *f, const struct peer_curve *g,
                                 struct peer_roots *roots)
{
    for (int i = 0; i < roots->count && i < PEER_ROOTS; i++) {
        for (int k = 0; k < NEWTON_STEPS && newton_step(f, g, NEWTON_LONGEST, roots->root[i]); k++) {
        }
    }
}

#endif
