/* What is the same for every method: is it a problem, memory, preparation, and the way back. */
#include <string.h>

#include "boundary.h"
#include "family.h"
#include "form.h"
#include "chords.h"

#include "../core/roots.h"

/* ---- is it a problem? ---- */

static bool all_finite(const real *c, int n)
{
    for (int i = 0; i < n; i++) {
        if (!real_is_finite(c[i])) {
            return false;
        }
    }
    return true;
}

static const char *check_knots(const struct control_family *f)
{
    int n = f->degree, run = 1;
    if (!all_finite(f->knots, f->count + n + 1)) {
        return "a knot is not finite";
    }
    for (int i = 1; i <= f->count + n; i++) {
        if (!(f->knots[i - 1] <= f->knots[i])) {
            return "the knots decrease";
        }
        run = f->knots[i] == f->knots[i - 1] ? run + 1 : 1;
        bool inner = f->knots[n] < f->knots[i] && f->knots[i] < f->knots[f->count];
        if (inner && run > n) {
            return "a knot inside is repeated more than degree times: the curve is torn there";
        }
    }
    return f->knots[n] < f->knots[f->count] ? NULL : "the knots leave no interval";
}

static const char *check_points(const struct control_family *f)
{
    bool apart = false;
    if (!all_finite(f->x, f->count) || !all_finite(f->y, f->count)) {
        return "a coordinate is not finite";
    }
    for (int i = 1; i < f->count; i++) {
        apart = apart || f->x[i] != f->x[0] || f->y[i] != f->y[0];
    }
    return apart ? NULL : "all control points are one: the curve has no length";
}

static const char *check_weights(const struct control_family *f)
{
    for (int i = 0; f->weight && i < f->count; i++) {
        if (!(f->weight[i] > 0) || !real_is_finite(f->weight[i])) {
            return "a weight that is not positive, expected > 0";
        }
    }
    return NULL;
}

static const char *check_handle(const struct control_family *f)
{
    bool moves = false;
    for (int i = 0; i < f->count; i++) {
        moves = moves || f->share[i] != 0;
    }
    return !all_finite(f->share, f->count) || !real_is_finite(f->at.x) || !real_is_finite(f->at.y)
               ? "a share that is not finite"
           : moves ? NULL
                   : "no control point moves";
}

const char *region_problem_check(const struct region_problem *p, const char **field)
{
    const struct control_family *f = &p->family;
    const char *wrong;
    *field = "degree";
    if (f->degree < 2 || f->degree > DEGREE_MAX) {
        return "out of range, expected 2 to 32";
    }
    *field = "points";
    if (f->count < f->degree + 1) {
        return "fewer than degree + 1";
    }
    if ((wrong = check_points(f)) != NULL) {
        return wrong;
    }
    *field = "knots";
    if ((wrong = check_knots(f)) != NULL) {
        return wrong;
    }
    *field = "weights";
    if ((wrong = check_weights(f)) != NULL) {
        return wrong;
    }
    *field = "free";
    if ((wrong = check_handle(f)) != NULL) {
        return wrong;
    }
    *field = "interval";
    if (!(p->interval.lo < p->interval.hi)) {
        return "empty, expected [a, b] with a < b";
    }
    if (p->interval.lo < f->knots[f->degree] || p->interval.hi > f->knots[f->count]) {
        return "not inside the knots' own interval";
    }
    *field = "sign";
    if (p->sign != 1 && p->sign != -1) {
        return "neither 1 nor -1";
    }
    *field = "tolerance";
    return p->tolerance >= 0 && p->tolerance < 1 && p->max_steps > 0 ? NULL : "not in [0, 1)";
}

/* ---- memory ---- */

enum { CONE_ROOM = REGION_EDGES_MAX, RELAXED_ROOM = 512, CELLS_ROOM = 128, CHORDS = 8 };

/* Lengths of what a workspace holds. */
struct sizes {
    int e, l, m, pascal, spans, pieces, chords;
    size_t span_reals, piece_reals, roots, scratch;
    const struct intersector *intersector;
};

static int larger(int a, int b)
{
    return a > b ? a : b;
}

static void sizes_find(int degree, int spans, struct sizes *s)
{
    bool rational = degree <= REGION_RATIONAL_MAX;
    s->e = larger(envelope_degree(degree, false), envelope_degree(degree, rational));
    s->l = larger(planes_degree(degree, false), planes_degree(degree, rational));
    s->m = larger(torsion_degree(degree, false), torsion_degree(degree, rational));
    s->pascal = larger(larger(s->m, s->l), 3 * s->e);
    s->spans = spans;
    s->pieces = 24 * spans + s->m + 2 * s->l + s->e + 40;
    s->chords = CHORDS * spans + 2 * s->l;
    s->span_reals = 3 * (size_t)(s->e + 1) + 4 * (size_t)(s->l + 1) + 2 * (size_t)(s->m + 1);
    s->piece_reals = 4 * (size_t)(s->l + 1) + 3 * (size_t)(s->e + 1);
    s->roots = roots_scratch(s->pascal);
    s->intersector = intersector_find("certified");
    s->intersector = s->intersector ? s->intersector : intersector_find("bezier_clipping");
    s->scratch = s->intersector->scratch ? s->intersector->scratch(s->e, s->e) : 0;
}

/* Gives out memory in aligned parts, or counts it if there is none yet. */
struct carver {
    char *at;
    size_t used;
};

static void *carve(struct carver *c, size_t bytes)
{
    enum { ALIGN = 64 };
    char *here = c->at ? c->at + c->used : NULL;
    c->used += (bytes + ALIGN - 1) / ALIGN * ALIGN;
    return here;
}

