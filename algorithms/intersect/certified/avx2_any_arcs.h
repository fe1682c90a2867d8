/* Parts of a curve of any degree for the front kernel: halving, octagons.
 *
 * A point is carried as (x, y, x + y, x - y) in one vector, so that its octagon costs no more than a box and
 * the 1-norm of a difference is the larger of its last two numbers.  The parts of a curve are a binary tree
 * in the order of a heap: part k has the halves 2 k and 2 k + 1, the whole curve is 1, and part k at depth d,
 * 2^d <= k < 2^(d+1), lies over [k - 2^d, k - 2^d + 1] / 2^d.
 *
 * Rounding.  u = 2^-53, S the largest |coordinate|, n the degree, E = (12 n + 1) u S.  A halving sums b[i] +
 * b[i+1] in n rounds and scales by powers of two.  Let |b| <= 2^k S after round k, with error e_k; the next
 * sum errs by 2 e_k + u 2^(k+1) S, so that e_k <= k u 2^k S (1 + 2u)^k by induction: after scaling, a
 * coordinate errs by n u S (1 + 64 u) more than before, and x + y and x - y, which are below 2 S, by twice
 * that and u 2 S from the beginning.  After DEPTH_OF_ARCS = 8 halvings a coordinate errs by less than E, the
 * sum and the difference by less than 2 E. */
#ifndef FATLINE_CERTIFIED_AVX2_ANY_ARCS_H
#define FATLINE_CERTIFIED_AVX2_ANY_ARCS_H

#include "front.h"

#ifdef FATLINE_AVX2

#include <immintrin.h>

#define AVX2_ANY static inline __attribute__((always_inline, target("avx2,fma")))

/* From 4 to DEGREE_KNOWN: for these degrees there is code of their own, compiled from one text. */
enum { DEGREE_KNOWN = 8, DEPTH_OF_ARCS = 8, ARCS_MAX = 2 << DEPTH_OF_ARCS, POINTS_MIN = 4 };

struct arc {
    __m256d low, high; /* the exact part lies between, in each of x, y, x + y, x - y */
    /* What follows is made by arc_prepare.  Both sides of the cone of directions, (x1, x2, y1, y2): every
     * direction is, but for its error, a combination of the two with weights >= 0 of sum >= 1. */
    __m256d cone;
    double ex, ey; /* chord */
    double speed;  /* no exact difference is longer in the 1-norm */
    double bend;   /* no coordinate of f'' is larger, by the parameter of the part */
    bool halved, ready;
    bool wide; /* there is no cone: some difference may point back along the chord */
};

struct arcs {
    int n;
    size_t stride;
    double error; /* E */
    __m256d *points;
    struct arc *arc;
};

AVX2_ANY __m256d size_of(__m256d a)
{
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}

AVX2_ANY double largest_of(__m128d a)
{
    return _mm_cvtsd_f64(_mm_max_sd(a, _mm_unpackhi_pd(a, a)));
}

AVX2_ANY double least_of_four(__m256d a)
{
    __m128d b = _mm_min_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
    return _mm_cvtsd_f64(_mm_min_sd(b, _mm_unpackhi_pd(b, b)));
}

AVX2_ANY double most_of_four(__m256d a)
{
    return largest_of(_mm_max_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1)));
}

AVX2_ANY __m256d *arc_points(const struct arcs *c, int k)
{
    return c->points + (size_t)k * c->stride;
}

/* Parts have at least POINTS_MIN points: the last is repeated. */
AVX2_ANY void points_pad(int n, __m256d *p)
{
    for (int i = n + 1; i < POINTS_MIN; i++) {
        p[i] = p[n];
    }
}

AVX2_ANY void octagon_store(const struct arcs *c, __m256d low, __m256d high, struct arc *to)
{
    const __m256d pad = _mm256_mul_pd(_mm256_setr_pd(1, 1, 2, 2), _mm256_set1_pd(1.25 * c->error));
    to->low = _mm256_sub_pd(low, pad);
    to->high = _mm256_add_pd(high, pad);
    to->halved = to->ready = false;
}

AVX2_ANY bool octagons_meet(__m256d low, __m256d high, __m256d its_low, __m256d its_high)
{
    __m256d apart =
        _mm256_or_pd(_mm256_cmp_pd(low, its_high, _CMP_GT_OQ), _mm256_cmp_pd(its_low, high, _CMP_GT_OQ));
    return _mm256_testz_pd(apart, apart);
}

AVX2_ANY bool arcs_meet(const struct arc *a, const struct arc *b)
{
    return octagons_meet(a->low, a->high, b->low, b->high);
}

/* ---- halving ---- */

/* Four rounds of sums of neighbours: out[i] = sum C(4, j) in[i + j], i = 0..count - 5; on the way the first
 * and the last sums of rounds 0 to 3.  count > 4. */
