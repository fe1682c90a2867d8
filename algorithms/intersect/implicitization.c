/* Implicitization: the curve b is put into the implicit equation det M = 0 of the curve a of lower degree;
 * the roots of this resultant are the parameters v on b; for each, the parameter u on a comes from the null
 * space of M, or, at double points of a, from the line through b(v).  Krawczyk's test has the last word on
 * each box (u, v).
 *
 * No root is lost: the resultant comes with a bound on its coefficients, its roots in enclosures that cover
 * it, and u in an interval for all v of an enclosure.  Where these bounds decide nothing, the answer is
 * UNSUPPORTED. */
#include "../bezier.h"
#include "../core/contact.h"
#include "../core/implicit.h"
#include "../core/krawczyk.h"
#include "../core/lowered.h"
#include "../core/patch.h"
#include "../core/roots.h"
#include "../crossings.h"

enum { ROOTS_MAX = DEGREE_MAX * DEGREE_MAX + 1, DEPTH_MAX = 16 };

struct state {
    const struct bounds *bounds;
    struct arc f, g;
    struct crossings *out;
    struct lowered given[2], side[2];
    const struct lowered *a_given, *b_given; /* as they are */
    const struct lowered *a, *b;             /* in their lowest degrees, for the resultant */
    struct interval place;                   /* of the part of b whose polynomial is solved */
    struct lowered part;
    bool a_is_f;
    real tolerance_u, tolerance_v;
    int degree; /* of the resultant */
    real *scratch;
    enum outcome outcome;
};

/* ---- records ---- */

static bool meet(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

/* Is a zero in (t, s), proved unique, one that is on record?  Then one box around both holds one zero. */
static bool is_known(const struct state *z, const struct interval *t, const struct interval *s)
{
    for (int i = 0; i < z->out->count; i++) {
        const struct crossing *c = &z->out->at[i];
        if ((c->standing == UNIQUE || c->standing == END) && meet(&c->t, t) && meet(&c->s, s)) {
            struct interval a = {real_min(t->lo, c->t.lo), real_max(t->hi, c->t.hi)};
            struct interval b = {real_min(s->lo, c->s.lo), real_max(s->hi, c->s.hi)};
            if (krawczyk_narrow(&z->f, &z->g, &a, &b) == ONE_ZERO) {
                return true;
            }
        }
    }
    return false;
}

/* Cut to [0, 1]; false if nothing is left.  inside: nothing was cut off. */
static bool cut_to_domain(struct interval *t, bool *inside)
{
    *inside = *inside && t->lo >= 0 && t->hi <= 1;
    t->lo = real_max(t->lo, 0);
    t->hi = real_min(t->hi, 1);
    return t->lo <= t->hi;
}

/* A zero of multiplicity k moves by the k-th root of a relative error: up to 2^20 eps it is told where it may
 * be. */
static bool is_no_wider_than_conditioning(real width, int k)
{
    real power = 1;
    for (int i = 0; i < k; i++) {
        power = power * width;
    }
    return power <= (real)1048576 * REAL_EPSILON;
}

/* Narrows b's parameter in the box to where b may meet a's arc; false: nowhere.  Pieces are kept together. */
static bool clip_to_patch(const struct state *z, const struct lowered *a, const struct interval *u,
                          const struct lowered *b, real tolerance, struct interval *v)
{
    struct patch h;
    struct interval part[MEETINGS_MAX];
    real lo = 1, hi = 0;
    patch_cut(a, u->lo, u->hi, &h);
    int count = patch_meet(&h, b, tolerance, z->scratch, part);
    for (int i = 0; i < count; i++) {
        if (meet(&part[i], v)) {
            lo = real_min(lo, real_max(part[i].lo, v->lo));
            hi = real_max(hi, real_min(part[i].hi, v->hi));
        }
    }
    v->lo = lo;
    v->hi = hi;
    return lo <= hi;
}

/* Clips the box to and fro as long as it gets narrower; UNDECIDED, but narrow, if Krawczyk's test does not
 * take it. */
static enum proof settle(const struct state *z, struct interval *u, struct interval *v, struct crossing *x)
{
    enum proof proof = UNDECIDED;
    for (real before = 4; proof == UNDECIDED && u->hi - u->lo + v->hi - v->lo < before / 2;) {
        before = u->hi - u->lo + v->hi - v->lo;
        x->t = z->a_is_f ? *u : *v;
        x->s = z->a_is_f ? *v : *u;
        proof = krawczyk_narrow(&z->f, &z->g, &x->t, &x->s);
        if (proof == UNDECIDED && (!clip_to_patch(z, z->a_given, u, z->b_given, z->tolerance_v / 8, v) ||
                                   !clip_to_patch(z, z->b_given, v, z->a_given, z->tolerance_u / 8, u))) {
            proof = NO_ZERO;
        }
    }
    if (proof == UNDECIDED) {
        x->t = z->a_is_f ? *u : *v;
        x->s = z->a_is_f ? *v : *u;
    }
    return proof;
}

/* A box of at most k zeros.  Where it is wider than asked, and not for a proved zero's conditioning only, the
 * precision is exhausted: the answer goes no further than its records. */
static void admit(struct state *z, int k, const struct crossing *x)
{
    real t = x->t.hi - x->t.lo, s = x->s.hi - x->s.lo;
    bool narrow = t <= z->bounds->tolerance_t && s <= z->bounds->tolerance_s;
    bool sharp = is_no_wider_than_conditioning(real_max(t, s), k);
    if (!narrow && (x->standing == CANDIDATE || !sharp)) {
        z->outcome = !sharp && x->standing == CANDIDATE ? UNSUPPORTED
                     : z->outcome == SOLVED             ? OUT_OF_STEPS
                                                        : z->outcome;
    }
    crossings_add(z->out, x);
}

/* A box that stays undecided, because there is a contact or next to one, or none by less than rounding. */
static void admit_undecided(struct state *z, const struct root *r, struct crossing *x)
{
    if (!z->a->reduced && !z->b->reduced && z->place.hi - z->place.lo == 1) {
        x->at_most = r->at_most;
    }
    admit(z, r->at_most, x);
}

static void record(struct state *z, const struct root *r, struct interval u, struct interval v, int depth);

/* Next to a contact: where the gap between the arcs may vanish.  false: that is no narrower than the box. */
static bool divide_by_gap(struct state *z, const struct root *r, const struct interval *u,
                          const struct interval *v, int depth)
{
    struct contact_piece piece[CONTACT_DEGREE_MAX + 1];
    const real before = u->hi - u->lo + v->hi - v->lo;
    real after = 0;
    int count = contact_meet(z->b_given, v, z->a_given, u, z->tolerance_v / 8, z->scratch, piece);
    bool by_a = count < 0; /* a has a cusp there: then along b */
    if (by_a) {
        count = contact_meet(z->a_given, u, z->b_given, v, z->tolerance_u / 8, z->scratch, piece);
    }
    for (int i = 0; i < count; i++) {
        after += piece[i].t.hi - piece[i].t.lo + piece[i].s.hi - piece[i].s.lo;
    }
    if (count < 0 || 8 * after > 7 * before) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        record(z, r, by_a ? piece[i].t : piece[i].s, by_a ? piece[i].s : piece[i].t, depth + 1);
    }
    return true;
}

