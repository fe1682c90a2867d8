/* Numbers of twice the digits known to within a radius, and truncated power series of them: ball.h with
 * twofolds.
 *
 * |exact - mid| <= rad.  Operations on twofolds err relatively by at most 15 u^2 (core/twofold.h), u =
 * REAL_EPSILON / 2; every one here adds 16 u^2 |mid.hi| and enlarges the radius by a factor that covers the
 * radius's own rounding and |mid| <= (1 + u) |mid.hi|. */
#ifndef FATLINE_CERTIFIED_FINE_H
#define FATLINE_CERTIFIED_FINE_H

#include "../../core/twofold.h"
#include "ball.h"

struct fine {
    struct twofold mid;
    real rad;
};

/* c[0] + c[1] z + ... + c[FINE_LAST] z^FINE_LAST */
enum { FINE_LAST = SERIES - 1 };
struct fine_series {
    struct fine c[FINE_LAST + 1];
};

static inline struct fine fine_round(struct twofold mid, real rad)
{
    struct fine a = {mid,
                     (rad + 4 * (REAL_EPSILON * REAL_EPSILON) * real_abs(mid.hi)) * (1 + 8 * REAL_EPSILON)};
    return a;
}

static inline struct fine fine_of(real a)
{
    struct fine b = {twofold_of(a), 0};
    return b;
}

static inline real fine_most(struct fine a)
{
    return (real_abs(a.mid.hi) + a.rad) * (1 + 2 * REAL_EPSILON);
}

static inline struct ball fine_ball(struct fine a)
{
    return ball_round(a.mid.hi, a.rad + real_abs(a.mid.lo));
}

static inline struct fine fine_add(struct fine a, struct fine b)
{
    return fine_round(twofold_add(a.mid, b.mid), a.rad + b.rad);
}

static inline struct fine fine_subtract(struct fine a, struct fine b)
{
    return fine_round(twofold_add(a.mid, twofold_negate(b.mid)), a.rad + b.rad);
}

static inline struct fine fine_multiply(struct fine a, struct fine b)
{
    return fine_round(twofold_multiply(a.mid, b.mid),
                      real_abs(a.mid.hi) * b.rad + (real_abs(b.mid.hi) + b.rad) * a.rad);
}

/* 1 / a: off by rad / (|m| (|m| - rad)); no finite radius if rad is more than half of a. */
static inline struct fine fine_invert(struct fine a)
{
    real size = real_abs(a.mid.hi);
    if (!(size > 2 * a.rad)) {
        struct fine none = {twofold_of(0), REAL_HUGE};
        return none;
    }
    return fine_round(twofold_divide(twofold_of(1), a.mid), a.rad / (size * (size - a.rad)));
}

/* Sum of a[i] b[k - i] for i = from..k. */
static inline struct fine fine_term(const struct fine_series *a, int from, const struct fine_series *b, int k)
{
    struct fine sum = fine_of(0);
    for (int i = from; i <= k; i++) {
        sum = fine_add(sum, fine_multiply(a->c[i], b->c[k - i]));
    }
    return sum;
}

/* The terms of a b up to z^last, where a begins with z^from; out may be b. */
static inline void fine_series_multiply(const struct fine_series *a, int from, const struct fine_series *b,
                                        int last, struct fine_series *out)
{
    for (int k = last; k >= 0; k--) { /* the k-th needs none above it */
        out->c[k] = fine_term(a, from, b, k);
    }
}

/* 1 / a up to z^last. */
static inline void fine_series_invert(const struct fine_series *a, int last, struct fine_series *out)
{
    out->c[0] = fine_invert(a->c[0]);
    for (int k = 1; k <= last; k++) { /* a out = 1 */
        struct fine sum = fine_term(a, 1, out, k);
        sum.mid = twofold_negate(sum.mid);
        out->c[k] = fine_multiply(sum, out->c[0]);
    }
}

/* The derivative, up to z^(last - 1). */
static inline void fine_series_derive(const struct fine_series *a, int last, struct fine_series *out)
{
    for (int k = 1; k <= last; k++) {
        out->c[k - 1] = fine_multiply(a->c[k], fine_of(k));
    }
}

/* outer(inner), inner without its constant term. */
static inline void fine_series_compose(const struct fine_series *outer, const struct fine_series *inner,
                                       struct fine_series *out)
{
    struct fine_series r;
    r.c[0] = outer->c[FINE_LAST];
    for (int k = FINE_LAST - 1; k >= 0; k--) { /* by Horner; r is good to z^(FINE_LAST - 1 - k) before */
        int last = FINE_LAST - k;
        r.c[last] = fine_of(0);
        fine_series_multiply(inner, 1, &r, last, &r);
        r.c[0] = outer->c[k];
    }
    *out = r;
}

/* y as a series in x - x[0]: as series_graph. */
static inline void fine_series_graph(const struct fine_series *x, const struct fine_series *y,
                                     struct fine_series *g)
{
    struct fine_series one, now, slope;
    fine_series_derive(x, FINE_LAST, &slope);
    fine_series_invert(&slope, FINE_LAST - 1, &one);
    g->c[0] = y->c[0];
    now = *y;
    for (int k = 1; k <= FINE_LAST; k++) {
        const struct fine part = fine_invert(fine_of(k));
        fine_series_derive(&now, FINE_LAST - k + 1, &slope);
        fine_series_multiply(&slope, 0, &one, FINE_LAST - k, &now);
        for (int i = 0; i <= FINE_LAST - k; i++) {
            now.c[i] = fine_multiply(now.c[i], part);
        }
        g->c[k] = now.c[0];
    }
}

#endif
