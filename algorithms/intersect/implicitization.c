/* Implicitization: the curve b is put into the implicit equation det M = 0 of the curve a of lower degree;
 * the roots of this resultant are the parameters v on b; for each, the parameter u on a comes from the null
 * space of M, or, at double points of a, from the line through b(v).  Krawczyk's test has the last word on
 * each box (u, v).
 *
 * No root is lost: the resultant comes with a bound on its coefficients, its roots in enclosures that cover
 * it, and u in an interval for all v of an enclosure.  Where these bounds decide nothing, the answer is
 * UNSUPPORTED. */
#include "../bezier.h"
#include "../core/bernstein.h"
#include "../core/implicit.h"
#include "../core/krawczyk.h"
#include "../core/lowered.h"
#include "../core/roots.h"
#include "../crossings.h"

enum { ROOTS_MAX = DEGREE_MAX * DEGREE_MAX + 1 };

/* An arc of b as a point and how far its control points are from it. */
struct patch {
    real x, y, radius, error;
    real dx[POINTS_MAX], dy[POINTS_MAX];
};

struct state {
    const struct problem *problem;
    struct crossings *out;
    struct lowered side[2];
    const struct lowered *a, *b;
    bool a_is_f;
    real tolerance_u, tolerance_v;
    int degree; /* of the resultant */
    real *scratch;
    bool undecided;
};

/* ---- the other parameter ---- */

/* Control points over an interval: 8n u |x| (bernstein.h), for quotients the same again. */
static void cut_patch(const struct lowered *s, real lo, real hi, struct patch *h)
{
    const int n = s->polygon.degree, middle = n / 2;
    real q[3 * POINTS_MAX];
    bernstein_restrict(n, s->components, s->homogeneous, lo, hi, q);
    h->error = s->polygon.error + (4 * n + 2) * (s->components == 3 ? 2 : 1) * REAL_EPSILON * s->extent;
    h->radius = 0;
    real w = s->components == 3 ? q[2 * (n + 1) + middle] : (real)1;
    h->x = q[middle] / w;
    h->y = q[n + 1 + middle] / w;
    for (int i = 0; i <= n; i++) {
        w = s->components == 3 ? q[2 * (n + 1) + i] : (real)1;
        h->dx[i] = q[i] / w - h->x;
        h->dy[i] = q[n + 1 + i] / w - h->y;
        h->radius = real_max(h->radius, real_max(real_abs(h->dx[i]), real_abs(h->dy[i])));
    }
    h->radius += h->error;
}

/* All u where a may meet the strip of normal (x, y) around the patch. */
static int meet_strip(const struct state *z, const struct patch *h, real x, real y, struct root *out)
{
    const struct polygon *a = &z->a->polygon;
    const real norm = real_abs(x) + real_abs(y);
    real c[POINTS_MAX], width = 0, error = 0;
    for (int i = 0; i <= z->b->polygon.degree; i++) {
        width = real_max(width, real_abs(x * h->dx[i] + y * h->dy[i]));
    }
    width += norm * (h->error + a->error + 4 * REAL_EPSILON * h->radius);
    for (int i = 0; i <= a->degree; i++) {
        real w = a->w ? a->w[i] : (real)1;
        real px = x * (a->x[i] - h->x), py = y * (a->y[i] - h->y);
        c[i] = w * (px + py);
        error = real_max(error, w * (width + 3 * REAL_EPSILON * (real_abs(px) + real_abs(py))));
    }
    return roots_find(a->degree, c, error, z->tolerance_u / 8, z->scratch, a->degree + 1, out);
}

/* Direction of b at v, the larger component 1; any one where b stands still. */
static void direction_at(const struct lowered *b, real v, real *x, real *y)
{
    const int n = b->polygon.degree;
    real value[3] = {0, 0, 1}, slope[3] = {0, 0, 0}, scratch[POINTS_MAX];
    for (int k = 0; k < b->components; k++) {
        value[k] = bernstein_value_slope(n, b->homogeneous + k * (n + 1), v, scratch, &slope[k]);
    }
    *x = slope[0] * value[2] - value[0] * slope[2];
    *y = slope[1] * value[2] - value[1] * slope[2];
    real size = real_max(real_abs(*x), real_abs(*y));
    *x = size > 0 ? *x / size : (real)1;
    *y = size > 0 ? *y / size : (real)0;
}

/* Where the strip along b and the one across it agree.  At a crossing the first is sharp, at a contact the
 * second. */
