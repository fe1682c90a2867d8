#include "judge_strict.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "../cases/number.h"

struct trial {
    const struct test_case *c;
    const struct crossings *x;
    mpq_t pad;
    int broken;
    char *why;
    int held[CROSSINGS_MAX], weight[CROSSINGS_MAX];
};

bool interval_holds(const struct interval *a, const mpq_t q, const mpq_t pad)
{
    mpq_t end;
    mpq_init(end);
    real_to_rational(a->lo, end);
    mpq_sub(end, end, pad);
    bool inside = mpq_cmp(end, q) <= 0;
    real_to_rational(a->hi, end);
    mpq_add(end, end, pad);
    inside = inside && mpq_cmp(q, end) <= 0;
    mpq_clear(end);
    return inside;
}

__attribute__((format(printf, 2, 3))) static void broken(struct trial *j, const char *format, ...)
{
    va_list arguments;
    if (j->broken++)
        return;
    va_start(arguments, format);
    vsnprintf(j->why, 256, format, arguments);
    va_end(arguments);
}

static bool is_in_overlap(const struct trial *j, const mpq_t t, const mpq_t s)
{
    for (int i = 0; i < j->x->overlaps; i++)
        if (interval_holds(&j->x->overlap[i].t_outer, t, j->pad) &&
            interval_holds(&j->x->overlap[i].s_outer, s, j->pad))
            return true;
    return false;
}

static void try_solutions(struct trial *j)
{
    for (int k = 0; k < j->c->expected.count; k++) {
        const struct case_solution *x = &j->c->expected.at[k];
        int proofs = 0, others = 0;
        for (int i = 0; i < j->x->count; i++) {
            const struct crossing *r = &j->x->at[i];
            if (!interval_holds(&r->t, x->t, j->pad) || !interval_holds(&r->s, x->s, j->pad))
                continue;
            j->held[i]++;
            j->weight[i] += x->multiplicity ? x->multiplicity : 1;
            proofs += r->standing != CANDIDATE;
            others += r->standing == CANDIDATE;
        }
        if (proofs > 1)
            broken(j, "a solution in %d records that prove something, t = %.17g", proofs, mpq_get_d(x->t));
        if (proofs + others == 0 && !is_in_overlap(j, x->t, x->s))
            broken(j, "a solution in no record, t = %.17g", mpq_get_d(x->t));
    }
}

static void try_records(struct trial *j)
{
    for (int i = 0; i < j->x->count; i++) {
        const struct crossing *r = &j->x->at[i];
        double t = real_to_double(r->t.lo);
        int multiplicity = r->multiplicity ? r->multiplicity : 1;
        if (r->standing == UNIQUE && (j->held[i] != 1 || j->weight[i] != multiplicity))
            broken(j, "UNIQUE with %d solutions, of multiplicity %d, from t = %.17g", j->held[i],
                   j->weight[i], t);
        if (r->standing == END && j->weight[i] > 1)
            broken(j, "END with solutions of multiplicity %d, from t = %.17g", j->weight[i], t);
        if (r->standing == CLUSTER && j->weight[i] > r->at_most)
            broken(j, "CLUSTER of at most %d with %d, from t = %.17g", r->at_most, j->weight[i], t);
        if (i > 0 && r->t.lo < r[-1].t.lo)
            broken(j, "not sorted, at t = %.17g", t);
    }
}

static bool is_within(const struct overlap *r, const struct case_overlap *o, const mpq_t pad)
{
    return interval_holds(&r->t_outer, o->t0, pad) && interval_holds(&r->t_outer, o->t1, pad) &&
           interval_holds(&r->s_outer, o->s0, pad) && interval_holds(&r->s_outer, o->s1, pad);
}

/* t_inner and s_inner within o, and the same way round? */
static bool is_exact_part(const struct trial *j, const struct overlap *r, const struct case_overlap *o)
{
    bool backwards = mpq_cmp(o->s0, o->s1) > 0;
    mpq_t t, s;
    mpq_inits(t, s, NULL);
    real_to_rational(r->t_inner.lo, t);
    real_to_rational(r->s_inner.lo, s);
    mpq_add(t, t, j->pad);
    mpq_add(s, s, j->pad);
    bool part = mpq_cmp(t, o->t0) >= 0 && mpq_cmp(s, backwards ? o->s1 : o->s0) >= 0;
    real_to_rational(r->t_inner.hi, t);
    real_to_rational(r->s_inner.hi, s);
    mpq_sub(t, t, j->pad);
    mpq_sub(s, s, j->pad);
    part = part && mpq_cmp(t, o->t1) <= 0 && mpq_cmp(s, backwards ? o->s0 : o->s1) <= 0;
    mpq_clears(t, s, NULL);
    return part && r->reversed == backwards;
}

static bool ends_are_covered(const struct trial *j, const struct case_overlap *o)
{
    for (int end = 0; end < 2; end++) {
        mpq_srcptr t = end ? o->t1 : o->t0, s = end ? o->s1 : o->s0;
        bool covered = is_in_overlap(j, t, s);
        for (int i = 0; i < j->x->count && !covered; i++)
            covered = interval_holds(&j->x->at[i].t, t, j->pad) && interval_holds(&j->x->at[i].s, s, j->pad);
        if (!covered)
            return false;
    }
    return true;
}

static void try_overlaps(struct trial *j)
{
    const struct case_expected *e = &j->c->expected;
    for (int k = 0; k < e->overlaps; k++) {
        const struct case_overlap *o = &e->overlap[k];
        bool held = false;
        for (int i = 0; i < j->x->overlaps && !held; i++)
            held = is_within(&j->x->overlap[i], o, j->pad);
        if (!held && !ends_are_covered(j, o))
            broken(j, "an overlap is in no record, from t = %.17g", mpq_get_d(o->t0));
    }
    for (int i = 0; i < j->x->overlaps; i++) {
        const struct overlap *r = &j->x->overlap[i];
        bool found = !r->exact;
        for (int k = 0; k < e->overlaps && !found; k++)
            found = is_exact_part(j, r, &e->overlap[k]) && is_within(r, &e->overlap[k], j->pad);
        if (!found)
            broken(j, "an overlap called exact is none, from t = %.17g", real_to_double(r->t_outer.lo));
    }
}

int judge_strict(const struct test_case *c, const struct crossings *x, int digits, char why[256])
{
    static struct trial j;
    memset(j.held, 0, sizeof j.held);
    memset(j.weight, 0, sizeof j.weight);
    j.c = c;
    j.x = x;
    j.broken = 0;
    j.why = why;
    why[0] = 0;
    mpq_init(j.pad);
    mpz_ui_pow_ui(mpq_denref(j.pad), 10, (unsigned long)(digits - 2));
    mpz_set_ui(mpq_numref(j.pad), 1);
    try_solutions(&j);
    try_records(&j);
    try_overlaps(&j);
    mpq_clear(j.pad);
    return j.broken;
}
