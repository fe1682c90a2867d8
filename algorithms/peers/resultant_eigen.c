/* The resultant as a matrix polynomial, its roots as generalised eigenvalues (LAPACK), polished by Newton's
 * method.
 *
 * The Bezout matrix M(v) = sum of M_q B(q,e)(v) of the curve a of lower degree d along b is linearised in the
 * Bernstein basis itself: with x_q = C(e-1,q) (1-v)^(e-1-q) v^q y, M(v) y = 0 becomes
 *     C(e-1,q+1) v x_q = C(e-1,q) (1-v) x_{q+1},  (1-v) sum over q < e of e/(e-q) M_q x_q + v M_e x_{e-1} =
 * 0, a pencil in v : 1 - v, so that both ends of [0, 1] are treated alike and no monomials of v appear (G.
 * Jonsson, S. Vavasis, Solving polynomials with small leading coefficients, 2004).
 *
 * Filters.  An eigenvalue of multiplicity k moves by (K u)^(1/k) under a backward error u, in any direction
 * of the complex plane, so true real parameters are found with imaginary parts and outside [0, 1].  With a
 * growth K <= 2^20 this is 2^-16 for k = 2, 2^-11 for k = 3 and 2^-8 for k = 4: what lies farther off is
 * dropped.  What stays is a start for Newton's method, whose end must satisfy f(t) = g(s) to rounding: a
 * filter too wide costs time, not truth. Nothing here proves that no solution is missing. */
#include <lapacke.h>
#include <stdlib.h>

#include "../bezier.h"
#include "../core/bernstein.h"
#include "../core/implicit.h"
#include "../core/lowered.h"
#include "../core/roots.h"
#include "../crossings.h"

static const double REACH = 0x1p-8;

struct eigen {
    const struct problem *problem;
    struct crossings *out;
    const struct lowered *a, *b;
    bool a_is_f;
    int d, e;
    double *scratch;
};

/* A zero (t, s) with the length of Newton's last step. */
struct point {
    double t, s, step;
};

/* ---- the pencil ---- */

/* q = (1-v : v) coefficient matrices p, q of order d e, columns first: (1-v) p x + v q x = 0. */
static void fill_pencil(const struct eigen *z, const double *m, double *p, double *q)
{
    const int d = z->d, e = z->e, n = d * e;
    for (int i = 0; i < n * n; i++) {
        p[i] = q[i] = 0;
    }
    for (int k = 0; k + 1 < e; k++) {
        for (int i = 0; i < d; i++) {
            int row = k * d + i;
            q[row + row * n] = binomial(e - 1, k + 1);
            p[row + (row + d) * n] = -binomial(e - 1, k);
        }
    }
    for (int i = 0; i < d; i++) {
        for (int j = 0; j < d; j++) {
            const double *entry = m + (i < j ? i * d + j : j * d + i) * 2 * (e + 1);
            int row = (e - 1) * d + i;
            for (int k = 0; k < e; k++) { /* entries carry C(e,k) = e/(e-k) C(e-1,k) */
                p[row + (k * d + j) * n] += entry[k] / binomial(e - 1, k);
            }
            q[row + ((e - 1) * d + j) * n] += entry[e];
        }
    }
}

/* ---- from eigenvalues to starts ---- */

/* u from the block of the eigenvector where x_q is largest, by the ratio of implicit.h's null vector. */
static double start_from_vector(const struct eigen *z, const double *x)
{
    const int d = z->d;
    double most = 0, top = 0, bottom = 0;
    int best = 0;
    for (int i = 0; i < d * z->e; i++) {
        if (fabs(x[i]) > most) {
            most = fabs(x[i]);
            best = i / d;
        }
    }
    for (int k = 0; k < d; k++) {
        double y = x[best * d + k];
        bottom += binomial(d - 1, k) * y;
        top += k > 0 ? binomial(d - 2, k - 1) * y : 0;
    }
    return top / bottom;
}

struct jet {
    double value[3], slope[3];
};

static struct jet jet_at(const struct curve *c, double t)
{
    struct jet j = {{0, 0, 1}, {0, 0, 0}};
    const double *p[3] = {c->x, c->y, c->w};
    double scratch[POINTS_MAX];
    for (int k = 0; k < (c->w ? 3 : 2); k++) {
        j.value[k] = bernstein_value_slope(c->degree, p[k], t, scratch, &j.slope[k]);
    }
    return j;
}

/* Starts for u at the parameter v: where a crosses the line through b(v) along b, to within REACH; at a
 * double point of a, one eigenvalue has several, and an eigenvector is any mixture. */
