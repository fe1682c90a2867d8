/* The front kernel for polynomial curves of degree 1 to 3, with AVX2 and FMA.
 *
 * Lines and parabolas are raised to cubics.  Parts are halved where they may meet; where all differences
 * cross all others the same way, the one zero is found and proved, or proved absent; arcs side by side whose
 * strips are apart are empty.  What else lies side by side, and a zero that is next to a cut, is left to the
 * engine.
 *
 * Everything is homogeneous in the coordinates, so scaling both curves by a power of two changes no bit of t
 * and s, as long as no product comes near the ends of the range: the extent must be between 2^-64 and 2^64.
 */
#include "front.h"

#ifdef FATLINE_AVX2

#include "avx2_one.h"

enum { WAITING_MAX = 64, STEPS_OF_KERNEL = 256 };

struct pair_of_parts {
    short f, g;
};

struct kernel {
    struct front *z;
    double unit; /* u S */
    __m256d pad;
    bool raised;  /* one of the curves */
    bool powered; /* powers are made */
    int waiting, last_step;
    struct pair_of_parts wait[WAITING_MAX];
    struct powers powers;
    struct parts f, g;
};

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
AVX2_INLINE void part_whole(__m256d x, __m256d y, struct part *out)
{
    __m256d sum = _mm256_add_pd(x, y), difference = _mm256_sub_pd(x, y);
    __m256d a = _mm256_unpacklo_pd(x, y), b = _mm256_unpackhi_pd(x, y);
    __m256d c = _mm256_unpacklo_pd(sum, difference), d = _mm256_unpackhi_pd(sum, difference);
    out->point[0] = _mm256_permute2f128_pd(a, c, 0x20);
    out->point[1] = _mm256_permute2f128_pd(b, d, 0x20);
    out->point[2] = _mm256_permute2f128_pd(a, c, 0x31);
    out->point[3] = _mm256_permute2f128_pd(b, d, 0x31);
}

AVX2_INLINE void parts_init(struct parts *c)
{
    c->used = 1;
    c->part[0].lo = 0;
    c->part[0].width = 1;
    c->part[0].child = c->part[0].depth = 0;
    c->part[0].ready = false;
}

/* false: not for this kernel */
AVX2_INLINE bool curves_take(const struct front *z, struct kernel *k)
{
    const __m256d most = _mm256_set1_pd(0x1p64);
    __m256d fx = coordinates(z->f->degree, z->f->x), fy = coordinates(z->f->degree, z->f->y),
            gx = coordinates(z->g->degree, z->g->x), gy = coordinates(z->g->degree, z->g->y);
    __m256d ax = absolute(fx), ay = absolute(fy), bx = absolute(gx), by = absolute(gy);
    /* of a sum every term is known to be finite, of a maximum not */
    __m256d sum = _mm256_add_pd(_mm256_add_pd(ax, ay), _mm256_add_pd(bx, by));
    __m256d large = _mm256_max_pd(_mm256_max_pd(ax, ay), _mm256_max_pd(bx, by));
    __m128d largest = _mm_max_pd(_mm256_castpd256_pd128(large), _mm256_extractf128_pd(large, 1));
    double extent = _mm_cvtsd_f64(_mm_max_sd(largest, _mm_unpackhi_pd(largest, largest)));
    if (_mm256_movemask_pd(_mm256_cmp_pd(sum, most, _CMP_LT_OQ)) != 15 || !(extent > 0x1p-64)) {
        return false;
    }
    k->unit = DBL_EPSILON / 2 * extent;
    k->pad = octagon_pad(k->unit);
    part_whole(fx, fy, &k->f.part[0]);
    part_whole(gx, gy, &k->g.part[0]);
    part_bound(&k->f.part[0], k->pad);
    part_bound(&k->g.part[0], k->pad);
    return true;
}

/* ---- a pair ---- */

FATLINE_AVX2 static bool leave(struct kernel *k, const struct part *f, const struct part *g)
{
    struct interval t = {f->lo, f->lo + f->width}, s = {g->lo, g->lo + g->width};
    return front_leave(k->z, t, s);
}

/* Well inside both parts, but for ends of the domains, and as narrow as asked, the zero is a record. */
AVX2_INLINE bool settle_zero(struct kernel *k, const struct arms *a, __m256d at, __m256d radius)
{
    const __m256d zero = _mm256_setzero_pd(), one = _mm256_set1_pd(1);
    __m256d low = _mm256_sub_pd(at, radius), high = _mm256_add_pd(at, radius);
    __m256d out = _mm256_or_pd(_mm256_cmp_pd(low, a->hi, _CMP_GT_OQ), _mm256_cmp_pd(high, a->lo, _CMP_LT_OQ));
    if (!_mm256_testz_pd(out, out)) {
        return true;
    }
    __m256d below =
        _mm256_and_pd(_mm256_cmp_pd(low, a->lo, _CMP_LE_OQ), _mm256_cmp_pd(a->lo, zero, _CMP_GT_OQ));
    __m256d above =
        _mm256_and_pd(_mm256_cmp_pd(high, a->hi, _CMP_GE_OQ), _mm256_cmp_pd(a->hi, one, _CMP_LT_OQ));
    __m256d cut = _mm256_or_pd(below, above);
    return _mm256_testz_pd(cut, cut) && front_zero(k->z, at[0], radius[0], at[2], radius[2]);
}

