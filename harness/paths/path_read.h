/* Files of paths: JSON lines, SVG path data, SVG files.  Compiled for each precision. */
#ifndef FATLINE_PATH_READ_H
#define FATLINE_PATH_READ_H

#include "path_set.h"

/* Adds the paths of `file` ("-": standard input).  0, or an exit status: 2 if it cannot be read, 65 if
 * something in it is wrong; that was then said on stderr, once a line (or path), and the good ones are added.
 */
int path_set_read(struct path_set *set, const char *file);

/* The path as one line of JSON that path_set_read reads back: polynomial segments bit for bit, points of
 * rational ones rounded, subpaths one after the other. */
void path_write(FILE *stream, const struct loaded_path *p);

#endif
