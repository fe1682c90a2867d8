/* The front kernel for polynomial curves of any degrees, with AVX2 and FMA.
 *
 * As the one for cubics: parts are halved where their octagons meet; where the cones of directions cross, the
 * one zero is found and proved, or proved absent; arcs side by side whose strips are apart are empty.  A zero
 * next to a cut, arcs that stay side by side, and parts of the least width are left to the engine.
 *
 * Everything is homogeneous in the coordinates, so scaling both curves by a power of two changes no bit of t
 * and s, as long as no product comes near the ends of the range: the extent must be between 2^-64 and 2^64.
 */
#include "front.h"

#ifdef FATLINE_AVX2

#include "avx2_any_one.h"

enum {
    WAITING_MAX = 64,       /* 16 at the root, and one more for each halving of either curve */
    STEPS_OF_KERNEL = 4096, /* curves of degree 16 may meet 256 times */
    TRIAL_STEPS = 30
};

struct waiting {
    int f, g;
};

/* Few arcs side by side still are when they are halved, but for those that touch.  So such a pair is tried
 * for some steps; if all that comes of it is not settled by then, or after some halvings parts of it still
 * lie side by side, that is dropped, and the pair is left as it was. */
struct trial {
    bool on;
    struct waiting pair;
    int waiting, records; /* there were before */
    int last_step;
    int deepest; /* depths of f and g together: deeper arcs are not to lie side by side */
};

struct kernel {
    struct front *z;
    double unit; /* u S */
    bool readied;
    int waiting, last_step;
    struct arcs f, g;
    struct waiting wait[WAITING_MAX];
    struct trial trial;
    struct ready of_f, of_g;
};

/* ---- memory ---- */

static size_t stride_of(int n)
{
    return (size_t)(n + 1 < POINTS_MIN ? (int)POINTS_MIN : n + 1);
}

static size_t bytes_of(int n)
{
    return ARCS_MAX * (stride_of(n) * sizeof(__m256d) + sizeof(struct arc));
}

size_t front_any_scratch(int n, int m)
{
    return (bytes_of(n) + bytes_of(m)) / sizeof(real) + 8;
}

static char *arcs_place(struct arcs *c, int n, char *at)
{
    c->n = n;
    c->stride = stride_of(n);
    c->arc = (struct arc *)(void *)at;
    c->points = (__m256d *)(void *)(at + ARCS_MAX * sizeof(struct arc));
    return at + bytes_of(n);
}

/* ---- the curves ---- */

static double extent_of(const struct curve *c, double most, double *sum)
{
    for (int i = 0; i <= c->degree; i++) {
        double x = fabs(c->x[i]), y = fabs(c->y[i]);
        most = x > most ? x : most;
        most = y > most ? y : most;
        *sum += x + y;
    }
    return most;
}

FATLINE_AVX2 static void arcs_begin(struct arcs *c, const struct curve *from, double unit)
{
    int n = from->degree;
    __m256d *p = arc_points(c, 1), low = _mm256_set1_pd(DBL_MAX), high = _mm256_set1_pd(-DBL_MAX);
    c->error = (12 * n + 1) * unit;
    for (int i = 0; i <= n; i++) {
        double x = from->x[i], y = from->y[i];
        p[i] = _mm256_setr_pd(x, y, x + y, x - y);
        low = _mm256_min_pd(low, p[i]);
        high = _mm256_max_pd(high, p[i]);
    }
    points_pad(n, p);
    octagon_store(c, low, high, &c->arc[1]);
}

/* ---- a pair ---- */

static int depth_of(int k)
{
    return 31 - __builtin_clz((unsigned)k);
}

static struct interval span_of(int k)
{
    int first = 1 << depth_of(k);
    struct interval r = {(double)(k - first) / first, (double)(k - first + 1) / first};
    return r;
}

static bool leave(struct kernel *k, int f, int g)
{
    return front_leave(k->z, span_of(f), span_of(g));
}

/* Is the zero next to a cut? */
static bool is_near_cut(const struct side *a)
{
    return (a->lo > 0 && a->t - a->radius <= a->lo) || (a->hi < 1 && a->t + a->radius >= a->hi);
}

/* OPEN, BESIDE: to be halved; BESIDE: with parallel directions; LEFT: for the engine. */
enum verdict { OPEN, BESIDE, CLOSED, LEFT };

