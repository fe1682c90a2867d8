/* Cutting planes: the half-plane that a vertex of the polygon misses by most cuts that vertex off.
 *
 * The polygon always holds the region; when no vertex misses a condition by more than the tolerance, neither
 * does any other of its points, by convexity.  A vertex is measured by Bernstein coefficients over pieces
 * whose half-planes have similar directions: they are at most 2 sqrt(3) times their form.  Of an arc it makes
 * a chain of tangents, about 1 / sqrt(tolerance). */
#include "boundary.h"
#include "enclose.h"

static enum outcome find(const struct region_problem *p, struct region_workspace *w, struct region *out)
{
    struct region_work *k = w->work;
    enum outcome outcome = SOLVED;
    real tolerance = p->tolerance > 0 ? p->tolerance : real_ldexp(1, -20);
    bool narrow;
    if (!pieces_make_narrow(k, &narrow)) {
        return OUT_OF_ROOM;
    }
    bool some = enclose(k, &k->cone, 0, tolerance, &outcome);
    out->kind = REGION_EMPTY;
    if (some && !boundary_of_cone(&k->cone, out)) {
        outcome = OUT_OF_ROOM;
    }
    out->certified = outcome == SOLVED && narrow;
    return outcome;
}

#define SUMMARY "half-planes cut off vertices until none is outside by more than the tolerance"

extern const struct region_method region_cutting;
const struct region_method region_cutting = {
    "region_cutting", SUMMARY, "J. E. Kelley, The cutting-plane method for solving convex programs, 1960",
    find};
