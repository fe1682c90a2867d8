/* Area and largest disc of a bounded region. */
#include "arcs.h"
#include "boundary.h"

enum { ROUNDS = 200, SAMPLES = 6, LINES = 3 };

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

/* Greatest radius with normal . centre + c >= radius for all tangents, by the dual simplex method: three of
 * them whose normals surround 0 bound it; the one that the disc of these crosses by most takes the place of
 * one. */
struct disc {
    real line[LINES][3];
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
        a[i] = s->line[i][0];
        b[i] = s->line[i][1];
        one[i] = -1;
        c[i] = -s->line[i][2];
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
        row[i][0] = s->line[i][0];
        row[i][1] = s->line[i][1];
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

static void set_triple(const real *from, real *to)
{
    for (int i = 0; i < 3; i++) {
        to[i] = from[i];
    }
}

/* The entering line takes the place of the one whose factor falls to 0 first. */
static bool exchange(struct disc *s, const real *line)
{
    const real zero[3] = {0, 0, 1}, entering[3] = {line[0], line[1], 1};
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
    set_triple(line, s->line[leaves]);
    return true;
}

/* The tangent that the disc crosses by most, or touches; returns its distance from the centre. */
static real nearest_tangent(struct region_work *k, const struct region *r, const struct disc *s, real *line)
{
    struct point centre = {s->x, s->y};
    struct envelope a;
    real least = REAL_HUGE;
    for (int i = 0; i < r->count; i++) {
        const struct region_edge *e = &r->edge[i];
        real d, t, tangent[3];
        if (e->type == EDGE_ARC) {
            envelope_make(k, e, &a);
            d = envelope_distance(k, e, &a, centre, &t);
            envelope_tangent(k, e, t, tangent);
        } else {
            real length = real_sqrt(e->line[0] * e->line[0] + e->line[1] * e->line[1]);
            for (int j = 0; j < 3; j++) {
                tangent[j] = e->line[j] / length;
            }
            d = tangent[0] * centre.x + tangent[1] * centre.y + tangent[2];
        }
        if (d < least) {
            least = d;
            set_triple(tangent, line);
        }
    }
    return least;
}

/* Of the directions a and b, the one nearer to -n on the side of n where cross products have this sign. */
static bool is_nearer_to_opposite(const real *n, int side, const real *a, const real *b)
{
    real cross_a = side * (n[0] * a[1] - n[1] * a[0]), cross_b = side * (n[0] * b[1] - n[1] * b[0]);
    bool beside = side > 0 ? cross_a >= 0 : cross_a > 0; /* -n itself is on one side only */
    return beside && (cross_b < 0 || n[0] * a[0] + n[1] * a[1] < n[0] * b[0] + n[1] * b[1]);
}

/* Tangent number i of an edge, SAMPLES of each arc. */
static bool sample(const struct region_work *k, const struct region_edge *e, int i, real *line)
{
    if (e->type == EDGE_ARC) {
        envelope_tangent(k, e, e->t + (e->t1 - e->t) * ((real)i / (SAMPLES - 1)), line);
        return i < SAMPLES;
    }
    real length = real_sqrt(e->line[0] * e->line[0] + e->line[1] * e->line[1]);
    for (int j = 0; j < 3; j++) {
        line[j] = e->line[j] / length;
    }
    return i < 1;
}

/* Three tangents whose normals surround 0. */
static void disc_begin(const struct region_work *k, const struct region *r, struct disc *s)
{
    real line[3];
    sample(k, &r->edge[0], 0, s->line[0]);
    set_triple(s->line[0], s->line[1]);
    set_triple(s->line[0], s->line[2]);
    for (int i = 0; i < r->count; i++) {
        for (int j = 0; sample(k, &r->edge[i], j, line); j++) {
            for (int side = 1; side >= -1; side -= 2) {
                real *best = s->line[side > 0 ? 1 : 2];
                if (is_nearer_to_opposite(s->line[0], side, line, best)) {
                    set_triple(line, best);
                }
            }
        }
    }
}

static void measure_disc(struct region_work *k, real tolerance, struct region *r)
{
    struct disc s;
    real line[3] = {0, 0, 0};
    disc_begin(k, r, &s);
    for (int i = 0; i < ROUNDS && disc_touch(&s); i++) {
        real d = nearest_tangent(k, r, &s, line);
        r->disc_centre.x = s.x;
        r->disc_centre.y = s.y;
        r->disc_radius = real_max(0, d);
        if (s.radius - d <= tolerance * real_abs(s.radius) || !exchange(&s, line)) {
            return;
        }
    }
}

void boundary_measure(struct region_work *k, real tolerance, struct region *r)
{
    real fine = real_max(tolerance, 8 * REAL_EPSILON);
    if (r->kind == REGION_BOUNDED && r->count > 0) {
        r->area = area(k, fine, r);
        measure_disc(k, fine, r);
    }
}