static int starts_from_line(const struct eigen *z, double v, double u[POINTS_MAX])
{
    const struct curve *a = z->a_is_f ? &z->problem->f : &z->problem->g;
    const struct curve *b = z->a_is_f ? &z->problem->g : &z->problem->f;
    struct jet j = jet_at(b, v);
    double x = j.value[0] / j.value[2], y = j.value[1] / j.value[2], c[POINTS_MAX], error[POINTS_MAX],
           size = 0;
    double nx = -(j.slope[1] - y * j.slope[2]), ny = j.slope[0] - x * j.slope[2];
    struct root root[POINTS_MAX];
    for (int i = 0; i <= a->degree; i++) {
        double w = a->w ? a->w[i] : 1;
        c[i] = nx * (a->x[i] - w * x) + ny * (a->y[i] - w * y);
        size = fmax(size, fabs(c[i]));
    }
    for (int i = 0; i <= a->degree; i++) {
        error[i] = size * REACH * REACH * REACH;
    }
    int count = roots_find(a->degree, c, error, REACH, z->scratch, POINTS_MAX, root);
    for (int i = 0; i < count; i++) {
        u[i] = (root[i].lo + root[i].hi) / 2;
    }
    return count;
}

/* ---- Newton's method ---- */

/* f - g at p, homogeneous, in `r`; Newton's step, or where the Jacobian is singular the shortest step that
 * lowers |f - g|.  Returns max |f - g|, in Euclidean coordinates. */
static double newton_step(const struct problem *q, const struct point *p, double step[2])
{
    struct jet f = jet_at(&q->f, p->t), g = jet_at(&q->g, p->s);
    double r[2], t[2], s[2], size = 0;
    for (int k = 0; k < 2; k++) {
        r[k] = f.value[k] * g.value[2] - g.value[k] * f.value[2];
        t[k] = f.slope[k] * g.value[2] - g.value[k] * f.slope[2];
        s[k] = f.value[k] * g.slope[2] - g.slope[k] * f.value[2];
        size += t[k] * t[k] + s[k] * s[k];
    }
    double det = t[0] * s[1] - t[1] * s[0];
    step[0] = det != 0 ? -(r[0] * s[1] - r[1] * s[0]) / det : -(t[0] * r[0] + t[1] * r[1]) / size;
    step[1] = det != 0 ? -(t[0] * r[1] - t[1] * r[0]) / det : -(s[0] * r[0] + s[1] * r[1]) / size;
    return fmax(fabs(r[0]), fabs(r[1])) / fabs(f.value[2] * g.value[2]);
}

/* From p to the point of least |f - g| on the way of Newton's method, damped while it would grow; is it a
 * zero, to rounding?  p->step: the step from there.  At a double zero steps halve, until rounding sends them
 * anywhere. */
static bool polish(const struct problem *q, struct point *p)
{
    double step[2], next[2], least = newton_step(q, p, step);
    for (int round = 0; round < 100; round++) {
        p->step = fabs(step[0]) + fabs(step[1]);
        if (!(p->step > 2 * REAL_EPSILON) || least == 0) {
            break;
        }
        double scale = p->step < 0.25 ? 1 : 0.25 / p->step;
        struct point here = {p->t + scale * step[0], p->s + scale * step[1], p->step};
        double residual = newton_step(q, &here, next);
        for (int halved = 0; !(residual < least) && halved < 4; halved++) {
            scale *= 0.25;
            here.t = p->t + scale * step[0];
            here.s = p->s + scale * step[1];
            residual = newton_step(q, &here, next);
        }
        if (!(residual < least)) {
            break;
        }
        least = residual;
        *p = here;
        step[0] = next[0];
        step[1] = next[1];
    }
    int n = q->f.degree > q->g.degree ? q->f.degree : q->g.degree;
    return least <= 16 * n * REAL_EPSILON * q->bounds.scale;
}

/* Adds p unless it lies outside by more than the tolerance, or is on record already. */
static void add_point(const struct eigen *z, const struct point *p)
{
    const struct bounds *b = &z->problem->bounds;
    double t = fmin(fmax(p->t, 0), 1), s = fmin(fmax(p->s, 0), 1);
    if (fabs(t - p->t) > b->tolerance_t || fabs(s - p->s) > b->tolerance_s) {
        return;
    }
    for (int i = 0; i < z->out->count; i++) {
        const struct crossing *c = &z->out->at[i];
        double rt = fmax(b->tolerance_t, 8 * p->step), rs = fmax(b->tolerance_s, 8 * p->step);
        if (c->t.lo - rt <= t && t <= c->t.hi + rt && c->s.lo - rs <= s && s <= c->s.hi + rs) {
            return;
        }
    }
    double rt = fmin(b->tolerance_t / 2, p->step + 4 * REAL_EPSILON);
    double rs = fmin(b->tolerance_s / 2, p->step + 4 * REAL_EPSILON);
    struct crossing c = {
        {fmax(t - rt, 0), fmin(t + rt, 1)}, {fmax(s - rs, 0), fmin(s + rs, 1)}, CANDIDATE, 0, 0};
    crossings_add(z->out, &c);
}

