#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "path_read.h"
#include "../cases/case.h"
#include "../cases/case_fields.h"
#include "../cases/number.h"
#include "../run/progress.h"
#include "path_file.h"
#include "path_svg.h"

enum { ID_MAX = 255 };

/* ---- segments of a line ---- */

static bool read_coordinate(const struct fields *r, const char *segment, int i, int k, const json_t *v,
                            real *a)
{
    char field[FIELD_MAX];
    bool good = true;

    if (json_is_number(v)) {
        *a = json_number_value(v); /* the double it denotes, as everywhere */
        return true;
    }
    snprintf(field, sizeof field, "%s[%d][%d]", segment, i, k);
    mpq_t q;
    mpq_init(q);
    good = fields_rational(r, field, v, q);
    if (good) {
        *a = real_from_rational(q);
        good = real_is_finite(*a) || fields_complain(r, field,
                                                     "beyond the range of this precision, expected "
                                                     "a finite number");
    }
    mpq_clear(q);
    return good;
}

/* [[x, y], ...] */
static bool read_polynomial(const struct fields *r, const char *name, const json_t *v, struct path_draft *d)
{
    real x[DEGREE_MAX + 1], y[DEGREE_MAX + 1];
    char field[FIELD_MAX];
    size_t n = json_array_size(v);

    if (n < 2 || n > DEGREE_MAX + 1)
        return fields_complain(r, name, "%zu point%s, expected 2 to %d (degree 1 to %d)", n,
                               n == 1 ? "" : "s", DEGREE_MAX + 1, DEGREE_MAX);
    for (int i = 0; i < (int)n; i++) {
        const json_t *point = json_array_get(v, (size_t)i);

        if (!json_is_array(point) || json_array_size(point) != 2) {
            snprintf(field, sizeof field, "%s[%d]", name, i);
            return fields_array(r, field, point, 2);
        }
        if (!read_coordinate(r, name, i, 0, json_array_get(point, 0), &x[i]) ||
            !read_coordinate(r, name, i, 1, json_array_get(point, 1), &y[i]))
            return false;
    }
    return path_draft_add(d, (int)n - 1, x, y, NULL) ||
           fields_complain(r, name, "beyond the range of this precision, expected finite numbers");
}

/* Homogeneous coefficients, formed exactly and rounded once. */
static bool add_curve(const struct case_curve *c, struct path_draft *d)
{
    real x[DEGREE_MAX + 1], y[DEGREE_MAX + 1], w[DEGREE_MAX + 1];
    mpq_t product;

    mpq_init(product);
    for (int i = 0; i <= c->degree; i++) {
        w[i] = real_from_rational(c->w[i]);
        mpq_mul(product, c->w[i], c->x[i]);
        x[i] = real_from_rational(product);
        mpq_mul(product, c->w[i], c->y[i]);
        y[i] = real_from_rational(product);
    }
    mpq_clear(product);
    return path_draft_add(d, c->degree, x, y, c->rational ? w : NULL);
}

/* {"points", "weights", ...} as f of a case, over [0, 1]. */
static bool read_object(const struct fields *r, const char *name, const json_t *v, struct path_draft *d)
{
    static const char *const known[] = {"points", "degree", "weights", "f64", "w64", "domain", NULL};
    char where[FIELD_MAX];
    struct case_curve c;
    bool good;

    memset(&c, 0, sizeof c);
    mpq_inits(c.lo, c.hi, NULL);
    snprintf(where, sizeof where, "%s.", name);
    good = fields_are_known(r, where, v, known) && case_curve_read(r, name, v, &c);
    if (good && (mpq_sgn(c.lo) != 0 || mpq_cmp_ui(c.hi, 1, 1) != 0))
        good = fields_complain(r, name, "a domain, expected none (a segment runs over [0, 1])");
    if (good && !add_curve(&c, d))
        good = fields_complain(r, name,
                               "beyond the range of this precision, expected finite numbers and weights that "
                               "differ by less than 2^256");
    case_curve_clear(&c);
    return good;
}

