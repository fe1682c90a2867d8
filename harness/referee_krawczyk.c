/* Error analysis.  U = 2^-113.  A parameter t in [-1/64, 65/64] has |1 - t| + |t| <= 33/32, and (33/32)^32
 * < 2.7.
 *
 * One stage (1 - t) a + t b of de Casteljau's algorithm, with 1 - t rounded, errs by at most 3.01 U (33/32)
 * times the largest coefficient.  Value after n <= 32 stages: inputs 2 U * 2.7, stages n * 3.01 U * 2.7,
 * together less than 16 n U.  The same holds for the last two coefficients, hence for their difference (32 n
 * U) and n times that.
 *
 * Restriction is two such passes.  If b >= 1/2: to [0, b], then to [a/b, 1] of it, where a/b >= -1/32 and the
 * coefficients grow by (17/16)^32 < 7.  Else: to [a, 1], then to [0, (b-a)/(1-a)] of it, with no growth.
 * Growth in all at most 2.7 * 7 < 19.  Errors: inputs 2 U * 19; stages 2 n * 3.01 U * 19; the parameter of
 * the second pass errs by at most 3.2 U, which moves coefficients by at most n * 2 * 19 * 3.2 U.  Together
 * less than 300 n U; quad_restrict_error says 512 n U. */
#include "referee_krawczyk.h"

#include <quadmath.h>

static const quad U = 0x1p-113Q;

/* ---- intervals: every operation widens its result by 4 U of its magnitude, twice its rounding error --- */

static struct quad_interval widen(quad lo, quad hi, quad by)
{
    quad pad = by + 4 * U * fmaxq(fabsq(lo), fabsq(hi));
    struct quad_interval r = {lo - pad, hi + pad};
    return r;
}

static struct quad_interval sub(struct quad_interval a, struct quad_interval b)
{
    struct quad_interval r = widen(a.lo - b.hi, a.hi - b.lo, 4 * U * (fabsq(a.lo) + fabsq(b.hi)));
    return r;
}

static struct quad_interval add(struct quad_interval a, struct quad_interval b)
{
    struct quad_interval minus = {-b.hi, -b.lo};
    return sub(a, minus);
}

static struct quad_interval scaled(struct quad_interval a, quad by)
{
    return by >= 0 ? widen(a.lo * by, a.hi * by, 0) : widen(a.hi * by, a.lo * by, 0);
}

static struct quad_interval mul(struct quad_interval a, struct quad_interval b)
{
    quad p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    return widen(fminq(fminq(p, q), fminq(r, s)), fmaxq(fmaxq(p, q), fmaxq(r, s)), 0);
}

static quad magnitude(struct quad_interval a)
{
    return fmaxq(fabsq(a.lo), fabsq(a.hi));
}

static quad middle(struct quad_interval a)
{
    return (a.lo + a.hi) / 2;
}

/* ---- Bernstein polynomials ---------------------------------------------------------------------------- */

/* left: c becomes the coefficients over [0, t], else over [t, 1]. */
static void cut(int n, quad *c, quad t, bool left)
{
    quad u = 1 - t;
    for (int k = 1; k <= n; k++) {
        if (left)
            for (int i = n; i >= k; i--)
                c[i] = u * c[i - 1] + t * c[i];
        else
            for (int i = 0; i <= n - k; i++)
                c[i] = u * c[i] + t * c[i + 1];
    }
}

double quad_restrict_error(int n)
{
    return 512 * n * 0x1p-113;
}

void quad_restrict(int n, const quad *c, quad a, quad b, quad *out)
{
    for (int i = 0; i <= n; i++)
        out[i] = c[i];
    if (b >= 0.5Q) {
        if (b != 1)
            cut(n, out, b, true);
        if (a != 0)
            cut(n, out, a / b, false);
    } else {
        if (a != 0)
            cut(n, out, a, false);
        cut(n, out, (b - a) / (1 - a), true);
    }
}

/* Enclosures of a coordinate and of its derivative. */
struct jet {
    struct quad_interval value, slope;
};

