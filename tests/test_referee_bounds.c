/* What the referee rests on: a restriction errs within its bound, and no cell with a solution is excluded. */
#include "sketch.h"

static void test_restriction_errs_within_its_bound(void **state)
{
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        struct random_state r = random_for(1, "restrict", (uint64_t)trial);
        int n = trial < 32 ? trial + 1 : (int)random_between(&r, 1, 12);
        quad c[33], got[33], a, b;
        mpq_t exact[33], out, is, ends[2];
        for (int i = 0; i <= n; i++) {
            c[i] = (quad)random_between(&r, -1000000, 1000000) / 1000000;
            mpq_init(exact[i]);
            rational_from_quad(exact[i], c[i]);
        }
        mpq_inits(ends[0], ends[1], out, is, NULL);
        b = ldexpq((quad)random_between(&r, 1, 1000) / 1001, -(int)random_between(&r, 0, 50));
        a = -QUAD_OVERHANG + (1 + 2 * QUAD_OVERHANG - b) * ((quad)random_between(&r, 0, 1000) / 1000);
        b = trial % 3 == 0 ? 1 + QUAD_OVERHANG : fminq(a + b, 1 + QUAD_OVERHANG);
        quad_restrict(n, c, a, b, got);
        rational_from_quad(ends[0], a);
        rational_from_quad(ends[1], b);
        for (int k = 0; k < 8; k++) {
            int i = k < 2 ? k * n : (int)random_between(&r, 0, n);
            polar(n, (const mpq_t *)exact, ends[0], ends[1], i, out);
            rational_from_quad(is, got[i]);
            assert_true(distance(is, out) <= quad_restrict_error(n));
        }
        for (int i = 0; i <= n; i++)
            mpq_clear(exact[i]);
        mpq_clears(ends[0], ends[1], out, is, NULL);
    }
}

/* Down the cells that hold a planted solution: none is excluded, by whatever means, and what is proved is it.
 */
static void follow(const struct quad_pair *p, const quad at[2], struct random_state *r, int *proved)
{
    struct anchored_cell c, second;
    memset(&c, 0, sizeof c);
    c.f.width = c.g.width = 1;
    assert_true(anchored_cut(p, &c));
    for (int k = 0; k < 180; k++) {
        struct anchored_view view = anchored_look(p, &c);
        struct quad_root root;
        struct quad_interval t = {c.f.lo, c.f.lo + c.f.width}, s = {c.g.lo, c.g.lo + c.g.width};
        assert_false(view.apart);
        if (k % 8 == 0 || (view.promising && k < 24)) {
            enum proof proof = krawczyk_test(p, t, s, &root);
            assert_int_not_equal(proof, NO_ROOT);
            for (int i = 0; i < 2 && proof == ONE_ROOT; i++)
                assert_true(fabsq(root.at[i] - at[i]) <= root.radius[i]);
            *proved += proof == ONE_ROOT;
        }
        bool f = (random_bits(r) % 4 ? view.split_f : !view.split_f);
        if ((f ? c.f : c.g).halvings >= 90)
            break;
        anchored_halve(p, &c, f, &second);
        const struct anchored_part *right = f ? &second.f : &second.g;
        bool upper = at[f ? 0 : 1] > right->lo || (at[f ? 0 : 1] == right->lo && random_bits(r) % 2);
        if (upper)
            c = second;
        if (view.blurred && random_bits(r) % 2)
            assert_true(anchored_cut(p, &c));
    }
}

static void test_a_solution_is_never_excluded(void **state)
{
    (void)state;
    int proved = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        struct random_state r = random_for(2, "follow", (uint64_t)trial);
        struct sketch f, g;
        struct test_case c;
        struct referee_pair exact;
        struct quad_pair p;
        mpq_t t, s;
        mpq_inits(t, s, NULL);
        sketch_random(&f, &r, (int)random_between(&r, 1, 9), trial % 2);
        sketch_random(&g, &r, (int)random_between(&r, 1, 9), trial % 2);
        random_place(&r, t);
        random_place(&r, s);
        plant(&f, &g, t, s);
        case_make(&c, &f, &g);
        referee_pair_make(&c, &exact);
        referee_pair_round(&exact, &p);
        const quad at[2] = {(quad)mpq_get_d(t), (quad)mpq_get_d(s)};
        follow(&p, at, &r, &proved);
        referee_pair_clear(&exact);
        case_clear(&c);
        sketch_clear(&f);
        sketch_clear(&g);
        mpq_clears(t, s, NULL);
    }
    assert_true(proved > TRIALS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_restriction_errs_within_its_bound),
        cmocka_unit_test(test_a_solution_is_never_excluded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
