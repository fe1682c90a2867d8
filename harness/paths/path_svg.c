#include "path_svg.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"
#include "path_arc.h"

struct pen {
    const char *text;
    size_t at;
    struct path_draft *d;
    struct svg_error *error;
    real x, y, start_x, start_y;
    real control_x, control_y; /* of the last C, S (or Q, T) */
    char last;                 /* upper-case letter of the command before */
};

static bool complain(struct pen *p, size_t at, const char *format, ...) __attribute__((format(printf, 3, 4)));
static bool complain(struct pen *p, size_t at, const char *format, ...)
{
    va_list arguments;
    p->error->at = at;
    va_start(arguments, format);
    vsnprintf(p->error->what, sizeof p->error->what, format, arguments);
    va_end(arguments);
    return false;
}

/* "\"abc\"", or "the end". */
static const char *shown(const struct pen *p, char buffer[20])
{
    size_t n = strcspn(p->text + p->at, " \t\r\n,");
    if (!p->text[p->at])
        return "the end";
    snprintf(buffer, 20, "\"%.*s\"", (int)(n < 12 ? (n ? n : 1) : 12), p->text + p->at);
    return buffer;
}

/* ---- numbers ---- */

static void skip_space(struct pen *p)
{
    p->at += strspn(p->text + p->at, " \t\r\n\f");
}

