/* Everything that is the same for every algorithm: validation, scale, order, and the way back. */
#include "bezier.h"
#include "crossings.h"

/* ---- is it a problem? ---- */

/* Weights may differ by this factor: then no product of two of them, nor a square, underflows. */
static const int weights_ratio_exponent = 256;

static void weights_measure(const struct curve *c, real *least, real *most)
{
    *least = *most = c->w[0];
    for (int i = 1; i <= c->degree; i++) {
        *least = real_min(*least, c->w[i]);
        *most = real_max(*most, c->w[i]);
    }
}

/* Degree, domain, finite coordinates and positive weights; *extent grows to the largest |coordinate| of the
 * Euclidean control points.  a - a is 0 for finite a and NaN for every other. */
static bool curve_measure(const struct curve *c, real *extent)
{
    if (c->degree < 1 || c->degree > DEGREE_MAX || !(c->domain.lo < c->domain.hi)) {
        return false;
    }
    real width = c->domain.hi - c->domain.lo, rest = width - width, most = *extent;
    for (int i = 0; i <= c->degree; i++) {
        real a = real_max(real_abs(c->x[i]), real_abs(c->y[i]));
        rest += (c->x[i] - c->x[i]) + (c->y[i] - c->y[i]);
        if (c->w) {
            rest += c->w[i] - c->w[i];
            if (!(c->w[i] > 0)) {
                return false;
            }
            a = a / c->w[i];
        }
        most = real_max(most, a);
    }
    *extent = most;
    if (rest == 0 && c->w) {
        real light, heavy;
        weights_measure(c, &light, &heavy);
        rest = light < real_ldexp(heavy, -weights_ratio_exponent);
    }
    return rest == 0 && real_is_finite(most);
}

/* ---- scale ---- */

/* The power of two that brings extent into [1, 2); bounded, so that it is finite for subnormal extents too.
 */
static int scale_exponent(real extent)
{
    if (!(extent > 0)) {
        return 0;
    }
    int e = 1 - real_exponent(extent);
    return e < 1000 ? e : 1000;
}

/* Copies c times 2^e, exactly; the weights are multiplied by a power of two that brings the largest into [1,
 * 2), so that no common factor of theirs makes products of them overflow or underflow. */
static real *curve_scale(const struct curve *c, int e, real *to, struct curve *out)
{
    int length = c->degree + 1, weigh = 0;
    real factor = real_ldexp(1, e);
    if (c->w) {
        real light, heavy;
        weights_measure(c, &light, &heavy);
        weigh = 1 - real_exponent(heavy);
    }
    out->degree = c->degree;
    out->domain = c->domain;
    for (int i = 0; i < length; i++) {
        to[i] = c->w ? real_ldexp(c->x[i], e + weigh) : c->x[i] * factor;
        to[length + i] = c->w ? real_ldexp(c->y[i], e + weigh) : c->y[i] * factor;
    }
    out->x = to;
    out->y = to + length;
    out->w = NULL;
    to += 2 * length;
    if (c->w) {
        for (int i = 0; i < length; i++) {
            to[i] = real_ldexp(c->w[i], weigh);
        }
        out->w = to;
        to += length;
    }
    return to;
}

/* The control points of a cell are cut from the originals with componentwise relative error 8n u and halved
 * at most HALVINGS_MAX = 4 times, n u each (bernstein.h); a rational curve's homogeneous coordinates came
 * rounded (u), and x and w both err against w > 0, whence the factor 2. */
static real cell_error(const struct curve *c, real scale)
{
    real coefficient = (12 * c->degree + 1) * (REAL_EPSILON / 2);
    return coefficient * scale * (c->w ? 2 : 1);
}

/* ---- order ---- */

/* A total order of curves that no positive scaling of the coordinates changes: < 0, 0, > 0. */
static int curve_compare(const struct curve *a, const struct curve *b)
{
    if (a->degree != b->degree) {
        return a->degree - b->degree;
    }
    if (!a->w != !b->w) {
        return a->w ? 1 : -1;
    }
    const real *ca[3] = {a->x, a->y, a->w}, *cb[3] = {b->x, b->y, b->w};
    for (int k = 0; k < (a->w ? 3 : 2); k++) {
        for (int i = 0; i <= a->degree; i++) {
            if (ca[k][i] != cb[k][i]) {
                return ca[k][i] < cb[k][i] ? -1 : 1;
            }
        }
    }
    if (a->domain.lo != b->domain.lo) {
        return a->domain.lo < b->domain.lo ? -1 : 1;
    }
    return a->domain.hi < b->domain.hi ? -1 : a->domain.hi > b->domain.hi;
}

/* ---- the way back ---- */

static void to_domain(const struct interval *domain, struct interval *t)
{
    real a = domain->lo, b = domain->hi;
    if (a == 0 && b == 1) {
        return;
    }
    /* u of b - a and of the product, at most 2 max each; u of the sum and of the end, at most max each */
    real pad = 4 * REAL_EPSILON * real_max(real_abs(a), real_abs(b));
    real lo = a + (b - a) * t->lo - pad, hi = a + (b - a) * t->hi + pad;
    t->lo = t->lo == 0 ? a : real_max(a, lo);
    t->hi = t->hi == 1 ? b : real_min(b, hi);
}