static bool read_segments(const struct fields *r, const json_t *v, struct path_draft *d)
{
    const json_t *segment;
    size_t i;

    if (!json_is_array(v))
        return fields_complain(r, "segments", "%s, expected an array of segments [[x, y], ...]",
                               fields_type(v));
    json_array_foreach(v, i, segment)
    {
        char name[40];

        snprintf(name, sizeof name, "segments[%zu]", i);
        if (json_is_array(segment) ? !read_polynomial(r, name, segment, d)
                                   : !read_object(r, name, segment, d))
            return false;
    }
    return true;
}

/* ---- lines ---- */

static bool read_data(const struct fields *r, const json_t *v, struct path_draft *d)
{
    struct svg_error error;

    if (!json_is_string(v))
        return fields_complain(r, "d", "%s, expected text of SVG path data", fields_type(v));
    return path_svg_read(json_string_value(v), d, &error) ||
           fields_complain(r, "d", "character %zu: %s", error.at + 1, error.what);
}

static bool read_path(const struct fields *r, const json_t *line, struct path_set *set)
{
    const json_t *id = json_object_get(line, "id"), *data = json_object_get(line, "d"),
                 *segments = json_object_get(line, "segments");
    static const char *const known[] = {"id", "segments", "d", "note", NULL};
    struct path_draft d;

    if (!json_is_object(line))
        return fields_complain(r, "line", "%s, expected an object with id and segments or d",
                               fields_type(line));
    if (!fields_are_known(r, "", line, known))
        return false;
    if (!json_is_string(id))
        return fields_complain(r, "id", "%s, expected text", fields_type(id));
    if (!*json_string_value(id) || strlen(json_string_value(id)) > ID_MAX)
        return fields_complain(r, "id", "%zu bytes long, expected 1 to %d", strlen(json_string_value(id)),
                               ID_MAX);
    if (!data == !segments)
        return fields_complain(r, data ? "d" : "segments", "%s, expected either segments or d",
                               data ? "together with segments" : "missing");
    path_draft_begin(&d, json_string_value(id));
    if (!(data ? read_data(r, data, &d) : read_segments(r, segments, &d))) {
        path_draft_clear(&d);
        return false;
    }
    path_draft_end(&d, set);
    return true;
}

static bool read_line(const struct fields *r, const char *text, struct path_set *set)
{
    json_error_t error;
    size_t flags = JSON_REJECT_DUPLICATES | JSON_DECODE_ANY;
    json_t *line = json_loads(text, flags, &error);
    bool good;

    if (!line && json_error_code(&error) == json_error_numeric_overflow)
        line = json_loads(text, flags | JSON_DECODE_INT_AS_REAL, &error);
    good = line ? read_path(r, line, set)
                : fields_complain(r, "line", "%s (column %d), expected one JSON object", error.text,
                                  error.column);
    json_decref(line);
    return good;
}

static int read_lines(struct path_set *set, const char *file, char *text)
{
    int worst = 0, number = 0;
    char message[512];

    for (char *rest = text, *line; (line = strsep(&rest, "\n")) != NULL;) {
        struct fields r = {file, ++number, message};

        if (line[strspn(line, " \t\r")] && !read_line(&r, line, set)) {
            progress_note("%s", message);
            worst = 65;
        }
    }
    return worst;
}

/* ---- path data in files ---- */

/* Line and column, from 1, of a byte. */
static void find_place(const char *text, size_t at, int *line, int *column)
{
    *line = *column = 1;
    for (size_t i = 0; i < at; i++) {
        (*column)++;
        if (text[i] == '\n') {
            (*line)++;
            *column = 1;
        }
    }
}

