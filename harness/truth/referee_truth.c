#include "referee_truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/case_fields.h"
#include "../cases/number.h"
#include "referee_place.h"
#include "../run/memory.h"

/* sin: of the angle of the tangents.  cond: the largest row norm of the inverse of (f', -g'), with respect to
 * the parameters of the domains, times the pair's largest |coordinate|: what a relative change of the
 * coordinates grows into. */
static void condition(const struct test_case *c, const struct referee_pair *p, const struct quad_root *root,
                      struct case_solution *a)
{
    const double *f = root->tangent[0], *g = root->tangent[1];
    double cross = f[0] * g[1] - f[1] * g[0], speed_f = hypot(f[0], f[1]), speed_g = hypot(g[0], g[1]);
    mpq_t width;
    mpq_init(width);
    mpq_sub(width, c->f.hi, c->f.lo);
    double row_t = number_to_double(width) * speed_g;
    mpq_sub(width, c->g.hi, c->g.lo);
    double row_s = number_to_double(width) * speed_f;
    mpq_clear(width);
    a->sine = cross / (speed_f * speed_g);
    a->cond = fmax(row_t, row_s) / fabs(cross) * (p->size / p->unit);
}

/* q in [0, 1] to the curve's own parameter. */
static void to_domain(const struct case_curve *c, mpq_t q)
{
    mpq_t width;
    mpq_init(width);
    mpq_sub(width, c->hi, c->lo);
    mpq_mul(q, q, width);
    mpq_add(q, q, c->lo);
    mpq_clear(width);
}

static int compare(const void *a, const void *b)
{
    const struct case_solution *p = a, *q = b;
    int order = mpq_cmp(p->t, q->t);
    return order ? order : mpq_cmp(p->s, q->s);
}

/* ---- as JSON ------------------------------------------------------------------------------------------ */

/* A fraction, or 40 digits. */
static json_t *text_of(const mpq_t q, bool exact)
{
    char text[64], *fraction;
    json_t *v;
    if (exact) {
        fraction = mpq_get_str(NULL, 10, q);
        v = json_string(fraction);
        free(fraction);
        return v;
    }
    mpf_t a;
    mpf_init2(a, 320);
    mpf_set_q(a, q);
    gmp_snprintf(text, sizeof text, "%.39Fe", a);
    mpf_clear(a);
    return json_string(text);
}

static json_t *expected_json(const struct case_expected *e)
{
    json_t *params = json_array(), *exact = json_array(), *sine = json_array(), *mult = json_array();
    json_t *cond = json_array();
    for (int i = 0; i < e->count; i++) {
        const struct case_solution *a = &e->at[i];
        json_array_append_new(params, json_pack("[f,f]", number_to_double(a->t), number_to_double(a->s)));
        json_array_append_new(exact, json_pack("[o,o]", text_of(a->t, a->exact), text_of(a->s, a->exact)));
        json_array_append_new(sine, json_real(a->sine));
        json_array_append_new(mult, json_integer(1));
        json_array_append_new(cond, json_real(a->cond));
    }
    return json_pack("{s:i,s:o,s:o,s:o,s:o,s:o}", "count", e->count, "params", params, "exact", exact, "sin",
                     sine, "mult", mult, "cond", cond);
}

/* ---- the answer --------------------------------------------------------------------------------------- */

static bool at_end(const struct case_curve *c, const mpq_t q)
{
    return mpq_equal(q, c->lo) || mpq_equal(q, c->hi);
}

static void install(struct test_case *c, struct case_expected *e)
{
    const char *name = e->count ? "transversal" : "none";
    qsort(e->at, (size_t)e->count, sizeof *e->at, compare);
    for (int i = 0; i < e->count; i++)
        if (at_end(&c->f, e->at[i].t) || at_end(&c->g, e->at[i].s))
            name = "endpoint";
    e->known = true;
    case_expected_clear(&c->expected);
    c->expected = *e;
    free(c->class_name);
    c->class_name = strdup(name);
    if (c->line) {
        json_object_set_new(c->line, "expected", expected_json(e));
        json_object_set_new(c->line, "class", json_string(name));
    }
}

const char *referee_truth(struct test_case *c, const struct referee_pair *p, const struct quad_root *root,
                          int roots)
{
    struct case_expected e = {.tol = NAN};
    const char *why = NULL;

    e.at = memory_new((size_t)roots, sizeof *e.at);
    for (int i = 0; i < roots && !why; i++) {
        struct case_solution *a = &e.at[e.count];
        mpq_inits(a->t, a->s, NULL);
        switch (referee_place(p, &root[i], a)) {
        case INSIDE:
            a->multiplicity = 1;
            condition(c, p, &root[i], a);
            to_domain(&c->f, a->t);
            to_domain(&c->g, a->s);
            e.count++;
            break;
        case NOT_KNOWN:
            why = "a root is too near to an end of a domain, or too ill-conditioned";
            /* fall through */
        case OUTSIDE:
            mpq_clears(a->t, a->s, NULL);
        }
    }
    if (why)
        case_expected_clear(&e);
    else
        install(c, &e);
    return why;
}
