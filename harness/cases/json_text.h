/* JSON on one line, with the shortest texts of doubles that read back bit for bit. */
#ifndef FATLINE_JSON_TEXT_H
#define FATLINE_JSON_TEXT_H

#include <jansson.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

void json_text_write(FILE *stream, const json_t *v);         /* no line end */
void json_text_write_string(FILE *stream, const char *text); /* null where it is not UTF-8 */

json_t *json_number_or_null(double a); /* null where it is not finite */

#ifdef __cplusplus
}
#endif

#endif