static void swap_intervals(struct interval *a, struct interval *b)
{
    struct interval c = *a;
    *a = *b;
    *b = c;
}

static void translate_back(const struct problem *p, bool swapped, real factor, struct crossings *out)
{
    for (int i = 0; i < out->count; i++) {
        struct crossing *c = &out->at[i];
        if (swapped) {
            swap_intervals(&c->t, &c->s);
        }
        to_domain(&p->f.domain, &c->t);
        to_domain(&p->g.domain, &c->s);
    }
    for (int i = 0; i < out->overlaps; i++) {
        struct overlap *o = &out->overlap[i];
        if (swapped) {
            swap_intervals(&o->t_outer, &o->s_outer);
            swap_intervals(&o->t_inner, &o->s_inner);
        }
        to_domain(&p->f.domain, &o->t_outer);
        to_domain(&p->f.domain, &o->t_inner);
        to_domain(&p->g.domain, &o->s_outer);
        to_domain(&p->g.domain, &o->s_inner);
        o->distance = o->distance / factor;
    }
    crossings_sort(out);
}

/* In [0, 1]: not below the rounding of a parameter, and not so wide that a record would say nothing. */
static real local_tolerance(real tolerance, const struct interval *domain)
{
    const real narrowest = 4 * REAL_EPSILON, widest = (real)1 / 16;
    return real_min(widest, real_max(narrowest, tolerance / (domain->hi - domain->lo)));
}

static void scale_both(const struct problem *p, int e, bool swapped, struct workspace *w, struct problem *q)
{
    const struct curve *first = swapped ? &p->g : &p->f, *second = swapped ? &p->f : &p->g;
    curve_scale(second, e, curve_scale(first, e, w->prepared, &q->f), &q->g);
}

/* The prepared problem q, in w's memory; true: the curves are exchanged. */
static bool prepare(const struct problem *p, real extent, int e, struct workspace *w, struct problem *q)
{
    const struct interval whole = {0, 1};
    bool swapped = !p->keep_order && curve_compare(&p->f, &p->g) > 0;
    *q = *p;
    scale_both(p, e, swapped, w, q);
    if (!p->keep_order && p->f.w && p->g.w &&
        curve_compare(&q->f, &q->g) > 0) { /* the scaled weights decide */
        swapped = !swapped;
        scale_both(p, e, swapped, w, q);
    }
    w->swapped = swapped;
    q->swapped = swapped;
    const struct interval first = q->f.domain, second = q->g.domain;
    q->f.domain = q->g.domain = whole;
    q->bounds.scale = extent * real_ldexp(1, e);
    q->bounds.f = cell_error(&q->f, q->bounds.scale);
    q->bounds.g = cell_error(&q->g, q->bounds.scale);
    q->bounds.tolerance_t = local_tolerance(p->tolerance, &first);
    q->bounds.tolerance_s = local_tolerance(p->tolerance, &second);
    return swapped;
}

/* What problem_solve is given, and what a front leaves. */
struct call {
    const struct problem *p;
    const struct intersector *a;
    struct workspace *w;
    struct crossings *out;
    struct rest rest;
};

/* Not in line: what a front settles is not to pay for it, not even for keeping these arguments in registers.
 */
__attribute__((noinline)) static enum outcome solve_prepared(const struct call *call, enum front_answer front)
{
    const struct problem *p = call->p;
    const struct intersector *a = call->a;
    struct workspace *w = call->w;
    struct crossings *out = call->out;
    real extent = 0;
    if (!(p->tolerance > 0) || !real_is_finite(p->tolerance) || p->max_steps <= 0 ||
        !curve_measure(&p->f, &extent) || !curve_measure(&p->g, &extent)) {
        return INVALID;
    }
    const int e = scale_exponent(extent);
    struct problem q;
    bool swapped = prepare(p, extent, e, w, &q);
    q.rest = front == FRONT_LEFT ? &call->rest : NULL;
    w->planned = w->plan == a && w->plan_n == q.f.degree && w->plan_m == q.g.degree;
    w->plan = a;
    w->plan_n = q.f.degree;
    w->plan_m = q.g.degree;
    enum outcome outcome = a->intersect(&q, w, out);
    translate_back(p, swapped, real_ldexp(1, e), out);
    return outcome == SOLVED && out->merged ? OUT_OF_ROOM : outcome;
}

enum outcome problem_solve(const struct problem *p, const struct intersector *a, struct workspace *w,
                           struct crossings *out)
{
    struct call call;
    call.p = p;
    call.a = a;
    call.w = w;
    call.out = out;
    out->count = out->overlaps = 0;
    out->merged = false;
    w->used = w->steps = 0;
    enum front_answer front = a->front ? a->front(p, w, out, &call.rest) : FRONT_REFUSED;
    return front == FRONT_DONE ? SOLVED : solve_prepared(&call, front);
}

const char *outcome_name(enum outcome o)
{
    static const char *const names[] = {"SOLVED",  "OUT_OF_STEPS", "OUT_OF_ROOM", "UNSUPPORTED",
                                        "INVALID", "GAVE_UP",      "CRASHED",     "TIMED_OUT"};
    return names[o];
}

const char *standing_name(enum standing s)
{
    static const char *const names[] = {"CANDIDATE", "UNIQUE", "END", "CLUSTER"};
    return names[s];
}