static void try_start(const struct eigen *z, double u, double v)
{
    struct point p = {z->a_is_f ? u : v, z->a_is_f ? v : u, 0};
    if (u >= -REACH && u <= 1 + REACH && polish(z->problem, &p)) {
        add_point(z, &p);
    }
}

/* ---- the algorithm ---- */

static void solve_eigenvalue(const struct eigen *z, double re, double im, double beta, const double *x)
{
    /* (1-v) : v = beta : (re + i im); the size of the pair is arbitrary */
    double sum = re + beta, square = sum * sum + im * im;
    double v = (re * sum + im * im) / square, imaginary = im * beta / square, u[POINTS_MAX];
    if (!(fabs(imaginary) <= REACH && v >= -REACH && v <= 1 + REACH)) {
        return;
    }
    v = fmin(fmax(v, 0), 1);
    if (z->d > 1 && im == 0) {
        try_start(z, start_from_vector(z, x), v);
    }
    int count = starts_from_line(z, v, u);
    for (int i = 0; i < count; i++) {
        try_start(z, u[i], v);
    }
}

static enum outcome solve_pencil(const struct eigen *z, double *memory)
{
    const int n = z->d * z->e;
    double *p = memory, *q = p + n * n, *x = q + n * n, *re = x + n * n, *im = re + n, *beta = im + n,
           *m = beta + n;
    implicit_matrix(&z->a->polygon, &z->b->polygon, m);
    fill_pencil(z, m, p, q);
    for (int i = 0; i < n * n; i++) {
        q[i] = -q[i];
    }
    if (LAPACKE_dggev(LAPACK_COL_MAJOR, 'N', 'V', n, p, n, q, n, re, im, beta, NULL, n, x, n)) {
        return UNSUPPORTED;
    }
    for (int i = 0; i < n; i++) {
        solve_eigenvalue(z, re[i], im[i], beta[i], x + i * n);
    }
    return SOLVED;
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    struct lowered side[2];
    const struct arc f = {p->f.degree, p->f.x, p->f.y, p->f.w, 0},
                     g = {p->g.degree, p->g.x, p->g.y, p->g.w, 0};
    lowered_init(&f, p->bounds.scale, &side[0]);
    lowered_init(&g, p->bounds.scale, &side[1]);
    bool a_is_f = side[0].polygon.degree <= side[1].polygon.degree;
    struct eigen z = {p, out, &side[!a_is_f], &side[a_is_f], a_is_f, 0, 0, w->scratch};
    z.d = z.a->polygon.degree;
    z.e = z.b->polygon.degree;
    const size_t n = (size_t)z.d * z.e;
    if (z.d > implicit_degree_max()) {
        return UNSUPPORTED;
    }
    double *error = z.scratch + n + 1;
    implicit_resultant(&z.a->polygon, &z.b->polygon, error + n + 1, z.scratch, error);
    if (implicit_vanishes((int)n, z.scratch, error)) {
        return UNSUPPORTED; /* a singular pencil: any number is an eigenvalue */
    }
    double *memory =
        (double *)malloc((3 * n * n + 3 * n + n * z.d * 2 + 2 * (size_t)z.d * z.d) * sizeof(double));
    if (!memory) {
        return UNSUPPORTED;
    }
    enum outcome outcome = solve_pencil(&z, memory);
    free(memory);
    return outcome;
}

static size_t scratch(int n, int m)
{
    int d = n < m ? n : m, e = n < m ? m : n;
    size_t resultant = implicit_scratch(d < implicit_degree_max() ? d : implicit_degree_max(), e);
    return 2 * ((size_t)(n * m) + 1) + resultant + roots_scratch(e);
}

const struct intersector resultant_eigen = {
    "resultant_eigen",
    "eigenvalues of the Bezout matrix polynomial (LAPACK), Newton; points without proof",
    "D. Manocha, J. Demmel: Algorithms for intersecting parametric and algebraic curves I, 1994",
    {0, 0, 0, 0},
    intersect,
    scratch,
    true,
    true};
