#include "answer_table.h"

#include <gmp.h>
#include <math.h>
#include <mpfr.h>

#include "../cases/number.h"
#include "../cases/place.h"

/* More records than ROWS_MAX are for programs: they are written as JSON. */
enum { ROWS_MAX = 40, POINT_DIGITS = 10 };

enum { DIGITS_MAX = REAL_BITS <= 53 ? 16 : REAL_BITS <= 113 ? 34 : 60, TEXT = 80 };

/* Decimal with `digits` significant digits. */
static void decimal_text(real a, int digits, char text[TEXT])
{
    mpq_t q;
    mpfr_t decimal;
    if (!real_is_finite(a)) {
        snprintf(text, TEXT, "beyond range");
        return;
    }
    mpq_init(q);
    mpfr_init2(decimal, 256);
    real_to_rational(a, q);
    mpfr_set_q(decimal, q, MPFR_RNDN);
    mpfr_snprintf(text, TEXT, "%.*Rg", digits, decimal);
    mpfr_clear(decimal);
    mpq_clear(q);
}

/* As many digits as the wider of the two intervals tells, and two more. */
static int digits_told(const struct crossing *c)
{
    double width = real_to_double(real_max(c->t.hi - c->t.lo, c->s.hi - c->s.lo));
    if (!(width > 0))
        return DIGITS_MAX;
    int digits = 2 - (int)floor(log10(width));
    return digits < 3 ? 3 : digits > DIGITS_MAX ? DIGITS_MAX : digits;
}

static void write_crossing(FILE *stream, const struct crossing *c, const struct curve *f, int width)
{
    char t[TEXT], s[TEXT], wide[TEXT], at_x[TEXT], at_y[TEXT];
    real x, y;
    int digits = digits_told(c);
    decimal_text(place_middle(c->t.lo, c->t.hi), digits, t);
    decimal_text(place_middle(c->s.lo, c->s.hi), digits, s);
    decimal_text(real_max(c->t.hi - c->t.lo, c->s.hi - c->s.lo), 2, wide);
    place_at(f, place_middle(c->t.lo, c->t.hi), &x, &y);
    decimal_text(x, POINT_DIGITS, at_x);
    decimal_text(y, POINT_DIGITS, at_y);
    fprintf(stream, "  %-*s %-*s (%s, %s)  %s", width, t, width, s, at_x, at_y, standing_name(c->standing));
    if (c->multiplicity > 0)
        fprintf(stream, ", multiplicity %d", c->multiplicity);
    if (c->at_most > 0)
        fprintf(stream, ", at most %d", c->at_most);
    fprintf(stream, ", width %s\n", wide);
}

static void write_overlap(FILE *stream, const struct overlap *o)
{
    fprintf(stream, "  overlap: t in [%.12g, %.12g], s in [%.12g, %.12g]%s%s; within %.1e\n",
            real_to_double(o->t_outer.lo), real_to_double(o->t_outer.hi), real_to_double(o->s_outer.lo),
            real_to_double(o->s_outer.hi), o->reversed ? ", reversed" : "", o->exact ? ", exact" : "",
            real_to_double(o->distance));
}

void answer_table_write(FILE *stream, const struct answer *a, const struct problem *p, const char *message)
{
    const struct crossings *out = a->crossings;
    char tolerance[TEXT];
    int width = 8;
    decimal_text(a->tolerance, 3, tolerance);
    const int shown = out->count < ROWS_MAX ? out->count : ROWS_MAX;
    for (int i = 0; i < shown; i++)
        width = digits_told(&out->at[i]) + 8 > width ? digits_told(&out->at[i]) + 8 : width;
    fprintf(stream, "%s: %s, %s, tolerance %s: %s after %ld step%s%s%s\n", a->id, a->algorithm, REAL_NAME,
            tolerance, outcome_name(a->outcome), a->steps, a->steps == 1 ? "" : "s", message ? ": " : "",
            message ? message : "");
    if (out->count > 0)
        fprintf(stream, "  %-*s %-*s point\n", width, "t (on f)", width, "s (on g)");
    for (int i = 0; i < shown; i++)
        write_crossing(stream, &out->at[i], &p->f, width);
    if (shown < out->count)
        fprintf(stream, "  and %d more\n", out->count - shown);
    for (int i = 0; i < out->overlaps; i++)
        write_overlap(stream, &out->overlap[i]);
    if (a->outcome == SOLVED && out->count + out->overlaps == 0)
        fprintf(stream, "  no intersection\n");
}
