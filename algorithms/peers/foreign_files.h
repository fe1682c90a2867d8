/* Where the adapters are: the folder `peers` beside, or above, that of this program, or the environment's
 * FATLINE_PEERS. */
#ifndef FATLINE_FOREIGN_FILES_H
#define FATLINE_FOREIGN_FILES_H

#include <stdbool.h>

/* path: room for PATH_MAX; false if there is no such file. */
bool foreign_path(const char *file, char *path);

#endif
