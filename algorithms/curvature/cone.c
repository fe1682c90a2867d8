#include "cone.h"

real triple_normalise(real *a)
{
    real square = triple_dot(a, a);
    if (!(square > 0)) {
        return 0;
    }
    real length = real_sqrt(square), factor = 1 / length;
    for (int i = 0; i < 3; i++) {
        a[i] = a[i] * factor;
    }
    return length;
}

void triple_meet(const real *a, real error_a, const real *b, real error_b, real *out, real *error)
{
    triple_cross(a, b, out);
    real length = triple_normalise(out), most = 4 * REAL_EPSILON + error_a + error_b;
    *error = length > most ? most / length : (real)1;
}

void half_plane_infinity(struct half_plane *p)
{
    p->l[0] = p->l[1] = p->error = p->t = 0;
    p->l[2] = 1;
    p->source = AT_INFINITY;
    p->corner = false;
    p->span = 0;
}

void cone_init(struct cone *c)
{
    c->count = 1;
    c->missed = false;
    half_plane_infinity(&c->edge[0].plane);
    c->edge[0].v[0] = c->edge[0].v[1] = c->edge[0].v[2] = c->edge[0].error = 0;
    c->edge[0].holds = c->edge[0].fresh = false;
}

static void set_vertex(struct cone *c, int i)
{
    struct cone_edge *e = &c->edge[i], *next = &c->edge[i + 1 < c->count ? i + 1 : 0];
    triple_meet(e->plane.l, e->plane.error, next->plane.l, next->plane.error, e->v, &e->error);
    e->holds = false;
    e->fresh = true;
}

static void set_plane(struct cone *c, int i, const struct half_plane *p)
{
    c->edge[i].plane = *p;
}

/* -1, 0 or 1: the side of p on which v lies, 0 within rounding. */
static int side(const struct half_plane *p, const real *v, real error)
{
    real s = triple_dot(p->l, v), bound = 4 * REAL_EPSILON + p->error + error;
    return s > bound ? 1 : s < -bound ? -1 : 0;
}

/* 0 x + 0 y - 1 > 0. */
static bool is_nowhere(const struct half_plane *p)
{
    return p->l[0] == 0 && p->l[1] == 0 && p->l[2] < 0;
}

static enum clip clip_whole(struct cone *c, const struct half_plane *p)
{
    real v[3], error;
    triple_meet(c->edge[0].plane.l, c->edge[0].plane.error, p->l, p->error, v, &error);
    if (error >= 1) {
        c->missed = is_nowhere(p);
        return triple_dot(c->edge[0].plane.l, p->l) > 0 ? CLIP_NOTHING : CLIP_EMPTY;
    }
    c->count = 2;
    set_plane(c, 1, p);
    set_vertex(c, 0);
    set_vertex(c, 1);
    return CLIP_CUT;
}

/* In the middle of edge i of a cone of two half-planes. */
static void middle(const struct cone *c, int i, real *m)
{
    triple_cross(c->edge[0].v, c->edge[i].plane.l, m);
    if (triple_dot(m, c->edge[1 - i].plane.l) < 0) {
        for (int k = 0; k < 3; k++) {
            m[k] = -m[k];
        }
    }
    triple_normalise(m);
}

/* p passes through the vertices of a cone of two half-planes. */
static enum clip clip_pencil(struct cone *c, const struct half_plane *p)
{
    real m[2][3];
    int s[2];
    for (int i = 0; i < 2; i++) {
        middle(c, i, m[i]);
        s[i] = side(p, m[i], c->edge[0].error);
    }
    if (s[0] >= 0 && s[1] >= 0) {
        return CLIP_NOTHING;
    }
    if (s[0] <= 0 && s[1] <= 0) {
        return CLIP_EMPTY;
    }
    set_plane(c, s[0] < 0 ? 0 : 1, p);
    set_vertex(c, 0);
    set_vertex(c, 1);
    return CLIP_CUT;
}

/* Edges are kept that have a vertex inside; they are consecutive, `first` of them, `kept` in number. */
static void find_kept(const struct cone *c, const struct half_plane *p, int *first, int *kept)
{
    int n = c->count, before = side(p, c->edge[n - 1].v, c->edge[n - 1].error);
    *first = *kept = 0;
    for (int i = 0; i < n; i++) {
        int after = side(p, c->edge[i].v, c->edge[i].error);
        if (after > 0 && before <= 0) {
            *first = i;
        }
        *kept += after > 0 || before > 0;
        before = after;
    }
}

static enum clip clip_general(struct cone *c, const struct half_plane *p)
{
    int n = c->count, first, kept;
    find_kept(c, p, &first, &kept);
    if (kept + 1 > c->room || n + 1 > c->room) {
        return CLIP_FULL;
    }
    if (kept == n) { /* one edge at least is cut in two: n >= 2 edges stay, and p */
        for (int i = n; i > first; i--) {
            c->edge[i] = c->edge[i - 1];
        }
        c->count = n + 1;
        set_plane(c, first, p);
        set_vertex(c, (first + n) % (n + 1));
        set_vertex(c, first);
        return CLIP_CUT;
    }
    if (first + kept <= n) { /* p takes the place of the first edge that goes, or of the last */
        for (int i = 0; i < kept; i++) {
            c->edge[i] = c->edge[first + i];
        }
    } else {
        int tail = n - first, head = kept - tail;
        for (int i = 0; i < tail; i++) {
            c->edge[head + 1 + i] = c->edge[first + i];
        }
        c->count = kept + 1;
        set_plane(c, head, p);
        set_vertex(c, (head + kept) % (kept + 1));
        set_vertex(c, head);
        return CLIP_CUT;
    }
    c->count = kept + 1;
    set_plane(c, kept, p);
    set_vertex(c, kept - 1);
    set_vertex(c, kept);
    return CLIP_CUT;
}

enum clip cone_clip(struct cone *c, const struct half_plane *p)
{
    bool inside = true, outside = true;
    c->missed = is_nowhere(p);
    if (c->count == 1) {
        return clip_whole(c, p);
    }
    if (c->count == 2 && side(p, c->edge[0].v, c->edge[0].error) == 0) {
        return clip_pencil(c, p);
    }
    c->missed = is_nowhere(p);
    bool strictly = true;
    for (int i = 0; i < c->count; i++) {
        int s = side(p, c->edge[i].v, c->edge[i].error);
        inside = inside && s >= 0;
        outside = outside && s <= 0;
        strictly = strictly && s < 0;
    }
    c->missed = c->missed || strictly;
    return inside ? CLIP_NOTHING : outside ? CLIP_EMPTY : clip_general(c, p);
}

bool cone_generator(const struct cone *c, int k, real *v, real *error)
{
    *error = 4 * REAL_EPSILON;
    if (c->count == 1) { /* both ways along both axes, and the origin */
        v[0] = k == 0 ? 1 : k == 1 ? -1 : 0;
        v[1] = k == 2 ? 1 : k == 3 ? -1 : 0;
        v[2] = k == 4 ? 1 : 0;
        return k < 5;
    }
    if (k < c->count) {
        for (int i = 0; i < 3; i++) {
            v[i] = c->edge[k].v[i];
        }
        *error = c->edge[k].error;
        return true;
    }
    if (c->count == 2 && k < 4) {
        middle(c, k - 2, v);
        *error = c->edge[0].error;
        return true;
    }
    return false;
}
