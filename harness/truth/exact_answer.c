/* The answer as the fields "expected", "class" and "flags" of a line. */
#include "exact_answer.h"
#include "exact_parameter.h"
#include "../cases/json_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PREC_FIRST = 192, PREC_LAST = 1 << 14 };

/* ---- order and identity ---- */

/* Roots of one curve: the same number iff their balls, far below the distance of different ones, touch. */
static int compare_roots(const struct real_root *a, const struct real_root *b)
{
    if (a->exact && b->exact)
        return fmpq_cmp(a->value, b->value);
    return arb_overlaps(a->ball, b->ball) ? 0 : arb_lt(a->ball, b->ball) ? -1 : 1;
}

static int compare_points(const void *a, const void *b)
{
    const struct exact_point *p = a, *q = b;
    int order = compare_roots(&p->t, &q->t);
    return order ? order : compare_roots(&p->s, &q->s);
}

/* Two solutions are at one place iff they share t or s, or, where the pairs that would join them lie on an
 * arc, by their coordinates. */
static bool same_place(const struct exact_answer *a, const struct exact_point *p, const struct exact_point *q)
{
    return compare_roots(&p->t, &q->t) == 0 || compare_roots(&p->s, &q->s) == 0 ||
           (a->same_carrier && exact_same_place(a, p, q));
}

static int distinct_points(const struct exact_answer *answer, bool *shared)
{
    const struct point_list *l = &answer->points;
    int *place = calloc((size_t)l->count + 1, sizeof *place), count = l->count;
    for (int i = 0; i < l->count; i++)
        place[i] = i;
    for (int i = 0; i < l->count; i++)
        for (int j = 0; j < i; j++) {
            int from = place[i], to = place[j];
            if (from == to || !same_place(answer, &l->at[i], &l->at[j]))
                continue;
            for (int k = 0; k < l->count; k++)
                place[k] = place[k] == from ? to : place[k];
            count--;
        }
    free(place);
    *shared = count < l->count;
    return count;
}

/* ---- class and flags ---- */

/* Where two parts of one algebraic curve share an end (multiplicity 0) there is no contact of two curves: the
 * class is endpoint. */
struct traits {
    bool stationary, tangent, endpoint, shared, straight_f, straight_g;
};

static bool is_end(const struct real_root *r)
{
    return r->exact && (fmpq_is_zero(r->value) || fmpq_is_one(r->value));
}

/* The velocity keeps its direction. */
static bool is_straight(const struct exact_curve *c)
{
    fmpz_poly_t u[4];
    for (int i = 0; i < 4; i++)
        fmpz_poly_init(u[i]);
    const fmpz_poly_struct *coordinate[2] = {c->x, c->y};
    for (int i = 0; i < 2; i++) {
        fmpz_poly_derivative(u[i], coordinate[i]);
        fmpz_poly_mul(u[i], u[i], c->w);
        fmpz_poly_derivative(u[2], c->w);
        fmpz_poly_mul(u[2], u[2], coordinate[i]);
        fmpz_poly_sub(u[i], u[i], u[2]);
    }
    slong top =
        fmpz_poly_degree(u[0]) > fmpz_poly_degree(u[1]) ? fmpz_poly_degree(u[0]) : fmpz_poly_degree(u[1]);
    fmpz_t a, b;
    fmpz_init(a);
    fmpz_init(b);
    fmpz_poly_get_coeff_fmpz(a, u[0], top);
    fmpz_poly_get_coeff_fmpz(b, u[1], top);
    fmpz_poly_scalar_mul_fmpz(u[2], u[0], b);
    fmpz_poly_scalar_mul_fmpz(u[3], u[1], a);
    bool straight = fmpz_poly_equal(u[2], u[3]);
    fmpz_clear(a);
    fmpz_clear(b);
    for (int i = 0; i < 4; i++)
        fmpz_poly_clear(u[i]);
    return straight;
}

static struct traits traits_of(const struct exact_answer *a, const struct test_case *c)
{
    struct traits r = {0};
    for (int i = 0; i < a->points.count; i++) {
        const struct exact_point *p = &a->points.at[i];
        bool stationary = p->order_f > 0 || p->order_g > 0;
        r.stationary = r.stationary || stationary;
        r.tangent = r.tangent || (!stationary && p->multiplicity > 1);
        r.endpoint = r.endpoint || is_end(&p->t) || is_end(&p->s);
    }
    r.straight_f = c->f.degree > 1 && a->pair.f.n > 0 && is_straight(&a->pair.f);
    r.straight_g = c->g.degree > 1 && a->pair.g.n > 0 && is_straight(&a->pair.g);
    return r;
}

static const char *class_of(const struct exact_answer *a, const struct traits *r)
{
    if (a->point_curve || (r->stationary && a->ranges.count == 0))
        return "degenerate";
    if (a->ranges.count > 0)
        return "overlap";
    return r->tangent ? "tangent" : r->endpoint ? "endpoint" : a->points.count > 0 ? "transversal" : "none";
}

static json_t *flags_of(const struct exact_answer *a, const struct traits *r)
{
    const struct {
        bool is;
        const char *name;
    } flag[] = {
        {r->stationary, "cusp"},         {r->endpoint, "endpoint"},         {a->ranges.count > 0, "overlap"},
        {a->point_curve, "point-curve"}, {a->same_carrier, "same-carrier"}, {r->shared, "shared-point"},
        {r->straight_f, "straight-f"},   {r->straight_g, "straight-g"},     {r->tangent, "tangent"},
    };
    json_t *list = json_array();
    for (size_t i = 0; i < sizeof flag / sizeof *flag; i++)
        if (flag[i].is)
            json_array_append_new(list, json_string(flag[i].name));
    return list;
}

