/* Area and largest disc of a bounded region. */
#include "arcs.h"
#include "boundary.h"
#include "pieces.h"
#include "planes.h"

enum { ROUNDS = 200, SAMPLES = 8, LINES = 3, TANGENTS_MAX = 256 };

/* ---- area ---- */

static real area(const struct region_work *k, real tolerance, const struct region *r)
{
    real sum = 0;
    struct point o = r->edge[0].from;
    struct envelope a;
    for (int i = 0; i < r->count; i++) {
        const struct region_edge *e = &r->edge[i];
        if (e->type == EDGE_ARC) {
            envelope_make(k, e, &a);
            sum += envelope_area(e, &a, o, tolerance);
        } else {
            sum += ((e->from.x - o.x) * (e->to.y - o.y) - (e->from.y - o.y) * (e->to.x - o.x)) / 2;
        }
    }
    return sum;
}

/* ---- largest disc ---- */

struct tangent {
    int edge; /* number of the edge that it touches, at t */
    real t, line[3];
};

/* Greatest radius with normal . centre + c >= radius for all tangents, by the dual simplex method: three of
 * them whose normals surround 0 bound it; the one that the disc of these crosses by most takes the place of
 * one. */
struct disc {
    struct tangent touch[LINES];
    real x, y, radius;
};

static real determinant(const real *a, const real *b, const real *c)
{
    real cross[3];
    triple_cross(b, c, cross);
    return triple_dot(a, cross);
}

/* Centre and radius of the disc that touches all three lines; false: there is none. */
static bool disc_touch(struct disc *s)
{
    real a[3], b[3], one[3], c[3];
    for (int i = 0; i < LINES; i++) {
        a[i] = s->touch[i].line[0];
        b[i] = s->touch[i].line[1];
        one[i] = -1;
        c[i] = -s->touch[i].line[2];
    }
    real d = determinant(a, b, one);
    if (d == 0) {
        return false;
    }
    s->x = determinant(c, b, one) / d;
    s->y = determinant(a, c, one) / d;
    s->radius = determinant(a, b, c) / d;
    return true;
}

/* Factors with sum f_i (A_i, B_i, 1) = v. */
static bool combine(const struct disc *s, const real *v, real *f)
{
    real row[LINES][3];
    for (int i = 0; i < LINES; i++) {
        row[i][0] = s->touch[i].line[0];
        row[i][1] = s->touch[i].line[1];
        row[i][2] = 1;
    }
    real d = determinant(row[0], row[1], row[2]);
    if (d == 0) {
        return false;
    }
    f[0] = determinant(v, row[1], row[2]) / d;
    f[1] = determinant(row[0], v, row[2]) / d;
    f[2] = determinant(row[0], row[1], v) / d;
    return true;
}

/* The entering line takes the place of the one whose factor falls to 0 first. */
static bool exchange(struct disc *s, const struct tangent *enters)
{
    const real zero[3] = {0, 0, 1}, entering[3] = {enters->line[0], enters->line[1], 1};
    real f[LINES], g[LINES];
    int leaves = -1;
    if (!combine(s, zero, f) || !combine(s, entering, g)) {
        return false;
    }
    for (int i = 0; i < LINES; i++) {
        if (g[i] > 0 && (leaves < 0 || f[i] * g[leaves] < f[leaves] * g[i])) {
            leaves = i;
        }
    }
    if (leaves < 0) {
        return false;
    }
    s->touch[leaves] = *enters;
    return true;
}

static void unit_line(const struct region_edge *e, real *line)
{
    real length = real_sqrt(e->line[0] * e->line[0] + e->line[1] * e->line[1]);
    for (int j = 0; j < 3; j++) {
        line[j] = e->line[j] / length;
    }
}

/* A few tangents of each arc, arc after arc. */
struct tangents {
    int count;
    struct tangent at[TANGENTS_MAX];
};

/* false: too many arcs. */
static bool tangents_make(const struct region_work *k, const struct region *r, struct tangents *out)
{
    out->count = 0;
    for (int i = 0; i < r->count; i++) {
        const struct region_edge *e = &r->edge[i];
        if (e->type == EDGE_ARC && out->count + SAMPLES > TANGENTS_MAX) {
            return false;
        }
        for (int j = 0; e->type == EDGE_ARC && j < SAMPLES; j++) {
            struct tangent *at = &out->at[out->count++];
            at->edge = i;
            at->t = e->t + (e->t1 - e->t) * ((real)j / (SAMPLES - 1));
            envelope_tangent(k, e, at->t, at->line);
        }
    }
    return true;
}

static real height(const real *line, const struct disc *s)
{
    return line[0] * s->x + line[1] * s->y + line[2];
}

static void keep_nearer(const struct tangent *tangent, const struct disc *s, real *least,
                        struct tangent *nearest)
{
    if (height(tangent->line, s) < *least) {
        *least = height(tangent->line, s);
        *nearest = *tangent;
    }
}

/* Sample i is nearer than its neighbours on the same arc. */
static bool is_nearest_around(const struct tangents *samples, int i, const struct disc *s)
{
    real here = height(samples->at[i].line, s);
    return (i % SAMPLES == 0 || here <= height(samples->at[i - 1].line, s)) &&
           (i % SAMPLES == SAMPLES - 1 || here <= height(samples->at[i + 1].line, s));
}

/* Between samples the distance falls by no more than it changes from one to the next. */
static bool may_be_nearer(const struct tangents *samples, int i, const struct disc *s, real least)
{
    real here = height(samples->at[i].line, s), change = 0;
    if (i % SAMPLES > 0) {
        change = height(samples->at[i - 1].line, s) - here;
    }
    if (i % SAMPLES < SAMPLES - 1) {
        change = real_max(change, height(samples->at[i + 1].line, s) - here);
    }
    return here - change < least;
}