/* Where the chords meet. */
AVX2_ANY void chords_meet(const struct kernel *k, int i, int j, struct side *f, struct side *g)
{
    const struct arc *a = &k->f.arc[i], *b = &k->g.arc[j];
    __m128d p = _mm256_castpd256_pd128(arc_points(&k->f, i)[0]);
    __m128d q = _mm256_castpd256_pd128(arc_points(&k->g, j)[0]), r = q - p;
    double x = _mm_cvtsd_f64(r), y = _mm_cvtsd_f64(_mm_unpackhi_pd(r, r));
    double one = 1 / (a->ex * b->ey - a->ey * b->ex);
    f->t = f->lo + (f->hi - f->lo) * ((x * b->ey - y * b->ex) * one);
    g->t = g->lo + (g->hi - g->lo) * ((x * a->ey - y * a->ex) * one);
}

FATLINE_AVX2 static enum verdict settle_one(struct kernel *k, int i, int j, double gap)
{
    struct side f, g;
    if (!k->readied) {
        ready_make(&k->f, k->unit, &k->of_f);
        ready_make(&k->g, k->unit, &k->of_g);
        k->readied = true;
    }
    side_make(&k->f, i, &k->g.arc[j], gap, &f);
    side_make(&k->g, j, &k->f.arc[i], gap, &g);
    chords_meet(k, i, j, &f, &g);
    enum search_of_one found = one_zero(&k->of_f, &k->of_g, &f, &g);
    if (found == NOWHERE) {
        return CLOSED;
    }
    return found == SOMEWHERE && !is_near_cut(&f) && !is_near_cut(&g) &&
                   front_zero(k->z, f.t, f.radius, g.t, g.radius)
               ? CLOSED
               : LEFT;
}

FATLINE_AVX2 static enum verdict settle(struct kernel *k, const struct waiting *at)
{
    struct arc *f = &k->f.arc[at->f], *g = &k->g.arc[at->g];
    if (!f->ready) {
        arc_prepare(&k->f, at->f);
    }
    if (!g->ready) {
        arc_prepare(&k->g, at->g);
    }
    double gap = cones_gap(&k->f, f, &k->g, g);
    if (gap > 0) {
        return settle_one(k, at->f, at->g, gap);
    }
    if (f->wide || g->wide) {
        return OPEN;
    }
    if (strips_are_apart(&k->f, at->f, &k->g, at->g) || strips_are_apart(&k->g, at->g, &k->f, at->f)) {
        return CLOSED;
    }
    return BESIDE;
}

static inline bool is_deepest(int k)
{
    return k >= 1 << DEPTH_OF_ARCS;
}

/* The pair's halves; false: one is as deep as can be, or there is no room. */
FATLINE_AVX2 static bool halve(struct kernel *k, const struct waiting *at)
{
    bool of_f = k->f.arc[at->f].bend >= k->g.arc[at->g].bend;
    struct arcs *c = of_f ? &k->f : &k->g, *d = of_f ? &k->g : &k->f;
    int half = of_f ? at->f : at->g, other = of_f ? at->g : at->f;
    if (is_deepest(half) || k->waiting + 2 > WAITING_MAX) {
        return false;
    }
    if (!c->arc[half].halved) {
        arc_halve(c, half);
    }
    for (int i = 2 * half + 1; i >= 2 * half; i--) {
        struct waiting next = {of_f ? i : other, of_f ? other : i};
        k->wait[k->waiting] = next;
        k->waiting += arcs_meet(&c->arc[i], &d->arc[other]);
    }
    return true;
}

/* The whole curve in 1, 2 or 4 parts by how far it is from straight; returns the first, the others follow. */
FATLINE_AVX2 static int parts_of(struct arcs *c, bool least_two, int *first)
{
    const struct arc *a = &c->arc[1];
    double straight = c->n * (c->n - 1) * a->speed;
    *first = 1;
    if (!least_two && 16 * a->bend <= 3 * straight) {
        return 1;
    }
    arc_halve(c, 1);
    *first = 2;
    if (2 * a->bend <= straight) {
        return 2;
    }
    arc_halve(c, 2);
    arc_halve(c, 3);
    *first = 4;
    return 4;
}

