/* Curves for the tests of the exact truth, as polynomials over the rationals, and what is asserted of
 * answers. After prop.h. */
#ifndef FATLINE_EXACT_CURVES_H
#define FATLINE_EXACT_CURVES_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <flint/fmpq_poly.h>

#include "../harness/cases/case.h"
#include "../harness/truth/exact.h"
#include "../harness/cases/number.h"

/* (x / w, y / w); w is 1 for polynomial curves. */
struct plane_curve {
    fmpq_poly_t x, y, w;
};

static inline void plane_curve_init(struct plane_curve *c)
{
    fmpq_poly_init(c->x);
    fmpq_poly_init(c->y);
    fmpq_poly_init(c->w);
    fmpq_poly_one(c->w);
}

/* Coefficients as FLINT's texts, "3  1 0 -1/2" for 1 - t^2 / 2; w NULL: 1. */
static inline void plane_curve_set(struct plane_curve *c, const char *x, const char *y, const char *w)
{
    plane_curve_init(c);
    int failed =
        fmpq_poly_set_str(c->x, x) | fmpq_poly_set_str(c->y, y) | (w ? fmpq_poly_set_str(c->w, w) : 0);
    if (failed)
        abort();
}

static inline void plane_curve_clear(struct plane_curve *c)
{
    fmpq_poly_clear(c->x);
    fmpq_poly_clear(c->y);
    fmpq_poly_clear(c->w);
}

/* to(t) = from(inner(t)); to may be from. */
static inline void plane_curve_compose(struct plane_curve *to, const struct plane_curve *from,
                                       const char *inner)
{
    fmpq_poly_t p;
    fmpq_poly_init(p);
    if (fmpq_poly_set_str(p, inner))
        abort();
    fmpq_poly_compose(to->x, from->x, p);
    fmpq_poly_compose(to->y, from->y, p);
    fmpq_poly_compose(to->w, from->w, p);
    fmpq_poly_clear(p);
}

/* (x, y) -> (3 x + 2 y - 1, -x + 5/2 y + 7). */
static inline void plane_curve_map(struct plane_curve *c)
{
    fmpq_poly_t x, u;
    fmpq_poly_init(x);
    fmpq_poly_init(u);
    fmpq_poly_scalar_mul_si(x, c->x, 3);
    fmpq_poly_scalar_mul_si(u, c->y, 2);
    fmpq_poly_add(x, x, u);
    fmpq_poly_sub(x, x, c->w);
    fmpq_poly_scalar_mul_si(c->y, c->y, 5);
    fmpq_poly_scalar_div_si(c->y, c->y, 2);
    fmpq_poly_sub(c->y, c->y, c->x);
    fmpq_poly_scalar_mul_si(u, c->w, 7);
    fmpq_poly_add(c->y, c->y, u);
    fmpq_poly_set(c->x, x);
    fmpq_poly_clear(x);
    fmpq_poly_clear(u);
}

static inline int plane_curve_degree(const struct plane_curve *c)
{
    slong n = 1;
    n = fmpq_poly_degree(c->x) > n ? fmpq_poly_degree(c->x) : n;
    n = fmpq_poly_degree(c->y) > n ? fmpq_poly_degree(c->y) : n;
    n = fmpq_poly_degree(c->w) > n ? fmpq_poly_degree(c->w) : n;
    return (int)n;
}

/* The i-th Bernstein coefficient of degree n: sum over k of C(i, k) / C(n, k) p_k. */
static inline void bernstein_coefficient(fmpq_t b, const fmpq_poly_t p, int n, int i)
{
    fmpq_t c, r;
    fmpz_t u, v;
    fmpq_init(c);
    fmpq_init(r);
    fmpz_init(u);
    fmpz_init(v);
    fmpq_zero(b);
    for (int k = 0; k <= i; k++) {
        fmpz_bin_uiui(u, (ulong)i, (ulong)k);
        fmpz_bin_uiui(v, (ulong)n, (ulong)k);
        fmpq_set_fmpz_frac(r, u, v);
        fmpq_poly_get_coeff_fmpq(c, p, k);
        fmpq_addmul(b, c, r);
    }
    fmpq_clear(c);
    fmpq_clear(r);
    fmpz_clear(u);
    fmpz_clear(v);
}

static inline void print_fraction(FILE *out, const fmpq_t q)
{
    char *text = fmpq_get_str(NULL, 10, q);
    fprintf(out, "\"%s\"", text);
    flint_free(text);
}

