/* A line of a dataset of regions: a curve, its handle, and what is known of where the handle may go.
 *
 * The grammar of a line is in datasets/README.md.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_REGION_CASE_H
#define FATLINE_REGION_CASE_H

#include <gmp.h>
#include <jansson.h>
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct region_case {
    char *id;
    int degree, count;
    bool rational;
    mpq_t *x, *y, *w; /* Euclidean control points; weights, all 1 if !rational */
    mpq_t *knots;     /* count + degree + 1 */
    int members;      /* control points that move together; 0: the curve point at `drag` does */
    int *member;
    mpq_t drag;
    mpq_t lo, hi; /* the interval */
    int sign;
    bool loop_free;
    json_t *line;
};

enum region_case_status { REGION_CASE_READ, REGION_CASE_BAD };

/* Parses one line.  On REGION_CASE_READ c is to be cleared; else `error` says "file:line: field: what is
 * wrong, what was expected". */
enum region_case_status region_case_parse(const char *text, const char *file, int line, struct region_case *c,
                                          char error[512]);
void region_case_clear(struct region_case *c);

#ifdef __cplusplus
}
#endif
#endif
