#include "implicit.h"

#include "bernstein.h"

/* Minors are expanded up to these degrees.  Above, an interpolating polynomial of degree N loses N bits and
 * more. */
#if REAL_BITS < 100
enum { MINORS_MAX = 8, DEGREE_LIMIT = MINORS_MAX };
#elif REAL_BITS < 1000
enum { MINORS_MAX = 10, DEGREE_LIMIT = MINORS_MAX };
#else
enum { MINORS_MAX = 4, DEGREE_LIMIT = 32 };
#endif

enum { POINTS_MAX = 33 };

int implicit_degree_max(void)
{
    return DEGREE_LIMIT;
}

/* ---- the Bezout matrix ---- */

/* w_i C(n, i); one rounding. */
static real scaled_weight(const struct polygon *p, int i)
{
    real b = binomial(p->degree, i);
    return p->w ? b * p->w[i] : b;
}

/* Adds the ball value +- error to coefficient q of all entries that contain L(j, i). */
static void add_to_entries(int d, int e, int i, int j, int q, real value, real error, real *m)
{
    for (int k = i, l = j - 1; k <= l; k++, l--) {
        real *entry = m + (k * d + l) * 2 * (e + 1) + q;
        entry[0] += value;
        entry[e + 1] += error;
    }
}

struct place {
    real x, y;
};

/* The ball of x_j y_i - x_i y_j for points j and i relative to the third, true to within delta + u |x|.  It
 * is D_x y_k - x_k D_y with the side D = j - i, true to within side_error + u |D|, and the nearer end k, so
 * that it keeps its digits where a is small against its distance.  Error of the value: (|x_k| + |y_k| +
 * delta) side_error
 * + (|D_x| + |D_y|) delta + 3u (|D_x y_k| + |x_k D_y|) + u |value|. */
static real triangle(const struct place *j, const struct place *i, const struct place *side, real delta,
                     real side_error, real *error)
{
    real at_i = real_abs(i->x) + real_abs(i->y), at_j = real_abs(j->x) + real_abs(j->y);
    const struct place *k = at_i <= at_j ? i : j;
    real first = side->x * k->y, second = k->x * side->y;
    *error = (real_min(at_i, at_j) + delta) * side_error + (real_abs(side->x) + real_abs(side->y)) * delta +
             3 * (REAL_EPSILON / 2) * (real_abs(first) + real_abs(second));
    return first - second;
}

/* Coefficient q of every entry: balls of L with weights, which add 6u |L|; the sum of at most d of them adds
 * d u |L|. */
static void add_coefficient(const struct polygon *a, const struct polygon *b, int q, real *m)
{
    const real u = REAL_EPSILON / 2;
    const int d = a->degree;
    const real delta = a->error + b->error, factor = scaled_weight(b, q);
    struct place p[POINTS_MAX];
    real w[POINTS_MAX];
    for (int i = 0; i <= d; i++) {
        p[i].x = a->x[i] - b->x[q];
        p[i].y = a->y[i] - b->y[q];
        w[i] = scaled_weight(a, i);
    }
    for (int i = 0; i < d; i++) {
        for (int j = i + 1; j <= d; j++) {
            const struct place side = {a->x[j] - a->x[i], a->y[j] - a->y[i]};
            real weight = factor * w[i] * w[j], error;
            real value = triangle(&p[j], &p[i], &side, delta, 2 * a->error, &error);
            error += (7 + d) * u * real_abs(value);
            add_to_entries(d, b->degree, i, j, q, weight * value, weight * error, m);
        }
    }
}

void implicit_matrix(const struct polygon *a, const struct polygon *b, real *m)
{
    const int length = b->degree + 1;
    for (int i = 0; i < a->degree * a->degree * 2 * length; i++) {
        m[i] = i / length % 2 ? REAL_LEAST : (real)0; /* what underflow may take */
    }
    for (int q = 0; q <= b->degree; q++) {
        add_coefficient(a, b, q, m);
    }
}

/* ---- minors ---- */

/* out += sign a b for ball polynomials of degrees n and e in scaled form.  kappa |a b| bounds the rounding of
 * all the products that are summed in one coefficient. */
static void add_product(real sign, int n, const real *a, int e, const real *b, real kappa, int stride,
                        real *out)
{
    const real *a_error = a + n + 1, *b_error = b + e + 1;
    real *out_error = out + stride;
    for (int j = 0; j <= e; j++) {
        real value = sign * b[j], size = real_abs(b[j]);
        real own = b_error[j] + kappa * size, most = size + b_error[j];
        for (int i = 0; i <= n; i++) {
            out[i + j] += a[i] * value;
            out_error[i + j] += real_abs(a[i]) * own + a_error[i] * most;
        }
    }
}

/* Minors of the rows first, first + step, ... (`rows` of them) by all sets of as many columns: table + set *
 * pitch is the minor of the set of bits `set`, a ball polynomial of degree e * (number of its columns).
 * Expansion along the last row; no division. */
