/* Directions of parts of a curve of any degree for the front kernel: cones, and strips along chords. */
#ifndef FATLINE_CERTIFIED_AVX2_ANY_CONES_H
#define FATLINE_CERTIFIED_AVX2_ANY_CONES_H

#include "avx2_any_arcs.h"

#ifdef FATLINE_AVX2

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
