/* The sign of det(F', F'') along a curve, proved by the signs of Bernstein coefficients; independent of the
 * methods: from the moved control points themselves. */
#ifndef FATLINE_REGION_PROOF_H
#define FATLINE_REGION_PROOF_H

#include "../algorithms/core/bernstein.h"
#include "../algorithms/core/spline.h"
#include "../algorithms/region.h"

enum { PROOF_POINTS = 64, PROOF_FORM = 3 * 33, PROOF_DEPTH = 40 };

/* A form and one that bounds the sizes of what was added up to it. */
struct proof_form {
    int n;
    real c[PROOF_FORM], size[PROOF_FORM];
};

static inline struct proof_form proof_derivative(const struct proof_form *a)
{
    struct proof_form d;
    d.n = a->n - 1;
    bernstein_derivative(a->n, a->c, d.c);
    for (int i = 0; i < a->n; i++)
        d.size[i] = a->n * (a->size[i] + a->size[i + 1]);
    return d;
}

static inline struct proof_form proof_product(const struct proof_form *a, const struct proof_form *b)
{
    struct proof_form p;
    p.n = a->n + b->n;
    bernstein_multiply(a->n, a->c, b->n, b->c, p.c);
    bernstein_multiply(a->n, a->size, b->n, b->size, p.size);
    return p;
}

/* a b - c d, both of the same degree. */
static inline struct proof_form proof_minor(const struct proof_form *a, const struct proof_form *b,
                                            const struct proof_form *c, const struct proof_form *d)
{
    struct proof_form p = proof_product(a, b), q = proof_product(c, d);
    for (int i = 0; i <= p.n; i++) {
        p.c[i] -= q.c[i];
        p.size[i] += q.size[i];
    }
    return p;
}

/* Adds to *sum the form a, raised to the degree of *sum. */
static inline void proof_add(struct proof_form *sum, const struct proof_form *a)
{
    real c[PROOF_FORM], size[PROOF_FORM];
    bernstein_elevate(a->n, a->c, sum->n - a->n, c);
    bernstein_elevate(a->n, a->size, sum->n - a->n, size);
    for (int i = 0; i <= sum->n; i++) {
        sum->c[i] += c[i];
        sum->size[i] += size[i];
    }
}

/* W^3 det(F', F'') = W (X'Y'' - X''Y') + X (Y'W'' - Y''W') + Y (W'X'' - W''X'), of degree 3n - 3. */
static inline struct proof_form proof_turning(const struct proof_form *h)
{
    struct proof_form first[3], second[3], sum;
    for (int i = 0; i < 3; i++) {
        first[i] = proof_derivative(&h[i]);
        second[i] = proof_derivative(&first[i]);
    }
    sum.n = 3 * h[0].n - 3;
    for (int i = 0; i <= sum.n; i++)
        sum.c[i] = sum.size[i] = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        struct proof_form minor = proof_minor(&first[j], &second[k], &second[j], &first[k]);
        struct proof_form term = proof_product(&h[i], &minor);
        proof_add(&sum, &term);
    }
    return sum;
}

/* 1: sign * form > 0 on [0, 1]; -1: sign * form < 0 somewhere; 0: neither is proved. */
static inline int proof_sign(const struct proof_form *f, int sign)
{
    struct {
        real c[PROOF_FORM];
        int depth;
    } stack[PROOF_DEPTH + 2];
    real bound = 0;
    int waiting = 1, all = 1;
    for (int i = 0; i <= f->n; i++) {
        stack[0].c[i] = sign * f->c[i];
        bound = real_max(bound, 16 * f->n * REAL_EPSILON * f->size[i]);
    }
    stack[0].depth = 0;
    while (waiting > 0) {
        real *c = stack[waiting - 1].c, half[PROOF_FORM], low = c[0];
        if (c[0] < -bound || c[f->n] < -bound)
            return -1;
        for (int i = 1; i <= f->n; i++)
            low = real_min(low, c[i]);
        if (low > bound) {
            waiting--;
            continue;
        }
        if (stack[waiting - 1].depth == PROOF_DEPTH) {
            all = 0;
            waiting--;
            continue;
        }
        int depth = ++stack[waiting - 1].depth;
        for (int i = 0; i <= f->n; i++)
            half[i] = c[i];
        bernstein_halve(f->n, 1, half, c, stack[waiting].c);
        stack[waiting++].depth = depth;
    }
    return all;
}

/* Of the curve with its handle at d, on the whole interval: as proof_sign.  Positive curvature is regular. */
static inline int proof_of_curve(const struct region_problem *p, struct point d)
{
    const struct control_family *f = &p->family;
    real points[3 * PROOF_POINTS];
    struct spline s = {f->degree, f->count, 3, points, f->knots};
    int all = 1;
    for (int j = 0; j < f->count; j++) {
        real w = f->weight ? f->weight[j] : (real)1;
        points[j] = w * (f->x[j] - f->x[0] + f->share[j] * (d.x - f->at.x));
        points[f->count + j] = w * (f->y[j] - f->y[0] + f->share[j] * (d.y - f->at.y));
        points[2 * f->count + j] = w;
    }
    for (int i = 0; i < spline_pieces(&s); i++) {
        struct spline_piece piece;
        struct proof_form h[3];
        spline_piece(&s, i, &piece);
        real lo = real_max(piece.lo, p->interval.lo), hi = real_min(piece.hi, p->interval.hi);
        if (!(lo < hi))
            continue;
        for (int c = 0; c < 3; c++) {
            h[c].n = f->degree;
            bernstein_restrict(f->degree, 1, piece.coefficients + c * (f->degree + 1),
                               (lo - piece.lo) / (piece.hi - piece.lo),
                               (hi - piece.lo) / (piece.hi - piece.lo), h[c].c);
            for (int k = 0; k <= f->degree; k++)
                h[c].size[k] = real_abs(h[c].c[k]);
        }
        struct proof_form turning = proof_turning(h);
        int sign = proof_sign(&turning, p->sign);
        if (sign < 0)
            return -1;
        all = all && sign;
    }
    return all;
}

#endif
