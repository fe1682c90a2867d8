#include "wronskian.h"

#include "form.h"

enum { LENGTH = 97, COEFFICIENTS = 33, RANKS = 4, COLUMNS = 4 };

/* Scaled forms of nonnegative coefficients: sizes, and the same plus `small` times their errors in units of
 * REAL_EPSILON; of a product of such pairs the difference is, over `small`, its error to first order. */
struct sizes {
    int n;
    real plain[LENGTH], raised[LENGTH];
};

/* Column c of rank k, degree n: the k-th difference of the coefficients of component c, scaled. */
struct ranks {
    int n, ranks, columns;
    real at[RANKS][COLUMNS][COEFFICIENTS];
    struct sizes sizes[RANKS]; /* see ranks_make */
};

int envelope_degree(int n, bool rational)
{
    return rational ? 2 * n - 2 : n - 1;
}

int planes_degree(int n, bool rational)
{
    return rational ? 3 * n - 6 : 2 * n - 4;
}

int torsion_degree(int n, bool rational)
{
    return n < 3 ? -1 : rational ? 4 * n - 12 : 3 * n - 9;
}

static real small(void)
{
    return real_ldexp(1, -REAL_BITS / 2);
}

static void sizes_multiply(const struct sizes *a, const struct sizes *b, struct sizes *out)
{
    out->n = a->n + b->n;
    form_clear(out->n, out->plain);
    form_clear(out->n, out->raised);
    form_add_product(a->n, a->plain, b->n, b->plain, 1, out->plain);
    form_add_product(a->n, a->raised, b->n, b->raised, 1, out->raised);
}

/* What a determinant errs by, in units of REAL_EPSILON: its factors' errors, and the roundings of at most 24
 * products and their sums. */
static void sizes_bound(const struct sizes *s, real *bound)
{
    const real roundings = 4 * s->n + 16, large = 1 / small();
    for (int i = 0; i <= s->n; i++) {
        bound[i] = roundings * s->plain[i] + (s->raised[i] - s->plain[i]) * large;
    }
}

/* Differences 0..ranks-1 of `columns` forms of degree n, c[k][i], that err by at most noise[i] REAL_EPSILON;
 * a determinant of the polynomials f, f', f'', ... is that of the differences of one degree, up to a positive
 * constant, and at most the product of the sums of |differences| over the columns: their sizes. */
static void ranks_make(int n, int ranks, int columns, const real *const *c, const real *noise,
                       const real *pascal, struct ranks *r)
{
    r->n = n - (ranks - 1);
    r->ranks = ranks;
    r->columns = columns;
    real d[COLUMNS][COEFFICIENTS], error[COEFFICIENTS];
    for (int i = 0; i <= n; i++) {
        error[i] = noise[i];
        for (int k = 0; k < columns; k++) {
            d[k][i] = c[k][i];
        }
    }
    const real *row = pascal_row(pascal, r->n);
    for (int rank = 0; rank < ranks; rank++) {
        r->sizes[rank].n = r->n;
        for (int i = 0; i <= r->n; i++) {
            real size = 0;
            for (int k = 0; k < columns; k++) {
                r->at[rank][k][i] = d[k][i] * row[i];
                size += real_abs(d[k][i]);
            }
            r->sizes[rank].plain[i] = size * row[i];
            r->sizes[rank].raised[i] = (size + (size + error[i]) * small()) * row[i];
        }
        for (int i = 0; i < n - rank; i++) {
            error[i] += error[i + 1];
            for (int k = 0; k < columns; k++) {
                d[k][i] = d[k][i + 1] - d[k][i];
            }
        }
    }
}

/* out = column i of rank a times column j of rank a + 1, minus the exchange: scaled, degree 2n. */
static void minor(const struct ranks *r, int a, int i, int j, real *out)
{
    form_clear(2 * r->n, out);
    form_add_product(r->n, r->at[a][i], r->n, r->at[a + 1][j], 1, out);
    form_add_product(r->n, r->at[a][j], r->n, r->at[a + 1][i], -1, out);
}

