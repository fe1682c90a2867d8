/* Octagons: each segment in one, eight segments in one, and so on.
 *
 * A curve lies in the convex hull of its control points, so for each of the four functions h = x, y, x + y, x
 * - y it lies between the least and the greatest h of these points.  What is kept are doubles.  Rounding to
 * nearest is monotone: if a <= b then fl(a) <= fl(b); so is every sequence of roundings of one exact number.
 * Of a polynomial curve's control points h is one operation, exact for x and y: the number kept, at any
 * precision of `real`, is h rounded twice at most.  Hence low > high between two such numbers implies it for
 * the exact ones: octagons that are called apart are apart, without any margin.
 *
 * A rational curve's points are quotients, (x + y) / w rounded in sum and quotient, each by u of itself: 4 u
 * of the value (u = REAL_EPSILON / 2) covers both, and its own rounding; what is below REAL_LEAST may err by
 * that. Moved outwards by so much, low and high bound the exact numbers, and rounding to doubles keeps the
 * order.
 *
 * An overflow gives an infinity, the greatest number there is: order is kept. */
#include <math.h>

#include "../path.h"

static int nodes_for(int count)
{
    return count / PATH_FAN + (count % PATH_FAN != 0);
}

size_t path_tree_size(int count)
{
    size_t nodes = 0;
    do {
        count = nodes_for(count);
        nodes += (size_t)(count > 0 ? count : 1);
    } while (count > 1);
    return nodes * sizeof(struct path_node);
}

static void box_clear(struct path_node *node, int k)
{
    for (int h = 0; h < 4; h++) {
        node->low[h][k] = HUGE_VAL;
        node->high[h][k] = -HUGE_VAL;
    }
}

struct reach {
    real low[4], high[4];
};

static inline void reach_point(struct reach *r, real x, real y)
{
    real sum = x + y, difference = x - y;
    r->low[0] = real_min(r->low[0], x);
    r->low[1] = real_min(r->low[1], y);
    r->low[2] = real_min(r->low[2], sum);
    r->low[3] = real_min(r->low[3], difference);
    r->high[0] = real_max(r->high[0], x);
    r->high[1] = real_max(r->high[1], y);
    r->high[2] = real_max(r->high[2], sum);
    r->high[3] = real_max(r->high[3], difference);
}

static inline void reach_polynomial(const int n, const real *x, const real *y, struct reach *r)
{
    for (int i = 0; i <= n; i++) {
        reach_point(r, x[i], y[i]);
    }
}

static void reach_rational(const struct curve *c, struct reach *r)
{
    for (int i = 0; i <= c->degree; i++) {
        real w = c->w[i], h[4] = {c->x[i] / w, c->y[i] / w, (c->x[i] + c->y[i]) / w, (c->x[i] - c->y[i]) / w};
        for (int k = 0; k < 4; k++) {
            real pad = 2 * REAL_EPSILON * real_abs(h[k]) + 2 * REAL_LEAST;
            r->low[k] = real_min(r->low[k], h[k] - pad);
            r->high[k] = real_max(r->high[k], h[k] + pad);
        }
    }
}

static void box_of_segment(const struct path *path, int i, struct path_node *node, int k)
{
    const struct curve *c = &path->segment[i];
    struct reach r;
    for (int h = 0; h < 4; h++) {
        r.low[h] = REAL_HUGE;
        r.high[h] = -REAL_HUGE;
    }
    if (path->degree && path->degree[i] == 3) { /* the table is all that is read */
        const real *points = path->points + (size_t)BATCH_NUMBERS * (size_t)i;
        reach_polynomial(3, points, points + BATCH_NUMBERS / 2, &r);
    } else if (c->w) {
        reach_rational(c, &r);
    } else {
        reach_polynomial(c->degree, c->x, c->y, &r);
    }
    for (int h = 0; h < 4; h++) {
        node->low[h][k] = real_to_double(r.low[h]);
        node->high[h][k] = real_to_double(r.high[h]);
    }
}

/* Of segments first, first + 1, ...; made apart, so that it is written in one go. */
static void node_of_segments(const struct path *path, int first, struct path_node *to)
{
    struct path_node made;
    for (int k = 0; k < PATH_FAN; k++) {
        int i = first + k;
        if (i >= path->count || (!(path->degree && path->degree[i]) && path->next[i] == PATH_POINT)) {
            box_clear(&made, k);
        } else {
            box_of_segment(path, i, &made, k);
        }
    }
    *to = made;
}

/* All eight of `from`. */
static void box_of_node(const struct path_node *from, struct path_node *to, int k)
{
    for (int h = 0; h < 4; h++) {
        double low = from->low[h][0], high = from->high[h][0];
        for (int i = 1; i < PATH_FAN; i++) {
            low = from->low[h][i] < low ? from->low[h][i] : low;
            high = from->high[h][i] > high ? from->high[h][i] : high;
        }
        to->low[h][k] = low;
        to->high[h][k] = high;
    }
}

/* The boxes that the last node of a level lacks are empty. */
static void fill_up(struct path_node *node, int count)
{
    for (int k = count % PATH_FAN; k % PATH_FAN != 0; k++) {
        box_clear(&node[count / PATH_FAN], k);
    }
    if (count == 0) {
        for (int k = 0; k < PATH_FAN; k++) {
            box_clear(node, k);
        }
    }
}

void path_tree_make(struct path_tree *tree, const struct path *path, void *memory)
{
    struct path_node *node = (struct path_node *)memory;
    tree->path = path;
    tree->level[0] = node;
    tree->count[0] = path->count;
    for (int i = 0; i < path->count; i += PATH_FAN) {
        node_of_segments(path, i, &node[i / PATH_FAN]);
    }
    fill_up(node, path->count);
    int below = nodes_for(path->count), level = 0;
    while (below > 1) {
        struct path_node *above = node + below;
        for (int i = 0; i < below; i++) {
            box_of_node(&node[i], &above[i / PATH_FAN], i % PATH_FAN);
        }
        fill_up(above, below);
        node = above;
        tree->level[++level] = node;
        tree->count[level] = below;
        below = nodes_for(below);
    }
    tree->levels = level + 1;
}
