/* What the files of the library share.  Public names are those of fatline.h; nothing else is exported. */
#ifndef FATLINE_LIBRARY_H
#define FATLINE_LIBRARY_H

#include "../bezier.h"
#include "../fatline.h"

/* Is `memory` good for so many bytes, as malloc would align them? */
bool memory_fits(const void *memory, size_t size, size_t wanted);

enum fatline_outcome outcome_public(enum outcome o);
void crossing_public(const struct crossing *c, struct fatline_crossing *to);
/* of coordinates that were multiplied by 2^e */
void overlap_public(const struct overlap *o, int e, struct fatline_overlap *to);

#define TOLERANCE_USUAL 1e-12
/* NULL, or a sentence; NULL stands for the usual options. */
const char *options_error(const struct fatline_options *o);

#endif