enum verdict { OPEN, CLOSED, LEFT };

AVX2_INLINE enum verdict settle(struct kernel *k, struct part *f, struct part *g)
{
    part_prepare(f, k->unit);
    part_prepare(g, k->unit);
    double c = parts_cross(f, g, k->unit);
    if (c > 0) {
        struct arms arms;
        __m256d at, radius;
        if (!k->powered) {
            k->powered = true;
            powers_make(&k->f.part[0], &k->g.part[0], k->unit, k->raised, &k->powers);
        }
        enum search search = solve_parts(&k->powers, f, g, c, &arms, &at, &radius);
        return search == NO_ZERO || (search == ZERO && settle_zero(k, &arms, at, radius)) ? CLOSED : LEFT;
    }
    if (!f->wide && !g->wide && 3 * f->bend < f->speed && 3 * g->bend < g->speed) {
        return strip_apart(f, g, k->unit) || strip_apart(g, f, k->unit) ? CLOSED : LEFT;
    }
    return OPEN;
}

/* ---- the pairs that wait ---- */

AVX2_INLINE void push(struct kernel *k, int f, int g)
{
    struct pair_of_parts *top = &k->wait[k->waiting];
    top->f = (short)f;
    top->g = (short)g;
    k->waiting += parts_meet(&k->f.part[f], &k->g.part[g]);
}

/* Halves the arc that is farther from straight. */
AVX2_INLINE enum verdict split(struct kernel *k, int f, int g)
{
    bool of_f = k->f.part[f].bend >= k->g.part[g].bend;
    int half = of_f ? part_split(&k->f, f, k->pad) : part_split(&k->g, g, k->pad);
    if (!half || k->waiting + 2 > WAITING_MAX) {
        return LEFT;
    }
    push(k, of_f ? half + 1 : f, of_f ? g : half + 1);
    push(k, of_f ? half : f, of_f ? g : half);
    return CLOSED;
}

/* The whole curve in 1, 2 or 4 neighbouring parts by how far it is from straight; part_split has room. */
AVX2_INLINE int grid(struct parts *c, bool least_two, __m256d pad, int part[4])
{
    const struct part *a = &c->part[0];
    part[0] = 0;
    if (!least_two && 4 * a->bend <= a->speed) {
        return 1;
    }
    int half = part_split(c, 0, pad);
    part[0] = half;
    part[1] = half + 1;
    if (1.5 * a->bend <= a->speed) {
        return 2;
    }
    int first = part_split(c, half, pad), second = part_split(c, half + 1, pad);
    part[0] = first;
    part[1] = first + 1;
    part[2] = second;
    part[3] = second + 1;
    return 4;
}

/* The first split: both curves at once, so that parts far from each other never wait. */
FATLINE_AVX2 static void split_whole(struct kernel *k)
{
    int f[4], g[4];
    bool larger_f = k->f.part[0].bend >= k->g.part[0].bend;
    int n = grid(&k->f, larger_f, k->pad, f), m = grid(&k->g, !larger_f, k->pad, g);
    for (int i = n - 1; i >= 0; i--) {
        for (int j = m - 1; j >= 0; j--) {
            push(k, f[i], g[j]);
        }
    }
}

/* All pairs that wait; false: everything has been left. */
FATLINE_AVX2 static bool work(struct kernel *k)
{
    while (k->waiting > 0) {
        const struct pair_of_parts at = k->wait[--k->waiting];
        struct part *f = &k->f.part[at.f], *g = &k->g.part[at.g];
        enum verdict verdict = LEFT;
        if (k->z->steps < k->last_step) {
            k->z->steps++;
            verdict = settle(k, f, g);
            verdict = verdict == OPEN ? split(k, at.f, at.g) : verdict;
        }
        if (verdict == LEFT && !leave(k, f, g)) {
            return false;
        }
    }
    return true;
}

FATLINE_AVX2 bool front_cubic_avx2(struct front *z)
{
    struct kernel k;
    if (!curves_take(z, &k)) {
        return false;
    }
    if (!parts_meet(&k.f.part[0], &k.g.part[0])) {
        return true;
    }
    k.z = z;
    k.raised = z->f->degree < 3 || z->g->degree < 3;
    k.powered = false;
    k.waiting = 0;
    int steps = z->max_steps - z->steps;
    k.last_step = z->steps + (steps < STEPS_OF_KERNEL ? steps : (int)STEPS_OF_KERNEL);
    parts_init(&k.f);
    parts_init(&k.g);
    z->steps++;
    enum verdict verdict = settle(&k, &k.f.part[0], &k.g.part[0]);
    if (verdict == OPEN) {
        split_whole(&k);
        work(&k);
    } else if (verdict == LEFT) {
        leave(&k, &k.f.part[0], &k.g.part[0]);
    }
    return true;
}

#endif
