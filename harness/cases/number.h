/* Numbers as text, exact rationals and the build's real.
 *
 * The text forms of a coordinate: decimal ("-1.25e-3"), fraction ("3/16"), C hex float ("0x1.8p-4"), decimal
 * with a trailing f (rounded to float32 first); in JSON also plain numbers (the double they denote). */
#ifndef FATLINE_NUMBER_H
#define FATLINE_NUMBER_H

#include <stdio.h>
#include <gmp.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    NUMBER_LENGTH_MAX = 20000, /* characters of a text */
    NUMBER_EXPONENT_10 = 5000, /* a decimal exponent is at most so large in magnitude ... */
    NUMBER_EXPONENT_2 = 20000  /* ... and a binary one; binary128 ends at 2^-16494 */
};

/* Exact value of `text`; false if it is none of the forms above, without anything before or after it, or
 * beyond the limits above, or with a trailing f not a finite float32 (q is then unchanged). */
bool number_parse(const char *text, mpq_t q);
/* A short text that reads back to the same double: the shortest, but for the rare power of two where it may
 * be one digit longer.  a is finite. */
void number_text_double(double a, char *text, size_t size);
/* Nearest double, ties to even; infinite beyond DBL_MAX. */
double number_to_double(const mpq_t q);
/* q rounded to m 2^e with |m| <= 2^bits and e >= exponent_min, ties to even: any binary format without its
 * largest exponent. */
void number_round(const mpq_t q, int bits, long exponent_min, mpz_t m, long *e);
/* q = q 2^e, exactly. */
void number_scale(mpq_t q, long e);

#ifdef __cplusplus
}
#endif

/* What follows depends on the precision: real_text.c, compiled for each. */
#ifdef FATLINE_REAL_H
enum { REAL_TEXT_MAX = 640 }; /* longest text of a real */
/* Nearest real, ties to even; infinite where the type ends. */
real real_from_rational(const mpq_t q);
/* Exact; a is finite. */
void real_to_rational(real a, mpq_t q);
/* Double: as number_text_double; quad and multi: C hex float. Reads back bit for bit. */
void real_text(real a, char *text, size_t size);
/* As a value of JSON: the same text, in quotes in quad and multi; null where it is not finite. */
void real_write(FILE *stream, real a);
/* Reads a text of real_text, or any form of number_parse rounded to nearest; false if it is none. */
bool real_parse(const char *text, real *a);
#endif

#endif