/* White space with at most one comma in it. */
static void skip_comma(struct pen *p)
{
    skip_space(p);
    if (p->text[p->at] == ',') {
        p->at++;
        skip_space(p);
    }
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Bytes of the number that begins here; 0: none does. */
static size_t number_length(const char *text)
{
    const char *c = text + (*text == '+' || *text == '-');
    int digits = 0;
    for (; is_digit(*c); c++)
        digits++;
    if (*c == '.')
        for (c++; is_digit(*c); c++)
            digits++;
    if (!digits)
        return 0;
    if (*c == 'e' || *c == 'E') {
        const char *e = c + 1 + (c[1] == '+' || c[1] == '-');
        if (is_digit(*e)) {
            while (is_digit(*e))
                e++;
            c = e;
        }
    }
    return (size_t)(c - text);
}

/* The nearest real.  Doubles: strtod, which the C library rounds correctly. */
static bool value_of(const char *number, real *a)
{
    if (REAL_BITS == 53) {
        *a = strtod(number, NULL);
        return real_is_finite(*a);
    }
    mpq_t q;
    mpq_init(q);
    bool good = number_parse(number + (*number == '+'), q);
    *a = good ? real_from_rational(q) : (real)0;
    mpq_clear(q);
    return good && real_is_finite(*a);
}

static bool read_number(struct pen *p, const char *what, real *a)
{
    char buffer[20], number[400];
    size_t n = number_length(p->text + p->at), at = p->at;
    if (n == 0)
        return complain(p, p->at, "%s, expected a number (%s)", shown(p, buffer), what);
    if (n >= sizeof number)
        return complain(p, at, "a number of %zu digits, expected less than %zu", n, sizeof number);
    memcpy(number, p->text + at, n);
    number[n] = 0;
    p->at += n;
    skip_comma(p);
    return value_of(number, a) ||
           complain(p, at, "%.40s is beyond the range of this precision, expected a finite number", number);
}

static bool read_pair(struct pen *p, bool relative, const char *x_name, const char *y_name, real *x, real *y)
{
    if (!read_number(p, x_name, x) || !read_number(p, y_name, y))
        return false;
    if (relative) {
        *x += p->x;
        *y += p->y;
    }
    return true;
}

static bool read_flag(struct pen *p, const char *what, bool *flag)
{
    char buffer[20];
    if (p->text[p->at] != '0' && p->text[p->at] != '1')
        return complain(p, p->at, "%s, expected 0 or 1 (%s)", shown(p, buffer), what);
    *flag = p->text[p->at++] == '1';
    skip_comma(p);
    return true;
}

/* ---- commands ---- */

/* The segment from the pen through x[1..degree]; the pen moves to its end. */
static bool draw(struct pen *p, size_t at, int degree, real *x, real *y)
{
    x[0] = p->x;
    y[0] = p->y;
    if (!path_draft_add(p->d, degree, x, y, NULL))
        return complain(p, at, "coordinates beyond the range of this precision, expected finite numbers");
    p->x = x[degree];
    p->y = y[degree];
    return true;
}

static bool move(struct pen *p, bool relative)
{
    real x, y;
    if (!read_pair(p, relative, "x", "y", &x, &y))
        return false;
    p->x = p->start_x = x;
    p->y = p->start_y = y;
    path_draft_break(p->d);
    return true;
}

static bool draw_line(struct pen *p, char command, bool relative)
{
    real x[2] = {p->x, p->x}, y[2] = {p->y, p->y};
    size_t at = p->at;
    bool good = command == 'H'   ? read_number(p, "x", &x[1])
                : command == 'V' ? read_number(p, "y", &y[1])
                                 : read_pair(p, relative, "x", "y", &x[1], &y[1]);
    if (good && relative && command == 'H')
        x[1] += p->x;
    if (good && relative && command == 'V')
        y[1] += p->y;
    return good && draw(p, at, 1, x, y);
}

/* The last control point reflected, if the last command was such a curve, else the pen. */
static void reflect(const struct pen *p, const char *after, real *x, real *y)
{
    bool smooth = p->last && strchr(after, p->last);
    *x = smooth ? 2 * p->x - p->control_x : p->x;
    *y = smooth ? 2 * p->y - p->control_y : p->y;
}

static bool draw_cubic(struct pen *p, char command, bool relative)
{
    real x[4], y[4];
    size_t at = p->at;
    if (command == 'S')
        reflect(p, "CS", &x[1], &y[1]);
    else if (!read_pair(p, relative, "x1", "y1", &x[1], &y[1]))
        return false;
    if (!read_pair(p, relative, "x2", "y2", &x[2], &y[2]) || !read_pair(p, relative, "x", "y", &x[3], &y[3]))
        return false;
    p->control_x = x[2];
    p->control_y = y[2];
    return draw(p, at, 3, x, y);
}

static bool draw_quadratic(struct pen *p, char command, bool relative)
{
    real x[3], y[3];
    size_t at = p->at;
    if (command == 'T')
        reflect(p, "QT", &x[1], &y[1]);
    else if (!read_pair(p, relative, "x1", "y1", &x[1], &y[1]))
        return false;
    if (!read_pair(p, relative, "x", "y", &x[2], &y[2]))
        return false;
    p->control_x = x[1];
    p->control_y = y[1];
    return draw(p, at, 2, x, y);
}

static bool draw_arc(struct pen *p, bool relative)
{
    real rx, ry, rotation, x, y;
    bool large, sweep;
    size_t at = p->at;
    if (!read_number(p, "rx", &rx) || !read_number(p, "ry", &ry) ||
        !read_number(p, "x-axis-rotation", &rotation) || !read_flag(p, "large-arc-flag", &large) ||
        !read_flag(p, "sweep-flag", &sweep) || !read_pair(p, relative, "x", "y", &x, &y))
        return false;
    if (!path_arc_add(p->d, p->x, p->y, rx, ry, real_to_double(rotation), large, sweep, x, y))
        return complain(p, at, "an arc beyond the range of this precision, expected finite numbers");
    p->x = x;
    p->y = y;
    return true;
}

static bool close_path(struct pen *p)
{
    real x[2] = {p->x, p->start_x}, y[2] = {p->y, p->start_y};
    bool good = (p->x == p->start_x && p->y == p->start_y) || draw(p, p->at, 1, x, y);
    path_draft_break(p->d);
    return good;
}

/* One set of arguments. */
static bool run(struct pen *p, char command, bool relative)
{
    bool good = command == 'M'                   ? move(p, relative)
                : strchr("LHV", command) != NULL ? draw_line(p, command, relative)
                : strchr("CS", command) != NULL  ? draw_cubic(p, command, relative)
                : strchr("QT", command) != NULL  ? draw_quadratic(p, command, relative)
                : command == 'A'                 ? draw_arc(p, relative)
                                                 : close_path(p);
    p->last = command;
    return good;
}

/* A letter and all its arguments: what follows those of M are lines. */
static bool run_command(struct pen *p)
{
    char buffer[20], letter = p->text[p->at];
    char command = (char)(letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter);
    bool relative = letter != command;
    if (!letter || !strchr("MLHVCSQTAZ", command))
        return complain(p, p->at, "%s, expected a command (M L H V C S Q T A Z)", shown(p, buffer));
    if (!p->last && command != 'M')
        return complain(p, p->at, "%s, expected M or m first", shown(p, buffer));
    p->at++;
    skip_space(p);
    if (!run(p, command, relative))
        return false;
    while (command != 'Z' && p->text[p->at] && !isalpha((unsigned char)p->text[p->at]))
        if (!run(p, command == 'M' ? 'L' : command, relative))
            return false;
    return true;
}

bool path_svg_read(const char *text, struct path_draft *d, struct svg_error *error)
{
    struct pen p;
    memset((void *)&p, 0, sizeof p);
    p.text = text;
    p.d = d;
    p.error = error;
    p.x = p.y = p.start_x = p.start_y = p.control_x = p.control_y = 0;
    for (skip_space(&p); text[p.at]; skip_space(&p))
        if (!run_command(&p))
            return false;
    return true;
}
