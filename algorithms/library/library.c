/* Names, memory, and the only intersector that the library knows. */
#include <float.h>
#include <stdint.h>
#include <string.h>

#include "library.h"

/* The proofs count on every operation being rounded once, to double. */
_Static_assert(FLT_EVAL_METHOD == 0, "double arithmetic has to be done in double: on x86, SSE2");
_Static_assert((int)FATLINE_DEGREE_MAX == (int)DEGREE_MAX &&
                   (int)FATLINE_CROSSINGS_MAX == (int)CROSSINGS_MAX &&
                   (int)FATLINE_OVERLAPS_MAX == (int)OVERLAPS_MAX,
               "fatline.h says other limits than bezier.h");

extern const struct intersector certified;

/* Stands for registry.c, which would bring all the other algorithms along. */
const struct intersector *intersector_find(const char *name)
{
    return strcmp(name, certified.name) ? NULL : &certified;
}

bool memory_fits(const void *memory, size_t size, size_t wanted)
{
    return memory && wanted > 0 && size >= wanted && (uintptr_t)memory % _Alignof(max_align_t) == 0;
}

enum fatline_outcome outcome_public(enum outcome o)
{
    return o == SOLVED         ? FATLINE_SOLVED
           : o == OUT_OF_STEPS ? FATLINE_OUT_OF_STEPS
           : o == OUT_OF_ROOM  ? FATLINE_OUT_OF_ROOM
           : o == UNSUPPORTED  ? FATLINE_UNSUPPORTED
                               : FATLINE_INVALID;
}

void crossing_public(const struct crossing *c, struct fatline_crossing *to)
{
    static const enum fatline_standing standing[] = {FATLINE_CANDIDATE, FATLINE_UNIQUE, FATLINE_END,
                                                     FATLINE_CLUSTER};
    to->t_lo = c->t.lo;
    to->t_hi = c->t.hi;
    to->s_lo = c->s.lo;
    to->s_hi = c->s.hi;
    to->standing = standing[c->standing];
    to->at_most = c->standing == CANDIDATE ? 0 : c->at_most;
}

void overlap_public(const struct overlap *o, int e, struct fatline_overlap *to)
{
    to->t_outer_lo = o->t_outer.lo;
    to->t_outer_hi = o->t_outer.hi;
    to->s_outer_lo = o->s_outer.lo;
    to->s_outer_hi = o->s_outer.hi;
    to->t_inner_lo = o->t_inner.lo;
    to->t_inner_hi = o->t_inner.hi;
    to->s_inner_lo = o->s_inner.lo;
    to->s_inner_hi = o->s_inner.hi;
    to->distance = real_ldexp(o->distance, -e);
    to->reversed = o->reversed;
}

const char *options_error(const struct fatline_options *o)
{
    if (o && (!(o->tolerance >= 0) || !real_is_finite(o->tolerance))) {
        return "the tolerance is not finite and at least 0";
    }
    return o && o->max_steps < 0 ? "max_steps is negative" : NULL;
}

const char *fatline_version(void)
{
    return FATLINE_VERSION;
}

const char *fatline_outcome_text(enum fatline_outcome outcome)
{
    static const char *const texts[] = {"solved", "out of steps", "out of room", "not supported",
                                        "invalid input"};
    return (unsigned)outcome < sizeof texts / sizeof *texts ? texts[outcome] : "no outcome";
}

const char *fatline_standing_text(enum fatline_standing standing)
{
    static const char *const texts[] = {"candidate", "unique", "end", "cluster"};
    return (unsigned)standing < sizeof texts / sizeof *texts ? texts[standing] : "no standing";
}

const char *fatline_kind_text(enum fatline_kind kind)
{
    static const char *const texts[] = {"empty", "bounded", "unbounded", "plane"};
    return (unsigned)kind < sizeof texts / sizeof *texts ? texts[kind] : "no kind";
}
