/* The gap between two arcs as a polynomial of one parameter with a remainder (gap_model.c). */
#ifndef FATLINE_CERTIFIED_GAP_MODEL_H
#define FATLINE_CERTIFIED_GAP_MODEL_H

#include "ball.h"
#include "graphs.h"

/* A node in the frame of the graph. */
struct framed {
    int n;
    bool rational;
    real c[3][DEGREE_MAX + 1]; /* homogeneous: x, y, w */
    real error;                /* of x and y, times the weight */
    real most[SERIES + 1];     /* polynomial: no Taylor coefficient of x or y is larger; else REAL_HUGE */
};

/* Of the free node's own parameter. */
struct stretch {
    real lo, hi;
};
enum { STRETCHES_MAX = 8 };

/* All by own parameters.  gap: G_0 to G_5 at `at`, G_6 over the node. */
struct gap_model {
    struct framed graph, loose;
    struct series gap;
    struct series x;     /* X at `at` */
    real noise;          /* of points of cut nodes: what narrower ones cannot tell from 0 */
    real swing;          /* the last coefficient of X over the node, at most */
    real run;            /* |X'| of the graph, at least */
    real at, as;         /* parameters of about the same abscissa */
    real ex, ey, x0, y0; /* the frame: along (ex, ey), from (x0, y0) */
    bool f_is_graph;
    struct series range; /* of gamma, over the graph and as far past its ends as the free node goes */
    real ahead, far;     /* by how much X(at) is past the graph at as; more than rounding */
};

/* false: the graph is none. */
bool gap_model_init(const struct source *free_of, const struct node *free_node, const struct source *graph_of,
                    const struct node *graph, struct gap_model *out);

/* The same with Taylor coefficients at another place. */
bool gap_model_centre(struct gap_model *c, real at);

/* The same with twice the digits (gap_fine.c), for nodes that are the whole of a level above 0; false: their
 * sources have no more digits, and c is not to be used. */
bool gap_model_sharpen(const struct source *free_of, const struct source *graph_of, real at,
                       struct gap_model *c);

/* Bernstein coefficients, degree SERIES - p, of G^(p) / p! over [lo, hi] in [0, 1]. */
void gap_model_bernstein(const struct gap_model *c, int p, real lo, real hi, struct ball *out);

/* Solutions with the free parameter in [lo, hi] have the graph's own parameter within rs of as. */
void gap_model_place(const struct gap_model *c, real lo, real hi, real *as, real *rs);

/* Where the free node's abscissas over [lo, hi] are, against the graph's: all beyond these, all among them,
 * or that is not known.  Beyond them no zero of G is a solution. */
enum reach { BEYOND, ACROSS, INSIDE };
enum reach gap_model_reach(const struct gap_model *c, real lo, real hi);

/* ---- gap_zeros.c ---- */

/* Disjoint stretches of `in` that hold all solutions in it, zeros of G, in order; STRETCHES_MAX at most. */
int gap_stretches(const struct gap_model *c, const struct stretch *in, struct stretch *out);
/* The least p for which G^(p) has one sign on the stretch, and so G at most p zeros; 0: none.  size: at most
 * |G^(p)| / p!. */
int gap_order(const struct gap_model *c, const struct stretch *s, real *size);
/* Is rounding of the points, not the remainder, what hides G there? */
bool gap_is_limited(const struct gap_model *c, const struct stretch *s);
/* Does G have opposite signs on the two sides of s?  Then, if s has all solutions of `in`, there is one. */
bool gap_crosses(const struct gap_model *c, const struct stretch *s, const struct stretch *in);
/* From own parameters of the nodes to a region of the level. */
void gap_region(const struct gap_model *c, const struct stretch *s, const struct node *f,
                const struct node *g, struct zero *out);

/* ---- cluster_fine.c ---- */

/* A model of a pair that is a whole level, and stretches that hold all its zeros: settled with twice the
 * digits, or OPEN. */
enum verdict cluster_sharpen(struct solver *z, const struct pair *at, const struct gap_model *c, int most,
                             int count, const struct stretch *s);

#endif
