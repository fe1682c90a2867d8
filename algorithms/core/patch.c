#include "patch.h"

#include "bernstein.h"
#include "roots.h"

/* Any direction will do where the curve stands still. */
static void find_direction(const struct lowered *s, real t, struct patch *h)
{
    const int n = s->polygon.degree;
    real value[3] = {0, 0, 1}, slope[3] = {0, 0, 0}, scratch[POINTS_MAX];
    for (int k = 0; k < s->components; k++) {
        value[k] = bernstein_value_slope(n, s->homogeneous + k * (n + 1), t, scratch, &slope[k]);
    }
    real x = slope[0] * value[2] - value[0] * slope[2], y = slope[1] * value[2] - value[1] * slope[2];
    real size = real_max(real_abs(x), real_abs(y));
    h->x = size > 0 ? x / size : (real)1;
    h->y = size > 0 ? y / size : (real)0;
}

/* Cutting errs by 8n u |x| (bernstein.h), for quotients twice. */
void patch_cut(const struct lowered *s, real lo, real hi, struct patch *h)
{
    const int n = s->polygon.degree, middle = n / 2;
    real q[3 * POINTS_MAX];
    bernstein_restrict(n, s->components, s->homogeneous, lo, hi, q);
    h->degree = n;
    h->error = s->polygon.error + (4 * n + 2) * (s->components == 3 ? 2 : 1) * REAL_EPSILON * s->extent;
    h->radius = 0;
    real w = s->components == 3 ? q[2 * (n + 1) + middle] : (real)1;
    h->px = q[middle] / w;
    h->py = q[n + 1 + middle] / w;
    for (int i = 0; i <= n; i++) {
        w = s->components == 3 ? q[2 * (n + 1) + i] : (real)1;
        h->dx[i] = q[i] / w - h->px;
        h->dy[i] = q[n + 1 + i] / w - h->py;
        h->radius = real_max(h->radius, real_max(real_abs(h->dx[i]), real_abs(h->dy[i])));
    }
    h->radius += h->error;
    find_direction(s, lo + (hi - lo) / 2, h);
}

/* All parameters where a may meet the strip of normal (x, y) around the patch. */
static int meet_strip(const struct patch *h, const struct polygon *a, real x, real y, real tolerance,
                      real *scratch, struct root *out)
{
    const real norm = real_abs(x) + real_abs(y);
    real c[POINTS_MAX], error[POINTS_MAX], width = 0;
    for (int i = 0; i <= h->degree; i++) {
        width = real_max(width, real_abs(x * h->dx[i] + y * h->dy[i]));
    }
    width += norm * (h->error + a->error + 4 * REAL_EPSILON * h->radius);
    for (int i = 0; i <= a->degree; i++) {
        real w = a->w ? a->w[i] : (real)1;
        real px = x * (a->x[i] - h->px), py = y * (a->y[i] - h->py);
        c[i] = w * (px + py);
        error[i] = w * (width + 3 * REAL_EPSILON * (real_abs(px) + real_abs(py)));
    }
    return roots_find(a->degree, c, error, tolerance, scratch, a->degree + 1, out);
}

int patch_meet(const struct patch *h, const struct lowered *a, real tolerance, real *scratch,
               struct interval out[MEETINGS_MAX])
{
    struct root along[POINTS_MAX], across[POINTS_MAX];
    int n = meet_strip(h, &a->polygon, -h->y, h->x, tolerance, scratch, along);
    int m = meet_strip(h, &a->polygon, h->x, h->y, tolerance, scratch, across);
    int count = 0;
    for (int i = 0, j = 0; i < n && j < m;) {
        real lo = real_max(along[i].lo, across[j].lo), hi = real_min(along[i].hi, across[j].hi);
        if (lo <= hi) {
            out[count].lo = lo;
            out[count++].hi = hi;
        }
        if (along[i].hi < across[j].hi) {
            i++;
        } else {
            j++;
        }
    }
    return count;
}
