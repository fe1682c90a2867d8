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

enum {
    WAITING_MAX = 64,
    STEPS_OF_KERNEL = 256,
    TRIAL_STEPS = 6,
    TRIALS_MAX = 2 /* that fail */
};

struct pair_of_parts {
    struct part *f, *g;
};

/* Few arcs side by side still are when they are halved.  So such a pair is tried for some steps; if it is not
 * settled by then, all that came of it is dropped, and it is left as it was. */
struct trial {
    bool on;
    struct pair_of_parts pair;
    int waiting, records; /* there were before */
    int last_step, failed;
};

struct kernel {
    struct front *z;
    double unit; /* u S */
    __m256d pad, tolerance;
    bool raised;  /* one of the curves */
    bool powered; /* powers are made */
    int waiting, last_step;
    struct pair_of_parts wait[WAITING_MAX];
    struct trial trial;
    struct powers powers;
    struct parts *f, *g;
    struct parts first, second; /* of the curves in the order in which they came */
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

/* ---- a pair ---- */

FATLINE_AVX2 static bool leave(struct kernel *k, const struct part *f, const struct part *g)
{
    struct interval t = {f->lo, f->lo + f->width}, s = {g->lo, g->lo + g->width};
    return front_leave(k->z, t, s);
}

/* (t, t, s, s), low and high, as a record of the zero between; false: there is no room. */
AVX2_INLINE bool record(struct crossings *out, __m256d low, __m256d high, bool is_end)
{
    if (out->count == CROSSINGS_MAX) {
        return false;
    }
    struct crossing *c = &out->at[out->count++];
    _mm256_storeu_pd(&c->t.lo, _mm256_unpacklo_pd(low, high)); /* t.lo, t.hi, s.lo, s.hi */
    c->standing = is_end ? END : UNIQUE;
    c->at_most = 1;
    c->multiplicity = is_end ? 0 : 1;
    return true;
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
    __m256d below = _mm256_cmp_pd(low, a->lo, _CMP_LE_OQ), above = _mm256_cmp_pd(high, a->hi, _CMP_GE_OQ);
    __m256d cut = _mm256_or_pd(_mm256_and_pd(below, _mm256_cmp_pd(a->lo, zero, _CMP_GT_OQ)),
                               _mm256_and_pd(above, _mm256_cmp_pd(a->hi, one, _CMP_LT_OQ)));
    low = _mm256_max_pd(low, zero);
    high = _mm256_min_pd(high, one);
    __m256d wide = _mm256_cmp_pd(_mm256_sub_pd(high, low), k->tolerance, _CMP_GT_OQ);
    __m256d bad = _mm256_or_pd(cut, wide), end = _mm256_or_pd(below, above);
    /* next to no cut, but below or above: next to an end */
    return _mm256_testz_pd(bad, bad) && record(k->z->out, low, high, !_mm256_testz_pd(end, end));
}

/* BESIDE: narrow, with parallel directions. */
enum verdict { OPEN, BESIDE, CLOSED, LEFT };

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
            powers_make(&k->f->part[0], &k->g->part[0], k->unit, k->raised, &k->powers);
        }
        enum search search = solve_parts(&k->powers, f, g, c, &arms, &at, &radius);
        return search == NO_ZERO || (search == ZERO && settle_zero(k, &arms, at, radius)) ? CLOSED : LEFT;
    }
    if (part_is_narrow(f) && part_is_narrow(g)) {
        return strip_apart(f, g, k->unit) || strip_apart(g, f, k->unit) ? CLOSED : BESIDE;
    }
    return OPEN;
}

/* ---- the pairs that wait ---- */

AVX2_INLINE void push(struct kernel *k, struct part *f, struct part *g)
{
    struct pair_of_parts *top = &k->wait[k->waiting];
    top->f = f;
    top->g = g;
    k->waiting += parts_meet(f, g);
}

/* Halves the arc that is farther from straight. */
AVX2_INLINE enum verdict split(struct kernel *k, struct part *f, struct part *g)
{
    if (k->waiting + 2 > WAITING_MAX) {
        return LEFT;
    }
    if (f->bend >= g->bend) {
        struct part *half = part_split(k->f, f, k->pad);
        if (!half) {
            return LEFT;
        }
        push(k, half + 1, g);
        push(k, half, g);
    } else {
        struct part *half = part_split(k->g, g, k->pad);
        if (!half) {
            return LEFT;
        }
        push(k, f, half + 1);
        push(k, f, half);
    }
    return CLOSED;
}

