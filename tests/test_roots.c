/* Roots of polynomials in Bernstein form: planted ones are never lost, however the coefficients err. */
#include <math.h>

#include "dyadic.h"
#include "nasty.h"

#include "../algorithms/core/roots.h"
#include "../harness/planted_roots.h"

enum { DEGREE = 12, SCRATCH = 8192 };

/* A polynomial with planted roots k 2^-bits: exact coefficients, and reals within the errors of them. */
struct planted {
    int n, roots;
    real root[DEGREE];
    mpq_t exact[DEGREE + 1];
    real c[DEGREE + 1], error[DEGREE + 1];
};

static void planted_init(struct planted *p)
{
    p->n = p->roots = 0;
    rationals_init(DEGREE + 1, p->exact);
    mpq_set_si(p->exact[0], 1, 1);
}

static void planted_clear(struct planted *p)
{
    rationals_clear(DEGREE + 1, p->exact);
}

/* Multiplies by factor[0] + factor[1] z + ... + factor[k] z^k, all in scaled Bernstein form (z = v / (1 -
 * v)). */
static void multiply(struct planted *p, int k, mpq_t *factor)
{
    mpq_t out[DEGREE + 1], term;
    rationals_init(DEGREE + 1, out);
    mpq_init(term);
    for (int i = 0; i <= p->n; i++) {
        for (int j = 0; j <= k; j++) {
            mpq_mul(term, p->exact[i], factor[j]);
            mpq_add(out[i + j], out[i + j], term);
        }
    }
    p->n += k;
    for (int i = 0; i <= p->n; i++)
        mpq_set(p->exact[i], out[i]);
    mpq_clear(term);
    rationals_clear(DEGREE + 1, out);
}

/* v - root = (1 - root) v - root (1 - v). */
static void plant(struct planted *p, real root)
{
    mpq_t factor[2];
    rationals_init(2, factor);
    real_to_rational(-root, factor[0]);
    mpq_set_si(factor[1], 1, 1);
    mpq_add(factor[1], factor[1], factor[0]);
    multiply(p, 1, factor);
    rationals_clear(2, factor);
    p->root[p->roots++] = root;
}

/* A factor without roots in [0, 1]: positive coefficients. */
static void plant_nothing(struct planted *p, struct random_state *r, int k)
{
    mpq_t factor[DEGREE + 1];
    rationals_init(k + 1, factor);
    for (int i = 0; i <= k; i++)
        mpq_set_si(factor[i], random_between(r, 1, 1000), 64);
    multiply(p, k, factor);
    rationals_clear(k + 1, factor);
}

/* Rounds the exact coefficients and moves each by up to `off` times the largest. */
static void blur(struct planted *p, struct random_state *r, real off)
{
    mpq_t q;
    mpq_init(q);
    real largest = 0;
    for (int i = 0; i <= p->n; i++) {
        mpq_set_si(q, 1, 1);
        mpz_bin_uiui(mpq_denref(q), p->n, i);
        mpq_mul(q, q, p->exact[i]);
        p->c[i] = real_from_rational(q);
        largest = real_max(largest, real_abs(p->c[i]));
    }
    for (int i = 0; i <= p->n; i++) {
        p->c[i] += prop_dyadic(r, 20) * off * largest;
        p->error[i] = off * largest + REAL_EPSILON * 2 * real_abs(p->c[i]);
    }
    mpq_clear(q);
}

/* Simple, double, triple, close, at the ends, at parameters full of digits. */
static void plant_roots(struct planted *p, struct random_state *r, int n)
{
    while (p->n < n) {
        int room = n - p->n, kind = (int)random_between(r, 0, 5);
        real root = kind == 0 ? nasty_unit(r) : prop_unit(r, 16);
        int times = kind == 1 ? 2 : kind == 2 ? 3 : 1;
        if (kind == 3 && room >= 2) {
            real beside = root + real_ldexp(1, -(int)random_between(r, 10, REAL_BITS - 4));
            plant(p, real_min(beside, 1));
        }
        for (int i = 0; i < times && p->n < n; i++)
            plant(p, root);
        if (kind == 5 && p->n < n)
            plant_nothing(p, r, n - p->n < 2 ? 1 : 2);
    }
}

