/* A curve that is one point, or no more than rounding of one.
 *
 * Every parameter of it goes with each parameter of the other curve at which that passes: arcs of no length.
 * The other curve is halved; a part whose octagon misses the point's holds no solution.  Parts as narrow as
 * asked, or no larger than rounding, that touch make one overlap: all of the point's domain, over which the
 * two are nowhere farther apart than the octagons allow. */
#include "evaluate.h"

struct passing {
    struct solver *z;
    const struct source *curve;
    const struct node *point;
    bool point_is_f;
    struct interval run; /* lo > hi: there is none */
    real distance;
};

/* The largest distance of two points of the octagons. */
static real span(const struct node *a, const struct node *b)
{
    real sum = 0;
    for (int k = 0; k < 2; k++) {
        sum += real_max(a->high[k] - b->low[k], b->high[k] - a->low[k]);
    }
    return sum * (1 + 8 * REAL_EPSILON);
}

static void run_end(struct passing *p)
{
    const struct interval whole = {0, 1};
    struct crossings *out = p->z->out;
    if (p->run.lo > p->run.hi) {
        return;
    }
    const struct interval *t = p->point_is_f ? &whole : &p->run, *s = p->point_is_f ? &p->run : &whole;
    if (out->overlaps < OVERLAPS_MAX) {
        const struct overlap o = {*t, *t, *s, *s, false, false, p->distance};
        out->overlap[out->overlaps++] = o;
    } else {
        const struct crossing c = {*t, *s, CANDIDATE, 0, 0};
        record_add(p->z, &c);
    }
    p->run.lo = 1;
    p->run.hi = 0;
}

static void run_go_on(struct passing *p, const struct interval *part, real distance)
{
    if (p->run.lo <= p->run.hi && part->lo > p->run.hi) {
        run_end(p);
    }
    bool fresh = p->run.lo > p->run.hi;
    p->run.lo = fresh ? part->lo : p->run.lo;
    p->run.hi = part->hi;
    p->distance = fresh ? distance : real_max(p->distance, distance);
}

static bool is_small(const struct passing *p, const struct node *a)
{
    const struct bounds *b = &p->z->p->bounds;
    real size = real_max(a->high[0] - a->low[0], a->high[1] - a->low[1]);
    return a->hi - a->lo <= (p->point_is_f ? b->tolerance_s : b->tolerance_t) ||
           size <= 8 * p->curve->node_error;
}

/* In order of the parameter. */
static void follow(struct passing *p)
{
    enum { DEPTH_MAX = 2 * REAL_BITS };
    struct interval waiting[DEPTH_MAX];
    real numbers[7 * DEGREE_MAX + 3];
    struct node part;
    int count = 1;
    waiting[0].lo = 0;
    waiting[0].hi = 1;
    part.points = numbers;
    while (count > 0) {
        struct interval at = waiting[--count];
        bool last = p->z->w->steps >= p->z->p->max_steps, over = last || count + 2 > DEPTH_MAX;
        p->z->w->steps += !last;
        node_cut(p->curve, at.lo, at.hi, &part);
        if (!nodes_meet(p->point, &part)) {
            continue;
        }
        if (over || is_small(p, &part)) {
            p->z->outcome = is_small(p, &part) ? p->z->outcome : OUT_OF_STEPS;
            run_go_on(p, &at, span(p->point, &part));
            continue;
        }
        real middle = at.lo + (at.hi - at.lo) / 2;
        waiting[count].lo = middle;
        waiting[count++].hi = at.hi;
        waiting[count].lo = at.lo;
        waiting[count++].hi = middle;
    }
    part.points = NULL;
    run_end(p);
}

static bool is_point(const struct source *c, const struct node *a)
{
    return real_max(a->high[0] - a->low[0], a->high[1] - a->low[1]) <= 4 * c->node_error;
}

bool point_settle(struct solver *z)
{
    const struct level *v = &z->level[0];
    const struct node *f = &z->f.node[z->root_f], *g = &z->g.node[z->root_g];
    bool of_f = is_point(&v->f, f);
    if (!of_f && !is_point(&v->g, g)) {
        return false;
    }
    struct passing p = {z, of_f ? &v->g : &v->f, of_f ? f : g, of_f, {1, 0}, 0};
    follow(&p);
    return true;
}