static void carve_spans(struct carver *c, const struct sizes *s, struct region_work *k)
{
    struct span *span = (struct span *)carve(c, (size_t)s->spans * sizeof(struct span));
    for (int i = 0; i < s->spans; i++) {
        real *pool = (real *)carve(c, s->span_reals * sizeof(real));
        if (k) {
            span[i].form.w = pool;
            span[i].form.L = pool + 3 * (s->e + 1);
            span[i].form.M = span[i].form.L + 4 * (s->l + 1);
            k->span = span;
        }
    }
}

/* The one layout, counted (w == NULL) and made. */
static size_t lay_out(void *memory, const struct sizes *s, struct region_workspace *w)
{
    struct carver c = {(char *)memory, 0};
    struct region_work *k = (struct region_work *)carve(&c, sizeof(struct region_work));
    real *pascal = (real *)carve(&c, pascal_size(s->pascal) * sizeof(real));
    carve_spans(&c, s, w ? k : NULL);
    struct piece *piece = (struct piece *)carve(&c, (size_t)s->pieces * sizeof(struct piece));
    size_t pool_length = (size_t)s->pieces * s->piece_reals;
    real *pool = (real *)carve(&c, pool_length * sizeof(real));
    struct half_plane *chord = (struct half_plane *)carve(&c, (size_t)s->chords * sizeof(struct half_plane));
    struct cone_edge *cone = (struct cone_edge *)carve(&c, CONE_ROOM * sizeof(struct cone_edge));
    struct cone_edge *relaxed = (struct cone_edge *)carve(&c, RELAXED_ROOM * sizeof(struct cone_edge));
    real *roots = (real *)carve(&c, s->roots * sizeof(real));
    struct crossings *crossings = (struct crossings *)carve(&c, sizeof(struct crossings));
    struct workspace *cells = (struct workspace *)carve(&c, sizeof(struct workspace));
    void *cells_memory = carve(&c, workspace_size(s->e, s->e, CELLS_ROOM, s->scratch));
    if (w) {
        w->work = k;
        pascal_fill(s->pascal, pascal);
        k->pascal = pascal;
        k->room_spans = s->spans;
        k->piece = piece;
        k->room_pieces = s->pieces;
        k->piece_pool = pool;
        k->piece_length = pool_length;
        k->chord = chord;
        k->room_chords = s->chords;
        k->cone.edge = cone;
        k->cone.room = CONE_ROOM;
        k->relaxed.edge = relaxed;
        k->relaxed.room = RELAXED_ROOM;
        k->roots = roots;
        k->crossings = crossings;
        k->cells = cells;
        k->intersector = s->intersector;
        workspace_init(cells, cells_memory, s->e, s->e, CELLS_ROOM, s->scratch);
    }
    return c.used;
}

size_t region_workspace_size(int degree, int spans)
{
    struct sizes s;
    sizes_find(degree, spans, &s);
    return lay_out(NULL, &s, NULL);
}

void region_workspace_init(struct region_workspace *w, void *memory, int degree, int spans)
{
    struct sizes s;
    sizes_find(degree, spans, &s);
    w->degree = degree;
    w->spans = spans;
    w->steps = 0;
    lay_out(memory, &s, w);
}

/* ---- preparation ---- */

/* A half-plane without direction must hold strictly on the whole closed span. */
static void check_fixed_spans(struct region_work *k)
{
    real bound[FORM_MAX], c[FORM_MAX], where;
    for (int i = 0; i < k->spans; i++) {
        const struct span_forms *f = &k->span[i].form;
        for (int j = 0; f->fixed && j <= f->l; j++) {
            bound[j] = f->L[3 * (f->l + 1) + j] * REAL_EPSILON;
            c[j] = f->L[2 * (f->l + 1) + j] - 2 * bound[j];
        }
        k->singular = k->singular || (f->fixed && form_holds(k, f->l, c, bound, &where) != HOLDS);
    }
}

enum outcome region_prepare(const struct region_problem *p, struct region_workspace *w)
{
    const char *field;
    struct region_work *k = w->work;
    w->steps = k->steps = 0;
    if (region_problem_check(p, &field)) {
        return INVALID;
    }
    if (p->family.weight && p->family.degree > REGION_RATIONAL_MAX) {
        return UNSUPPORTED;
    }
    if (p->family.degree > w->degree || family_spans(&p->family, &p->interval) > w->spans) {
        return OUT_OF_ROOM;
    }
    k->max_steps = p->max_steps;
    family_prepare(p, k);
    check_fixed_spans(k);
    k->chords = 0;
    return !p->loop_free || chords_make(k) ? SOLVED : OUT_OF_ROOM;
}

void region_clear(struct region *r)
{
    const struct point origin = {0, 0};
    r->kind = r->closed_kind = REGION_EMPTY;
    r->strict = r->certified = false;
    r->count = 0;
    r->area = r->disc_radius = 0;
    r->disc_centre = r->closed[0] = r->closed[1] = origin;
}

enum outcome region_solve(const struct region_problem *p, const struct region_method *method,
                          struct region_workspace *w, struct region *out)
{
    region_clear(out);
    enum outcome outcome = region_prepare(p, w);
    struct region_work *k = w->work;
    if (outcome != SOLVED) {
        return outcome;
    }
    out->strict = k->strict;
    outcome = method->find(p, w, out);
    if (outcome == SOLVED && out->kind == REGION_EMPTY) {
        out->count = 0;
        boundary_closed(k, out);
    } else {
        out->closed_kind = out->kind;
        boundary_measure(k, p->tolerance, out);
    }
    if (k->singular) {
        out->kind = REGION_EMPTY;
        out->strict = false;
        out->count = 0;
        out->area = out->disc_radius = 0;
    }
    boundary_out(k, out);
    w->steps = k->steps;
    return outcome;
}
