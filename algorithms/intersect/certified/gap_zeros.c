/* Zeros of the gap: where, and at most how many.
 *
 * core/roots.c encloses all zeros of the polynomials within the radii of G's Bernstein coefficients; the true
 * G is, at every t, the value of one of them. */
#include "../../core/roots.h"
#include "gap_model.h"

enum { ROOTS_SCRATCH = 32 + 2 * (REAL_BITS + 16) };

/* 1.5 eps of the ends by the map from [0, 1]. */
int gap_stretches(const struct gap_model *c, const struct stretch *in, struct stretch *out)
{
    struct ball g[SERIES + 1];
    real value[SERIES + 1], error[SERIES + 1], scratch[ROOTS_SCRATCH], wide = in->hi - in->lo;
    struct root root[STRETCHES_MAX];
    gap_model_bernstein(c, 0, in->lo, in->hi, g);
    for (int i = 0; i <= SERIES; i++) {
        value[i] = g[i].mid;
        error[i] = g[i].rad;
    }
    int count = roots_find(SERIES, value, error, REAL_EPSILON, scratch, STRETCHES_MAX, root);
    int kept = 0;
    for (int i = 0; i < count; i++) {
        real lo = in->lo + wide * root[i].lo, hi = in->lo + wide * root[i].hi;
        struct stretch *s = &out[kept];
        s->lo = real_max(in->lo, lo - 2 * REAL_EPSILON * lo);
        s->hi = real_min(in->hi, hi + 2 * REAL_EPSILON * hi);
        kept += gap_model_reach(c, s->lo, s->hi) != BEYOND;
    }
    return kept;
}

int gap_order(const struct gap_model *c, const struct stretch *s, real *size)
{
    for (int p = 1; p <= SERIES; p++) {
        struct ball g[SERIES + 1];
        gap_model_bernstein(c, p, s->lo, s->hi, g);
        int up = 0, down = 0;
        *size = 0;
        for (int i = 0; i <= SERIES - p; i++) {
            up += g[i].mid > g[i].rad;
            down += -g[i].mid > g[i].rad;
            *size = real_max(*size, ball_most(g[i]));
        }
        if (up > SERIES - p || down > SERIES - p) {
            return p;
        }
    }
    return 0;
}

bool gap_is_limited(const struct gap_model *c, const struct stretch *s)
{
    const int many = 4;
    real d = real_max(c->at - s->lo, s->hi - c->at), dd = d * d;
    return c->gap.c[SERIES].rad * (dd * dd * dd) <= c->noise && c->gap.c[0].rad <= many * c->noise;
}

bool gap_crosses(const struct gap_model *c, const struct stretch *s, const struct stretch *in)
{
    real width = s->hi - s->lo, lo = real_max(s->lo - width, in->lo), hi = real_min(s->hi + width, in->hi);
    struct ball g[SERIES + 1];
    gap_model_bernstein(c, 0, lo, hi, g);
    const struct ball *a = &g[0], *b = &g[SERIES];
    return gap_model_reach(c, lo, hi) == INSIDE && ball_least(*a) > 0 && ball_least(*b) > 0 &&
           (a->mid > 0) != (b->mid > 0);
}

void gap_region(const struct gap_model *c, const struct stretch *s, const struct node *f,
                const struct node *g, struct zero *out)
{
    const struct node *loose = c->f_is_graph ? g : f, *graph = c->f_is_graph ? f : g;
    real as, rs, wide = loose->hi - loose->lo, across = graph->hi - graph->lo;
    gap_model_place(c, s->lo, s->hi, &as, &rs);
    real t = loose->lo + wide * ((s->lo + s->hi) / 2), rt = wide * ((s->hi - s->lo) / 2) + 2 * REAL_EPSILON;
    real at = graph->lo + across * as, rat = across * rs + 2 * REAL_EPSILON;
    out->t = c->f_is_graph ? at : t;
    out->rt = c->f_is_graph ? rat : rt;
    out->s = c->f_is_graph ? t : at;
    out->rs = c->f_is_graph ? rt : rat;
}
