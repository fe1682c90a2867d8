/* Cutting planes for half-planes given as functions.
 *
 * On [a, b] a function lies above the lesser of its end values by no less than -bound (b - a)^2 / 8, the
 * bound that of its second derivative: so does h = L . v for a vertex v, and so does the length of L, seen
 * along any one direction.  Cells are halved until one or the other decides. */
#include "boundary.h"
#include "signs.h"

enum { CELLS = 32, STACK = 128, NARROWINGS = 40 };

struct seeker {
    const struct region_functions *f;
    struct region_work *k;
    real v[3], lowest, where; /* of h over |L| */
};

/* The line at t in [0, 1], in normalised coordinates; returns its length. */
static real line_at(const struct region_functions *f, const struct region_work *k, real t, real *l)
{
    real value[3];
    f->line(f->data, f->interval.lo + t * (f->interval.hi - f->interval.lo), value);
    l[0] = value[0] * k->scale;
    l[1] = value[1] * k->scale;
    l[2] = value[0] * k->centre_x + value[1] * k->centre_y + value[2];
    return real_sqrt(triple_dot(l, l));
}

/* By how much a line may leave the chord between its ends on a cell of [0, 1]. */
static real sag(const struct seeker *s, real lo, real hi)
{
    const struct region_functions *f = s->f;
    real whole = f->interval.hi - f->interval.lo, width = (hi - lo) * whole, bend[3];
    f->bend(f->data, f->interval.lo + lo * whole, f->interval.lo + hi * whole, bend);
    real last = bend[0] * real_abs(s->k->centre_x) + bend[1] * real_abs(s->k->centre_y) + bend[2];
    return ((bend[0] + bend[1]) * s->k->scale + last) * width * width / 8;
}

static void note(struct seeker *s, real t, real height)
{
    if (height < s->lowest) {
        s->lowest = height;
        s->where = t;
    }
}

/* No line of the cell is missed by more than the tolerance. */
static bool cell_holds(struct seeker *s, real lo, real hi)
{
    real a[3], b[3], sum[3], length_a = line_at(s->f, s->k, lo, a), length_b = line_at(s->f, s->k, hi, b);
    real at_lo = triple_dot(a, s->v), at_hi = triple_dot(b, s->v), off = sag(s, lo, hi);
    s->k->steps += 2;
    if (length_a > 0) {
        note(s, lo, at_lo / length_a);
    }
    if (length_b > 0) {
        note(s, hi, at_hi / length_b);
    }
    for (int i = 0; i < 3; i++) {
        sum[i] = a[i] + b[i];
    }
    triple_normalise(sum);
    real length = real_min(triple_dot(a, sum), triple_dot(b, sum)) - off;
    return real_min(at_lo, at_hi) - off >= -s->f->tolerance * real_max(length, 0);
}

/* The least height near a sampled one. */
static void narrow(struct seeker *s)
{
    real step = (real)1 / (2 * CELLS), l[3];
    for (int i = 0; i < NARROWINGS; i++) {
        real at = s->where;
        for (int side = -1; side <= 1; side += 2) {
            real t = real_min(1, real_max(0, at + side * step)), length = line_at(s->f, s->k, t, l);
            if (length > 0) {
                note(s, t, triple_dot(l, s->v) / length);
            }
        }
        step = s->where == at ? step / 2 : step;
        s->k->steps += 2;
    }
}

/* Is v allowed, but for the tolerance?  FAILS: s->where. */
static enum verdict look(struct seeker *s)
{
    real stack[2 * STACK];
    int waiting = 0;
    s->lowest = REAL_HUGE;
    for (int i = 0; i < CELLS; i++) {
        stack[waiting++] = (real)i / CELLS;
        stack[waiting++] = (real)(i + 1) / CELLS;
    }
    while (waiting > 0 && s->lowest >= -s->f->tolerance) {
        real hi = stack[--waiting], lo = stack[--waiting], middle = lo + (hi - lo) / 2;
        if (cell_holds(s, lo, hi)) {
            continue;
        }
        if (s->k->steps >= s->f->max_steps || waiting + 4 > 2 * STACK) {
            return UNSURE;
        }
        stack[waiting++] = lo;
        stack[waiting++] = middle;
        stack[waiting++] = middle;
        stack[waiting++] = hi;
    }
    if (s->lowest >= -s->f->tolerance) {
        return HOLDS;
    }
    narrow(s);
    return FAILS;
}

static enum clip cut_at(const struct seeker *s, real t)
{
    struct half_plane plane;
    if (!(line_at(s->f, s->k, t, plane.l) > 0)) {
        return CLIP_NOTHING;
    }
    triple_normalise(plane.l);
    plane.error = 8 * REAL_EPSILON;
    plane.source = MEMBER;
    plane.corner = false;
    plane.span = 0;
    plane.t = t;
    return cone_clip(&s->k->cone, &plane);
}

/* false: nothing is left. */
static bool cut(struct seeker *s, enum outcome *outcome, bool *sure)
{
    struct cone *c = &s->k->cone;
    real error;
    for (int i = 0; *outcome == SOLVED && cone_generator(c, i, s->v, &error); i++) {
        if (c->count > 1 && i < c->count && c->edge[i].holds) {
            continue;
        }
        enum verdict verdict = look(s);
        enum clip clip = verdict == FAILS ? cut_at(s, s->where) : CLIP_NOTHING;
        if (clip == CLIP_EMPTY) {
            return false;
        }
        *sure = *sure && (verdict == HOLDS || clip == CLIP_CUT);
        *outcome = clip == CLIP_FULL ? OUT_OF_ROOM : s->k->steps >= s->f->max_steps ? OUT_OF_STEPS : SOLVED;
        if (clip == CLIP_CUT) {
            i = -1;
        } else if (c->count > 1 && i < c->count) {
            c->edge[i].holds = true;
        }
    }
    return true;
}

enum outcome region_cut_functions(const struct region_functions *f, struct region_workspace *w,
                                  struct region *out)
{
    struct region_work *k = w->work;
    struct seeker s = {f, k, {0, 0, 0}, 0, 0};
    enum outcome outcome = SOLVED;
    bool some = true, sure = true;
    region_clear(out);
    w->steps = k->steps = 0;
    if (!(f->interval.lo < f->interval.hi) || !(f->size > 0) || !(f->tolerance > 0) || f->max_steps <= 0) {
        return INVALID;
    }
    k->centre_x = f->centre.x;
    k->centre_y = f->centre.y;
    k->scale = f->size;
    k->spans = 0;
    k->span[0].lo = f->interval.lo;
    k->span[0].hi = f->interval.hi;
    cone_init(&k->cone);
    for (int i = 0; some && i <= CELLS; i++) {
        some = cut_at(&s, (real)i / CELLS) != CLIP_EMPTY;
    }
    some = some && cut(&s, &outcome, &sure);
    if (some && !boundary_of_cone(&k->cone, out)) {
        outcome = OUT_OF_ROOM;
    }
    out->certified = some && sure && outcome == SOLVED;
    out->strict = some;
    out->closed_kind = out->kind;
    boundary_measure(k, 0, out);
    boundary_out(k, out);
    w->steps = k->steps;
    return outcome;
}
