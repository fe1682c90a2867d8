/* The front kernel for polynomial curves of degree 1 to 3, with AVX2 and FMA.
 *
 * Lines and parabolas are raised to cubics, whose parts are halved where they may meet (avx2_parts.h) until
 * every pair is settled (avx2_pairs.h).
 *
 * Everything is homogeneous in the coordinates, so scaling both curves by a power of two changes no bit of t
 * and s, as long as no product comes near the ends of the range: the extent must be between 2^-64 and 2^64.
 */
#include "front.h"

#ifdef FATLINE_AVX2

#include "avx2_pairs.h"

/* ---- the curves ---- */

/* One coordinate's four coefficients.  Raised: the sum, 3 S at most, is rounded, and the quotient: 2 u S. */
AVX2_INLINE __m256d coordinates(int degree, const double *c)
{
    if (degree == 3) {
        return _mm256_loadu_pd(c);
    }
    if (degree == 2) {
        return _mm256_setr_pd(c[0], (c[0] + 2 * c[1]) / 3, (2 * c[1] + c[2]) / 3, c[2]);
    }
    return _mm256_setr_pd(c[0], (2 * c[0] + c[1]) / 3, (c[0] + 2 * c[1]) / 3, c[1]);
}

/* Points from rows of coordinates. */
AVX2_INLINE void points_make(__m256d x, __m256d y, __m256d out[4])
{
    __m256d sum = _mm256_add_pd(x, y), difference = _mm256_sub_pd(x, y);
    __m256d a = _mm256_unpacklo_pd(x, y), b = _mm256_unpackhi_pd(x, y);
    __m256d c = _mm256_unpacklo_pd(sum, difference), d = _mm256_unpackhi_pd(sum, difference);
    out[0] = _mm256_permute2f128_pd(a, c, 0x20);
    out[1] = _mm256_permute2f128_pd(b, d, 0x20);
    out[2] = _mm256_permute2f128_pd(a, c, 0x31);
    out[3] = _mm256_permute2f128_pd(b, d, 0x31);
}

AVX2_INLINE void parts_init(struct parts *c, const __m256d point[4])
{
    struct part *whole = &c->part[0];
    c->used = 1;
    whole->lo = 0;
    whole->width = 1;
    whole->child = NULL;
    whole->depth = 0;
    whole->ready = false;
    whole->point[0] = point[0];
    whole->point[1] = point[1];
    whole->point[2] = point[2];
    whole->point[3] = point[3];
}

/* The unit u S of errors; false: not for this kernel. */
AVX2_INLINE bool unit_of(__m256d fx, __m256d fy, __m256d gx, __m256d gy, double *unit)
{
    const __m256d most = _mm256_set1_pd(0x1p64);
    __m256d ax = absolute(fx), ay = absolute(fy), bx = absolute(gx), by = absolute(gy);
    /* of a sum every term is known to be finite, of a maximum not */
    __m256d sum = _mm256_add_pd(_mm256_add_pd(ax, ay), _mm256_add_pd(bx, by));
    __m256d large = _mm256_max_pd(_mm256_max_pd(ax, ay), _mm256_max_pd(bx, by));
    __m128d largest = _mm_max_pd(_mm256_castpd256_pd128(large), _mm256_extractf128_pd(large, 1));
    double extent = _mm_cvtsd_f64(_mm_max_sd(largest, _mm_unpackhi_pd(largest, largest)));
    *unit = DBL_EPSILON / 2 * extent;
    return _mm256_movemask_pd(_mm256_cmp_pd(sum, most, _CMP_LT_OQ)) == 15 && extent > 0x1p-64;
}

/* ---- both ---- */

/* The whole curves are made, and their octagons meet. */
AVX2_INLINE void solve(struct kernel *k, bool raised)
{
    struct front *z = k->z;
    const int allowed = z->max_steps - z->steps;
    k->raised = raised;
    k->powered = k->trial.on = false;
    k->waiting = k->trial.failed = 0;
    k->last_step = z->steps + (allowed < STEPS_OF_KERNEL ? allowed : (int)STEPS_OF_KERNEL);
    z->steps++;
    enum verdict verdict = settle(k, &k->f->part[0], &k->g->part[0]);
    if (verdict == LEFT || verdict == BESIDE) { /* whole curves side by side mostly touch, or nearly */
        leave(k, &k->f->part[0], &k->g->part[0]);
    } else if (verdict != CLOSED) {
        split_whole(k);
        work(k);
    }
}

/* The curves in the order in which they came. */
AVX2_INLINE void begin(struct kernel *k, double unit, const __m256d f[4], const __m256d g[4])
{
    k->unit = unit;
    k->pad = octagon_pad(unit);
    parts_init(&k->first, f);
    parts_init(&k->second, g);
}

FATLINE_AVX2 bool front_cubic_avx2(struct front *z)
{
    struct kernel k;
    const struct curve *a = z->f, *b = z->g;
    __m256d fx = coordinates(a->degree, a->x), fy = coordinates(a->degree, a->y),
            gx = coordinates(b->degree, b->x), gy = coordinates(b->degree, b->y), f[4], g[4];
    double unit;
    if (!unit_of(fx, fy, gx, gy, &unit)) {
        return false;
    }
    points_make(fx, fy, f);
    points_make(gx, gy, g);
    if (points_meet(f, g, octagon_pad(2 * unit))) {
        begin(&k, unit, f, g);
        k.f = &k.first;
        k.g = &k.second;
        k.z = z;
        solve(&k, a->degree < 3 || b->degree < 3);
    }
    return true;
}

/* Not in line: pairs that are apart are not to pay for it. */
FATLINE_AVX2 __attribute__((noinline)) static enum front_answer meet(struct kernel *k, bool many,
                                                                     const struct problem *p,
                                                                     struct workspace *w,
                                                                     struct crossings *out, struct rest *rest)
{
    struct front z;
    bool swapped = front_open(&z, p, out, rest);
    z.many &= many;
    k->f = swapped ? &k->second : &k->first;
    k->g = swapped ? &k->first : &k->second;
    k->z = &z;
    solve(k, false);
    return front_close(&z, swapped, w);
}

AVX2_INLINE enum front_answer cubics(bool many, const struct problem *p, struct workspace *w,
                                     struct crossings *out, struct rest *rest)
{
    struct kernel k;
    __m256d fx = _mm256_loadu_pd(p->f.x), fy = _mm256_loadu_pd(p->f.y), gx = _mm256_loadu_pd(p->g.x),
            gy = _mm256_loadu_pd(p->g.y), f[4], g[4];
    double unit;
    if (!front_is_plain(p) || !unit_of(fx, fy, gx, gy, &unit)) {
        return FRONT_REFUSED;
    }
    points_make(fx, fy, f);
    points_make(gx, gy, g);
    if (!points_meet(f, g, octagon_pad(2 * unit))) {
        w->swapped = false;
        return FRONT_DONE;
    }
    begin(&k, unit, f, g);
    return meet(&k, many, p, w, out, rest);
}

FATLINE_AVX2 enum front_answer front_cubics(const struct problem *p, struct workspace *w,
                                            struct crossings *out, struct rest *rest)
{
    return cubics(true, p, w, out, rest);
}

FATLINE_AVX2 enum front_answer front_cubics_avx2(const struct problem *p, struct workspace *w,
                                                 struct crossings *out, struct rest *rest)
{
    return cubics(false, p, w, out, rest);
}

#endif
