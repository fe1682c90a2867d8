/* u = 2^-53 below; every bound is stated with u and computed with 2 u or more, which pays for its own
 * rounding. */
#include "referee_cells.h"

#include <math.h>

static const double TWO_U = 0x1p-52;

static double largest(int n, const double *a)
{
    double m = 0;
    for (int i = 0; i <= n; i++)
        m = fabs(a[i]) > m ? fabs(a[i]) : m;
    return m;
}

static double smallest(int n, const double *a)
{
    double m = a[0];
    for (int i = 1; i <= n; i++)
        m = a[i] < m ? a[i] : m;
    return m;
}

/* ---- cutting ------------------------------------------------------------------------------------------ */

/* |anchor|, |x|, |y|, w <= 1, so x - anchor w errs by two restriction errors and 3 roundings in binary128,
 * and by u of its size in double. */
static bool cut_part(const struct quad_curve *c, bool rational, const quad anchor[2],
                     quad b[3][QUAD_DEGREE_MAX + 1], struct anchored_part *p)
{
    int n = c->degree;
    double restricted = quad_restrict_error(n);

    for (int k = 0; k < 2; k++)
        for (int i = 0; i <= n; i++)
            p->at[k][i] = (double)(b[k][i] - (rational ? anchor[k] * b[2][i] : anchor[k]));
    p->error = 4 * restricted + TWO_U * fmax(largest(n, p->at[0]), largest(n, p->at[1]));
    p->weight_error = 0;
    if (!rational)
        return true;
    for (int i = 0; i <= n; i++)
        p->at[2][i] = (double)b[2][i];
    double least = smallest(n, p->at[2]);
    p->weight_error = 2 * restricted / least + TWO_U;
    return least > 0x1p20 * restricted;
}

static void restrict_part(const struct quad_curve *c, bool rational, const struct anchored_part *p,
                          quad b[3][QUAD_DEGREE_MAX + 1])
{
    for (int k = 0; k < (rational ? 3 : 2); k++)
        quad_restrict(c->degree, c->at[k], p->lo, p->lo + p->width, b[k]);
}

bool anchored_cut(const struct quad_pair *p, struct anchored_cell *c)
{
    quad f[3][QUAD_DEGREE_MAX + 1], g[3][QUAD_DEGREE_MAX + 1], anchor[2];
    restrict_part(&p->f, p->rational, &c->f, f);
    restrict_part(&p->g, p->rational, &c->g, g);
    for (int k = 0; k < 2; k++) {
        quad a = p->rational ? f[k][0] / f[2][0] : f[k][0];
        anchor[k] = a < -1 ? -1 : a > 1 ? 1 : a;
    }
    c->since_cut = 0;
    bool cut_f = cut_part(&p->f, p->rational, anchor, f, &c->f);
    return cut_part(&p->g, p->rational, anchor, g, &c->g) && cut_f;
}

/* ---- halving ------------------------------------------------------------------------------------------ */

/* Each of the n stages errs by u of its result, absolutely for x and y, relatively for w > 0. */
static void halve_part(int n, bool rational, struct anchored_part *a, struct anchored_part *b)
{
    for (int k = 0; k < (rational ? 3 : 2); k++) {
        double *left = a->at[k], *right = b->at[k];
        for (int i = 0; i <= n; i++)
            right[i] = left[i];
        for (int j = 1; j <= n; j++) {
            for (int i = 0; i <= n - j; i++)
                right[i] = 0.5 * (right[i] + right[i + 1]);
            left[j] = right[0];
        }
    }
    a->halvings++;
    a->width /= 2;
    b->lo = a->lo + a->width;
    b->width = a->width;
    b->halvings = a->halvings;
    b->error = a->error;
    b->weight_error = a->weight_error;
}

void anchored_halve(const struct quad_pair *p, struct anchored_cell *c, bool f, struct anchored_cell *second)
{
    int n = f ? p->f.degree : p->g.degree;
    struct anchored_part *a = f ? &c->f : &c->g;

    a->error += n * TWO_U * fmax(largest(n, a->at[0]), largest(n, a->at[1]));
    a->weight_error += n * TWO_U;
    c->since_cut++;
    *second = *c;
    halve_part(n, p->rational, a, f ? &second->f : &second->g);
}

/* ---- looking ------------------------------------------------------------------------------------------ */

/* Euclidean control points, each coordinate within error of the exact one. */
struct polygon {
    int degree;
    double x[QUAD_DEGREE_MAX + 1], y[QUAD_DEGREE_MAX + 1];
    double error, largest;
    double lo[2], hi[2];
};

/* x / w for |x~ - x| <= e and w~ = w (1 + d): error at most (e / w~ + |x~ / w~| |d|) / (1 - |d|) + u |x~ /
 * w~|. */
