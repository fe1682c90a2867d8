/* What the judge rests on: groups of records are components, and curves called apart are so. */
#include "scene.h"

static bool touch(const struct record *a, const struct record *b, real tol)
{
    return a->at.t.lo - tol <= b->at.t.hi + tol && b->at.t.lo - tol <= a->at.t.hi + tol &&
           a->at.s.lo - tol <= b->at.s.hi + tol && b->at.s.lo - tol <= a->at.s.hi + tol;
}

/* The sweep finds the components that comparing all with all finds. */
static void test_groups_are_components(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        struct grouping g;
        int name[120];
        scene_make(&e, i, false, 0);
        int count = (int)random_between(&e.r, 0, 120);
        for (int k = 0; k < count; k++)
            add(&e, prop_unit(&e.r, 6), prop_unit(&e.r, 6), 1.0 / 32, CANDIDATE);
        grouping_make(&e.a, (real)0x1p-9, &g);
        assert_int_equal(g.records, count);
        for (int k = 0; k < count; k++)
            name[k] = k;
        for (bool changed = true; changed;) {
            changed = false;
            for (int k = 0; k < count; k++)
                for (int j = 0; j < count; j++)
                    if (name[k] > name[j] && touch(&g.record[k], &g.record[j], (real)0x1p-9)) {
                        name[k] = name[j];
                        changed = true;
                    }
        }
        for (int k = 0; k < count; k++)
            for (int j = 0; j < k; j++)
                assert_true((name[k] == name[j]) == (g.record[k].group == g.record[j].group));
        grouping_clear(&g);
        scene_clear(&e);
    }
}

static void euclidean(const struct curve *c, real t, real at[2])
{
    real sum[3] = {0, 0, 0};
    for (int i = 0; i <= c->degree; i++) {
        real b = 1;
        for (int k = 0; k < i; k++)
            b = b * (real)(c->degree - k) / (real)(k + 1) * t;
        for (int k = i; k < c->degree; k++)
            b = b * (1 - t);
        sum[0] += b * c->x[i];
        sum[1] += b * c->y[i];
        sum[2] += b * (c->w ? c->w[i] : (real)1);
    }
    at[0] = sum[0] / sum[2];
    at[1] = sum[1] / sum[2];
}

/* What is said to be apart has no near points; and boxes of half the true distance are seen to be apart. */
static void test_apart_is_sound_and_sharp(void **state)
{
    (void)state;
    int seen = 0;
    for (int i = 0; i < TRIALS; i++) {
        struct random_state r = random_for(9, "apart", (uint64_t)i);
        struct prop_curve f, g;
        struct problem p;
        struct box b;
        memset((void *)&p, 0, sizeof p);
        prop_curve_make(&f, &r, 1 + i % 5, 10, i % 2);
        prop_curve_make(&g, &r, 1 + i / 5 % 5, 10, i % 2);
        p.f = f.curve;
        p.g = g.curve;
        b.t.lo = prop_unit(&r, 10) * (real)(15.0 / 16);
        b.t.hi = b.t.lo + (real)(1.0 / 16);
        b.s.lo = prop_unit(&r, 10) * (real)(15.0 / 16);
        b.s.hi = b.s.lo + (real)(1.0 / 16);
        real least = 100, at[2], to[2];
        for (int k = 0; k <= 12; k++)
            for (int j = 0; j <= 12; j++) {
                euclidean(&p.f, b.t.lo + (b.t.hi - b.t.lo) * (real)k / 12, at);
                euclidean(&p.g, b.s.lo + (b.s.hi - b.s.lo) * (real)j / 12, to);
                real d = real_sqrt((at[0] - to[0]) * (at[0] - to[0]) + (at[1] - to[1]) * (at[1] - to[1]));
                least = real_min(least, d);
            }
        assert_false(curves_apart(&p, &b, least));
        if (least > (real)0.25) {
            assert_true(curves_apart(&p, &b, least / 2));
            seen++;
        }
    }
    assert_true(seen > TRIALS / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_groups_are_components),
        cmocka_unit_test(test_apart_is_sound_and_sharp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
