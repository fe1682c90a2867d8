#include "crossings.h"

static bool touch(const struct interval *a, const struct interval *b)
{
    return a->lo <= b->hi && b->lo <= a->hi;
}

static void join(struct interval *a, const struct interval *b)
{
    a->lo = real_min(a->lo, b->lo);
    a->hi = real_max(a->hi, b->hi);
}

/* Cells come depth first, so that what touches was mostly added shortly before: merges every candidate into a
 * touching one among the NEAR before it. */
enum { NEAR = 16 };

static void merge_touching(struct crossings *out)
{
    int kept = 0;
    for (int i = 0; i < out->count; i++) {
        struct crossing c = out->at[i];
        int last = kept > NEAR ? kept - NEAR : 0, j = c.standing == CANDIDATE ? kept - 1 : -1;
        while (j >= last && !(out->at[j].standing == CANDIDATE && touch(&out->at[j].t, &c.t) &&
                              touch(&out->at[j].s, &c.s))) {
            j--;
        }
        if (j >= last && j >= 0) {
            join(&out->at[j].t, &c.t);
            join(&out->at[j].s, &c.s);
            out->at[j].at_most = 0;
        } else {
            out->at[kept++] = c;
        }
    }
    out->count = kept;
}

/* Joins every candidate with the one before it if that is still single: half as many are left. */
static void merge_pairs(struct crossings *out)
{
    int kept = 0;
    bool single = false;
    for (int i = 0; i < out->count; i++) {
        struct crossing c = out->at[i];
        if (single && c.standing == CANDIDATE) {
            join(&out->at[kept - 1].t, &c.t);
            join(&out->at[kept - 1].s, &c.s);
            out->at[kept - 1].at_most = 0;
            single = false;
        } else {
            out->at[kept++] = c;
            single = c.standing == CANDIDATE;
        }
    }
    out->count = kept;
}

void crossings_add(struct crossings *out, const struct crossing *c)
{
    if (out->count == CROSSINGS_MAX) {
        out->merged = true;
        merge_touching(out);
        if (out->count > CROSSINGS_MAX / 2) {
            merge_pairs(out);
        }
    }
    if (out->count < CROSSINGS_MAX) {
        out->at[out->count++] = *c;
        return;
    }
    int k = CROSSINGS_MAX -
            1; /* no two candidates stand together: c goes into the last one, or takes its place */
    while (k > 0 && out->at[k].standing != CANDIDATE) {
        k--;
    }
    join(&out->at[k].t, &c->t);
    join(&out->at[k].s, &c->s);
    out->at[k].standing = CANDIDATE;
    out->at[k].at_most = out->at[k].multiplicity = 0;
}

static bool precedes(const struct crossing *a, const struct crossing *b)
{
    if (a->t.lo != b->t.lo) {
        return a->t.lo < b->t.lo;
    }
    if (a->s.lo != b->s.lo) {
        return a->s.lo < b->s.lo;
    }
    return a->t.hi != b->t.hi ? a->t.hi < b->t.hi : a->s.hi < b->s.hi;
}

void crossings_sort(struct crossings *out)
{
    int gap = 1; /* few records mostly come nearly in order */
    while (out->count > NEAR && gap < out->count / 3) {
        gap = 3 * gap + 1;
    }
    for (; gap > 0; gap /= 3) {
        for (int i = gap; i < out->count; i++) {
            if (!precedes(&out->at[i], &out->at[i - gap])) {
                continue;
            }
            struct crossing c = out->at[i];
            int j = i;
            for (; j >= gap && precedes(&c, &out->at[j - gap]); j -= gap) {
                out->at[j] = out->at[j - gap];
            }
            out->at[j] = c;
        }
    }
}
