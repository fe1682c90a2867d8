#include <stdlib.h>
#include <string.h>

#include "glyphs.h"
#include "outline.h"
#include "random.h"

/* All letters of all fonts, brought to about the same size by whole factors. */
struct library {
    int fonts, letters;
    struct font *font[GLYPH_FONTS_MAX];
    const char *letter;
    struct outline *outline[GLYPH_FONTS_MAX]; /* one for each letter; empty if the font lacks it */
};

static int open_fonts(struct library *l, const char *names, char why[512])
{
    char *copy = strdup(names), *rest = copy, *name;
    snprintf(why, 512, "--fonts names fewer than two fonts, or more than %d", GLYPH_FONTS_MAX);
    while (copy && l->fonts < GLYPH_FONTS_MAX && (name = strsep(&rest, ","))) {
        name += strspn(name, " ");
        l->font[l->fonts] = font_open(name, why);
        if (!l->font[l->fonts])
            break;
        l->fonts++;
    }
    bool good = copy && !rest && l->fonts >= 2;
    free(copy);
    return good ? 0 : 2;
}

static int load_letters(struct library *l, const char *letters, char why[512])
{
    long most = 0;
    l->letter = letters;
    l->letters = (int)strlen(letters);
    for (int k = 0; k < l->fonts; k++)
        if (font_units(l->font[k]) > most)
            most = font_units(l->font[k]);
    for (int k = 0; k < l->fonts; k++) {
        long units = font_units(l->font[k]), factor = (most + units / 2) / units;
        l->outline[k] = calloc((size_t)l->letters + 1, sizeof *l->outline[k]);
        for (int i = 0; l->outline[k] && i < l->letters; i++)
            if (!font_outline(l->font[k], (unsigned char)letters[i], factor, &l->outline[k][i])) {
                snprintf(why, 512, "%s has no outline of '%c'", font_file(l->font[k]), letters[i]);
                return 2;
            }
    }
    return 0;
}

static void close_library(struct library *l)
{
    for (int k = 0; k < l->fonts; k++) {
        for (int i = 0; l->outline[k] && i < l->letters; i++)
            outline_clear(&l->outline[k][i]);
        free(l->outline[k]);
        font_close(l->font[k]);
    }
}

static void find_range(const long *c, int n, long *lo, long *hi)
{
    *lo = *hi = c[0];
    for (int i = 1; i <= n; i++) {
        *lo = c[i] < *lo ? c[i] : *lo;
        *hi = c[i] > *hi ? c[i] : *hi;
    }
}

/* Do the boxes of the control points, the second moved by (dx, dy), have a point in common? */
static bool boxes_meet(const struct segment *a, const struct segment *b, long dx, long dy)
{
    long alo, ahi, blo, bhi;
    find_range(a->x, a->degree, &alo, &ahi);
    find_range(b->x, b->degree, &blo, &bhi);
    if (ahi < blo + dx || bhi + dx < alo)
        return false;
    find_range(a->y, a->degree, &alo, &ahi);
    find_range(b->y, b->degree, &blo, &bhi);
    return alo <= bhi + dy && blo + dy <= ahi;
}

struct choice {
    int font[2], letter[2];
    int segment[2];
    long dx, dy; /* the second outline was moved so */
};

/* Two outlines laid on each other: mostly the same letter of two fonts, every eighth time two letters, every
 * eighth time an outline on itself, moved by a few units. */
static void choose_outlines(const struct library *l, uint64_t index, struct random_state *r, struct choice *c)
{
    c->font[0] = (int)random_between(r, 0, l->fonts - 1);
    c->font[1] = (c->font[0] + (int)random_between(r, 1, l->fonts - 1)) % l->fonts;
    c->letter[0] = c->letter[1] = (int)random_between(r, 0, l->letters - 1);
    c->dx = 2 * random_between(r, -20, 20);
    c->dy = 2 * random_between(r, -20, 20);
    if (index % 8 == 3)
        c->letter[1] = (int)random_between(r, 0, l->letters - 1);
    if (index % 8 == 7)
        c->font[1] = c->font[0], c->dx = 2 * random_between(r, -2, 2), c->dy = 2 * random_between(r, -2, 2);
}