/* "name":{...} at degree n, at least the curve's own. */
static inline void print_curve(FILE *out, const char *name, const struct plane_curve *c, int n)
{
    fmpq_t x, y, w;
    fmpq_init(x);
    fmpq_init(y);
    fmpq_init(w);
    fprintf(out, "\"%s\":{\"points\":[", name);
    for (int i = 0; i <= n; i++) {
        bernstein_coefficient(x, c->x, n, i);
        bernstein_coefficient(y, c->y, n, i);
        bernstein_coefficient(w, c->w, n, i);
        fmpq_div(x, x, w);
        fmpq_div(y, y, w);
        fputs(i ? ",[" : "[", out);
        print_fraction(out, x);
        fputc(',', out);
        print_fraction(out, y);
        fputc(']', out);
    }
    fputc(']', out);
    for (int i = 0; i <= n && !fmpq_poly_is_one(c->w); i++) {
        bernstein_coefficient(w, c->w, n, i);
        fputs(i ? "," : ",\"weights\":[", out);
        print_fraction(out, w);
        fputs(i == n ? "]" : "", out);
    }
    fputc('}', out);
    fmpq_clear(x);
    fmpq_clear(y);
    fmpq_clear(w);
}

/* A case of the two curves, each elevated by so many degrees; rest: more fields, "" or ",...".  */
static inline bool make_case(struct test_case *c, const struct plane_curve *f, int f_more,
                             const struct plane_curve *g, int g_more, const char *rest)
{
    char *text, error[512];
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("{\"id\":\"a\",", out);
    print_curve(out, "f", f, plane_curve_degree(f) + f_more);
    fputc(',', out);
    print_curve(out, "g", g, plane_curve_degree(g) + g_more);
    fprintf(out, "%s}", rest);
    fclose(out);
    bool read = case_parse(text, "test", 1, c, error) == CASE_READ;
    if (!read)
        fprintf(stderr, "%s\n%s\n", text, error);
    free(text);
    return read;
}

static const struct exact_limits exact_test_limits = {40, 0};

static inline void solve(struct test_case *c, const struct plane_curve *f, int f_more,
                         const struct plane_curve *g, int g_more)
{
    assert_true(make_case(c, f, f_more, g, g_more, ""));
    const char *trouble = exact_solve(c, &exact_test_limits);
    if (trouble)
        fail_msg("%s", trouble);
}

/* As solve, of curves given as texts. */
static inline void solve_texts(struct test_case *c, const char *const f[3], const char *const g[3])
{
    struct plane_curve u, v;
    plane_curve_set(&u, f[0], f[1], f[2]);
    plane_curve_set(&v, g[0], g[1], g[2]);
    solve(c, &u, 0, &v, 0);
    plane_curve_clear(&u);
    plane_curve_clear(&v);
}

static inline bool rational_is(const mpq_t q, const char *text)
{
    mpq_t e;
    mpq_init(e);
    assert_true(number_parse(text, e));
    bool is = mpq_equal(q, e) != 0;
    mpq_clear(e);
    return is;
}

static inline void assert_solution(const struct test_case *c, int i, const char *t, const char *s,
                                   int multiplicity)
{
    const struct case_solution *a = &c->expected.at[i];
    if (!a->exact || !rational_is(a->t, t) || !rational_is(a->s, s) || a->multiplicity != multiplicity)
        fail_msg("(%s, %s) mult %d expected, (%.17g, %.17g) mult %d found", t, s, multiplicity,
                 mpq_get_d(a->t), mpq_get_d(a->s), a->multiplicity);
}

static inline void assert_overlap(const struct test_case *c, int i, const char *const ends[4])
{
    const struct case_overlap *o = &c->expected.overlap[i];
    if (!rational_is(o->t0, ends[0]) || !rational_is(o->t1, ends[1]) || !rational_is(o->s0, ends[2]) ||
        !rational_is(o->s1, ends[3]))
        fail_msg("[%s, %s, %s, %s] expected, [%.17g, %.17g, %.17g, %.17g] found", ends[0], ends[1], ends[2],
                 ends[3], mpq_get_d(o->t0), mpq_get_d(o->t1), mpq_get_d(o->s0), mpq_get_d(o->s1));
}

static inline void assert_class(const struct test_case *c, const char *name, int count, int overlaps)
{
    assert_string_equal(c->class_name, name);
    assert_int_equal(c->expected.count, count);
    assert_int_equal(c->expected.overlaps, overlaps);
}

#endif
