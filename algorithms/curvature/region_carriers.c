/* The exact structure: corner lines, and arcs of the envelope where they are visible.
 *
 * Corner lines are the tangents at the ends of the interval, at knots and where M changes its sign.  If all
 * vertices of their polygon fulfil all conditions it is the region.  If not, each vertex that does not is cut
 * off, a few times; then the S+ arcs inside are cut by the edges and by each other, parts whose midpoints
 * fulfil all conditions are the boundary's, so are parts of corner lines, and the order of the normals is
 * that of the boundary. */
#include "carriers.h"

enum { ROUNDS = 3 };

static enum outcome find_arcs(struct region_work *k, struct region *out)
{
    struct carrier_arcs inside, visible;
    struct carrier_crossings crossings;
    if (!pieces_make(k, AT_ALL) || !arcs_inside(k, &inside)) {
        return OUT_OF_ROOM;
    }
    enum outcome outcome = arcs_cross(k, &inside, &crossings);
    if (outcome != SOLVED) {
        return outcome;
    }
    if (!arcs_visible(k, &inside, &crossings, &visible) || !carriers_join(k, &visible, out)) {
        return OUT_OF_ROOM;
    }
    out->certified = out->certified && out->count > 0 && carriers_certify(k, &visible, out);
    return SOLVED;
}

/* All edges are corner lines, or the line at infinity; others were cuts, which may stand for an arc. */
static bool has_corners_only(const struct cone *c)
{
    for (int i = 0; i < c->count; i++) {
        if (c->edge[i].plane.source != AT_INFINITY && !c->edge[i].plane.corner) {
            return false;
        }
    }
    return true;
}

/* Vertices are known well enough for their conditions to mean something. */
static bool is_sharp(const struct cone *c)
{
    for (int i = 0; c->count > 1 && i < c->count; i++) {
        if (c->edge[i].error > real_ldexp(1, -REAL_BITS * 3 / 8)) {
            return false;
        }
    }
    return true;
}

static enum outcome find(const struct region_problem *p, struct region_workspace *w, struct region *out)
{
    struct region_work *k = w->work;
    enum outcome outcome = SOLVED;
    int cuts = 1;
    (void)p;
    if (!pieces_make(k, AT_TORSION)) {
        return OUT_OF_ROOM;
    }
    cone_init(&k->cone);
    out->kind = REGION_EMPTY;
    if (!enclose_ends(k, &k->cone, false, 0, &outcome)) {
        return outcome;
    }
    for (int i = 0; (i < ROUNDS || k->cone.count < 3) && cuts > 0 && outcome == SOLVED; i++) {
        if (!enclose_round(k, &k->cone, 0, 0, &cuts, &outcome)) {
            return outcome;
        }
    }
    if (outcome == SOLVED && cuts == 0 && (has_corners_only(&k->cone) || k->cone.count < 3)) {
        out->certified = is_sharp(&k->cone);
        return boundary_of_cone(&k->cone, out) ? SOLVED : OUT_OF_ROOM;
    }
    return outcome == SOLVED ? find_arcs(k, out) : outcome;
}

#define SUMMARY "corner lines and visible arcs of the envelope: the exact structure"

extern const struct region_method region_carriers;
const struct region_method region_carriers = {
    "region_carriers", SUMMARY,
    "E. I. Karousos, Quantifying the dependence of shape on a control point (in Greek)", find};
