/* The one zero of two extended parts: Newton's method with a proved radius, as in solve_one.c, (1) and (2)
 * there, on vectors (f.x, f.y, g.x, g.y) and (t, t, s, s).
 *
 * Both curves are evaluated in powers of their own parameters, so all errors are those of the whole curves:
 * with L the largest |coordinate| of a curve's differences h0, h1, h2, and v its value,
 *
 *     C1 = 3 h0, C2 = 3 (h1 - h0), C3 = (h2 - h1) - (h1 - h0)    err by 6, 18, 12 u L, since
 *     |h| <= L, |h1 - h0| <= 2 L, |C1| <= 3 L, |C2| <= 6 L, |C3| <= 4 L;
 *     a value by Horner's rule with FMA adds u (10 L + 13 L) and u S:   noise  60 u L + u S;
 *     D2 = 2 C2 and D3 = 3 C3 err by 36 and 48 u L, Horner's rule adds 24 and 27 u L:   slope 141 u L.
 *
 * Past the ends of a part the tangent goes on: value + past * slope errs by |past| times the slope's noise
 * and 6 u L of rounding, whence 160 u L, and by another u S: of both curves 5 u S will do.  A raised curve's
 * points err by 3 u S: 3 u S of value, 18 u S of slope.
 */
#ifndef FATLINE_CERTIFIED_AVX2_ONE_H
#define FATLINE_CERTIFIED_AVX2_ONE_H

#include "avx2_parts.h"

enum { NEWTON_MAX = 12 };

/* Both curves in powers. */
struct powers {
    __m256d c0, c1, c2, c3, d2, d3;
    __m256d noise;       /* of f and g together, in each lane */
    __m256d slope_noise; /* of f, f, g, g */
};

AVX2_INLINE void powers_make(const struct part *f, const struct part *g, double unit, bool raised,
                             struct powers *out)
{
    const __m256d three = _mm256_set1_pd(3);
    __m256d p0 = _mm256_permute2f128_pd(f->point[0], g->point[0], 0x20),
            p1 = _mm256_permute2f128_pd(f->point[1], g->point[1], 0x20),
            p2 = _mm256_permute2f128_pd(f->point[2], g->point[2], 0x20),
            p3 = _mm256_permute2f128_pd(f->point[3], g->point[3], 0x20);
    __m256d h0 = _mm256_sub_pd(p1, p0), h1 = _mm256_sub_pd(p2, p1), h2 = _mm256_sub_pd(p3, p2);
    __m256d k0 = _mm256_sub_pd(h1, h0), k1 = _mm256_sub_pd(h2, h1);
    out->c0 = p0;
    out->c1 = _mm256_mul_pd(three, h0);
    out->c2 = _mm256_mul_pd(three, k0);
    out->c3 = _mm256_sub_pd(k1, k0);
    out->d2 = _mm256_add_pd(out->c2, out->c2);
    out->d3 = _mm256_mul_pd(three, out->c3);
    __m256d size = _mm256_max_pd(_mm256_max_pd(absolute(h0), absolute(h1)), absolute(h2));
    size = _mm256_mul_pd(_mm256_max_pd(size, neighbours(size)), _mm256_set1_pd(DBL_EPSILON / 2));
    __m256d both = _mm256_add_pd(size, other_half(size));
    out->noise = _mm256_fmadd_pd(_mm256_set1_pd(60), both, _mm256_set1_pd((raised ? 11 : 5) * unit));
    out->slope_noise = _mm256_fmadd_pd(_mm256_set1_pd(160), size, _mm256_set1_pd(raised ? 20 * unit : 0));
}

/* In the domain. */
AVX2_INLINE void powers_at(const struct powers *p, __m256d t, __m256d *value, __m256d *slope)
{
    *slope = _mm256_fmadd_pd(_mm256_fmadd_pd(p->d3, t, p->d2), t, p->c1);
    *value = _mm256_fmadd_pd(_mm256_fmadd_pd(_mm256_fmadd_pd(p->c3, t, p->c2), t, p->c1), t, p->c0);
}

/* One pair of parts, and what bounds its zero. */
struct arms {
    __m256d lo, hi;
    __m256d reach; /* B of solve_one.c: V_g h_f / (3 c) for t, V_f h_g / (3 c) for s */
    __m256d bend;  /* |f''|, |g''| by the curves' own parameters */
};

AVX2_INLINE __m256d halves(double t, double s)
{
    return _mm256_set_m128d(_mm_set1_pd(s), _mm_set1_pd(t));
}

AVX2_INLINE void arms_make(const struct part *f, const struct part *g, double c, struct arms *out)
{
    const double up = 1 + 8 * DBL_EPSILON, k = up / (3 * c);
    __m256d width = halves(f->width, g->width);
    out->lo = halves(f->lo, g->lo);
    out->hi = _mm256_add_pd(out->lo, width); /* dyadic: exact */
    out->reach = _mm256_mul_pd(halves(g->speed * k, f->speed * k), width);
    out->bend = _mm256_div_pd(halves(6 * up * f->bend, 6 * up * g->bend), _mm256_mul_pd(width, width));
}

/* A Newton step, from a point where the curves' difference is r in the lower half and -r in the upper. */
struct newton {
    __m256d slope; /* f', g' */
    __m256d det;   /* cross(f', g') and, in the upper half, its negative */
    __m256d by;    /* dt, dt, ds, ds: to be subtracted */
};

AVX2_INLINE void newton_step(__m256d slope, __m256d r, struct newton *out)
{
    __m256d turned = neighbours(other_half(slope));
    __m256d products = _mm256_mul_pd(slope, turned), moments = _mm256_mul_pd(r, turned);
    out->slope = slope;
    out->det = _mm256_hsub_pd(products, products);
    __m256d one_over = _mm256_div_pd(_mm256_set1_pd(1), out->det); /* while r is still being made */
    out->by = _mm256_mul_pd(_mm256_hsub_pd(moments, moments), one_over);
}

