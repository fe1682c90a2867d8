/* Inside a region every curve is regular with curvature of one sign, just outside an edge none is: proved for
 * random points by the Bernstein coefficients of det(F', F'') itself. */
#include "region_family.h"
#include "region_proof.h"

struct tally {
    int inside, outside, open;
};

/* A positive combination of the vertices and the middle of the disc. */
static void draw_inside(const struct family *f, struct random_state *r, struct point *d)
{
    real x = 0, y = 0, sum = 0;
    for (int i = 0; i < f->region->count; i++) {
        real weight = prop_unit(r, 10);
        x += weight * f->region->edge[i].to.x;
        y += weight * f->region->edge[i].to.y;
        sum += weight;
    }
    real middle = sum / 4 + (real)1 / 1000;
    d->x = (x + middle * f->region->disc_centre.x) / (sum + middle);
    d->y = (y + middle * f->region->disc_centre.y) / (sum + middle);
}

static void prove_inside(const struct family *f, struct random_state *r, struct tally *t)
{
    struct point d;
    for (int i = 0; i < 4; i++) {
        draw_inside(f, r, &d);
        int sign = proof_of_curve(&f->owned.problem, d);
        if (sign < 0)
            fail_msg("%s: (%.17g, %.17g) is inside, but the curvature changes its sign", f->c.id,
                     real_to_double(d.x), real_to_double(d.y));
        t->inside += sign > 0;
        t->open += sign == 0;
    }
}

/* Beyond the middle of a line's segment and the start of an arc, by a small step along the normal. */
static void prove_outside(const struct family *f, struct tally *t)
{
    real step = real_max(f->region->disc_radius / 100, size_of(f) / 10000);
    for (int i = 0; i < f->region->count; i++) {
        const struct region_edge *e = &f->region->edge[i];
        struct point d = e->from;
        if (e->type != EDGE_ARC) {
            d.x = (e->from.x + e->to.x) / 2;
            d.y = (e->from.y + e->to.y) / 2;
        }
        d.x -= step * e->line[0];
        d.y -= step * e->line[1];
        int sign = proof_of_curve(&f->owned.problem, d);
        if (sign > 0)
            fail_msg("%s: beyond edge %d, but the curvature keeps its sign", f->c.id, i);
        t->outside += sign < 0;
        t->open += sign == 0;
    }
}

static void test_inside_and_outside(void **state)
{
    (void)state;
    struct tally t = {0, 0, 0};
    for (int i = 0; i < trials(1500); i++) {
        struct family f;
        struct random_state r = random_for(21, "proof", (uint64_t)i);
        family_open(&f, 21, 3, 9, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        if (is_compact(&f) && f.region->strict && f.region->certified &&
            f.region->disc_radius > size_of(&f) / 10000) {
            prove_inside(&f, &r, &t);
            prove_outside(&f, &t);
        }
        family_close(&f);
    }
    print_message("%d points inside and %d outside proved, %d open\n", t.inside, t.outside, t.open);
    assert_true(t.inside > 0 && t.outside > 0);
    assert_true(100 * t.open <= t.inside + t.outside);
}

/* What region_contains says of any point is so; and it seldom cannot tell. */
static void test_membership(void **state)
{
    (void)state;
    int told = 0, open = 0;
    for (int i = 0; i < trials(1500); i++) {
        struct family f;
        struct random_state r = random_for(22, "membership", (uint64_t)i);
        family_open(&f, 22, 3, 9, (uint64_t)i);
        assert_int_equal(region_prepare(&f.owned.problem, &f.room.workspace), SOLVED);
        for (int j = 0; j < 4; j++) {
            struct point d = {12 * prop_dyadic(&r, 20), 12 * prop_dyadic(&r, 20)};
            enum side side = region_contains(&f.owned.problem, &f.room.workspace, d, 0);
            int sign = proof_of_curve(&f.owned.problem, d);
            if ((side == SIDE_INSIDE && sign < 0) || (side == SIDE_OUTSIDE && sign > 0))
                fail_msg("%s: (%.17g, %.17g) is said to be %s", f.c.id, real_to_double(d.x),
                         real_to_double(d.y), side == SIDE_INSIDE ? "inside" : "outside");
            told += side != SIDE_BOUNDARY;
            open += side == SIDE_BOUNDARY;
        }
        family_close(&f);
    }
    assert_true(told > 50 * open);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_inside_and_outside),
        cmocka_unit_test(test_membership),
    };
    return cmocka_run_group_tests_name("region_proof", tests, NULL, NULL);
}
