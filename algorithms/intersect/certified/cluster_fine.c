/* What rounding hides in a closer look, with twice the digits.
 *
 * In a level of its own a contact of order k is still hidden where the gap is below rounding of the level's
 * points, and a level in it gains little: its points are as large, against it, as its width, the gap falls
 * with the k-th power of it.  But the points are known to twice the digits; with these the gap's Taylor
 * coefficients are (gap_fine.c), taken in the middle of the stretch that holds the zeros, where the remainder
 * is least; again and again while that halves it.  Then stretches that are apart are refined each by itself.
 *
 * At the end each holds at most p zeros, with multiplicity, if the p-th derivative has one sign on it and on
 * what rounding of the problem's parameters adds at its ends: a CLUSTER of p, or, p = 1, the zero that there
 * is if G changes sign across it.  All of them or none: OPEN leaves the pair as it was. */
#include "gap_model.h"

/* One record to be. */
struct held {
    struct zero x;
    int at_most;
    bool exists;
};

struct sharpening {
    struct solver *z;
    int level;
    const struct node *f, *g;
    const struct source *loose, *graph;
    real pad; /* what rounding of the problem's parameters adds to a stretch */
    int most, count;
    struct held at[STRETCHES_MAX];
};

/* Clusters of more than `most` only where they are narrow.  A stretch that gets no narrower; `in` holds no
 * other zeros. */
static bool finish(struct sharpening *h, const struct gap_model *c, const struct stretch *in,
                   const struct stretch *s)
{
    const real narrow = (real)1 / 256;
    real width = s->hi - s->lo, size;
    struct stretch wide = {real_max(s->lo - h->pad, (real)0), real_min(s->hi + h->pad, (real)1)};
    int p = gap_order(c, &wide, &size);
    if (p == 0 || (p > h->most && width > narrow) || h->count == STRETCHES_MAX) {
        return false;
    }
    struct held *to = &h->at[h->count++];
    gap_region(c, s, h->f, h->g, &to->x);
    to->at_most = p;
    to->exists = p == 1 && gap_crosses(c, s, in);
    return region_is_whole(h->z, h->level, h->f, h->g, &to->x);
}

/* Makes the model anew near the middle of the stretch, where the graph reaches so far. */
static bool look_near(struct sharpening *h, const struct stretch *in, struct gap_model *c)
{
    real at = (in->lo + in->hi) / 2;
    for (int k = 0; k < 4 && gap_model_centre(c, at) && real_abs(c->ahead) > c->far; k++) {
        at = real_min(real_max(at - c->ahead / c->x.c[1].mid, (real)0), (real)1);
    }
    return gap_model_sharpen(h->loose, h->graph, at, c);
}

/* The zeros in `in`, again and again while that halves one stretch; `in` ends as the last one looked at.
 * Negative: there is no model. */
static int narrow_down(struct sharpening *h, struct stretch *in, struct gap_model *c,
                       struct stretch s[STRETCHES_MAX])
{
    enum { ROUNDS = 8 };
    int count = 1;
    for (int k = 0; k < ROUNDS; k++) {
        if (!look_near(h, in, c)) {
            return -1;
        }
        count = gap_stretches(c, in, s);
        if (count != 1 || !(s[0].hi - s[0].lo < (in->hi - in->lo) / 2) || gap_is_limited(c, in)) {
            break;
        }
        *in = s[0];
    }
    return count;
}

/* The same by looking at so many parts of the stretch; those that touch are one. */
static int look_at_parts(struct sharpening *h, const struct stretch *in, int parts, struct gap_model *c,
                         struct stretch s[STRETCHES_MAX])
{
    real width = in->hi - in->lo;
    int count = 0;
    for (int i = 0; i < parts; i++) {
        struct stretch found[STRETCHES_MAX], part = {in->lo + width * ((real)i / (real)parts), in->hi};
        if (i + 1 < parts) {
            part.hi = in->lo + width * ((real)(i + 1) / (real)parts);
        }
        if (!look_near(h, &part, c)) {
            return -1;
        }
        int more = gap_stretches(c, &part, found);
        for (int k = 0; k < more; k++) {
            if (count > 0 && (found[k].lo <= s[count - 1].hi || count == STRETCHES_MAX)) {
                s[count - 1].hi = found[k].hi;
            } else {
                s[count++] = found[k];
            }
        }
    }
    return count;
}

/* All zeros in `in`, which lie in `at`; false: something cannot be told. */
static bool refine(struct sharpening *h, const struct gap_model *model, const struct stretch *in,
                   const struct stretch *at, int depth)
{
    enum { DEPTH = 3, PARTS = 4 };
    struct gap_model c = *model;
    struct stretch s[STRETCHES_MAX], last = *at;
    int count = narrow_down(h, &last, &c, s);
    if (count == 1 && (depth == DEPTH || gap_is_limited(&c, &s[0]))) {
        return finish(h, &c, in, &s[0]);
    }
    if (count == 1) {
        last = s[0];
        count = look_at_parts(h, &last, PARTS << depth, &c, s);
    }
    for (int i = 0; i < count; i++) {
        struct stretch part = {i > 0 ? (s[i - 1].hi + s[i].lo) / 2 : in->lo,
                               i < count - 1 ? (s[i].hi + s[i + 1].lo) / 2 : in->hi};
        if (depth < DEPTH ? !refine(h, &c, &part, &s[i], depth + 1) : !finish(h, &c, &part, &s[i])) {
            return false;
        }
    }
    return count >= 0;
}

enum verdict cluster_sharpen(struct solver *z, const struct pair *at, const struct gap_model *c, int most,
                             int count, const struct stretch *s)
{
    const struct level *v = &z->level[at->level];
    real width = c->f_is_graph ? v->s.hi - v->s.lo : v->t.hi - v->t.lo;
    struct sharpening h = {z,
                           at->level,
                           &z->f.node[at->f],
                           &z->g.node[at->g],
                           c->f_is_graph ? &v->g : &v->f,
                           c->f_is_graph ? &v->f : &v->g,
                           8 * REAL_EPSILON / width,
                           most,
                           0};
    for (int i = 0; i < count; i++) {
        if (!refine(&h, c, &s[i], &s[i], 0)) {
            return OPEN;
        }
    }
    for (int i = 0; i < h.count; i++) {
        region_record(z, at->level, &h.at[i].x, h.at[i].at_most, h.at[i].exists);
    }
    return CLOSED;
}
