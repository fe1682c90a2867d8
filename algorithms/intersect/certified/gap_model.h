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
};

/* All by own parameters.  gap: G_0 to G_5 at `at`, G_6 over the node. */
struct gap_model {
    struct framed graph, loose;
    struct series gap;
    struct series x; /* X at `at` */
    real noise;      /* of points of cut nodes: what narrower ones cannot tell from 0 */
    real swing;      /* the last coefficient of X over the node, at most */
    real run;        /* |X'| of the graph, at least */
    real at, as;     /* parameters of about the same abscissa */
    real off;        /* how far these are apart in x, at most */
};

/* false: the graph is none. */
bool gap_model_init(const struct source *free_of, const struct node *free_node, const struct source *graph_of,
                    const struct node *graph, struct gap_model *out);

/* Bernstein coefficients, degree SERIES - p, of G^(p) / p! over [lo, hi] in [0, 1]. */
void gap_model_bernstein(const struct gap_model *c, int p, real lo, real hi, struct ball *out);

/* Solutions with the free parameter in [lo, hi] have the graph's own parameter within rs of as. */
void gap_model_place(const struct gap_model *c, real lo, real hi, real *as, real *rs);

#endif
