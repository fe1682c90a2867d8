#include "path_boxes.h"
#include "../run/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct box {
    double low[2], high[2];
};

static void include(struct box *b, int k, double a)
{
    b->low[k] = a < b->low[k] ? a : b->low[k];
    b->high[k] = a > b->high[k] ? a : b->high[k];
}

static double cubic_value(const double c[4], double t)
{
    double u = 1 - t;
    return u * u * u * c[0] + 3 * u * u * t * c[1] + 3 * u * t * t * c[2] + t * t * t * c[3];
}

static void include_at(struct box *b, int k, const double c[4], double t)
{
    if (t > 0 && t < 1)
        include(b, k, cubic_value(c, t));
}

/* The ends, and where the derivative A (1-t)^2 + 2 B t (1-t) + C t^2 is zero. */
static void include_cubic(struct box *b, int k, const double c[4])
{
    double A = c[1] - c[0], B = c[2] - c[1], C = c[3] - c[2], square = B * B - A * C;
    include(b, k, c[0]);
    include(b, k, c[3]);
    if (square >= 0) {
        double q = A - B + (A - B < 0 ? -sqrt(square) : sqrt(square));
        if (q != 0)
            include_at(b, k, c, A / q);
        if (A - 2 * B + C != 0)
            include_at(b, k, c, q / (A - 2 * B + C));
    }
}

/* Of degree 3, elevated from 1 or 2. */
static void elevate(int degree, const real *c, double out[4])
{
    double p[4] = {0, 0, 0, 0};
    for (int i = 0; i <= degree; i++)
        p[i] = real_to_double(c[i]);
    out[0] = p[0];
    out[1] = degree == 1 ? p[0] + (p[1] - p[0]) / 3 : degree == 2 ? (p[0] + 2 * p[1]) / 3 : p[1];
    out[2] = degree == 1 ? p[1] + (p[0] - p[1]) / 3 : degree == 2 ? (p[2] + 2 * p[1]) / 3 : p[2];
    out[3] = p[degree];
}

static struct box box_of(const struct curve *c)
{
    struct box b = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    double p[4];
    for (int k = 0; k < 2; k++) {
        const real *at = k ? c->y : c->x;
        if (c->degree <= 3 && !c->w) {
            elevate(c->degree, at, p);
            include_cubic(&b, k, p);
            continue;
        }
        for (int i = 0; i <= c->degree; i++)
            include(&b, k, real_to_double(c->w ? at[i] / c->w[i] : at[i]));
    }
    return b;
}

static bool boxes_meet(const struct box *p, const struct box *q)
{
    return p->low[0] <= q->high[0] && q->low[0] <= p->high[0] && p->low[1] <= q->high[1] &&
           q->low[1] <= p->high[1];
}

/* x + y and x - y no longer count. */
static void make_boxes(struct path_tree *tree)
{
    for (int level = 0; level < tree->levels; level++)
        for (int k = 0; k < tree->count[level]; k++)
            for (int h = 2; h < 4; h++) {
                struct path_node *node = &tree->level[level][k / PATH_FAN];
                node->low[h][k % PATH_FAN] = -HUGE_VAL;
                node->high[h][k % PATH_FAN] = HUGE_VAL;
            }
}

static void add(struct boxed_pairs *out, const struct path_pair *pair)
{
    if (out->count == out->room) {
        out->room = out->room + out->room / 2 + 1024;
        out->at = (struct path_pair *)memory_resized(out->at, (size_t)out->room * sizeof *out->at);
    }
    out->at[out->count++] = *pair;
}

void path_pairs_find(const struct path *a, const struct path *b, struct boxed_pairs *out)
{
    enum { BLOCK = 4096 };
    const struct path *other = b ? b : a;
    void *memory_a = memory_resized(NULL, path_tree_size(a->count)),
         *memory_b = memory_resized(NULL, path_tree_size(other->count));
    struct path_pair *block = (struct path_pair *)memory_resized(NULL, BLOCK * sizeof *block);
    struct path_walk *walk = (struct path_walk *)memory_resized(NULL, sizeof *walk);
    struct path_tree tree_a, tree_b;

    memset(out, 0, sizeof *out);
    path_tree_make(&tree_a, a, memory_a);
    path_tree_make(&tree_b, other, memory_b);
    make_boxes(&tree_a);
    make_boxes(&tree_b);
    path_walk_begin(walk, &tree_a, b ? &tree_b : &tree_a);
    for (int count; (count = path_walk_next(walk, block, BLOCK)) > 0;)
        for (int k = 0; k < count; k++) {
            int i = block[k].i, j = block[k].j;
            struct box p = box_of(&a->segment[i]), q = box_of(&other->segment[j]);
            bool neighbours = !b && (a->next[i] == j || a->next[j] == i);
            if (!neighbours && boxes_meet(&p, &q))
                add(out, &block[k]);
        }
    free(memory_a);
    free(memory_b);
    free(block);
    free(walk);
}
