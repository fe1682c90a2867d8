/* In the ellipse's frame, divided by its half axes, the arc is one of the unit circle, from u to v.  A
 * circular arc from p to q of less than half a turn is the rational quadratic with control points p, (p + q)
 * / (1 + p.q), q and weights 1, sqrt((1 + p.q) / 2), 1. Halving directions takes square roots only. */
#include "path_arc.h"

#include <math.h>

struct vector {
    real x, y;
};

struct ellipse {
    struct vector centre;
    real rx, ry, cosine, sine;
};

static struct vector to_plane(const struct ellipse *e, struct vector u)
{
    real x = e->rx * u.x, y = e->ry * u.y;
    struct vector p = {e->cosine * x - e->sine * y + e->centre.x, e->sine * x + e->cosine * y + e->centre.y};
    return p;
}

static real dot(struct vector p, struct vector q)
{
    return p.x * q.x + p.y * q.y;
}

static struct vector unit(struct vector p)
{
    real length = real_sqrt(dot(p, p));
    struct vector q = {p.x / length, p.y / length};
    return q;
}

static bool add_piece(struct path_draft *d, const struct ellipse *e, struct vector p, struct vector q,
                      struct vector from, struct vector to)
{
    real one = 1 + dot(p, q), w = real_sqrt(one / 2);
    struct vector corner = {(p.x + q.x) / one, (p.y + q.y) / one};
    corner = to_plane(e, corner);
    real x[3] = {from.x, w * corner.x, to.x}, y[3] = {from.y, w * corner.y, to.y}, weights[3] = {1, w, 1};
    return path_draft_add(d, 2, x, y, weights);
}

/* Halves the arc until `halvings` are done; less than half a turn remains of each piece. */
static bool add_arc(struct path_draft *d, const struct ellipse *e, struct vector p, struct vector q,
                    struct vector from, struct vector to, bool large, bool sweep, int halvings)
{
    if (halvings == 0)
        return add_piece(d, e, p, q, from, to);
    struct vector sum = {p.x + q.x, p.y + q.y}, across = {p.y - q.y, q.x - p.x}, middle;
    /* across: q - p turned left, away from a counter-clockwise arc's side; the longer one is better known */
    if (dot(sum, sum) > dot(across, across)) {
        middle = sum;
        if (large) {
            middle.x = -sum.x;
            middle.y = -sum.y;
        }
    } else {
        middle.x = sweep ? -across.x : across.x;
        middle.y = sweep ? -across.y : across.y;
    }
    middle = unit(middle);
    struct vector at = to_plane(e, middle);
    return add_arc(d, e, p, middle, from, at, false, sweep, halvings - 1) &&
           add_arc(d, e, middle, q, at, to, false, sweep, halvings - 1);
}

static bool add_line(struct path_draft *d, struct vector from, struct vector to)
{
    real x[2] = {from.x, to.x}, y[2] = {from.y, to.y};
    return path_draft_add(d, 1, x, y, NULL);
}

/* Appendix F.6.5 with half axes enlarged as F.6.6 asks; p, q: the ends on the unit circle. */
static void find_centre(struct ellipse *e, struct vector from, struct vector to, bool far_side,
                        struct vector *p, struct vector *q)
{
    real mx = (from.x - to.x) / 2, my = (from.y - to.y) / 2;
    struct vector h = {(e->cosine * mx + e->sine * my) / e->rx, (e->cosine * my - e->sine * mx) / e->ry};
    real size = dot(h, h);
    if (size > 1) {
        real grow = real_sqrt(size);
        e->rx = e->rx * grow;
        e->ry = e->ry * grow;
        h.x = h.x / grow;
        h.y = h.y / grow;
        size = 1;
    }
    real root = real_sqrt((1 - size) / size);
    struct vector c = {far_side ? root * h.y : -root * h.y, far_side ? -root * h.x : root * h.x};
    real x = e->rx * c.x, y = e->ry * c.y;
    e->centre.x = e->cosine * x - e->sine * y + (from.x + to.x) / 2;
    e->centre.y = e->sine * x + e->cosine * y + (from.y + to.y) / 2;
    p->x = h.x - c.x;
    p->y = h.y - c.y;
    q->x = -h.x - c.x;
    q->y = -h.y - c.y;
}

bool path_arc_add(struct path_draft *d, real x0, real y0, real rx, real ry, double rotation, bool large,
                  bool sweep, real x1, real y1)
{
    const double degree = 3.14159265358979323846 / 180;
    struct vector from = {x0, y0}, to = {x1, y1}, p, q;
    struct ellipse e;
    if (x0 == x1 && y0 == y1)
        return true;
    e.rx = real_abs(rx);
    e.ry = real_abs(ry);
    e.cosine = cos(rotation * degree);
    e.sine = sin(rotation * degree);
    if (e.rx == 0 || e.ry == 0)
        return add_line(d, from, to);
    find_centre(&e, from, to, large != sweep, &p, &q);
    int halvings = large ? 2 : dot(p, q) < 0 ? 1 : 0;
    return add_arc(d, &e, p, q, from, to, large, sweep, halvings);
}