/* Where the chords meet. */
AVX2_INLINE __m256d chords_meet(const struct part *f, const struct part *g, const struct arms *a)
{
    __m256d from = _mm256_permute2f128_pd(f->point[0], g->point[0], 0x20);
    __m256d to = _mm256_permute2f128_pd(f->point[3], g->point[3], 0x20);
    struct newton n;
    newton_step(_mm256_sub_pd(to, from), _mm256_sub_pd(from, other_half(from)), &n);
    return _mm256_fnmadd_pd(n.by, _mm256_sub_pd(a->hi, a->lo), a->lo);
}

AVX2_INLINE __m256d both_halves(__m256d a)
{
    return _mm256_add_pd(a, other_half(a));
}

/* solve_one.c: radii after the last step, noise E there.  False: k u > 1/128, and nothing is proved. */
AVX2_INLINE bool newton_radii(const struct powers *p, const struct arms *a, const struct newton *n,
                              __m256d noise, __m256d at, __m256d *out)
{
    const __m256d eps = _mm256_set1_pd(DBL_EPSILON), one = _mm256_set1_pd(1),
                  up = _mm256_set1_pd(1 + 8 * DBL_EPSILON);
    __m256d step = absolute(n->by), det = absolute(n->det), own = absolute(n->slope);
    own = _mm256_add_pd(own, neighbours(own)); /* |f'|, |f'|, |g'|, |g'| */
    __m256d its = other_half(own), area = _mm256_mul_pd(own, its);
    if (!(64 * DBL_EPSILON * _mm256_cvtsd_f64(area) <= _mm256_cvtsd_f64(det))) {
        return false;
    }
    __m256d solving =
        _mm256_mul_pd(_mm256_set1_pd(8 * DBL_EPSILON), _mm256_add_pd(one, _mm256_div_pd(area, det)));
    __m256d way = _mm256_mul_pd(step, _mm256_fmadd_pd(own, solving, p->slope_noise));
    __m256d left = _mm256_add_pd(_mm256_add_pd(noise, noise), both_halves(way));
    __m256d radius = _mm256_mul_pd(a->reach, left);
    __m256d change = _mm256_fmadd_pd(a->bend, _mm256_add_pd(step, radius), p->slope_noise);
    __m256d its_change = other_half(change);
    __m256d lost = both_halves(_mm256_mul_pd(change, _mm256_add_pd(its, its_change)));
    lost = _mm256_fmadd_pd(_mm256_mul_pd(_mm256_set1_pd(4), eps), area, lost);
    __m256d least = _mm256_sub_pd(det, lost);
    __m256d sharp = _mm256_mul_pd(_mm256_div_pd(_mm256_mul_pd(left, up), least),
                                  _mm256_add_pd(its, _mm256_add_pd(its_change, its_change)));
    __m256d holds = _mm256_cmp_pd(_mm256_add_pd(least, least), det, _CMP_GT_OQ);
    radius = _mm256_blendv_pd(radius, _mm256_min_pd(radius, sharp), holds);
    *out = _mm256_fmadd_pd(eps, absolute(at), radius);
    return true;
}

/* The zero of parts with parts_cross c > 0, in the curves' own parameters; NO_ZERO: it is outside them. */
enum search { STUCK, NO_ZERO, ZERO };
AVX2_INLINE enum search solve_parts(const struct powers *p, const struct part *f, const struct part *g,
                                    double c, struct arms *a, __m256d *zero, __m256d *radius)
{
    arms_make(f, g, c, a);
    __m256d at = chords_meet(f, g, a);
    for (int k = 0; k < NEWTON_MAX; k++) {
        __m256d noise = p->noise, value, slope;
        __m256d beyond =
            _mm256_or_pd(_mm256_cmp_pd(at, a->lo, _CMP_LT_OQ), _mm256_cmp_pd(at, a->hi, _CMP_GT_OQ));
        if (_mm256_testz_pd(beyond, beyond)) {
            powers_at(p, at, &value, &slope);
        } else {
            __m256d in = _mm256_min_pd(_mm256_max_pd(at, a->lo), a->hi), past = _mm256_sub_pd(at, in);
            powers_at(p, in, &value, &slope);
            value = _mm256_fmadd_pd(past, slope, value);
            noise = _mm256_add_pd(both_halves(_mm256_mul_pd(absolute(past), p->slope_noise)), noise);
        }
        __m256d r = _mm256_sub_pd(value, other_half(value));
        __m256d far = absolute(r);
        far = _mm256_max_pd(far, neighbours(far));
        __m256d reach = _mm256_mul_pd(a->reach, _mm256_add_pd(far, noise));
        __m256d out = _mm256_or_pd(_mm256_cmp_pd(_mm256_sub_pd(at, reach), a->hi, _CMP_GT_OQ),
                                   _mm256_cmp_pd(_mm256_add_pd(at, reach), a->lo, _CMP_LT_OQ));
        if (!_mm256_testz_pd(out, out)) {
            return NO_ZERO;
        }
        struct newton n;
        newton_step(slope, r, &n);
        at = _mm256_sub_pd(at, n.by);
        __m256d rest = both_halves(_mm256_mul_pd(a->bend, _mm256_mul_pd(n.by, n.by)));
        if (_mm256_cvtsd_f64(rest) <= 2 * _mm256_cvtsd_f64(noise)) {
            *zero = at;
            return newton_radii(p, a, &n, noise, at, radius) ? ZERO : STUCK;
        }
    }
    return STUCK;
}

#endif