/* Two segments of these outlines whose boxes meet: a line and a curve in every fourth case, else two curves;
 * not the same one unmoved. */
static bool choose_segments(const struct library *l, uint64_t index, struct random_state *r, struct choice *c)
{
    const struct outline *a = &l->outline[c->font[0]][c->letter[0]],
                         *b = &l->outline[c->font[1]][c->letter[1]];
    bool same = a == b && c->dx == 0 && c->dy == 0;
    for (int trial = 0; trial < 1000; trial++) {
        c->segment[0] = (int)random_between(r, 0, a->count - 1);
        c->segment[1] = (int)random_between(r, 0, b->count - 1);
        const struct segment *f = &a->at[c->segment[0]], *g = &b->at[c->segment[1]];
        int lines = (f->degree == 1) + (g->degree == 1);
        if (lines == (index % 4 == 1) && !(same && f == g) && boxes_meet(f, g, c->dx, c->dy))
            return true;
    }
    return false;
}

static void put_segment(FILE *stream, const char *name, const struct segment *a, long dx, long dy)
{
    fprintf(stream, ", \"%s\": {\"degree\": %d, \"points\": [", name, a->degree);
    for (int i = 0; i <= a->degree; i++)
        fprintf(stream, "%s[\"%ld\", \"%ld\"]", i ? ", " : "", a->x[i] + dx, a->y[i] + dy);
    fputs("], \"f64\": [", stream);
    for (int i = 0; i <= a->degree; i++)
        fprintf(stream, "%s[%ld, %ld]", i ? ", " : "", a->x[i] + dx, a->y[i] + dy);
    fputs("]}", stream);
}

/* A letter as it may stand in a JSON string. */
static void put_letter(FILE *stream, char letter)
{
    fprintf(stream, letter == '"' || letter == '\\' ? "\\%c" : "%c", letter);
}

static void put_case(FILE *stream, const struct library *l, const struct choice *c, uint64_t seed,
                     uint64_t index)
{
    fprintf(stream, "{\"id\": \"glyphs-%llu-%llu\", \"family\": \"glyphs\", \"source\": \"outlines of ",
            (unsigned long long)seed, (unsigned long long)index);
    fprintf(stream, "%s and %s, seed %llu\", \"note\": \"", font_file(l->font[c->font[0]]),
            font_file(l->font[c->font[1]]), (unsigned long long)seed);
    for (int k = 0; k < 2; k++) {
        fprintf(stream, "%s[", k ? " x " : "");
        put_letter(stream, l->letter[c->letter[k]]);
        fprintf(stream, "]#%d", c->segment[k]);
    }
    fprintf(stream, ", the second moved by (%ld, %ld)\"", c->dx, c->dy);
    put_segment(stream, "f", &l->outline[c->font[0]][c->letter[0]].at[c->segment[0]], 0, 0);
    put_segment(stream, "g", &l->outline[c->font[1]][c->letter[1]].at[c->segment[1]], c->dx, c->dy);
    fputs("}\n", stream);
}

int glyphs_write(FILE *stream, const char *fonts, const char *letters, uint64_t seed, uint64_t first,
                 uint64_t count, char why[512])
{
    struct library l = {0};
    int status = open_fonts(&l, fonts, why);
    status = status ? status : load_letters(&l, letters, why);
    for (uint64_t index = first; !status && index - first < count; index++) {
        struct random_state r = random_for(seed, "glyphs", index);
        struct choice c;
        int trial = 0;
        do
            choose_outlines(&l, index, &r, &c);
        while (!choose_segments(&l, index, &r, &c) && ++trial < 1000);
        if (trial == 1000) {
            snprintf(why, 512, "no two curves of these letters, or no line and curve, meet");
            status = 2;
        } else {
            put_case(stream, &l, &c, seed, index);
        }
    }
    close_library(&l);
    return status;
}