AVX2_ANY void four_rounds(int count, const __m256d *in, __m256d *out, __m256d *left, __m256d *right)
{
    __m256d c0 = in[1], c1 = in[0] + in[1], c2, c3, a, b, d;
    left[0] = in[0];
    left[1] = c1;
    a = c0 + in[2];
    c0 = in[2];
    left[2] = c2 = c1 + a;
    c1 = a;
    a = c0 + in[3];
    c0 = in[3];
    b = c1 + a;
    c1 = a;
    left[3] = c3 = c2 + b;
    c2 = b;
    for (int i = 4; i < count; i++) {
        a = c0 + in[i];
        c0 = in[i];
        b = c1 + a;
        c1 = a;
        d = c2 + b;
        c2 = b;
        out[i - 4] = c3 + d;
        c3 = d;
    }
    right[count - 1] = c0;
    right[count - 2] = c1;
    right[count - 3] = c2;
    right[count - 4] = c3;
}

/* The rest of the rounds, 1 <= count <= 4. */
AVX2_ANY void last_rounds(int count, const __m256d *in, __m256d *left, __m256d *right)
{
    __m256d b[4] = {in[0], in[count > 1 ? 1 : 0], in[count > 2 ? 2 : 0], in[count > 3 ? 3 : 0]};
    for (int k = 0; k < count; k++) {
        left[k] = b[0];
        right[count - 1 - k] = b[count - 1 - k];
        b[0] = b[0] + b[1];
        b[1] = b[1] + b[2];
        b[2] = b[2] + b[3];
    }
}

/* In registers, for a degree that the compiler knows. */
AVX2_ANY void halve_known(int n, struct arcs *c, int k)
{
    const __m256d *in = arc_points(c, k);
    __m256d b[DEGREE_KNOWN + 1], *left = arc_points(c, 2 * k), *right = arc_points(c, 2 * k + 1);
#pragma GCC unroll 32
    for (int i = 0; i <= n; i++) {
        b[i] = in[i];
    }
    __m256d low = b[0], high = low, low_2 = b[n], high_2 = low_2;
    left[0] = low;
    right[n] = low_2;
#pragma GCC unroll 32
    for (int round = 1; round <= n; round++) {
        const __m256d scale = _mm256_set1_pd(1.0 / (1 << round));
#pragma GCC unroll 32
        for (int i = 0; i <= n - round; i++) {
            b[i] = b[i] + b[i + 1];
        }
        __m256d first = b[0] * scale, last = b[n - round] * scale;
        left[round] = first;
        right[n - round] = last;
        low = _mm256_min_pd(low, first);
        high = _mm256_max_pd(high, first);
        low_2 = _mm256_min_pd(low_2, last);
        high_2 = _mm256_max_pd(high_2, last);
    }
    octagon_store(c, low, high, &c->arc[2 * k]);
    octagon_store(c, low_2, high_2, &c->arc[2 * k + 1]);
    c->arc[k].halved = true;
}

/* For any degree: four rounds at a time. */
FATLINE_AVX2 static void halve_any(struct arcs *c, int k)
{
    int n = c->n, count = n + 1;
    __m256d sums[DEGREE_MAX + 1], *left = arc_points(c, 2 * k), *right = arc_points(c, 2 * k + 1);
    const __m256d *in = arc_points(c, k);
    for (int first = 0; count > 0; first += 4, count -= 4, in = sums) {
        if (count > 4) {
            four_rounds(count, in, sums, left + first, right);
        } else {
            last_rounds(count, in, left + first, right);
        }
    }
    const __m256d half = _mm256_set1_pd(0.5);
    __m256d low = left[0], high = low, low_2 = right[n], high_2 = low_2, scale = half;
    for (int i = 1; i <= n; i++, scale = scale * half) {
        __m256d a = left[i] * scale, b = right[n - i] * scale;
        left[i] = a;
        right[n - i] = b;
        low = _mm256_min_pd(low, a);
        high = _mm256_max_pd(high, a);
        low_2 = _mm256_min_pd(low_2, b);
        high_2 = _mm256_max_pd(high_2, b);
    }
    points_pad(n, left);
    points_pad(n, right);
    octagon_store(c, low, high, &c->arc[2 * k]);
    octagon_store(c, low_2, high_2, &c->arc[2 * k + 1]);
    c->arc[k].halved = true;
}

/* The halves of part k, which has none. */
FATLINE_AVX2 static void arc_halve(struct arcs *c, int k)
{
    switch (c->n) {
    case 4:
        halve_known(4, c, k);
        break;
    case 5:
        halve_known(5, c, k);
        break;
    case 6:
        halve_known(6, c, k);
        break;
    case 7:
        halve_known(7, c, k);
        break;
    case 8:
        halve_known(8, c, k);
        break;
    default:
        halve_any(c, k);
    }
}

#endif
#endif