static void expand_minors(int d, int e, const real *m, int first, int step, int rows, real *table)
{
    const int pitch = 2 * (d * e + 1);
    const real kappa = (real)(d * (e + 1) + 2) * (REAL_EPSILON / 2);
    table[0] = 1;
    table[1] = 0;
    for (int set = 1; set < 1 << d; set++) {
        int size = 0;
        for (int k = 0; k < d; k++) {
            size += set >> k & 1;
        }
        if (size > rows) {
            continue;
        }
        real *minor = table + (size_t)set * pitch;
        int row = first + step * (size - 1), length = size * e + 1, sign = size % 2 ? 1 : -1;
        for (int i = 0; i < 2 * length; i++) {
            minor[i] = i < length ? (real)0 : REAL_LEAST; /* more than underflow takes from fewer products */
        }
        for (int k = 0; k < d; k++) {
            if (set >> k & 1) {
                const real *entry = m + (row < k ? row * d + k : k * d + row) * 2 * (e + 1);
                add_product(sign, (size - 1) * e, table + (size_t)(set - (1 << k)) * pitch, e, entry, kappa,
                            length, minor);
                sign = -sign;
            }
        }
    }
}

void implicit_unscale(int n, const real *scaled, real *c, real *error)
{
    real factor = 1;
    for (int k = 0; k <= n; k++) {
        c[k] = scaled[k] / factor;
        error[k] = scaled[n + 1 + k] / factor + (2 * n + 1) * (REAL_EPSILON / 2) * real_abs(c[k]);
        error[k] += error[k] / 64 + REAL_LEAST;          /* the rounding of the bound itself; underflow */
        factor = factor * (real)(n - k) / (real)(k + 1); /* 2u each */
    }
}

void implicit_resultant(const struct polygon *a, const struct polygon *b, real *scratch, real *c, real *error)
{
    const int d = a->degree, e = b->degree, pitch = 2 * (d * e + 1);
    if (d > MINORS_MAX) {
        implicit_by_nodes(a, b, scratch, c, error);
        return;
    }
    real *table = scratch + d * d * 2 * (e + 1);
    implicit_matrix(a, b, scratch);
    expand_minors(d, e, scratch, 0, 1, d, table);
    implicit_unscale(d * e, table + (size_t)((1 << d) - 1) * pitch, c, error);
}

size_t implicit_scratch(int d, int e)
{
    size_t k = d < MINORS_MAX ? d : MINORS_MAX;
    size_t minors = k * k * 2 * (e + 1) + ((size_t)1 << k) * 2 * (k * e + 1);
    size_t nodes = d > MINORS_MAX ? implicit_by_nodes_scratch(d, e) : 0;
    return nodes > minors ? nodes : minors;
}

bool implicit_vanishes(int n, const real *c, const real *error)
{
    bool vanishes = true;
    for (int i = 0; i <= n; i++) {
        if (!real_is_finite(c[i])) {
            return true;
        }
        vanishes = vanishes && real_abs(c[i]) <= 4 * error[i];
    }
    return vanishes;
}

/* ---- inversion ---- */

struct ratio {
    real top, bottom, top_error, bottom_error;
};

/* u = top / bottom from the cofactors z_k of one row, multiples of (1-u)^(d-1-k) u^k where det M = 0:
 * sum C(d-2, k-1) z_k = u sum C(d-1, k) z_k.  The row is the last, or with step -1 the first. */
static struct ratio cofactor_ratio(int d, const real *m, int step, real *table)
{
    struct ratio r = {0, 0, 0, 0};
    expand_minors(d, 0, m, step > 0 ? 0 : d - 1, step, d - 1, table);
    for (int k = 0; k < d; k++) {
        const real *minor = table + 2 * (size_t)((1 << d) - 1 - (1 << k));
        real value = k % 2 ? -minor[0] : minor[0];
        real error = minor[1] + (d + 2) * (REAL_EPSILON / 2) * real_abs(value);
        r.bottom += binomial(d - 1, k) * value;
        r.bottom_error += binomial(d - 1, k) * error;
        if (k > 0) {
            r.top += binomial(d - 2, k - 1) * value;
            r.top_error += binomial(d - 2, k - 1) * error;
        }
    }
    r.top_error += r.top_error / 64;
    r.bottom_error += r.bottom_error / 64;
    return r;
}

/* A row of cofactors that is not 0 spans the null space, so the ratio holds for whatever u solves a(u) = P.
 */
static enum inversion narrow_by_ratio(const struct ratio *r, real *lo, real *hi)
{
    real top = real_abs(r->top), bottom = real_abs(r->bottom);
    if (!(bottom > r->bottom_error)) {
        return top - r->top_error > bottom + r->bottom_error ? NOWHERE : AMBIGUOUS;
    }
    real u = r->top / r->bottom;
    real error = (r->top_error + real_abs(u) * r->bottom_error) / (bottom - r->bottom_error);
    error += (real_abs(u) + error) * 4 * REAL_EPSILON;
    *lo = real_max(*lo, u - error);
    *hi = real_min(*hi, u + error);
    return *lo <= *hi ? INVERTED : NOWHERE;
}

enum inversion implicit_invert(const struct polygon *a, real x, real y, real radius, real *scratch, real *lo,
                               real *hi)
{
    const int d = a->degree;
    const struct polygon point = {0, &x, &y, NULL, radius};
    enum inversion found = AMBIGUOUS;
    *lo = 0;
    *hi = 1;
    if (d < 2 || d > MINORS_MAX) {
        return AMBIGUOUS;
    }
    real *table = scratch + 2 * d * d;
    implicit_matrix(a, &point, scratch);
    for (int step = -1; step <= 1; step += 2) {
        struct ratio r = cofactor_ratio(d, scratch, step, table);
        enum inversion one = narrow_by_ratio(&r, lo, hi);
        if (one == NOWHERE) {
            return NOWHERE;
        }
        found = one == INVERTED ? INVERTED : found;
    }
    return found;
}
