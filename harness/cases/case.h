/* A line of a dataset: two curves in exact rational numbers, and what is known of their intersections.
 *
 * The grammar of a line is in datasets/README.md.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_CASE_H
#define FATLINE_CASE_H

#include <gmp.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Euclidean control points (x[i], y[i]) and weights w[i] (all 1 if !rational), i = 0..degree, on [lo, hi]. */
struct case_curve {
    int degree;
    bool rational;
    mpq_t *x, *y, *w;
    mpq_t lo, hi; /* the domain; 0 and 1 unless the line says otherwise */
};

/* One isolated solution, in the curves' own parameters. */
struct case_solution {
    mpq_t t, s;       /* within 10^-(digits) of the true parameters; exact when `exact` */
    bool exact;       /* t and s are the solution itself */
    int multiplicity; /* 0: not known */
    double cond; /* growth of a relative change of the coordinates into t and s; NAN: not known, or contact */
    double sine; /* of the angle of the tangents; NAN: not defined */
};

/* f over [t0, t1] and g over [s0, s1] are one arc: f(t0) = g(s0), f(t1) = g(s1); s0 > s1 when reversed. */
struct case_overlap {
    mpq_t t0, t1, s0, s1;
    bool exact; /* these are the ends themselves */
};

struct case_expected {
    bool known;
    int count, overlaps;
    struct case_solution *at; /* count of them, sorted by t then s */
    struct case_overlap *overlap;
    double tol; /* NAN: not given */
};

struct test_case {
    char *id;
    char *class_name; /* "transversal", "tangent", "degenerate", "endpoint", "overlap", "none", or "" */
    bool ambiguous;   /* near.ambiguous is not empty: counted apart */
    struct case_curve f, g;
    struct case_expected expected;
    json_t *line;     /* the whole object, for whoever copies it on; owned */
    const char *file; /* where it was read; the reader's name, not owned */
    int line_number;
};

/* Reads case lines from one stream.  A bad line yields a message "file:line: field: what is wrong, what was
 * expected" in `error` and the reader goes on with the next call. */
struct case_reader {
    FILE *stream;
    const char *file;
    int line_number;
    char *text;
    size_t text_size;
    char error[512];
};

enum case_status { CASE_READ, CASE_BAD, CASE_END };

void case_reader_init(struct case_reader *r, FILE *stream, const char *file);
enum case_status case_read(struct case_reader *r, struct test_case *c); /* on CASE_READ c is to be cleared */
void case_reader_clear(struct case_reader *r);                          /* does not close the stream */
void case_clear(struct test_case *c);
void case_expected_clear(struct case_expected *e); /* then nothing is known; memory is of malloc */

/* Parses one line already in memory; as case_read. */
enum case_status case_parse(const char *text, const char *file, int line_number, struct test_case *c,
                            char error[512]);

/* The tolerance of the judge: max(asked, expected.tol); where tol is missing 1e-12 (1 + max cond), and
 * 1e-6 if a solution is a contact (multiplicity > 1 or sine 0) or degenerate. */
double case_tolerance(const struct test_case *c, double asked);

#ifdef __cplusplus
}
#endif
#endif
