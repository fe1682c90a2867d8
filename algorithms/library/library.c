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
