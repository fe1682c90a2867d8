/* fatline_paths on short paths from bytes: records are sorted, of segments that there are; every solution
 * that fatline_intersect proves of two segments, or Newton's method finds on a segment and itself, lies in a
 * record (but for joints); a record holds no more of them than it says, and a UNIQUE the one sought from its
 * middle. */
#ifndef FATLINE_FUZZ_PATHS_H
#define FATLINE_FUZZ_PATHS_H

#include "fuzz_input.h"

enum { SEGMENTS_MAX = 5, SOLUTIONS_MAX = 512 };

struct fuzzed_path {
    struct drawn segment[SEGMENTS_MAX];
    double points[2 * LENGTH * SEGMENTS_MAX], weights[LENGTH * SEGMENTS_MAX];
    unsigned char degree[SEGMENTS_MAX];
    int subpath[SEGMENTS_MAX], joint[SEGMENTS_MAX]; /* the segment that begins where this one ends, or -1 */
    struct fatline_path path;
};

/* A place on both paths, inside both segments. */
struct solution {
    int i, j;
    struct quad_root at;
};

/* ---- paths from bytes ---- */

/* Begins where `before` ends, or is it again, or as it likes. */
static void draw_segment(struct input *in, const struct drawn *before, bool weights, struct drawn *c)
{
    uint8_t kind = take(in);
    int degree = kind < 3 ? kind * 16 : 1 + kind % 4; /* 0, 16 and 32 too */
    if (before && kind >= 224)
        draw_like(in, before, kind & 1, kind & 2, c);
    else
        draw(in, c, degree, weights && kind % 8 >= 4, kind >= 208);
    int n = before ? before->curve.degree : 0;
    for (int k = 0; before && kind < 192 && k < 2; k++)
        c->points[k] = before->points[2 * n + k];
}

/* Of rational curves it is the rounded products with weights that are compared. */
static bool is_same(double x, double y, bool rational)
{
    return x == y || (rational && fabs(x - y) <= 0x1p-40 * fabs(x));
}

static bool is_joint(const struct drawn *c, const struct drawn *d)
{
    const double *p = c->points + 2 * c->curve.degree, *q = d->points;
    bool rational = c->curve.weights || d->curve.weights;
    return is_same(p[0], q[0], rational) && is_same(p[1], q[1], rational);
}

static bool is_dot(const struct drawn *c)
{
    for (int k = 2; k < 2 * (c->curve.degree + 1); k++)
        if (!is_same(c->points[k], c->points[k % 2], c->curve.weights))
            return false;
    return true;
}

/* The segment that begins where segment i of first..last-1 ends, with nothing but points between; or -1. */
static int joint_after(const struct fuzzed_path *p, int first, int last, int i)
{
    int k = i, next;
    do {
        next = k + 1 < last ? k + 1 : first;
        if (!is_joint(&p->segment[k], &p->segment[next]))
            return -1;
        k = next;
    } while (k != i && is_dot(&p->segment[k]));
    return k;
}

static void draw_path(struct input *in, struct fuzzed_path *p)
{
    uint8_t kinds = take(in);
    int count = take(in) % (SEGMENTS_MAX + 1), used = 0,
        split = kinds & 1 ? 1 + take(in) % SEGMENTS_MAX : count;
    for (int i = 0; i < count; i++) {
        struct drawn *c = &p->segment[i];
        draw_segment(in, i > 0 ? &p->segment[i - 1] : NULL, kinds & 2, c);
        int n = c->curve.degree;
        if (i + 1 == count && (kinds & 4)) {
            c->points[2 * n] = p->segment[0].points[0];
            c->points[2 * n + 1] = p->segment[0].points[1];
        }
        p->degree[i] = (unsigned char)n;
        for (int k = 0; k <= n; k++, used++) {
            p->points[2 * used] = c->points[2 * k];
            p->points[2 * used + 1] = c->points[2 * k + 1];
            p->weights[used] = c->curve.weights ? c->weights[k] : 1;
        }
    }
    p->subpath[0] = 0;
    p->subpath[1] = split;
    struct fatline_path path = {count,
                                p->points,
                                p->degree,
                                kinds & 2 ? p->weights : NULL,
                                count == 0      ? 0
                                : split < count ? 2
                                                : 1,
                                kinds & 8 || split < count ? p->subpath : NULL};
    p->path = path;
    for (int i = 0; i < count; i++)
        p->joint[i] =
            i < split ? joint_after(p, 0, split < count ? split : count, i) : joint_after(p, split, count, i);
}

/* Nothing else is a path. */
static bool is_path(const struct fuzzed_path *p)
{
    for (int i = 0; i < p->path.count; i++) {
        const struct fatline_curve *c = &p->segment[i].curve;
        double extent = 0;
        bool rational = false;
        if (!is_valid(c, FATLINE_DEGREE_MAX))
            return false;
        for (int k = 0; k <= c->degree; k++) {
            extent = fmax(extent, fmax(fabs(c->points[2 * k]), fabs(c->points[2 * k + 1])));
            rational = rational || (c->weights && c->weights[k] != c->weights[0]);
        }
        if (rational && extent != 0 && (extent < 0x1p-700 || extent > 0x1p1000))
            return false;
    }
    return true;
}

