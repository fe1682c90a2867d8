/* Which kernel, if any; and what is the same for all of them: the order of the curves, and the way back. */
#include "../../crossings.h"
#include "front.h"

#ifdef FATLINE_AVX2
/* libgcc asks the processor before main begins; this only reads what it found. */
static bool has_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#endif

/* Are there kernels for many pairs of parts at once? */
static bool has_many(void)
{
#ifdef FATLINE_AVX2
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#endif
    return false;
}

bool front_run(struct front *z)
{
#ifdef FATLINE_AVX2
    if (z->f->degree <= 3 && z->g->degree <= 3 && has_avx2()) {
        return front_cubic_avx2(z);
    }
    if (has_avx2()) {
        return front_any_avx2(z);
    }
#endif
    (void)z;
    return false;
}

size_t front_scratch(int n, int m)
{
#ifdef FATLINE_AVX2
    if (n > 3 || m > 3) {
        return front_any_scratch(n, m);
    }
#endif
    return (void)n, (void)m, (size_t)0;
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

bool front_open(struct front *z, const struct problem *p, struct crossings *out, struct rest *rest)
{
    const real narrowest = 4 * REAL_EPSILON, widest = (real)1 / 16; /* as in problem.c */
    bool swapped = !p->keep_order && comes_after(&p->f, &p->g);
    z->f = swapped ? &p->g : &p->f;
    z->g = swapped ? &p->f : &p->g;
    z->tolerance_t = z->tolerance_s = real_min(widest, real_max(narrowest, p->tolerance));
    z->steps = 0;
    z->max_steps = p->max_steps;
    z->many = has_many();
    z->out = out;
    z->rest = rest;
    rest->count = 0;
    return swapped;
}

enum front_answer front_close(const struct front *z, bool swapped, struct workspace *w)
{
    w->steps = z->steps;
    if (z->rest->count > 0) {
        return FRONT_LEFT;
    }
    w->swapped = swapped;
    finish(z->out, swapped);
    return FRONT_DONE;
}

/* Not in line: pairs of cubics are not to pay for it. */
__attribute__((noinline)) static enum front_answer front_of_any(bool many, const struct problem *p,
                                                                struct workspace *w, struct crossings *out,
                                                                struct rest *rest)
{
    struct front z;
    if (!front_is_plain(p) || p->f.degree < 1 || p->g.degree < 1 || p->f.degree > DEGREE_MAX ||
        p->g.degree > DEGREE_MAX) {
        return FRONT_REFUSED;
    }
    bool swapped = front_open(&z, p, out, rest);
    z.many &= many;
    z.scratch = w->scratch;
    z.scratch_length = w->scratch_length;
    return front_run(&z) ? front_close(&z, swapped, w) : FRONT_REFUSED;
}

enum front_answer front_of_certified(const struct problem *p, struct workspace *w, struct crossings *out,
                                     struct rest *rest)
{
#ifdef FATLINE_AVX2
    if (p->f.degree == 3 && p->g.degree == 3 && has_avx2()) {
        return front_cubics(p, w, out, rest);
    }
#endif
    return front_of_any(true, p, w, out, rest);
}

enum front_answer front_of_certified_avx2(const struct problem *p, struct workspace *w, struct crossings *out,
                                          struct rest *rest)
{
#ifdef FATLINE_AVX2
    if (p->f.degree == 3 && p->g.degree == 3 && has_avx2()) {
        return front_cubics_avx2(p, w, out, rest);
    }
#endif
    return front_of_any(false, p, w, out, rest);
}

bool front_of_prepared(bool many, const struct problem *p, struct workspace *w, struct crossings *out,
                       struct rest *rest)
{
    struct front z = {&p->f,
                      &p->g,
                      p->bounds.tolerance_t,
                      p->bounds.tolerance_s,
                      w->steps,
                      p->max_steps,
                      out,
                      rest,
                      many && has_many(),
                      w->scratch,
                      w->scratch_length};
    rest->count = 0;
    if (p->f.w || p->g.w || !front_run(&z)) {
        return false;
    }
    w->steps = z.steps;
    return true;
}
