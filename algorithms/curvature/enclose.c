#include "enclose.h"
#include "planes.h"

enum clip enclose_clip(struct cone *c, const struct half_plane *p, real relaxed)
{
    struct half_plane moved = *p;
    moved.l[2] += relaxed;
    triple_normalise(moved.l);
    return cone_clip(c, &moved);
}

/* false: empty. */
static bool clip_end(struct region_work *k, struct cone *c, int span, real t, real relaxed,
                     enum outcome *outcome)
{
    struct half_plane plane;
    if (!half_plane_at(k, span, t, true, &plane)) {
        return true;
    }
    enum clip clip = enclose_clip(c, &plane, relaxed);
    *outcome = clip == CLIP_FULL ? OUT_OF_ROOM : *outcome;
    return clip != CLIP_EMPTY;
}

static int sign_of(real a)
{
    return a > 0 ? 1 : a < 0 ? -1 : 0;
}

/* At the knot after this span the tangent is no corner line: the envelope goes on smoothly and M keeps its
 * sign. */
static bool goes_on(const struct region_work *k, int span)
{
    const struct span_forms *f = &k->span[span].form, *g = &k->span[span + 1].form;
    return f->m >= 0 && g->m >= 0 && sign_of(f->M[f->m]) == sign_of(g->M[0]) && joint_is_smooth(k, span);
}

bool enclose_ends(struct region_work *k, struct cone *c, bool all, real relaxed, enum outcome *outcome)
{
    bool joint = false; /* the end before this piece was passed over */
    for (int i = 0; i < k->pieces; i++) {
        const struct piece *p = &k->piece[i];
        if (p->lo == 0 && !joint && !clip_end(k, c, p->span, 0, relaxed, outcome)) {
            return false;
        }
        joint = !all && p->hi == 1 && p->span + 1 < k->spans && goes_on(k, p->span);
        if (!joint && !clip_end(k, c, p->span, p->hi, relaxed, outcome)) {
            return false;
        }
    }
    for (int i = 0; i < k->chords; i++) {
        if (enclose_clip(c, &k->chord[i], relaxed) == CLIP_EMPTY) {
            return false;
        }
    }
    return true;
}

static void mark(struct cone *c, int i)
{
    if (c->count > 1 && i < c->count) {
        c->edge[i].holds = true;
    }
}

bool enclose_round(struct region_work *k, struct cone *c, real relaxed, real tolerance, int *cuts,
                   enum outcome *outcome)
{
    real v[3], error;
    struct half_plane worst;
    *cuts = 0;
    for (int i = 0; i < c->count; i++) {
        c->edge[i].fresh = false;
    }
    for (int i = 0; cone_generator(c, i, v, &error); i++) {
        if (c->count > 1 && i < c->count && (c->edge[i].holds || c->edge[i].fresh)) {
            continue;
        }
        enum verdict verdict = planes_hold(k, NULL, NULL, v, error + relaxed + tolerance, &worst);
        if (verdict == UNSURE && k->steps >= k->max_steps) {
            *outcome = OUT_OF_STEPS;
            return true;
        }
        enum clip clip = verdict == FAILS ? enclose_clip(c, &worst, relaxed) : CLIP_NOTHING;
        if (clip == CLIP_EMPTY) {
            return false;
        }
        if (clip == CLIP_FULL) {
            *outcome = OUT_OF_ROOM;
            return true;
        }
        if (clip == CLIP_NOTHING) {
            mark(c, i);
        } else {
            ++*cuts;
        }
    }
    return true;
}

bool enclose(struct region_work *k, struct cone *c, real relaxed, real tolerance, enum outcome *outcome)
{
    int cuts = 1;
    cone_init(c);
    if (!enclose_ends(k, c, true, relaxed, outcome)) {
        return false;
    }
    while (cuts > 0 && *outcome == SOLVED) {
        if (k->steps >= k->max_steps) {
            *outcome = OUT_OF_STEPS;
        } else if (!enclose_round(k, c, relaxed, tolerance, &cuts, outcome)) {
            return false;
        }
    }
    return true;
}