/* Adds factor Wr(i, j, k), columns of three ranks, given the minors of ranks 1 and 2. */
static void add_wronskian(const struct ranks *r, int i, const real *minor_jk, int j, const real *minor_ik,
                          int k, const real *minor_ij, real *out)
{
    form_clear(3 * r->n, out);
    form_add_product(r->n, r->at[0][i], 2 * r->n, minor_jk, 1, out);
    form_add_product(r->n, r->at[0][j], 2 * r->n, minor_ik, -1, out);
    form_add_product(r->n, r->at[0][k], 2 * r->n, minor_ij, 1, out);
}

/* ---- factors of t and 1 - t ---- */

/* Takes out of `components` scaled forms of degree n the factors t^lo (1 - t)^hi. */
static int shift(int n, int components, real *c, int lo, int hi)
{
    int left = n - lo - hi;
    for (int k = 0; k < components; k++) {
        for (int i = 0; i <= left; i++) {
            c[k * (left + 1) + i] = c[k * (n + 1) + lo + i];
        }
    }
    return left;
}

/* Coefficient i of the first `components` of c is not distinguishable from 0; bound NULL: is 0. */
static bool is_zero(int n, int components, const real *c, const real *bound, int i)
{
    for (int k = 0; k < components; k++) {
        if (real_abs(c[k * (n + 1) + i]) > (bound ? bound[i] * REAL_EPSILON : (real)0)) {
            return false;
        }
    }
    return true;
}

static void count_zeros(int n, int components, const real *c, const real *bound, int *lo, int *hi)
{
    for (*lo = 0; *lo <= n && is_zero(n, components, c, bound, *lo); ++*lo) {
    }
    for (*hi = 0; *lo + *hi <= n && is_zero(n, components, c, bound, n - *hi); ++*hi) {
    }
}

/* ---- the forms ---- */

/* w of a polynomial family: differences, those within the errors of the inputs taken for 0. */
static void envelope_polynomial(const struct span_input *s, const real *pascal, struct span_forms *f)
{
    const real *from[3] = {s->s1, s->s2, s->eta};
    f->e = s->n - 1;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i <= f->e; i++) {
            real a = from[k][i], b = from[k][i + 1];
            real noise = 8 * s->n * REAL_EPSILON * (real_abs(a) + real_abs(b));
            real w = k < 2 ? a - b : b - a;
            f->w[k * (f->e + 1) + i] = (real_abs(w) <= noise ? (real)0 : w) * pascal_row(pascal, f->e)[i];
        }
    }
}

/* w_1 = Wr(S1, W), w_2 = Wr(S2, W), w_3 = Wr(W, eta). */
static void envelope_rational(const struct ranks *r, real *w)
{
    int e = 2 * r->n;
    minor(r, 0, 0, 2, w);
    minor(r, 0, 1, 2, w + e + 1);
    minor(r, 0, 2, 3, w + 2 * (e + 1));
}

/* L of a polynomial family: w x w' from w's two ranks. */
static void planes_polynomial(const struct ranks *r, real *L, struct sizes *sizes)
{
    int l = 2 * r->n;
    minor(r, 0, 1, 2, L);
    minor(r, 0, 2, 0, L + l + 1);
    minor(r, 0, 0, 1, L + 2 * (l + 1));
    sizes_multiply(&r->sizes[0], &r->sizes[1], sizes);
}

/* A = Wr(eta, S2, W), B = Wr(S1, eta, W), C = Wr(S1, S2, W); columns S1, S2, W, eta. */
static void planes_rational(const struct ranks *r, real *L, struct sizes *sizes)
{
    enum { S1, S2, W, ETA };
    real s2w[LENGTH], ew[LENGTH], es2[LENGTH], s1w[LENGTH], s1e[LENGTH], s1s2[LENGTH];
    struct sizes two;
    int l = 3 * r->n;
    minor(r, 1, S2, W, s2w);
    minor(r, 1, ETA, W, ew);
    minor(r, 1, ETA, S2, es2);
    minor(r, 1, S1, W, s1w);
    minor(r, 1, S1, ETA, s1e);
    minor(r, 1, S1, S2, s1s2);
    add_wronskian(r, ETA, s2w, S2, ew, W, es2, L);
    add_wronskian(r, S1, ew, ETA, s1w, W, s1e, L + l + 1);
    add_wronskian(r, S1, s2w, S2, s1w, W, s1s2, L + 2 * (l + 1));
    sizes_multiply(&r->sizes[0], &r->sizes[1], &two);
    sizes_multiply(&two, &r->sizes[2], sizes);
}