/* What a sound double program can be held to: 2^-44 cond at a simple crossing, about the root of the rounding
 * errors' order at a contact. */
static double tolerance_of(const struct exact_point *p, double cond)
{
    const double contact[] = {1e-6, 0, 1e-6, 1e-4, 1e-3};
    if (p->multiplicity == 1)
        return fmin(1e-3, fmax(1e-12, 0x1p-44 * cond));
    return contact[p->multiplicity > 4 ? 4 : p->multiplicity];
}

/* ---- the fields ---- */

static void add(json_t *object, const char *list, json_t *value)
{
    json_array_append_new(json_object_get(object, list), value);
}

/* To seven digits: figures for people. */
static double rounded(double a)
{
    char text[32];
    snprintf(text, sizeof text, "%.7g", a);
    return strtod(text, NULL);
}

static const char *put_point(struct exact_answer *a, struct test_case *c, struct exact_point *p, int digits,
                             json_t *expected)
{
    struct parameter t, s;
    struct case_solution *to = &c->expected.at[c->expected.count++];
    bool done = parameter_set(&t, &p->t, &c->f, digits, true);
    done = parameter_set(&s, &p->s, &c->g, digits, true) && done;
    struct exact_facts facts = exact_facts_of(a, c, p);
    mpq_inits(to->t, to->s, NULL);
    mpq_set(to->t, t.q);
    mpq_set(to->s, s.q);
    to->exact = t.exact && s.exact;
    to->multiplicity = p->multiplicity;
    to->cond = facts.cond;
    to->sine = facts.sine;
    c->expected.tol = fmax(c->expected.tol, tolerance_of(p, facts.cond));
    add(expected, "params", json_pack("[f, f]", t.nearest, s.nearest));
    add(expected, "exact", json_pack("[s, s]", t.text, s.text));
    add(expected, "points", json_pack("[f, f]", facts.x, facts.y));
    add(expected, "sin", json_number_or_null(rounded(facts.sine)));
    add(expected, "mult", p->multiplicity ? json_integer(p->multiplicity) : json_null());
    add(expected, "cond", json_number_or_null(rounded(facts.cond)));
    parameter_clear(&t);
    parameter_clear(&s);
    return done ? NULL : "a parameter could not be rounded";
}

static const char *put_range(struct test_case *c, struct exact_range *r, int digits, json_t *expected)
{
    struct real_root *end[4] = {&r->t0, &r->t1, &r->s0, &r->s1};
    struct case_overlap *to = &c->expected.overlap[c->expected.overlaps++];
    mpq_ptr q[4] = {to->t0, to->t1, to->s0, to->s1};
    struct parameter p[4];
    bool done = true;
    for (int i = 0; i < 4; i++) {
        bool refine = !fmpz_poly_is_zero(end[i]->p);
        done = parameter_set(&p[i], end[i], i < 2 ? &c->f : &c->g, digits, refine) && done;
        mpq_init(q[i]);
        mpq_set(q[i], p[i].q);
        to->exact = (i == 0 || to->exact) && p[i].exact;
    }
    add(expected, "overlap",
        json_pack("[f, f, f, f]", p[0].nearest, p[1].nearest, p[2].nearest, p[3].nearest));
    for (int i = 0; i < 4; i++)
        parameter_clear(&p[i]);
    return done ? NULL : "the end of an overlap could not be rounded";
}

static int compare_ranges(const void *a, const void *b)
{
    const struct exact_range *p = a, *q = b;
    int order = compare_roots(&p->t0, &q->t0);
    return order ? order : compare_roots(&p->s0, &q->s0);
}

const char *exact_answer_write(struct exact_answer *a, struct test_case *c, int digits)
{
    static const char *const lists[] = {"params", "exact", "points", "sin", "mult", "cond"};
    const char *trouble = NULL;
    json_t *expected = json_object();
    case_expected_clear(&c->expected);
    c->expected.known = true;
    c->expected.tol = 1e-12;
    c->expected.at = calloc((size_t)a->points.count + 1, sizeof *c->expected.at);
    c->expected.overlap = calloc((size_t)a->ranges.count + 1, sizeof *c->expected.overlap);
    struct traits traits = traits_of(a, c);
    json_object_set_new(expected, "count", json_integer(a->points.count));
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        json_object_set_new(expected, lists[i], json_array());
    if (a->ranges.count > 0)
        json_object_set_new(expected, "overlap", json_array());
    for (int i = 0; i < a->points.count; i++) {
        real_root_refine(&a->points.at[i].t, PREC_FIRST, false);
        real_root_refine(&a->points.at[i].s, PREC_FIRST, false);
    }
    if (a->points.count > 0)
        qsort(a->points.at, (size_t)a->points.count, sizeof *a->points.at, compare_points);
    if (a->ranges.count > 0)
        qsort(a->ranges.at, (size_t)a->ranges.count, sizeof *a->ranges.at, compare_ranges);
    int places = distinct_points(a, &traits.shared);
    for (int i = 0; i < a->points.count && !trouble; i++)
        trouble = put_point(a, c, &a->points.at[i], digits, expected);
    for (int i = 0; i < a->ranges.count && !trouble; i++)
        trouble = put_range(c, &a->ranges.at[i], digits, expected);
    json_object_set_new(expected, "tol", json_real(c->expected.tol));
    json_object_set_new(expected, "distinct_points", json_integer(places));
    free(c->class_name);
    c->class_name = strdup(class_of(a, &traits));
    json_object_set_new(c->line, "expected", expected);
    json_object_set_new(c->line, "class", json_string(c->class_name));
    json_object_set_new(c->line, "flags", flags_of(a, &traits));
    return trouble;
}
