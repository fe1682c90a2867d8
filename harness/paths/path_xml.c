#include "path_xml.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *path_xml_tag(const char *text, const char *name)
{
    size_t n = strlen(name);

    for (const char *at = text; (at = strchr(at, '<')) != NULL; at++) {
        if (!strncmp(at, "<!--", 4)) {
            if (!(at = strstr(at + 4, "-->")))
                return NULL;
        } else if (!strncmp(at + 1, name, n) && at[n + 1] && strchr(" \t\r\n/>", at[n + 1]))
            return at;
    }
    return NULL;
}

bool path_xml_others(const char *text, char *list, size_t size)
{
    static const char *const shapes[] = {"rect",    "circle", "ellipse", "line",  "polyline",
                                         "polygon", "use",    "text",    "image", NULL};

    list[0] = 0;
    for (int i = 0; shapes[i]; i++) {
        size_t n = strlen(list);

        if (path_xml_tag(text, shapes[i]))
            snprintf(list + n, size - n, "%s%s", n ? ", " : "", shapes[i]);
    }
    return list[0];
}

/* The UTF-8 of a character; returns its bytes, at most 4; 0: it is none. */
static size_t put_character(unsigned long c, char *to)
{
    static const unsigned char lead[] = {0, 0, 0xc0, 0xe0, 0xf0};
    size_t bytes = c < 0x80 ? 1 : c < 0x800 ? 2 : c < 0x10000 ? 3 : 4;

    if (c == 0 || c > 0x10ffff || (c >= 0xd800 && c < 0xe000))
        return 0;
    for (size_t i = bytes - 1; i > 0; i--) {
        to[i] = (char)(0x80 | (c & 0x3f));
        c >>= 6;
    }
    to[0] = (char)(lead[bytes] | c);
    return bytes;
}

/* The reference at `text`, a byte &: its character into `to`, and how many bytes it took; 0: it is none. */
static size_t read_reference(const char *text, char *to, size_t *put)
{
    static const struct {
        const char *name, *character;
    } named[] = {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}};
    int base = text[1] == '#' && text[2] == 'x' ? 16 : 10;
    const char *digits = text + (base == 16 ? 3 : 2);
    char *end;

    for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
        if (!strncmp(text, named[i].name, strlen(named[i].name))) {
            *to = named[i].character[0];
            *put = 1;
            return strlen(named[i].name);
        }
    }
    if (text[1] != '#' || !strspn(digits, base == 16 ? "0123456789abcdefABCDEF" : "0123456789"))
        return 0;
    unsigned long c = strtoul(digits, &end, base);
    *put = *end == ';' ? put_character(c, to) : 0;
    return *put ? (size_t)(end + 1 - text) : 0;
}

/* No reference is shorter than its character: &#9; of one byte, &#x80; of two, &#x800; of three, &#x10000; of
 * four. */
void path_xml_decode(char *text)
{
    char *to = text, character[4];

    while (*text) {
        size_t put = 0, taken = *text == '&' ? read_reference(text, character, &put) : 0;

        if (taken) {
            memcpy(to, character, put);
            text += taken;
            to += put;
        } else {
            *to++ = *text++;
        }
    }
    *to = 0;
}
