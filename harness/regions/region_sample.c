#include "region_sample.h"
#include "../run/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ORDERS = 3, COLUMNS = 4 }; /* S1, S2, W, eta and their derivatives 0, 1, 2 */

/* The curve in doubles, normalised. */
struct doubles {
    int degree, count, sign;
    double *knots, (*column)[COLUMNS];
};

static void find_frame(struct region_sample *s, const struct control_family *f)
{
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    bool any = false;
    for (int j = 0; j < f->count; j++)
        any = any || f->share[j] == 0;
    for (int j = 0; j < f->count; j++) {
        const double p[2] = {real_to_double(f->x[j]), real_to_double(f->y[j])};
        for (int c = 0; c < 2 && (!any || f->share[j] == 0); c++) {
            lo[c] = fmin(lo[c], p[c]);
            hi[c] = fmax(hi[c], p[c]);
        }
    }
    s->x0 = (lo[0] + hi[0]) / 2;
    s->y0 = (lo[1] + hi[1]) / 2;
    s->size = fmax(hi[0] - lo[0], hi[1] - lo[1]) / 2;
    s->size = s->size > 0 ? s->size : 1;
}

static void doubles_make(struct doubles *d, const struct region_sample *s, const struct region_problem *p)
{
    const struct control_family *f = &p->family;
    d->degree = f->degree;
    d->count = f->count;
    d->sign = p->sign;
    d->knots = (double *)memory_resized(NULL, (size_t)(f->count + f->degree + 1) * sizeof *d->knots);
    d->column = (double(*)[COLUMNS])memory_resized(NULL, (size_t)f->count * sizeof *d->column);
    for (int i = 0; i <= f->count + f->degree; i++)
        d->knots[i] = real_to_double(f->knots[i]);
    for (int j = 0; j < f->count; j++) {
        double w = f->weight ? real_to_double(f->weight[j]) : 1, share = real_to_double(f->share[j]);
        double x = real_to_double(f->x[j]) - s->x0, y = real_to_double(f->y[j]) - s->y0;
        double at_x = real_to_double(f->at.x) - s->x0, at_y = real_to_double(f->at.y) - s->y0;
        d->column[j][0] = w * (x - share * at_x) / s->size;
        d->column[j][1] = w * (y - share * at_y) / s->size;
        d->column[j][2] = w;
        d->column[j][3] = w * share;
    }
}

/* De Boor on the order-th differences of the control points k-n..k: value of that derivative at t. */
static double derivative(const struct doubles *d, int k, int column, int order, double t)
{
    double a[DEGREE_MAX + 1];
    int n = d->degree;
    const double *u = d->knots;
    for (int j = 0; j <= n; j++)
        a[j] = d->column[k - n + j][column];
    for (int r = 1; r <= order; r++)
        for (int j = n; j >= r; j--)
            a[j] = (n - r + 1) * (a[j] - a[j - 1]) / (u[k + 1 + j - r] - u[k - n + j]);
    for (int r = order + 1; r <= n; r++)
        for (int j = n; j >= r; j--) {
            double left = u[k - n + j], right = u[k + 1 + j - r], v = (t - left) / (right - left);
            a[j] = (1 - v) * a[j - 1] + v * a[j];
        }
    return a[n];
}

/* det(F', F'') for the handle at (x, y), F = (S + (x, y) eta) / W, by the rule for quotients; *noise grows to
 * what it may err by. */
static double height(double v[ORDERS][COLUMNS], double x, double y, double *noise)
{
    double w = v[0][2], f[2][ORDERS];
    for (int c = 0; c < 2; c++) {
        double h[ORDERS];
        for (int r = 0; r < ORDERS; r++)
            h[r] = v[r][c] + (c ? y : x) * v[r][3];
        f[c][0] = h[0] / w;
        f[c][1] = (h[1] - v[1][2] * f[c][0]) / w;
        f[c][2] = (h[2] - 2 * v[1][2] * f[c][1] - v[2][2] * f[c][0]) / w;
    }
    double first = hypot(f[0][1], f[1][1]), second = hypot(f[0][2], f[1][2]);
    *noise = fmax(*noise, 1e-13 * (1 + first) * (1 + second));
    return f[0][1] * f[1][2] - f[0][2] * f[1][1];
}

