/* Segments that run in one direction.
 *
 * Let h be linear, and h(P_0) <= h(P_1) <= ... <= h(P_n), not all equal, for the Euclidean control points of
 * a curve with positive weights.  Then every line h = const crosses the control polygon at most once, so by
 * variation diminution (Schoenberg 1930; of a rational curve: of the polynomial h - const times the
 * denominator, with coefficients w_i (h(P_i) - const)) it meets the curve at most once: h grows strictly
 * along the curve.  Of two such curves, the second beginning where the first ends, h grows strictly along
 * both: they have that point in common and no other.
 *
 * Rounding.  h(P) = P.D.  A difference of polynomial control points errs by u of itself, its product with D
 * by two more roundings, so that the sum is off by at most 4 u (|e_x D_x| + |e_y D_y|), and REAL_LEAST where
 * products underflow; an exact difference of zero leaves h alone.  Quotients err by u of themselves, which
 * adds u
 * (|P_i| + |P_(i+1)|) |D|.  Twice these bounds are asked for. */
#include "paths.h"

struct vector {
    real x, y;
};

static inline struct vector point_of(const struct curve *c, int i)
{
    struct vector p = {c->x[i], c->y[i]};
    if (c->w) {
        p.x = p.x / c->w[i];
        p.y = p.y / c->w[i];
    }
    return p;
}

/* The chord, of length 1 in the 1-norm; NaN if there is none. */
static inline struct vector heading(const struct curve *c)
{
    struct vector p = point_of(c, 0), q = point_of(c, c->degree), d = {q.x - p.x, q.y - p.y};
    real length = real_abs(d.x) + real_abs(d.y);
    d.x = d.x / length;
    d.y = d.y / length;
    return d;
}

static inline bool grows(const struct curve *c, const struct vector *d)
{
    struct vector p = point_of(c, 0);
    bool moved = false;
    for (int i = 1; i <= c->degree; i++) {
        struct vector q = point_of(c, i), e = {q.x - p.x, q.y - p.y};
        real along = e.x * d->x, across = e.y * d->y;
        real bound = 4 * REAL_EPSILON * (real_abs(along) + real_abs(across)) + 4 * REAL_LEAST;
        if (c->w) {
            bound += 2 * REAL_EPSILON *
                     ((real_abs(p.x) + real_abs(q.x)) * real_abs(d->x) +
                      (real_abs(p.y) + real_abs(q.y)) * real_abs(d->y));
        }
        if (along + across > bound) {
            moved = true;
        } else if (c->w || e.x != 0 || e.y != 0) {
            return false;
        }
        p = q;
    }
    return moved;
}

bool path_runs_straight(const struct curve *c, const struct curve *d)
{
    struct vector way = heading(c);
    if (!d) {
        return grows(c, &way);
    }
    struct vector on = heading(d), both = {way.x + on.x, way.y + on.y};
    return grows(c, &both) && grows(d, &both);
}
