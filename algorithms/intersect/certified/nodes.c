/* Nodes: parts of a curve with their control points, octagon, directions and bounds. */
#include "../../core/bernstein.h"
#include "graphs.h"

/* ---- control points and octagon ---- */

static inline void widen(struct node *to, real x, real y)
{
    real form[4] = {x, y, x + y, x - y};
    for (int k = 0; k < 4; k++) {
        to->low[k] = real_min(to->low[k], form[k]);
        to->high[k] = real_max(to->high[k], form[k]);
    }
}

/* x and y err by node_error E, quotients by u S more; x + y and x - y by 2 E and 2 u S of rounding, and u S
 * <= E / 13. */
static inline void octagon(const struct source *c, const int n, struct node *to)
{
    const real *x = to->points, *y = x + n + 1, *w = y + n + 1;
    for (int k = 0; k < 4; k++) {
        to->low[k] = REAL_HUGE;
        to->high[k] = -REAL_HUGE;
    }
    for (int i = 0; i <= n; i++) {
        if (c->rational) {
            widen(to, x[i] / w[i], y[i] / w[i]);
        } else {
            widen(to, x[i], y[i]);
        }
    }
    real pad = c->node_error * (real)1.25, twice = 2 * pad;
    to->low[0] -= pad;
    to->low[1] -= pad;
    to->low[2] -= twice;
    to->low[3] -= twice;
    to->high[0] += pad;
    to->high[1] += pad;
    to->high[2] += twice;
    to->high[3] += twice;
}

static void octagon_made(const struct source *c, struct node *to)
{
    if (c->n == 3 && !c->rational) {
        octagon(c, 3, to);
    } else {
        octagon(c, c->n, to);
    }
    to->child = 0;
    to->ready = false;
}

void node_root(const struct source *c, struct node *to)
{
    to->lo = 0;
    to->hi = 1;
    to->halved = 0;
    octagon_made(c, to);
}

void node_cut(const struct source *c, real lo, real hi, struct node *to)
{
    bernstein_restrict(c->n, c->rational ? 3 : 2, c->points, lo, hi, to->points);
    to->lo = lo;
    to->hi = hi;
    to->halved = 0;
    octagon_made(c, to);
}

/* ---- directions ---- */

/* Rounding: a direction errs by 2 E and by u of itself, at most 4 u S <= E / 3.  The second differences by 4
 * E and by that of two directions and their own, at most 8 u S <= 2 E / 3, and so does f'' / (n (n - 1)).
 * tests/proofs/directions.g, second_differences.g. */
static inline void prepare_polynomial(const struct source *c, const int n, struct node *to)
{
    const real *x = to->points, *y = x + n + 1;
    real *ax = to->way, *ay = ax + n, ex = x[n] - x[0], ey = y[n] - y[0], speed = 0, bend = 0;
    bool back = false;
    for (int i = 0; i < n; i++) {
        ax[i] = x[i + 1] - x[i];
        ay[i] = y[i + 1] - y[i];
        speed = real_max(speed, real_abs(ax[i]) + real_abs(ay[i]));
        back |= !(ex * ax[i] + ey * ay[i] > 0);
    }
    for (int i = 0; i + 1 < n; i++) {
        bend = real_max(bend, real_max(real_abs(ax[i + 1] - ax[i]), real_abs(ay[i + 1] - ay[i])));
    }
    to->error = (real)2.5 * c->node_error;
    to->speed = speed + 2 * to->error;
    to->bend = n > 1 ? n * (n - 1) * (bend + 5 * c->node_error) : (real)0;
    to->pace_lo = to->pace_hi = n;
    to->ways = n;
    to->wide = back;
}

/* X = (1-t) X0 + t X1 with X0 = sum x[i] B(i,n-1), X1 = sum x[i+1] B(i,n-1), W likewise: then X'W - XW' = n
 * (X1 W0 - X0 W1).  Terms of one coefficient: x[i+1] w[j] - x[i] w[j+1], weights C(n-1,i) C(n-1,j) /
 * C(2n-2,i+j) of sum 1. */