/* The whole curve in 1, 2 or 4 neighbouring parts by how far it is from straight; part_split has room. */
AVX2_INLINE int grid(struct parts *c, bool least_two, __m256d pad, struct part *part[4])
{
    struct part *a = &c->part[0];
    part[0] = a;
    if (!least_two && 4 * a->bend <= a->speed) {
        return 1;
    }
    struct part *half = part_split(c, a, pad);
    part[0] = half;
    part[1] = half + 1;
    if (1.5 * a->bend <= a->speed) {
        return 2;
    }
    part[0] = part_split(c, half, pad);
    part[1] = part[0] + 1;
    part[2] = part_split(c, half + 1, pad);
    part[3] = part[2] + 1;
    return 4;
}

/* The first split: both curves at once, so that parts far from each other never wait. */
FATLINE_AVX2 static void split_whole(struct kernel *k)
{
    struct part *f[4], *g[4], *whole_f = &k->f->part[0], *whole_g = &k->g->part[0];
    part_bound(whole_f, k->pad);
    part_bound(whole_g, k->pad);
    bool larger_f = whole_f->bend >= whole_g->bend;
    int n = grid(k->f, larger_f, k->pad, f), m = grid(k->g, !larger_f, k->pad, g);
    for (int i = n - 1; i >= 0; i--) {
        for (int j = m - 1; j >= 0; j--) {
            push(k, f[i], g[j]);
        }
    }
}

/* false: there have been too many in vain */
AVX2_INLINE bool trial_begin(struct kernel *k, struct pair_of_parts at)
{
    struct trial *t = &k->trial;
    if (t->failed == TRIALS_MAX) {
        return false;
    }
    t->on = true;
    t->pair = at;
    t->waiting = k->waiting;
    t->records = k->z->out->count;
    t->last_step = k->z->steps + TRIAL_STEPS;
    t->last_step = t->last_step < k->last_step ? t->last_step : k->last_step;
    return true;
}

/* Back to where it began; returns the pair. */
static struct pair_of_parts trial_fail(struct kernel *k)
{
    k->trial.on = false;
    k->trial.failed++;
    k->waiting = k->trial.waiting;
    k->z->out->count = k->trial.records;
    return k->trial.pair;
}

/* One pair; LEFT: it is to be left. */
AVX2_INLINE enum verdict step(struct kernel *k, struct pair_of_parts at)
{
    int last = k->trial.on ? k->trial.last_step : k->last_step;
    if (k->z->steps >= last) {
        return LEFT;
    }
    k->z->steps++;
    enum verdict verdict = settle(k, at.f, at.g);
    if (verdict == BESIDE && !k->trial.on && !trial_begin(k, at)) {
        return LEFT;
    }
    return verdict <= BESIDE ? split(k, at.f, at.g) : verdict;
}

/* All pairs that wait. */
FATLINE_AVX2 static void work(struct kernel *k)
{
    while (k->waiting > 0) {
        struct pair_of_parts at = k->wait[--k->waiting];
        if (k->trial.on && k->waiting < k->trial.waiting) {
            k->trial.on = false;
        }
        if (step(k, at) == LEFT) {
            at = k->trial.on ? trial_fail(k) : at;
            if (!leave(k, at.f, at.g)) {
                return;
            }
        }
    }
}

/* The whole curves are made, and their octagons meet. */
AVX2_INLINE void solve(struct kernel *k, bool raised)
{
    struct front *z = k->z;
    const int allowed = z->max_steps - z->steps;
    k->tolerance = halves(z->tolerance_t, z->tolerance_s);
    k->raised = raised;
    k->powered = k->trial.on = false;
    k->waiting = k->trial.failed = 0;
    k->last_step = z->steps + (allowed < STEPS_OF_KERNEL ? allowed : (int)STEPS_OF_KERNEL);
    z->steps++;
    enum verdict verdict = settle(k, &k->f->part[0], &k->g->part[0]);
    if (verdict == LEFT) {
        leave(k, &k->f->part[0], &k->g->part[0]);
    } else if (verdict != CLOSED) {
        if (verdict == BESIDE) {
            const struct pair_of_parts whole = {&k->f->part[0], &k->g->part[0]};
            trial_begin(k, whole);
        }
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
FATLINE_AVX2 __attribute__((noinline)) static enum front_answer
meet(struct kernel *k, const struct problem *p, struct workspace *w, struct crossings *out, struct rest *rest)
{
    struct front z;
    bool swapped = front_open(&z, p, out, rest);
    k->f = swapped ? &k->second : &k->first;
    k->g = swapped ? &k->first : &k->second;
    k->z = &z;
    solve(k, false);
    return front_close(&z, swapped, w);
}

FATLINE_AVX2 enum front_answer front_cubics_avx2(const struct problem *p, struct workspace *w,
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
    return meet(&k, p, w, out, rest);
}

#endif