static struct jet jet_over(int n, const quad *c, struct quad_interval d)
{
    quad b[QUAD_DEGREE_MAX + 1], error = quad_restrict_error(n);
    quad_restrict(n, c, d.lo, d.hi, b);
    quad lo = b[n], hi = b[n], slope_lo = b[1] - b[0], slope_hi = slope_lo;
    for (int i = 0; i < n; i++) {
        quad step = b[i + 1] - b[i];
        lo = fminq(lo, b[i]);
        hi = fmaxq(hi, b[i]);
        slope_lo = fminq(slope_lo, step);
        slope_hi = fmaxq(slope_hi, step);
    }
    /* d.hi - d.lo is rounded: relative error U, within the widening of `scaled`. */
    struct jet j = {widen(lo, hi, error),
                    scaled(scaled(widen(slope_lo, slope_hi, 2 * error), n), 1 / (d.hi - d.lo))};
    j.slope = widen(j.slope.lo, j.slope.hi, 4 * U * magnitude(j.slope));
    return j;
}

static struct jet jet_at(int n, const quad *c, quad t)
{
    quad b[QUAD_DEGREE_MAX + 1], u = 1 - t, error = 16 * n * U;
    for (int i = 0; i <= n; i++)
        b[i] = c[i];
    for (int k = 1; k < n; k++)
        for (int i = 0; i <= n - k; i++)
            b[i] = u * b[i] + t * b[i + 1];
    quad value = u * b[0] + t * b[1], slope = n * (b[1] - b[0]);
    struct jet j = {widen(value, value, error), widen(slope, slope, 2 * n * error)};
    return j;
}

/* ---- the system --------------------------------------------------------------------------------------- */

/* Enclosures of H and its Jacobian; the coordinates' jets, f then g. */
struct system {
    struct jet part[2][3];
    struct quad_interval value[2], jacobian[2][2];
};

static void assemble(bool rational, struct system *h)
{
    for (int i = 0; i < 2; i++) {
        struct jet f = h->part[0][i], g = h->part[1][i], u = h->part[0][2], v = h->part[1][2];
        if (rational) {
            h->value[i] = sub(mul(f.value, v.value), mul(g.value, u.value));
            h->jacobian[i][0] = sub(mul(f.slope, v.value), mul(g.value, u.slope));
            h->jacobian[i][1] = sub(mul(f.value, v.slope), mul(g.slope, u.value));
        } else {
            h->value[i] = sub(f.value, g.value);
            h->jacobian[i][0] = f.slope;
            h->jacobian[i][1] = scaled(g.slope, -1);
        }
    }
}

static void system_over(const struct quad_pair *p, const struct quad_interval d[2], struct system *h)
{
    for (int i = 0; i < (p->rational ? 3 : 2); i++) {
        h->part[0][i] = jet_over(p->f.degree, p->f.at[i], d[0]);
        h->part[1][i] = jet_over(p->g.degree, p->g.at[i], d[1]);
    }
    assemble(p->rational, h);
}

static void system_at(const struct quad_pair *p, const quad z[2], struct system *h)
{
    for (int i = 0; i < (p->rational ? 3 : 2); i++) {
        h->part[0][i] = jet_at(p->f.degree, p->f.at[i], z[0]);
        h->part[1][i] = jet_at(p->g.degree, p->g.at[i], z[1]);
    }
    assemble(p->rational, h);
}

/* Approximate inverse of the middle of J; false if there is none. */
static bool invert(struct quad_interval j[2][2], quad y[2][2])
{
    quad a = middle(j[0][0]), b = middle(j[0][1]), c = middle(j[1][0]), d = middle(j[1][1]);
    quad det = a * d - b * c;
    if (!(fabsq(det) > 8 * U * (fabsq(a * d) + fabsq(b * c))))
        return false;
    y[0][0] = d / det;
    y[0][1] = -b / det;
    y[1][0] = -c / det;
    y[1][1] = a / det;
    return true;
}

static struct quad_interval row_times(const quad row[2], struct quad_interval a, struct quad_interval b)
{
    return add(scaled(a, row[0]), scaled(b, row[1]));
}

/* ---- Krawczyk's test ---------------------------------------------------------------------------------- */

static struct quad_interval inflate(struct quad_interval a)
{
    quad by = (a.hi - a.lo) / 4;
    struct quad_interval r = {fmaxq(a.lo - by, -QUAD_OVERHANG), fminq(a.hi + by, 1 + QUAD_OVERHANG)};
    return r;
}

static void set_tangent(bool rational, const struct jet part[3], double tangent[2])
{
    for (int i = 0; i < 2; i++) {
        quad slope = middle(part[i].slope);
        if (rational) {
            quad w = middle(part[2].value);
            slope = (slope - middle(part[i].value) / w * middle(part[2].slope)) / w;
        }
        tangent[i] = (double)slope;
    }
}

