/* The list of records: whatever is added stays covered, also when the list is full; sorting only sorts. */
#include "nasty.h"

#include "../algorithms/crossings.h"

enum { ADDED = CROSSINGS_MAX + 500 };

static struct crossings out;
static struct crossing added[ADDED];

static bool is_inside(const struct interval *a, const struct interval *b)
{
    return b->lo <= a->lo && a->hi <= b->hi;
}

/* Dyadic ends, so that records touch often; widths from 0. */
static struct crossing make(struct random_state *r, int spread, int proved)
{
    struct crossing c;
    c.t.lo = real_ldexp((int)random_between(r, 0, spread), -10);
    c.t.hi = c.t.lo + real_ldexp((int)random_between(r, 0, 2), -10);
    c.s.lo = real_ldexp((int)random_between(r, 0, spread), -10);
    c.s.hi = c.s.lo + real_ldexp((int)random_between(r, 0, 2), -10);
    c.standing = (int)random_between(r, 1, 100) <= proved ? UNIQUE : CANDIDATE;
    c.at_most = c.multiplicity = c.standing == UNIQUE;
    return c;
}

/* Some record holds c; one that is proved and smaller than what it was merged with would be a lie. */
static bool is_covered(const struct crossing *c)
{
    for (int i = 0; i < out.count; i++) {
        const struct crossing *x = &out.at[i];
        if (is_inside(&c->t, &x->t) && is_inside(&c->s, &x->s) &&
            (x->standing == CANDIDATE ||
             (x->standing == c->standing && is_inside(&x->t, &c->t) && is_inside(&x->s, &c->s))))
            return true;
    }
    return false;
}

static bool precedes_or_equals(const struct crossing *a, const struct crossing *b)
{
    return a->t.lo < b->t.lo || (a->t.lo == b->t.lo && a->s.lo <= b->s.lo);
}

/* Few or many, near or far from each other, none to all of them proved. */
static void test_coverage(void **state)
{
    (void)state;
    static const int spread[] = {40, 400, 1000}, proved[] = {0, 10, 99, 100};
    for (int i = 0; i < 12; i++) {
        struct random_state r = random_for(1, "crossings", (uint64_t)i);
        int count = i % 4 ? ADDED : (int)random_between(&r, 1, CROSSINGS_MAX);
        out.count = out.overlaps = 0;
        out.merged = false;
        for (int k = 0; k < count; k++) {
            added[k] = make(&r, spread[i % 3], proved[i / 3]);
            crossings_add(&out, &added[k]);
            assert_true(out.count <= CROSSINGS_MAX);
        }
        assert_true(out.merged == (count > CROSSINGS_MAX));
        for (int k = 0; k < count; k++)
            if (!is_covered(&added[k]))
                fail_msg("list %d: record %d of %d is lost", i, k, count);
        crossings_sort(&out);
        for (int k = 0; k < count; k++)
            assert_true(is_covered(&added[k]));
        for (int k = 1; k < out.count; k++)
            assert_true(precedes_or_equals(&out.at[k - 1], &out.at[k]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coverage),
    };
    return cmocka_run_group_tests_name("crossings", tests, NULL, NULL);
}
