/* What the files of the library share.  Public names are those of fatline.h; nothing else is exported. */
#ifndef FATLINE_LIBRARY_H
#define FATLINE_LIBRARY_H

#include "../bezier.h"
#include "../fatline.h"

/* Is `memory` good for so many bytes, as malloc would align them? */
bool memory_fits(const void *memory, size_t size, size_t wanted);

enum fatline_outcome outcome_public(enum outcome o);

#endif