/* `data` begins at byte `offset` of `whole`. */
static int read_plain(struct path_set *set, const char *file, const char *id, const char *whole,
                      size_t offset, const char *data)
{
    struct path_draft d;
    struct svg_error error;
    int line, column;

    path_draft_begin(&d, id);
    if (path_svg_read(data, &d, &error)) {
        path_draft_end(&d, set);
        return 0;
    }
    path_draft_clear(&d);
    find_place(whole, offset + error.at, &line, &column);
    progress_note("%s:%d: column %d: %s", file, line, column, error.what);
    return 65;
}

/* The value of ` name="value"` in the tag text..end, in place of which a byte 0 is put; NULL: there is none.
 */
static char *attribute(char *text, char *end, const char *name, char **after)
{
    size_t n = strlen(name);

    for (char *at = text; at + n < end; at++) {
        char *value = at + n + strspn(at + n, " \t\r\n");

        if (strncmp(at, name, n) || !strchr(" \t\r\n", at[-1]) || *value != '=')
            continue;
        value += 1 + strspn(value + 1, " \t\r\n");
        *after = (*value == '"' || *value == '\'') ? strchr(value + 1, *value) : NULL;
        return *after && *after <= end ? value + 1 : NULL;
    }
    return NULL;
}

/* An SVG file: `text`, where bytes 0 are put after attributes, and a copy that stays whole. */
struct svg_file {
    const char *file;
    char *text, *whole;
    int paths;
};

/* One <path ...> tag. */
static int read_tag(struct path_set *set, struct svg_file *f, char *tag, char *end)
{
    char *data_end, *id_end, made[40], *data = attribute(tag, end, "d", &data_end),
                                       *id = attribute(tag, end, "id", &id_end);

    snprintf(made, sizeof made, "path%d", ++f->paths);
    if (!data)
        return 0;
    if (id)
        *id_end = 0;
    *data_end = 0;
    return read_plain(set, f->file, id && *id ? id : made, f->whole, (size_t)(data - f->text), data);
}

/* The byte > of the tag that begins here, outside quotes; NULL: the file ends before. */
static char *tag_end(char *tag)
{
    char quote = 0;

    for (; *tag; tag++) {
        if (quote ? *tag == quote : *tag == '"' || *tag == '\'')
            quote = quote ? 0 : *tag;
        else if (*tag == '>' && !quote)
            return tag;
    }
    return NULL;
}

/* The next <path ...> that is not in a comment, or NULL. */
static char *next_tag(char *text)
{
    for (char *at = text; (at = strchr(at, '<')) != NULL; at++) {
        if (!strncmp(at, "<!--", 4)) {
            if (!(at = strstr(at + 4, "-->")))
                return NULL;
        } else if (!strncmp(at, "<path", 5) && at[5] && strchr(" \t\r\n", at[5]))
            return at;
    }
    return NULL;
}

static int read_svg(struct path_set *set, const char *file, char *text)
{
    struct svg_file f = {file, text, strdup(text), 0};
    int worst = 0;

    if (strstr(text, "transform"))
        progress_note("%s: transformations are not applied", file);
    for (char *tag = next_tag(text), *end; tag; tag = next_tag(end)) {
        end = tag_end(tag);
        if (!end) {
            int line, column;

            find_place(f.whole, (size_t)(tag - text), &line, &column);
            progress_note("%s:%d: column %d: <path without an end, expected >", file, line, column);
            worst = 65;
            break;
        }
        if (read_tag(set, &f, tag + 5, end))
            worst = 65;
    }
    free(f.whole);
    return worst;
}

int path_set_read(struct path_set *set, const char *file)
{
    char *text = path_file_read(file);
    const char *name = strrchr(file, '/') ? strrchr(file, '/') + 1 : file;
    int status = 65;
    size_t begin;

    if (!text)
        return 2;
    begin = strspn(text, " \t\r\n");
    if (!strcmp(file, "-"))
        file = name = "stdin";
    if (text[begin] == '<')
        status = read_svg(set, file, text);
    else if (text[begin] == 'M' || text[begin] == 'm')
        status = read_plain(set, file, name, text, 0, text);
    else
        status = read_lines(set, file, text);
    free(text);
    return status;
}