static void numerators(int n, const real *x, const real *w, real *out)
{
    for (int k = 0; k <= 2 * n - 2; k++) {
        int first = k > n - 1 ? k - (n - 1) : 0, last = k < n - 1 ? k : n - 1;
        real weight = binomial(n - 1, first) * binomial(n - 1, k - first) / binomial(2 * n - 2, k), sum = 0;
        for (int i = first; i <= last; i++) {
            int j = k - i;
            sum += weight * (x[i + 1] * w[j] - x[i] * w[j + 1]);
            if (i < last) {
                weight = weight * (real)((n - 1 - i) * j) / (real)((i + 1) * (n - j));
            }
        }
        out[k] = sum;
    }
}

void direction_turn(const struct node *a, real *out)
{
    int d = a->ways - 1;
    numerators(d, a->way, a->way + a->ways, out);
    for (int k = 0; k <= 2 * d - 2; k++) {
        out[k] = -out[k];
    }
}

/* With w the node's largest weight, |x|, |y| <= S w, each known to E w / 2 and w to E w / (2 S): a product
 * errs by E w^2, the difference of two by 2 E w^2, its rounding by (4 n + 16) u S w^2 <= E w^2 / 2. f' = n N
 * / W^2, f'' = n N' / W^2 - 2 n N W' / W^3, with N' of degree 2n - 3 and |W'| <= n max |w[i+1] - w[i]|. */
static void prepare_rational(const struct source *c, struct node *to)
{
    int n = c->n, ways = 2 * n - 1;
    const real *x = to->points, *y = x + n + 1, *w = y + n + 1;
    real *ax = to->way, *ay = ax + ways;
    real most = w[0], least = w[0], change = 0, longest = 0, speed = 0, turn = 0;
    for (int i = 1; i <= n; i++) {
        most = real_max(most, w[i]);
        least = real_min(least, w[i]);
        change = real_max(change, real_abs(w[i] - w[i - 1]));
    }
    numerators(n, x, w, ax);
    numerators(n, y, w, ay);
    most = most * (1 + c->node_error);
    least = least * (1 - c->node_error);
    to->error = 3 * c->node_error * most * most;
    real ex = x[n] / w[n] - x[0] / w[0], ey = y[n] / w[n] - y[0] / w[0];
    bool back = false;
    for (int i = 0; i < ways; i++) {
        speed = real_max(speed, real_abs(ax[i]) + real_abs(ay[i]));
        longest = real_max(longest, real_max(real_abs(ax[i]), real_abs(ay[i])));
        back |= !(ex * ax[i] + ey * ay[i] > 0);
        if (i > 0) {
            turn = real_max(turn, real_max(real_abs(ax[i] - ax[i - 1]), real_abs(ay[i] - ay[i - 1])));
        }
    }
    to->speed = speed + 2 * to->error;
    turn = (2 * n - 2) * (turn + 2 * to->error);
    change = n * (change + 2 * c->node_error * most);
    to->bend =
        n * (1 + 32 * REAL_EPSILON) * (turn + 2 * (longest + to->error) * change / least) / (least * least);
    to->pace_lo = n / (most * most) * (1 - 4 * REAL_EPSILON);
    to->pace_hi = n / (least * least) * (1 + 4 * REAL_EPSILON);
    to->ways = ways;
    to->wide = back;
}

void node_prepare(const struct source *c, struct node *to)
{
    if (to->ready) {
        return;
    }
    to->ready = true;
    if (c->rational) {
        prepare_rational(c, to);
    } else if (c->n == 3) {
        prepare_polynomial(c, 3, to);
    } else {
        prepare_polynomial(c, c->n, to);
    }
}

/* ---- the tree ---- */

