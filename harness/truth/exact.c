/* The true answer: a pair of curves as integer polynomials, and which of the two roads it takes. */
#include "exact.h"

#include <stdlib.h>
#include "exact_answer.h"

/* ---- from control points to integer polynomials ---- */

static void lcm_of_denominators(fmpz_t l, mpq_t *v, int n)
{
    fmpz_t d;
    fmpz_init(d);
    for (int i = 0; i <= n; i++) {
        fmpz_set_mpz(d, mpq_denref(v[i]));
        fmpz_lcm(l, l, d);
    }
    fmpz_clear(d);
}

/* Bernstein to power basis, in place: c_k = C(n, k) times the k-th forward difference. */
static void to_power_basis(fmpz_poly_t p, fmpz *b, int n)
{
    fmpz_t c;
    fmpz_init(c);
    fmpz_poly_zero(p);
    for (int k = 0; k <= n; k++) {
        fmpz_bin_uiui(c, (ulong)n, (ulong)k);
        fmpz_mul(c, c, b);
        fmpz_poly_set_coeff_fmpz(p, k, c);
        for (int i = 0; i < n - k; i++)
            fmpz_sub(b + i, b + i + 1, b + i);
    }
    fmpz_clear(c);
}

/* p: the sum of w_i x_i times the scales, as a polynomial; x NULL: 1; w NULL: 1. */
static void coordinate(fmpz_poly_t p, int n, mpq_t *x, const fmpz_t x_scale, mpq_t *w, const fmpz_t w_scale)
{
    fmpq_t v, u;
    fmpz *b = _fmpz_vec_init(n + 1);
    fmpq_init(v);
    fmpq_init(u);
    for (int i = 0; i <= n; i++) {
        fmpq_one(v);
        if (x) {
            fmpq_set_mpq(u, x[i]);
            fmpq_mul(v, v, u);
            fmpq_mul_fmpz(v, v, x_scale);
        }
        if (w) {
            fmpq_set_mpq(u, w[i]);
            fmpq_mul(v, v, u);
            fmpq_mul_fmpz(v, v, w_scale);
        }
        fmpz_set(b + i, fmpq_numref(v)); /* the scales make it an integer */
    }
    to_power_basis(p, b, n);
    _fmpz_vec_clear(b, n + 1);
    fmpq_clear(v);
    fmpq_clear(u);
}

/* a' b - a b'. */
static void cross_derivative(fmpz_poly_t r, const fmpz_poly_t a, const fmpz_poly_t b)
{
    fmpz_poly_t u;
    fmpz_poly_init(u);
    fmpz_poly_derivative(u, b);
    fmpz_poly_mul(u, u, a);
    fmpz_poly_derivative(r, a);
    fmpz_poly_mul(r, r, b);
    fmpz_poly_sub(r, r, u);
    fmpz_poly_clear(u);
}

static void curve_set(struct exact_curve *e, const struct case_curve *c, fmpz_t const scale[2])
{
    fmpz_t weights;
    fmpz_poly_t g, u;
    fmpz_poly_struct *part[3] = {e->x, e->y, e->w};
    fmpz_init_set_ui(weights, 1);
    fmpz_poly_init(g);
    fmpz_poly_init(u);
    mpq_t *w = c->rational ? c->w : NULL;
    if (w)
        lcm_of_denominators(weights, w, c->degree);
    coordinate(e->x, c->degree, c->x, scale[0], w, weights);
    coordinate(e->y, c->degree, c->y, scale[1], w, weights);
    coordinate(e->w, c->degree, NULL, NULL, w, weights);
    fmpz_poly_gcd(g, e->x, e->w);
    fmpz_poly_gcd(g, g, e->y);
    e->n = 0;
    for (int i = 0; i < 3; i++) {
        fmpz_poly_div(part[i], part[i], g);
        e->n = fmpz_poly_degree(part[i]) > e->n ? (int)fmpz_poly_degree(part[i]) : e->n;
    }
    cross_derivative(g, e->x, e->w);
    cross_derivative(u, e->y, e->w);
    fmpz_poly_gcd(e->stationary, g, u);
    fmpz_clear(weights);
    fmpz_poly_clear(g);
    fmpz_poly_clear(u);
}

static void curve_init(struct exact_curve *e)
{
    fmpz_poly_init(e->x);
    fmpz_poly_init(e->y);
    fmpz_poly_init(e->w);
    fmpz_poly_init(e->stationary);
}

static void curve_clear(struct exact_curve *e)
{
    fmpz_poly_clear(e->x);
    fmpz_poly_clear(e->y);
    fmpz_poly_clear(e->w);
    fmpz_poly_clear(e->stationary);
}