static void line_tangent(const struct region *r, int edge, struct tangent *out)
{
    out->edge = edge;
    out->t = r->edge[edge].t;
    unit_line(&r->edge[edge], out->line);
}

/* The tangent that the disc crosses by most, or touches, of an arc from its samples; returns its distance
 * from the centre. */
static real nearest_tangent(const struct region_work *k, const struct region *r,
                            const struct tangents *samples, const struct disc *s, struct tangent *nearest)
{
    const struct point centre = {s->x, s->y};
    real least = REAL_HUGE;
    struct tangent at;
    for (int i = 0; i < r->count; i++) {
        if (r->edge[i].type != EDGE_ARC) {
            line_tangent(r, i, &at);
            keep_nearer(&at, s, &least, nearest);
        }
    }
    for (int i = 0; i < samples->count; i++) {
        if (is_nearest_around(samples, i, s) && may_be_nearer(samples, i, s, least)) {
            at = samples->at[i];
            const struct region_edge *e = &r->edge[at.edge];
            envelope_touch(k, e, centre, real_abs(e->t1 - e->t) / (SAMPLES - 1), &at.t, at.line);
            keep_nearer(&at, s, &least, nearest);
        }
    }
    return least;
}

/* A disc between two contacts: two tangents of one arc, on either side of where it touches, the normal there
 * being opposite to that of the third. */
static bool between_tangents(const struct region_work *k, const struct region *r, const struct disc *s,
                             struct tangent *out)
{
    for (int i = 0; i < LINES; i++) {
        const struct tangent *a = &s->touch[i], *b = &s->touch[(i + 1) % LINES],
                             *c = &s->touch[(i + 2) % LINES];
        if (a->edge != b->edge || r->edge[a->edge].type != EDGE_ARC || a->t == b->t) {
            continue;
        }
        out->edge = a->edge;
        out->t = envelope_opposite(k, &r->edge[out->edge], c->line, a->t, b->t);
        envelope_tangent(k, &r->edge[out->edge], out->t, out->line);
        return height(out->line, s) < s->radius;
    }
    return false;
}

/* Of the directions a and b, the one nearer to -n on the side of n where cross products have this sign. */
static bool is_nearer_to_opposite(const real *n, int side, const real *a, const real *b)
{
    real cross_a = side * (n[0] * a[1] - n[1] * a[0]), cross_b = side * (n[0] * b[1] - n[1] * b[0]);
    bool beside = side > 0 ? cross_a >= 0 : cross_a > 0; /* -n itself is on one side only */
    return beside && (cross_b < 0 || n[0] * a[0] + n[1] * a[1] < n[0] * b[0] + n[1] * b[1]);
}

static void begin_with(const struct tangent *tangent, bool first, struct disc *s)
{
    for (int i = 0; first && i < LINES; i++) {
        s->touch[i] = *tangent;
    }
    for (int side = 1; side >= -1; side -= 2) {
        struct tangent *best = &s->touch[side > 0 ? 1 : 2];
        if (is_nearer_to_opposite(s->touch[0].line, side, tangent->line, best->line)) {
            *best = *tangent;
        }
    }
}

/* Three tangents whose normals surround 0. */
static void disc_begin(const struct region *r, const struct tangents *samples, struct disc *s)
{
    struct tangent at;
    bool first = true;
    for (int i = 0; i < r->count; i++) {
        if (r->edge[i].type != EDGE_ARC) {
            line_tangent(r, i, &at);
            begin_with(&at, first, s);
            first = false;
        }
    }
    for (int i = 0; i < samples->count; i++) {
        begin_with(&samples->at[i], first, s);
        first = false;
    }
}

/* The centre of a disc that touches the arc there. */
static void move_centre(const struct region_work *k, const struct region *r, const struct tangent *at,
                        struct disc *s)
{
    real v[3];
    envelope_at(k, r->edge[at->edge].span, at->t, v);
    s->x = v[0] / v[2] + s->radius * at->line[0];
    s->y = v[1] / v[2] + s->radius * at->line[1];
}

/* Radii of the touching discs fall until they meet the largest disc that fits, or rounding stops them. */
static void measure_disc(const struct region_work *k, real tolerance, struct region *r)
{
    struct tangents samples;
    struct disc s;
    real last = REAL_HUGE;
    if (!tangents_make(k, r, &samples)) {
        return;
    }
    disc_begin(r, &samples, &s);
    struct tangent between, enters = s.touch[0];
    for (int i = 0; i < ROUNDS && disc_touch(&s) && s.radius < last; i++) {
        bool two = between_tangents(k, r, &s, &between);
        if (two) {
            move_centre(k, r, &between, &s);
        }
        real d = nearest_tangent(k, r, &samples, &s, &enters),
             size = s.radius + real_abs(s.x) + real_abs(s.y);
        if (d > r->disc_radius) {
            r->disc_centre.x = s.x;
            r->disc_centre.y = s.y;
            r->disc_radius = d;
        }
        last = s.radius;
        if (s.radius - d <= tolerance * size || !exchange(&s, two ? &between : &enters)) {
            return;
        }
    }
}

void boundary_measure(const struct region_work *k, real tolerance, struct region *r)
{
    real fine = real_max(tolerance, 8 * REAL_EPSILON);
    if (r->kind == REGION_BOUNDED && r->count > 0) {
        r->area = area(k, fine, r);
        measure_disc(k, 64 * fine, r);
    }
}