/* M = det(w, w', w'') of a polynomial family. */
static void torsion_polynomial(const struct ranks *r, real *M, struct sizes *sizes)
{
    real yz[LENGTH], xz[LENGTH], xy[LENGTH];
    struct sizes two;
    minor(r, 1, 1, 2, yz);
    minor(r, 1, 0, 2, xz);
    minor(r, 1, 0, 1, xy);
    add_wronskian(r, 0, yz, 1, xz, 2, xy, M);
    sizes_multiply(&r->sizes[0], &r->sizes[1], &two);
    sizes_multiply(&two, &r->sizes[2], sizes);
}

/* M = Wr(W, eta, S1, S2) by the minors of ranks 0, 1 and of ranks 2, 3; columns S1, S2, W, eta. */
static void torsion_rational(const struct ranks *r, real *M, struct sizes *sizes)
{
    static const int pairs[6][5] = {/* columns of either minor, in the order W, eta, S1, S2, and the sign */
                                    {2, 3, 0, 1, 1}, {2, 0, 3, 1, -1}, {2, 1, 3, 0, 1},
                                    {3, 0, 2, 1, 1}, {3, 1, 2, 0, -1}, {0, 1, 2, 3, 1}};
    struct sizes two, four;
    real upper[LENGTH], lower[LENGTH];
    form_clear(4 * r->n, M);
    for (int k = 0; k < 6; k++) {
        minor(r, 0, pairs[k][0], pairs[k][1], upper);
        minor(r, 2, pairs[k][2], pairs[k][3], lower);
        form_add_product(2 * r->n, upper, 2 * r->n, lower, pairs[k][4], M);
    }
    sizes_multiply(&r->sizes[0], &r->sizes[1], &two);
    sizes_multiply(&r->sizes[2], &r->sizes[3], &four);
    sizes_multiply(&two, &four, sizes);
}

/* Takes the common factors of the components out of L, and writes L unscaled. */
static void planes_finish(const real *pascal, const struct sizes *sizes, int l, struct span_forms *f)
{
    real *bound = f->L + 3 * (l + 1);
    int lo, hi;
    sizes_bound(sizes, bound);
    count_zeros(l, 3, f->L, bound, &lo, &hi);
    f->bare_start = lo > 0;
    f->bare_end = hi > 0;
    if (lo > l) {
        lo = hi = 0;
    }
    f->fixed = true;
    for (int i = lo; i <= l - hi && f->fixed; i++) {
        f->fixed = is_zero(l, 2, f->L, bound, i);
    }
    f->l = shift(l, 4, f->L, lo, hi);
    for (int k = 0; k < 4; k++) {
        form_unscale(f->l, pascal, f->L + k * (f->l + 1), f->L + k * (f->l + 1));
    }
}

/* Takes the factors of t and 1 - t out of M, and writes it unscaled. */
static void torsion_finish(const real *pascal, const struct sizes *sizes, int m, struct span_forms *f)
{
    real *bound = f->M + m + 1;
    int lo, hi;
    sizes_bound(sizes, bound);
    count_zeros(m, 1, f->M, bound, &lo, &hi);
    f->m = -1;
    if (lo > m) {
        return;
    }
    f->m = shift(m, 2, f->M, lo, hi);
    form_unscale(f->m, pascal, f->M, f->M);
    bound = f->M + f->m + 1;
    form_unscale(f->m, pascal, bound, bound);
    for (int i = 0; i <= f->m; i++) {
        bound[i] = bound[i] * REAL_EPSILON;
    }
}