/* Records what the box u x v holds. */
static void record(struct state *z, const struct root *r, struct interval u, struct interval v, int depth)
{
    struct crossing x = {u, v, CANDIDATE, 0, 0};
    bool inside = true;
    enum proof proof = settle(z, &u, &v, &x);
    if (proof == UNDECIDED && (depth >= DEPTH_MAX || !divide_by_gap(z, r, &u, &v, depth))) {
        admit_undecided(z, r, &x);
    } else if (proof == ONE_ZERO && cut_to_domain(&x.t, &inside) && cut_to_domain(&x.s, &inside) &&
               !is_known(z, &x.t, &x.s)) {
        x.standing = inside ? UNIQUE : END;
        x.at_most = x.multiplicity = 1;
        admit(z, 1, &x);
    }
}

/* The other parameter: by inversion, or, where that is ambiguous, wherever a may meet this arc of b. */
static void solve_root(struct state *z, const struct root *r)
{
    struct interval u[MEETINGS_MAX], v = {r->lo, r->hi};
    struct patch h;
    int count = 1;
    patch_cut(z->b_given, r->lo, r->hi, &h);
    enum inversion found =
        implicit_invert(&z->a->polygon, h.px, h.py, h.radius, z->scratch, &u[0].lo, &u[0].hi);
    if (found == NOWHERE) {
        return;
    }
    if (found == AMBIGUOUS) {
        count = patch_meet(&h, z->a_given, z->tolerance_u / 8, z->scratch, u);
    }
    for (int i = 0; i < count; i++) {
        record(z, r, u[i], v, 0);
    }
}

/* Products w x were rounded once: u |x| <= (eps scale / 2) w. */
static struct arc arc_of_curve(const struct curve *c, real scale)
{
    struct arc a = {c->degree, c->x, c->y, c->w, c->w ? REAL_EPSILON * scale : (real)0};
    return a;
}

/* Is a to be made implicit, rather than b?  The lower degree costs less; a larger curve is better
 * conditioned. */
static bool is_easier(const struct lowered *a, const struct lowered *b)
{
    return a->polygon.degree != b->polygon.degree ? a->polygon.degree < b->polygon.degree
                                                  : a->size >= b->size;
}

