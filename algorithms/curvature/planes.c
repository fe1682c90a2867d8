#include "planes.h"

#include "../core/bernstein.h"
#include "cone.h"
#include "form.h"

bool half_plane_at(const struct region_work *k, int span, real t, bool corner, struct half_plane *out)
{
    const struct span_forms *f = &k->span[span].form;
    real value[4];
    if (t == 0 || t == 1) {
        for (int c = 0; c < 4; c++) {
            value[c] = f->L[c * (f->l + 1) + (t == 0 ? 0 : f->l)];
        }
    } else {
        form_values(f->l, 4, k->pascal, f->L, t, value);
    }
    real length = triple_normalise(value);
    out->source = MEMBER;
    out->corner = corner;
    out->span = span;
    out->t = t;
    for (int c = 0; c < 3; c++) {
        out->l[c] = value[c];
    }
    if (!(length > value[3] * REAL_EPSILON)) {
        return false;
    }
    out->error = 3 * REAL_EPSILON * (1 + value[3] / length);
    return true;
}

void envelope_at(const struct region_work *k, int span, real t, real *v)
{
    const struct span_forms *f = &k->span[span].form;
    form_values(f->e, 3, k->pascal, f->w, t, v);
    triple_normalise(v);
    if (v[2] < 0) {
        for (int c = 0; c < 3; c++) {
            v[c] = -v[c];
        }
    }
}

/* Downhill from t, by Newton's method for a minimum while the value falls. */
static real descend(int n, const real *pascal, const real *c, real t, real *value)
{
    real d[FORM_MAX];
    form_values(n, 1, pascal, c, t, value);
    if (n < 2) {
        return t;
    }
    bernstein_derivative(n, c, d);
    for (int i = 0; i < 8; i++) {
        real curvature, at, slope = form_value_slope(n - 1, pascal, d, t, &curvature);
        real step = curvature > 0 ? -slope / curvature : slope > 0 ? (real)-1 / 8 : (real)1 / 8;
        real next = real_min(1, real_max(0, t + step));
        form_values(n, 1, pascal, c, next, &at);
        if (!(at < *value)) {
            return t;
        }
        *value = at;
        t = next;
    }
    return t;
}

/* Where c is least, or nearly: downhill from the least coefficient and from `start`. */
static real lowest(int n, const real *pascal, const real *c, real start)
{
    int least = 0;
    real value[2];
    for (int i = 1; i <= n; i++) {
        least = c[i] < c[least] ? i : least;
    }
    real a = descend(n, pascal, c, n > 0 ? (real)least / n : (real)0, &value[0]);
    real b = descend(n, pascal, c, start, &value[1]);
    return value[0] < value[1] ? a : b;
}

static void heights(const struct piece *p, int l, const real *v, real error, real *h, real *bound)
{
    const real *A = p->L, *B = A + l + 1, *C = B + l + 1, *E = C + l + 1;
    for (int i = 0; i <= l; i++) {
        h[i] = A[i] * v[0] + B[i] * v[1] + C[i] * v[2];
        bound[i] = 2 * REAL_EPSILON * E[i] + error * (real_abs(A[i]) + real_abs(B[i]) + real_abs(C[i]));
    }
}

enum verdict piece_holds(struct region_work *k, const struct piece *p, const real *v, real error, real *where)
{
    real h[FORM_MAX], bound[FORM_MAX], t;
    int l = k->span[p->span].form.l;
    heights(p, l, v, error, h, bound);
    enum verdict verdict = form_holds(k, l, h, bound, &t);
    if (verdict == FAILS) {
        t = lowest(l, k->pascal, h, t);
        *where = t == 0 ? p->lo : t == 1 ? p->hi : p->lo + t * (p->hi - p->lo);
    }
    return verdict;
}

static bool is_excepted(const struct piece *p, const struct piece *except)
{
    int turn = except ? p->quarter - except->quarter : 0;
    return except && p->type > 0 && p->chain == except->chain && turn >= -1 && turn <= 1;
}

enum verdict planes_hold(struct region_work *k, const struct piece *a, const struct piece *b, const real *v,
                         real error, struct half_plane *worst)
{
    enum verdict all = HOLDS;
    real lowest = 0, t;
    struct half_plane plane;
    for (int i = 0; i < k->pieces + k->chords; i++) {
        bool is_chord = i >= k->pieces;
        if (is_chord) {
            plane = k->chord[i - k->pieces];
        } else if (is_excepted(&k->piece[i], a) || is_excepted(&k->piece[i], b)) {
            continue;
        } else {
            enum verdict one = piece_holds(k, &k->piece[i], v, error, &t);
            all = one != HOLDS && all == HOLDS ? UNSURE : all;
            if (one != FAILS || !half_plane_at(k, k->piece[i].span, t, false, &plane)) {
                continue;
            }
        }
        real height = triple_dot(plane.l, v);
        if (height < lowest && height < -(plane.error + error)) {
            lowest = height;
            *worst = plane;
            all = FAILS;
        }
    }
    return all;
}