FATLINE_AVX2 static void split_whole(struct kernel *k)
{
    bool larger_f = k->f.arc[1].bend >= k->g.arc[1].bend;
    int first_f, first_g, n = parts_of(&k->f, larger_f, &first_f), m = parts_of(&k->g, !larger_f, &first_g);
    struct waiting *top = k->wait; /* none waits yet */
    for (int i = first_f + n - 1; i >= first_f; i--) {
        const __m256d low = k->f.arc[i].low, high = k->f.arc[i].high;
        for (int j = first_g + m - 1; j >= first_g; j--) {
            top->f = i;
            top->g = j;
            top += octagons_meet(low, high, k->g.arc[j].low, k->g.arc[j].high);
        }
    }
    k->waiting = (int)(top - k->wait);
}

static int depths_of(const struct waiting *at)
{
    return depth_of(at->f) + depth_of(at->g);
}

/* Of trials of the higher degrees more come to a good end after all, and the engine takes longer for them. */
static void trial_begin(struct kernel *k, const struct waiting *at)
{
    struct trial *trial = &k->trial;
    trial->on = true;
    trial->pair = *at;
    trial->waiting = k->waiting;
    trial->records = k->z->out->count;
    trial->last_step = k->z->steps + TRIAL_STEPS;
    trial->deepest = depths_of(at) + 3 + (k->f.n + k->g.n) / 4;
}

/* What is to be left instead of `at`. */
static struct waiting trial_fail(struct kernel *k)
{
    k->trial.on = false;
    k->waiting = k->trial.waiting;
    k->z->out->count = k->trial.records;
    return k->trial.pair;
}

/* CLOSED: the pair is settled, or its halves wait. */
FATLINE_AVX2 static enum verdict step(struct kernel *k, const struct waiting *at)
{
    struct front *z = k->z;
    if (z->steps >= k->last_step || (k->trial.on && z->steps >= k->trial.last_step)) {
        return LEFT;
    }
    z->steps++;
    enum verdict verdict = settle(k, at);
    if (verdict == CLOSED || verdict == LEFT) {
        return verdict;
    }
    if (verdict == BESIDE && !k->trial.on) {
        trial_begin(k, at);
    } else if (verdict == BESIDE && depths_of(at) > k->trial.deepest) {
        return LEFT;
    }
    return halve(k, at) ? CLOSED : LEFT;
}

FATLINE_AVX2 static void work(struct kernel *k)
{
    while (k->waiting > 0) {
        struct waiting at = k->wait[--k->waiting];
        if (k->trial.on && k->waiting < k->trial.waiting) {
            k->trial.on = false;
        }
        if (step(k, &at) == LEFT) {
            at = k->trial.on ? trial_fail(k) : at;
            if (!leave(k, at.f, at.g)) {
                return;
            }
        }
    }
}

static void solve(struct kernel *k)
{
    struct front *z = k->z;
    struct waiting whole = {1, 1};
    int allowed = z->max_steps - z->steps;
    k->last_step = z->steps + (allowed < STEPS_OF_KERNEL ? allowed : (int)STEPS_OF_KERNEL);
    k->waiting = 0;
    k->readied = k->trial.on = false;
    z->steps++;
    enum verdict verdict = settle(k, &whole);
    if (verdict == LEFT || verdict == BESIDE) { /* whole curves side by side mostly touch, or nearly */
        leave(k, 1, 1);
    } else if (verdict != CLOSED) {
        split_whole(k);
        work(k);
    }
}

FATLINE_AVX2 bool front_any_avx2(struct front *z)
{
    struct kernel k;
    double sum = 0, most = extent_of(z->g, extent_of(z->f, 0, &sum), &sum);
    if (!(sum < 0x1p64) || !(most > 0x1p-64) ||
        z->scratch_length < front_any_scratch(z->f->degree, z->g->degree)) {
        return false;
    }
    char *at = (char *)z->scratch;
    at += (32 - (size_t)at % 32) % 32;
    arcs_place(&k.g, z->g->degree, arcs_place(&k.f, z->f->degree, at));
    k.z = z;
    k.unit = DBL_EPSILON / 2 * most;
    arcs_begin(&k.f, z->f, k.unit);
    arcs_begin(&k.g, z->g, k.unit);
    if (arcs_meet(&k.f.arc[1], &k.g.arc[1])) {
        solve(&k);
    }
    return true;
}

#endif