/* The bound of referee_krawczyk.h at r->at, h being the system there. */
static void bound_distance(const struct system *h, struct quad_root *r)
{
    quad most = 0;
    for (int i = 0; i < 2; i++) {
        quad y[2] = {r->proof[i][0], r->proof[i][1]};
        most = fmaxq(most, magnitude(row_times(y, h->value[0], h->value[1])) / r->scale[i]);
    }
    for (int i = 0; i < 2; i++)
        r->radius[i] = most * r->scale[i] / (1 - r->contraction) * (1 + 0x1p-40Q);
}

/* Newton's method from the middle of the domain; false if it comes too near its border. */
static bool refine(const struct quad_pair *p, struct quad_root *r)
{
    struct system h;
    quad last = HUGE_VALQ;
    r->at[0] = middle(r->domain[0]);
    r->at[1] = middle(r->domain[1]);
    for (int k = 0; k < 40; k++) {
        system_at(p, r->at, &h);
        if (!invert(h.jacobian, r->inverse))
            return false;
        quad step = 0;
        for (int i = 0; i < 2; i++) {
            quad d = r->inverse[i][0] * middle(h.value[0]) + r->inverse[i][1] * middle(h.value[1]);
            r->at[i] -= d;
            step = fmaxq(step, fabsq(d) / r->scale[i]);
            quad margin = 2 * QUAD_ROOT_MARGIN * r->scale[i];
            if (!(r->at[i] > r->domain[i].lo + margin && r->at[i] < r->domain[i].hi - margin))
                return false;
        }
        if (step == 0 || (step < 0x1p-60Q && step >= last / 4))
            break;
        last = step;
    }
    system_at(p, r->at, &h);
    bound_distance(&h, r);
    set_tangent(p->rational, h.part[0], r->tangent[0]);
    set_tangent(p->rational, h.part[1], r->tangent[1]);
    return true;
}

/* K = m - Y H(m) + (1 - Y J(D)) (D - m).  Every zero in D lies in K, whatever Y is; if K lies in the interior
 * of D there is exactly one (Krawczyk 1969, Moore 1977). */
enum proof krawczyk_test(const struct quad_pair *p, struct quad_interval t, struct quad_interval s,
                         struct quad_root *root)
{
    struct quad_interval cell[2] = {t, s};
    quad m[2], y[2][2], radius[2], contraction = 0;
    struct system over, at;
    bool inside = true;

    for (int i = 0; i < 2; i++) {
        root->domain[i] = inflate(cell[i]);
        m[i] = middle(root->domain[i]);
    }
    system_over(p, root->domain, &over);
    system_at(p, m, &at);
    if (!invert(at.jacobian, y))
        return UNDECIDED;
    for (int i = 0; i < 2; i++) /* the proof works with these doubles, which any Y may be */
        for (int j = 0; j < 2; j++)
            y[i][j] = root->proof[i][j] = (double)y[i][j];
    for (int i = 0; i < 2; i++)
        radius[i] = fmaxq(root->domain[i].hi - m[i], m[i] - root->domain[i].lo) * (1 + 4 * U);
    for (int i = 0; i < 2; i++) {
        quad spread = 0;
        for (int j = 0; j < 2; j++) {
            struct quad_interval one = {i == j, i == j};
            struct quad_interval yj = row_times(y[i], over.jacobian[0][j], over.jacobian[1][j]);
            spread += magnitude(sub(one, yj)) * radius[j] * (1 + 8 * U);
        }
        struct quad_interval step = row_times(y[i], at.value[0], at.value[1]), here = {m[i], m[i]};
        struct quad_interval k = sub(here, step);
        k = widen(k.lo - spread, k.hi + spread, 8 * U * (spread + fabsq(m[i])));
        if (k.hi < cell[i].lo || k.lo > cell[i].hi)
            return NO_ROOT;
        inside = inside && k.lo > root->domain[i].lo && k.hi < root->domain[i].hi;
        contraction = fmaxq(contraction, spread / radius[i]);
        root->scale[i] = (double)radius[i];
    }
    root->contraction = (double)contraction * (1 + 0x1p-40) + 0x1p-40;
    if (!inside || !(root->contraction < 0.9) || !refine(p, root))
        return UNDECIDED;
    return ONE_ROOT;
}
