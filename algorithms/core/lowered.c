#include "lowered.h"

#include "bernstein.h"
#include "reduce.h"

/* Does c look like a curve of lower degree?  Only its highest difference is tested. */
static bool may_be_reduced(const struct arc *c, real scale)
{
    real top = 0, size = 0;
    for (int k = 0; k < (c->w ? 3 : 2); k++) {
        const real *p = k == 0 ? c->x : k == 1 ? c->y : c->w;
        real difference = 0;
        for (int i = 0; i <= c->degree; i++) {
            real b = binomial(c->degree, i);
            difference += i % 2 ? -b * p[i] : b * p[i];
            size += b * real_max(real_abs(p[i]), c->w ? scale * c->w[i] : scale);
        }
        top = real_max(top, real_abs(difference));
    }
    return top <= 16 * REAL_EPSILON * size;
}

/* Replaces c by its best approximation of degree k if the two are the same to rounding. */
static bool reduce_to(int k, const struct arc *c, real scale, struct lowered *s)
{
    const int n = c->degree;
    real memory[2 * POINTS_MAX * (REDUCED_MAX + 1)], residual[POINTS_MAX], off = 0, least = 1;
    struct reduction r;
    reduction_init(&r, n, k, memory);
    for (int j = 0; j < s->components; j++) {
        const real *p = j == 0 ? c->x : j == 1 ? c->y : c->w;
        real *q = s->homogeneous + j * (k + 1);
        reduction_apply(&r, 1, p, q);
        real bound = reduction_residual(&r, 1, p, q, residual), most = 0;
        for (int i = 0; i <= n; i++) {
            most = real_max(most, real_abs(residual[i]));
        }
        off += (bound + most) * (j < 2 ? (real)1 : scale);
    }
    for (int i = 0; c->w && i <= k; i++) {
        least = i == 0 ? s->homogeneous[2 * (k + 1)] : real_min(least, s->homogeneous[2 * (k + 1) + i]);
    }
    s->polygon.error = least > 0 ? 2 * off / least : REAL_HUGE;
    return s->polygon.error <= 32 * n * REAL_EPSILON * scale;
}

/* What follows from the homogeneous coordinates, which err by `error` in the plane. */
static void complete(struct lowered *s, int n, real error)
{
    const real *w = s->components == 3 ? s->homogeneous + 2 * (n + 1) : NULL;
    s->extent = s->size = 0;
    for (int k = 0; k < 2; k++) {
        real *e = s->euclidean + k * (n + 1), lo = REAL_HUGE, hi = -REAL_HUGE;
        for (int i = 0; i <= n; i++) {
            e[i] = s->homogeneous[k * (n + 1) + i];
            e[i] = w ? e[i] / w[i] : e[i];
            lo = real_min(lo, e[i]);
            hi = real_max(hi, e[i]);
        }
        s->extent = real_max(s->extent, real_max(real_abs(lo), real_abs(hi)));
        s->size = real_max(s->size, hi - lo);
    }
    s->polygon.degree = n;
    s->polygon.x = s->euclidean;
    s->polygon.y = s->euclidean + n + 1;
    s->polygon.w = w;
    s->polygon.error = error + (w ? REAL_EPSILON * s->extent : (real)0); /* quotients, rounded */
}

void lowered_take(const struct arc *c, struct lowered *s)
{
    const int n = c->degree;
    s->components = c->w ? 3 : 2;
    s->reduced = false;
    for (int i = 0; i < s->components * (n + 1); i++) {
        const real *p = i <= n ? c->x : i <= 2 * n + 1 ? c->y : c->w;
        s->homogeneous[i] = p[i % (n + 1)];
    }
    complete(s, n, c->error);
}

void lowered_init(const struct arc *c, real scale, struct lowered *s)
{
    s->components = c->w ? 3 : 2;
    s->reduced = false;
    if (c->degree > 1 && may_be_reduced(c, scale)) {
        for (int k = 1; k <= REDUCED_MAX && k < c->degree; k++) {
            s->reduced = reduce_to(k, c, scale, s);
            if (s->reduced) {
                complete(s, k, c->error + s->polygon.error);
                return;
            }
        }
    }
    lowered_take(c, s);
}

/* Cutting errs by 8n u |x| (bernstein.h), in quotients twice. */
void lowered_cut(const struct lowered *s, real lo, real hi, struct lowered *part)
{
    const int n = s->polygon.degree;
    part->components = s->components;
    part->reduced = true;
    bernstein_restrict(n, s->components, s->homogeneous, lo, hi, part->homogeneous);
    complete(part, n, s->polygon.error + 4 * (s->components - 1) * n * REAL_EPSILON * s->extent);
}
