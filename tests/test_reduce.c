/* Degree reduction: its matrix is that of the orthogonal projection, found here from the normal equations in
 * exact arithmetic, each entry rounded once; the residual's bound holds; nothing is left along lower degrees.
 */
#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/reduce.h"

enum { DEGREE = 32, ROWS = REDUCED_MAX + 1, COLUMNS = DEGREE + 1, COMPONENTS = 3 };

/* C(n, i) C(k, j) / C(n + k, i + j) = (n + k + 1) times the integral of B(i,n) B(j,k). */
static void inner_product(int n, int i, int k, int j, mpq_t out)
{
    mpz_t b;
    mpz_init(b);
    mpz_bin_uiui(mpq_numref(out), (unsigned long)n, (unsigned long)i);
    mpz_bin_uiui(b, (unsigned long)k, (unsigned long)j);
    mpz_mul(mpq_numref(out), mpq_numref(out), b);
    mpz_bin_uiui(mpq_denref(out), (unsigned long)(n + k), (unsigned long)(i + j));
    mpz_mul_si(mpq_denref(out), mpq_denref(out), n + k + 1);
    mpq_canonicalize(out);
    mpz_clear(b);
}

struct projection {
    mpq_t gram[ROWS][ROWS], entry[ROWS][COLUMNS];
};

/* gram entry = right side, solved in place: Gauss and Jordan. */
static void projection_init(struct projection *p, int n, int k)
{
    mpq_t factor, product;
    mpq_init(factor);
    mpq_init(product);
    for (int j = 0; j <= k; j++) {
        rationals_init(k + 1, p->gram[j]);
        rationals_init(n + 1, p->entry[j]);
        for (int i = 0; i <= k; i++)
            inner_product(k, j, k, i, p->gram[j][i]);
        for (int i = 0; i <= n; i++)
            inner_product(k, j, n, i, p->entry[j][i]);
    }
    for (int pivot = 0; pivot <= k; pivot++) {
        mpq_inv(factor, p->gram[pivot][pivot]);
        for (int i = 0; i <= k; i++)
            mpq_mul(p->gram[pivot][i], p->gram[pivot][i], factor);
        for (int i = 0; i <= n; i++)
            mpq_mul(p->entry[pivot][i], p->entry[pivot][i], factor);
        for (int row = 0; row <= k; row++) {
            if (row == pivot)
                continue;
            mpq_set(factor, p->gram[row][pivot]);
            for (int i = 0; i <= k; i++) {
                mpq_mul(product, factor, p->gram[pivot][i]);
                mpq_sub(p->gram[row][i], p->gram[row][i], product);
            }
            for (int i = 0; i <= n; i++) {
                mpq_mul(product, factor, p->entry[pivot][i]);
                mpq_sub(p->entry[row][i], p->entry[row][i], product);
            }
        }
    }
    mpq_clear(factor);
    mpq_clear(product);
}

static void projection_clear(struct projection *p, int n, int k)
{
    for (int j = 0; j <= k; j++) {
        rationals_clear(k + 1, p->gram[j]);
        rationals_clear(n + 1, p->entry[j]);
    }
}

static real memory[2 * ROWS * COLUMNS];

/* Coefficient i in degree n of B(row, k): C(k, row) C(n-k, i-row) / C(n, i). */
static void exact_elevation(int n, int k, int i, int row, mpq_t out)
{
    mpz_t b;
    mpz_init(b);
    mpq_set_ui(out, 0, 1);
    if (i >= row && i - row <= n - k) {
        mpz_bin_uiui(mpq_numref(out), (unsigned long)k, (unsigned long)row);
        mpz_bin_uiui(b, (unsigned long)(n - k), (unsigned long)(i - row));
        mpz_mul(mpq_numref(out), mpq_numref(out), b);
        mpz_bin_uiui(mpq_denref(out), (unsigned long)n, (unsigned long)i);
        mpq_canonicalize(out);
    }
    mpz_clear(b);
}

static void test_matrices(void **state)
{
    (void)state;
    struct projection p;
    mpq_t e;
    mpq_init(e);
    for (int n = 2; n <= DEGREE; n += REAL_BITS > 113 ? 6 : 1)
        for (int k = 1; k <= REDUCED_MAX && k < n; k++) {
            struct reduction r;
            projection_init(&p, n, k);
            reduction_init(&r, n, k, memory);
            assert_true(r.n == n && r.k == k);
            assert_int_equal(reduction_length(n, k), 2 * (n + 1) * (k + 1));
            for (int row = 0; row <= k; row++)
                for (int i = 0; i <= n; i++) {
                    if (r.reduce[row * (n + 1) + i] != real_from_rational(p.entry[row][i]))
                        fail_msg("reduce %d to %d: entry %d, %d is not rounded once", n, k, row, i);
                    exact_elevation(n, k, i, row, e);
                    if (r.elevate[i * (k + 1) + row] != real_from_rational(e))
                        fail_msg("elevate %d to %d: entry %d, %d is not rounded once", k, n, i, row);
                }
            projection_clear(&p, n, k);
        }
    mpq_clear(e);
}