/* ---- a call ---- */

struct fuzzed_answer {
    enum fatline_outcome outcome;
    struct fatline_paths_answer a;
};

/* In memory of just the sizes asked for. */
static void solve_paths(const struct fatline_path *a, const struct fatline_path *b,
                        const struct fatline_options *o, struct fuzzed_answer *out)
{
    static struct arena workspace, memory;
    size_t size = fatline_paths_workspace_size(a, b);
    memset(out, 0, sizeof *out);
    if (size == 0) {
        require(fatline_paths_memory_size(a, b, 0) == 0);
        out->outcome = FATLINE_INVALID;
        return;
    }
    out->a.size = fatline_paths_memory_size(a, b, 0);
    out->a.memory = exactly(&memory, out->a.size);
    struct fatline_paths_workspace *w = fatline_paths_workspace_init(exactly(&workspace, size), size);
    require(w != NULL);
    out->outcome = fatline_paths(w, a, b, o, 0, &out->a);
    while (out->outcome == FATLINE_OUT_OF_ROOM) {
        out->a.size *= 2;
        out->a.memory = exactly(&memory, out->a.size);
        out->outcome = fatline_paths(w, a, b, o, out->a.done, &out->a);
    }
    require((out->a.error != NULL) == (out->outcome == FATLINE_INVALID));
    require(out->outcome == FATLINE_INVALID ||
            out->outcome == (out->a.open > 0 ? FATLINE_OUT_OF_STEPS : FATLINE_SOLVED));
}

/* ---- what records say ---- */

static bool is_span(const struct fatline_path_span *s, int count)
{
    return 0 <= s->first && s->first < count && 0 <= s->last && s->last < count && 0 <= s->lo && s->lo <= 1 &&
           0 <= s->hi && s->hi <= 1 && (s->first != s->last || s->lo <= s->hi);
}

static bool is_later(const struct fatline_path_span *s, const struct fatline_path_span *r)
{
    return s->first != r->first ? s->first > r->first : s->lo > r->lo;
}

static void check_records(const struct fatline_paths_answer *a, int count_a, int count_b)
{
    for (int i = 0; i < a->count; i++) {
        const struct fatline_path_crossing *c = &a->crossing[i];
        require(is_span(&c->a, count_a) && is_span(&c->b, count_b));
        require(c->at_most >= 0 && c->overlap >= -1 && c->overlap < a->overlaps && c->chain >= 0);
        require(c->overlap < 0 || c->standing == FATLINE_CANDIDATE);
        require((c->standing != FATLINE_UNIQUE && c->standing != FATLINE_END) || c->at_most == 1);
        require(i == 0 || !is_later(&c[-1].a, &c->a));
        require(i == 0 || is_later(&c->a, &c[-1].a) || !is_later(&c[-1].b, &c->b));
    }
    for (int i = 0; i < a->overlaps; i++) {
        const struct fatline_path_overlap *o = &a->overlap[i];
        require(0 <= o->a_inner_lo && o->a_inner_hi <= 1 && 0 <= o->b_inner_lo && o->b_inner_hi <= 1);
        require(o->distance >= 0);
    }
}

/* Is t of segment i on the span, or within `pad` of it? */
static bool span_holds(const struct fatline_path_span *s, int count, int i, quad t, quad pad)
{
    if (s->first == s->last)
        return i == s->first && s->lo - pad <= t && t <= s->hi + pad;
    int at = (i - s->first + count) % count, last = (s->last - s->first + count) % count;
    return at == 0 ? t >= s->lo - pad : at == last ? t <= s->hi + pad : at < last;
}

struct search {
    const struct fuzzed_path *a, *b; /* the same: one path */
    const struct fatline_paths_answer *answer;
    int count;
    struct solution at[SOLUTIONS_MAX];
};

static bool record_holds(const struct search *z, const struct fatline_path_crossing *c,
                         const struct solution *x, quad pad)
{
    int n = z->a->path.count, m = z->b->path.count;
    bool as_given = span_holds(&c->a, n, x->i, x->at.t, pad) && span_holds(&c->b, m, x->j, x->at.s, pad);
    return as_given || (z->a == z->b && span_holds(&c->a, n, x->j, x->at.s, pad) &&
                        span_holds(&c->b, n, x->i, x->at.t, pad));
}

/* The end of one segment at the beginning of the next one. */
static bool is_at_joint(const struct search *z, const struct solution *x)
{
    const quad near = (quad)1 / (1LL << 40);
    return z->a == z->b && ((z->a->joint[x->i] == x->j && x->at.t > 1 - near && x->at.s < near) ||
                            (z->a->joint[x->j] == x->i && x->at.s > 1 - near && x->at.t < near));
}