static int invert_by_strips(const struct state *z, const struct patch *h, real v, struct interval *u)
{
    struct root along[POINTS_MAX], across[POINTS_MAX];
    real x, y;
    int count = 0;
    direction_at(z->b, v, &x, &y);
    int n = meet_strip(z, h, -y, x, along), m = meet_strip(z, h, x, y, across);
    for (int i = 0, j = 0; i < n && j < m;) {
        real lo = real_max(along[i].lo, across[j].lo), hi = real_min(along[i].hi, across[j].hi);
        if (lo <= hi) {
            u[count].lo = lo;
            u[count++].hi = hi;
        }
        if (along[i].hi < across[j].hi) {
            i++;
        } else {
            j++;
        }
    }
    return count;
}

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
            if (krawczyk_narrow(&z->problem->f, &z->problem->g, &a, &b) == ONE_ZERO) {
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

/* A zero of multiplicity k moves by the k-th root of a relative error: 2^20 eps is the most that is let pass.
 */
static bool is_no_wider_than_conditioning(real width, int k)
{
    real power = 1;
    for (int i = 0; i < k; i++) {
        power = power * width;
    }
    return power <= (real)1048576 * REAL_EPSILON;
}

/* A box that Krawczyk's test leaves undecided: a cluster where the resultant bounds the number of zeros. */
static void add_undecided(struct state *z, const struct root *r, struct crossing *x)
{
    const struct bounds *bounds = &z->problem->bounds;
    real t = x->t.hi - x->t.lo, s = x->s.hi - x->s.lo;
    bool exact = !z->a->reduced && !z->b->reduced;
    if (exact && r->at_most < z->degree && is_no_wider_than_conditioning(real_max(t, s), r->at_most)) {
        x->standing = CLUSTER;
        x->at_most = r->at_most;
    } else if (t > bounds->tolerance_t || s > bounds->tolerance_s) {
        z->undecided = true;
    }
    crossings_add(z->out, x);
}

/* Records what the box u x v holds; false if it is undecided and then recorded only if `last`. */
static bool record(struct state *z, const struct root *r, const struct interval *u, bool last)
{
    struct interval v = {r->lo, r->hi};
    struct crossing x = {z->a_is_f ? *u : v, z->a_is_f ? v : *u, CANDIDATE, 0, 0};
    bool inside = true;
    enum proof proof = krawczyk_narrow(&z->problem->f, &z->problem->g, &x.t, &x.s);
    if (proof == NO_ZERO) {
        return true;
    }
    if (proof == UNDECIDED) {
        if (last) {
            add_undecided(z, r, &x);
        }
        return last;
    }
    if (cut_to_domain(&x.t, &inside) && cut_to_domain(&x.s, &inside) && !is_known(z, &x.t, &x.s)) {
        x.standing = inside ? UNIQUE : END;
        x.at_most = x.multiplicity = 1;
        crossings_add(z->out, &x);
    }
    return true;
}

static void solve_root(struct state *z, const struct root *r)
{
    struct interval u[POINTS_MAX], all = {0, 1};
    struct patch h;
    cut_patch(z->b, r->lo, r->hi, &h);
    enum inversion found = implicit_invert(&z->a->polygon, h.x, h.y, h.radius, z->scratch, &all.lo, &all.hi);
    if (found == NOWHERE || (found == INVERTED && record(z, r, &all, false))) {
        return;
    }
    int count = invert_by_strips(z, &h, (r->lo + r->hi) / 2, u);
    for (int i = 0; i < count; i++) {
        u[i].lo = real_max(u[i].lo, all.lo);
        u[i].hi = real_min(u[i].hi, all.hi);
        if (u[i].lo <= u[i].hi) {
            record(z, r, &u[i], true);
        }
    }
}

static enum outcome intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    struct state z;
    struct root root[ROOTS_MAX];
    z.problem = p;
    z.out = out;
    z.undecided = false;
    lowered_init(&p->f, p->bounds.scale, &z.side[0]);
    lowered_init(&p->g, p->bounds.scale, &z.side[1]);
    z.a_is_f = z.side[0].polygon.degree <= z.side[1].polygon.degree;
    z.a = &z.side[!z.a_is_f];
    z.b = &z.side[z.a_is_f];
    z.tolerance_u = z.a_is_f ? p->bounds.tolerance_t : p->bounds.tolerance_s;
    z.tolerance_v = z.a_is_f ? p->bounds.tolerance_s : p->bounds.tolerance_t;
    const int d = z.a->polygon.degree;
    z.degree = d * z.b->polygon.degree;
    if (d > implicit_degree_max()) {
        return UNSUPPORTED;
    }
    real *c = w->scratch;
    z.scratch = c + z.degree + 1;
    real error = implicit_resultant(&z.a->polygon, &z.b->polygon, z.scratch, c);
    if (implicit_vanishes(z.degree, c, error)) {
        return UNSUPPORTED;
    }
    int count = roots_find(z.degree, c, error, z.tolerance_v / 8, z.scratch, ROOTS_MAX, root);
    for (int i = 0; i < count; i++) {
        w->steps++;
        solve_root(&z, &root[i]);
    }
    if (z.undecided) {
        out->count = 0;
        return UNSUPPORTED;
    }
    return SOLVED;
}

static size_t scratch(int n, int m)
{
    int d = n < m ? n : m, e = n < m ? m : n;
    size_t resultant = implicit_scratch(d < implicit_degree_max() ? d : implicit_degree_max(), e);
    size_t roots = roots_scratch(n * m) + roots_scratch(e);
    return (size_t)(n * m) + 1 + (resultant > roots ? resultant : roots);
}

extern const struct intersector implicitization;
const struct intersector implicitization = {
    "implicitization",
    "resultant in Bernstein form, its roots, inversion; every box proved or owned up to",
    "T. W. Sederberg, S. R. Parry: Comparison of three curve intersection algorithms, 1986",
    {2, 1, 2.0 / 3, 1},
    intersect,
    scratch,
    false,
    false};
