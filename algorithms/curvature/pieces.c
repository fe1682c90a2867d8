#include "pieces.h"

#include "../core/bernstein.h"
#include "cone.h"
#include "form.h"
#include "planes.h"

enum { CUTS = 4 * FORM_MAX };

/* ---- where to cut ---- */

static int add_cuts(struct region_work *k, int n, const real *c, const real *error, int reason, int room,
                    int count, struct cut *out)
{
    real t[FORM_MAX];
    int roots = count < 0 ? -1 : form_crossings(k, n, c, error, FORM_MAX, t);
    if (roots < 0 || count + roots > room) {
        return -1;
    }
    for (int i = 0; i < roots; i++) {
        int at = count++;
        for (; at > 0 && out[at - 1].t > t[i]; at--) {
            out[at] = out[at - 1];
        }
        out[at].t = t[i];
        out[at].reasons = reason;
    }
    return count;
}

static int merge_cuts(int count, struct cut *out)
{
    const real close = real_ldexp(1, -REAL_BITS / 2);
    int kept = 0;
    for (int i = 0; i < count; i++) {
        if (kept > 0 && out[i].t - out[kept - 1].t <= close) {
            /* M's root is the one that matters: its tangent is a corner line */
            out[kept - 1].t = (out[i].reasons & BREAK_M) ? out[i].t : out[kept - 1].t;
            out[kept - 1].reasons |= out[i].reasons;
        } else {
            out[kept++] = out[i];
        }
    }
    return kept;
}

/* Error bounds for the coefficients of w: the noise of differences of coefficients of size below 4. */
static void envelope_noise(const struct region_work *k, int e, real *error)
{
    for (int i = 0; i <= e; i++) {
        error[i] = 16 * k->degree * REAL_EPSILON;
    }
}

int span_cuts(struct region_work *k, const struct span *s, enum cuts cuts, int room, struct cut *out)
{
    const struct span_forms *f = &s->form;
    real error[FORM_MAX];
    int count = 0, length = f->l + 1;
    if (f->m > 0) {
        count = add_cuts(k, f->m, f->M, f->M + f->m + 1, BREAK_M, room, count, out);
    }
    if (cuts == AT_ALL && !f->fixed) {
        envelope_noise(k, f->e, error);
        count = add_cuts(k, f->e, f->w + 2 * (f->e + 1), error, BREAK_N, room, count, out);
        for (int i = 0; i < length; i++) {
            error[i] = f->L[3 * length + i] * REAL_EPSILON;
        }
        count = add_cuts(k, f->l, f->L, error, BREAK_A, room, count, out);
        count = add_cuts(k, f->l, f->L + length, error, BREAK_B, room, count, out);
    }
    return count < 0 ? -1 : merge_cuts(count, out);
}

/* ---- the pieces ---- */

static int sign(real a)
{
    return a > 0 ? 1 : a < 0 ? -1 : 0;
}

/* S+ is where sign w3 M > 0. */
static int type_at(const struct region_work *k, const struct span_forms *f, real t)
{
    real w3, M;
    if (f->m < 0 || f->fixed) {
        return 0;
    }
    form_values(f->e, 1, k->pascal, f->w + 2 * (f->e + 1), t, &w3);
    form_values(f->m, 1, k->pascal, f->M, t, &M);
    return k->sign * sign(w3) * sign(M);
}

static real *take(struct region_work *k, size_t length)
{
    if (k->piece_used + length > k->piece_length) {
        return NULL;
    }
    k->piece_used += length;
    return k->piece_pool + (k->piece_used - length);
}

static bool add_piece(struct region_work *k, int span, real lo, real hi, enum cuts cuts)
{
    const struct span_forms *f = &k->span[span].form;
    if (k->pieces == k->room_pieces) {
        return false;
    }
    struct piece *p = &k->piece[k->pieces++];
    p->span = span;
    p->lo = lo;
    p->hi = hi;
    p->L = f->L;
    p->w = f->w;
    p->type = p->chain = p->quarter = 0;
    if (lo > 0 || hi < 1) {
        real *L = take(k, 4 * (size_t)(f->l + 1));
        if (!L) {
            return false;
        }
        bernstein_restrict(f->l, 4, f->L, lo, hi, L);
        p->L = L;
    }
    if (cuts != AT_ALL) {
        return true;
    }
    p->type = type_at(k, f, lo + (hi - lo) / 2);
    if (p->type > 0 && (lo > 0 || hi < 1)) {
        real *w = take(k, 3 * (size_t)(f->e + 1));
        if (!w) {
            return false;
        }
        bernstein_restrict(f->e, 3, f->w, lo, hi, w);
        p->w = w;
    }
    return true;
}

/* Unit vectors on one line through 0, to within what neighbouring spans agree in. */
static bool is_parallel(const real *a, const real *b)
{
    real c[3], close = real_ldexp(1, -REAL_BITS / 2);
    triple_cross(a, b, c);
    return triple_dot(c, c) <= close * close;
}

