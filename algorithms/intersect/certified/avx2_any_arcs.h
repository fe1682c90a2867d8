/* Parts of a curve of any degree for the front kernel: halving, octagons, cones of directions, strips.
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

/* ---- directions ---- */

/* The first two numbers of four vectors as columns. */
AVX2_ANY void columns(const __m256d *a, __m256d *x, __m256d *y)
{
    __m256d b = _mm256_insertf128_pd(a[0], _mm256_castpd256_pd128(a[2]), 1);
    __m256d c = _mm256_insertf128_pd(a[1], _mm256_castpd256_pd128(a[3]), 1);
    *x = _mm256_unpacklo_pd(b, c);
    *y = _mm256_unpackhi_pd(b, c);
}

/* Each block of four of `count` vectors begins at blocks_at(i), i = 0, 4, ...; the last may overlap. */
AVX2_ANY int block_at(int count, int i)
{
    return i + 4 <= count || count < 4 ? i : count - 4;
}

/* Both sides of the cone.  With e the chord, as it was computed, and e' = e turned left, a difference is A =
 * (d e + k e') / |e|^2, d = e . A, k = cross(e, A).  Let D > 0 be the least d, and s, r the least and the
 * largest of the k / d: the sides are (e + s e') D / |e|^2 and (e + r e') D / |e|^2.
 *
 * Rounding.  Computed d and k belong to a difference that is no farther from A than 3 u V, V the largest
 * 1-norm, for each errs by 2 u |e| |A| at most.  k / d errs by u of itself, which 4 u covers; the sides by 6
 * u of each coordinate. */
AVX2_ANY bool cone_of(int n, const __m256d *way, double ex, double ey, __m256d *cone)
{
    const __m256d x = _mm256_set1_pd(ex), y = _mm256_set1_pd(ey), small = _mm256_set1_pd(4 * DBL_EPSILON / 2);
    __m256d least = _mm256_set1_pd(DBL_MAX), first = least, last = _mm256_set1_pd(-DBL_MAX);
#pragma GCC unroll 2
    for (int i = 0; i < n; i += 4) {
        __m256d ax, ay;
        columns(way + block_at(n, i), &ax, &ay);
        __m256d along = _mm256_fmadd_pd(x, ax, y * ay), across = _mm256_fmsub_pd(x, ay, y * ax);
        __m256d slope = across / along;
        least = _mm256_min_pd(least, along);
        first = _mm256_min_pd(first, slope);
        last = _mm256_max_pd(last, slope);
    }
    double d = least_of_four(least);
    if (!(d > 0)) {
        return false;
    }
    /* (s, r) as (s, r, s, r), widened */
    __m128d s = _mm_set1_pd(least_of_four(first)), r = _mm_set1_pd(most_of_four(last));
    __m128d sides = _mm_unpacklo_pd(s, r);
    __m256d slope = _mm256_insertf128_pd(_mm256_castpd128_pd256(sides), sides, 1);
    __m256d out = _mm256_setr_pd(-1, 1, -1, 1) * small;
    slope = _mm256_fmadd_pd(size_of(slope), out, slope);
    double share = d / (ex * ex + ey * ey);
    __m256d along = _mm256_setr_pd(ex, ex, ey, ey), left = _mm256_setr_pd(-ey, -ey, ex, ex);
    *cone = _mm256_fmadd_pd(slope, left, along) * _mm256_set1_pd(share);
    return true;
}

/* A difference errs by 2 E and its rounding u 2 S <= E / 6 in x and y, twice that in x + y and x - y; a
 * second difference by 4 E and u 8 S <= 2 E / 3. */
AVX2_ANY void prepare(int n, struct arcs *c, int k)
{
    struct arc *a = &c->arc[k];
    const __m256d *p = arc_points(c, k);
    __m256d way[DEGREE_MAX + 3], speed, bend = _mm256_setzero_pd(), before;
    way[0] = before = p[1] - p[0];
    speed = size_of(before);
#pragma GCC unroll 8
    for (int i = 1; i < n; i++) {
        __m256d now = p[i + 1] - p[i];
        way[i] = now;
        speed = _mm256_max_pd(speed, size_of(now));
        bend = _mm256_max_pd(bend, size_of(now - before));
        before = now;
    }
    for (int i = n; i < 4; i++) {
        way[i] = before;
    }
    __m128d first = _mm256_castpd256_pd128(p[0]), last = _mm256_castpd256_pd128(p[n]), chord = last - first;
    a->ex = _mm_cvtsd_f64(chord);
    a->ey = _mm_cvtsd_f64(_mm_unpackhi_pd(chord, chord));
    a->speed = largest_of(_mm256_extractf128_pd(speed, 1)) + 5 * c->error;
    a->bend = n > 1 ? n * (n - 1) * (largest_of(_mm256_castpd256_pd128(bend)) + 5 * c->error) : 0;
    a->wide = !cone_of(n, way, a->ex, a->ey, &a->cone);
    a->ready = true;
}

