/* Pairs of parts of two cubics: settled, split, or left to the engine.
 *
 * Where all differences cross all others the same way, the one zero is found and proved, or proved absent;
 * arcs side by side whose strips are apart are empty.  What else lies side by side, and a zero that is next
 * to a cut, is left. */
#ifndef FATLINE_CERTIFIED_AVX2_PAIRS_H
#define FATLINE_CERTIFIED_AVX2_PAIRS_H

#include "avx2_one.h"
#include "crowd.h"

enum {
    WAITING_MAX = 64,
    STEPS_OF_KERNEL = 256, /* fewer than CROSSINGS_MAX */
    TRIAL_STEPS = 16,
    TRIAL_HALVINGS = 3, /* of both arcs together */
    TRIALS_MAX = 2      /* that fail */
};

struct pair_of_parts {
    struct part *f, *g;
};

/* Few arcs side by side still are when they are halved, but for those that touch.  So such a pair is tried
 * for some steps; if it is not settled by then, or after some halvings parts of it still lie side by side,
 * all that came of it is dropped, and it is left as it was. */
struct trial {
    bool on;
    struct pair_of_parts pair;
    int waiting, records; /* there were before */
    int last_step, failed;
    int deepest; /* depths of both arcs together: deeper ones are not to lie side by side */
};

struct kernel {
    struct front *z;
    double unit; /* u S */
    __m256d pad;
    bool raised;  /* one of the curves */
    bool powered; /* powers are made */
    int waiting, last_step;
    struct pair_of_parts wait[WAITING_MAX];
    struct trial trial;
    struct powers powers;
    struct parts *f, *g;
    struct parts first, second; /* of the curves in the order in which they came */
};

/* ---- a pair ---- */

FATLINE_AVX2 static bool leave(struct kernel *k, const struct part *f, const struct part *g)
{
    struct interval t = {f->lo, f->lo + f->width}, s = {g->lo, g->lo + g->width};
    return front_leave(k->z, t, s);
}

/* (t, t, s, s), low and high, as a record of the zero between.  There is room: a step adds one at most. */
AVX2_INLINE void record(struct crossings *out, __m256d low, __m256d high, bool is_end)
{
    struct crossing *c = &out->at[out->count++];
    _mm256_storeu_pd(&c->t.lo, _mm256_unpacklo_pd(low, high)); /* t.lo, t.hi, s.lo, s.hi */
    c->standing = (enum standing)(UNIQUE + is_end);            /* END is the next */
    c->at_most = 1;
    c->multiplicity = 1 - is_end;
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
    __m256d asked = _mm256_permute4x64_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&k->z->tolerance_t)), 0x50);
    __m256d wide = _mm256_cmp_pd(_mm256_sub_pd(high, low), asked, _CMP_GT_OQ); /* t, t, s, s */
    __m256d bad = _mm256_or_pd(cut, wide), end = _mm256_or_pd(below, above);
    if (!_mm256_testz_pd(bad, bad)) {
        return false;
    }
    /* next to no cut, but below or above: next to an end */
    record(k->z->out, low, high, !_mm256_testz_pd(end, end));
    return true;
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

AVX2_INLINE int depths_of(struct pair_of_parts at)
{
    return at.f->depth + at.g->depth;
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
    t->deepest = depths_of(at) + TRIAL_HALVINGS;
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
    if (verdict == BESIDE && (k->trial.on ? depths_of(at) > k->trial.deepest : !trial_begin(k, at))) {
        return LEFT;
    }
    return verdict <= BESIDE ? split(k, at.f, at.g) : verdict;
}

/* ---- many pairs at once ---- */

/* The part over a node of crowd.h; NULL: there is no room. */
FATLINE_AVX2 static struct part *part_of(struct kernel *k, struct parts *c, double node)
{
    struct part *a = &c->part[0];
    for (int code = (int)node, level = 30 - __builtin_clz((unsigned)code); a && level >= 0; level--) {
        struct part *half = part_split(c, a, k->pad);
        a = half ? half + (code >> level & 1) : NULL;
    }
    return a;
}

FATLINE_AVX2 static void rows_of(const struct part *whole, double x[4], double y[4])
{
    for (int i = 0; i < 4; i++) {
        x[i] = whole->point[i][0];
        y[i] = whole->point[i][1];
    }
}

static double node_of(const struct part *a)
{
    return (1 + a->lo) / a->width; /* exact */
}

/* Instead of one after the other, if many wait; false: there is nothing more to do. */
FATLINE_AVX2 static bool settle_crowd(struct kernel *k)
{
    struct crowd c;
    c.unit = k->unit;
    c.count = k->waiting;
    rows_of(&k->f->part[0], c.x[0], c.y[0]);
    rows_of(&k->g->part[0], c.x[1], c.y[1]);
    for (int i = 0; i < c.count; i++) {
        c.f[i] = node_of(k->wait[i].f);
        c.g[i] = node_of(k->wait[i].g);
    }
    k->waiting = 0;
    if (!crowd_settle_avx512(&c, k->z, k->last_step)) {
        return false;
    }
    for (int i = 0; i < c.count; i++) {
        struct part *f = part_of(k, k->f, c.f[i]), *g = part_of(k, k->g, c.g[i]);
        if (f && g && k->waiting < WAITING_MAX) {
            k->wait[k->waiting].f = f;
            k->wait[k->waiting++].g = g;
        } else {
            struct interval t = span_of_node(c.f[i]), s = span_of_node(c.g[i]);
            if (!front_leave(k->z, t, s)) {
                return false;
            }
        }
    }
    return true;
}

/* All pairs that wait. */
FATLINE_AVX2 static void work(struct kernel *k)
{
    if (k->waiting >= CROWD_FROM && k->z->many && !settle_crowd(k)) {
        return;
    }
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

#endif
