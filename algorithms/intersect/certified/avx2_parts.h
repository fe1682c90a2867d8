/* Parts of a cubic in doubles, with AVX2 and FMA: what cubic_avx2.c halves.
 *
 * A control point is carried as the four forms (x, y, x + y, x - y) of an octagon, so that halving and
 * bounding cost for four what they cost for one.
 *
 * Let S be the largest |coordinate| of both curves, u = 2^-53.  The forms x and y of a root's points are
 * exact, or within 3 u S of those of a raised curve (cubic_avx2.c); one halving adds at most 3 u S, since
 * each of its three averages rounds its sum once.  So at depth d <= 11 a coordinate errs by at most 3 (d + 1)
 * u S <= E = 37 u S (terms of u^2 included), and x + y and x - y, of size 2 S and rounded once more at the
 * root, by 2 E. */
#ifndef FATLINE_CERTIFIED_AVX2_PARTS_H
#define FATLINE_CERTIFIED_AVX2_PARTS_H

#include <immintrin.h>

#include "front.h"

#define AVX2_INLINE FATLINE_AVX2 __attribute__((always_inline)) static inline

enum { PARTS_MAX = 64, PART_DEPTH_MAX = 11 };

struct part {
    __m256d point[4];
    __m256d low, high;   /* the exact arc's octagon lies within */
    double ax[4], ay[4]; /* differences of the points; the last twice */
    double lo, width;    /* a dyadic interval: exact */
    double speed;        /* no exact difference is longer in the 1-norm */
    double bend;         /* no coordinate of an exact second difference is larger */
    struct part *child;  /* the first of two halves, the other is next to it; NULL: none yet */
    int depth;
    bool ready; /* differences, speed and bend are made */
};

/* The parts of one curve; [0] is the whole. */
struct parts {
    int used;
    struct part part[PARTS_MAX];
};

AVX2_INLINE __m256d absolute(__m256d a)
{
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}

AVX2_INLINE __m256d other_half(__m256d a)
{
    return _mm256_permute2f128_pd(a, a, 1);
}

AVX2_INLINE __m256d neighbours(__m256d a)
{
    return _mm256_permute_pd(a, 5);
}

/* E + u S of rounding for x and y, twice that for the sums: 40 u S and 80 u S. */
AVX2_INLINE __m256d octagon_pad(double unit)
{
    return _mm256_setr_pd(40 * unit, 40 * unit, 80 * unit, 80 * unit);
}

AVX2_INLINE __m256d least_of(const __m256d p[4])
{
    return _mm256_min_pd(_mm256_min_pd(p[0], p[1]), _mm256_min_pd(p[2], p[3]));
}

AVX2_INLINE __m256d most_of(const __m256d p[4])
{
    return _mm256_max_pd(_mm256_max_pd(p[0], p[1]), _mm256_max_pd(p[2], p[3]));
}

/* May arcs with these points meet?  pad: that of both; differences are rounded by less than it has to spare.
 */
AVX2_INLINE bool points_meet(const __m256d f[4], const __m256d g[4], __m256d pad)
{
    __m256d above = _mm256_sub_pd(least_of(g), most_of(f)), below = _mm256_sub_pd(least_of(f), most_of(g));
    __m256d apart = _mm256_cmp_pd(_mm256_max_pd(above, below), pad, _CMP_GT_OQ);
    return _mm256_testz_pd(apart, apart);
}

AVX2_INLINE void part_bound(struct part *a, __m256d pad)
{
    a->low = _mm256_sub_pd(least_of(a->point), pad);
    a->high = _mm256_add_pd(most_of(a->point), pad);
}

AVX2_INLINE bool parts_meet(const struct part *a, const struct part *b)
{
    __m256d apart =
        _mm256_or_pd(_mm256_cmp_pd(a->low, b->high, _CMP_GT_OQ), _mm256_cmp_pd(b->low, a->high, _CMP_GT_OQ));
    return _mm256_testz_pd(apart, apart);
}

