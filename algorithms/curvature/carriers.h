/* The parts of region_carriers: which arcs of the envelope are visible, and how all is joined. */
#ifndef FATLINE_CARRIERS_H
#define FATLINE_CARRIERS_H

#include "boundary.h"
#include "enclose.h"

enum { ARCS_MAX = 128, MARKS_MAX = 512 };

/* Where an arc ends: at the end of its piece, on an edge of the cone, where it crosses another arc. */
enum mark_kind { MARK_END, MARK_EDGE, MARK_CROSSING };

struct mark {
    real t; /* of the span */
    enum mark_kind kind;
    int edge; /* of the cone */
};

/* Part of an S+ piece, from.t < to.t. */
struct carrier_arc {
    int piece;
    struct mark from, to;
};

struct carrier_arcs {
    int count;
    struct carrier_arc at[ARCS_MAX];
};

/* A crossing on arc number `arc`, at t of its span. */
struct carrier_crossing {
    int arc;
    real t;
};

struct carrier_crossings {
    int count;
    struct carrier_crossing at[MARKS_MAX];
};

/* Pieces joined smoothly within half a turn: their arcs do not cross. */
bool pieces_are_near(const struct piece *a, const struct piece *b);

/* p is a tangent of the piece, at *t of its span. */
bool plane_is_own(const struct region_work *k, const struct half_plane *p, const struct piece *own, real *t);

/* The S+ pieces inside the cone k->cone, cut by its edges; false: no room. */
bool arcs_inside(struct region_work *k, struct carrier_arcs *out);

/* All crossings of two arcs inside the cone, each on both of them. */
enum outcome arcs_cross(struct region_work *k, const struct carrier_arcs *arcs,
                        struct carrier_crossings *out);

/* The visible parts of arcs cut at their crossings: those whose midpoints fulfil all conditions. */
bool arcs_visible(struct region_work *k, const struct carrier_arcs *arcs,
                  const struct carrier_crossings *crossings, struct carrier_arcs *out);

/* Visible arcs and visible parts of the cone's edges as the region's boundary; certified if it closes up. */
bool carriers_join(struct region_work *k, const struct carrier_arcs *visible, struct region *out);

/* Every vertex and every arc fulfils all conditions. */
bool carriers_certify(struct region_work *k, const struct carrier_arcs *visible, const struct region *r);

#endif
