#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "outline.h"

struct font {
    FT_Library library;
    FT_Face face;
    char file[256];
};

/* Debian packages of the families one is likely to ask for. */
static const struct {
    const char *prefix, *package;
} packages[] = {{"DejaVu", "fonts-dejavu-core"},
                {"Latin Modern", "fonts-lmodern"},
                {"LM ", "fonts-lmodern"},
                {"Noto", "fonts-noto-core"},
                {"Liberation", "fonts-liberation"},
                {"TeX Gyre", "fonts-texgyre"},
                {"FreeS", "fonts-freefont-otf"},
                {"FreeM", "fonts-freefont-otf"},
                {"Linux Libertine", "fonts-linuxlibertine"},
                {NULL, NULL}};

static void complain_missing(const char *family, char why[512])
{
    for (int i = 0; packages[i].prefix; i++)
        if (!strncmp(family, packages[i].prefix, strlen(packages[i].prefix))) {
            snprintf(why, 512, "font '%s' is not installed; on Debian: apt-get install %s", family,
                     packages[i].package);
            return;
        }
    snprintf(why, 512, "font '%s' is not installed (fc-list shows which are)", family);
}

/* The regular face of exactly this family; fontconfig would else offer another one. */
static bool find_file(const char *family, char *file, size_t size, int *face_index)
{
    FcPattern *wanted = FcPatternCreate();
    FcResult result;
    bool found = false;
    FcPatternAddString(wanted, FC_FAMILY, (const FcChar8 *)family);
    FcPatternAddInteger(wanted, FC_WEIGHT, FC_WEIGHT_REGULAR);
    FcPatternAddInteger(wanted, FC_SLANT, FC_SLANT_ROMAN);
    FcPatternAddBool(wanted, FC_OUTLINE, FcTrue);
    FcConfigSubstitute(NULL, wanted, FcMatchPattern);
    FcDefaultSubstitute(wanted);
    FcPattern *match = FcFontMatch(NULL, wanted, &result);
    FcChar8 *name;
    for (int i = 0; match && !found && FcPatternGetString(match, FC_FAMILY, i, &name) == FcResultMatch; i++)
        found = !FcStrCmpIgnoreCase(name, (const FcChar8 *)family);
    found = found && FcPatternGetString(match, FC_FILE, 0, &name) == FcResultMatch;
    if (found)
        snprintf(file, size, "%s", (const char *)name);
    if (!found || FcPatternGetInteger(match, FC_INDEX, 0, face_index) != FcResultMatch)
        *face_index = 0;
    if (match)
        FcPatternDestroy(match);
    FcPatternDestroy(wanted);
    return found;
}

struct font *font_open(const char *family, char why[512])
{
    char path[4096];
    int index;
    struct font *font;
    if (!find_file(family, path, sizeof path, &index)) {
        complain_missing(family, why);
        return NULL;
    }
    font = calloc(1, sizeof *font);
    if (!font || FT_Init_FreeType(&font->library)) {
        snprintf(why, 512, "FreeType does not start");
        free(font);
        return NULL;
    }
    if (FT_New_Face(font->library, path, index, &font->face) || !FT_IS_SCALABLE(font->face)) {
        snprintf(why, 512, "FreeType cannot read outlines from %.400s", path);
        font_close(font);
        return NULL;
    }
    const char *slash = strrchr(path, '/');
    snprintf(font->file, sizeof font->file, "%.200s", slash ? slash + 1 : path);
    return font;
}

void font_close(struct font *font)
{
    if (font->face)
        FT_Done_Face(font->face);
    FT_Done_FreeType(font->library);
    free(font);
}

const char *font_file(const struct font *font)
{
    return font->file;
}

long font_units(const struct font *font)
{
    return font->face->units_per_EM;
}

/* What FT_Outline_Decompose hands on. */
struct pen {
    struct outline *out;
    long factor, x, y;
    bool failed;
};

static int draw(struct pen *pen, int degree, const FT_Vector *const *p)
{
    struct outline *o = pen->out;
    struct segment a = {degree, {pen->x}, {pen->y}};
    bool moved = false;
    for (int i = 1; i <= degree; i++) {
        a.x[i] = pen->factor * p[i - 1]->x;
        a.y[i] = pen->factor * p[i - 1]->y;
        moved = moved || a.x[i] != pen->x || a.y[i] != pen->y;
    }
    pen->x = a.x[degree];
    pen->y = a.y[degree];
    if (!moved)
        return 0;
    if (o->count == o->room) {
        int room = o->room ? 2 * o->room : 64;
        struct segment *more = realloc(o->at, (size_t)room * sizeof *more);
        if (!more)
            return 1;
        o->at = more;
        o->room = room;
    }
    o->at[o->count++] = a;
    return 0;
}

static int move_to(const FT_Vector *to, void *user)
{
    struct pen *pen = user;
    pen->x = pen->factor * to->x;
    pen->y = pen->factor * to->y;
    return 0;
}

static int line_to(const FT_Vector *to, void *user)
{
    return draw(user, 1, &to);
}

static int conic_to(const FT_Vector *control, const FT_Vector *to, void *user)
{
    const FT_Vector *const p[2] = {control, to};
    return draw(user, 2, p);
}

static int cubic_to(const FT_Vector *first, const FT_Vector *second, const FT_Vector *to, void *user)
{
    const FT_Vector *const p[3] = {first, second, to};
    return draw(user, 3, p);
}

bool font_outline(struct font *font, unsigned long character, long factor, struct outline *o)
{
    /* shift 1: coordinates arrive doubled, so that implied points midway between two others are exact */
    static const FT_Outline_Funcs pens = {move_to, line_to, conic_to, cubic_to, 1, 0};
    struct pen pen = {.out = o, .factor = factor};
    memset(o, 0, sizeof *o);
    FT_UInt glyph = FT_Get_Char_Index(font->face, character);
    return glyph && !FT_Load_Glyph(font->face, glyph, FT_LOAD_NO_SCALE) &&
           font->face->glyph->format == FT_GLYPH_FORMAT_OUTLINE &&
           !FT_Outline_Decompose(&font->face->glyph->outline, &pens, &pen) && o->count > 0;
}

void outline_clear(struct outline *o)
{
    free(o->at);
    memset(o, 0, sizeof *o);
}
