#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "problem.h"
#include "number.h"
#include "../run/memory.h"

/* The nearest real; *fits becomes false if it is none, or too small for a relative error of REAL_EPSILON / 2.
 */
static real nearest(const mpq_t q, bool *fits)
{
    real a = real_from_rational(q);

    if (!real_is_finite(a)) {
        *fits = false;
    } else if (real_abs(a) < REAL_LEAST) {
        mpq_t back;
        mpq_init(back);
        real_to_rational(a, back);
        *fits = *fits && mpq_equal(back, q);
        mpq_clear(back);
    }
    return a;
}

/* c into coefficients at `memory`, of which it takes 2 (degree + 1), or 3 (degree + 1) if c is rational.
 * w X is formed exactly and rounded once. */
static const char *curve_make(const struct case_curve *c, real *memory, struct curve *out)
{
    int length = c->degree + 1;
    real *x = memory, *y = x + length, *w = y + length;
    bool fits = true;
    mpq_t product;

    mpq_init(product);
    for (int i = 0; i < length; i++) {
        if (c->rational) {
            w[i] = nearest(c->w[i], &fits);
            mpq_mul(product, c->w[i], c->x[i]);
            x[i] = nearest(product, &fits);
            mpq_mul(product, c->w[i], c->y[i]);
            y[i] = nearest(product, &fits);
            fits = fits && w[i] > 0;
        } else {
            x[i] = nearest(c->x[i], &fits);
            y[i] = nearest(c->y[i], &fits);
        }
    }
    mpq_clear(product);
    out->degree = c->degree;
    out->x = x;
    out->y = y;
    out->w = c->rational ? w : NULL;
    out->domain.lo = real_from_rational(c->lo);
    out->domain.hi = real_from_rational(c->hi);
    if (!fits)
        return "coordinates: beyond the range of this precision, expected finite numbers and positive "
               "weights";
    if (!real_is_finite(out->domain.lo) || !real_is_finite(out->domain.hi) ||
        !(out->domain.lo < out->domain.hi))
        return "domain: empty in this precision, expected [lo, hi] with lo < hi";
    return NULL;
}

static size_t coefficients(const struct case_curve *c)
{
    return (size_t)(c->rational ? 3 : 2) * (size_t)(c->degree + 1);
}

/* The first three digits of (t - lo) / (hi - lo). */
static real first_digits(const mpq_t t, const struct case_curve *c)
{
    mpq_t u, width;
    double digits;

    mpq_inits(u, width, NULL);
    mpq_sub(u, t, c->lo);
    mpq_sub(width, c->hi, c->lo);
    mpq_div(u, u, width);
    digits = floor(1000 * mpq_get_d(u) + 0.5);
    mpq_clears(u, width, NULL);
    return (real)(int)digits / 1000;
}

static void tell_roots(const struct test_case *c, struct owned_problem *p)
{
    if (!c->expected.known || !c->expected.count)
        return;
    p->known = (struct known *)memory_resized(NULL, (size_t)c->expected.count * sizeof *p->known);
    for (int i = 0; i < c->expected.count; i++) {
        p->known[i].t = first_digits(c->expected.at[i].t, &c->f);
        p->known[i].s = first_digits(c->expected.at[i].s, &c->g);
    }
    p->problem.known = p->known;
    p->problem.known_count = c->expected.count;
}

const char *owned_problem_make(const struct test_case *c, real tolerance, int max_steps,
                               struct owned_problem *p)
{
    const char *wrong;

    memset(&p->problem, 0, sizeof p->problem);
    p->memory = NULL;
    p->known = NULL;
    if (c->f.degree < 1 || c->f.degree > DEGREE_MAX)
        return "f.degree: out of range, expected 1 to 32";
    if (c->g.degree < 1 || c->g.degree > DEGREE_MAX)
        return "g.degree: out of range, expected 1 to 32";
    p->memory = (real *)memory_resized(NULL, (coefficients(&c->f) + coefficients(&c->g)) * sizeof(real));
    wrong = curve_make(&c->f, p->memory, &p->problem.f);
    if (!wrong)
        wrong = curve_make(&c->g, p->memory + coefficients(&c->f), &p->problem.g);
    if (wrong)
        owned_problem_clear(p);
    if (!wrong)
        tell_roots(c, p);
    p->problem.tolerance = tolerance;
    p->problem.max_steps = max_steps;
    return wrong;
}

void owned_problem_clear(struct owned_problem *p)
{
    free(p->memory);
    free(p->known);
    p->memory = NULL;
    p->known = NULL;
}

void workspace_make(struct workspace *w, const struct intersector *const *a, int n, int m, int room)
{
    size_t scratch = 0;

    for (; a && *a; a++) {
        if ((*a)->scratch) {
            /* problem_solve may exchange the curves */
            size_t nm = (*a)->scratch(n, m), mn = (*a)->scratch(m, n);
            scratch = nm > scratch ? nm : scratch;
            scratch = mn > scratch ? mn : scratch;
        }
    }
    workspace_init(w, memory_resized(NULL, workspace_size(n, m, room, scratch)), n, m, room, scratch);
}

/* The block begins with the cells. */
void workspace_clear(struct workspace *w)
{
    free(w->cell);
    w->cell = NULL;
}

struct workspace *workspace_fit(struct fitted_workspace *f, const struct intersector *const *a, int n, int m,
                                int room)
{
    if (n > f->n || m > f->m) {
        fitted_workspace_clear(f);
        f->n = n > f->n ? n : f->n;
        f->m = m > f->m ? m : f->m;
        workspace_make(&f->workspace, a, f->n, f->m, room);
    }
    return &f->workspace;
}

void fitted_workspace_clear(struct fitted_workspace *f)
{
    if (f->n > 0)
        workspace_clear(&f->workspace);
}
