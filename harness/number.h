/* Numbers as text, exact rationals and the build's real.
 *
 * The text forms of a coordinate: decimal ("-1.25e-3"), fraction ("3/16"), C hex float ("0x1.8p-4"), decimal
 * with a trailing f (rounded to float32 first); in JSON also plain numbers (the double they denote). */
#ifndef FATLINE_NUMBER_H
#define FATLINE_NUMBER_H

#include <gmp.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Exact value of `text`; false if it is none of the forms above (q is then unchanged). */
bool number_parse(const char *text, mpq_t q);
/* Shortest text that reads back to the same double. */
void number_text_double(double a, char *text, size_t size);
/* Nearest double, ties to even. */
double number_to_double(const mpq_t q);

#ifdef __cplusplus
}
#endif

/* What follows depends on the precision: harness/real_text.c, compiled for each. */
#ifdef FATLINE_REAL_H
enum { REAL_TEXT_MAX = 640 }; /* longest text of a real */
/* Nearest real, ties to even. */
real real_from_rational(const mpq_t q);
/* Exact; a is finite. */
void real_to_rational(real a, mpq_t q);
/* Double: as number_text_double; quad and multi: C hex float. Reads back bit for bit. */
void real_text(real a, char *text, size_t size);
/* Reads a text of real_text, or any form of number_parse rounded to nearest; false if it is none. */
bool real_parse(const char *text, real *a);
#endif

#endif