/* Nodes 1 and 2 are siblings, 3 and 4, and so on; a lone root takes a pair of places. */
int node_new(struct tree *tree)
{
    int k = tree->spare;
    if (k) {
        tree->spare = tree->node[k].child;
    } else if (tree->used + 2 < NODES_MAX) {
        k = tree->used + 1;
        tree->used += 2;
        for (int i = k; i < k + 2; i++) {
            tree->node[i].points = tree->numbers + (size_t)i * (size_t)tree->stride;
        }
    } else {
        return 0;
    }
    tree->node[k].child = tree->node[k + 1].child = 0;
    return k;
}

/* tests/proofs/halve_cubic.g */
static void halve_cubic(const real *c, real *left, real *right)
{
    const real half = (real)0.5;
    for (int k = 0; k < 2; k++, c += 4, left += 4, right += 4) {
        real a = (c[0] + c[1]) * half, b = (c[1] + c[2]) * half, d = (c[2] + c[3]) * half;
        real e = (a + b) * half, f = (b + d) * half, m = (e + f) * half;
        left[0] = c[0];
        left[1] = a;
        left[2] = e;
        left[3] = right[0] = m;
        right[1] = f;
        right[2] = d;
        right[3] = c[3];
    }
}

int node_split(struct tree *tree, const struct source *c, int k)
{
    if (tree->node[k].child) {
        return tree->node[k].child;
    }
    int first = node_new(tree);
    if (!first) {
        return 0;
    }
    enum { HALVINGS = 4 }; /* as in core/cells.h: the bound of the error counts on it */
    struct node *from = &tree->node[k], *left = &tree->node[first], *right = left + 1;
    real middle = from->lo + (from->hi - from->lo) * (real)0.5;
    int components = c->rational ? 3 : 2;
    left->way = left->points + components * (c->n + 1);
    right->way = right->points + components * (c->n + 1);
    if (from->halved == HALVINGS) {
        node_cut(c, from->lo, middle, left);
        node_cut(c, middle, from->hi, right);
    } else {
        if (c->n == 3 && !c->rational) {
            halve_cubic(from->points, left->points, right->points);
        } else {
            bernstein_halve(c->n, components, from->points, left->points, right->points);
        }
        left->lo = from->lo;
        left->hi = right->lo = middle;
        right->hi = from->hi;
        left->halved = right->halved = from->halved + 1;
        octagon_made(c, left);
        octagon_made(c, right);
    }
    from->child = first;
    return first;
}

/* ---- memory ---- */

/* Frees the pairs of siblings without a mark; `halved` serves as the mark, its sign. */
static void sweep(struct tree *tree)
{
    tree->spare = 0;
    for (int k = 1; k < tree->used; k += 2) {
        struct node *a = &tree->node[k];
        bool kept = a[0].halved < 0 || a[1].halved < 0;
        for (int i = 0; i < 2; i++) {
            if (a[i].child) {
                struct node *below = &tree->node[a[i].child];
                if (below[0].halved >= 0 && below[1].halved >= 0) {
                    a[i].child = 0;
                }
            }
        }
        if (!kept) {
            a[0].child = -1;
        }
    }
    for (int k = 1; k < tree->used; k += 2) {
        struct node *a = &tree->node[k];
        if (a[0].child == -1) {
            a[0].child = tree->spare;
            tree->spare = k;
        }
        for (int i = 0; i < 2; i++) {
            if (a[i].halved < 0) {
                a[i].halved = -1 - a[i].halved;
            }
        }
    }
}

static void mark(struct tree *tree, int k)
{
    if (tree->node[k].halved >= 0) {
        tree->node[k].halved = -1 - tree->node[k].halved;
    }
}

void nodes_collect(struct solver *z)
{
    mark(&z->f, z->root_f);
    mark(&z->g, z->root_g);
    for (int i = 0; i < z->pairs; i++) {
        mark(&z->f, z->pair[i].f);
        mark(&z->g, z->pair[i].g);
    }
    sweep(&z->f);
    sweep(&z->g);
}
