/* Branch and bound over [0, 1]^2.  A cell is dropped only when doubles with error bounds separate its two
 * pieces (referee_cells.h), when it lies in the domain of a root found before, or when Krawczyk's test in
 * binary128 decides it (referee_krawczyk.h); else it is halved.  So on success every solution is among the
 * roots, each proved to exist and to be the only one in its domain. */
#include "referee.h"

#include <quadmath.h>
#include <stdlib.h>
#include <string.h>

#include "referee_cells.h"
#include "../cases/case_fields.h"
#include "referee_pair.h"
#include "referee_truth.h"
#include "../run/memory.h"

enum {
    HALVINGS_MAX = 96,            /* of one curve */
    STACK = 2 * HALVINGS_MAX + 2, /* depth first: one waiting cell a halving */
    CELLS_BASE = 20000,
    CELLS_EACH = 500, /* visits allowed: base + each * n m */
    CUT_EVERY = 8     /* halvings before a blurred cell is cut again */
};

struct search {
    struct quad_pair pair;
    struct anchored_cell *stack;
    int waiting;
    struct quad_root *root;
    int roots, room;
    long cells;
};

static struct quad_interval range(const struct anchored_part *p)
{
    struct quad_interval r = {p->lo, p->lo + p->width}; /* dyadic of at most HALVINGS_MAX bits: exact */
    return r;
}

static bool within(struct quad_interval a, struct quad_interval b)
{
    return a.lo >= b.lo && a.hi <= b.hi;
}

static bool is_known(const struct search *q, struct quad_interval t, struct quad_interval s)
{
    for (int i = 0; i < q->roots; i++)
        if (within(t, q->root[i].domain[0]) && within(s, q->root[i].domain[1]))
            return true;
    return false;
}

/* b's root lies in a's domain, so it is a's. */
static bool holds(const struct quad_root *a, const struct quad_root *b)
{
    for (int i = 0; i < 2; i++)
        if (b->at[i] - b->radius[i] < a->domain[i].lo || b->at[i] + b->radius[i] > a->domain[i].hi)
            return false;
    return true;
}

static bool differ(const struct quad_root *a, const struct quad_root *b)
{
    for (int i = 0; i < 2; i++)
        if (fabsq(a->at[i] - b->at[i]) > 2 * (a->radius[i] + b->radius[i]))
            return true;
    return false;
}

/* False if it cannot be told whether the root is a new one. */
static bool add_root(struct search *q, const struct quad_root *r)
{
    for (int i = 0; i < q->roots; i++) {
        if (holds(&q->root[i], r) || holds(r, &q->root[i]))
            return true;
        if (!differ(&q->root[i], r))
            return false;
    }
    if (q->roots == q->room)
        return false;
    q->root[q->roots++] = *r;
    return true;
}

/* Halves the larger piece, or the other if that is at its limit; false if both are. */
static bool split(struct search *q, struct anchored_cell *c, bool f)
{
    if ((f ? c->f : c->g).halvings == HALVINGS_MAX)
        f = !f;
    if ((f ? c->f : c->g).halvings == HALVINGS_MAX)
        return false;
    anchored_halve(&q->pair, c, f, &q->stack[q->waiting++]);
    q->stack[q->waiting++] = *c;
    return true;
}

/* NULL, or why it cannot go on. */
static const char *take(struct search *q, struct anchored_cell *c)
{
    struct quad_interval t = range(&c->f), s = range(&c->g);
    struct quad_root root;

    if (is_known(q, t, s))
        return NULL;
    struct anchored_view view = anchored_look(&q->pair, c);
    if (view.apart)
        return NULL;
    if (view.blurred && c->since_cut >= CUT_EVERY) {
        if (!anchored_cut(&q->pair, c))
            return "a weight is too small beside the others";
        view = anchored_look(&q->pair, c);
        if (view.apart)
            return NULL;
    }
    if (view.promising)
        switch (krawczyk_test(&q->pair, t, s, &root)) {
        case NO_ROOT:
            return NULL;
        case ONE_ROOT:
            return add_root(q, &root) ? NULL : "two roots are too near to each other";
        case UNDECIDED:
            break;
        }
    return split(q, c, view.split_f) ? NULL : "a cell stayed undecided (contact, overlap, or degenerate)";
}

static const char *find_roots(struct search *q)
{
    struct anchored_cell *root = &q->stack[0], c;
    long limit = CELLS_BASE + (long)CELLS_EACH * q->pair.f.degree * q->pair.g.degree;
    const char *why = NULL;

    memset(root, 0, sizeof *root);
    root->f.width = root->g.width = 1;
    q->waiting = 1;
    if (!anchored_cut(&q->pair, root))
        return "a weight is too small beside the others";
    while (q->waiting && !why) {
        c = q->stack[--q->waiting];
        why = ++q->cells > limit ? "too many cells (overlap, or nearly)" : take(q, &c);
    }
    return why;
}

const char *referee_solve(struct test_case *c)
{
    struct referee_pair exact;
    struct search q;
    const char *why;

    if (c->f.degree < 1 || c->g.degree < 1 || c->f.degree > QUAD_DEGREE_MAX || c->g.degree > QUAD_DEGREE_MAX)
        return "degree beyond 1 to 32";
    memset(&q, 0, sizeof q);
    referee_pair_make(c, &exact);
    referee_pair_round(&exact, &q.pair);
    q.room = 2 * c->f.degree * c->g.degree; /* the bidegrees' bound on isolated zeros of H */
    q.root = memory_new((size_t)q.room, sizeof *q.root);
    q.stack = memory_new(STACK, sizeof *q.stack);
    why = find_roots(&q);
    if (!why)
        why = referee_truth(c, &exact, q.root, q.roots);
    free(q.stack);
    free(q.root);
    referee_pair_clear(&exact);
    return why;
}
