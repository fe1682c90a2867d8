/* What the judge has to know of the two curves themselves.  Compiled for each precision; shares no code with
 * the algorithms. */
#ifndef FATLINE_JUDGE_CURVES_H
#define FATLINE_JUDGE_CURVES_H

#include "../../algorithms/bezier.h"
#include "../cases/case.h"

struct box {
    struct interval t, s;
};

/* Largest side of the control points' common box. */
real curves_size(const struct problem *p);

/* True only if |f(t) - g(s)| > distance for all t, s in the box, proved by Lipschitz bounds; false also if
 * that took too many steps. */
bool curves_apart(const struct problem *p, const struct box *b, real distance);

/* The s in [lo, hi] with g(s) nearest to f(t), by Gauss and Newton's method from *s: a local minimum. Returns
 * the distance there. */
real curves_match(const struct problem *p, real t, struct interval range, real *s);

/* An expected overlap: s as a function of t, tabulated at equal steps from t.lo to t.hi. */
enum { TRACE_MAX = 33 };
struct trace {
    struct interval t, range; /* of s */
    real s[TRACE_MAX];
    bool sure[TRACE_MAX]; /* the curves do meet at this entry */
};

void trace_make(const struct problem *p, const struct case_overlap *o, struct trace *trace);
real trace_t(const struct trace *trace, int k);
real trace_s(const struct problem *p, const struct trace *trace, real t); /* t in trace->t */
/* Does a point of the overlap lie within tol of the box? */
bool trace_meets(const struct problem *p, const struct trace *trace, const struct box *b, real tol);

#endif
