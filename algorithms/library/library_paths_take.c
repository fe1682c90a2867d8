/* What is wrong with a path, and its copy: plain segments as rows of a table, others as homogeneous
 * coordinates, and which follow each other. */
#include "library_paths.h"

enum { SEGMENTS_MAX = 1 << 30 };

static int degree_of(const struct fatline_path *p, int segment)
{
    return p->degree ? p->degree[segment] : 3;
}

/* ---- what is wrong? ---- */

enum fault { NOTHING, MISSING, COUNT, SUBPATHS, DEGREE, COORDINATE, WEIGHT, WEIGHTS, SIZE };

static const char *const errors[][2] = {
    {NULL, NULL},
    {"the first path or its points are missing", "the points of the second path are missing"},
    {"the number of segments of the first path is not 0 to 2^30",
     "the number of segments of the second path is not 0 to 2^30"},
    {"the subpaths of the first path do not begin at 0 and increase within its segments",
     "the subpaths of the second path do not begin at 0 and increase within its segments"},
    {"the degree of a segment of the first path is not 1 to 32",
     "the degree of a segment of the second path is not 1 to 32"},
    {"a coordinate of the first path is not finite", "a coordinate of the second path is not finite"},
    {"a weight of the first path is not positive and finite",
     "a weight of the second path is not positive and finite"},
    {"weights of a segment of the first path differ by more than 2^256",
     "weights of a segment of the second path differ by more than 2^256"},
    {"a segment with weights of the first path is not of a size of 2^-700 to 2^1000",
     "a segment with weights of the second path is not of a size of 2^-700 to 2^1000"},
};

static bool has_subpaths(const struct fatline_path *p)
{
    if (p->subpath && (p->subpaths < 0 || (p->count > 0) != (p->subpaths > 0))) {
        return false;
    }
    for (int j = 0; p->subpath && j < p->subpaths; j++) {
        if (j == 0 ? p->subpath[0] != 0 : p->subpath[j] <= p->subpath[j - 1] || p->subpath[j] >= p->count) {
            return false;
        }
    }
    return true;
}

/* All but points and weights; *segment: as path_error. */
static enum fault shape_fault(const struct fatline_path *p, int *segment)
{
    *segment = -1;
    if (!p || p->count < 0 || p->count > SEGMENTS_MAX) {
        return p ? COUNT : MISSING;
    }
    for (int i = 0; i < p->count; i++) {
        if (degree_of(p, i) < 1 || degree_of(p, i) > DEGREE_MAX) {
            *segment = i;
            return DEGREE;
        }
    }
    return has_subpaths(p) ? NOTHING : SUBPATHS;
}

static bool weights_differ(int count, const double *w)
{
    for (int i = 1; i < count; i++) {
        if (w[i] != w[0]) {
            return true;
        }
    }
    return false;
}

/* Weights below 1 and of at least 2^-257, as copy_rational makes them, times coordinates: without overflow,
 * and with an error that underflow brings of 2^-1075 at most, 2^-818 of a point, nothing beside u 2^-700. */
static enum fault weights_fault(int count, const double *w, double extent)
{
    double least = w[0], most = w[0];
    for (int i = 0; i < count; i++) {
        if (!(w[i] > 0) || !real_is_finite(w[i])) {
            return WEIGHT;
        }
        least = real_min(least, w[i]);
        most = real_max(most, w[i]);
    }
    if (most / least > 0x1p256) {
        return WEIGHTS;
    }
    return weights_differ(count, w) && extent != 0 && !(extent >= 0x1p-700 && extent <= 0x1p1000) ? SIZE
                                                                                                  : NOTHING;
}

static enum fault segment_fault(int count, const double *points, const double *weights)
{
    double extent = 0;
    for (int k = 0; k < 2 * count; k++) {
        if (!real_is_finite(points[k])) {
            return COORDINATE;
        }
        extent = real_max(extent, real_abs(points[k]));
    }
    return weights ? weights_fault(count, weights, extent) : NOTHING;
}

const char *path_error(const struct fatline_path *p, bool second, int *segment)
{
    enum fault fault = shape_fault(p, segment);
    if (fault == NOTHING && p->count > 0 && !p->points) {
        fault = MISSING;
    }
    size_t at = 0;
    for (int i = 0; fault == NOTHING && i < p->count; i++) {
        int count = degree_of(p, i) + 1;
        fault = segment_fault(count, p->points + 2 * at, p->weights ? p->weights + at : NULL);
        *segment = fault == NOTHING ? -1 : i;
        at += (size_t)count;
    }
    return errors[fault][second];
}

