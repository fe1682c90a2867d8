/* The fields of a JSON line, read with complaints that say where: "file:line: field: what is wrong, what was
 * expected".  For the readers of harness/case*.c. */
#ifndef FATLINE_CASE_FIELDS_H
#define FATLINE_CASE_FIELDS_H

#include <gmp.h>
#include <jansson.h>
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct case_curve;
struct case_expected;

enum { FIELD_MAX = 96 }; /* longest name of a field, "expected.overlap[12][3]" */

struct fields {
    const char *file;
    int line;
    char *error; /* 512 bytes */
};

/* Writes the message; always false. */
bool fields_complain(const struct fields *r, const char *field, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

const char *fields_type(const json_t *v); /* "an array", "text", "missing", ... */

/* A number: text in a form of number.h, or a JSON number, which is the double it denotes. */
bool fields_rational(const struct fields *r, const char *field, const json_t *v, mpq_t q);
/* A JSON number or null (NAN). */
bool fields_double(const struct fields *r, const char *field, const json_t *v, double *a);
/* A JSON integer in lo..hi. */
bool fields_integer(const struct fields *r, const char *field, const json_t *v, int lo, int hi, int *a);
/* An array of `length` entries; of any length if that is negative. */
bool fields_array(const struct fields *r, const char *field, const json_t *v, int length);

/* Has the object no other fields than `known`, which ends with NULL?  A misspelt one would be a default.
 * where: what stands before a name in the message, "expected." */
bool fields_are_known(const struct fields *r, const char *where, const json_t *object,
                      const char *const *known);

/* Array of n initialised rationals; memory that cannot be had ends the program with status 2. */
mpq_t *rationals_new(int n);
void rationals_free(mpq_t *q, int n);

/* The object of one curve into c, whose numbers lo and hi are initialised and all else zeroed;
 * case_curve_clear also after a failure.  name: of the field in messages. */
bool case_curve_read(const struct fields *r, const char *name, const json_t *v, struct case_curve *c);
void case_curve_clear(struct case_curve *c);

/* The object `expected` of a line into e, which is zeroed. */
bool expected_read(const struct fields *r, const json_t *v, struct case_expected *e);

#ifdef __cplusplus
}
#endif
#endif