/* The first half of a, or NULL if there is no room, or no depth that E allows. */
AVX2_INLINE struct part *part_split(struct parts *c, struct part *a, __m256d pad)
{
    if (a->child) {
        return a->child;
    }
    if (c->used + 2 > PARTS_MAX || a->depth == PART_DEPTH_MAX) {
        return NULL;
    }
    struct part *left = &c->part[c->used], *right = left + 1;
    const __m256d half = _mm256_set1_pd(0.5);
    __m256d p0 = a->point[0], p1 = a->point[1], p2 = a->point[2], p3 = a->point[3];
    __m256d b0 = _mm256_mul_pd(half, _mm256_add_pd(p0, p1)), b1 = _mm256_mul_pd(half, _mm256_add_pd(p1, p2)),
            b2 = _mm256_mul_pd(half, _mm256_add_pd(p2, p3));
    __m256d c0 = _mm256_mul_pd(half, _mm256_add_pd(b0, b1)), c1 = _mm256_mul_pd(half, _mm256_add_pd(b1, b2)),
            middle = _mm256_mul_pd(half, _mm256_add_pd(c0, c1));
    left->point[0] = p0;
    left->point[1] = b0;
    left->point[2] = c0;
    left->point[3] = middle;
    right->point[0] = middle;
    right->point[1] = c1;
    right->point[2] = b2;
    right->point[3] = p3;
    part_bound(left, pad);
    part_bound(right, pad);
    left->lo = a->lo;
    left->width = right->width = a->width * 0.5;
    right->lo = a->lo + left->width;
    left->child = right->child = NULL;
    left->depth = right->depth = a->depth + 1;
    left->ready = right->ready = false;
    a->child = left;
    c->used += 2;
    return left;
}

/* A difference's coordinate errs by e = 2 E + 2 u S <= 77 u S, its sums by 4 E + 4 u S, so that the 1-norm
 * max(|x + y|, |x - y|) of an exact one is at most 153 u S more; second differences by 2 e + 4 u S. */
AVX2_INLINE void part_prepare(struct part *a, double unit)
{
    if (a->ready) {
        return;
    }
    a->ready = true;
    __m256d h0 = _mm256_sub_pd(a->point[1], a->point[0]), h1 = _mm256_sub_pd(a->point[2], a->point[1]),
            h2 = _mm256_sub_pd(a->point[3], a->point[2]);
    __m128d d0 = _mm256_castpd256_pd128(h0), d1 = _mm256_castpd256_pd128(h1), d2 = _mm256_castpd256_pd128(h2);
    __m256d x = _mm256_set_m128d(_mm_unpacklo_pd(d2, d2), _mm_unpacklo_pd(d0, d1));
    __m256d y = _mm256_set_m128d(_mm_unpackhi_pd(d2, d2), _mm_unpackhi_pd(d0, d1));
    _mm256_storeu_pd(a->ax, x);
    _mm256_storeu_pd(a->ay, y);
    __m256d size = _mm256_max_pd(_mm256_max_pd(absolute(h0), absolute(h1)), absolute(h2));
    __m256d turn = _mm256_max_pd(absolute(_mm256_sub_pd(h1, h0)), absolute(_mm256_sub_pd(h2, h1)));
    __m128d longest = _mm256_extractf128_pd(size, 1), largest = _mm256_castpd256_pd128(turn);
    a->speed = _mm_cvtsd_f64(_mm_max_sd(longest, _mm_unpackhi_pd(longest, longest))) + 160 * unit;
    a->bend = _mm_cvtsd_f64(_mm_max_sd(largest, _mm_unpackhi_pd(largest, largest))) + 160 * unit;
}

/* Do all differences point forward along the chord, and turn little?  Decides nothing but what is tried. */
AVX2_INLINE bool part_is_narrow(const struct part *a)
{
    if (3 * a->bend >= a->speed) {
        return false;
    }
    __m128d chord = _mm256_castpd256_pd128(_mm256_sub_pd(a->point[3], a->point[0]));
    __m256d across =
        _mm256_mul_pd(_mm256_loadu_pd(a->ay), _mm256_broadcastsd_pd(_mm_unpackhi_pd(chord, chord)));
    __m256d along = _mm256_fmadd_pd(_mm256_loadu_pd(a->ax), _mm256_broadcastsd_pd(chord), across);
    return _mm256_movemask_pd(along) == 0;
}

