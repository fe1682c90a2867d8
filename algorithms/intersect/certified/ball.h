/* Numbers known to within a radius, and truncated power series of them.
 *
 * |exact - mid| <= rad.  Every operation adds the rounding of its result (u |mid|, u = REAL_EPSILON / 2) and enlarges the
 * radius by a factor that covers the radius's own rounding. */
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

/* 1 / a; a does not contain 0. */
static inline struct ball ball_invert(struct ball a)
{
    real size = real_abs(a.mid);
    return ball_round(1 / a.mid, a.rad / (size * (size - a.rad)));
}

/* c[0] + c[1] z + ... + c[SERIES] z^SERIES */
enum { SERIES = 6 };
struct series {
    struct ball c[SERIES + 1];
};

/* The terms of a b up to z^SERIES that begin with z^from in a, from >= 0. */
static inline void series_multiply(const struct series *a, int from, const struct series *b, struct series *out)
{
    struct series r;
    for (int k = 0; k <= SERIES; k++) {
        r.c[k] = ball_of(0, 0);
        for (int i = from; i <= k; i++) {
            r.c[k] = ball_add(r.c[k], ball_multiply(a->c[i], b->c[k - i]));
        }
    }
    *out = r;
}

/* outer(inner), inner without its constant term. */
static inline void series_compose(const struct series *outer, const struct series *inner, struct series *out)
{
    struct series r;
    for (int k = 0; k <= SERIES; k++) {
        r.c[k] = ball_of(0, 0);
    }
    r.c[0] = outer->c[SERIES];
    for (int k = SERIES - 1; k >= 0; k--) { /* Horner */
        series_multiply(inner, 1, &r, &r);
        r.c[0] = outer->c[k];
    }
    *out = r;
}

/* The series s with a(s(z)) = a[0] + z, and no constant term; a[1] does not contain 0. */
static inline void series_revert(const struct series *a, struct series *out)
{
    struct ball one = ball_invert(a->c[1]);
    for (int k = 0; k <= SERIES; k++) {
        out->c[k] = ball_of(0, 0);
    }
    out->c[1] = one;
    for (int k = 2; k <= SERIES; k++) { /* the coefficient of z^k in a(s) is a[1] s[k] and terms of lower s */
        struct series now;
        series_compose(a, out, &now);
        out->c[k] = ball_multiply(ball_of(-now.c[k].mid, now.c[k].rad), one);
    }
}

#endif
