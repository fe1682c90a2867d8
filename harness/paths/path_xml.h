/* What there is to know of XML to read an SVG file.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_PATH_XML_H
#define FATLINE_PATH_XML_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The next tag <name ...> that is not in a comment, or NULL. */
const char *path_xml_tag(const char *text, const char *name);

/* Replaces the five entities of XML and references to characters (&#65; &#x41;) in place, as UTF-8; what is
 * none of these stays as it is. */
void path_xml_decode(char *text);

/* Names of the elements of SVG that draw something and are no path, "rect, use", each once; false: there are
 * none. */
bool path_xml_others(const char *text, char *list, size_t size);

#ifdef __cplusplus
}
#endif
#endif
