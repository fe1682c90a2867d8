/* Fronts: kernels for the ordinary pair of curves, in front of the engine for all pairs.
 *
 * A front kernel settles what it can prove quickly, in doubles and with the instructions of one kind of
 * processor: parts that are apart, and simple crossings.  The rest it leaves as rectangles of parameters to
 * the engine (certified.c), which cuts them from the originals and goes on from there: contacts, clusters,
 * overlaps, zeros near a cut, whatever is not as narrow as asked, and everything once too much is open.  So
 * every claim beyond a simple crossing is made in one place.
 *
 * What a kernel promises: every solution of the pair lies in a record or in a rectangle of the rest, each
 * record holds exactly one zero (UNIQUE, or END within its radius of an end of a domain), no zero has two
 * records, and no record's zero lies in a rectangle of the rest but for rounding at a common border: there
 * zero_prove (ends.c) sees that it has been reported. */
#ifndef FATLINE_CERTIFIED_FRONT_H
#define FATLINE_CERTIFIED_FRONT_H

#include <string.h>

#include "../../bezier.h"

/* What a kernel is given: two polynomial curves, in the order in which they are to be taken, whose domains
 * are taken for [0, 1]; nothing is known about their coordinates. */
struct front {
    const struct curve *f, *g;
    real tolerance_t, tolerance_s; /* 4 REAL_EPSILON to 1/16; read as a pair */
    int steps, max_steps;          /* taken: the kernel counts them; at most so many */
    struct crossings *out;         /* records are added, with t and s as for f and g */
    struct rest *rest;
    bool many;     /* kernels for many pairs of parts at once may be used */
    real *scratch; /* memory of the call, of scratch_length numbers */
    size_t scratch_length;
};

/* Every solution in the rectangle is left to the engine; false: there are too many rectangles, so now
 * everything is left, no record stays, and the kernel has nothing more to do. */
static inline bool front_leave(struct front *z, struct interval t, struct interval s)
{
    if (z->rest->count < REST_MAX) {
        z->rest->at[z->rest->count].t = t;
        z->rest->at[z->rest->count].s = s;
        z->rest->count++;
        return true;
    }
    z->out->count = 0;
    z->rest->count = 1;
    z->rest->at[0].t.lo = z->rest->at[0].s.lo = 0;
    z->rest->at[0].t.hi = z->rest->at[0].s.hi = 1;
    return false;
}

/* A record of the one zero in (t +- rt) x (s +- rs), which is no cut's neighbour; false: it is wider than
 * asked, and nothing has been done. */
static inline bool front_zero(struct front *z, real t, real rt, real s, real rs)
{
    struct crossing *c = &z->out->at[z->out->count];
    real t_lo = t - rt, t_hi = t + rt, s_lo = s - rs, s_hi = s + rs;
    bool is_end = (t_lo <= 0) | (t_hi >= 1) | (s_lo <= 0) | (s_hi >= 1);
    t_lo = real_max(t_lo, (real)0);
    s_lo = real_max(s_lo, (real)0);
    t_hi = real_min(t_hi, (real)1);
    s_hi = real_min(s_hi, (real)1);
    if (t_hi - t_lo > z->tolerance_t || s_hi - s_lo > z->tolerance_s || z->out->count == CROSSINGS_MAX) {
        return false;
    }
    if (t_lo > t_hi || s_lo > s_hi) {
        return true; /* beyond the domain after all */
    }
    c->t.lo = t_lo;
    c->t.hi = t_hi;
    c->s.lo = s_lo;
    c->s.hi = s_hi;
    c->standing = is_end ? END : UNIQUE;
    c->at_most = 1;
    c->multiplicity = is_end ? 0 : 1;
    z->out->count++;
    return true;
}

static inline bool curve_is_plain(const struct curve *c)
{
    static const struct interval whole = {0, 1};
    return !c->w && !memcmp(&c->domain, &whole, sizeof whole);
}

/* Two polynomial curves over [0, 1], and a question that is one; nothing is known about their coordinates and
 * degrees. */
static inline bool front_is_plain(const struct problem *p)
{
    return curve_is_plain(&p->f) && curve_is_plain(&p->g) && p->tolerance > 0 && p->tolerance <= REAL_HUGE &&
           p->max_steps > 0;
}

/* For a plain problem: *z, with the curves in the order of problem_solve; true: they are exchanged. */
bool front_open(struct front *z, const struct problem *p, struct crossings *out, struct rest *rest);
/* What a kernel has done, in the caller's order of the curves if that was all. */
enum front_answer front_close(const struct front *z, bool swapped, struct workspace *w);

/* The kernel for these degrees and this processor, if there is one; false: there is none, or it does not take
 * these numbers, and nothing has been done.  Degrees and domains are those of problems. */
bool front_run(struct front *z);
/* Numbers of scratch memory that a kernel for these degrees may need. */
size_t front_scratch(int n, int m);

/* The fronts of `certified` and, without kernels for many pairs of parts, `certified_avx2` (struct
 * intersector). */
enum front_answer front_of_certified(const struct problem *p, struct workspace *w, struct crossings *out,
                                     struct rest *rest);
enum front_answer front_of_certified_avx2(const struct problem *p, struct workspace *w, struct crossings *out,
                                          struct rest *rest);
/* The same for a prepared problem; true: `rest`, perhaps empty, is all that is left. */
bool front_of_prepared(bool many, const struct problem *p, struct workspace *w, struct crossings *out,
                       struct rest *rest);

/* ---- kernels, each in files of its own; false: it does not take these numbers ---- */

#if defined(__x86_64__) && !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)
#define FATLINE_AVX2 __attribute__((target("avx2,fma")))
FATLINE_AVX2 bool front_cubic_avx2(struct front *z); /* degrees 1 to 3 */
FATLINE_AVX2 bool front_any_avx2(struct front *z);   /* any; it needs scratch */
size_t front_any_scratch(int n, int m);              /* so many numbers */
/* The front of `certified` for two cubics: pairs that are apart cost little more than reading them. */
FATLINE_AVX2 enum front_answer front_cubics(const struct problem *p, struct workspace *w,
                                            struct crossings *out, struct rest *rest);
FATLINE_AVX2 enum front_answer front_cubics_avx2(const struct problem *p, struct workspace *w,
                                                 struct crossings *out, struct rest *rest);
#endif

#endif