/* ---- a copy ---- */

static size_t rounded(size_t bytes)
{
    return (bytes + 63) / 64 * 64;
}

/* Numbers beside the table that a segment may need. */
static size_t other_numbers(const struct fatline_path *p, int segment)
{
    int n = degree_of(p, segment);
    return n > 3 || p->weights ? 3 * ((size_t)n + 1) : 0;
}

size_t path_taken_size(const struct fatline_path *p)
{
    int segment;
    if (shape_fault(p, &segment) != NOTHING) {
        return 0;
    }
    size_t numbers = 0, count = (size_t)p->count;
    for (int i = 0; i < p->count; i++) {
        numbers += other_numbers(p, i);
    }
    numbers += BATCH_NUMBERS * count;
    return rounded(1 + numbers * sizeof(real) + count * (sizeof(struct curve) + 2 * sizeof(int) + 1));
}

static void copy_plain(int n, const double *points, real *row, struct curve *to)
{
    for (int k = 0; k < BATCH_NUMBERS; k++) {
        row[k] = 0;
    }
    for (int i = 0; i <= n; i++) {
        row[i] = points[2 * i];
        row[BATCH_NUMBERS / 2 + i] = points[2 * i + 1];
    }
    to->x = row;
    to->y = row + BATCH_NUMBERS / 2;
}

/* Weights are brought below 1 by a power of two.  Returns the first number that was left. */
static real *copy_other(int n, const double *points, const double *weights, real *at, struct curve *to)
{
    real *x = at, *y = x + n + 1, *w = y + n + 1, heavy = 0;
    for (int i = 0; weights && i <= n; i++) {
        heavy = real_max(heavy, weights[i]);
    }
    for (int i = 0; i <= n; i++) {
        real weight = weights ? real_ldexp(weights[i], -real_exponent(heavy)) : (real)1;
        x[i] = weight * points[2 * i];
        y[i] = weight * points[2 * i + 1];
        if (weights) {
            w[i] = weight;
        }
    }
    to->x = x;
    to->y = y;
    to->w = weights ? w : NULL;
    return weights ? w + n + 1 : w;
}

static void copy_segments(const struct fatline_path *p, struct curve *segment, real *rows, real *others,
                          struct taken_path *out)
{
    const double *points = p->points, *weights = p->weights;
    out->degree = 1;
    for (int i = 0; i < p->count; i++) {
        int n = degree_of(p, i);
        bool rational = weights && weights_differ(n + 1, weights), plain = n <= 3 && !rational;
        struct curve *c = &segment[i];
        c->degree = n;
        c->w = NULL;
        c->domain.lo = 0;
        c->domain.hi = 1;
        if (plain) {
            copy_plain(n, points, rows + (size_t)BATCH_NUMBERS * (size_t)i, c);
        } else {
            others = copy_other(n, points, rational ? weights : NULL, others, c);
        }
        out->path.degree[i] = (unsigned char)(plain ? n : 0);
        out->degree = out->degree > n ? out->degree : n;
        points += 2 * (n + 1);
        weights = weights ? weights + n + 1 : NULL;
    }
}

void path_take(const struct fatline_path *p, void *memory, struct taken_path *out)
{
    size_t count = (size_t)p->count, others = 0;
    for (int i = 0; i < p->count; i++) {
        others += other_numbers(p, i);
    }
    real *rows = (real *)memory;
    struct curve *segment = (struct curve *)(void *)(rows + BATCH_NUMBERS * count + others);
    int *next = (int *)(void *)(segment + count);
    out->path.count = p->count;
    out->path.segment = segment;
    out->path.points = rows;
    out->path.next = next;
    out->path.before = next + count;
    out->path.degree = (unsigned char *)(next + 2 * count);
    copy_segments(p, segment, rows, rows + BATCH_NUMBERS * count, out);
    int subpaths = p->subpath ? p->subpaths : 1;
    for (int j = 0; j < subpaths; j++) {
        path_link(&out->path, p->subpath ? p->subpath[j] : 0,
                  j + 1 < subpaths ? p->subpath[j + 1] : p->count);
    }
}