static int count_lost(const struct planted *p, int count, const struct root *found)
{
    int lost = 0;
    for (int i = 0; i < p->roots; i++) {
        int j = 0;
        while (j < count && !(found[j].lo <= p->root[i] && p->root[i] <= found[j].hi))
            j++;
        lost += j == count;
    }
    return lost;
}

static int count_held(const struct planted *p, const struct root *r)
{
    int held = 0;
    for (int i = 0; i < p->roots; i++)
        held += r->lo <= p->root[i] && p->root[i] <= r->hi;
    return held;
}

static void make_planted(struct planted *p, struct random_state *r)
{
    planted_init(p);
    plant_roots(p, r, (int)random_between(r, 1, DEGREE));
    int finest = REAL_BITS - 2 < 100 ? REAL_BITS - 2 : 100;
    blur(p, r, random_bits(r) % 3 ? real_ldexp(1, -(int)random_between(r, 10, finest)) : (real)0);
}

static void check_planted(const struct root_finder *f, int i)
{
    static real scratch[SCRATCH];
    struct random_state r = random_for(1, "planted", (uint64_t)i);
    struct planted p;
    struct root found[DEGREE + 1];
    make_planted(&p, &r);
    int count = f->find(p.n, p.c, p.error, real_ldexp(1, -30), scratch, DEGREE + 1, found, NULL);
    if (count_lost(&p, count, found) > 0)
        fail_msg("%s, case %d: a root is lost", f->name, i);
    for (int j = 0; j < count; j++) {
        int held = count_held(&p, &found[j]);
        if (held > found[j].at_most || (found[j].single && held != 1))
            fail_msg("%s, case %d: %d roots where at most %d were promised", f->name, i, held,
                     found[j].at_most);
        if (found[j].lo > found[j].hi || (j > 0 && found[j - 1].hi >= found[j].lo))
            fail_msg("%s, case %d: enclosures out of order", f->name, i);
    }
    planted_clear(&p);
}

static void test_planted(void **state)
{
    (void)state;
    assert_true(roots_scratch(DEGREE) <= SCRATCH);
    for (int k = 0; root_finders[k]; k++)
        for (int i = 0; i < trials(k == 0 ? 8000 : 3000); i++)
            check_planted(root_finders[k], i);
}

/* ---- order and cost ---- */

/* log2 of the widths of the intervals that held 1/3. */
struct trail {
    int count;
    double width[4096];
};

static void follow(void *log, real lo, real hi)
{
    struct trail *t = (struct trail *)log;
    real width = hi - lo, root = (real)1 / 3;
    if (lo <= root && root <= hi && width > 0 && t->count < 4096) {
        int e = real_exponent(width);
        t->width[t->count++] = e + log2(real_to_double(real_ldexp(width, -e)));
    }
}

/* The last ratio (L3 - L2) / (L2 - L1) with L3 three quarters of the way to where rounding ends; 0: there is
 * none. */
static double order_of(const struct root_finder *f, enum planted_kind kind, int n, int *clips)
{
    static real scratch[SCRATCH];
    static struct trail trail;
    real c[PLANTED_DEGREE_MAX + 1], error[PLANTED_DEGREE_MAX + 1];
    struct root found[PLANTED_DEGREE_MAX + 1];
    struct root_search search = {0, follow, &trail};
    double order = 0, floor = -0.75 * REAL_BITS / planted_kind_roots(kind);
    trail.count = 0;
    planted_roots_make(kind, n, 20, c, error);
    f->find(n, c, error, real_ldexp(1, 4 - REAL_BITS), scratch, PLANTED_DEGREE_MAX + 1, found, &search);
    for (int i = 2; i < trail.count; i++) {
        const double *w = &trail.width[i - 2];
        if (w[2] >= floor && w[0] <= -3)
            order = (w[2] - w[1]) / (w[1] - w[0]);
    }
    *clips = trail.count;
    *clips = trail.count;
    return order;
}

/* Orders 2, 3, 4 at a simple root; 3/2 and 2 at a double, 4/3 at a triple one by quadratic and cubic
 * clipping.  Elsewhere convergence is linear: 1.  In less than 2,048 bits there are few widths, or too few.
 */
