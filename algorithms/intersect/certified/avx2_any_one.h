/* The one zero of two extended parts for the front kernel: theorem and bounds are those of solve_one.c.
 *
 * The whole curves are evaluated, a value and its derivative in one vector: the sums of C(n, i) c[i] v^(n-i)
 * t^i and n C(n-1, i) (c[i+1] - c[i]) v^(n-1-i) t^i, v = 1 - t, by Horner's rule in v (evaluate.h).  A fused
 * product rounds once less, so the errors are below (3n + 4) u S and n (3n + 6) u V, V the largest 1-norm of
 * a difference of the whole curve. */
#ifndef FATLINE_CERTIFIED_AVX2_ANY_ONE_H
#define FATLINE_CERTIFIED_AVX2_ANY_ONE_H

#include "avx2_any_cones.h"

#ifdef FATLINE_AVX2

/* A whole curve made ready: (C x, C y, C' x', C' y'). */
struct ready {
    int n;
    double noise, slope_noise;
    __m256d at[DEGREE_MAX + 1];
};

/* One side of the pair. */
struct side {
    double lo, hi;
    double reach; /* |t - t*| <= reach |H| */
    double bend;  /* no coordinate of f'' is larger, by the parameter of the curve */
    double t, radius;
    double x, y, dx, dy, past; /* of the extended part at t, and how far t is outside */
};

enum search_of_one { LOST, NOWHERE, SOMEWHERE };

/* Binomials are exact: C(n, i) (n - i) < 2^53. */
FATLINE_AVX2 static void ready_make(const struct arcs *c, double unit, struct ready *out)
{
    int n = c->n;
    const __m256d *p = arc_points(c, 1);
    double above[DEGREE_MAX + 1];
    above[0] = above[n] = 1;
    for (int i = 1; 2 * i <= n; i++) {
        above[i] = above[n - i] = above[i - 1] * (n - i + 1) / i;
    }
    for (int i = 0; i <= n; i++) {
        /* n C(n - 1, i) = (n - i) C(n, i) */
        __m256d slope = (p[i < n ? i + 1 : n] - p[i]) * _mm256_set1_pd((n - i) * above[i]);
        out->at[i] = _mm256_permute2f128_pd(p[i] * _mm256_set1_pd(above[i]), slope, 0x20);
    }
    out->n = n;
    out->noise = (3 * n + 4) * unit;
    out->slope_noise = n * (3 * n + 6) * (DBL_EPSILON / 2) * c->arc[1].speed;
}

/* The sums for t^n and for the slope, by powers of t; *power: t^n. */
AVX2_ANY __m256d sums_at(int n, const struct ready *c, __m256d t, __m256d v, __m256d *power)
{
    __m256d sum = c->at[0];
    *power = t;
#pragma GCC unroll 8
    for (int i = 1; i < n; i++) {
        sum = _mm256_fmadd_pd(sum, v, c->at[i] * *power);
        *power = *power * t;
    }
    return sum;
}

AVX2_ANY __m256d sums_of(const struct ready *c, __m256d t, __m256d v, __m256d *power)
{
    switch (c->n) {
    case 4:
        return sums_at(4, c, t, v, power);
    case 5:
        return sums_at(5, c, t, v, power);
    case 6:
        return sums_at(6, c, t, v, power);
    case 7:
        return sums_at(7, c, t, v, power);
    case 8:
        return sums_at(8, c, t, v, power);
    default:
        return sums_at(c->n, c, t, v, power);
    }
}

AVX2_ANY void spot_of(const struct ready *c, struct side *a)
{
    double inside = a->t < a->lo ? a->lo : a->t > a->hi ? a->hi : a->t, past = a->t - inside;
    __m256d t = _mm256_set1_pd(inside), v = _mm256_set1_pd(1 - inside), power;
    __m256d sum = sums_of(c, t, v, &power);
    __m256d value = _mm256_fmadd_pd(sum, v, c->at[c->n] * power);
    __m128d slope = _mm256_extractf128_pd(sum, 1);
    __m128d at = _mm_fmadd_pd(_mm_set1_pd(past), slope, _mm256_castpd256_pd128(value));
    a->past = fabs(past);
    a->x = _mm_cvtsd_f64(at);
    a->y = _mm_cvtsd_f64(_mm_unpackhi_pd(at, at));
    a->dx = _mm_cvtsd_f64(slope);
    a->dy = _mm_cvtsd_f64(_mm_unpackhi_pd(slope, slope));
}

