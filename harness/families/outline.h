/* The outline of one glyph as segments with integer control points.  Compiled once, as C. */
#ifndef FATLINE_OUTLINE_H
#define FATLINE_OUTLINE_H

#include <stdbool.h>

struct segment {
    int degree; /* 1, 2 or 3 */
    long x[4], y[4];
};

struct outline {
    int count, room;
    struct segment *at;
};

struct font; /* an open font */

/* NULL if it is not installed or cannot be read; why: what to do about it. */
struct font *font_open(const char *family, char why[512]);
void font_close(struct font *font);
const char *font_file(const struct font *font); /* name of the file, without its folder */
long font_units(const struct font *font);       /* units per em */

/* The glyph of a character, in half font units times `factor`; segments that are one point are left out.
 * False if the font has no outline for it.  outline_clear afterwards. */
bool font_outline(struct font *font, unsigned long character, long factor, struct outline *o);
void outline_clear(struct outline *o);

#endif
