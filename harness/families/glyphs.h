/* Outlines of real fonts as pairs of curves (FreeType, fontconfig).  Compiled once, as C. */
#ifndef FATLINE_GLYPHS_H
#define FATLINE_GLYPHS_H

#include <stdint.h>
#include <stdio.h>

enum { GLYPH_FONTS_MAX = 8 };

/* fonts: family names separated by commas, at least two; letters: ASCII.  Writes `count` case lines from
 * number `first` on.  0, or 2 with the reason in `why` (a font that is not installed, and the package that
 * has it). */
int glyphs_write(FILE *stream, const char *fonts, const char *letters, uint64_t seed, uint64_t first,
                 uint64_t count, char why[512]);

#endif