AVX2_ANY void side_make(const struct arcs *c, int k, const struct arc *other, double gap, struct side *out)
{
    const struct arc *a = &c->arc[k];
    int depth = 31 - __builtin_clz((unsigned)k), first = 1 << depth;
    double parts = first, width = 1 / parts; /* exact */
    out->lo = (k - first) * width;
    out->hi = (k - first + 1) * width;
    out->reach = other->speed * width / (c->n * gap) * (1 + 8 * DBL_EPSILON);
    out->bend = a->bend * (parts * parts);
}

/* What is left of |H| after the last step (dt, ds), and radii by the whole part and by the zero's own
 * neighbourhood: solve_one.c, (1) and (2).  False: k u > 1/128 there, and nothing is proved. */
AVX2_ANY bool radii_make(const struct ready *of_f, const struct ready *of_g, double dt, double ds, double det,
                         double error, struct side *f, struct side *g)
{
    double df = fabs(f->dx) + fabs(f->dy), dg = fabs(g->dx) + fabs(g->dy);
    if (!(64 * DBL_EPSILON * (df * dg) <= det)) {
        return false;
    }
    double tilt = df * dg / det, way = df * dt + dg * ds;
    double left =
        2 * error + way * (8 * DBL_EPSILON * (1 + tilt)) + of_f->slope_noise * dt + of_g->slope_noise * ds;
    f->radius = f->reach * left;
    g->radius = g->reach * left;
    double change_f = f->bend * (dt + f->radius) + of_f->slope_noise;
    double change_g = g->bend * (ds + g->radius) + of_g->slope_noise;
    double least = det - change_f * dg - change_g * df - 2 * change_f * change_g - 4 * DBL_EPSILON * df * dg;
    if (2 * least > det) {
        double by = left * (1 + 8 * DBL_EPSILON) / least;
        f->radius = real_min(f->radius, by * (dg + 2 * change_g));
        g->radius = real_min(g->radius, by * (df + 2 * change_f));
    }
    f->radius += DBL_EPSILON * fabs(f->t);
    g->radius += DBL_EPSILON * fabs(g->t);
    return true;
}

AVX2_ANY bool is_outside(const struct side *a, double radius)
{
    return (a->t - radius > a->hi) | (a->t + radius < a->lo);
}

/* Newton's method from where the chords meet; f and g are made but for t. */
FATLINE_AVX2 static enum search_of_one one_zero(const struct ready *of_f, const struct ready *of_g,
                                                struct side *f, struct side *g)
{
    enum { ITERATIONS_MAX = 12 };
    for (int k = 0; k < ITERATIONS_MAX; k++) {
        spot_of(of_f, f);
        spot_of(of_g, g);
        double x = f->x - g->x, y = f->y - g->y, far = real_max(fabs(x), fabs(y));
        double error = of_f->noise + of_g->noise + f->past * of_f->slope_noise + g->past * of_g->slope_noise;
        far = far * (1 + 4 * DBL_EPSILON) + error;
        if (is_outside(f, f->reach * far) | is_outside(g, g->reach * far)) {
            return NOWHERE;
        }
        double det = f->dx * g->dy - f->dy * g->dx, one = 1 / det;
        double dt = (x * g->dy - y * g->dx) * one, ds = (x * f->dy - y * f->dx) * one;
        f->t -= dt;
        g->t -= ds;
        if (f->bend * (dt * dt) + g->bend * (ds * ds) <= 2 * error) {
            if (!radii_make(of_f, of_g, fabs(dt), fabs(ds), fabs(det), error, f, g)) {
                return LOST;
            }
            return is_outside(f, f->radius) || is_outside(g, g->radius) ? NOWHERE : SOMEWHERE;
        }
    }
    return LOST;
}

#endif
#endif