FATLINE_AVX2 static void arc_prepare(struct arcs *c, int k)
{
    switch (c->n) {
    case 4:
        prepare(4, c, k);
        break;
    case 5:
        prepare(5, c, k);
        break;
    case 6:
        prepare(6, c, k);
        break;
    case 7:
        prepare(7, c, k);
        break;
    case 8:
        prepare(8, c, k);
        break;
    default:
        prepare(c->n, c, k);
    }
}

/* c > 0: every exact difference of f crosses every one of g the same way, and no product is smaller than c
 * (cone.c).  By bilinearity no product is smaller than the least of those of the sides, which is positive;
 * with what cone_of says, differences err by 2.2 E + 3 u V < 3.2 E, and the products of sides by 16 u V_f V_g
 * < 3 (E_f V_g + E_g V_f), as u V <= 4 u S < E / 3, and E < V / 5: 10 (E_f V_g + E_g V_f) covers all. */
AVX2_ANY double cones_gap(const struct arcs *of_f, const struct arc *f, const struct arcs *of_g,
                          const struct arc *g)
{
    if (f->wide | g->wide) {
        return 0;
    }
    /* x1 x1 x2 x2, y1 y1 y2 y2 and x1 x2 x1 x2, y1 y2 y1 y2 */
    __m256d fx = _mm256_permute4x64_pd(f->cone, 0x50), fy = _mm256_permute4x64_pd(f->cone, 0xfa);
    __m256d gx = _mm256_permute4x64_pd(g->cone, 0x44), gy = _mm256_permute4x64_pd(g->cone, 0xee);
    __m256d product = _mm256_fmsub_pd(fx, gy, fy * gx);
    int negative = _mm256_movemask_pd(product);
    if (negative != 0 && negative != 15) {
        return 0;
    }
    double c = least_of_four(size_of(product));
    c -= 10 * (of_f->error * g->speed + of_g->error * f->speed);
    return c > 0 ? c : 0;
}

/* ---- strips ---- */

struct offsets {
    double low, high;
};

AVX2_ANY struct offsets offsets(int n, const __m256d *p, double ex, double ey)
{
    const __m256d x = _mm256_set1_pd(ex), y = _mm256_set1_pd(ey);
    __m256d low = _mm256_set1_pd(DBL_MAX), high = _mm256_set1_pd(-DBL_MAX);
#pragma GCC unroll 3
    for (int i = 0; i <= n; i += 4) {
        __m256d px, py;
        columns(p + block_at(n + 1, i), &px, &py);
        __m256d d = _mm256_fmsub_pd(x, py, y * px);
        low = _mm256_min_pd(low, d);
        high = _mm256_max_pd(high, d);
    }
    struct offsets r = {least_of_four(low), most_of_four(high)};
    return r;
}

/* Range of ex y - ey x over the control points. */
FATLINE_AVX2 static struct offsets offsets_of(const struct arcs *c, int k, double ex, double ey)
{
    const __m256d *p = arc_points(c, k);
    switch (c->n) {
    case 4:
        return offsets(4, p, ex, ey);
    case 5:
        return offsets(5, p, ex, ey);
    case 6:
        return offsets(6, p, ex, ey);
    case 7:
        return offsets(7, p, ex, ey);
    case 8:
        return offsets(8, p, ex, ey);
    default:
        return offsets(c->n, p, ex, ey);
    }
}

/* Along a's chord e, as it was computed.  An offset errs by E |e|_1 and 2 u S |e|_1 of rounding. */
FATLINE_AVX2 static bool strips_are_apart(const struct arcs *of_a, int a, const struct arcs *of_b, int b)
{
    double ex = of_a->arc[a].ex, ey = of_a->arc[a].ey;
    struct offsets own = offsets_of(of_a, a, ex, ey), other = offsets_of(of_b, b, ex, ey);
    double bound = 2 * (of_a->error + of_b->error) * (fabs(ex) + fabs(ey));
    return own.low - other.high > bound || other.low - own.high > bound;
}

#endif
#endif