static void answer_init(struct exact_answer *a, const struct test_case *c, double seconds)
{
    *a = (struct exact_answer){0};
    curve_init(&a->pair.f);
    curve_init(&a->pair.g);
    for (int i = 0; i < 2; i++) {
        fmpz_init_set_ui(a->scale[i], 1);
        lcm_of_denominators(a->scale[i], i ? c->f.y : c->f.x, c->f.degree);
        lcm_of_denominators(a->scale[i], i ? c->g.y : c->g.x, c->g.degree);
    }
    curve_set(&a->pair.f, &c->f, a->scale);
    curve_set(&a->pair.g, &c->g, a->scale);
    a->pair.deadline = seconds > 0 ? exact_clock() + seconds : 0;
}

static void answer_clear(struct exact_answer *a)
{
    curve_clear(&a->pair.f);
    curve_clear(&a->pair.g);
    fmpz_clear(a->scale[0]);
    fmpz_clear(a->scale[1]);
    point_list_clear(&a->points);
    range_list_clear(&a->ranges);
}

/* ---- a curve that is one point ---- */

static void append_range(struct range_list *l, const struct real_root *t0, const struct real_root *t1,
                         const struct real_root *s0, const struct real_root *s1)
{
    l->at = realloc(l->at, (size_t)(l->count + 1) * sizeof *l->at);
    struct exact_range *r = &l->at[l->count++];
    struct real_root *to[4] = {&r->t0, &r->t1, &r->s0, &r->s1};
    const struct real_root *from[4] = {t0, t1, s0, s1};
    for (int i = 0; i < 4; i++) {
        real_root_init(to[i]);
        real_root_set(to[i], from[i]);
    }
}

/* A point on the other curve: every parameter of the point goes with that of the curve, an arc of no length.
 */
static void solve_point(struct exact_answer *a, const struct biv *p, const struct biv *q)
{
    struct real_root zero, one;
    struct biv ps, qs;
    bool f_is_point = a->pair.f.n == 0;
    fmpz_poly_t u, v;
    fmpq_t x;
    fmpz_poly_init(u);
    fmpz_poly_init(v);
    fmpq_init(x);
    real_root_init(&zero);
    real_root_init(&one);
    real_root_set_exact(&zero, x);
    biv_swap_variables(&ps, p);
    biv_swap_variables(&qs, q);
    biv_restrict_t(u, f_is_point ? p : &ps, x);
    biv_restrict_t(v, f_is_point ? q : &qs, x);
    fmpz_poly_gcd(u, u, v);
    fmpq_one(x);
    real_root_set_exact(&one, x);
    if (fmpz_poly_is_zero(u)) {
        append_range(&a->ranges, &zero, &one, &zero, &one);
    } else {
        struct root_list l;
        root_list_find(&l, u);
        for (int i = 0; i < l.count; i++) {
            real_root_refine(&l.at[i], 256, false);
            if (f_is_point)
                append_range(&a->ranges, &zero, &one, &l.at[i], &l.at[i]);
            else
                append_range(&a->ranges, &l.at[i], &l.at[i], &zero, &one);
        }
        root_list_clear(&l);
    }
    fmpz_poly_clear(u);
    fmpz_poly_clear(v);
    fmpq_clear(x);
    real_root_clear(&zero);
    real_root_clear(&one);
    biv_clear(&ps);
    biv_clear(&qs);
}

/* ---- the two roads ---- */

/* Images of irreducible curves meet in finitely many points or are the same: then the resultant is 0. */
static const char *solve_curves(struct exact_answer *a, const struct biv *p, const struct biv *q, int digits)
{
    struct exact_system e = {.p = *p, .q = *q, .pair = &a->pair, .whole = true};
    const char *trouble = exact_system_solve(&e, &a->points);
    if (trouble != EXACT_COMMON_COMPONENT)
        return trouble;
    a->same_carrier = true;
    return exact_overlap_solve(&a->pair, p, q, digits, &a->ranges, &a->points);
}

const char *exact_solve(struct test_case *c, const struct exact_limits *limits)
{
    struct exact_answer a;
    struct biv p, q;
    answer_init(&a, c, limits->seconds);
    const struct exact_curve *f = &a.pair.f, *g = &a.pair.g;
    biv_init(&p, f->n, g->n);
    biv_init(&q, f->n, g->n);
    biv_set_cross(&p, f->x, g->w, f->w, g->x);
    biv_set_cross(&q, f->y, g->w, f->w, g->y);
    a.point_curve = f->n == 0 || g->n == 0;
    const char *trouble = NULL;
    if (a.point_curve)
        solve_point(&a, &p, &q);
    else
        trouble = solve_curves(&a, &p, &q, limits->digits);
    if (!trouble)
        trouble = exact_answer_write(&a, c, limits->digits);
    biv_clear(&p);
    biv_clear(&q);
    answer_clear(&a);
    return trouble;
}