AVX2_INLINE __m256d crosses(const struct part *f, int i, __m256d x, __m256d y)
{
    __m256d back = _mm256_mul_pd(_mm256_broadcast_sd(&f->ay[i]), x);
    return _mm256_fmsub_pd(_mm256_broadcast_sd(&f->ax[i]), y, back);
}

/* c > 0: the cross product theorem (cone.c) holds with c; else it is not proved.
 *
 * Rounding.  With e = 77 u S the error of a difference's coordinate, and V_f, V_g >= 160 u S, a cross product
 * errs by e (V_f + V_g) + e^2 of data, where e^2 <= e (V_f + V_g) / 4, and by u (|ay bx| + |cross|) <= 2 u
 * V_f V_g <= 0.06 e (V_f + V_g), V <= 4.1 S: in all less than 102 u S (V_f + V_g). */
AVX2_INLINE double parts_cross(const struct part *f, const struct part *g, double unit)
{
    __m256d x = _mm256_loadu_pd(g->ax), y = _mm256_loadu_pd(g->ay);
    __m256d c0 = crosses(f, 0, x, y), c1 = crosses(f, 1, x, y), c2 = crosses(f, 2, x, y);
    __m256d least = _mm256_min_pd(_mm256_min_pd(c0, c1), c2), most = _mm256_max_pd(_mm256_max_pd(c0, c1), c2);
    if (_mm256_movemask_pd(least) != 0) {
        if (_mm256_movemask_pd(most) != 15) {
            return 0;
        }
        least = absolute(most);
    }
    __m128d h = _mm_min_pd(_mm256_castpd256_pd128(least), _mm256_extractf128_pd(least, 1));
    return _mm_cvtsd_f64(_mm_min_sd(h, _mm_unpackhi_pd(h, h))) - 104 * unit * (f->speed + g->speed);
}

/* The cross products of d with four points p - base; turned: (-d.y, d.x) twice.  Their order does not matter.
 */
AVX2_INLINE __m256d offsets(__m256d turned, __m256d base, const __m256d p[4])
{
    __m256d a = _mm256_sub_pd(_mm256_permute2f128_pd(p[0], p[1], 0x20), base);
    __m256d b = _mm256_sub_pd(_mm256_permute2f128_pd(p[2], p[3], 0x20), base);
    return _mm256_hadd_pd(_mm256_mul_pd(a, turned), _mm256_mul_pd(b, turned));
}

AVX2_INLINE double least_lane(__m256d a)
{
    __m128d h = _mm_min_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
    return _mm_cvtsd_f64(_mm_min_sd(h, _mm_unpackhi_pd(h, h)));
}

AVX2_INLINE double most_lane(__m256d a)
{
    __m128d h = _mm_max_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
    return _mm_cvtsd_f64(_mm_max_sd(h, _mm_unpackhi_pd(h, h)));
}

/* Are all points of b on one side of a's strip along its chord d?
 *
 * The direction d as computed is exact by definition.  cross(d, p - p0), p0 as computed, errs by E |d| of p,
 * by 2 u S |d| of the subtraction and 4 u S |d| of products and sum, |d| the 1-norm: two values by less than
 * 88 u S |d|. */
AVX2_INLINE bool strip_apart(const struct part *a, const struct part *b, double unit)
{
    const __m256d sign = _mm256_setr_pd(-0.0, 0.0, -0.0, 0.0);
    __m256d base = _mm256_permute2f128_pd(a->point[0], a->point[0], 0),
            end = _mm256_permute2f128_pd(a->point[3], a->point[3], 0);
    __m256d chord = _mm256_sub_pd(end, base), turned = _mm256_xor_pd(neighbours(chord), sign);
    __m256d own = offsets(turned, base, a->point), its = offsets(turned, base, b->point);
    double pad = 96 * unit * (fabs(chord[0]) + fabs(chord[1]));
    return least_lane(its) > most_lane(own) + pad || most_lane(its) < least_lane(own) - pad;
}

#endif