/* bound NULL: coefficients that are 0 are exactly so. */
static void envelope_finish(const real *pascal, const real *bound, struct span_forms *f)
{
    int lo, hi;
    count_zeros(f->e, 3, f->w, bound, &lo, &hi);
    f->still = lo > f->e;
    if (f->still) {
        lo = hi = 0;
    }
    f->bare_start = f->bare_start || lo > 0;
    f->bare_end = f->bare_end || hi > 0;
    f->e = shift(f->e, 3, f->w, lo, hi);
    for (int k = 0; k < 3; k++) {
        form_unscale(f->e, pascal, f->w + k * (f->e + 1), f->w + k * (f->e + 1));
    }
}

static void make_polynomial(const struct span_input *s, const real *pascal, struct span_forms *f)
{
    struct ranks r;
    struct sizes sizes;
    real noise[COEFFICIENTS];
    envelope_polynomial(s, pascal, f);
    f->bare_start = f->bare_end = false;
    envelope_finish(pascal, NULL, f);
    bool start = f->bare_start, end = f->bare_end;
    const real *w[3] = {f->w, f->w + f->e + 1, f->w + 2 * (f->e + 1)};
    real most = 0;
    for (int i = 0; i <= s->n; i++) {
        most = real_max(most, real_abs(s->s1[i]) + real_abs(s->s2[i]) + real_abs(s->eta[i]));
    }
    for (int i = 0; i <= f->e; i++) {
        noise[i] = 8 * s->n * most;
    }
    if (f->e < 1) { /* a constant w: the envelope is a point, its tangents do not exist */
        f->l = 0;
        for (int k = 0; k < 4; k++) {
            f->L[k] = 0;
        }
        f->m = -1;
        f->fixed = true;
        return;
    }
    ranks_make(f->e, 2, 3, w, noise, pascal, &r);
    planes_polynomial(&r, f->L, &sizes);
    planes_finish(pascal, &sizes, 2 * (f->e - 1), f);
    f->bare_start = f->bare_start || start;
    f->bare_end = f->bare_end || end;
    f->m = -1;
    if (f->e >= 2) {
        ranks_make(f->e, 3, 3, w, noise, pascal, &r);
        torsion_polynomial(&r, f->M, &sizes);
        torsion_finish(pascal, &sizes, 3 * (f->e - 2), f);
    }
}

static void make_rational(const struct span_input *s, const real *pascal, struct span_forms *f)
{
    struct ranks r;
    struct sizes sizes;
    real noise[COEFFICIENTS], bound[LENGTH];
    const real *column[4] = {s->s1, s->s2, s->wt, s->eta};
    for (int i = 0; i <= s->n; i++) {
        noise[i] = 0;
        for (int k = 0; k < 4; k++) {
            noise[i] += 4 * s->n * real_abs(column[k][i]);
        }
    }
    ranks_make(s->n, 2, 4, column, noise, pascal, &r);
    f->e = 2 * s->n - 2;
    envelope_rational(&r, f->w);
    sizes_multiply(&r.sizes[0], &r.sizes[1], &sizes);
    f->bare_start = f->bare_end = false;
    sizes_bound(&sizes, bound);
    envelope_finish(pascal, bound, f);
    bool start = f->bare_start, end = f->bare_end;
    ranks_make(s->n, 3, 4, column, noise, pascal, &r);
    planes_rational(&r, f->L, &sizes);
    planes_finish(pascal, &sizes, 3 * s->n - 6, f);
    f->bare_start = f->bare_start || start;
    f->bare_end = f->bare_end || end;
    f->m = -1;
    if (s->n >= 3) {
        ranks_make(s->n, 4, 4, column, noise, pascal, &r);
        torsion_rational(&r, f->M, &sizes);
        torsion_finish(pascal, &sizes, 4 * s->n - 12, f);
    }
}

void span_forms_make(const struct span_input *s, const real *pascal, struct span_forms *f)
{
    if (s->wt) {
        make_rational(s, pascal, f);
    } else {
        make_polynomial(s, pascal, f);
    }
}
