/* Breaks of the family and segments of its envelope. */
#include <math.h>

#include "cone.h"
#include "pieces.h"
#include "planes.h"

enum { CUTS = 4 * FORM_MAX };

/* Angle in degrees from the normal a to the normal b, in (-180, 180]; NaN-free: 0 without a direction. */
static double angle(const real *a, const real *b)
{
    const double degrees = 57.295779513082320877;
    double cross = real_to_double(a[0] * b[1] - a[1] * b[0]), dot = real_to_double(a[0] * b[0] + a[1] * b[1]);
    return cross == 0 && dot == 0 ? 0 : degrees * atan2(cross, dot);
}

/* The normal at t, or close to it where it has no direction: A and B may vanish at the end of a support. */
static void normal_near(const struct region_work *k, int span, real t, real other, real *n)
{
    struct half_plane p;
    n[0] = n[1] = 0;
    for (int i = 1; i < 4; i++) {
        if (half_plane_at(k, span, t, false, &p) && p.l[0] * p.l[0] + p.l[1] * p.l[1] > REAL_EPSILON) {
            n[0] = p.l[0];
            n[1] = p.l[1];
            return;
        }
        t = t + (other - t) * real_ldexp(1, -16 / i);
    }
}

/* Between roots of A and of B the normal turns by less than 90 degrees. */
static double turning(const struct region_work *k, int span, real lo, real hi)
{
    real a[2], b[2], m[2];
    real middle = lo + (hi - lo) / 2;
    normal_near(k, span, lo, hi, a);
    normal_near(k, span, middle, hi, m);
    normal_near(k, span, hi, lo, b);
    return angle(a, m) + angle(m, b);
}

static bool add(struct region_breaks *out, const struct region_work *k, int span, real t, int reasons)
{
    const struct span *s = &k->span[span];
    if (out->count == REGION_BREAKS_MAX) {
        return false;
    }
    struct region_break *b = &out->at[out->count++];
    b->span = span;
    b->t = t == 1 ? s->hi : s->lo + t * (s->hi - s->lo);
    b->reasons = reasons;
    b->type = 0;
    b->turning = 0;
    return true;
}

enum outcome region_breaks_find(const struct region_problem *p, struct region_workspace *w,
                                struct region_breaks *out)
{
    struct region_work *k = w->work;
    struct cut cut[CUTS];
    int piece = 0;
    (void)p;
    out->count = 0;
    k->steps = 0;
    if (!pieces_make(k, AT_ALL)) {
        return OUT_OF_ROOM;
    }
    for (int i = 0; i < k->spans; i++) {
        int cuts = span_cuts(k, &k->span[i], AT_ALL, CUTS, cut);
        bool room = cuts >= 0 && add(out, k, i, 0, i == 0 ? BREAK_END : BREAK_KNOT);
        for (int j = 0; room && j <= cuts; j++, piece++) {
            const struct piece *at = &k->piece[piece];
            out->at[out->count - 1].type = at->type;
            out->at[out->count - 1].turning = at->type ? turning(k, i, at->lo, at->hi) : 0;
            int last = i + 1 == k->spans ? BREAK_END : BREAK_KNOT;
            room = add(out, k, i, j < cuts ? cut[j].t : (real)1, j < cuts ? cut[j].reasons : last);
        }
        if (!room) {
            return OUT_OF_ROOM;
        }
    }
    return SOLVED;
}
