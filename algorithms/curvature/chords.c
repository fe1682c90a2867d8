#include "chords.h"

#include "cone.h"
#include "form.h"

/* w itself: its sign matters here. */
static void oriented_envelope(const struct region_work *k, int span, real t, real *v)
{
    const struct span_forms *f = &k->span[span].form;
    form_values(f->e, 3, k->pascal, f->w, t, v);
    triple_normalise(v);
}

static bool add_chord(struct region_work *k, const real *from, int span, real t)
{
    real to[3];
    struct half_plane *p = &k->chord[k->chords];
    if (k->chords == k->room_chords) {
        return false;
    }
    oriented_envelope(k, span, t, to);
    triple_meet(from, 8 * REAL_EPSILON, to, 8 * REAL_EPSILON, p->l, &p->error);
    if (p->error >= real_ldexp(1, -REAL_BITS / 2)) { /* as good as the start itself: its tangent says more */
        return true;
    }
    for (int i = 0; i < 3; i++) {
        p->l[i] = k->sign < 0 ? -p->l[i] : p->l[i];
    }
    p->source = CHORD;
    p->corner = true;
    p->span = span;
    p->t = t;
    k->chords++;
    return true;
}

bool chords_make(struct region_work *k)
{
    real from[3], g[FORM_MAX], error[FORM_MAX], root[FORM_MAX];
    oriented_envelope(k, 0, 0, from);
    for (int i = 0; i < k->spans; i++) {
        const struct span_forms *f = &k->span[i].form;
        const real *A = f->L, *B = A + f->l + 1, *C = B + f->l + 1, *E = C + f->l + 1;
        for (int j = 0; j <= f->l; j++) {
            g[j] = A[j] * from[0] + B[j] * from[1] + C[j] * from[2];
            error[j] = 4 * REAL_EPSILON * E[j];
        }
        int roots = form_crossings(k, f->l, g, error, FORM_MAX, root);
        bool room = roots >= 0 && (i == 0 || add_chord(k, from, i, 0)) && add_chord(k, from, i, 1);
        for (int j = 0; room && j < roots; j++) {
            room = add_chord(k, from, i, root[j]);
        }
        if (!room) {
            return false;
        }
    }
    return true;
}