static void check_order(int k, enum planted_kind kind, int n)
{
    static const double theory[3][3] = {{2, 3, 4}, {1, 1.5, 2}, {1, 1, 4.0 / 3}};
    int clips;
    double order = order_of(root_finders[k], kind, n, &clips), most = theory[kind][k];
    const double allowed = REAL_BITS > 1000 ? 0.03 : 0.2;
    if (REAL_BITS < 1000 && most > 1 && order == 0)
        return;
    if (most > 1 ? !(fabs(order - most) <= allowed * most) : clips < REAL_BITS / 8)
        fail_msg("%s, %s root, degree %d: order %.3f in %d clips, theory %.3f", root_finders[k]->name,
                 planted_kind_name(kind), n, order, clips, most);
}

static void test_order(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++)
        for (int kind = SIMPLE_ROOT; kind <= TRIPLE_ROOT; kind++)
            for (int n = 8; n <= 16; n *= 2)
                check_order(k, (enum planted_kind)kind, n);
}

/* All in one enclosure if there is room for one only. */
static void test_room(void **state)
{
    (void)state;
    static real scratch[SCRATCH];
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(2, "room", (uint64_t)i);
        struct planted p;
        struct root found;
        make_planted(&p, &r);
        int count = roots_find(p.n, p.c, p.error, real_ldexp(1, -30), scratch, 1, &found);
        assert_true(count <= 1 && count_lost(&p, count, &found) == 0);
        planted_clear(&p);
    }
}

/* Well separated simple roots with coefficients rounded once: as narrow as asked, and each proved to be one.
 */
static void test_narrow(void **state)
{
    (void)state;
    static real scratch[SCRATCH];
    const real tolerance = real_ldexp(1, -REAL_BITS / 2);
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(3, "narrow", (uint64_t)i);
        struct planted p;
        struct root found[DEGREE + 1];
        planted_init(&p);
        for (int k = 1; k <= 4; k++)
            plant(&p, ((real)k + prop_unit(&r, 16) / 2) / 8);
        plant_nothing(&p, &r, 3);
        blur(&p, &r, 0);
        int count = roots_find(p.n, p.c, p.error, tolerance, scratch, DEGREE + 1, found);
        assert_int_equal(count, 4);
        for (int j = 0; j < count; j++)
            assert_true(found[j].single && found[j].at_most == 1 && found[j].hi - found[j].lo <= tolerance);
        planted_clear(&p);
    }
}

/* A double root is counted as two once the enclosure is seen from far enough. */
static void test_double_root(void **state)
{
    (void)state;
    static real scratch[SCRATCH];
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(4, "double", (uint64_t)i);
        struct planted p;
        struct root found[DEGREE + 1];
        real root = ((real)1 + 2 * prop_unit(&r, 16)) / 4;
        planted_init(&p);
        plant(&p, root);
        plant(&p, root);
        plant_nothing(&p, &r, 4);
        blur(&p, &r, real_ldexp(1, -REAL_BITS + 8));
        int count = roots_find(p.n, p.c, p.error, real_ldexp(1, -REAL_BITS), scratch, DEGREE + 1, found);
        assert_int_equal(count, 1);
        assert_int_equal(found[0].at_most, 2);
        assert_false(found[0].single);
        assert_true(found[0].hi - found[0].lo < real_ldexp(1, -REAL_BITS / 2 + 12));
        planted_clear(&p);
    }
}

/* Negative control: with the errors of the coefficients kept from it, the finder loses roots. */
static void test_margins_are_needed(void **state)
{
    (void)state;
    static real scratch[SCRATCH];
    int lost = 0;
    for (int i = 0; i < trials(1000); i++) {
        struct random_state r = random_for(5, "margins", (uint64_t)i);
        struct planted p;
        struct root found[DEGREE + 1];
        make_planted(&p, &r);
        for (int k = 0; k <= p.n; k++)
            p.error[k] = 0;
        lost += count_lost(&p, roots_find(p.n, p.c, p.error, real_ldexp(1, -30), scratch, DEGREE + 1, found),
                           found);
        planted_clear(&p);
    }
    assert_true(lost > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_planted),     cmocka_unit_test(test_order),
        cmocka_unit_test(test_room),        cmocka_unit_test(test_narrow),
        cmocka_unit_test(test_double_root), cmocka_unit_test(test_margins_are_needed),
    };
    return cmocka_run_group_tests_name("roots", tests, NULL, NULL);
}
