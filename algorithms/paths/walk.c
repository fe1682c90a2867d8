/* Both trees at once, depth first: two nodes whose boxes met are opened, the taller one first, and their
 * eight boxes held against each other.
 *
 * No pair is lost: a box holds those below it, so segments whose octagons meet lie below boxes that meet, at
 * every level. Of one path the pairs of boxes with a <= b are enough: all others are the same pairs the other
 * way. */
#include "paths.h"

static void wait(struct path_walk *walk, int level_a, int a, int level_b, int b)
{
    struct path_place *at = &walk->place[walk->waiting++];
    at->level_a = level_a;
    at->a = a;
    at->level_b = level_b;
    at->b = b;
}

/* The root of a tree is the node of its last level. */
void path_walk_begin(struct path_walk *walk, const struct path_tree *a, const struct path_tree *b)
{
    walk->a = a;
    walk->b = b;
    walk->self = a->path == b->path;
    walk->boxes = path_boxes_choose();
    walk->tests = 0;
    walk->waiting = 0;
    wait(walk, a->levels - 1, 0, b->levels - 1, 0);
}

/* Which boxes of `of` meet the whole of a node of `tree`, where that is known. */
static unsigned worth(struct path_walk *walk, const struct path_tree *tree, int level, int node,
                      const struct path_node *of)
{
    int i = node % PATH_FAN;
    if (level + 1 >= tree->levels) {
        return (1u << PATH_FAN) - 1;
    }
    walk->tests++;
    return (unsigned)(walk->boxes(&tree->level[level + 1][node / PATH_FAN], 1u << i, of) >> PATH_FAN * i);
}

/* The node of the taller tree is opened: its boxes that meet the other node wait. */
static void open_one(struct path_walk *walk, const struct path_place *at, bool of_a)
{
    const struct path_tree *tall = of_a ? walk->a : walk->b;
    int level = of_a ? at->level_a : at->level_b, node = of_a ? at->a : at->b;
    unsigned met = of_a ? worth(walk, walk->b, at->level_b, at->b, &tall->level[level][node])
                        : worth(walk, walk->a, at->level_a, at->a, &tall->level[level][node]);
    for (; met; met &= met - 1) {
        int below = node * PATH_FAN + __builtin_ctz(met);
        if (below < tall->count[level]) {
            wait(walk, of_a ? level - 1 : at->level_a, of_a ? below : at->a, of_a ? at->level_b : level - 1,
                 of_a ? at->b : below);
        }
    }
}

/* The pairs of boxes that are tried of one node with itself: bit 8 i + k for i <= k. */
static const uint64_t upper = 0x80c0e0f0f8fcfeffu;

/* Bit 8 i + k: box i of node a and box k of node b, of the same level, meet. */
static uint64_t pairs_met(struct path_walk *walk, const struct path_place *at)
{
    const struct path_node *a = &walk->a->level[at->level_a][at->a], *b = &walk->b->level[at->level_b][at->b];
    unsigned which = worth(walk, walk->b, at->level_b, at->b, a);
    walk->tests += __builtin_popcount(which);
    uint64_t pairs = walk->boxes(a, which, b);
    return walk->self && at->a == at->b ? pairs & upper : pairs;
}

/* Two nodes of the same level: pairs of segments go to `out`, of nodes wait.  Returns how many were written.
 */
static int open_both(struct path_walk *walk, const struct path_place *at, struct path_pair *out)
{
    int written = 0, level = at->level_a;
    for (uint64_t pairs = pairs_met(walk, at); pairs; pairs &= pairs - 1) {
        int bit = __builtin_ctzll(pairs);
        int i = at->a * PATH_FAN + bit / PATH_FAN, j = at->b * PATH_FAN + bit % PATH_FAN;
        if (i >= walk->a->count[level] || j >= walk->b->count[level]) {
            continue;
        }
        if (level > 0) {
            wait(walk, level - 1, i, level - 1, j);
        } else if (!walk->self || i != j) {
            out[written].i = i;
            out[written++].j = j;
        }
    }
    return written;
}

/* Each place opened leaves at most PATH_FAN^2 others, all one level lower in at least one tree: PATH_WAIT is
 * enough. */
int path_walk_next(struct path_walk *walk, struct path_pair *out, int room)
{
    int written = 0;
    while (walk->waiting > 0 && room - written >= PATH_BLOCK_LEAST) {
        struct path_place at = walk->place[--walk->waiting];
        if (at.level_a == at.level_b) {
            written += open_both(walk, &at, out + written);
        } else {
            open_one(walk, &at, at.level_a > at.level_b);
        }
    }
    return written;
}
