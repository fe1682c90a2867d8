/* The judge against answers about overlaps, made by hand. */
#include "scene.h"

/* f is the parabola (t, t^2), g its arc over [a / 8, b / 8], reversed or not. */
static void overlap_make(struct scene *e, int trial)
{
    char line[1024];
    memset((void *)e, 0, sizeof *e);
    e->r = random_for(8, "judge overlap", (uint64_t)trial);
    int a = (int)random_between(&e->r, 0, 4), b = a + (int)random_between(&e->r, 1, 4);
    int from = trial % 2 ? b : a, to = trial % 2 ? a : b;
    sprintf(line,
            "{\"id\":\"overlap\",\"f\":{\"points\":[[0,0],[\"1/2\",0],[1,1]]},"
            "\"g\":{\"points\":[[\"%d/8\",\"%d/64\"],[\"%d/16\",\"%d/64\"],[\"%d/8\",\"%d/64\"]]},"
            "\"expected\":{\"count\":0,\"overlap\":[[\"%d/8\",\"%d/8\",%d,%d]]}}",
            from, from * from, from + to, from * to, to, to * to, a, b, trial % 2, 1 - trial % 2);
    parse_scene(e, line);
    e->root[0] = (real)a / 8;
    e->root[1] = (real)b / 8;
    struct overlap *o = &e->x->overlap[e->x->overlaps++];
    o->t_outer.lo = o->t_inner.lo = e->root[0];
    o->t_outer.hi = o->t_inner.hi = e->root[1];
    o->s_outer.lo = o->s_inner.lo = 0;
    o->s_outer.hi = o->s_inner.hi = 1;
    o->distance = 0;
    o->reversed = trial % 2;
    o->exact = true;
}

static void test_overlap_records(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        overlap_make(&e, i);
        struct overlap *o = &e.x->overlap[0];
        assert_counts(verdict(&e), RIGHT, 1, 0, 0, 0, 0, 0);
        o->exact = false;
        assert_counts(verdict(&e), RIGHT, 1, 0, 0, 0, 0, 0);
        add(&e, e.root[1], (real) !(i % 2), TOL, UNIQUE);
        o->t_outer.hi -= (real)0x1p-10; /* covered but for the end, which the other record holds */
        assert_counts(verdict(&e), RIGHT, 1, 0, 0, 0, 0, 1);
        o->t_outer.hi = (e.root[0] + e.root[1]) / 2; /* and now a half of it is not */
        assert_counts(verdict(&e), WRONG, 0, 1, 0, 0, 0, 1);
        scene_clear(&e);
    }
}

static void test_candidates_along_an_overlap(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        struct scene e;
        enum { PIECES = 16 };
        overlap_make(&e, i);
        e.x->overlaps = 0;
        e.a.outcome = i % 3 ? OUT_OF_STEPS : SOLVED;
        for (int k = 0; k < PIECES; k++) {
            struct crossing *c = &e.x->at[e.x->count++];
            c->t.lo = e.root[0] + (e.root[1] - e.root[0]) * (real)k / PIECES;
            c->t.hi = e.root[0] + (e.root[1] - e.root[0]) * (real)(k + 1) / PIECES;
            c->s.lo = (real)(i % 2 ? PIECES - 1 - k : k) / PIECES;
            c->s.hi = c->s.lo + (real)1 / PIECES;
        }
        assert_counts(verdict(&e), i % 3 ? STOPPED : RIGHT, 1, 0, 0, 0, 0, 1);
        e.x->at[PIECES / 2].standing = UNIQUE; /* one solution only, in the midst of an overlap? */
        assert_int_equal(verdict(&e).extra, 1);
        e.x->at[PIECES / 2] = e.x->at[0];
        struct judgement v = verdict(&e);
        assert_int_equal(v.missed, 1);
        assert_int_equal(v.found, 0);
        scene_clear(&e);
    }
}

static void test_overlaps_that_are_none(void **state)
{
    (void)state;
    struct scene e;
    scene_make(&e, 5, false, 10);
    add_all(&e, UNIQUE);
    struct overlap *o = &e.x->overlap[e.x->overlaps++];
    o->t_outer.lo = o->t_inner.lo = o->s_outer.lo = o->s_inner.lo = 0;
    o->t_outer.hi = o->t_inner.hi = o->s_outer.hi = o->s_inner.hi = 1;
    o->distance = (real)0x1p-10; /* true: the curves are this near all along */
    assert_int_equal(verdict(&e).extra, 0);
    assert_int_equal(verdict(&e).merged, 1); /* but that tells nothing apart */
    o->distance = (real)0x1p-20;
    assert_int_equal(verdict(&e).extra, 1);
    o->distance = (real)0x1p-10;
    o->exact = true;
    assert_int_equal(verdict(&e).extra, 1);
    scene_clear(&e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_overlap_records),
        cmocka_unit_test(test_candidates_along_an_overlap),
        cmocka_unit_test(test_overlaps_that_are_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
