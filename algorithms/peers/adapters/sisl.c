/* SISL's curve-curve intersection s1857 as a program of its own (program.h).  SISL is under the AGPL: this
 * program is built apart, linked to nothing of ours, and not shipped. */
#include <sisl.h>

#include <stdlib.h>

#include "program.h"

static const double tolerance = 1e-12;

/* kind of newCurve: 3, polynomial Bezier; 4, rational, with control points (w x, w y, w). */
static SISLCurve *curve(const struct peer_curve *c, double *knots, double *coefficients)
{
    const int order = c->degree + 1;
    for (int i = 0; i < order; i++) {
        knots[i] = 0;
        knots[order + i] = 1;
    }
    if (!c->weight) {
        return newCurve(order, order, knots, (double *)c->point, 3, 2, 0);
    }
    for (int i = 0; i < order; i++) {
        coefficients[3 * i] = c->weight[i] * c->point[2 * i];
        coefficients[3 * i + 1] = c->weight[i] * c->point[2 * i + 1];
        coefficients[3 * i + 2] = c->weight[i];
    }
    return newCurve(order, order, knots, coefficients, 4, 2, 0);
}

enum peer_outcome peer_intersect(const struct peer_curve *f, const struct peer_curve *g,
                                 struct peer_roots *out)
{
    double knots[2][2 * PEER_DEGREE + 2], coefficients[2][3 * PEER_DEGREE + 3], *t = NULL, *s = NULL;
    SISLCurve *a = curve(f, knots[0], coefficients[0]), *b = curve(g, knots[1], coefficients[1]);
    SISLIntcurve **arc = NULL;
    int points = 0, arcs = 0, status = -1;

    if (a && b) {
        s1857(a, b, 0, tolerance, &points, &t, &s, &arcs, &arc, &status);
    }
    for (int i = 0; i < points; i++) {
        peer_add(out, t[i], s[i]);
    }
    for (int i = 0; i < arcs; i++) {
        const SISLIntcurve *x = arc[i];
        const int last = x->ipoint - 1;
        if (last > 0 && x->epar1 && x->epar2) {
            peer_add_overlap(out, x->epar1[0], x->epar1[last], x->epar2[0], x->epar2[last]);
        } else {
            out->coincident = 1;
        }
    }
    free(t);
    free(s);
    if (arc) {
        freeIntcrvlist(arc, arcs);
    }
    if (a) {
        freeCurve(a);
    }
    if (b) {
        freeCurve(b);
    }
    return status < 0 ? PEER_FAILED : PEER_SOLVED;
}

const char *peer_version(void)
{
    return PEER_VERSION;
}

int main(void)
{
    return program_run("sisl");
}