static void polygon_make(int n, bool rational, const struct anchored_part *p, struct polygon *q)
{
    q->degree = n;
    q->lo[0] = q->lo[1] = HUGE_VAL;
    q->hi[0] = q->hi[1] = -HUGE_VAL;
    for (int i = 0; i <= n; i++) {
        q->x[i] = rational ? p->at[0][i] / p->at[2][i] : p->at[0][i];
        q->y[i] = rational ? p->at[1][i] / p->at[2][i] : p->at[1][i];
        q->lo[0] = q->x[i] < q->lo[0] ? q->x[i] : q->lo[0];
        q->hi[0] = q->x[i] > q->hi[0] ? q->x[i] : q->hi[0];
        q->lo[1] = q->y[i] < q->lo[1] ? q->y[i] : q->lo[1];
        q->hi[1] = q->y[i] > q->hi[1] ? q->y[i] : q->hi[1];
    }
    q->largest = fmax(fmax(-q->lo[0], q->hi[0]), fmax(-q->lo[1], q->hi[1]));
    q->error = p->error;
    if (rational)
        q->error = 2 * p->error / smallest(n, p->at[2]) + 2 * (p->weight_error + TWO_U) * q->largest;
}

static double extent(const struct polygon *q)
{
    return fmax(q->hi[0] - q->lo[0], q->hi[1] - q->lo[1]);
}

static void project(const struct polygon *q, double nx, double ny, double *lo, double *hi)
{
    *lo = HUGE_VAL;
    *hi = -HUGE_VAL;
    for (int i = 0; i <= q->degree; i++) {
        double v = nx * q->x[i] + ny * q->y[i];
        *lo = v < *lo ? v : *lo;
        *hi = v > *hi ? v : *hi;
    }
}

/* Curves lie in the hulls of their control points, so projections that do not overlap separate them.  A
 * projection errs by (|nx| + |ny|) (error + 2 u largest); the difference of two ends by u of its size more.
 */
static bool separated(const struct polygon *f, const struct polygon *g, double nx, double ny)
{
    double f_lo, f_hi, g_lo, g_hi;
    double margin = 2 * (fabs(nx) + fabs(ny)) * (f->error + g->error + 4 * TWO_U * (f->largest + g->largest));
    project(f, nx, ny, &f_lo, &f_hi);
    project(g, nx, ny, &g_lo, &g_hi);
    return f_lo > g_hi + margin || g_lo > f_hi + margin;
}

static bool apart(const struct polygon *f, const struct polygon *g)
{
    int n = f->degree, m = g->degree;
    double margin = 2 * (f->error + g->error + TWO_U * (f->largest + g->largest));
    for (int k = 0; k < 2; k++)
        if (f->lo[k] > g->hi[k] + margin || g->lo[k] > f->hi[k] + margin)
            return true;
    return separated(f, g, f->y[0] - f->y[n], f->x[n] - f->x[0]) ||
           separated(f, g, g->y[0] - g->y[m], g->x[m] - g->x[0]);
}

/* Largest |row (n d - chord)| over the steps d of the polygon. */
static double bend(const struct polygon *q, const double row[2])
{
    int n = q->degree;
    double x = q->x[n] - q->x[0], y = q->y[n] - q->y[0], most = 0;
    for (int i = 0; i < n; i++) {
        double b = row[0] * (n * (q->x[i + 1] - q->x[i]) - x) + row[1] * (n * (q->y[i + 1] - q->y[i]) - y);
        most = fabs(b) > most ? fabs(b) : most;
    }
    return most;
}

/* The chords cross near the cell, and Krawczyk's operator with the chords' directions for Y contracts. */
static bool promising(const struct polygon *f, const struct polygon *g)
{
    int n = f->degree, m = g->degree;
    double a = f->x[n] - f->x[0], b = g->x[0] - g->x[m], c = f->y[n] - f->y[0], d = g->y[0] - g->y[m];
    double det = a * d - b * c, x = g->x[0] - f->x[0], y = g->y[0] - f->y[0];
    double inverse[2][2] = {{d / det, -b / det}, {-c / det, a / det}};
    for (int i = 0; i < 2; i++) {
        double at = inverse[i][0] * x + inverse[i][1] * y;
        double contraction = 1.25 * (bend(f, inverse[i]) + bend(g, inverse[i]));
        if (!(contraction < 0.4 && fabs(at - 0.5) < 0.8))
            return false;
    }
    return true;
}

struct anchored_view anchored_look(const struct quad_pair *p, const struct anchored_cell *c)
{
    struct anchored_view view = {false, false, true, false};
    struct polygon f, g;

    polygon_make(p->f.degree, p->rational, &c->f, &f);
    polygon_make(p->g.degree, p->rational, &c->g, &g);
    view.apart = apart(&f, &g);
    if (view.apart)
        return view;
    view.split_f = extent(&f) >= extent(&g);
    view.blurred = f.error + g.error > 0x1p-20 * fmin(extent(&f), extent(&g));
    view.promising = promising(&f, &g);
    return view;
}