/* sum of a[i] c[i] and of |a[i] c[i]|. */
static void dot(int length, mpq_t *a, const real *c, mpq_t out, mpq_t size)
{
    mpq_t term;
    mpq_init(term);
    mpq_set_ui(out, 0, 1);
    mpq_set_ui(size, 0, 1);
    for (int i = 0; i < length; i++) {
        real_to_rational(c[i], term);
        mpq_mul(term, term, a[i]);
        mpq_add(out, out, term);
        mpq_abs(term, term);
        mpq_add(size, size, term);
    }
    mpq_clear(term);
}

/* q against the projection of c (entries, products and sums: n + 3 roundings), rest against c - q elevated.
 */
static void check_component(const struct reduction *r, struct projection *p, const real *c, const real *q,
                            const real *rest, real bound, int trial)
{
    mpq_t exact, size, limit, e[ROWS];
    mpq_init(exact);
    mpq_init(size);
    mpq_init(limit);
    rationals_init(r->k + 1, e);
    for (int row = 0; row <= r->k; row++) {
        dot(r->n + 1, p->entry[row], c, exact, size);
        if (!is_near(q[row], exact, r->n + 3, size))
            fail_msg("reduction %d: %d to %d: coefficient %d is not that of the projection", trial, r->n,
                     r->k, row);
    }
    real_to_rational(bound, limit);
    for (int i = 0; i <= r->n; i++) {
        mpq_t own;
        mpq_init(own);
        for (int row = 0; row <= r->k; row++)
            exact_elevation(r->n, r->k, i, row, e[row]);
        dot(r->k + 1, e, q, exact, size);
        real_to_rational(c[i], own);
        mpq_sub(exact, own, exact);
        if (!is_within(rest[i], exact, limit))
            fail_msg("reduction %d: %d to %d: residual %d is off by more than its bound", trial, r->n, r->k,
                     i);
        mpq_clear(own);
    }
    rationals_clear(r->k + 1, e);
    mpq_clear(exact);
    mpq_clear(size);
    mpq_clear(limit);
}

static void test_apply(void **state)
{
    (void)state;
    for (int i = 0; i < trials(400); i++) {
        struct random_state r = random_for(1, "apply", (uint64_t)i);
        int k = (int)random_between(&r, 1, REDUCED_MAX), n = (int)random_between(&r, k + 1, DEGREE);
        int components = (int)random_between(&r, 1, COMPONENTS);
        real c[COMPONENTS * COLUMNS], q[COMPONENTS * ROWS], rest[COMPONENTS * COLUMNS];
        struct reduction reduction;
        struct projection p;
        reduction_init(&reduction, n, k, memory);
        projection_init(&p, n, k);
        for (int j = 0; j < components; j++)
            nasty_coefficients(&r, n, c + j * (n + 1));
        reduction_apply(&reduction, components, c, q);
        real bound = reduction_residual(&reduction, components, c, q, rest);
        for (int j = 0; j < components; j++)
            check_component(&reduction, &p, c + j * (n + 1), q + j * (k + 1), rest + j * (n + 1), bound, i);
        projection_clear(&p, n, k);
    }
}

/* The exact matrix: what is left of c is orthogonal to every B(j, k), and polynomials of degree k stay. */
static void test_projection(void **state)
{
    (void)state;
    mpq_t left, term, product;
    mpq_init(left);
    mpq_init(term);
    mpq_init(product);
    for (int n = 2; n <= 12; n += 5)
        for (int k = 1; k <= REDUCED_MAX && k < n; k++) {
            struct projection p;
            projection_init(&p, n, k);
            for (int i = 0; i <= n; i++)
                for (int j = 0; j <= k; j++) { /* B(i,n) less its projection, against B(j,k) */
                    inner_product(n, i, k, j, left);
                    for (int row = 0; row <= k; row++) {
                        inner_product(k, row, k, j, term);
                        mpq_mul(product, term, p.entry[row][i]);
                        mpq_sub(left, left, product);
                    }
                    assert_int_equal(mpq_sgn(left), 0);
                }
            projection_clear(&p, n, k);
        }
    mpq_clear(left);
    mpq_clear(term);
    mpq_clear(product);
}

static void test_identity(void **state)
{
    (void)state;
    for (int k = 1; k <= REDUCED_MAX; k++)
        for (int n = 1; n <= k; n++) {
            struct random_state r = random_for(1, "identity", (uint64_t)(10 * k + n));
            struct reduction reduction;
            real c[COMPONENTS * COLUMNS], q[COMPONENTS * COLUMNS], rest[COMPONENTS * COLUMNS];
            reduction_init(&reduction, n, k, NULL);
            assert_true(reduction.k == n && reduction_length(n, k) == 0);
            for (int j = 0; j < COMPONENTS; j++)
                nasty_coefficients(&r, n, c + j * (n + 1));
            reduction_apply(&reduction, COMPONENTS, c, q);
            assert_true(reduction_residual(&reduction, COMPONENTS, c, q, rest) == 0);
            for (int i = 0; i < COMPONENTS * (n + 1); i++)
                assert_true(q[i] == c[i] && rest[i] == 0);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_matrices),
        cmocka_unit_test(test_apply),
        cmocka_unit_test(test_projection),
        cmocka_unit_test(test_identity),
    };
    return cmocka_run_group_tests_name("reduce", tests, NULL, NULL);
}
