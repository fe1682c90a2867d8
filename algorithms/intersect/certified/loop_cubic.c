/* Where a polynomial cubic crosses itself, in closed form.
 *
 * With f(t) = a t^3 + b t^2 + c t + d, u = t + s and v = u^2 - t s = t^2 + t s + s^2,
 *
 *     f(t) - f(s) = (t - s) (a v + b u + c).
 *
 * Let D = cross(a, b) != 0.  Products of the bracket with a and with b give u = cross(c, a) / D and v =
 * cross(b, c) / D: there is at most one pair {t, s}, the roots of z^2 - u z + (u^2 - v), of which t < s are
 * real if and only if
 *
 *     4 v - 3 u^2 > 0;
 *
 * where it is 0 the curve has a cusp, at u / 2, and does not cross itself; where it is negative neither. If c
 * = 0, then u = v = 0: no more than a cusp at t = 0; likewise at t = 1 if the last two control points are
 * one.
 *
 * Rounding: the control points are exact and below 2 in size (struct bounds); everything from them on is in
 * fine.h, whose radii hold barring underflow.  a, b, c are below 16, 24, 12 and the cross products below
 * 2^10. A result that underflows errs by less than 8 u REAL_LEAST, so that without these errors D, cross(c,
 * a), cross(b, c) and the discriminant change by much less than tiny = 2^122 REAL_LEAST: their radii are
 * enlarged by that. As 2^-200 < |D| < 2^10, 1 / D does not underflow, and the radius of a quotient, above
 * 2^-10 tiny, covers what does in it by the factor that covers its own rounding. */
#include "fine.h"
#include "loops.h"

/* ---- the closed form ---- */

static struct fine padded(struct fine a)
{
    const real tiny = real_ldexp(REAL_LEAST, 122);
    a.rad += 2 * tiny;
    return a;
}

/* a, b, c of one coordinate. */
static void power_basis(const real *p, struct fine out[3])
{
    const struct fine three = fine_of(3);
    struct fine d[3];
    for (int i = 0; i < 3; i++) {
        d[i] = fine_subtract(fine_of(p[i + 1]), fine_of(p[i]));
    }
    struct fine e0 = fine_subtract(d[1], d[0]), e1 = fine_subtract(d[2], d[1]);
    out[0] = fine_subtract(e1, e0);
    out[1] = fine_multiply(three, e0);
    out[2] = fine_multiply(three, d[0]);
}

static struct fine cross(const struct fine *x, const struct fine *y, int i, int k)
{
    return padded(fine_subtract(fine_multiply(x[i], y[k]), fine_multiply(x[k], y[i])));
}

/* u and 4 v - 3 u^2; false: D may be 0. */
static bool sum_and_discriminant(const struct curve *f, struct fine *u, struct fine *discriminant)
{
    struct fine x[3], y[3];
    power_basis(f->x, x);
    power_basis(f->y, y);
    struct fine d = cross(x, y, 0, 1);
    if (!(real_abs(d.mid.hi) > 2 * d.rad + real_ldexp(1, -200))) {
        return false;
    }
    struct fine inverse = fine_invert(d), v = fine_multiply(cross(x, y, 1, 2), inverse);
    *u = fine_multiply(cross(x, y, 2, 0), inverse);
    *discriminant =
        padded(fine_subtract(fine_multiply(fine_of(4), v), fine_multiply(fine_of(3), fine_multiply(*u, *u))));
    return true;
}

/* Are two control points one? */
static bool are_one(const struct curve *f, int i, int k)
{
    return f->x[i] == f->x[k] && f->y[i] == f->y[k];
}

/* ---- the record ---- */

static bool in_domain(const struct interval *t)
{
    return t->lo >= 0 && t->hi <= 1;
}

static void clip_to_domain(struct interval *t)
{
    t->lo = real_max(t->lo, (real)0);
    t->hi = real_min(t->hi, (real)1);
}

/* t and s are u / 2 -+ h, low <= h^2 <= high.  The square roots and sums err by less than 4 u of the sizes.
 */
static void roots_around(struct ball half, real low, real high, struct crossing *c)
{
    real least = low > 0 ? real_sqrt(low) * (1 - 2 * REAL_EPSILON) : (real)0;
    real most = real_sqrt(high) * (1 + 2 * REAL_EPSILON);
    real pad = (half.rad + REAL_EPSILON * (real_abs(half.mid) + most)) * (1 + 8 * REAL_EPSILON);
    c->t.lo = half.mid - most - pad;
    c->t.hi = half.mid - least + pad;
    c->s.lo = half.mid + least - pad;
    c->s.hi = half.mid + most + pad;
}

enum cubic_loop cubic_loop_find(const struct curve *f, struct crossing *c)
{
    struct fine u, d;
    if (f->degree != 3 || f->w || !sum_and_discriminant(f, &u, &d)) {
        return LOOP_UNKNOWN;
    }
    struct ball sum = fine_ball(u), square = fine_ball(d);
    real low = (square.mid - square.rad) / 4, high = (square.mid + square.rad) / 4;
    low -= REAL_EPSILON * real_abs(low);
    high += REAL_EPSILON * real_abs(high);
    if (!(high > 0) || are_one(f, 0, 1) || are_one(f, 2, 3)) {
        return LOOP_NONE;
    }
    roots_around(ball_of(sum.mid / 2, sum.rad / 2), low, high, c);
    if (c->t.hi < 0 || c->t.lo > 1 || c->s.hi < 0 || c->s.lo > 1) {
        return LOOP_NONE;
    }
    bool inside = in_domain(&c->t) && in_domain(&c->s);
    clip_to_domain(&c->t);
    clip_to_domain(&c->s);
    c->standing = !(low > 0) ? CANDIDATE : inside ? UNIQUE : END;
    c->at_most = c->standing == CANDIDATE ? 0 : 1;
    c->multiplicity = c->standing == UNIQUE;
    return LOOP_FOUND;
}

/* ---- candidates ---- */

static bool touches(const struct crossing *a, const struct crossing *b)
{
    return a->standing == CANDIDATE && b->standing == CANDIDATE && a->t.lo <= b->t.hi && b->t.lo <= a->t.hi &&
           a->s.lo <= b->s.hi && b->s.lo <= a->s.hi;
}

static void hold_both(struct interval *a, const struct interval *b)
{
    a->lo = real_min(a->lo, b->lo);
    a->hi = real_max(a->hi, b->hi);
}

/* As many steps as there are records, squared. */
void candidates_unite(struct crossings *out)
{
    int kept = 0;
    for (int i = 0; i < out->count; i++) {
        struct crossing c = out->at[i];
        for (int k = 0; k < kept; k++) {
            if (touches(&out->at[k], &c)) { /* larger now, it may touch any other */
                hold_both(&c.t, &out->at[k].t);
                hold_both(&c.s, &out->at[k].s);
                c.at_most = c.multiplicity = 0;
                out->at[k] = out->at[--kept];
                k = -1;
            }
        }
        out->at[kept++] = c;
    }
    out->count = kept;
}
