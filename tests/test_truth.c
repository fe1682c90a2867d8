/* Resultants against FLINT's; wrong expectations are told. */
#include "prop.h"

#include <flint/fmpz_mpoly.h>

#include "../harness/truth/exact_poly.h"
#include "../harness/truth/truth_compare.h"
#include "exact_curves.h"

static void to_mpoly(fmpz_mpoly_t to, const struct biv *p, const fmpz_mpoly_ctx_t ctx)
{
    for (int i = 0; i <= p->n; i++)
        for (int j = 0; j <= p->m; j++)
            fmpz_mpoly_set_coeff_fmpz_ui(to, biv_at(p, i, j), (ulong[]){(ulong)i, (ulong)j}, ctx);
}

static void random_system(struct biv *p, struct random_state *r, int n, int m)
{
    biv_init(p, n, m);
    for (int k = 0; k <= n; k++)
        fmpz_set_si(biv_at(p, k, 0), random_between(r, -1000000, 1000000));
    for (int j = 1; j <= m; j++)
        fmpz_set_si(biv_at(p, 0, j), random_between(r, -1000000, 1000000));
}

/* The resultant is FLINT's, up to sign, and has n m roots: Bezout's number. */
static void test_resultant(void **state)
{
    (void)state;
    fmpz_mpoly_ctx_t ctx;
    fmpz_mpoly_t a, b, c;
    fmpz_poly_t r;
    fmpz_t u, v;
    fmpz_mpoly_ctx_init(ctx, 2, ORD_LEX);
    fmpz_poly_init(r);
    fmpz_init(u);
    fmpz_init(v);
    for (int i = 0; i < 40; i++) {
        struct random_state random = random_for(3, "resultant", (uint64_t)i);
        int n = 1 + i % 5, m = 1 + i % 4;
        struct biv p, q;
        random_system(&p, &random, n, m);
        random_system(&q, &random, n, m);
        fmpz_mpoly_init(a, ctx);
        fmpz_mpoly_init(b, ctx);
        fmpz_mpoly_init(c, ctx);
        to_mpoly(a, &p, ctx);
        to_mpoly(b, &q, ctx);
        assert_true(fmpz_mpoly_resultant(c, a, b, 1, ctx));
        assert_true(biv_resultant(r, &p, &q, n * m, NULL, 0));
        assert_int_equal(fmpz_poly_degree(r), n * m);
        assert_int_equal(fmpz_mpoly_degree_si(c, 0, ctx), n * m);
        for (int k = 0; k <= n * m; k++) {
            fmpz_mpoly_get_coeff_fmpz_ui(u, c, (ulong[]){(ulong)k, 0}, ctx);
            fmpz_poly_get_coeff_fmpz(v, r, k);
            assert_true(fmpz_cmpabs(u, v) == 0);
        }
        fmpz_mpoly_clear(a, ctx);
        fmpz_mpoly_clear(b, ctx);
        fmpz_mpoly_clear(c, ctx);
        biv_clear(&p);
        biv_clear(&q);
    }
    fmpz_mpoly_ctx_clear(ctx);
    fmpz_poly_clear(r);
    fmpz_clear(u);
    fmpz_clear(v);
}

static int differences(const char *rest)
{
    struct plane_curve f, g;
    struct test_case said, found;
    char *report;
    size_t size;
    plane_curve_set(&f, "2  0 1", "3  0 0 1", NULL);
    plane_curve_set(&g, "2  0 1", "2  0 1/2", NULL); /* meets the parabola at 0 and 1/2 */
    assert_true(make_case(&said, &f, 0, &g, 0, rest));
    solve(&found, &f, 0, &g, 0);
    FILE *stream = open_memstream(&report, &size);
    int count = truth_compare(stream, &said, &found, 1e-15);
    fclose(stream);
    assert_true((count > 0) == (size > 0));
    free(report);
    case_clear(&said);
    case_clear(&found);
    plane_curve_clear(&f);
    plane_curve_clear(&g);
    return count;
}

static void test_wrong_expectations_are_told(void **state)
{
    (void)state;
    assert_int_equal(
        differences(",\"class\":\"endpoint\",\"expected\":{\"count\":2,\"params\":[[0,0],[0.5,0.5]],"
                    "\"mult\":[1,1]}"),
        0);
    assert_int_equal(
        differences(",\"planted\":[{\"t\":\"1/2\",\"s\":\"1/2\",\"mult\":1}],\"planted_count\":2"), 0);
    assert_true(differences(",\"class\":\"tangent\""));
    assert_true(differences(",\"expected\":{\"count\":1,\"params\":[[0,0]]}"));
    assert_true(differences(",\"expected\":{\"count\":2,\"params\":[[0,0],[0.5,0.500000000001]]}"));
    assert_true(differences(",\"expected\":{\"count\":2,\"params\":[[0,0],[0.5,0.5]],\"mult\":[1,2]}"));
    assert_true(
        differences(",\"expected\":{\"count\":2,\"params\":[[0,0],[0.5,0.5]],\"overlap\":[[0,1,0,1]]}"));
    assert_true(differences(",\"planted\":[{\"t\":\"1/3\",\"s\":\"1/2\"}]"));
    assert_true(differences(",\"planted\":[{\"t\":\"1/2\",\"s\":\"1/2\",\"mult\":2}]"));
    assert_true(differences(",\"planted_count\":1"));
    assert_true(differences(",\"planted_overlap\":[0,1,0,1]"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_resultant),
        cmocka_unit_test(test_wrong_expectations_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
