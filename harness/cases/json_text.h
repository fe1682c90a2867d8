/* JSON on one line, with the shortest texts of doubles that read back bit for bit. */
#ifndef FATLINE_JSON_TEXT_H
#define FATLINE_JSON_TEXT_H

#include <jansson.h>
#include <stdio.h>

void json_text_write(FILE *stream, const json_t *v); /* no line end */

#endif
