/* The closed conditions h_t(d) >= 0 where the open region is empty: moved outwards by a little they leave a
 * region that is thin, and whose shape tells what it surrounds. */
#include "boundary.h"
#include "enclose.h"

/* What is smaller than this is a point or a line; conditions are moved by less than its square. */
static real thin(void)
{
    return real_ldexp(1, -REAL_BITS * 3 / 16);
}

static real relaxation(void)
{
    return real_ldexp(1, -REAL_BITS * 5 / 8);
}

/* Finite vertices and directions of those that are far. */
struct shape {
    int points, far;
    struct point a, b;         /* two finite points far apart */
    struct point toward, away; /* two directions far apart */
    real length;               /* of b - a */
};

static real distance(struct point a, struct point b)
{
    real x = a.x - b.x, y = a.y - b.y;
    return real_sqrt(x * x + y * y);
}

static bool is_far(const real *v)
{
    return v[2] * 1024 <= 1;
}

static struct point affine(const real *v)
{
    struct point p = {v[0] / v[2], v[1] / v[2]};
    return p;
}

static struct point direction(const real *v)
{
    real length = real_sqrt(v[0] * v[0] + v[1] * v[1]);
    struct point p = {v[0] / length, v[1] / length};
    return p;
}

/* Starts at any vertex: the farthest from it, and the farthest from that one, are far apart enough. */
static void measure(const struct cone *c, struct shape *s)
{
    const struct point origin = {0, 0};
    real v[3], error;
    s->points = s->far = 0;
    s->length = 0;
    s->a = s->b = s->toward = s->away = origin;
    for (int pass = 0; pass < 3; pass++) {
        struct point a = pass == 0 ? s->a : s->b, u = pass == 0 ? s->toward : s->away;
        for (int i = 0; cone_generator(c, i, v, &error); i++) {
            if (is_far(v)) {
                struct point d = direction(v);
                s->far += pass == 0;
                if (pass == 0 || distance(d, u) > distance(s->away, u)) {
                    s->away = d;
                }
                s->toward = pass == 0 ? d : u;
            } else {
                struct point p = affine(v);
                s->points += pass == 0;
                if (pass == 0 || distance(p, a) > distance(s->b, a)) {
                    s->b = p;
                }
                s->a = pass == 0 ? p : a;
            }
        }
    }
    if (s->points > 0) {
        s->length = distance(s->a, s->b);
    }
}

/* All finite vertices near the line through p with direction u, all far ones near its ends. */
static bool is_thin(const struct cone *c, struct point p, struct point u)
{
    real v[3], error;
    for (int i = 0; cone_generator(c, i, v, &error); i++) {
        struct point q = is_far(v) ? direction(v) : affine(v);
        real x = is_far(v) ? q.x : q.x - p.x, y = is_far(v) ? q.y : q.y - p.y;
        if (real_abs(u.x * y - u.y * x) > thin()) {
            return false;
        }
    }
    return true;
}

static enum region_kind classify(const struct cone *c, struct shape *s)
{
    measure(c, s);
    if (c->count == 1) {
        return REGION_PLANE;
    }
    enum region_kind solid = s->far ? REGION_UNBOUNDED : REGION_BOUNDED;
    if (s->points == 0) {
        return solid;
    }
    if (!s->far && s->length <= thin()) {
        return REGION_POINT;
    }
    struct point u = s->away;
    if (!s->far) {
        u.x = (s->b.x - s->a.x) / s->length;
        u.y = (s->b.y - s->a.y) / s->length;
    }
    if (!is_thin(c, s->a, u)) {
        return solid;
    }
    return !s->far ? REGION_SEGMENT : distance(s->toward, s->away) > 1 ? REGION_LINE : REGION_RAY;
}

/* The finite point that lies least along u. */
static struct point first_along(const struct cone *c, struct point u, struct point best)
{
    real v[3], error;
    for (int i = 0; cone_generator(c, i, v, &error); i++) {
        struct point p = is_far(v) ? best : affine(v);
        if (p.x * u.x + p.y * u.y < best.x * u.x + best.y * u.y) {
            best = p;
        }
    }
    return best;
}

void boundary_closed(struct region_work *k, struct region *r)
{
    struct shape s;
    struct cone *c = &k->relaxed;
    enum outcome outcome = SOLVED;
    bool empty;
    r->closed_kind = REGION_EMPTY;
    if (!pieces_make(k, AT_TORSION)) {
        r->certified = false;
        return;
    }
    empty = !enclose(k, c, relaxation(), relaxation(), &outcome);
    r->certified = empty && c->missed && outcome == SOLVED;
    if (empty || outcome != SOLVED) {
        return;
    }
    r->closed_kind = classify(c, &s);
    r->closed[0] = s.a;
    r->closed[1] = s.b;
    if (r->closed_kind == REGION_RAY || r->closed_kind == REGION_LINE) {
        r->closed[0] = first_along(c, s.away, s.a);
        r->closed[1].x = r->closed[0].x + s.away.x;
        r->closed[1].y = r->closed[0].y + s.away.y;
    }
}