/* Restricts b to where it may meet a, if it is far larger: else its polynomial would say little of what
 * happens at a. The part's place in b is z->place.  false: it meets a nowhere. */
static bool choose_part(struct state *z)
{
    const struct interval all = {0, 1};
    z->place = all;
    if (z->b->size <= 16 * z->a->size) {
        return true;
    }
    if (!clip_to_patch(z, z->a, &all, z->b, (real)1 / 1024, &z->place)) {
        return false;
    }
    lowered_cut(z->b, z->place.lo, z->place.hi, &z->part);
    return true;
}

/* From the part's parameters to b's: three roundings of at most u hi. */
static struct root to_place(const struct interval *place, const struct root *r)
{
    struct root b = *r;
    real width = place->hi - place->lo, pad = 2 * REAL_EPSILON * place->hi;
    if (place->lo > 0 || place->hi < 1) {
        b.lo = real_max(place->lo, place->lo + width * r->lo - pad);
        b.hi = real_min(place->hi, place->lo + width * r->hi + pad);
    }
    return b;
}

static enum outcome intersect_by(const struct root_finder *finder, const struct problem *p,
                                 struct workspace *w, struct crossings *out)
{
    struct state z;
    struct root root[ROOTS_MAX];
    z.bounds = &p->bounds;
    z.f = arc_of_curve(&p->f, p->bounds.scale);
    z.g = arc_of_curve(&p->g, p->bounds.scale);
    z.out = out;
    z.outcome = SOLVED;
    lowered_init(&z.f, p->bounds.scale, &z.side[0]);
    lowered_init(&z.g, p->bounds.scale, &z.side[1]);
    z.a_is_f = is_easier(&z.side[0], &z.side[1]);
    lowered_take(&z.f, &z.given[0]);
    lowered_take(&z.g, &z.given[1]);
    z.a_given = &z.given[!z.a_is_f];
    z.b_given = &z.given[z.a_is_f];
    z.a = &z.side[!z.a_is_f];
    z.b = &z.side[z.a_is_f];
    z.tolerance_u = z.a_is_f ? p->bounds.tolerance_t : p->bounds.tolerance_s;
    z.tolerance_v = z.a_is_f ? p->bounds.tolerance_s : p->bounds.tolerance_t;
    const int d = z.a->polygon.degree;
    z.degree = d * z.b->polygon.degree;
    if (d > implicit_degree_max()) {
        return UNSUPPORTED;
    }
    real *c = w->scratch, *error = c + z.degree + 1;
    z.scratch = error + z.degree + 1;
    if (!choose_part(&z)) {
        return SOLVED;
    }
    real width = z.place.hi - z.place.lo;
    const struct polygon *part = width < 1 ? &z.part.polygon : &z.b->polygon;
    implicit_resultant(&z.a->polygon, part, z.scratch, c, error);
    real tolerance = width > 0 ? z.tolerance_v / (8 * width) : (real)1;
    int count = 1;
    if (implicit_vanishes(z.degree, c, error)) {
        const struct root anywhere = {0, 1, z.degree, false};
        root[0] = anywhere;
    } else {
        count = finder->find(z.degree, c, error, tolerance, z.scratch, ROOTS_MAX, root, NULL);
    }
    for (int i = 0; i < count; i++) {
        struct root r = to_place(&z.place, &root[i]);
        w->steps++;
        solve_root(&z, &r);
    }
    if (z.outcome == UNSUPPORTED) {
        out->count = 0;
    }
    return z.outcome;
}

static size_t scratch(int n, int m)
{
    int d = n < m ? n : m, e = n < m ? m : n;
    size_t resultant = implicit_scratch(d < implicit_degree_max() ? d : implicit_degree_max(), e);
    size_t roots = roots_scratch(n * m + n + m);
    return 2 * ((size_t)(n * m) + 1) + (resultant > roots ? resultant : roots);
}

#define IMPLICITIZATION(id, finder, how)                                                                     \
    static enum outcome id##_intersect(const struct problem *p, struct workspace *w, struct crossings *out)  \
    {                                                                                                        \
        return intersect_by(root_finders[finder], p, w, out);                                                \
    }                                                                                                        \
    extern const struct intersector id;                                                                      \
    const struct intersector id = {                                                                          \
        #id,                                                                                                 \
        "resultant in Bernstein form, its roots" how ", inversion; every box proved or owned up to",         \
        "T. W. Sederberg, S. R. Parry: Comparison of three curve intersection algorithms, 1986",             \
        {0, 0, 0, 0},                                                                                        \
        id##_intersect,                                                                                      \
        scratch,                                                                                             \
        false,                                                                                               \
        false};

IMPLICITIZATION(implicitization, 0, "")
IMPLICITIZATION(implicitization_quadratic, 1, " by quadratic clipping")
IMPLICITIZATION(implicitization_cubic, 2, " by cubic clipping")