bool joint_is_smooth(const struct region_work *k, int span)
{
    struct half_plane left, right;
    real v[3], w[3];
    if (!half_plane_at(k, span, 1, true, &left) || !half_plane_at(k, span + 1, 0, true, &right) ||
        !is_parallel(left.l, right.l) || !(triple_dot(left.l, right.l) > 0)) {
        return false;
    }
    envelope_at(k, span, 1, v);
    envelope_at(k, span + 1, 0, w);
    return is_parallel(v, w);
}

/* An arc that leaves to infinity and comes back from there is not convex. */
static bool joint_is_finite(const struct region_work *k, int span)
{
    real v[3];
    envelope_at(k, span, 1, v);
    return v[2] > real_ldexp(1, -REAL_BITS / 2);
}

/* The quadrant of the normal in the middle of a piece, 0 to 3, counted the way in which normals turn on S+.
 */
static int quadrant(const struct region_work *k, const struct piece *p)
{
    const struct span_forms *f = &k->span[p->span].form;
    real normal[2];
    form_values(f->l, 2, k->pascal, f->L, p->lo + (p->hi - p->lo) / 2, normal);
    int counter_clockwise = normal[1] >= 0 ? (normal[0] >= 0 ? 0 : 1) : (normal[0] < 0 ? 2 : 3);
    return k->sign > 0 ? counter_clockwise : 3 - counter_clockwise;
}

/* Chains of arcs, and in each the quarters: the tangent turns by pi/2 at most between roots of A and of B,
 * which may lie on a knot, where neither span shows them.  So the quadrants are compared as well. */
static void number_chains(struct region_work *k, int first, const struct cut *cut)
{
    for (int i = first; i < k->pieces; i++) {
        struct piece *p = &k->piece[i];
        const struct piece *before = i > 0 ? p - 1 : NULL;
        int reasons = i > first ? cut[i - first - 1].reasons : 0;
        bool goes_on = before && before->type > 0 && p->type > 0 && !(reasons & (BREAK_M | BREAK_N));
        if (i == first) {
            goes_on = goes_on && joint_is_smooth(k, before->span) && joint_is_finite(k, before->span);
        }
        p->chain = before ? before->chain + !goes_on : 0;
        p->quarter = 0;
        if (goes_on) {
            int turned = (quadrant(k, p) - quadrant(k, before) + 4) % 4;
            bool cut_here = (reasons & (BREAK_A | BREAK_B)) != 0;
            p->quarter = before->quarter + (turned > 0 ? turned : cut_here);
        }
    }
}

bool pieces_make(struct region_work *k, enum cuts cuts)
{
    struct cut cut[CUTS + 1];
    k->pieces = 0;
    k->piece_used = 0;
    for (int i = 0; i < k->spans; i++) {
        int count = span_cuts(k, &k->span[i], cuts, CUTS, cut), first = k->pieces;
        real lo = 0;
        for (int j = 0; j <= count; j++) {
            real hi = j < count ? cut[j].t : (real)1;
            if (!add_piece(k, i, lo, hi, cuts)) {
                return false;
            }
            lo = hi;
        }
        if (count < 0) {
            return false;
        }
        if (cuts == AT_ALL) {
            number_chains(k, first, cut);
        }
    }
    return true;
}

/* ---- narrow pieces ---- */

/* Coefficients within 60 degrees of their sum, but for those that are noise. */
static bool is_narrow(const struct piece *p, int l)
{
    real sum[3] = {0, 0, 0};
    for (int i = 0; i <= l; i++) {
        for (int c = 0; c < 3; c++) {
            sum[c] += p->L[c * (l + 1) + i];
        }
    }
    triple_normalise(sum);
    for (int i = 0; i <= l; i++) {
        const real v[3] = {p->L[i], p->L[l + 1 + i], p->L[2 * (l + 1) + i]};
        real along = triple_dot(v, sum), noise = 4 * REAL_EPSILON * p->L[3 * (l + 1) + i];
        if (triple_dot(v, v) > real_max(4 * along * real_max(along, 0), noise * noise)) {
            return false;
        }
    }
    return true;
}

bool pieces_make_narrow(struct region_work *k, bool *all)
{
    enum { HALVINGS = 24 };
    real hi[HALVINGS + 1];
    k->pieces = 0;
    k->piece_used = 0;
    *all = true;
    for (int span = 0; span < k->spans; span++) {
        int top = 0, reserve = 2 * (k->spans - span);
        real lo = 0;
        hi[0] = 1;
        while (top >= 0) {
            size_t used = k->piece_used;
            if (!add_piece(k, span, lo, hi[top], AT_TORSION)) {
                return false;
            }
            bool narrow = is_narrow(&k->piece[k->pieces - 1], k->span[span].form.l);
            if (!narrow && top < HALVINGS && k->pieces + top + reserve < k->room_pieces) {
                k->pieces--;
                k->piece_used = used;
                hi[top + 1] = lo + (hi[top] - lo) / 2;
                top++;
                continue;
            }
            *all = *all && narrow;
            lo = hi[top--];
        }
    }
    return true;
}
