/* Numbers known to within a radius, and truncated power series of them.
 *
 * |exact - mid| <= rad.  Every operation adds the rounding of its result (u |mid|, u = REAL_EPSILON / 2) and
 * enlarges the radius by a factor that covers the radius's own rounding. */
#ifndef FATLINE_CERTIFIED_BALL_H
#define FATLINE_CERTIFIED_BALL_H

#include "../../core/real.h"

struct ball {
    real mid, rad;
};

static inline struct ball ball_of(real mid, real rad)
{
    struct ball b = {mid, rad};
    return b;
}

static inline real ball_most(struct ball a)
{
    return (real_abs(a.mid) + a.rad) * (1 + REAL_EPSILON);
}

/* The least |value|, or 0. */
static inline real ball_least(struct ball a)
{
    real least = (real_abs(a.mid) - a.rad) * (1 - REAL_EPSILON);
    return least > 0 ? least : (real)0;
}

static inline struct ball ball_round(real mid, real rad)
{
    return ball_of(mid, (rad + REAL_EPSILON * real_abs(mid)) * (1 + 8 * REAL_EPSILON));
}

static inline struct ball ball_add(struct ball a, struct ball b)
{
    return ball_round(a.mid + b.mid, a.rad + b.rad);
}

static inline struct ball ball_subtract(struct ball a, struct ball b)
{
    return ball_round(a.mid - b.mid, a.rad + b.rad);
}

static inline struct ball ball_multiply(struct ball a, struct ball b)
{
    return ball_round(a.mid * b.mid, real_abs(a.mid) * b.rad + (real_abs(b.mid) + b.rad) * a.rad);
}

/* 1 / a; no finite radius if a contains 0. */
static inline struct ball ball_invert(struct ball a)
{
    real size = real_abs(a.mid);
    if (!(size > a.rad)) {
        return ball_of(0, REAL_HUGE);
    }
    return ball_round(1 / a.mid, a.rad / (size * (size - a.rad)));
}

/* c[0] + c[1] z + ... + c[SERIES] z^SERIES */
enum { SERIES = 6 };
struct series {
    struct ball c[SERIES + 1];
};

/* Sum of a[i] b[k - i] for i = from..k: the rounding of a sum of m products is at most (m + 1) u times their
 * sizes. */
static inline struct ball series_term(const struct series *a, int from, const struct series *b, int k)
{
    real mid = 0, rad = 0, size = 0;
    for (int i = from; i <= k; i++) {
        const struct ball *p = &a->c[i], *q = &b->c[k - i];
        real product = p->mid * q->mid;
        mid += product;
        size += real_abs(product);
        rad += real_abs(p->mid) * q->rad + (real_abs(q->mid) + q->rad) * p->rad;
    }
    return ball_of(mid, (rad + (k + 2) * REAL_EPSILON * size) * (1 + 32 * REAL_EPSILON));
}

/* The terms of a b up to z^last, where a begins with z^from. */
static inline void series_multiply(const struct series *a, int from, const struct series *b, int last,
                                   struct series *out)
{
    struct series r;
    for (int k = 0; k <= last; k++) {
        r.c[k] = series_term(a, from, b, k);
    }
    for (int k = 0; k <= last; k++) {
        out->c[k] = r.c[k];
    }
}

/* 1 / a up to z^last; a[0] does not contain 0. */
static inline void series_invert(const struct series *a, int last, struct series *out)
{
    out->c[0] = ball_invert(a->c[0]);
    for (int k = 1; k <= last; k++) { /* a out = 1 */
        struct ball sum = series_term(a, 1, out, k);
        out->c[k] = ball_multiply(ball_of(-sum.mid, sum.rad), out->c[0]);
    }
}

/* The derivative, up to z^(last - 1). */
static inline void series_derive(const struct series *a, int last, struct series *out)
{
    for (int k = 1; k <= last; k++) {
        out->c[k - 1] = ball_multiply(a->c[k], ball_of(k, 0));
    }
}

/* outer(inner), inner without its constant term. */
static inline void series_compose(const struct series *outer, const struct series *inner, struct series *out)
{
    struct series r;
    r.c[0] = outer->c[SERIES];
    for (int k = SERIES - 1; k >= 0; k--) { /* by Horner; r is good to z^(SERIES - 1 - k) before */
        int last = SERIES - k;
        r.c[last] = ball_of(0, 0);
        series_multiply(inner, 1, &r, last, &r);
        r.c[0] = outer->c[k];
    }
    *out = r;
}

/* y as a series in x - x[0]: g[0] = y[0], k g[k] the constant term of (d/dx)^k y / (k - 1)!, d/dx = (1 / x')
 * d/dz. x[1] does not contain 0. */
static inline void series_graph(const struct series *x, const struct series *y, struct series *g)
{
    struct series one, now, slope;
    series_derive(x, SERIES, &slope);
    series_invert(&slope, SERIES - 1, &one);
    g->c[0] = y->c[0];
    now = *y;
    for (int k = 1; k <= SERIES; k++) { /* now: d^(k-1) y / dx^(k-1) / (k-1)! up to z^(SERIES - k + 1) */
        series_derive(&now, SERIES - k + 1, &slope);
        series_multiply(&slope, 0, &one, SERIES - k, &now);
        for (int i = 0; i <= SERIES - k; i++) {
            now.c[i] = ball_multiply(now.c[i], ball_of((real)1 / (real)k, REAL_EPSILON));
        }
        g->c[k] = now.c[0];
    }
}

#endif
