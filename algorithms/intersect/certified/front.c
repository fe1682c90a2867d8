/* Which kernel, if any; and what is the same for all of them: the order of the curves, and the way back. */
#include "../../crossings.h"
#include "front.h"

bool front_run(struct front *z)
{
#ifdef FATLINE_AVX2
    /* libgcc asks the processor before main begins; this only reads what it found */
    if (z->f->degree <= 3 && z->g->degree <= 3 && __builtin_cpu_supports("avx2") &&
        __builtin_cpu_supports("fma")) {
        return front_cubic_avx2(z);
    }
#endif
    (void)z;
    return false;
}

/* The order of problem_solve for polynomial curves over [0, 1]: by degree, then by the first coordinate that
 * differs. */
static bool comes_after(const struct curve *a, const struct curve *b)
{
    if (a->degree != b->degree) {
        return a->degree > b->degree;
    }
    for (int i = 0; i <= a->degree; i++) {
        if (a->x[i] != b->x[i]) {
            return a->x[i] > b->x[i];
        }
    }
    for (int i = 0; i <= a->degree; i++) {
        if (a->y[i] != b->y[i]) {
            return a->y[i] > b->y[i];
        }
    }
    return false;
}

static bool is_plain(const struct curve *c)
{
    return !c->w && c->domain.lo == 0 && c->domain.hi == 1 && c->degree >= 1 && c->degree <= DEGREE_MAX;
}

static void finish(struct crossings *out, bool swapped)
{
    for (int i = 0; swapped && i < out->count; i++) {
        struct interval t = out->at[i].t;
        out->at[i].t = out->at[i].s;
        out->at[i].s = t;
    }
    if (out->count > 1) {
        crossings_sort(out);
    }
}

enum front_answer front_of_certified(const struct problem *p, struct workspace *w, struct crossings *out,
                                     struct rest *rest)
{
    const real narrowest = 4 * REAL_EPSILON, widest = (real)1 / 16; /* as in problem.c */
    if (!is_plain(&p->f) || !is_plain(&p->g) || !(p->tolerance > 0) || !real_is_finite(p->tolerance) ||
        p->max_steps <= 0) {
        return FRONT_REFUSED;
    }
    bool swapped = !p->keep_order && comes_after(&p->f, &p->g);
    real tolerance = real_min(widest, real_max(narrowest, p->tolerance));
    struct front z = {
        swapped ? &p->g : &p->f, swapped ? &p->f : &p->g, tolerance, tolerance, 0, p->max_steps, out, rest};
    rest->count = 0;
    if (!front_run(&z)) {
        return FRONT_REFUSED;
    }
    w->steps = z.steps;
    if (rest->count > 0) {
        return FRONT_LEFT;
    }
    w->swapped = swapped;
    finish(out, swapped);
    return FRONT_DONE;
}

bool front_of_prepared(const struct problem *p, struct workspace *w, struct crossings *out, struct rest *rest)
{
    struct front z = {&p->f, &p->g, p->bounds.tolerance_t, p->bounds.tolerance_s, w->steps, p->max_steps,
                      out,   rest};
    rest->count = 0;
    if (p->f.w || p->g.w || !front_run(&z)) {
        return false;
    }
    w->steps = z.steps;
    return true;
}