static void plane_at(const struct doubles *d, int k, double t, struct sampled_plane *out)
{
    double v[ORDERS][COLUMNS];
    for (int r = 0; r < ORDERS; r++)
        for (int c = 0; c < COLUMNS; c++)
            v[r][c] = derivative(d, k, c, r, t);
    double noise = 0, h = height(v, 0, 0, &noise);
    double a = height(v, 1, 0, &noise) - h, b = height(v, 0, 1, &noise) - h, length = hypot(a, b);
    double all = hypot(length, h);
    if (!(length > 1e-13 * all))
        length = fabs(h);
    if (!(all > 0))
        length = 1;
    out->error = noise / length;
    out->a = d->sign * a / length;
    out->b = d->sign * b / length;
    out->c = all > 0 ? d->sign * h / length : 1; /* nothing is known there */
}

/* Cuts the polygon by a plane; returns the number of corners left. */
static int clip(const struct sampled_plane *p, int n, double (*from)[2], double (*to)[2])
{
    int kept = 0;
    for (int i = 0; i < n; i++) {
        const double *q = from[i], *r = from[i + 1 < n ? i + 1 : 0];
        double hq = p->a * q[0] + p->b * q[1] + p->c, hr = p->a * r[0] + p->b * r[1] + p->c;
        if (hq >= 0) {
            to[kept][0] = q[0];
            to[kept++][1] = q[1];
        }
        if ((hq > 0 && hr < 0) || (hq < 0 && hr > 0)) {
            to[kept][0] = q[0] + (hq / (hq - hr)) * (r[0] - q[0]);
            to[kept++][1] = q[1] + (hq / (hq - hr)) * (r[1] - q[1]);
        }
    }
    return kept;
}

static bool cuts(const struct sampled_plane *p, int n, double (*corner)[2])
{
    for (int i = 0; i < n; i++)
        if (p->a * corner[i][0] + p->b * corner[i][1] + p->c < 0)
            return true;
    return false;
}

/* The planes in an order that spreads them, so that the polygon is small soon. */
static void find_corners(struct region_sample *s)
{
    static const double box[4][2] = {{-SAMPLE_BOX, -SAMPLE_BOX},
                                     {SAMPLE_BOX, -SAMPLE_BOX},
                                     {SAMPLE_BOX, SAMPLE_BOX},
                                     {-SAMPLE_BOX, SAMPLE_BOX}};
    double(*now)[2] = (double(*)[2])memory_resized(NULL, ((size_t)s->count + 8) * sizeof *now);
    double(*next)[2] = (double(*)[2])memory_resized(NULL, ((size_t)s->count + 8) * sizeof *next);
    int n = 4, step = 1;
    for (int i = 0; i < 4; i++) {
        now[i][0] = box[i][0];
        now[i][1] = box[i][1];
    }
    while (step * 2 < s->count)
        step *= 2;
    for (int done = step; step > 0; step /= 2) /* multiples of the step that are none of the step before */
        for (int i = step == done ? 0 : step; i < s->count && n > 0; i += step == done ? step : 2 * step) {
            if (!cuts(&s->plane[i], n, now))
                continue;
            n = clip(&s->plane[i], n, now, next);
            double(*other)[2] = now;
            now = next;
            next = other;
        }
    free(next);
    s->corners = n;
    s->corner = now;
}

void region_sample_make(struct region_sample *s, const struct region_problem *p, int per_span)
{
    const struct control_family *f = &p->family;
    struct doubles d;
    double lo = real_to_double(p->interval.lo), hi = real_to_double(p->interval.hi);
    find_frame(s, f);
    doubles_make(&d, s, p);
    s->count = 0;
    s->plane = (struct sampled_plane *)memory_resized(NULL, (size_t)(f->count - f->degree) *
                                                                (size_t)per_span * sizeof *s->plane);
    for (int k = f->degree; k < f->count; k++) {
        double a = fmax(d.knots[k], lo), b = fmin(d.knots[k + 1], hi);
        for (int i = 0; i < per_span && a < b; i++) {
            double x = (1 - cos(M_PI * (i + 0.5) / per_span)) / 2;
            plane_at(&d, k, a + x * (b - a), &s->plane[s->count++]);
        }
    }
    free(d.knots);
    free(d.column);
    find_corners(s);
}

void region_sample_clear(struct region_sample *s)
{
    free(s->plane);
    free(s->corner);
    s->plane = NULL;
    s->corner = NULL;
}

double region_sample_height(const struct region_sample *s, double x, double y)
{
    double least = INFINITY;
    x = (x - s->x0) / s->size;
    y = (y - s->y0) / s->size;
    double far = fmax(1, hypot(x, y));
    for (int i = 0; i < s->count; i++) {
        const struct sampled_plane *p = &s->plane[i];
        least = fmin(least, (p->a * x + p->b * y + p->c) / far + p->error);
    }
    return least;
}
