/* A region does not depend on affine maps, the direction of the curve, knots inserted, the degree raised. */
#include "region_made.h"

/* d -> (a x + b y + u, c x + e y + v). */
struct affine {
    real a, b, c, e, u, v;
};

static struct point apply(const struct affine *m, struct point d)
{
    struct point p = {m->a * d.x + m->b * d.y + m->u, m->c * d.x + m->e * d.y + m->v};
    return p;
}

/* The vertices of one are on the boundary of the other after the map, and as many kinds of edges. */
static void compare(const struct family *f, const struct affine *map, const struct made *m, const char *what)
{
    struct owned_workspace room;
    memset((void *)&room, 0, sizeof room);
    solve(m, &room, f->other);
    real close = 100 * size_of(f) * real_ldexp(1, -REAL_BITS / 2);
    if (f->other->kind != f->region->kind)
        fail_msg("%s: %s: %s, and %s before", f->c.id, what, region_kind_name(f->other->kind),
                 region_kind_name(f->region->kind));
    for (int i = 0; i < f->region->count; i++) {
        struct point v = apply(map, f->region->edge[i].from);
        real distance = region_distance(&m->p, &room.workspace, f->other, v);
        if (real_abs(distance) > close)
            fail_msg("%s: %s: vertex %d is off by %g", f->c.id, what, i, real_to_double(distance));
    }
    real area = f->region->area * real_abs(map->a * map->e - map->b * map->c);
    if (real_abs(f->other->area - area) > area / 100000)
        fail_msg("%s: %s: area %g, expected %g", f->c.id, what, real_to_double(f->other->area),
                 real_to_double(area));
    owned_workspace_clear(&room);
}

static void map_points(const struct affine *map, struct made *m)
{
    m->p.family.at = apply(map, m->p.family.at);
    for (int i = 0; i < m->p.family.count; i++) {
        struct point d = {m->x[i], m->y[i]}, image = apply(map, d);
        m->x[i] = image.x;
        m->y[i] = image.y;
    }
    m->p.sign = map->a * map->e - map->b * map->c < 0 ? -m->p.sign : m->p.sign;
}

static void reverse(struct made *m)
{
    struct made old = *m;
    int count = m->p.family.count, knots = count + m->p.family.degree + 1;
    for (int i = 0; i < count; i++) {
        m->x[i] = old.x[count - 1 - i];
        m->y[i] = old.y[count - 1 - i];
        m->weight[i] = old.weight[count - 1 - i];
        m->share[i] = old.share[count - 1 - i];
    }
    for (int i = 0; i < knots; i++)
        m->knots[i] = 1 - old.knots[knots - 1 - i];
    m->p.interval.lo = 1 - old.p.interval.hi;
    m->p.interval.hi = 1 - old.p.interval.lo;
    m->p.sign = -old.p.sign;
}

/* New homogeneous coordinates (w x, w y, w, w share), from those of the old points j and j - 1. */
static void blend(const struct made *old, int i, int j, real a, struct made *m)
{
    real w = 0, x = 0, y = 0, share = 0;
    for (int k = 0; k < 2; k++) {
        int at = k ? j - 1 : j;
        real part = k ? 1 - a : a;
        if (part == 0)
            continue;
        w += part * old->weight[at];
        x += part * old->weight[at] * old->x[at];
        y += part * old->weight[at] * old->y[at];
        share += part * old->weight[at] * old->share[at];
    }
    m->weight[i] = w;
    m->x[i] = x / w;
    m->y[i] = y / w;
    m->share[i] = share / w;
}

/* Boehm's insertion of the knot u. */
static void insert_knot(struct made *m, real u)
{
    struct made old = *m;
    int n = m->p.family.degree, k = n;
    while (old.knots[k + 1] <= u)
        k++;
    m->p.family.count++;
    for (int i = 0; i < m->p.family.count; i++) {
        real a = i <= k - n ? (real)1
                 : i > k    ? (real)0
                            : (u - old.knots[i]) / (old.knots[i + n] - old.knots[i]);
        blend(&old, i, i, a, m);
    }
    for (int i = k + 1; i < m->p.family.count + n + 1; i++)
        m->knots[i] = i == k + 1 ? u : old.knots[i - 1];
}

/* Of a Bezier curve. */
static void elevate(struct made *m)
{
    struct made old = *m;
    int n = m->p.family.degree++;
    m->p.family.count++;
    for (int i = 0; i <= n + 1; i++)
        blend(&old, i, i, 1 - (real)i / (n + 1), m);
    for (int i = 0; i <= n + 1; i++) {
        m->knots[i] = 0;
        m->knots[n + 2 + i] = 1;
    }
}

static bool is_telling(const struct family *f)
{
    return is_compact(f) && f->region->certified && f->region->disc_radius > size_of(f) / 1000;
}

static void test_invariances(void **state)
{
    (void)state;
    const struct affine same = {1, 0, 0, 1, 0, 0}, turned = {2, 1, -1, 3, 5, -7},
                        mirrored = {1, 2, 1, -1, 0, 3};
    int told = 0, elevated = 0;
    for (int i = 0; i < trials(1500); i++) {
        struct family f;
        family_open(&f, 31, 3, 7, (uint64_t)i);
        assert_int_equal(find(&f, "region_carriers", f.region), SOLVED);
        if (is_telling(&f)) {
            struct made m;
            made_from(&f.owned.problem, &m);
            map_points(&turned, &m);
            compare(&f, &turned, &m, "an affine map");
            made_from(&f.owned.problem, &m);
            map_points(&mirrored, &m);
            compare(&f, &mirrored, &m, "a reflection, the other sign");
            made_from(&f.owned.problem, &m);
            reverse(&m);
            compare(&f, &same, &m, "the curve backwards, the other sign");
            made_from(&f.owned.problem, &m);
            insert_knot(&m, (real)7 / 16);
            compare(&f, &same, &m, "a knot inserted");
            if (f.owned.problem.family.count == f.owned.problem.family.degree + 1) {
                made_from(&f.owned.problem, &m);
                elevate(&m);
                compare(&f, &same, &m, "the degree elevated");
                elevated++;
            }
            told++;
        }
        family_close(&f);
    }
    if (REAL_BITS <= 53)
        assert_true(told > 20 && elevated > 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_invariances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
