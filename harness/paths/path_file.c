#include "path_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../run/progress.h"

static char *read_all(FILE *stream)
{
    char *text = NULL;
    size_t room = 0, size = 0, got;

    do {
        if (size + 1 >= room) {
            room = 2 * room + 65536;
            char *more = realloc(text, room);
            if (!more) {
                free(text);
                errno = ENOMEM;
                return NULL;
            }
            text = more;
        }
        got = fread(text + size, 1, room - size - 1, stream);
        size += got;
    } while (got > 0);
    text[size] = 0;
    if (!ferror(stream))
        return text;
    free(text);
    return NULL;
}

char *path_file_read(const char *file)
{
    int standard = !strcmp(file, "-");
    FILE *stream = standard ? stdin : fopen(file, "r");
    char *text = stream ? read_all(stream) : NULL;

    if (!text)
        progress_note("%s: %s", file, strerror(errno));
    if (stream && !standard)
        fclose(stream);
    return text;
}