/* It has to be in a record; inside both segments it is kept, to be counted. */
static void add_solution(struct search *z, const struct solution *x)
{
    const quad same = (quad)1 / (1LL << 60), inside = (quad)1 / (1LL << 40);
    bool told = is_at_joint(z, x);
    for (int k = 0; k < z->answer->count && !told; k++)
        told = record_holds(z, &z->answer->crossing[k], x, quad_pad);
    require(told);
    for (int k = 0; k < z->count; k++)
        if (z->at[k].i == x->i && z->at[k].j == x->j && quad_abs(z->at[k].at.t - x->at.t) < same &&
            quad_abs(z->at[k].at.s - x->at.s) < same)
            return;
    if (z->count < SOLUTIONS_MAX && quad_inside(0, 1, 0, 1, &x->at, -inside))
        z->at[z->count++] = *x;
}

/* ---- pairs of segments ---- */

static bool quad_pair(const struct fuzzed_path *a, int i, const struct fuzzed_path *b, int j,
                      struct quad_curve *f, struct quad_curve *g)
{
    const struct fatline_curve *c = &a->segment[i].curve, *d = &b->segment[j].curve;
    quad size = quad_size(d, quad_size(c, 0));
    if (!(size > 0))
        return false;
    quad_curve_make(c, size, f);
    quad_curve_make(d, size, g);
    return true;
}

/* From the middles of what fatline_intersect proves. */
static void search_pair(struct search *z, int i, int j, const struct fatline_options *o)
{
    static struct kept single;
    static struct quad_curve f, g;
    const struct fatline_curve *c = &z->a->segment[i].curve, *d = &z->b->segment[j].curve;
    if (!quad_pair(z->a, i, z->b, j, &f, &g))
        return;
    solve(c->degree > d->degree ? c->degree : d->degree, c, d, o, &single);
    for (int k = 0; k < single.answer.count && k < 20; k++) {
        const struct fatline_crossing *r = &single.crossing[k];
        struct solution x = {i, j, {((quad)r->t_lo + r->t_hi) / 2, ((quad)r->s_lo + r->s_hi) / 2}};
        if (r->standing == FATLINE_UNIQUE && quad_newton(&f, &g, &x.at) && quad_inside(0, 1, 0, 1, &x.at, 0))
            add_solution(z, &x);
    }
}

/* Where a segment crosses itself, from some places. */
static void search_loop(struct search *z, int i)
{
    static const double starts[][2] = {{0, 1}, {0.2, 0.8}, {0.4, 0.9}, {0.1, 0.6}};
    static struct quad_curve f, g;
    if (z->a->segment[i].curve.degree < 2 || !quad_pair(z->a, i, z->a, i, &f, &g))
        return;
    for (int k = 0; k < 4; k++) {
        struct solution x = {i, i, {starts[k][0], starts[k][1]}};
        if (quad_newton(&f, &g, &x.at) && quad_inside(0, 1, 0, 1, &x.at, 0) &&
            x.at.s - x.at.t > (quad)1 / (1 << 20))
            add_solution(z, &x);
    }
}

/* ---- are they true? ---- */

static void check_unique(const struct search *z, const struct fatline_path_crossing *c)
{
    static struct quad_curve f, g;
    struct solution x = {
        c->a.first, c->b.first, {((quad)c->a.lo + c->a.hi) / 2, ((quad)c->b.lo + c->b.hi) / 2}};
    if (c->a.first != c->a.last || c->b.first != c->b.last || !quad_pair(z->a, x.i, z->b, x.j, &f, &g))
        return;
    if (PLANTED)
        x.at.t = c->a.lo / 2;
    if (PLANTED || quad_newton(&f, &g, &x.at))
        require(record_holds(z, c, &x, quad_pad));
}

static void check_counts(const struct search *z)
{
    for (int r = 0; r < z->answer->count; r++) {
        const struct fatline_path_crossing *c = &z->answer->crossing[r];
        int held = 0;
        if (c->standing == FATLINE_CANDIDATE || c->at_most == 0)
            continue;
        for (int k = 0; k < z->count; k++)
            held += record_holds(z, c, &z->at[k], -quad_pad);
        require(held <= c->at_most);
        if (c->standing == FATLINE_UNIQUE)
            check_unique(z, c);
    }
}

static void try_paths(struct input *in)
{
    static struct fuzzed_path first, second;
    static struct search z;
    struct fuzzed_answer answer;
    struct fatline_options o = draw_options(in);
    o.max_steps = least(o.max_steps, STEPS_OF_MANY);
    bool alone = take(in) % 2;
    draw_path(in, &first);
    if (!alone)
        draw_path(in, &second);
    const struct fuzzed_path *b = alone ? &first : &second;
    solve_paths(&first.path, alone ? NULL : &second.path, &o, &answer);
    require((is_path(&first) && is_path(b)) == (answer.outcome != FATLINE_INVALID));
    if (answer.outcome != FATLINE_INVALID) {
        z.a = &first;
        z.b = b;
        z.answer = &answer.a;
        z.count = 0;
        check_records(&answer.a, first.path.count, b->path.count);
        for (int i = 0; i < first.path.count; i++) {
            for (int j = alone ? i + 1 : 0; j < b->path.count; j++)
                search_pair(&z, i, j, &o);
            if (alone)
                search_loop(&z, i);
        }
        check_counts(&z);
    }
}

#endif
