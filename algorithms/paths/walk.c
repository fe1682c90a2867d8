/* Both trees at once, depth first: two nodes whose boxes met are opened, the taller one first, and their
 * eight boxes held against each other.
 *
 * No pair is lost: a box holds those below it, so segments whose octagons meet lie below boxes that meet, at
 * every level. Of one path the pairs of boxes with a <= b are enough: all others are the same pairs the other
 * way. */
#include "../path.h"

/* Bit k: box k of `to` meets box i of `from`. */
static inline unsigned boxes_met(const struct path_node *from, int i, const struct path_node *to)
{
    long long apart[PATH_FAN] = {0, 0, 0, 0, 0, 0, 0, 0};
    unsigned met = 0;
    for (int h = 0; h < 4; h++) {
        double low = from->low[h][i], high = from->high[h][i];
        for (int k = 0; k < PATH_FAN; k++) {
            apart[k] |= -(long long)(low > to->high[h][k]) | -(long long)(to->low[h][k] > high);
        }
    }
    for (int k = 0; k < PATH_FAN; k++) {
        met |= (unsigned)(apart[k] == 0) << k;
    }
    return met;
}

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
    walk->tests = 0;
    walk->waiting = 0;
    wait(walk, a->levels - 1, 0, b->levels - 1, 0);
}

/* Box i of node a of the tree's level `level`, as a node one level up knows it, against the eight of another:
 * the nodes of the taller tree whose boxes meet that of node b. */
static void open_one(struct path_walk *walk, const struct path_place *at, bool of_a)
{
    const struct path_tree *tall = of_a ? walk->a : walk->b, *low = of_a ? walk->b : walk->a;
    int level = of_a ? at->level_a : at->level_b, node = of_a ? at->a : at->b;
    int other_level = of_a ? at->level_b : at->level_a, other = of_a ? at->b : at->a;
    const struct path_node *from = &tall->level[level][node];
    unsigned met = ~0u;
    if (other_level + 1 < low->levels) {
        walk->tests++;
        met = boxes_met(&low->level[other_level + 1][other / PATH_FAN], other % PATH_FAN, from);
    }
    for (int k = PATH_FAN - 1; k >= 0; k--) {
        int below = node * PATH_FAN + k;
        if (met >> k & 1 && below < tall->count[level]) {
            wait(walk, of_a ? level - 1 : at->level_a, of_a ? below : at->a, of_a ? at->level_b : level - 1,
                 of_a ? at->b : below);
        }
    }
}

/* Which boxes of `of` meet the whole of node b of the other tree, where it is known. */
static unsigned worth(struct path_walk *walk, const struct path_tree *tree, int level, int node,
                      const struct path_node *of)
{
    if (level + 1 >= tree->levels) {
        return ~0u;
    }
    walk->tests++;
    return boxes_met(&tree->level[level + 1][node / PATH_FAN], node % PATH_FAN, of);
}

/* Two nodes of the same level: pairs of boxes; of segments they go to `out`.  Returns how many. */
static int open_both(struct path_walk *walk, const struct path_place *at, struct path_pair *out)
{
    const struct path_node *a = &walk->a->level[at->level_a][at->a], *b = &walk->b->level[at->level_b][at->b];
    unsigned worth_a = worth(walk, walk->b, at->level_b, at->b, a);
    int written = 0, level = at->level_a;
    for (int i = 0; i < PATH_FAN; i++) {
        int below_a = at->a * PATH_FAN + i;
        if (!(worth_a >> i & 1) || below_a >= walk->a->count[level]) {
            continue;
        }
        walk->tests++;
        for (unsigned met = boxes_met(a, i, b); met; met &= met - 1) {
            int below_b = at->b * PATH_FAN + __builtin_ctz(met);
            if (below_b >= walk->b->count[level] || (walk->self && below_b < below_a) ||
                (walk->self && level == 0 && below_b == below_a)) {
                continue;
            }
            if (level > 0) {
                wait(walk, level - 1, below_a, level - 1, below_b);
            } else {
                out[written].i = below_a;
                out[written++].j = below_b;
            }
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
