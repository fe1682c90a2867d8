/* What an adapter of somebody else's library offers: plain C and doubles, so that it can be a shared object
 * or a program of its own, in any language. */
#ifndef FATLINE_PEER_H
#define FATLINE_PEER_H

#ifdef __cplusplus
extern "C" {
#endif

enum { PEER_DEGREE = 32, PEER_ROOTS = 1024, PEER_OVERLAPS = 16 };

/* REFUSED: curves of a kind that it does not take.  FAILED: it says so, or threw. */
enum peer_outcome { PEER_SOLVED, PEER_REFUSED, PEER_FAILED };

/* point: x0 y0 x1 y1 ..., Euclidean; weight: NULL for polynomial curves.  Over [0, 1]. */
struct peer_curve {
    int degree;
    const double *point, *weight;
};

/* root: (t, s).  overlap: (t0, t1, s0, s1) with f(t0) = g(s0), f(t1) = g(s1).  coincident: it says that the
 * curves share an arc, without its ends.  count may exceed PEER_ROOTS: the rest was not kept. */
struct peer_roots {
    int count, overlaps, coincident;
    double root[PEER_ROOTS][2], overlap[PEER_OVERLAPS][4];
};

/* out: zeroed counts. */
enum peer_outcome peer_intersect(const struct peer_curve *f, const struct peer_curve *g,
                                 struct peer_roots *out);
const char *peer_version(void);

static inline void peer_add(struct peer_roots *out, double t, double s)
{
    if (out->count < PEER_ROOTS) {
        out->root[out->count][0] = t;
        out->root[out->count][1] = s;
    }
    out->count++;
}

static inline void peer_add_overlap(struct peer_roots *out, double t0, double t1, double s0, double s1)
{
    if (out->overlaps < PEER_OVERLAPS) {
        double *o = out->overlap[out->overlaps++];
        o[0] = t0;
        o[1] = t1;
        o[2] = s0;
        o[3] = s1;
    }
}

#ifdef __cplusplus
}
#endif
#endif
