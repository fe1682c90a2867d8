/* A whole file in memory.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_PATH_FILE_H
#define FATLINE_PATH_FILE_H

#ifdef __cplusplus
extern "C" {
#endif

/* The text of `file` ("-": standard input), to be freed; NULL: it cannot be read, which was said on stderr.
 * Bytes 0 end it. */
char *path_file_read(const char *file);

#ifdef __cplusplus
}
#endif
#endif
